//! What the stored record of error against work must be by itself, and some of its runs again.

use crossfibre::discretisation::Discretisation;
use serde_json::Value;

use super::precision::whole_ladder;
use super::support::check;
use super::{Bound, Case, Check};
use crate::precision::stored::{differences, stored};
use crate::precision::variants::Precision;
use crate::precision::{Entry, FINEST, Problem, Record, Variant, ladders, run_of, tasks};

/// The cases of this file.
pub const CASES: &[Case] = &[Case {
    id: "record.stored",
    title: "The stored record of error against work: complete, counted rightly, converging",
    equations: &[2, 4, 5, 6, 7, 9, 10, 11, 12, 13, 15, 16, 17, 18, 20],
    run: stored_record,
}];

const PAGE: &str = "eqn (4), α = 1";
const ENGINEERING: &str = "engineering, α = 1";

fn stored_record() -> Vec<Check> {
    let (elements, evaluations) = counts();
    vec![
        check(
            "It has the runs that the study makes, and no others",
            "problems, variants and refinements of the study",
            "difference of their numbers",
            tasks(FINEST).len().abs_diff(stored().entries.len()) as f64,
            Bound::Exactly(0.0),
            "a variant that is added is not in the record before it is written anew",
        ),
        check(
            "Every run in doubles has reached the time of its steps",
            "t = steps × Δt of the scene",
            "runs of another time",
            stored().entries.iter().filter(|entry| is_late(entry)).count() as f64,
            Bound::Exactly(0.0),
            "one multiplication: no tolerance",
        ),
        check(
            "One fibre at α = 1 has visited one element more in every step",
            "1 + 2 + … + n = n(n + 1)/2: the front passes an element a step",
            "runs of another number of element-steps",
            elements as f64,
            Bound::Exactly(0.0),
            "a count",
        ),
        check(
            "and worked out (2), (6), (4), (7), and (5) where (4) needs it, once for each",
            "the list of equations of an element of one fibre whose front is not at the clamp",
            "runs of another number of evaluations",
            evaluations as f64,
            Bound::Exactly(0.0),
            "a count",
        ),
        check(
            "One fibre and Fig. 3 on meshes of 10, 4 and 2 mm, run again, come out the same",
            "docs/work-precision/record.json",
            "numbers that differ in any bit, and runs that are missing",
            again() as f64,
            Bound::Exactly(0.0),
            "deterministic; `crossfibre study work-precision --out docs/work-precision` writes it anew",
        ),
        whole_ladder(),
    ]
}

fn is_late(entry: &Entry) -> bool {
    let variant = Variant::named(&entry.variant);
    if variant.precision != Precision::Double {
        return false;
    }
    let scene = run_of(entry.problem, &variant, entry.refinement).scene;
    let time_step = Discretisation::<f64>::of(&scene).time_step;
    entry.found.time.to_bits() != (entry.found.steps as f64 * time_step).to_bits()
}

/// Runs of one fibre that have another number of element-steps than they must, and of evaluations.
fn counts() -> (usize, usize) {
    let (mut elements, mut evaluations) = (0, 0);
    for (variant, each) in [(PAGE, 5), (ENGINEERING, 4)] {
        for Entry { found, .. } in stored().series(Problem::Single, variant) {
            let visited = found.steps * (found.steps + 1) / 2;
            elements += usize::from(found.element_steps != visited);
            evaluations += usize::from(found.evaluations != each * visited);
        }
    }
    (elements, evaluations)
}

fn again() -> usize {
    let tasks = ladders(&[Problem::Single, Problem::Crossed], &[PAGE, ENGINEERING], (0.2, 1.0));
    let fresh = Record::computed(&tasks).entries;
    let apart = |fresh: &Entry| {
        let series = stored().series(fresh.problem, &fresh.variant);
        let kept = series.into_iter().find(|kept| kept.refinement == fresh.refinement);
        let value = |entry: &Entry| serde_json::to_value(entry).unwrap_or(Value::Null);
        kept.map_or(1, |kept| differences(&value(fresh), &value(kept)))
    };
    fresh.iter().map(apart).sum()
}
