//! How accurate for how much time.

use maud::{Markup, html};

use super::parts::{duration, grouped, table, text};
use crate::precision::answer::wanted::{Wanted, Work};
use crate::record::Record;
use crate::report::prose::prose;
use crate::report::words::visible;

/// What gives an accuracy: the page's own variant if it does, else the cheapest that does.
pub fn page_or_cheapest(row: &Wanted) -> Option<&Work> {
    row.page.as_ref().or(row.cheapest.as_ref())
}

/// A mesh and what it takes.
pub fn in_words(work: &Work) -> String {
    let time = work.seconds.map_or_else(String::new, |s| format!(", {}", duration(s)));
    format!("{} elements{time}", grouped(work.elements as u64))
}

fn millimetres(spacing: f64) -> String {
    let text = format!("{:.5}", 1e3 * spacing);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The table, and all that the study says.
pub fn cost(record: &Record) -> Markup {
    let columns = [
        ("wanted", true),
        ("by eqn (4), α = 1: elements", false),
        ("mm", false),
        ("evaluations", false),
        ("time", false),
        ("cheapest", true),
        ("elements", false),
        ("mm", false),
        ("evaluations", false),
        ("time", false),
    ];
    let dash = || html! { "–" };
    let cells = |work: Option<&Work>| match work {
        None => vec![html! { "not reached" }, dash(), dash(), dash()],
        Some(work) => vec![
            html! { (grouped(work.elements as u64)) },
            html! { (millimetres(work.spacing)) },
            html! { (grouped(work.evaluations)) },
            work.seconds.map_or_else(dash, |seconds| html! { (duration(seconds)) }),
        ],
    };
    let row = |row: &Wanted| {
        let mut line = vec![text(&row.what)];
        line.extend(cells(row.page.as_ref()));
        line.push(row.cheapest.as_ref().map_or_else(dash, |work| text(&work.variant)));
        line.extend(cells(row.cheapest.as_ref()));
        line
    };
    html! {
        @if record.cost.wanted.is_empty() { p { "The record does not say." } } @else {
            p { "The coarsest mesh that keeps an error, together with all finer ones. Errors are relative to exact "
                "solutions; evaluations, of numbered equations, are the same everywhere; times are of one machine: "
                (visible(&record.cost.machine)) "." }
            (table("What an accuracy takes", &columns, record.cost.wanted.iter().map(row).collect()))
        }
        details { summary { "What not to use, observed orders, and where the errors come from" }
            div.fold { (prose(&record.accuracy)) } }
    }
}
