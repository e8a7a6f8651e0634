//! The cost of a run: the paper has it grow as the square of the number of elements, and has flags spare
//! half of it.

use crossfibre::discretisation::Discretisation;

use crate::cases::support::check;
use crate::cases::{Bound, Check};
use crate::convergence::power_law;
use crate::precision::orders::LEVEL;
use crate::precision::{Entry, Found, Problem, Record, Run, Variant, found, ladders, run_of};
use crate::worse::worse;

const FLAGGED: &str = "eqn (4), α = 1";
const WHOLE: &str = "eqn (4), α = 1, no flags";

/// What is counted of a run.
type Count = fn(&Found) -> u64;

pub fn checks() -> Vec<Check> {
    let problems = [Problem::Single, Problem::Crossed];
    let record = Record::computed(&ladders(&problems, &[FLAGGED, WHOLE], (1.0, 16.0)));
    let mut checks = Vec::new();
    let counts: [(&str, Count); 2] = [
        ("element-steps", |found| found.element_steps),
        ("evaluations", |found| found.evaluations),
    ];
    for problem in problems {
        for variant in [FLAGGED, WHOLE] {
            // Of one fibre with its flags evaluations are five times the element-steps.
            let counts =
                &counts[..if (problem, variant) == (Problem::Single, FLAGGED) { 1 } else { 2 }];
            for &(what, count) in counts {
                checks.push(power(&record.series(problem, variant), problem, variant, what, count));
            }
        }
    }
    checks.push(half());
    checks.push(quarter(&record));
    checks
}

/// p of count = C nᵖ.
fn power(series: &[&Entry], problem: Problem, variant: &str, what: &str, count: Count) -> Check {
    let points: Vec<_> =
        series.iter().map(|entry| (entry.elements as f64, count(&entry.found) as f64)).collect();
    let law = power_law(&points, LEVEL).ok().filter(|law| law.points >= 5);
    let interval = law.map_or_else(String::new, |law| format!(" ± {:.4}", law.half_width));
    check(
        format!("{}, {variant}: {what} grow as the square of the number of elements", problem.id()),
        "the paper: computing time in proportion with n²",
        &format!("p of C nᵖ, fitted to five meshes{interval}"),
        law.map_or(f64::NAN, |law| law.order),
        Bound::Within(1.95, 2.05),
        "2.00 ± 0.05: nodes at the ends and the first steps are terms in proportion with n",
    )
}

/// A front that just reaches the clamp has passed half of all elements of all steps.
fn half() -> Check {
    let off = |&refinement: &f64| {
        let variant = Variant::named(FLAGGED);
        let mut run: Run = run_of(Problem::Single, &variant, refinement);
        let n = run.scene.primary.elements as u64;
        let discretisation = Discretisation::<f64>::of(&run.scene);
        run.scene.duration = n as f64 * discretisation.time_step;
        off_half(&found(&run), n)
    };
    check(
        "Where the front just reaches the clamp the flags spare half: n(n + 1)/2 of n² element-steps are made",
        "1 + 2 + … + n: at α = 1 the front passes an element a step",
        "greatest difference of element-steps and of steps, one fibre of 75 to 1200 elements",
        [0.5, 1.0, 2.0, 4.0, 8.0].iter().map(off).max().unwrap_or(u64::MAX) as f64,
        Bound::Exactly(0.0),
        "a count",
    )
}

/// How many element-steps there are too many or too few in n steps that begin with one element, and how
/// many steps.
fn off_half(found: &Found, n: u64) -> u64 {
    found.element_steps.abs_diff(n * (n + 1) / 2) + found.steps.abs_diff(n)
}

/// What is visited of Fig. 3.
fn quarter(record: &Record) -> Check {
    let [flagged, whole] = [FLAGGED, WHOLE].map(|name| record.series(Problem::Crossed, name));
    let apart = flagged.iter().zip(&whole).map(|(flagged, whole)| {
        let share = flagged.found.element_steps as f64 / whole.found.element_steps as f64;
        let steps = flagged.found.steps as f64;
        ((share - 0.25) * 2.0 * steps - 1.0).abs()
    });
    check(
        "Of Fig. 3 a quarter is visited, and half an element for each step: 1/4 + 1/(2 steps)",
        "100 steps over 150 elements, from the 50th on over 100: (½·100² + ½·50²)/(100·250) of the whole",
        "greatest difference of 2 steps (share − 1/4) from 1",
        apart.fold(0.0, worse),
        Bound::AtMost(1e-13),
        "a ratio of counts, rounded",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::stored::stored;

    #[test]
    fn element_steps_and_steps_are_off_together() {
        let mut found = stored().series(Problem::Single, FLAGGED)[0].found.clone();
        (found.steps, found.element_steps) = (7, 28);
        assert_eq!(off_half(&found, 7), 0);
        (found.steps, found.element_steps) = (9, 25);
        assert_eq!(off_half(&found, 7), 5);
    }

    #[test]
    fn four_meshes_give_no_power_of_the_cost() {
        let series = stored().series(Problem::Single, WHOLE);
        let measured = |meshes: usize| {
            let count: Count = |found| found.element_steps;
            power(&series[..meshes], Problem::Single, WHOLE, "element-steps", count).measured
        };
        assert!(measured(4).is_nan());
        for meshes in [5, 6] {
            // Every element in every step, of which there are two for three elements.
            assert!((measured(meshes) - 2.0).abs() < 1e-2, "{}", measured(meshes));
        }
    }
}
