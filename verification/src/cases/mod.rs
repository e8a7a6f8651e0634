//! The checks: each names its oracle, its norm, its tolerance and where the tolerance comes from.
//!
//! A [`Case`] runs a few scenes and returns [`Check`]s. All numbers are deterministic: the same
//! source gives the same bits, so a tolerance can be held against the error it was set for.

mod axial;
mod by_hand;
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

pub use by_hand::four_elements;
pub use conformance::over_envelopes;
pub use invariance::in_other_frames;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::conform::real::{self, Real};
use crate::extremes;

/// One comparison with an oracle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Check {
    /// What is claimed, as a sentence.
    pub claim: String,
    /// What it is compared with.
    pub oracle: String,
    /// How the error is measured.
    pub norm: String,
    /// The error, or the quantity that the bound is on.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub measured: f64,
    /// What it may be.
    pub bound: Bound,
    /// Why the bound is what it is.
    pub reason: String,
}

/// What a measured number may be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// Nothing but this, to the bit.
    Exactly(f64),
    /// An error: at most this, and not under an eighth of it, or the tolerance is too loose.
    AtMost(f64),
    /// A fault that must show: at least this, and not over eight times it.
    AtLeast(f64),
    /// From the first to the second. A window of one sign spans at most a factor of eight. One that holds
    /// zero is at most 1 wide: it is of orders and shares, where 1 is the step to the next. One from zero
    /// on is of an error that may be none at all, as where two searches end on one grid; if it is
    /// something, the end is not over eight times it.
    Within(f64, f64),
}

/// A tolerance beyond this many times the measured error is itself a failure.
pub const HEAD_ROOM: f64 = 8.0;

/// A window that holds zero is at most so wide.
const WIDEST: f64 = 1.0;

/// What came of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Within its bound.
    Passed,
    /// Outside it.
    Failed,
    /// Within a bound so loose that it would not notice a change.
    Loose,
    /// Within its bound, and said before: another check of the case has the same claim, or the same
    /// number and bound.
    Redundant,
}

impl Verdict {
    /// What is the matter, in a few words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "out of bounds",
            Self::Loose => "bound too loose",
            Self::Redundant => "says what another check of the case says",
        }
    }
}

impl Check {
    /// Whether the measured number keeps to its bound, and the bound to the number.
    pub fn verdict(&self) -> Verdict {
        let x = self.measured;
        let (kept, loose) = match self.bound {
            Bound::Exactly(expected) => (x.to_bits() == expected.to_bits(), false),
            Bound::AtMost(most) => (x <= most, x * HEAD_ROOM < most),
            Bound::AtLeast(least) => (x >= least, x > HEAD_ROOM * least),
            Bound::Within(low, high) => {
                let is_far = low == 0.0 && x != 0.0 && x * HEAD_ROOM < high;
                (low <= x && x <= high, is_wide(low, high) || is_far)
            }
        };
        match (kept, loose) {
            (false, _) => Verdict::Failed,
            (true, true) => Verdict::Loose,
            (true, false) => Verdict::Passed,
        }
    }

    /// The factor between the measured number and the bound; none where nothing was measured, and for
    /// bounds that are no such factor.
    pub fn head_room(&self) -> Option<f64> {
        let factor = match self.bound {
            Bound::Within(low, _) if low != 0.0 => return None,
            Bound::AtMost(most) | Bound::Within(_, most) if self.measured != 0.0 => {
                most / self.measured
            }
            Bound::AtLeast(least) => self.measured / least,
            _ => return None,
        };
        factor.is_finite().then_some(factor)
    }

    /// Whether another check of the same case says the same. That two numbers are both what they must be
    /// to the bit is no repetition.
    fn repeats(&self, other: &Self) -> bool {
        let exactly = matches!(self.bound, Bound::Exactly(_));
        let same = self.measured.to_bits() == other.measured.to_bits() && self.bound == other.bound;
        self.claim == other.claim || (same && !exactly)
    }
}

/// Whether a window would hold what it should tell apart.
fn is_wide(low: f64, high: f64) -> bool {
    if low <= 0.0 && high >= 0.0 {
        high - low > WIDEST * (1.0 + f64::EPSILON)
    } else {
        (high / low).max(low / high) > HEAD_ROOM
    }
}

