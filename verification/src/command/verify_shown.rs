//! What `crossfibre verify` shows while it runs: a line a case in the order of the list, and below them
//! on a terminal how far it is.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use console::{Term, truncate_str};
use indicatif::{ProgressBar, ProgressStyle};

use crate::cases::{Case, all};
use crate::exit::{BAD, GOOD};
use crate::record::{CaseRecord, run_watched};
use crate::report::words::{advice, bound};

/// Runs cases, and prints each as soon as it and all before it are done.
pub fn run(cases: &[Case], print_lines: bool) -> io::Result<Vec<CaseRecord>> {
    // Drawn on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(cases.len() as u64).with_style(style());
    // The seconds go on while a long case runs.
    bar.enable_steady_tick(Duration::from_secs(1));
    let running = Mutex::new(Vec::new());
    let show = |change: &dyn Fn(&mut Vec<&'static str>)| {
        let mut running = held(&running);
        change(&mut running);
        bar.set_message(running.join(", "));
    };
    let lines = Mutex::new(InOrder::default());
    let columns = Term::stdout().size_checked().map(|(_, columns)| usize::from(columns));
    let records = run_watched(
        cases,
        |case| show(&|running| running.push(case.id)),
        |place, record| {
            if print_lines {
                let mut lines = held(&lines);
                bar.suspend(|| lines.done(place, line(record, columns), &mut anstream::stdout()));
            }
            show(&|running| running.retain(|id| *id != record.id));
            bar.inc(1);
        },
    );
    bar.finish_and_clear();
    lines.into_inner().unwrap_or_else(PoisonError::into_inner).written?;
    Ok(records)
}

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{bar:24} {pos}/{len} {elapsed} {wide_msg}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Lines that come in any order and are written in theirs.
struct InOrder {
    next: usize,
    waiting: BTreeMap<usize, String>,
    /// The first failure to write, after which nothing more is written.
    written: io::Result<()>,
}

impl Default for InOrder {
    fn default() -> Self {
        Self { next: 0, waiting: BTreeMap::new(), written: Ok(()) }
    }
}

impl InOrder {
    fn done(&mut self, place: usize, line: String, to: &mut impl Write) {
        self.waiting.insert(place, line);
        while let Some(line) = self.waiting.remove(&self.next) {
            self.next += 1;
            if self.written.is_ok() {
                self.written = write!(to, "{line}").and_then(|()| to.flush());
            }
        }
    }
}

/// A case in a line, cut off where a terminal ends, and each check that did not pass in another.
fn line(case: &CaseRecord, columns: Option<usize>) -> String {
    let troubles: Vec<_> = case.troubles().collect();
    let (style, mark) = if troubles.is_empty() { (GOOD, "ok    ") } else { (BAD, "FAILED") };
    let passed = case.checks.len() - troubles.len();
    let whole = format!(
        "{style}{mark}{style:#} {:26} {passed:2}/{:<2}  {}",
        case.id,
        case.checks.len(),
        case.title
    );
    let mut text = truncate_str(&whole, columns.unwrap_or(usize::MAX), "…").into_owned() + "\n";
    for trouble in troubles {
        text += &format!("         {}: {}\n", trouble.check.claim, trouble.verdict.words());
    }
    text
}

