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
    let fresh = Record::computed(tasks);
    let kept: Vec<_> = fresh
        .entries
        .iter()
        .filter_map(|fresh| {
            let old = stored().series(fresh.problem, &fresh.variant);
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
    (apart + fresh.entries.len() - kept.len()) as f64
}
