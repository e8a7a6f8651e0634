//! The record in a few lines of Markdown, for the page of a CI job.

use std::fmt::Write;

use crate::claims::Finding;
use crate::record::{CaseRecord, CheckRecord, Record};
use crate::report::words::{advice, argument, bound, cell, count, line, number};
use crate::sensitivity::matrix::Matrix;

/// The most failures that are told one by one.
const MOST: usize = 20;

/// The whole file.
pub fn render(record: &Record) -> String {
    let (all, passed) = record.tally();
    let mut out = String::new();
    let verdict = match (all, all - passed) {
        (0, _) => "no check was run".into(),
        (_, 0) => "all checks pass".into(),
        (_, failed) => format!(
            "{} not pass",
            count(failed, "check") + if failed == 1 { " does" } else { " do" }
        ),
    };
    let _ = writeln!(out, "## crossfibre {}: {verdict}\n", cell(&line(&record.version)));
    let found = |finding| record.claims.iter().filter(|claim| claim.finding == finding).count();
    let _ = writeln!(
        out,
        "**{passed} of {all} checks pass**, in {}{}. Of {} of the paper {} are reproduced, {} are not, {} cannot be \
         decided. {} from the page in the ledger.\n",
        count(record.cases.len(), "case"),
        left_out(record),
        count(record.claims.len(), "claim"),
        found(Finding::Reproduced),
        found(Finding::NotReproduced),
        found(Finding::Undecidable),
        count(record.ledger.len(), "departure"),
    );
    failures(&mut out, record);
    if let Some(matrix) = &record.sensitivity {
        let _ = writeln!(out, "{}\n", planted(matrix));
    }
    let _ = writeln!(
        out,
        "Made {} by {}, {} build for {}, source `{}`.\n",
        cell(&line(&record.build.commit_in_words())),
        cell(&line(&record.build.compiler)),
        cell(&line(&record.build.profile)),
        cell(&line(&record.build.target)),
        cell(&line(&record.build.source)).replace('`', "'"),
    );
    // Paths and no links: the page of a job is no place of the repository.
    out += "In full: `report.html` and `VALIDATION.md` of this job; how things are derived: `docs/exact`; \
            how to change them: `CONTRIBUTING.md`.\n";
    out
}

/// How many cases were not run, if any.
fn left_out(record: &Record) -> String {
    match record.left_out.len() {
        0 => String::new(),
        some => format!(", {} left out", count(some, "case")),
    }
}

/// What the checks make of planted faults.
fn planted(matrix: &Matrix) -> String {
    let faults = count(matrix.faults.len(), "planted fault");
    let checks = count(matrix.checks.len(), "check");
    let (missed, idle) = (matrix.missed().count(), matrix.idle().count());
    if (missed, idle) == (0, 0) {
        return format!("Of {faults} all are noticed.");
    }
    format!(
        "Of {faults} {} are noticed by some check, {missed} by none. Of {checks} {} notice some planted \
         fault, {idle} none.",
        matrix.noticed().count(),
        matrix.checks.len() - idle,
    )
}

fn failures(out: &mut String, record: &Record) {
    let troubles: Vec<(&CaseRecord, &CheckRecord)> = record
        .cases
        .iter()
        .flat_map(|case| case.troubles().map(move |check| (case, check)))
        .collect();
    if troubles.is_empty() {
        return;
    }
    *out += "| case | claim | measured | bound | what it is | what to do |\n|---|---|---|---|---|---|\n";
    for (case, record) in troubles.iter().take(MOST) {
        let check = &record.check;
        let again = format!("crossfibre verify --filter {}", argument(&case.id));
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} | {} | {}: `{}` |",
            cell(&case.id),
            cell(&check.claim),
            number(check.measured),
            bound(check.bound),
            record.verdict.words(),
            advice(record.verdict),
            cell(&again).replace('`', "'"),
        );
    }
    if troubles.len() > MOST {
        let _ = writeln!(out, "\nand {} more.", troubles.len() - MOST);
    }
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up::{self, HOSTILE};

    #[test]
    fn a_reader_learns_the_verdict_first_and_what_to_do() {
        let passing = render(&made_up::passing());
        assert!(passing.starts_with("## crossfibre 0.0.7: all checks pass\n"), "{passing}");
        assert!(!passing.contains("--filter"));
        let failing = render(&made_up::record());
        assert!(failing.starts_with("## crossfibre 0.0.7: 5 checks do not pass\n"), "{failing}");
        assert!(failing.contains("`crossfibre verify --filter a.troubled` |"), "{failing}");
        assert!(failing.contains("set the tolerance by the error"), "{failing}");
        assert!(failing.len() < 6000, "{}", failing.len());
    }

    /// The second check of the troubled case, repeated so that so many checks do not pass.
    fn with_troubles(count: usize) -> String {
        let mut record = made_up::record();
        record.cases.truncate(2);
        let failing = record.cases[1].checks[1].clone();
        record.cases[1].checks = vec![failing; count];
        render(&record)
    }

    #[test]
    fn of_many_troubles_the_first_twenty_are_shown_and_the_others_counted() {
        let rows = |text: &str| text.matches("| a.troubled |").count();
        let (twenty, more) = (with_troubles(20), with_troubles(23));
        assert_eq!((rows(&twenty), twenty.contains(" more.")), (20, false));
        assert_eq!((rows(&more), more.contains("\nand 3 more.\n")), (20, true));
    }

    #[test]
    fn a_part_of_the_cases_is_told_to_be_one() {
        let mut record = made_up::passing();
        assert!(render(&record).contains(" in 1 case. Of "));
        record.left_out = vec!["smith.kink".into(), "smith.sweep".into()];
        assert!(render(&record).contains(" in 1 case, 2 cases left out. Of "));
    }

    #[test]
    fn hostile_names_stay_in_their_cells() {
        let text = render(&made_up::record());
        for bad in ["<script", "](javascript", "\u{0}", "\u{202e}", HOSTILE] {
            assert!(!text.contains(bad), "{bad:?} in {text}");
        }
        let rows = text.lines().filter(|line| line.starts_with('|'));
        let cells = |row: &str| row.replace("\\\\", "").replace("\\|", "").matches('|').count();
        assert!(rows.clone().count() >= 7);
        assert!(rows.clone().all(|row| cells(row) == 7), "{text}");
    }

    /// Of the made-up faults one makes two of the four checks fail, one stops their case, and one is
    /// noticed by nothing.
    #[test]
    fn what_the_checks_make_of_planted_faults_is_two_statements_or_that_all_are_noticed() {
        let mut matrix = made_up::passing().sensitivity.unwrap();
        let all_but_one = "Of 3 planted faults 2 are noticed by some check, 1 by none. Of 4 checks 4 notice some \
                           planted fault, 0 none.";
        assert_eq!(planted(&matrix), all_but_one);
        let unseen = matrix.faults.pop();
        assert_eq!(planted(&matrix), "Of 2 planted faults all are noticed.");
        matrix.faults.pop();
        matrix.faults.extend(unseen);
        let two_idle = "Of 2 planted faults 1 are noticed by some check, 1 by none. Of 4 checks 2 notice some \
                        planted fault, 2 none.";
        assert_eq!(planted(&matrix), two_idle);
    }

    #[test]
    fn of_many_failures_the_first_are_told() {
        let mut record = made_up::record();
        let failed = record.cases[1].checks[1].clone();
        record.cases[1].checks.extend(std::iter::repeat_n(failed, 40));
        let text = render(&record);
        assert!(text.contains("\nand 25 more.\n"), "{text}");
    }
}
