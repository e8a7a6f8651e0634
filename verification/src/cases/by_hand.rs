//! Numbers worked by hand: every numbered equation, and a whole step (docs/exact/by-hand.md).
//!
//! Directions are of Pythagorean triangles, so that roots and cosines are fractions, and the answers
//! are fractions of whole numbers. Nothing here computes them.

mod crossover;
mod fibre;
mod step;

pub use step::four_elements;

use super::support::check;
use super::{Bound, Case, Check};
use crate::planted::{self, Edition};
use crate::worse::worse;
use crossfibre::errata::Corrections;
use crossfibre::scene::Strain;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "by-hand.fibre",
        title: "The equations of a fibre and of its waves at numbers worked by hand",
        equations: &[1, 2, 3, 4, 5, 6, 7, 19, 20],
        run: fibre::equations,
    },
    Case {
        id: "by-hand.crossover",
        title: "The equations of projectile and crossover at numbers worked by hand",
        equations: &[8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18],
        run: crossover::equations,
    },
    Case {
        id: "by-hand.step",
        title: "A step of four elements worked by hand",
        equations: &[2, 4, 5, 6, 7],
        run: step::checks,
    },
];

/// The paper with all corrections.
fn corrected() -> Edition {
    planted::edition(Strain::Incremental, Corrections::ALL)
}

/// The paper as printed.
fn printed() -> Edition {
    planted::edition(Strain::Incremental, Corrections::NONE)
}

/// A number, and what it is by hand: two whole numbers, the one over the other.
type Worked = (f64, (i64, i64));

/// Of an answer with a numerator and a denominator below 2⁵³, the double next to it.
fn fraction((numerator, denominator): (i64, i64)) -> f64 {
    numerator as f64 / denominator as f64
}

/// Half a unit in the last place of 1.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// The check of one equation.
fn equation(claim: &str, worked: &[Worked]) -> Check {
    let roundings = |&(got, exact): &Worked| {
        let exact = fraction(exact);
        (got - exact).abs() / (exact.abs() * ROUNDING)
    };
    check(
        claim,
        "fractions of whole numbers, worked by hand (docs/exact/by-hand.md)",
        &format!("greatest relative error of {} numbers, in roundings of 2⁻⁵³", worked.len()),
        worked.iter().map(roundings).fold(0.0, worse),
        Bound::AtMost(8.0),
        "a rounding for each input that is no binary fraction, for each operation, and for the answer; no \
         term is many times its sum",
    )
}
