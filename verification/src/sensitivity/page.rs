//! The matrix in words: the page in `docs/sensitivity`, and what `verify --sensitivity` prints.

use super::judge::{Judgement, judge};
use super::matrix::{Matrix, Row};
use crate::report::words::cell;
use crate::tables::markdown;

/// The page.
pub fn page(matrix: &Matrix) -> String {
    let sections = [
        head(matrix),
        groups(matrix),
        judgement(&judge(matrix)),
        rewrites(matrix),
        faults(matrix),
        checks(matrix),
    ];
    sections.join("\n")
}

/// By group of faults: how many there are, and how many of them are noticed.
pub fn groups(matrix: &Matrix) -> String {
    let mut names: Vec<&str> = Vec::new();
    for row in &matrix.faults {
        if !names.contains(&row.group.as_str()) {
            names.push(&row.group);
        }
    }
    let missed: Vec<&str> = matrix.missed_by_quick().map(|row| row.id.as_str()).collect();
    let rows: Vec<Vec<String>> = names
        .iter()
        .map(|&name| {
            let of_group: Vec<&Row> =
                matrix.faults.iter().filter(|row| row.group == name).collect();
            let noticed = of_group.iter().filter(|row| !missed.contains(&row.id.as_str())).count();
            let fewest = of_group.iter().map(|row| matrix.noticing(row).count()).min().unwrap_or(0);
            [cell(name), of_group.len().to_string(), noticed.to_string(), fewest.to_string()]
                .to_vec()
        })
        .collect();
    markdown(
        &["faults in", "faults", "noticed by the quick checks", "fewest checks that notice one"],
        &rows,
    )
}

/// What is wrong with the matrix, as a list; a sentence if nothing is.
pub fn judgement(judgement: &Judgement) -> String {
    let lines = judgement.lines();
    if lines.is_empty() {
        return "Every fault is noticed by a check of the quick set, every check notices a fault, and no check but \
                those that compare bits falls for an edition that is equal in algebra.\n"
            .into();
    }
    lines.iter().map(|line| format!("- {}\n", cell(line))).collect()
}

fn head(matrix: &Matrix) -> String {
    format!(
        "\
# What the checks notice

Written by

    crossfibre verify --sensitivity --quick --out docs/sensitivity

Each fault below is something that can go wrong when equations are copied from a page, when the march is put
together, when a law or an exact solution is worked out. It is planted, the {} quick checks are run, and those that no
longer pass have noticed it. The whole matrix is [matrix.json](matrix.json).
",
        matrix.checks.len()
    )
}

fn rewrites(matrix: &Matrix) -> String {
    let rows: Vec<Vec<String>> = matrix
        .rewrites
        .iter()
        .map(|row| {
            vec![
                format!("`{}`", cell(&row.id).replace('`', "'")),
                cell(&row.what),
                falling(matrix, row),
            ]
        })
        .collect();
    format!(
        "## Editions that are equal in algebra\n\nTheir last digits differ, so that only checks of bits may fall.\n\n{}",
        markdown(&["edition", "what is done", "checks that fall"], &rows)
    )
}

fn falling(matrix: &Matrix, row: &Row) -> String {
    let names: Vec<String> = matrix
        .noticing(row)
        .map(|i| format!("{}: {}", cell(&matrix.checks[i].case), cell(&matrix.checks[i].claim)))
        .collect();
    if names.is_empty() { "none".into() } else { names.join("; ") }
}

fn faults(matrix: &Matrix) -> String {
    let rows: Vec<Vec<String>> = matrix
        .faults
        .iter()
        .map(|row| {
            vec![
                format!("`{}`", cell(&row.id).replace('`', "'")),
                cell(&row.group),
                cell(&row.what),
                matrix.noticing(row).count().to_string(),
                cases(matrix, row),
            ]
        })
        .collect();
    format!(
        "## The faults\n\nA case in italics comes to no end with the fault: it panics.\n\n{}",
        markdown(&["fault", "in", "what is done instead", "checks", "cases that notice it"], &rows)
    )
}

/// The cases that notice a fault.
fn cases(matrix: &Matrix, row: &Row) -> String {
    let name = |case| if row.stops(case) { format!("*{}*", cell(case)) } else { cell(case) };
    matrix.cases_noticing(row).into_iter().map(name).collect::<Vec<_>>().join(", ")
}

fn checks(matrix: &Matrix) -> String {
    let rows: Vec<Vec<String>> = matrix
        .checks
        .iter()
        .enumerate()
        .map(|(i, check)| {
            let quick = if check.quick { "yes" } else { "" };
            vec![
                check.case.clone(),
                cell(&check.claim),
                quick.into(),
                matrix.noticed_by(i).count().to_string(),
            ]
        })
        .collect();
    format!(
        "## The checks\n\n{}",
        markdown(&["case", "claim", "quick", "faults that it notices"], &rows)
    )
}
