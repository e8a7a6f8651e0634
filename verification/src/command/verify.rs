//! `crossfibre verify`: runs the checks, says what came of them, and writes the reports.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use indicatif::ProgressBar;

use crate::cases::support::shipped;
use crate::cases::{self, Verdict};
use crate::exit::{Exit, say};
use crate::record::{CaseRecord, Record, run_cases};
use crate::report::{self, markdown};
use crate::wide;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// Only cases whose name contains this; no report is written.
    #[arg(long)]
    filter: Option<String>,
    /// Name the cases and stop.
    #[arg(long)]
    list: bool,
    /// Print the record as JSON instead of lines for people.
    #[arg(long)]
    json: bool,
    /// Folder for report.json, report.html, junit.xml, VALIDATION.md and summary.md.
    #[arg(long, default_value = "target/verification", value_name = "DIR")]
    out: PathBuf,
    /// Fail if this file is not the VALIDATION.md that was written: a stale report.
    #[arg(long, value_name = "FILE", conflicts_with = "filter")]
    compare: Option<PathBuf>,
}

/// Runs it.
pub fn run(args: &Args) -> Result<Exit> {
    let chosen: Vec<_> = cases::all()
        .into_iter()
        .filter(|case| args.filter.as_ref().is_none_or(|part| case.id.contains(part.as_str())))
        .collect();
    if chosen.is_empty() {
        let part = args.filter.as_deref().unwrap_or_default();
        bail!("no case has `{part}` in its name; `crossfibre verify --list` names them");
    }
    if args.list {
        let mut out = io::stdout().lock();
        for case in &chosen {
            writeln!(out, "{:26} {}", case.id, case.title)?;
        }
        return Ok(Exit::Well);
    }
    // Drawn on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(chosen.len() as u64);
    let records = run_cases(&chosen, |_| bar.inc(1));
    bar.finish_and_clear();

    let troubles = records.iter().flat_map(CaseRecord::troubles).count();
    if !args.json {
        print(&records)?;
    }
    if args.filter.is_some() {
        if args.json {
            writeln!(io::stdout().lock(), "{}", serde_json::to_string_pretty(&records)?)?;
        }
        return Ok(if troubles == 0 { Exit::Well } else { Exit::CheckFailed });
    }
    let record = Record::around(records);
    let validation = write_reports(&record, &args.out)?;
    if args.json {
        writeln!(io::stdout().lock(), "{}", serde_json::to_string_pretty(&record)?)?;
    } else {
        let (all, passed) = record.tally();
        let mut out = io::stdout().lock();
        writeln!(out, "\n{passed} passed, {} failed", all - passed)?;
        writeln!(
            out,
            "the paper's timing example: 10.1 s of an IBM 370/168 then, {:.0} µs of this machine now",
            timing_example().as_secs_f64() * 1e6
        )?;
        writeln!(out, "reports: {}", args.out.display())?;
    }
    let stale = match &args.compare {
        Some(file) => is_stale(file, &validation, &args.out)?,
        None => false,
    };
    Ok(if troubles == 0 && !stale { Exit::Well } else { Exit::CheckFailed })
}

/// How long the paper's timing example takes: the shortest of some runs. In no report, because it is
/// another number every time.
fn timing_example() -> Duration {
    let scene = shipped("timing");
    let run = || {
        let start = Instant::now();
        wide::run(&scene, |_| {});
        start.elapsed()
    };
    (0..20).map(|_| run()).min().unwrap_or_default()
}

/// One line a case; each check that did not pass with what to look at.
fn print(records: &[CaseRecord]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    for case in records {
        let troubles = case.troubles().count();
        let mark = if troubles == 0 { "ok    " } else { "FAILED" };
        let passed = case.checks.len() - troubles;
        writeln!(out, "{mark} {:26} {passed:2}/{:<2}  {}", case.id, case.checks.len(), case.title)?;
        for trouble in case.troubles() {
            let check = &trouble.check;
            let what = match trouble.verdict {
                Verdict::Loose => "the bound is too loose for what is measured",
                _ => "out of bounds",
            };
            writeln!(out, "         {}: {what}", check.claim)?;
            writeln!(
                out,
                "           measured {:e}, bound {}",
                check.measured,
                markdown::bound(check.bound)
            )?;
            writeln!(out, "           norm:   {}", check.norm)?;
            writeln!(out, "           oracle: {}", check.oracle)?;
            writeln!(out, "           reason of the bound: {}", check.reason)?;
            writeln!(out, "           again:  crossfibre verify --filter {}", case.id)?;
        }
    }
    Ok(())
}

/// Writes the record and the reports; gives the text of VALIDATION.md.
fn write_reports(record: &Record, folder: &Path) -> Result<String> {
    let mut files = vec![("report.json", record.json())];
    files.extend(report::files(record));
    report::write(folder, &files)?;
    let validation = files.into_iter().find(|(name, _)| *name == "VALIDATION.md");
    Ok(validation.map(|(_, text)| text).unwrap_or_default())
}

/// Whether a file differs from the report just written; says where.
fn is_stale(file: &Path, fresh: &str, folder: &Path) -> Result<bool> {
    let old = fs::read_to_string(file).with_context(|| file.display().to_string())?;
    if old == fresh {
        return Ok(false);
    }
    let line = old.lines().zip(fresh.lines()).take_while(|(a, b)| a == b).count();
    say(&format!(
        "{} is stale from line {} on: read the difference, then copy {} over it",
        file.display(),
        line + 1,
        folder.join("VALIDATION.md").display()
    ));
    Ok(true)
}
