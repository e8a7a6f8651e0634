//! The stored record, run again.

use serde_json::Value;

use crate::cases::support::check;
use crate::cases::{Bound, Check};
use crate::precision::stored::{differences, stored};
use crate::precision::{FINEST, Problem, QUICK, Record, Task, tasks, variants::Precision};

/// What is run again. Runs in 106 bits take fifty times as long, and the exact solutions of the unequal
/// fibres and of the rod take longer than the runs.
fn again(task: &Task) -> bool {
    let is_long = task.variant.precision == Precision::DoubleDouble
        || matches!(task.problem, Problem::Unequal | Problem::Rod);
    !is_long || task.refinement <= 1.0
}

pub fn checks() -> Vec<Check> {
    let tasks: Vec<_> = tasks(QUICK).into_iter().filter(again).collect();
    vec![check(
        "Runs of the stored record come out the same: one fibre and Fig. 3 down to 0.25 mm, the unequal fibres, \
             the rod, and all in 106 bits down to 2 mm",
        "docs/work-precision/record.json",
        "numbers that differ in any bit, and runs that are missing",
        departures(&tasks),
        Bound::Exactly(0.0),
        "deterministic; `crossfibre study work-precision --out docs/work-precision` writes it anew",
    )]
}

/// Every run of it, which takes minutes.
pub fn whole() -> Vec<Check> {
    vec![check(
        "Every run of the stored record comes out the same",
        "docs/work-precision/record.json",
        "numbers that differ in any bit, and runs that are missing",
        departures(&tasks(FINEST)),
        Bound::Exactly(0.0),
        "deterministic; `crossfibre study work-precision --out docs/work-precision` writes it anew",
    )]
}

/// How many numbers of the stored record are not those of these runs, and how many runs it lacks.
fn departures(tasks: &[Task]) -> f64 {
    apart(&Record::computed(tasks), stored()) as f64
}

/// How many numbers of an old record are not those of the runs of a fresh one, and how many of these runs it
/// lacks.
fn apart(fresh: &Record, old: &Record) -> usize {
    let kept: Vec<_> = fresh
        .entries
        .iter()
        .filter_map(|fresh| {
            let old = old.series(fresh.problem, &fresh.variant);
            old.into_iter().find(|old| old.refinement == fresh.refinement)
        })
        .collect();
    let value = |entry| serde_json::to_value(entry).unwrap_or(Value::Null);
    let apart: usize = fresh
        .entries
        .iter()
        .zip(&kept)
        .map(|(fresh, kept)| differences(&value(fresh), &value(*kept)))
        .sum();
    apart + fresh.entries.len() - kept.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::{VARIANTS, Variant};

    const PAGE: &str = "eqn (4), α = 1";
    const LONG: &str = "eqn (4), α = 1, 106 bits";

    #[test]
    fn what_takes_long_is_run_again_on_coarse_meshes_only() {
        let is_run = |problem, variant, refinement| {
            again(&Task { problem, variant: Variant::named(variant), refinement })
        };
        assert!(is_run(Problem::Single, PAGE, 8.0) && is_run(Problem::Crossed, PAGE, 2.0));
        for (problem, variant) in
            [(Problem::Single, LONG), (Problem::Rod, PAGE), (Problem::Unequal, PAGE)]
        {
            assert!(is_run(problem, variant, 0.5) && is_run(problem, variant, 1.0));
            assert!(!is_run(problem, variant, 2.0), "{problem:?} {variant}");
        }
    }

    #[test]
    fn numbers_that_differ_and_runs_that_are_missing_are_counted() {
        let old = stored();
        let mut fresh = Record { entries: old.entries[..4].to_vec(), ..old.clone() };
        assert_eq!(apart(&fresh, old), 0);
        fresh.entries[1].found.steps += 1;
        fresh.entries[2].found.time *= 2.0;
        assert_eq!(apart(&fresh, old), 2);
        fresh.entries[3].refinement = 0.3;
        assert_eq!(apart(&fresh, old), 3);
    }

    #[test]
    fn a_run_that_the_stored_record_lacks_is_a_departure() {
        let variant = Variant::named(PAGE);
        let known = Task { problem: Problem::Single, variant, refinement: 0.2 };
        let unknown = Task { variant: Variant { name: "another", ..VARIANTS[0] }, ..known };
        assert_eq!(departures(&[known]), 0.0);
        assert_eq!(departures(&[known, unknown]), 1.0);
    }
}