/// The verdicts on the checks of a case, in their order.
pub fn verdicts(checks: &[Check]) -> Vec<Verdict> {
    let verdict = |(k, check): (usize, &Check)| match check.verdict() {
        Verdict::Passed if checks[..k].iter().any(|before| check.repeats(before)) => {
            Verdict::Redundant
        }
        verdict => verdict,
    };
    checks.iter().enumerate().map(verdict).collect()
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
        by_hand::CASES,
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

/// Every case, and what takes minutes.
pub fn full() -> Vec<Case> {
    [all(), vec![precision::WHOLE_RECORD]].concat()
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
    fn at_its_ends_a_bound_passes() {
        for (measured, bound) in [
            (1.0, Bound::AtMost(1.0)),
            (0.125, Bound::AtMost(1.0)),
            (1.0, Bound::AtLeast(1.0)),
            (8.0, Bound::AtLeast(1.0)),
            (9.0, Bound::AtLeast(2.0)),
            (1.0, Bound::Within(0.5, 1.0)),
            (0.5, Bound::Within(0.125, 1.0)),
            (0.0625, Bound::Within(0.0, 0.5)),
            (0.0, Bound::Within(0.0, 1.0 + f64::EPSILON)),
            (-2.0, Bound::Within(-3.0, -1.5)),
        ] {
            assert_eq!(check(measured, bound), Verdict::Passed, "{measured} {bound:?}");
        }
        assert_eq!(check(-1.0, Bound::Within(-2.0, 0.0)), Verdict::Loose);
    }

    #[test]
    fn a_window_must_tell_something_apart() {
        let window = |low, high, x| check(x, Bound::Within(low, high));
        // A factor of 7.5, and of 8.2.
        assert_eq!(window(0.02, 0.15, 0.053), Verdict::Passed);
        assert_eq!(window(0.02, 0.164, 0.053), Verdict::Loose);
        assert_eq!(window(-3.5, -0.43, -2.9), Verdict::Loose);
        // Widths of 1 and 1.03.
        assert_eq!(window(-0.2, 0.8, 0.072), Verdict::Passed);
        assert_eq!(window(-0.2, 0.83, 0.072), Verdict::Loose);
        assert_eq!(window(0.0, 1.03, 0.0), Verdict::Loose);
        assert_eq!(window(-0.2, 0.83, 0.91), Verdict::Failed);
        // From zero on: factors of 7.9 and 8.1, and nothing to hold the end to.
        assert_eq!(window(0.0, 3.16e-7, 4e-8), Verdict::Passed);
        assert_eq!(window(0.0, 3.24e-7, 4e-8), Verdict::Loose);
        assert_eq!(window(0.0, 3.24e-7, 0.0), Verdict::Passed);
        assert_eq!(window(0.0, 3.24e-7, -4e-8), Verdict::Failed);
    }

    #[test]
    fn a_check_that_says_what_another_says_is_redundant() {
        let check = |claim: &str, measured, bound| Check {
            claim: claim.into(),
            oracle: String::new(),
            norm: String::new(),
            measured,
            bound,
            reason: String::new(),
        };
        let verdicts = verdicts(&[
            check("one", 0.37, Bound::AtMost(0.9)),
            check("two", 0.37, Bound::AtMost(0.8)),
            check("three", 0.37, Bound::AtMost(0.9)),
            check("two", 0.41, Bound::AtMost(0.7)),
            check("two", 0.71, Bound::AtMost(0.7)),
            check("four", 0.0, Bound::Exactly(0.0)),
            check("five", 0.0, Bound::Exactly(0.0)),
            check("six", 0.5, Bound::AtMost(0.9)),
        ]);
        use Verdict::{Failed, Passed, Redundant};
        assert_eq!(
            verdicts,
            [Passed, Passed, Redundant, Redundant, Failed, Passed, Passed, Passed]
        );
    }

    #[test]
    fn head_room_is_the_factor_to_the_bound() {
        let of = |measured, bound| {
            let text = String::new;
            let (claim, oracle, norm, reason) = (text(), text(), text(), text());
            Check { claim, oracle, norm, measured, bound, reason }.head_room()
        };
        assert_eq!(of(0.125, Bound::AtMost(0.5)), Some(4.0));
        assert_eq!(of(0.75, Bound::AtLeast(0.25)), Some(3.0));
        assert_eq!(of(0.125, Bound::Within(0.0, 0.75)), Some(6.0));
        assert_eq!(of(0.125, Bound::Within(-0.5, 0.75)), None);
        for bound in [Bound::AtMost(0.5), Bound::Exactly(0.0), Bound::Within(0.0, 0.7)] {
            assert_eq!(of(0.0, bound), None, "{bound:?}");
        }
        assert_eq!(of(f64::NAN, Bound::AtMost(0.5)), None);
    }

    #[test]
    fn the_quick_set_leaves_out_just_the_slow_ones() {
        for slow in SLOW {
            assert!(all().iter().any(|case| case.id.starts_with(slow)), "{slow}");
        }
        assert!(all().iter().filter(|case| case.is_quick()).count() > 50);
    }

    #[test]
    fn the_full_set_is_every_case_and_one_that_takes_minutes() {
        let ids = |cases: Vec<Case>| cases.iter().map(|case| case.id).collect::<Vec<_>>();
        let mut expected = ids(all());
        expected.push("precision.whole-record");
        assert_eq!(ids(full()), expected);
    }

    #[test]
    fn case_ids_are_unique() {
        let mut ids: Vec<_> = full().iter().map(|case| case.id).collect();
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count);
    }
}