/// Every check that did not pass, with its numbers and what to do next; nothing if all did.
pub fn failures(records: &[CaseRecord], to: &mut impl Write) -> io::Result<()> {
    let ordinary = all();
    for case in records.iter().filter(|case| case.troubles().next().is_some()) {
        writeln!(to, "\n{BAD}FAILED{BAD:#} {}: {}", case.id, case.title)?;
        for trouble in case.troubles() {
            let check = &trouble.check;
            writeln!(to, "  {}: {}", check.claim, trouble.verdict.words())?;
            writeln!(to, "    measured {:e}, bound {}", check.measured, bound(check.bound))?;
            writeln!(to, "    norm:   {}", check.norm)?;
            writeln!(to, "    oracle: {}", check.oracle)?;
            writeln!(to, "    reason of the bound: {}", check.reason)?;
            writeln!(to, "    what to do: {}", advice(trouble.verdict))?;
        }
        for page in &case.derivation {
            writeln!(to, "  derived in: {}", page.path)?;
        }
        let is_ordinary = ordinary.iter().any(|ordinary| ordinary.id == case.id);
        let full = if is_ordinary { "" } else { "--full " };
        writeln!(to, "  again:      crossfibre verify {full}--filter {}", case.id)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::{Bound, Check, Verdict};
    use crate::derivations;
    use crate::record::CheckRecord;

    fn case(id: &str, verdict: Verdict) -> CaseRecord {
        let text = |what: &str| format!("{what} of {id}");
        let check = Check {
            claim: text("claim"),
            oracle: text("oracle"),
            norm: text("norm"),
            measured: 0.0137,
            bound: Bound::AtMost(0.0121),
            reason: text("reason"),
        };
        let checks = vec![CheckRecord { check, verdict }];
        CaseRecord {
            id: id.into(),
            title: text("title"),
            quick: true,
            equations: vec![],
            derivation: derivations::of(id),
            pictures: vec![],
            checks,
            seconds: 1.7,
        }
    }

    #[test]
    fn lines_wait_for_those_before_them() {
        let (mut lines, mut seen) = (InOrder::default(), Vec::new());
        for (place, upto) in [(2, ""), (0, "0"), (3, "0"), (1, "0123"), (4, "01234")] {
            lines.done(place, place.to_string(), &mut seen);
            assert_eq!(seen, upto.as_bytes());
        }
    }

    #[test]
    fn a_failure_is_told_with_where_to_look_and_how_to_run_it_again() {
        let records =
            [case("smith.kink", Verdict::Failed), case("golden.vectors", Verdict::Passed)];
        let mut text = Vec::new();
        failures(&records, &mut anstream::StripStream::new(&mut text)).unwrap();
        let text = String::from_utf8(text).unwrap();
        for part in [
            "FAILED smith.kink: title of smith.kink",
            "claim of smith.kink: out of bounds",
            "measured 1.37e-2, bound at most 0.0121",
            "derived in: docs/exact/smith.md",
            "what to do: run the case again",
            "again:      crossfibre verify --filter smith.kink",
        ] {
            assert!(text.contains(part), "{part} is not in:\n{text}");
        }
        assert!(!text.contains("golden.vectors"), "{text}");
    }

    #[test]
    fn a_case_that_is_run_with_all_others_only_if_asked_for_is_asked_for_again() {
        for (id, again) in [
            ("smith.kink", "crossfibre verify --filter smith.kink\n"),
            (
                "precision.whole-record",
                "crossfibre verify --full --filter precision.whole-record\n",
            ),
        ] {
            let mut text = Vec::new();
            failures(&[case(id, Verdict::Failed)], &mut text).unwrap();
            let text = String::from_utf8(text).unwrap();
            assert!(text.ends_with(again), "{text}");
        }
    }

    #[test]
    fn a_case_is_a_line_with_a_mark() {
        let shown = |verdict, columns| {
            let text = line(&case("smith.kink", verdict), columns);
            anstream::adapter::strip_str(&text).to_string()
        };
        let whole = "ok     smith.kink                  1/1   title of smith.kink\n";
        assert_eq!(shown(Verdict::Passed, None), whole);
        assert_eq!(shown(Verdict::Passed, Some(60)), whole);
        assert_eq!(
            shown(Verdict::Passed, Some(50)),
            "ok     smith.kink                  1/1   title of…\n"
        );
        // What has failed is told in whole.
        let loose = shown(Verdict::Loose, Some(50));
        assert!(loose.starts_with("FAILED smith.kink                  0/1 "), "{loose}");
        assert!(loose.contains("claim of smith.kink: bound too loose"), "{loose}");
    }
}
