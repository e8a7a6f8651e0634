//! The first screen: did everything pass, what is proven and what is not, how accurate for how much
//! time, what the paper got wrong.

use std::collections::BTreeSet;

use maud::{Markup, html};

use super::cost::{in_words, page_or_cheapest};
use super::parts::{duration, text};
use crate::cases::Verdict;
use crate::claims::{Claim, Finding};
use crate::ledger_effects::CrossoverRow;
use crate::record::Record;
use crate::report::words::{count, equations, number, visible};

/// The verdict in a sentence.
pub fn verdict(record: &Record) -> String {
    let (all, passed) = record.tally();
    match (all, all - passed) {
        (0, _) => "No check was run".into(),
        (_, 0) if !record.left_out.is_empty() => format!("All {all} checks that were run pass"),
        (_, 0) => format!("All {all} checks pass"),
        (_, 1) => format!("1 of {all} checks does not pass"),
        (_, failed) => format!("{failed} of {all} checks do not pass"),
    }
}

/// What stands below it.
pub fn lead() -> Markup {
    html! {
        p.lead {
            "A literal reference of a 1980 model of stress waves in two crossed fibres, held against closed "
            "forms, invariants, and itself. Each check names what it is compared with, how, and why its "
            "tolerance is what it is."
        }
    }
}

/// The four answers.
pub fn answers(record: &Record) -> Markup {
    html! {
        section.answers aria-label="The answers in short" {
            (passed(record)) (proven(record)) (accurate(record)) (wrong(record))
        }
    }
}

fn passed(record: &Record) -> Markup {
    let verdicts = || record.cases.iter().flat_map(|case| &case.checks).map(|check| check.verdict);
    let number_of = |verdict| verdicts().filter(|v| *v == verdict).count();
    let seconds: f64 = record.cases.iter().map(|case| case.seconds).sum();
    html! {
        section.card {
            h2 { "Did everything pass?" }
            p.figure { (number_of(Verdict::Passed)) span.of { " of " (verdicts().count()) } }
            ul.plain {
                li { (count(record.cases.len(), "case")) ", " (duration(seconds)) " of computing" }
                @if !record.left_out.is_empty() {
                    li { strong.warn { "Not all: " } (count(record.left_out.len(), "case")) " left out" }
                }
                @if let Some((least, median)) = head_rooms(record) {
                    li { "head-room of tolerances: " (format!("{least:.2}")) " the least, "
                        (format!("{median:.1}")) " the median, 8 the most that passes" }
                }
                li { (number_of(Verdict::Failed)) " out of bounds, " (number_of(Verdict::Loose))
                    " with a bound too loose, " (number_of(Verdict::Redundant)) " said twice" }
                @if let Some(matrix) = &record.sensitivity {
                    li { (matrix.noticed().count()) " of " (count(matrix.faults.len(), "planted fault")) " noticed" }
                }
            }
            p.more { a href="#cases" { "Every case" } " · " a href="#tolerances" { "every tolerance" } }
        }
    }
}

/// The least head-room, and the median.
fn head_rooms(record: &Record) -> Option<(f64, f64)> {
    let checks = record.cases.iter().flat_map(|case| &case.checks);
    let mut all: Vec<f64> = checks.filter_map(|record| record.check.head_room()).collect();
    all.sort_by(f64::total_cmp);
    Some((*all.first()?, all[all.len() / 2]))
}

fn proven(record: &Record) -> Markup {
    let of = |finding| record.claims.iter().filter(move |claim: &&Claim| claim.finding == finding);
    html! {
        section.card {
            h2 { "What is proven, what is not?" }
            p.figure { (of(Finding::Reproduced).count())
                span.of { " of " (count(record.claims.len(), "claim")) " of the paper reproduced" } }
            ul.plain {
                @for claim in of(Finding::NotReproduced) {
                    li { strong.bad { "Not reproduced: " } (text(&claim.claim)) }
                }
                @for claim in of(Finding::Undecidable) {
                    li { strong.warn { "Undecidable: " } (text(&claim.claim)) }
                }
                @for claim in of(Finding::NotExamined) {
                    li { strong.warn { "Not examined: " } (text(&claim.claim)) }
                }
            }
            p.more { a href="#claims" { "Every claim, with its evidence" } }
        }
    }
}

/// How many accuracies are told here.
const TOLD: usize = 6;

fn accurate(record: &Record) -> Markup {
    // Evenly from all of them: the first is the easiest of one fibre, the last of two.
    let wanted = &record.cost.wanted;
    let each = wanted.len().div_ceil(TOLD).max(1);
    html! {
        section.card {
            h2 { "How accurate for how much time?" }
            @if wanted.is_empty() { p { "The record does not say." } }
            dl.pairs {
                @for row in wanted.iter().skip(1).step_by(each) {
                    dt { (visible(&row.what)) }
                    dd { (page_or_cheapest(row).map_or("not reached".into(), in_words)) }
                }
            }
            p.more { a href="#cost" { "All of it, errors against work" } }
        }
    }
}

fn wrong(record: &Record) -> Markup {
    let errata: Vec<_> = record.ledger.iter().filter(|line| line.kind == "erratum").collect();
    let changed: BTreeSet<u8> = errata.iter().flat_map(|line| &line.equations).copied().collect();
    let effects = &record.effects;
    let (printed, corrected) = (effects.crossover.first(), effects.crossover.last());
    type Row = (&'static str, fn(&CrossoverRow) -> String);
    let rows: [Row; 4] = [
        ("reflected, R", |row| number(row.reflection)),
        ("transmitted, T", |row| number(row.transmission)),
        ("diverted, D", |row| number(row.diversion)),
        ("energy lost or gained", |row| format!("{:.2} %", 100.0 * row.energy)),
    ];
    html! {
        section.card {
            h2 { "What did the paper get wrong?" }
            p.figure { (errata.len()) span.of { " errata in equations "
                (equations(&changed.into_iter().collect::<Vec<_>>())) } }
            @if let (Some(printed), Some(corrected)) = (printed, corrected) {
                table.small {
                    caption { "Fig. 3 at 0.25 mm" }
                    thead { tr { td {} th scope="col" { "as printed" } th scope="col" { "corrected" }
                        th scope="col" { "exact" } } }
                    tbody {
                        @for (name, of) in rows {
                            tr { th.text scope="row" { (name) } td { (of(printed)) }
                                td { (of(corrected)) } td { (of(&effects.exact)) } }
                        }
                    }
                }
            }
            p.more { a href="#wrong" { "Every departure, " (record.ledger.len()) " in all, with its measured effect" } }
        }
    }
}
