//! A report for a terminal.

use std::fmt::{self, Display, Formatter};

use super::judge::allowed;
use super::protocol::Depth;
use super::quantity::Quantity;
use super::record::{ItemRecord, Report, Row, Verdict};

/// Failures that are shown one by one.
const SHOWN: usize = 12;

/// A report as text.
pub struct Text<'r>(pub &'r Report);

impl Display for Text<'_> {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        let Self(report) = self;
        let candidate = &report.candidate;
        let version = candidate.version.as_deref().unwrap_or("");
        writeln!(
            to,
            "{} {version}, held against crossfibre {}",
            candidate.name, report.crossfibre
        )?;
        if !report.quantities.is_empty() {
            table(to, &report.quantities, report.exact)?;
        }
        let failures = grouped(report);
        if !failures.is_empty() {
            writeln!(to)?;
        }
        for (failure, count) in failures.iter().take(SHOWN) {
            told(to, failure, *count)?;
        }
        if failures.len() > SHOWN {
            writeln!(to, "… and {} more", failures.len() - SHOWN)?;
        }
        let left_out = left_out(report);
        if !left_out.is_empty() {
            writeln!(to, "\nleft out: {}", left_out.join("; "))?;
        }
        let counts: Vec<_> = Verdict::ALL
            .iter()
            .map(|&verdict| (report.count(verdict), verdict.name()))
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| format!("{count} {name}"))
            .collect();
        writeln!(
            to,
            "\n{} questions, seed {}: {}",
            report.items.len(),
            report.seed,
            counts.join(", ")
        )?;
        writeln!(to, "{}", conclusion(report))
    }
}

/// Failures of one reason after the other are one, with their count.
fn grouped(report: &Report) -> Vec<(&ItemRecord, usize)> {
    let mut groups: Vec<(&ItemRecord, usize)> = Vec::new();
    for failure in report.failures() {
        match groups.last_mut() {
            Some((first, count)) if first.reason == failure.reason => *count += 1,
            _ => groups.push((failure, 1)),
        }
    }
    groups
}

fn table(to: &mut Formatter, rows: &[Row], exact: bool) -> fmt::Result {
    writeln!(
        to,
        "\n{:30} {:>8} {:>8} {:>7} {:>9} {:>5} {:>5} {:>9} {:>10}",
        "", "", "equal", "", "ULP: half", "99 %", "", "relative", "envelopes"
    )?;
    writeln!(
        to,
        "{:30} {:>8} {:>8} {:>7} {:>9} {:>5} {:>5} {:>9} {:>10}",
        "", "numbers", "bits", "", "below", "below", "most", "at most", "at most"
    )?;
    let mut depth = None;
    for row in rows {
        if depth != Some(row.depth) {
            writeln!(to, "{}", row.depth.name())?;
            depth = Some(row.depth);
        }
        line(to, row, exact)?;
    }
    writeln!(
        to,
        "an envelope is what rounding explains; beyond {} of an equation, {} of others: wrong",
        allowed(Quantity::Equation(4)),
        allowed(Quantity::Energy)
    )
}

/// The sentence that answers the question.
pub fn conclusion(report: &Report) -> String {
    let judged = [Verdict::Bits, Verdict::Rounding].map(|verdict| report.count(verdict));
    match (report.conforms, judged) {
        (true, [_, 0]) => "conforms: equal to the bit in everything that was asked".into(),
        (true, _) => "conforms: what differs is rounding".into(),
        (false, [0, 0]) if report.failures().next().is_none() => {
            "does not conform: nothing was asked that it supports".into()
        }
        (false, _) => format!("does not conform{}", nearest_to_the_cause(report)),
    }
}

/// The wrong quantities of the depth nearest to a cause.
fn nearest_to_the_cause(report: &Report) -> String {
    let mut wrong = report.quantities.iter().filter(|row| row.is_wrong(report.exact)).peekable();
    let Some(depth) = wrong.peek().map(|row| row.depth) else { return String::new() };
    let names: Vec<_> =
        wrong.filter(|row| row.depth == depth).map(|row| row.quantity.as_str()).collect();
    match depth {
        Depth::Equation => format!(": wrong in {}", names.join(", ")),
        _ => format!(": first wrong at the depth of a {}, in {}", depth.name(), names.join(", ")),
    }
}

fn line(to: &mut Formatter, row: &Row, exact: bool) -> fmt::Result {
    let [half, most_of_all, most] = row.ulps.map(ulps);
    let part = if row.same == row.values {
        "all".into()
    } else {
        // Rounded down: all but one of many is not all.
        format!("{:.1} %", (1000.0 * row.same as f64 / row.values as f64).floor() / 10.0)
    };
    let wrong = row.is_wrong(exact);
    let mark = if wrong { "WRONG" } else { "" };
    write!(
        to,
        "  {:28} {:>8} {part:>8} {mark:>7} {half:>9} {most_of_all:>5} {most:>5}",
        row.quantity, row.values
    )?;
    if row.same == row.values {
        return writeln!(to);
    }
    writeln!(to, " {:>9.1e} {:>10}", row.relative.0, envelopes(row))?;
    if wrong {
        writeln!(to, "  {:28} most at {}", "", row.worst_at)?;
    }
    Ok(())
}

fn envelopes(row: &Row) -> String {
    match row.envelopes.0 {
        x if x.is_infinite() => "infinite".into(),
        x if x < 100.0 => format!("{x:.2}"),
        x => format!("{x:.1e}"),
    }
}

