//! The tolerances: how much of each is used, as bars, as a strip for a case, and as a table.

use std::cmp::Ordering;

use maud::{Markup, html};

use super::cases::place;
use super::parts::{table, text};
use crate::cases::{Bound, Check, HEAD_ROOM, Verdict};
use crate::record::{CaseRecord, CheckRecord, Record};
use crate::report::words::{bound, head_room, number, visible};

/// How much of a bound is used, from 0 to 1; none for what must be exact or is no number.
fn used(check: &Check) -> Option<f64> {
    let share = match check.bound {
        Bound::Exactly(_) => return None,
        Bound::AtMost(most) => check.measured / most,
        Bound::AtLeast(least) => least / check.measured,
        Bound::Within(low, high) => (check.measured - low) / (high - low),
    };
    share.is_finite().then(|| share.clamp(0.0, 1.0))
}

/// A bar as long as what is used of a tolerance; for a window, a mark where the number is.
pub fn bar(check: &Check) -> Markup {
    let kind = match (check.verdict(), check.bound) {
        (Verdict::Failed, _) => "bar broken",
        (_, Bound::Within(..)) => "bar window",
        _ => "bar",
    };
    html! {
        @if let Some(used) = used(check) {
            span class=(kind) aria-hidden="true" { span style={ "width:" (format!("{:.1}", 100.0 * used)) "%" } {} }
        }
    }
}

/// Ends of the strip in pixels, and its height.
const STRIP: (f64, f64, f64) = (8.0, 232.0, 26.0);

/// Where a head-room stands on a strip: 1 at the left end, the most that is allowed at the right, by its
/// logarithm.
fn along(factor: f64) -> f64 {
    let (left, right, _) = STRIP;
    let share = pxfm::f_log(factor) / pxfm::f_log(HEAD_ROOM);
    left + (right - left) * share.clamp(0.0, 1.0)
}

/// The head-rooms of a case on a line from 1 to 8.
pub fn strip(case: &CaseRecord) -> Markup {
    let factors: Vec<(f64, Verdict)> = case
        .checks
        .iter()
        .filter_map(|record| Some((record.check.head_room()?, record.verdict)))
        .collect();
    let (left, right, height) = STRIP;
    let (least, most) =
        factors.iter().fold((f64::INFINITY, 0.0_f64), |(least, most), (factor, _)| {
            (least.min(*factor), most.max(*factor))
        });
    let label = format!("Head-room of {} checks, from {least:.1} to {most:.1}", factors.len());
    html! {
        @if factors.is_empty() { "no bound of this case is a factor" } @else {
            svg.strip role="img" aria-label=(label) viewBox="0 0 240 44" width="240" height="44" {
                @for tick in [1, 2, 4, 8] {
                    @let x = format!("{:.1}", along(f64::from(tick)));
                    line.grid x1=(x) x2=(x) y1="2" y2=(height) {}
                    text x=(x) y="40" text-anchor="middle" { (tick) }
                }
                line.axis x1=(left) x2=(right) y1=(height / 2.0) y2=(height / 2.0) {}
                @for (factor, verdict) in &factors {
                    @let tone = if *verdict == Verdict::Passed { "dot" } else { "dot bad" };
                    circle class=(tone) cx=(format!("{:.1}", along(*factor))) cy=(height / 2.0) r="4.5" {}
                }
            }
        }
    }
}

/// By head-room, the least first; what has none comes last, in its order.
fn by_head_room(a: &CheckRecord, b: &CheckRecord) -> Ordering {
    let of = |record: &CheckRecord| record.check.head_room().unwrap_or(f64::INFINITY);
    of(a).total_cmp(&of(b))
}

/// All of them.
pub fn tolerances(record: &Record) -> Markup {
    let mut all: Vec<(&CaseRecord, &CheckRecord)> = record
        .cases
        .iter()
        .flat_map(|case| case.checks.iter().map(move |check| (case, check)))
        .collect();
    all.sort_by(|(_, a), (_, b)| by_head_room(a, b));
    let columns = [
        ("case", true),
        ("measured", false),
        ("bound", true),
        ("used", true),
        ("head-room", false),
        ("claim", true),
        ("reason of the bound", true),
    ];
    let (judged, rest): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|(_, record)| record.check.head_room().is_some());
    let row = |(case, record): &(&CaseRecord, &CheckRecord)| {
        let check = &record.check;
        vec![
            html! { a href={ "#" (place(&case.id)) } { (visible(&case.id)) } },
            html! { (number(check.measured)) },
            html! { (bound(check.bound)) },
            bar(check),
            html! { (head_room(check)) },
            text(&check.claim),
            text(&check.reason),
        ]
    };
    html! {
        p { "All numbers are deterministic, so a tolerance is held to the error that it was set for: over "
            (HEAD_ROOM) " times of it is too loose, and fails; so does a fault that shows more than " (HEAD_ROOM)
            " times as much as it must, a window that would hold what it should tell apart, and a check that says "
            "what another of its case says. The tightest come first: they are the first to notice a change." }
        (spread(&judged))
        details { summary { (judged.len()) " tolerances, by head-room" }
            (table("Worst measured error, bound and head-room", &columns, judged.iter().map(row).collect())) }
        details { summary { (rest.len()) " windows, exact numbers, and errors of zero" }
            (table("Bounds that are no factor", &columns, rest.iter().map(row).collect())) }
    }
}

