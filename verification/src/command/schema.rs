//! `crossfibre schema`: the JSON Schema of a file format, from the types that read or write it.

use std::io::Write;
use std::path::PathBuf;

use anyhow::Result;
use clap::ValueEnum;
use crossfibre::result::RunResult;
use crossfibre::scene::Scene;
use schemars::schema_for;

use super::plan::PlanFile;
use crate::conform::{self, protocol};
use crate::diff::record::Record;
use crate::exact_file::ExactFile;
use crate::exit::Exit;
use crate::golden::file::VectorFile;
use crate::output::Destination;
use crate::record;
use crate::trace_line::TraceLine;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// Which format
    format: Format,
    /// Write to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// What `run`, `trace` and `plan` read: crossfibre-scene/1
    Scene,
    /// What `run --json` writes: crossfibre-result/1
    Result,
    /// What `exact --json` writes: crossfibre-exact/1
    Exact,
    /// A line of what `trace` writes: crossfibre-trace/1
    Trace,
    /// What `diff --json` writes: crossfibre-diff/1
    Diff,
    /// What `plan --json` writes: crossfibre-plan/1
    Plan,
    /// The questions and answers of `conform`: crossfibre-conformance/1
    Conformance,
    /// What `conform --json` writes: crossfibre-conformance-report/1
    ConformanceReport,
    /// What `verify` writes and `report` reads: crossfibre-report/1
    Report,
    /// A file of golden vectors, written by `vectors --bless`: crossfibre-vectors/1
    Vectors,
}

pub fn run(args: &Args) -> Result<Exit> {
    let schema = match args.format {
        Format::Scene => schema_for!(Scene),
        Format::Result => schema_for!(RunResult),
        Format::Exact => schema_for!(ExactFile),
        Format::Trace => schema_for!(TraceLine),
        Format::Diff => schema_for!(Record),
        Format::Plan => schema_for!(PlanFile),
        Format::Conformance => schema_for!(protocol::Message),
        Format::ConformanceReport => schema_for!(conform::record::Report),
        Format::Report => schema_for!(record::Record),
        Format::Vectors => schema_for!(VectorFile),
    };
    let mut out = Destination::of(args.output.as_deref())?.open()?;
    serde_json::to_writer_pretty(&mut out, &schema).map_err(std::io::Error::from)?;
    writeln!(out)?;
    out.finish()?;
    Ok(Exit::Well)
}
