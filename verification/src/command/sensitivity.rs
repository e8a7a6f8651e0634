//! `crossfibre verify --sensitivity`: plants every fault in turn and says which checks notice.

use std::io::{self, Write};
use std::path::Path;

use anyhow::{Result, anyhow};
use indicatif::ProgressBar;

use crate::cases::Case;
use crate::exit::Exit;
use crate::output::make_folder;
use crate::planted;
use crate::report;
use crate::sensitivity::judge::judge;
use crate::sensitivity::measure::{Asked, measure};
use crate::sensitivity::{one, page};

/// Measures the matrix, stores it with its page in a folder and judges it.
pub fn run(asked: &Asked<'_>, folder: &Path, as_json: bool) -> Result<Exit> {
    // Before half an hour of work, not after.
    make_folder(folder)?;
    let faults = planted::all();
    // Drawn on standard error, and only if that is a terminal.
    let bar = ProgressBar::new((faults.len() + planted::rewrites().len()) as u64);
    let matrix = measure(asked, &faults, || bar.inc(1))?;
    bar.finish_and_clear();

    let json = serde_json::to_string_pretty(&matrix)? + "\n";
    report::write(folder, &[("matrix.json", json.clone()), ("README.md", page::page(&matrix))])?;
    let judged = judge(&matrix);
    let mut out = io::stdout().lock();
    if as_json {
        write!(out, "{json}")?;
    } else {
        writeln!(out, "{}", page::groups(&matrix))?;
        write!(out, "{}", page::judgement(&judged))?;
        writeln!(out, "\nthe matrix and its page: {}", folder.display())?;
    }
    Ok(if judged.is_well() { Exit::Well } else { Exit::CheckFailed })
}

/// `--plant`: the checks with one fault, a line of JSON for each case that comes to its end.
pub fn planted(id: &str, cases: &[Case]) -> Result<Exit> {
    planted::plant(id).map_err(|unknown| anyhow!("--plant: {unknown}"))?;
    one::tell(cases, |said| {
        let line = serde_json::to_string(said).expect("a line can be written");
        // A reader that has gone needs no more.
        let _ = writeln!(io::stdout().lock(), "{line}");
    });
    Ok(Exit::Well)
}
