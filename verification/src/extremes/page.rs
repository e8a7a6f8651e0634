//! The page `docs/extremes/README.md`.

use super::{GROUPS, Row};
use crate::cases::Verdict;
use crate::report::markdown::{bound, cell, number};

/// The page: a pure function of the program.
pub fn page() -> String {
    let mut out = String::from(
        "\
# Extreme cases

What happens at the ends of every parameter, whether it is right, and what the program says. This page is
written by

    crossfibre study extremes --out docs/extremes

and is the same to the byte wherever that runs: the numbers of its tables are measured, not typed. The same
rows are the cases `extreme.*` of `crossfibre verify`. That no scene which passes its check ends in a panic or in
a number that is not finite is tested over random scenes (`tests/library/parameter_box.rs`).
",
    );
    for group in GROUPS {
        out += &format!("\n## {}\n\n{}\n\n", group.case.title, group.found);
        out += "| scene | what must happen | the program says | measured | bound | against, and why |\n";
        out += "|---|---|---|---|---|---|\n";
        for row in (group.rows)() {
            out += &line(&row);
        }
    }
    out
}

fn line(row: &Row) -> String {
    let Row { extreme, says, check } = row;
    let failed = if check.verdict() == Verdict::Passed { "" } else { " **failed**" };
    let why = [check.oracle.as_str(), check.norm.as_str(), check.reason.as_str()]
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join("; ");
    let cells = [
        cell(extreme),
        cell(&check.claim),
        cell(says),
        format!("{}{failed}", number(check.measured)),
        bound(check.bound),
        cell(&why),
    ];
    format!("| {} |\n", cells.join(" | "))
}
