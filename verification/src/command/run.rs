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
use crate::result_formats::Format;
use crate::summary::Summary;
use crate::wide;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The scene, `-` for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Write the result to FILE, `-` for standard output: JSON (crossfibre-result/1), or what its
    /// ending .csv or .npz says
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write the result in this format, whatever the ending of FILE, instead of the summary
    #[arg(long)]
    format: Option<Format>,
    /// Write the result as JSON instead of the summary
    #[arg(long, conflicts_with = "format")]
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
    // Before minutes of work, not after.
    let format = args.format();
    format.iter().try_for_each(|format| format.check())?;
    let scene = scene::read(&args.scene)?;
    let plan = Plan::of(&scene);
    if !args.force {
        scene::refuse_if_long(&plan, "shorten the duration, coarsen the mesh, or add --force")?;
    }
    let result = march(&scene, &plan, args.quiet);
    let to_stdout = matches!(destination, Destination::Stdout);
    if let Some(format) = format {
        let mut out = destination.open()?;
        format.write(&result, &mut out)?;
        out.finish()?;
    }
    let exit = ended::told(&scene, &result.outcome);
    if !(args.quiet || args.json || format.is_some() && to_stdout) {
        write!(io::stdout().lock(), "{}", Summary { scene: &scene, result: &result })?;
    }
    Ok(exit)
}

impl Args {
    /// The format to write the result in; none if it is not to be written.
    fn format(&self) -> Option<Format> {
        let of_file = || self.output.as_deref().map(Format::of);
        if self.json { Some(Format::Json) } else { self.format.or_else(of_file) }
    }
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
