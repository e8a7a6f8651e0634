//! `crossfibre verify`: runs the checks, says what came of them, and writes the reports.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use crossfibre::nearest::did_you_mean;
use serde_json::json;

use super::{sensitivity, verify_shown};
use crate::cases::support::shipped;
use crate::cases::{self, Case};
use crate::exit::{Exit, say};
use crate::input;
use crate::output::make_folder;
use crate::record::{CaseRecord, Record};
use crate::report::{self, words::count};
use crate::sensitivity::measure::Asked;
use crate::wide;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// Only cases whose name contains this (may be repeated); reports only if --out is given
    #[arg(long, value_name = "PART")]
    filter: Vec<String>,
    /// Only what takes seconds; reports only if --out is given
    #[arg(long)]
    quick: bool,
    /// Everything, and what takes minutes: the whole stored record of the study work-precision
    #[arg(long, conflicts_with = "quick")]
    full: bool,
    /// Plant every fault of the catalogue in turn and say which checks notice it: the kill matrix, written to
    /// --out [default: target/sensitivity]; of the cases that are chosen
    #[arg(long, conflicts_with_all = ["full", "list", "compare"])]
    sensitivity: bool,
    /// Run the checks with a fault planted: what --sensitivity does with every fault
    #[arg(long, value_name = "FAULT", hide = true, conflicts_with_all = ["sensitivity", "list", "out", "compare"])]
    plant: Option<String>,
    /// Name the cases and stop: name, quick or not, number of equations exercised, title
    #[arg(long)]
    list: bool,
    /// Print the record as JSON instead of lines for people
    #[arg(long)]
    json: bool,
    /// Folder for the reports [default: target/verification]; of a part of the cases all but
    /// VALIDATION.md
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Fail if this file is not the VALIDATION.md that was written: a stale report
    #[arg(long, value_name = "FILE", conflicts_with_all = ["filter", "quick", "full"])]
    compare: Option<PathBuf>,
}

/// Runs it.
pub fn run(args: &Args) -> Result<Exit> {
    let chosen = chosen(args)?;
    if args.list {
        list(&chosen, args.json)?;
        return Ok(Exit::Well);
    }
    if let Some(fault) = &args.plant {
        return sensitivity::planted(fault, &chosen);
    }
    if args.sensitivity {
        let folder = args.out.as_deref().unwrap_or(Path::new("target/sensitivity"));
        let asked = Asked { cases: &chosen, arguments: &args.selection() };
        return sensitivity::run(&asked, folder, args.json);
    }
    // Before the checks, which take a while: what the reports are written to and compared with.
    let folder = args.folder();
    folder.map_or(Ok(()), make_folder)?;
    let old = args.compare.as_deref().map(|file| input::text(file, REPORT)).transpose()?;
    let records = verify_shown::run(&chosen, !args.json)?;
    let well = records.iter().flat_map(CaseRecord::troubles).next().is_none();
    let stale = match folder {
        Some(folder) if !args.is_part() => whole(args, folder, records, old)?,
        _ => part(args, folder, records)?,
    };
    Ok(if well && !stale { Exit::Well } else { Exit::CheckFailed })
}

impl Args {
    /// Whether cases are left out.
    fn is_part(&self) -> bool {
        self.quick || !self.filter.is_empty()
    }

    /// The folder to write reports to; none where a part of the cases has none.
    fn folder(&self) -> Option<&Path> {
        self.out.as_deref().or_else(|| (!self.is_part()).then_some(Path::new(report::FOLDER)))
    }

    /// The arguments that choose the same cases.
    fn selection(&self) -> Vec<String> {
        let filters = self.filter.iter().flat_map(|part| ["--filter".into(), part.clone()]);
        self.quick.then(|| "--quick".into()).into_iter().chain(filters).collect()
    }
}

/// The cases to run.
fn chosen(args: &Args) -> Result<Vec<Case>> {
    let mut cases = if args.full { cases::full() } else { cases::all() };
    for part in &args.filter {
        if !cases.iter().any(|case| case.id.contains(part)) {
            let known: Vec<_> =
                cases.iter().flat_map(|case| case.id.split('.').chain([case.id])).collect();
            let meant = did_you_mean(part, &known);
            bail!("no case has `{part}` in its name{meant}; `crossfibre verify --list` names them");
        }
    }
    let named = |case: &Case| {
        args.filter.is_empty() || args.filter.iter().any(|part| case.id.contains(part))
    };
    cases.retain(|case| named(case) && (case.is_quick() || !args.quick));
    if cases.is_empty() {
        bail!("none of these cases is quick; leave out --quick");
    }
    Ok(cases)
}

fn list(cases: &[Case], as_json: bool) -> Result<()> {
    let mut out = io::stdout().lock();
    if as_json {
        let listed = |case: &Case| json!({ "id": case.id, "quick": case.is_quick(), "equations": case.equations, "title": case.title });
        let listed: Vec<_> = cases.iter().map(listed).collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&listed)?)?;
        return Ok(());
    }
    for case in cases {
        let quick = if case.is_quick() { "quick" } else { "" };
        writeln!(out, "{:26} {quick:5} {:3}  {}", case.id, case.equations.len(), case.title)?;
    }
    Ok(())
}

/// The end of a part of the cases.
fn part(args: &Args, folder: Option<&Path>, records: Vec<CaseRecord>) -> Result<bool> {
    if args.json {
        writeln!(io::stdout().lock(), "{}", serde_json::to_string_pretty(&records)?)?;
    } else {
        tell(&records)?;
    }
    if let Some(folder) = folder {
        let mut files = written(&Record::around(records));
        // That one is of all cases.
        files.retain(|(name, _)| *name != VALIDATION);
        report::write(folder, &files)?;
    }
    Ok(false)
}

