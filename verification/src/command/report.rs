//! `crossfibre report`: the reports again, from a stored record.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::{fs, io};

use anyhow::{Context, Result, anyhow};

use crate::exit::Exit;
use crate::record::Record;
use crate::report;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The report.json that `verify` has written, `-` for standard input
    #[arg(long, value_name = "FILE")]
    from: PathBuf,
    /// Folder for report.html, junit.xml, VALIDATION.md and summary.md; that of FILE if it is not given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Runs it. That checks have failed is for `verify` to say: this is well when the files are written.
pub fn run(args: &Args) -> Result<Exit> {
    let is_standard = args.from == Path::new("-");
    let name = if is_standard { "standard input".into() } else { args.from.display().to_string() };
    let bytes = if is_standard {
        let mut bytes = vec![];
        io::stdin().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        fs::read(&args.from)
    };
    let bytes = bytes.with_context(|| name.clone())?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        anyhow!("{name}: not UTF-8: the byte at offset {at}")
    })?;
    let record = Record::read(&text).map_err(|fault| anyhow!("{name}: {fault}"))?;
    let beside = args.from.parent().filter(|folder| !folder.as_os_str().is_empty() && !is_standard);
    let folder = args.out.as_deref().or(beside).unwrap_or(Path::new("."));
    let files = report::files(&record);
    report::write(folder, &files)?;
    let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    writeln!(io::stdout().lock(), "{} in {}", names.join(", "), folder.display())?;
    Ok(Exit::Well)
}
