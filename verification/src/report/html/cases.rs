//! Each case: what is claimed, by which oracle, the numbers, how to run it alone, what it catches.

use maud::{Markup, html};

use super::parts::{duration, link, text};
use super::tolerances::{bar, strip};
use crate::cases::Verdict;
use crate::record::{CaseRecord, CheckRecord, Record};
use crate::report::words::{
    advice, anchor, argument, bound, count, equations, head_room, line, number, visible,
};

/// The name of a case's place.
pub fn place(case: &str) -> String {
    format!("case-{}", anchor(case))
}

/// The cases with checks that did not pass, open and before everything else.
pub fn troubled(record: &Record) -> Markup {
    let troubled: Vec<&CaseRecord> =
        record.cases.iter().filter(|case| case.troubles().next().is_some()).collect();
    html! {
        @if !troubled.is_empty() {
            section.troubled id="troubled" aria-labelledby="troubled-title" {
                h2 id="troubled-title" { "What did not pass" }
                @for case in troubled { (one(record, case, true)) }
            }
        }
    }
}

/// All cases; those that did not pass are above.
pub fn all(record: &Record) -> Markup {
    html! {
        p { "A case runs a few scenes and compares. " strong { "Bound" } ": what the measured number may be; "
            strong { "head-room" } ": the factor between them. The bar shows how much of a tolerance is used." }
        @for case in &record.cases {
            @if case.troubles().next().is_none() { (one(record, case, false)) }
            @else { p.elsewhere { a href={ "#" (place(&case.id)) } { (visible(&case.id)) } " did not pass: see above." } }
        }
    }
}

fn one(record: &Record, case: &CaseRecord, is_open: bool) -> Markup {
    let passed = case.checks.len() - case.troubles().count();
    let tone = if passed == case.checks.len() { "good" } else { "bad" };
    html! {
        details.case open[is_open] id=(place(&case.id)) {
            summary {
                span.name { (line(&case.id)) } " "
                span.title { (line(&case.title)) } " "
                strong class={ "tag " (tone) } { (passed) " of " (case.checks.len()) }
            }
            div.fold {
                (facts(record, case))
                (catches(record, case))
                ol.checks {
                    @for check in case.troubles() { (one_check(case, check)) }
                    @for check in case.checks.iter().filter(|check| check.verdict == Verdict::Passed) {
                        (one_check(case, check))
                    }
                }
            }
        }
    }
}

fn facts(record: &Record, case: &CaseRecord) -> Markup {
    let shown = record.pictures.iter().filter(|picture| case.pictures.contains(&picture.id));
    let again = format!("crossfibre verify --filter {}", argument(&case.id));
    let quick = if case.quick { "part of" } else { "not part of" };
    html! {
        dl.pairs {
            dt { "equations" }
            dd { @if case.equations.is_empty() { "none of the scheme" } @else { (equations(&case.equations)) } }
            dt { "derivation" }
            dd { @for page in &case.derivation { (link(&page.title, &page.path)) br; } }
            dt { "run it alone" }
            dd { code { (again) } ", " (duration(case.seconds)) ", " (quick) " " code { "verify --quick" } }
            @if !case.pictures.is_empty() {
                dt { "pictures" }
                dd { @for picture in shown {
                    (link(&picture.title, &format!("#picture-{}", anchor(&picture.id)))) br;
                } }
            }
            dt { "head-room" } dd { (strip(case)) }
        }
    }
}

/// The faults that a case is known to notice.
fn catches(record: &Record, case: &CaseRecord) -> Markup {
    let Some(matrix) = &record.sensitivity else { return html! {} };
    if !matrix.checks.iter().any(|column| column.case == case.id) {
        return html! { p.faults { "The planted faults were not tried on this case." } };
    }
    let faults: Vec<_> = matrix.noticed_by_case(&case.id).collect();
    html! {
        details.faults {
            summary { "Catches " (count(faults.len(), "planted fault")) " of " (matrix.faults.len()) }
            ul {
                @for fault in faults {
                    li { code { (visible(&fault.id)) } span { " " (visible(&fault.what)) } }
                }
            }
        }
    }
}

fn one_check(case: &CaseRecord, record: &CheckRecord) -> Markup {
    let check = &record.check;
    let (tone, mark) = match record.verdict {
        Verdict::Passed => ("good", "✓"),
        Verdict::Failed => ("bad", "✗"),
        Verdict::Loose | Verdict::Redundant => ("warn", "!"),
    };
    html! {
        li {
            p.claim {
                span class={ "mark " (tone) } aria-hidden="true" { (mark) } " " (text(&check.claim))
                @if record.verdict == Verdict::Passed { span.hidden { " Passed." } }
                @else { " " strong class={ "tag " (tone) } { (record.verdict.words()) } }
            }
            p.numbers {
                strong { (number(check.measured)) } " – " (bound(check.bound)) " " (bar(check))
                @if record.verdict != Verdict::Failed && check.head_room().is_some() {
                    " head-room " (head_room(check))
                }
            }
            dl.pairs {
                dt { "oracle" } dd { (text(&check.oracle)) }
                dt { "norm" } dd { (text(&check.norm)) }
                dt { "why so" } dd { (text(&check.reason)) }
                @if record.verdict != Verdict::Passed {
                    dt { "measured" } dd { (format!("{:e}", check.measured)) }
                    dt { "what to do" } dd { (advice(record.verdict)) ": "
                        code { "crossfibre verify --filter " (argument(&case.id)) } }
                }
            }
        }
    }
}
