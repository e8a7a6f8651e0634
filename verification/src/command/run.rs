//! `crossfibre run`: a scene in, a summary or a result out.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::Result;
use crossfibre::plan::Plan;
use crossfibre::result::RunResult;
use crossfibre::scene::Scene;
use crossfibre::state::State;
use indicatif::{ProgressBar, ProgressStyle};

use super::{ended, scene};
use crate::exit::Exit;
use crate::output::Destination;
use crate::summary::Summary;
use crate::wide;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The scene, `-` for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Write the result as JSON (crossfibre-result/1) to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write the result as JSON instead of the summary
    #[arg(long)]
    json: bool,
    /// Run even if it takes hours
    #[arg(long)]
    force: bool,
    /// No summary and no progress bar
    #[arg(short, long)]
    quiet: bool,
}

pub fn run(args: &Args) -> Result<Exit> {
    let destination = Destination::of(args.output.as_deref())?;
    let scene = scene::read(&args.scene)?;
    let plan = Plan::of(&scene);
    if !args.force {
        scene::refuse_if_long(&plan, "shorten the duration, coarsen the mesh, or add --force")?;
    }
    let result = march(&scene, &plan, args.quiet);
    let to_stdout = matches!(destination, Destination::Stdout);
    if args.json || args.output.is_some() {
        let mut out = destination.open()?;
        serde_json::to_writer(&mut out, &result).map_err(io::Error::from)?;
        writeln!(out)?;
        out.finish()?;
    }
    let exit = ended::told(&scene, &result.outcome);
    if !(args.quiet || args.json || args.output.is_some() && to_stdout) {
        write!(io::stdout().lock(), "{}", Summary { scene: &scene, result: &result })?;
    }
    Ok(exit)
}

/// Element-steps from which a run shows how far it is: about a second of work.
const LONG: f64 = 2e8;

/// Element-steps between two looks at the clock.
const BETWEEN: u64 = 10_000_000;

fn march(scene: &Scene, plan: &Plan, quiet: bool) -> RunResult {
    if quiet || plan.element_steps < LONG {
        return wide::run(scene, |_| {});
    }
    // Drawn on standard error, and only if that is a terminal.
    let style = ProgressStyle::with_template("{wide_bar} {percent} %, {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(plan.element_steps as u64).with_style(style);
    let mut next = BETWEEN;
    let result = wide::run(scene, |state: &State<f64>| {
        if state.work.elements >= next {
            next = state.work.elements + BETWEEN;
            bar.set_position(state.work.elements);
        }
    });
    bar.finish_and_clear();
    result
}
