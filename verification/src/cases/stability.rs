//! The largest stable Courant number: by hand, by the spectral radius of the linearised step, measured.

use super::support::{check, relative};
use super::{Bound, Case, Check};
use crate::stability::rows::{EDITIONS, Group, Row, rows};
use crate::stability::spectrum::{THRESHOLD, spectral_radius};
use crate::stability::tasks::{measured, predicted};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "stability.uniform",
        title: "The stable Courant number of a uniform fibre, unstrained and strained",
        equations: &[2, 4, 6, 7, 20],
        run: || {
            let rows = ["uniform-4-0", "uniform-4-1.45", "uniform-4-50", "uniform-engineering-50"];
            three_ways(&rows, 2e-7, WITHOUT_DAMPING)
        },
    },
    Case {
        id: "stability.laws",
        title: "The stable Courant number with other laws, arms and artificial viscosity",
        equations: &[2, 4, 6, 7, 20],
        run: || {
            let rows = [
                "law-stiffening-polynomial-4-1.45",
                "law-exponential-engineering-5",
                "law-7-viscosity-0.1-4-1.45",
                "law-Maxwell-literal-E-0.4-t-0.7-engineering-1.45",
                "law-Maxwell-exact-E-0.4-t-0.1-engineering-1.45",
                "law-Eyring-literal-E-0-t-0.1-engineering-0",
            ];
            three_ways(&rows, 4e-7, Bound::AtMost(6e-4))
        },
    },
    Case {
        id: "stability.projectile",
        title: "A light projectile: the stable Courant number of its node",
        equations: &[2, 6, 7, 8, 20],
        run: || {
            let rows = [
                "projectile-along-0.3-without",
                "projectile-along-0.01-without",
                "projectile-across-0.0001-without",
            ];
            three_ways(&rows, 4e-7, WITHOUT_DAMPING)
        },
    },
    Case {
        id: "stability.crossover",
        title: "A tilted crossover: the stable Courant number of its node",
        equations: &[2, 4, 6, 7, 9, 10, 11, 12, 13, 15, 16, 17, 18, 20],
        run: crossover,
    },
];

/// Growth beyond the limit rises as a root there, and both searches end at 1e-7 of a common grid: they
/// may end at the same number.
const WITHOUT_DAMPING: Bound = Bound::Within(0.0, 4e-7);

/// The row of an id.
fn row(id: &str) -> Row {
    rows().into_iter().find(|row| row.id == id).unwrap_or_else(|| panic!("no row is called {id}"))
}

/// A limit; infinite if there is none.
fn limit(found: Option<f64>) -> f64 {
    found.unwrap_or(f64::INFINITY)
}

/// The worst of some rows: spectral radius against the formula, measured against spectral radius.
fn three_ways(ids: &[&str], by_hand: f64, by_marching: Bound) -> Vec<Check> {
    let found: Vec<_> = ids
        .iter()
        .map(|id| row(id))
        .map(|row| (row.by_hand, limit(predicted(&row.base)), limit(measured(&row.base))))
        .collect();
    let worst = |apart: fn(&(f64, f64, f64)) -> f64| found.iter().map(apart).fold(0.0, worse);
    vec![
        check(
            format!("The linearised step lets go where the formula says: {}", ids.join(", ")),
            "docs/exact/stability.md",
            "greatest relative difference of the limits, bisected",
            worst(|(hand, predicted, _)| relative(*predicted, *hand)),
            Bound::AtMost(by_hand),
            "the search ends at 1e-7; a formula for fibres without end is that of the mesh to the square \
             of what is left of the motion at its far end",
        ),
        check(
            "The march lets go where the linearised step does",
            "spectral radius of the derivative of the step, by dual numbers",
            "greatest relative difference of the limits, bisected",
            worst(|(_, predicted, measured)| relative(*measured, *predicted)),
            by_marching,
            "growth of less than 2e-4 a step is not seen; beyond the limit it rises as a root without \
             damping, in proportion with it",
        ),
    ]
}

/// The crossovers of two equal fibres with all corrections.
fn corrected_crossovers() -> impl Iterator<Item = Row> {
    let corrected = EDITIONS[2].0;
    rows().into_iter().filter(move |row| {
        row.group == Group::Crossover && row.cells.iter().any(|cell| cell == corrected)
    })
}

fn crossover() -> Vec<Check> {
    let mut checks =
        three_ways(&["crossover-engineering-0.6-1-without-inertia"], 1e-6, Bound::AtMost(2e-6));
    let unstable = corrected_crossovers()
        .flat_map(|row| [0.3, 0.9, 1.0].map(|courant| spectral_radius(&row.base, courant)))
        .filter(|radius| *radius > 1.0 + THRESHOLD)
        .count();
    checks.push(check(
        "With all corrections the crossover is stable at α = 0.3, 0.9 and 1, straight and tilted, at every \
         slide factor, by either strain",
        "spectral radius of the derivative of the step, by dual numbers",
        "number of states with a radius beyond 1 + 1e-6",
        unstable as f64,
        Bound::Exactly(0.0),
        "none may grow",
    ));
    checks
}

#[cfg(test)]
mod tests {
    use crossfibre::errata::Corrections;

    use super::*;

    /// By two measures of strain, straight and tilted, at five slide factors.
    #[test]
    fn the_corrected_crossovers_are_twenty_and_all_are_corrected() {
        let all: Vec<_> = corrected_crossovers().collect();
        assert_eq!(all.len(), 2 * 2 * 5);
        for row in all {
            assert_eq!(row.group, Group::Crossover, "{}", row.id);
            assert_eq!(row.base.scene.corrections, Corrections::ALL, "{}", row.id);
        }
    }
}
