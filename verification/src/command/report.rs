//! `crossfibre report`: the reports again, from a stored record.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};

use crate::exit::Exit;
use crate::input;
use crate::record::{RIGHT_FILE, Record};
use crate::report;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The report.json that `verify` has written, `-` for standard input
    #[arg(long, value_name = "FILE")]
    from: PathBuf,
    /// Folder for the reports, all that `verify` writes but report.json; that of FILE if it is not given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Runs it. That checks have failed is for `verify` to say: this is well when the files are written.
pub fn run(args: &Args) -> Result<Exit> {
    let (name, text) = input::text(&args.from, RIGHT_FILE)?;
    let record = Record::read(&text).map_err(|fault| anyhow!("{name}: {fault}"))?;
    // Of standard input, `-`, that is the folder in which the command is run.
    let beside = args.from.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = args.out.as_deref().or(beside).unwrap_or(Path::new("."));
    let files = report::files(&record);
    report::write(folder, &files)?;
    let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    writeln!(io::stdout().lock(), "{} in {}", names.join(", "), folder.display())?;
    Ok(Exit::Well)
}