/// Head-rooms in classes, as a picture that says how tight the whole is.
fn spread(judged: &[(&CaseRecord, &CheckRecord)]) -> Markup {
    const CLASSES: [(f64, f64); 6] =
        [(1.0, 1.5), (1.5, 2.0), (2.0, 3.0), (3.0, 4.0), (4.0, 6.0), (6.0, HEAD_ROOM)];
    let factors: Vec<f64> = judged.iter().filter_map(|(_, r)| r.check.head_room()).collect();
    let number = |(low, high): (f64, f64)| {
        factors
            .iter()
            .filter(|f| low <= **f && (**f < high || high >= HEAD_ROOM && **f <= high))
            .count()
    };
    let counts = CLASSES.map(|class| (class, number(class)));
    let most = counts.iter().map(|(_, n)| *n).max().unwrap_or(0).max(1);
    html! {
        table.histogram {
            caption { "How many tolerances have which head-room" }
            thead { tr { th scope="col" { "head-room" } th scope="col" { "checks" } td {} } }
            tbody {
                @for ((low, high), n) in counts {
                    tr {
                        th scope="row" { (low) " to " (high) }
                        td { (n) }
                        td.text { span.bar.long aria-hidden="true" {
                            span style={ "width:" (100 * n / most) "%" } {} } }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;

    #[test]
    fn a_bar_is_as_long_as_what_is_used() {
        let check = |measured, bound| Check {
            claim: String::new(),
            oracle: String::new(),
            norm: String::new(),
            measured,
            bound,
            reason: String::new(),
        };
        assert_eq!(used(&check(0.25, Bound::AtMost(1.0))), Some(0.25));
        assert_eq!(used(&check(4.0, Bound::AtLeast(1.0))), Some(0.25));
        assert_eq!(used(&check(0.75, Bound::Within(0.5, 1.5))), Some(0.25));
        assert_eq!(used(&check(7.0, Bound::AtMost(1.0))), Some(1.0));
        assert_eq!(used(&check(f64::NAN, Bound::AtMost(1.0))), None);
        assert_eq!(used(&check(0.0, Bound::Exactly(0.0))), None);
    }

    /// Head-rooms of 1, 1.5, 8 and 9: at the ends of classes each is in the upper one, but for the last, and what
    /// is too loose is in none.
    #[test]
    fn a_head_room_is_counted_in_one_class() {
        let mut record = made_up::passing();
        let checks = [(1.0, 1.0), (0.5, 0.75), (0.125, 1.0), (1.0, 9.0)];
        let model = record.cases[0].checks[0].clone();
        record.cases[0].checks = checks
            .iter()
            .map(|&(measured, most)| {
                let bound = Bound::AtMost(most);
                CheckRecord { check: Check { measured, bound, ..model.check.clone() }, ..model }
            })
            .collect();
        let case = &record.cases[0];
        let judged: Vec<_> = case.checks.iter().map(|check| (case, check)).collect();
        let page = spread(&judged).into_string();
        let counts: Vec<&str> =
            page.split("<td>").skip(2).filter_map(|cell| cell.split('<').next()).collect();
        assert_eq!(counts, ["1", "1", "0", "0", "0", "1"]);
    }

    #[test]
    fn the_tightest_tolerance_comes_first() {
        let record = made_up::passing();
        let page = tolerances(&record).into_string();
        // 2.8 for a fault that shows, 3.7 for an error.
        let (fault, error) = (page.find(">2.8<").unwrap(), page.find(">3.7<").unwrap());
        assert!(fault < error);
        assert!((along(8.0) - STRIP.1).abs() < 1e-9 && (along(1.0) - STRIP.0).abs() < 1e-9);
    }
}
