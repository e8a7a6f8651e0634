//! Observed orders between two bounds.

use crate::cases::support::check;
use crate::cases::{Bound, Check};
use crate::precision::orders::{Expected, Row, TOLERANCE, fitted, rows, verdict};
use crate::precision::stored::stored;
use crate::precision::{Problem, Quantity, Record, ladders};

const PAGE: &str = "eqn (4), α = 1";
const PRINTED: &str = "eqn (4), α = 1, printed";
const ENGINEERING: &str = "engineering, α = 1";
const DISPERSED: &str = "engineering, α = 0.5";
const DIFFUSED: &str = "engineering, α = 0.5, viscous";
const DIFFUSED_PAGE: &str = "eqn (4), α = 0.5, viscous";

const REASON: &str =
    "the expected order ∓ 1/12, the distance of the nearest two that are expected anywhere";

/// Bounds of an order; none where none is expected.
fn bounds(expected: Expected) -> Option<(f64, f64)> {
    match expected {
        Expected::Order(order) => Some((order - TOLERANCE, order + TOLERANCE)),
        Expected::Between(from, to) => Some((from - TOLERANCE, to + TOLERANCE)),
        Expected::Stays => Some((-TOLERANCE, TOLERANCE)),
        Expected::Exact | Expected::Swings => None,
    }
}

pub fn checks() -> Vec<Check> {
    let variants = [PAGE, PRINTED, ENGINEERING, DISPERSED, DIFFUSED, DIFFUSED_PAGE];
    let mut tasks = ladders(&[Problem::Crossed, Problem::Rod], &variants, (1.0, 16.0));
    tasks.extend(ladders(&[Problem::Single], &variants, (1.0, 32.0)));
    // Its runs take longer.
    tasks.extend(ladders(&[Problem::Unequal], &variants[..4], (1.0, 8.0)));
    let record = Record::computed(&tasks);
    let mut checks: Vec<_> = rows().iter().filter_map(|row| order(&record, row)).collect();
    checks.push(verdicts(&record));
    checks.extend(energy(&record));
    checks
}

fn order(record: &Record, row: &Row) -> Option<Check> {
    let series = record.series(row.problem, row.variant);
    let (low, high) = bounds(row.expected)?;
    let seen = row.observed(&series)?;
    let law = seen.law?;
    let Row { problem, variant, quantity, expected, why, .. } = row;
    Some(check(
        format!(
            "{}, {variant}: the error of {} has the order {expected}",
            problem.id(),
            quantity.label()
        ),
        "exact solution; docs/convergence.md",
        &format!("order fitted to the meshes: {}; {}", fitted(seen.law), verdict(seen.verdict)),
        law.order,
        Bound::Within(low, high),
        &format!("{REASON}. {why}"),
    ))
}

/// Rows whose verdict is not the expected one.
fn verdicts(record: &Record) -> Check {
    let against = |row: &Row| {
        let seen = row.observed(&record.series(row.problem, row.variant));
        seen.is_some_and(|seen| !row.agrees(seen.verdict))
    };
    check(
        "Where one order is expected the errors are in the asymptotic range; where none is, they are not",
        "docs/convergence.md: the rule of the asymptotic range",
        "number of series with another verdict",
        rows().iter().filter(|row| against(row)).count() as f64,
        Bound::Exactly(0.0),
        "two meshes may not differ in order by more than 0.1 from all; a sign may not change",
    )
}

/// The same on the stored record, whose meshes go on to 0.03 mm.
pub fn whole_ladder() -> Check {
    check(
        "In the stored record, on meshes down to 0.03 mm and in all variants, no order is outside its bounds",
        "exact solution; docs/convergence.md",
        "number of orders outside",
        outside(stored()) as f64,
        Bound::Exactly(0.0),
        REASON,
    )
}

/// The orders of a record that are outside their bounds.
fn outside(record: &Record) -> usize {
    let is_outside = |row: &Row| {
        let seen = row.observed(&record.series(row.problem, row.variant));
        let bounds = bounds(row.expected);
        seen.and_then(|seen| seen.law)
            .zip(bounds)
            .is_some_and(|(law, (low, high))| !(low..=high).contains(&law.order))
    };
    rows().iter().filter(|row| is_outside(row)).count()
}

/// The energy's error goes with α².
fn energy(record: &Record) -> Option<Check> {
    let error = |variant| {
        let series = record.series(Problem::Single, variant);
        series.iter().find(|entry| entry.refinement == 16.0)?.error(Quantity::Energy)
    };
    let ratio = error(DISPERSED)? / error(ENGINEERING)?;
    Some(check(
        "The residual of the energy at α = 0.5 is a quarter of that at α = 1",
        "Parseval: Σ(Δv)² of a jump and its ringing is in proportion with α², whatever the width",
        "ratio of the residuals over 1/4, less 1; one fibre, engineering strain, 0.125 mm",
        (4.0 * ratio - 1.0).abs(),
        Bound::AtMost(2e-2),
        "the start of the wave, some elements that are no front yet",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The energy residual of one fibre, whose order is 1, made to fall with the square of the spacing.
    #[test]
    fn an_order_outside_its_bounds_is_counted() {
        assert_eq!(outside(stored()), 0);
        let mut record = stored().clone();
        let entries = record.entries.iter_mut();
        for entry in entries.filter(|e| e.problem == Problem::Single && e.variant == ENGINEERING) {
            let value = 1e3 * entry.spacing * entry.spacing;
            let readings = entry.found.readings.iter_mut();
            for reading in readings.filter(|reading| reading.quantity == Quantity::Energy) {
                reading.value = value;
            }
        }
        assert_eq!(outside(&record), 1);
    }
}
