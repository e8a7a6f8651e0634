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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conform::example::{of_everything, report};

    #[test]
    fn a_page_has_the_verdicts_the_quantities_and_the_failures() {
        let page = render(&of_everything());
        for part in [
            "<h1>&lt;made&gt; up 7</h1>",
            "<p class=\"bad\"><strong>does not conform: wrong in eqn (7)</strong></p>",
            "seed 3: <code>./made-up --fast</code>",
            "<tr><th>bits</th><th>rounding</th><th>wrong</th><th>broken</th><th>skipped</th>\
             <th>not judged</th></tr>",
            "<tr><td>1</td><td>1</td><td>3</td><td>1</td><td>2</td><td>1</td></tr>",
            "<tr class=\"bad\"><td>eqn (7)</td><td class=\"text\">equation</td><td>3</td>\
             <td>2000</td><td>1999</td><td>0</td><td>3</td><td>1e5</td><td>2.5e-3</td>\
             <td>1.2e2</td><td>4</td><td>3.0e-4</td><td>0</td>\
             <td class=\"text\">where eqn (7) is worst</td></tr>",
            "<tr class=\"\"><td>eqn (8)</td>",
            "<tr class=\"\"><td>primary strain</td>",
            "<tr class=\"bad\"><td>energy</td>",
            "<tr><td>run/late</td><td class=\"text bad\">wrong</td>\
             <td class=\"text long\">too late</td><td>17</td></tr>",
            "<li>2 × no eyring law</li><li>1 × over- or underflow</li>",
        ] {
            assert!(page.contains(part), "{part}\nis not in\n{page}");
        }
    }

    #[test]
    fn a_page_without_failures_has_no_heading_for_them() {
        let page = render(&Report { conforms: true, ..report(vec![], vec![]) });
        assert!(page.contains("<p class=\"good\">"), "{page}");
        assert!(!page.contains("Failures") && !page.contains("Left out"), "{page}");
    }
}
