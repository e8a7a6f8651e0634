//! `crossfibre plan`: what a run of a scene will do.

use std::fmt::{self, Display};
use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::Result;
use crossfibre::equations::equation;
use crossfibre::errata::LEDGER;
use crossfibre::plan::Plan;
use schemars::JsonSchema;
use serde::Serialize;

use super::{plan_accuracy, scene};
use crate::exit::Exit;
use crate::output::Destination;
use crate::precision::advice::{Accuracy, accuracy};

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The scene, `-` for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Find the meshes that give an error of this size, such as 1e-3, by trial runs
    #[arg(long, value_name = "ERROR", value_parser = error_size, allow_hyphen_values = true)]
    accuracy: Option<f64>,
    /// Write JSON (crossfibre-plan/1) instead of text
    #[arg(long)]
    json: bool,
    /// Write to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(args: &Args) -> Result<Exit> {
    let destination = Destination::of(args.output.as_deref())?;
    let scene = scene::read(&args.scene)?;
    let plan = Plan::of(&scene);
    if args.accuracy.is_some() {
        scene::refuse_if_long(&plan, "try a coarser mesh: finer ones are found from it")?;
    }
    let accuracy = args.accuracy.map(|wanted| accuracy(&scene, wanted));
    let file = PlanFile { plan, accuracy };
    let mut out = destination.open()?;
    if args.json {
        serde_json::to_writer_pretty(&mut out, &file).map_err(io::Error::from)?;
        writeln!(out)?;
    } else {
        write!(out, "{}", Table(&file.plan))?;
        if let Some(accuracy) = &file.accuracy {
            write!(out, "\n{}", plan_accuracy::Table { scene: &scene, accuracy })?;
        }
    }
    out.finish()?;
    Ok(Exit::Well)
}

/// What `--json` writes.
#[derive(Serialize, JsonSchema)]
pub struct PlanFile {
    /// The plan.
    #[serde(flatten)]
    plan: Plan,
    /// What the accuracy that was asked for takes.
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<Accuracy>,
}

fn error_size(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(size) if (1e-12..1.0).contains(&size) => Ok(size),
        _ => Err("must be a relative error from 1e-12 to below 1, such as 1e-3".into()),
    }
}

/// A plan for people.
struct Table<'a>(&'a Plan);

impl Display for Table<'_> {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let plan = self.0;
        writeln!(to, "{}\n", plan.title)?;
        writeln!(
            to,
            "fibre       elements      Δx, mm      c, m/s   Courant α   node mass, mg   dimensions"
        )?;
        for f in &plan.fibres {
            writeln!(
                to,
                "{:<10} {:>9}   {:>9.4}   {:>9.2}   {:>9.4}   {:>13.4}   {:>10}",
                f.fibre.name(),
                f.elements,
                f.spacing * 1e3,
                f.wave_speed,
                f.courant,
                f.node_mass * 1e6,
                f.dimensions,
            )?;
        }
        writeln!(to)?;
        writeln!(
            to,
            "time         {} steps of {:.6} µs reach {:.4} µs",
            plan.steps,
            plan.time_step * 1e6,
            plan.time * 1e6
        )?;
        match plan.crossover_node {
            Some(node) => writeln!(to, "crossover    node {node} of the primary fibre")?,
            None => writeln!(to, "crossover    none")?,
        }
        for f in plan.fibres.iter().filter(|f| f.law != "linear") {
            writeln!(to, "law          {} fibre: {}", f.fibre.name(), f.law)?;
        }
        writeln!(to, "corrections  {}", corrections(&plan.corrections))?;
        writeln!(
            to,
            "work         at most {:.4e} element-steps, {:.1} kB of memory",
            plan.element_steps,
            plan.memory / 1e3
        )?;
        for f in plan.fibres.iter().filter(|f| f.courant > f.greatest_courant) {
            writeln!(
                to,
                "beware       a Courant number above {:.4} on the {} fibre: the scheme is unstable",
                f.greatest_courant,
                f.fibre.name()
            )?;
        }
        writeln!(to, "\nequation                                     runs")?;
        for e in &plan.equations {
            let name = equation(e.equation).map_or("", |known| known.name);
            let runs = if e.runs { "yes" } else { "no" };
            writeln!(to, "{:>4} {name:<38}  {runs:<3}  {}", format!("({})", e.equation), e.why)?;
        }
        Ok(())
    }
}

fn corrections(chosen: &[&str]) -> String {
    if chosen.is_empty() {
        "none: the page as printed".into()
    } else if chosen.len() == LEDGER.len() {
        "all".into()
    } else {
        chosen.join(", ")
    }
}