/// A distance in units of the last place, short.
pub fn ulps(count: u64) -> String {
    match count {
        // What is not a number is no distance away.
        u64::MAX => "NaN".into(),
        100_000.. => format!("{:.0e}", count as f64),
        _ => count.to_string(),
    }
}

fn told(to: &mut Formatter, failure: &ItemRecord, count: usize) -> fmt::Result {
    let reason = failure.reason.as_deref().unwrap_or("");
    let more = if count > 1 { format!(" and {} more", count - 1) } else { String::new() };
    writeln!(to, "{:6} {}{more}: {reason}", failure.verdict.name(), failure.id)?;
    match failure.departs_at_step {
        Some(step) => writeln!(to, "       wrong from step {step} on"),
        None => Ok(()),
    }
}

/// Why questions were skipped or not judged, each reason with its count.
pub fn left_out(report: &Report) -> Vec<String> {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for item in &report.items {
        if matches!(item.verdict, Verdict::Skipped | Verdict::NotJudged) {
            let reason = item.reason.clone().unwrap_or_default();
            match reasons.iter_mut().find(|(known, _)| *known == reason) {
                Some((_, count)) => *count += 1,
                None => reasons.push((reason, 1)),
            }
        }
    }
    reasons.into_iter().map(|(reason, count)| format!("{count} × {reason}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conform::example::{item, of_everything, report};

    /// The lines, with one space for any number of them.
    fn lines(report: &Report) -> Vec<String> {
        let text = Text(report).to_string();
        text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
    }

    #[test]
    fn a_report_has_its_table_its_failures_and_what_was_left_out() {
        let found = lines(&of_everything());
        let (head, rest) = found.split_at(4);
        assert_eq!(head[0], "<made> up 7, held against crossfibre 0.1.0");
        assert_eq!(head[1], "");
        assert!(head[2].starts_with("equal ULP: half") && head[3].starts_with("numbers bits"));
        assert_eq!(
            rest,
            [
                "equation",
                // All but one of 2000 is not all; of equal bits there is no difference to tell.
                "eqn (7) 2000 99.9 % WRONG 0 3 1e5 2.5e-3 1.2e2",
                "most at where eqn (7) is worst",
                "eqn (8) 12 all 0 0 0",
                "step",
                "primary strain 40 25.0 % 1 99999 1e5 2.5e-3 0.50",
                "run",
                "primary tension 40 0.0 % WRONG 1 2 3 2.5e-3 1.0e2",
                "most at where primary tension is worst",
                "energy 3 0.0 % WRONG 7 NaN NaN 2.5e-3 infinite",
                "most at where energy is worst",
                "an envelope is what rounding explains; beyond 4 of an equation, 8 of others: wrong",
                "",
                "wrong equation/off and 1 more: a sign",
                "broken step/none: it ended",
                "wrong run/late: too late",
                "wrong from step 17 on",
                "",
                "left out: 2 × no eyring law; 1 × over- or underflow",
                "",
                "9 questions, seed 3: 1 bits, 1 rounding, 3 wrong, 1 broken, 2 skipped, 1 not judged",
                "does not conform: wrong in eqn (7)",
            ]
        );
    }

    #[test]
    fn a_part_of_a_report_that_has_nothing_to_say_is_not_there() {
        let equal = item("equation/equal", Depth::Equation, Verdict::Bits, None);
        let mut all_equal = report(vec![equal], vec![]);
        all_equal.conforms = true;
        assert_eq!(
            lines(&all_equal),
            [
                "<made> up 7, held against crossfibre 0.1.0",
                "",
                "1 questions, seed 3: 1 bits",
                "conforms: equal to the bit in everything that was asked",
            ]
        );
        let near = item("equation/near", Depth::Equation, Verdict::Rounding, None);
        all_equal.items.push(near);
        assert_eq!(conclusion(&all_equal), "conforms: what differs is rounding");
    }

    #[test]
    fn twelve_failures_are_shown_and_more_are_counted() {
        let failure = |k: usize| {
            let reason = format!("reason {k}");
            item(&format!("run/{k}"), Depth::Run, Verdict::Wrong, Some(&reason))
        };
        let text = |count| lines(&report((1..=count).map(failure).collect(), vec![]));
        let twelve = text(12);
        assert_eq!(twelve[2], "wrong run/1: reason 1");
        assert_eq!(
            twelve[13..],
            [
                "wrong run/12: reason 12",
                "",
                "12 questions, seed 3: 12 wrong",
                // No quantity was judged that could be named.
                "does not conform",
            ]
        );
        assert_eq!(text(14)[13..15], ["wrong run/12: reason 12", "… and 2 more"]);
    }

    #[test]
    fn who_is_wrong_is_told_where_first_and_who_was_asked_nothing_so() {
        let mut of_runs = of_everything();
        of_runs.quantities.retain(|row| row.depth == Depth::Run);
        assert_eq!(
            conclusion(&of_runs),
            "does not conform: first wrong at the depth of a run, in primary tension, energy"
        );
        let skipped = item("run/eyring", Depth::Run, Verdict::Skipped, Some("no eyring law"));
        assert_eq!(
            conclusion(&report(vec![skipped], vec![])),
            "does not conform: nothing was asked that it supports"
        );
    }

    #[test]
    fn of_a_candidate_that_has_to_be_equal_every_row_that_is_not_is_wrong() {
        let exact = Report { exact: true, ..of_everything() };
        let wrong = lines(&exact).iter().filter(|line| line.contains("WRONG")).count();
        assert_eq!(wrong, 4); // all but eqn (8)
    }
}