/// The end of all cases: the reports; whether the old one, of this name and text, is stale.
fn whole(
    args: &Args,
    out: &Path,
    records: Vec<CaseRecord>,
    old: Option<(String, String)>,
) -> Result<bool> {
    let record = Record::around(records);
    let files = written(&record);
    report::write(out, &files)?;
    if args.json {
        writeln!(io::stdout().lock(), "{}", serde_json::to_string_pretty(&record)?)?;
    } else {
        tell(&record.cases)?;
        let mut to = io::stdout().lock();
        writeln!(
            to,
            "the paper's timing example: 10.1 s of an IBM 370/168 then, {:.0} µs of this machine now",
            timing_example().as_secs_f64() * 1e6
        )?;
        writeln!(to, "reports: {}", out.display())?;
    }
    let fresh = files.iter().find(|(name, _)| *name == VALIDATION).map(|(_, text)| text);
    Ok(old.zip(fresh).is_some_and(|((name, old), fresh)| is_stale(&name, &old, fresh, out)))
}

/// What failed, and how many.
fn tell(records: &[CaseRecord]) -> io::Result<()> {
    let mut to = anstream::stdout().lock();
    verify_shown::failures(records, &mut to)?;
    let checks: usize = records.iter().map(|case| case.checks.len()).sum();
    let failed = records.iter().flat_map(CaseRecord::troubles).count();
    writeln!(
        to,
        "\n{} passed, {failed} failed, in {}",
        checks - failed,
        count(records.len(), "case")
    )
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

/// The report that is in the repository.
const VALIDATION: &str = "VALIDATION.md";

/// What to do about a file that cannot be compared with it.
const REPORT: &str = "name the VALIDATION.md of the repository";

/// The record and the reports.
fn written(record: &Record) -> Vec<(&'static str, String)> {
    [("report.json", record.json())].into_iter().chain(report::files(record)).collect()
}

/// Whether an old report differs from the one just written; says where.
fn is_stale(name: &str, old: &str, fresh: &str, folder: &Path) -> bool {
    if old == fresh {
        return false;
    }
    let line = old.lines().zip(fresh.lines()).take_while(|(a, b)| a == b).count();
    say(&format!(
        "{name} is stale from line {} on: read the difference, then copy {} over it",
        line + 1,
        folder.join(VALIDATION).display()
    ));
    true
}

#[cfg(test)]
mod tests {
    use std::env;
    use std::process::Command;

    use super::*;
    use crate::planted;

    /// No arguments.
    fn none() -> Args {
        Args {
            filter: vec![],
            quick: false,
            full: false,
            sensitivity: false,
            plant: None,
            list: false,
            json: false,
            out: None,
            compare: None,
        }
    }

    #[test]
    fn a_part_is_what_quick_or_a_filter_leaves_and_has_no_folder_but_the_one_named() {
        let filter = || vec!["smith".to_owned(), "axial".to_owned()];
        let whole = [none(), Args { full: true, ..none() }];
        let parts = [
            Args { quick: true, ..none() },
            Args { filter: filter(), ..none() },
            Args { quick: true, filter: filter(), ..none() },
        ];
        for args in whole {
            assert!(!args.is_part());
            assert_eq!(args.folder(), Some(Path::new("target/verification")));
            assert_eq!(args.selection(), [""; 0]);
        }
        assert!(parts.iter().all(|args| args.is_part() && args.folder().is_none()));
        let named = parts.each_ref().map(Args::selection);
        assert_eq!(named[0], ["--quick"]);
        assert_eq!(named[1], ["--filter", "smith", "--filter", "axial"]);
        assert_eq!(named[2], ["--quick", "--filter", "smith", "--filter", "axial"]);
        let args = Args { quick: true, out: Some("a".into()), ..none() };
        assert_eq!(args.folder(), Some(Path::new("a")));
    }

    #[test]
    fn a_report_is_stale_that_is_not_the_one_just_written() {
        let is_stale = |old, fresh| is_stale("a.md", old, fresh, Path::new("out"));
        assert!(!is_stale("# A\n1\n", "# A\n1\n"));
        assert!(is_stale("# A\n1\n", "# A\n2\n"));
        // Every line of the one is one of the other.
        assert!(is_stale("# A\n", "# A\n2\n") && is_stale("# A\n2\n", "# A\n"));
    }

    #[test]
    fn the_timing_example_takes_some_time() {
        assert!(timing_example() > Duration::ZERO);
    }

    /// What is planted stays for the whole process, so that the test calls itself in one of its own.
    #[test]
    fn a_check_that_fails_ends_with_its_own_code() {
        const ALONE: &str = "CROSSFIBRE_TEST_ALONE";
        const THIS: &str = "command::verify::tests::a_check_that_fails_ends_with_its_own_code";
        if env::var_os(ALONE).is_some() {
            planted::plant("2-twice").unwrap();
            let filter = vec!["momentum.fig3".to_owned()];
            assert_eq!(run(&Args { filter, ..none() }).unwrap(), Exit::CheckFailed);
            return;
        }
        let mut itself = Command::new(env::current_exe().unwrap());
        let ended = itself.args([THIS, "--exact"]).env(ALONE, "1").output().unwrap();
        let said = String::from_utf8_lossy(&ended.stdout);
        assert!(ended.status.success() && said.contains("test result: ok. 1 passed"), "{said}");
    }
}
