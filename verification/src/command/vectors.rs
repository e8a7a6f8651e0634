//! `crossfibre vectors`: holds the golden vectors against what this program computes, and writes
//! them when told why.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Result, bail};

use crate::cases;
use crate::exit::{Exit, say};
use crate::golden::bless::{red, stored, stored_runs, write};
use crate::golden::compare::{Difference, differences, vectors_that_differ};
use crate::golden::effect::Effects;
use crate::golden::file::Vectors;
use crate::golden::{FILES, Recomputed};

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// Compare with what is stored, bit by bit; this is what happens anyway
    #[arg(long, conflicts_with = "bless")]
    check: bool,
    /// Store what this program computes, if all checks pass
    #[arg(long)]
    bless: bool,
    /// Why the vectors change; goes into the files and their history
    #[arg(long, value_name = "TEXT", requires = "bless")]
    reason: Option<String>,
    /// The folder of the vectors
    #[arg(long, value_name = "DIR", default_value = "golden")]
    dir: PathBuf,
}

/// Differences that are printed one by one.
const SHOWN: usize = 10;

pub fn run(args: &Args) -> Result<Exit> {
    let reason = one_line(args.reason.as_deref().unwrap_or_default());
    if args.bless && reason.is_empty() {
        bail!(
            "--bless wants a --reason\n  help: say why the numbers change, \
             for those who find them changed"
        );
    }
    let stored = stored(&args.dir)?;
    let recomputed = Recomputed::now();
    let differences = differences(&stored, &recomputed);
    print(&differences)?;
    if args.check || !args.bless {
        return Ok(if differences.is_empty() { Exit::Well } else { Exit::CheckFailed });
    }
    if differences.is_empty() {
        return Ok(Exit::Well);
    }
    let mut out = io::stdout().lock();
    if let [_, _, Vectors::Runs(after)] = &recomputed.vectors {
        writeln!(out, "\n{}", Effects { before: &stored_runs(&stored), after })?;
    }
    out.flush()?;
    let red = red(&cases::all());
    if !red.is_empty() {
        red.iter().for_each(|claim| say(&format!("red: {claim}")));
        say("nothing is written while a check is red\n  help: `crossfibre verify` says more");
        return Ok(Exit::CheckFailed);
    }
    let written = write(&args.dir, &differences, &recomputed, &reason)?;
    writeln!(out, "written: {}", written.join(", "))?;
    Ok(Exit::Well)
}

/// A text without line breaks, so that the history keeps a line for each blessing.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn print(differences: &[Difference]) -> Result<()> {
    let mut out = io::stdout().lock();
    for difference in differences.iter().take(SHOWN) {
        writeln!(out, "{difference}")?;
    }
    if differences.len() > SHOWN {
        writeln!(out, "… and {} more", differences.len() - SHOWN)?;
    }
    if differences.is_empty() {
        writeln!(out, "{}: the same to the bit", FILES.join(", "))?;
    } else {
        writeln!(
            out,
            "{} differences in {} vectors",
            differences.len(),
            vectors_that_differ(differences)
        )?;
    }
    Ok(())
}
