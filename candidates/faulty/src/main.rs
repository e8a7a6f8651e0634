//! `crossfibre-faulty`: speaks the conformance protocol, wrongly on demand.

use std::io::{self, BufRead, BufWriter, Write};
use std::path::PathBuf;

use anyhow::{Context, Result, anyhow};
use clap::Parser;
use crossfibre::scene_file;
use crossfibre_faulty::answer::{Change, answer};
use crossfibre_faulty::scramble::scrambled;
use crossfibre_faulty::traced::trace;
use crossfibre_verification::conform::protocol::Precision;
use crossfibre_verification::faulty::catalogue::Wrong;
use crossfibre_verification::faulty::rewritten::Style;
use crossfibre_verification::random::SplitMix;

/// A candidate that is wrong on demand: reads questions on standard input, answers on standard
/// output.
#[derive(Parser)]
#[command(version)]
struct Args {
    /// A fault of --list, `expanded` or `factored` for other words, `none` for the reference itself
    #[arg(long, value_name = "NAME", default_value = "none", value_parser = change)]
    fault: Change,
    /// Compute in f32
    #[arg(long)]
    single: bool,
    /// Lose, double and exchange pieces of the answers, others for another seed
    #[arg(long, value_name = "SEED")]
    scramble: Option<u64>,
    /// Write the trace of a scene instead
    #[arg(long, value_name = "SCENE")]
    trace: Option<PathBuf>,
    /// Name the faults and the rewrites
    #[arg(long)]
    list: bool,
}

fn change(name: &str) -> Result<Change, String> {
    Change::from_name(name).ok_or_else(|| "no fault of that name: --list has them".into())
}

fn main() -> Result<()> {
    let args = Args::parse();
    let mut out = BufWriter::new(io::stdout().lock());
    if args.list {
        for wrong in Wrong::ALL {
            writeln!(out, "{:18} {}", wrong.fault().id, wrong.fault().what)?;
        }
        for style in Style::ALL {
            writeln!(out, "{:18} every equation right, in other words", style.name())?;
        }
    } else if let Some(path) = args.trace {
        let text = std::fs::read(&path).with_context(|| path.display().to_string())?;
        let scene = scene_file::read_bytes(&text).map_err(|fault| anyhow!("{fault}"))?;
        trace(args.fault, &scene, &mut out)?;
    } else {
        let number = if args.single { Precision::F32 } else { Precision::F64 };
        let mut scrambling = args.scramble.map(SplitMix::new);
        for (question, line) in io::stdin().lock().lines().enumerate() {
            let mut line = answer(&line?, args.fault, number);
            // But for `hello`, without which nothing would be asked.
            if let Some(random) = &mut scrambling
                && question > 0
            {
                line = scrambled(&line, random);
            }
            writeln!(out, "{line}")?;
            out.flush()?;
        }
    }
    Ok(out.flush()?)
}
