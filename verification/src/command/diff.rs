//! `crossfibre diff`: the first difference of two traces, and all others counted.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use super::select;
use crate::diff::{Comparison, Options, Report, Tolerance};
use crate::exit::Exit;
use crate::output::Destination;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The first trace, `-` for standard input
    #[arg(value_name = "A")]
    a: PathBuf,
    /// The second trace; one of the two may be `-`
    #[arg(value_name = "B")]
    b: PathBuf,
    #[command(flatten)]
    choice: select::Choice,
    /// Numbers agree that are this close, relative to the larger one; in a vector, to its largest component
    #[arg(long, value_name = "X", value_parser = tolerance, allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// Numbers agree that are no more than N doubles apart
    #[arg(long, value_name = "N")]
    ulp: Option<u64>,
    /// Read no further than the first difference
    #[arg(long)]
    first: bool,
    /// Write JSON (crossfibre-diff/1) instead of text
    #[arg(long)]
    json: bool,
    /// Write to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x >= 0.0 && x.is_finite() => Ok(x),
        _ => Err("it is a number from 0 up, such as 1e-12".into()),
    }
}

pub fn run(args: Args) -> Result<Exit> {
    if [&args.a, &args.b].map(|path| path == Path::new("-")) == [true, true] {
        bail!("both traces are `-`: standard input holds but one");
    }
    let destination = Destination::of(args.output.as_deref())?;
    let options = Options {
        filter: args.choice.into(),
        tolerance: Tolerance { relative: args.tolerance, ulp: args.ulp },
        first_only: args.first,
    };
    let mut comparison = Comparison::open(&args.a, &args.b, options)?;
    let read = comparison.run();
    let record = comparison.record();
    if let Err(error) = read {
        let until = match (&record.first_difference, record.agree_before) {
            (Some(_), _) => format!("\n  until there: {}", record.verdict),
            (None, 0) => String::new(),
            (None, events) => format!("\n  until there: the events agree, {events} of them"),
        };
        bail!("{error:#}{until}");
    }
    let mut out = destination.open()?;
    if args.json {
        serde_json::to_writer_pretty(&mut out, &record).map_err(io::Error::from)?;
        writeln!(out)?;
    } else {
        write!(out, "{}", Report(&record))?;
    }
    out.finish()?;
    Ok(if record.agree { Exit::Well } else { Exit::CandidateDisagrees })
}
