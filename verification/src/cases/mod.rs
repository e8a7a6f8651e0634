//! The checks: each names its oracle, its norm, its tolerance and where the tolerance comes from.
//!
//! A [`Case`] runs a few scenes and returns [`Check`]s. All numbers are deterministic: the same
//! source gives the same bits, so a tolerance can be held against the error it was set for.

mod axial;
mod conformance;
mod conservation;
mod courant;
pub mod crossover;
mod golden;
mod identities;
pub mod invariance;
pub(crate) mod materials;
mod motion;
mod precision;
mod projectile;
mod record;
mod smith;
mod stability;
pub mod support;

use serde::{Deserialize, Serialize};

use crate::extremes;

/// One comparison with an oracle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// What is claimed, as a sentence.
    pub claim: String,
    /// What it is compared with.
    pub oracle: String,
    /// How the error is measured.
    pub norm: String,
    /// The error, or the quantity that the bound is on.
    pub measured: f64,
    /// What it may be.
    pub bound: Bound,
    /// Why the bound is what it is.
    pub reason: String,
}

/// What a measured number may be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// Nothing but this, to the bit.
    Exactly(f64),
    /// An error: at most this, and not under an eighth of it, or the tolerance is too loose.
    AtMost(f64),
    /// A fault that must show: at least this, and not over eight times it.
    AtLeast(f64),
    /// From the first to the second.
    Within(f64, f64),
}

/// A tolerance beyond this many times the measured error is itself a failure.
pub const HEAD_ROOM: f64 = 8.0;

/// What came of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Within its bound.
    Passed,
    /// Outside it.
    Failed,
    /// Within a bound so loose that it would not notice a change.
    Loose,
}

impl Check {
    /// Whether the measured number keeps to its bound, and the bound to the number.
    pub fn verdict(&self) -> Verdict {
        let x = self.measured;
        let (kept, loose) = match self.bound {
            Bound::Exactly(expected) => (x.to_bits() == expected.to_bits(), false),
            Bound::AtMost(most) => (x <= most, x * HEAD_ROOM < most),
            Bound::AtLeast(least) => (x >= least, x > HEAD_ROOM * least),
            Bound::Within(low, high) => (low <= x && x <= high, false),
        };
        match (kept, loose) {
            (false, _) => Verdict::Failed,
            (true, true) => Verdict::Loose,
            (true, false) => Verdict::Passed,
        }
    }
}

/// A group of checks on the same runs.
#[derive(Clone, Copy)]
pub struct Case {
    /// Its name on the command line.
    pub id: &'static str,
    /// What it is about.
    pub title: &'static str,
    /// The numbered equations that it exercises.
    pub equations: &'static [u8],
    /// Makes the runs and the comparisons.
    pub run: fn() -> Vec<Check>,
}

/// Cases that `verify --quick` leaves out, by the beginnings of their names: they take two thirds of
/// the time.
const SLOW: [&str; 2] = ["precision.", "conformance.rewrites"];

impl Case {
    /// Whether `verify --quick` runs it.
    pub fn is_quick(&self) -> bool {
        !SLOW.iter().any(|slow| self.id.starts_with(slow))
    }
}

/// Every case, in the order of the report.
pub fn all() -> Vec<Case> {
    [
        smith::CASES,
        axial::CASES,
        courant::CASES,
        stability::CASES,
        crossover::CASES,
        projectile::CASES,
        conservation::CASES,
        identities::CASES,
        invariance::CASES,
        motion::CASES,
        materials::CASES,
        conformance::CASES,
        golden::CASES,
        precision::CASES,
        record::CASES,
        &extremes::cases(),
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(measured: f64, bound: Bound) -> Verdict {
        let text = String::new;
        let (claim, oracle, norm, reason) = (text(), text(), text(), text());
        Check { claim, oracle, norm, measured, bound, reason }.verdict()
    }

    #[test]
    fn a_bound_fails_what_is_outside_it_and_is_failed_when_it_is_too_loose() {
        assert_eq!(check(0.9, Bound::AtMost(1.0)), Verdict::Passed);
        assert_eq!(check(1.1, Bound::AtMost(1.0)), Verdict::Failed);
        assert_eq!(check(0.12, Bound::AtMost(1.0)), Verdict::Loose);
        assert_eq!(check(0.9, Bound::AtLeast(1.0)), Verdict::Failed);
        assert_eq!(check(1.1, Bound::AtLeast(1.0)), Verdict::Passed);
        assert_eq!(check(8.1, Bound::AtLeast(1.0)), Verdict::Loose);
        assert_eq!(check(0.3, Bound::Within(0.2, 0.4)), Verdict::Passed);
        assert_eq!(check(0.1, Bound::Within(0.2, 0.4)), Verdict::Failed);
        assert_eq!(check(0.0, Bound::Exactly(0.0)), Verdict::Passed);
        assert_eq!(check(5e-324, Bound::Exactly(0.0)), Verdict::Failed);
        for bound in [Bound::Exactly(0.0), Bound::AtMost(1.0), Bound::AtLeast(0.0)] {
            assert_eq!(check(f64::NAN, bound), Verdict::Failed, "{bound:?}");
        }
    }

    #[test]
    fn the_quick_set_leaves_out_just_the_slow_ones() {
        for slow in SLOW {
            assert!(all().iter().any(|case| case.id.starts_with(slow)), "{slow}");
        }
        assert!(all().iter().filter(|case| case.is_quick()).count() > 50);
    }

    #[test]
    fn case_ids_are_unique() {
        let mut ids: Vec<_> = all().iter().map(|case| case.id).collect();
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count);
    }
}
