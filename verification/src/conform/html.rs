//! A report as a page: one file, no network, no script.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::record::{ItemRecord, Report, Row, Verdict};
use super::text::{conclusion, left_out, ulps};
use crate::report::html::style::STYLE;

/// The text of the file.
pub fn render(report: &Report) -> String {
    let candidate = &report.candidate;
    let failures: Vec<_> = report.failures().collect();
    let tone = if report.conforms { "good" } else { "bad" };
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Conformance of " (candidate.name) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (candidate.name) " " (candidate.version.as_deref().unwrap_or("")) }
                p class=(tone) { strong { (conclusion(report)) } }
                p { "Held against crossfibre " (report.crossfibre) ", seed " (report.seed) ": "
                    code { (report.command.join(" ")) } }
                h2 { "Questions" }
                (verdicts(report))
                h2 { "Quantities" }
                p { "A rounding envelope is what the reference itself loses in this arithmetic against one "
                    "of 106 bits. Differences are from the reference, in units of the last place (ULP), "
                    "relative to the greatest number of the list, and in envelopes." }
                div.wide { (quantities(&report.quantities, report.exact)) }
                @if !failures.is_empty() {
                    h2 { "Failures" }
                    div.wide { (failed(&failures)) }
                }
                @let left_out = left_out(report);
                @if !left_out.is_empty() {
                    h2 { "Left out" }
                    ul { @for reason in &left_out { li { (reason) } } }
                }
            }
        }
    }
    .into_string()
}

fn verdicts(report: &Report) -> Markup {
    html! {
        table {
            tr { @for verdict in Verdict::ALL { th { (verdict.name()) } } }
            tr { @for verdict in Verdict::ALL { td { (report.count(verdict)) } } }
        }
    }
}

fn quantities(rows: &[Row], exact: bool) -> Markup {
    html! {
        table {
            tr {
                th { "quantity" } th.text { "depth" } th { "questions" } th { "numbers" }
                th { "equal bits" } th { "ULP, half" } th { "99 %" } th { "most" }
                th { "relative" } th { "envelopes" } th { "allowed" }
                th { "of it rounding" } th { "not rounding" } th.text { "most at" }
            }
            @for row in rows {
                @let tone = if row.is_wrong(exact) { "bad" } else { "" };
                tr class=(tone) {
                    td { (row.quantity) } td.text { (row.depth.name()) } td { (row.questions) }
                    td { (row.values) } td { (row.same) }
                    @for count in row.ulps { td { (ulps(count)) } }
                    td { (short(row.relative.0)) } td { (short(row.envelopes.0)) } td { (row.allowed) }
                    td { (short(row.rounding.0)) } td { (short(row.not_rounding.0)) }
                    td.text { (row.worst_at) }
                }
            }
        }
    }
}

fn short(x: f64) -> String {
    if x == 0.0 { "0".into() } else { format!("{x:.1e}") }
}

fn failed(failures: &[&ItemRecord]) -> Markup {
    html! {
        table {
            tr { th { "question" } th.text { "verdict" } th.text { "reason" } th { "from step" } }
            @for item in failures {
                tr {
                    td { (item.id) } td.text.bad { (item.verdict.name()) }
                    td.text.long { (item.reason.as_deref().unwrap_or("")) }
                    td { @if let Some(step) = item.departs_at_step { (step) } }
                }
            }
        }
    }
}
