//! How far two numbers of two traces are apart.

use crossfibre::double_double::DoubleDouble;
use crossfibre::number::Number as _;

use crate::bits;
use crate::trace_line::{self, NotFinite, Sum};

/// A number of a trace: a double, or the sum of two.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    hi: f64,
    /// Zero in a trace of doubles.
    lo: f64,
}

/// How far the numbers of a quantity may be apart and still agree. Either suffices.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tolerance {
    /// |a − b|, relative to the larger of the two; of a vector, to the largest component of both.
    pub relative: Option<f64>,
    /// In steps from double to double.
    pub ulp: Option<u64>,
}

/// How far a quantity of two traces is apart; of a vector, its worst component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// To the last bit.
    pub is_same: bool,
    /// Within the tolerance. Infinity and NaN agree with themselves alone.
    pub agrees: bool,
    /// Steps from double to double, −0 being 0; of sums of doubles, of their nearest doubles. None
    /// if one is NaN.
    pub ulp: Option<u64>,
    /// |a − b|, relative as in [`Tolerance::relative`]; infinite if one is not finite.
    pub relative: f64,
}

impl Number {
    /// A double.
    pub fn of(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// A sum of two doubles.
    pub fn sum(hi: f64, lo: f64) -> Self {
        if lo == 0.0 {
            return Self::of(hi);
        }
        let sum = DoubleDouble::new(hi, lo);
        Self { hi: sum.hi(), lo: sum.lo() }
    }

    /// Whether they are the same number: bit by bit, and every NaN is one.
    pub fn is_same(self, other: Self) -> bool {
        self.hi.to_bits() == other.hi.to_bits() && self.lo == other.lo
            || self.hi.is_nan() && other.hi.is_nan()
    }

    /// |a − b|.
    fn distance(self, other: Self) -> f64 {
        if self.lo == 0.0 && other.lo == 0.0 {
            return (self.hi - other.hi).abs();
        }
        (DoubleDouble::new(self.hi, self.lo) - DoubleDouble::new(other.hi, other.lo)).abs().to_f64()
    }

    fn is_finite(self) -> bool {
        self.hi.is_finite()
    }

    fn ulps(self, other: Self) -> Option<u64> {
        let is_number = !self.hi.is_nan() && !other.hi.is_nan();
        is_number.then(|| bits::ulps(self.hi, other.hi))
    }
}

impl From<Number> for trace_line::Number {
    fn from(Number { hi, lo }: Number) -> Self {
        match hi {
            _ if hi.is_nan() => Self::Other(NotFinite::NotANumber),
            f64::INFINITY => Self::Other(NotFinite::Infinity),
            f64::NEG_INFINITY => Self::Other(NotFinite::NegativeInfinity),
            _ if lo != 0.0 => Self::Sum(Sum { hi, lo }),
            _ => Self::Finite(hi),
        }
    }
}

impl Apart {
    /// Not at all.
    pub const SAME: Self = Self { is_same: true, agrees: true, ulp: Some(0), relative: 0.0 };

    /// How far two quantities with as many components are apart.
    pub fn of(a: &[Number], b: &[Number], tolerance: Tolerance) -> Self {
        let pairs = || a.iter().zip(b).map(|(&a, &b)| (a, b));
        if pairs().all(|(a, b)| a.is_same(b)) {
            return Self::SAME;
        }
        let largest = pairs()
            .flat_map(|(a, b)| [a.hi.abs(), b.hi.abs()])
            .filter(|x| x.is_finite())
            .fold(0.0, f64::max);
        let mut worst = Self { is_same: false, ..Self::SAME };
        for (a, b) in pairs().filter(|(a, b)| !a.is_same(*b)) {
            let is_finite = a.is_finite() && b.is_finite();
            let ulp = a.ulps(b);
            let relative = if is_finite { relative(a, b, largest) } else { f64::INFINITY };
            let agrees = is_finite
                && (tolerance.relative.is_some_and(|most| relative <= most)
                    || tolerance.ulp.is_some_and(|most| ulp.is_some_and(|ulp| ulp <= most)));
            worst = Self {
                is_same: false,
                agrees: worst.agrees && agrees,
                ulp: worst.ulp.zip(ulp).map(|(one, other)| one.max(other)),
                relative: worst.relative.max(relative),
            };
        }
        worst
    }
}

/// The distance by the largest component, which is zero only where both are: the distance is, too.
fn relative(a: Number, b: Number, largest: f64) -> f64 {
    if largest == 0.0 {
        return 0.0;
    }
    let distance = a.distance(b);
    if distance.is_finite() {
        distance / largest
    } else {
        // The difference of two finite numbers overflows.
        (a.hi / largest - b.hi / largest).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support;

    fn apart(a: &[f64], b: &[f64], tolerance: Tolerance) -> Apart {
        let numbers = |of: &[f64]| of.iter().copied().map(Number::of).collect::<Vec<_>>();
        Apart::of(&numbers(a), &numbers(b), tolerance)
    }

    #[test]
    fn a_vector_is_judged_by_its_largest_component_and_a_number_by_the_larger_one() {
        let tolerance = Tolerance { relative: Some(1e-3), ulp: None };
        let scalar = apart(&[0.31], &[0.3104], tolerance);
        assert!(!scalar.is_same && !scalar.agrees);
        // One rounding each of difference and quotient, of a difference that has lost three digits.
        assert!(support::relative(scalar.relative, 0.0004 / 0.3104) < 1e-12);
        let vector = apart(&[-5.7, 0.31], &[-5.7, 0.3104], tolerance);
        assert!(!vector.is_same && vector.agrees);
        assert!(support::relative(vector.relative, 0.0004 / 5.7) < 1e-12);
        // The two doubles next to 0.3104 and 0.31 are as many steps apart in either.
        assert_eq!((scalar.ulp, vector.ulp), (vector.ulp, Some(bits::ulps(0.31, 0.3104))));
    }

    #[test]
    fn either_tolerance_suffices_and_neither_excuses_what_is_not_finite() {
        let next = 0.73_f64.next_up();
        let none = Tolerance::default();
        let ulp = Tolerance { relative: None, ulp: Some(1) };
        let both = Tolerance { relative: Some(1e-20), ulp: Some(1) };
        assert!(!apart(&[0.73], &[next], none).agrees);
        assert!(apart(&[0.73], &[next], ulp).agrees);
        assert!(apart(&[0.73], &[next], both).agrees);
        assert!(!apart(&[0.73], &[next.next_up()], both).agrees);
        let loose = Tolerance { relative: Some(f64::MAX), ulp: Some(u64::MAX) };
        let infinite = apart(&[f64::INFINITY], &[f64::MAX], loose);
        assert_eq!((infinite.agrees, infinite.ulp), (false, Some(1)));
        let nan = apart(&[f64::NAN, 0.3], &[0.7, 0.3], loose);
        assert_eq!((nan.agrees, nan.ulp, nan.relative), (false, None, f64::INFINITY));
        assert_eq!(apart(&[f64::NAN], &[f64::NAN], none), Apart::SAME);
    }

    #[test]
    fn what_is_no_number_is_the_same_as_nothing_else_on_either_side() {
        let none = Tolerance::default();
        assert_eq!(apart(&[f64::NAN], &[-f64::NAN], none), Apart::SAME);
        for (a, b) in [(0.7, f64::NAN), (f64::NAN, 0.7)] {
            let apart = apart(&[a], &[b], none);
            assert_eq!((apart.is_same, apart.ulp), (false, None), "{a} {b}");
        }
        let written = trace_line::Number::from(Number::of(f64::NAN));
        assert!(matches!(written, trace_line::Number::Other(NotFinite::NotANumber)));
    }

    #[test]
    fn the_sign_of_zero_is_a_bit_and_no_distance() {
        let zero = apart(&[0.0], &[-0.0], Tolerance::default());
        assert_eq!(zero, Apart { is_same: false, agrees: false, ulp: Some(0), relative: 0.0 });
        assert!(apart(&[0.0], &[-0.0], Tolerance { relative: None, ulp: Some(0) }).agrees);
    }

    #[test]
    fn a_difference_that_overflows_is_twice_the_larger() {
        let opposite = apart(&[1.7e308], &[-1.7e308], Tolerance::default());
        assert_eq!(opposite.relative, 2.0);
    }

    #[test]
    fn sums_of_doubles_are_compared_in_all_their_digits() {
        let (a, b) = (Number::sum(0.1, 3e-18), Number::sum(0.1, 3.1e-18));
        let apart = Apart::of(&[a], &[b], Tolerance::default());
        assert_eq!((apart.is_same, apart.ulp), (false, Some(0)));
        // The difference of the small parts is exact to their rounding, 2⁻⁵³ of 3e-18.
        assert!(support::relative(apart.relative, 1e-18) < 1e-13);
        // A sum and its greater part are apart by the other one.
        for (a, b) in [(a, Number::of(0.1)), (Number::of(0.1), a)] {
            let apart = Apart::of(&[a], &[b], Tolerance::default());
            assert!(support::relative(apart.relative, 3e-17) < 1e-13, "{apart:?}");
        }
        // However it is divided into two, and a double is a sum without a second part.
        assert!(Number::sum(3e-18, 0.1).is_same(a));
        assert!(Number::sum(0.1, 0.0).is_same(Number::of(0.1)));
    }

    #[test]
    fn either_number_may_be_the_one_that_is_not_finite() {
        let loose = Tolerance { relative: Some(f64::MAX), ulp: Some(u64::MAX) };
        for (a, b) in [(f64::INFINITY, f64::MAX), (f64::MAX, f64::INFINITY)] {
            assert!(!apart(&[a], &[b], loose).agrees, "{a} {b}");
        }
    }

    #[test]
    fn just_the_tolerance_is_within_it_and_every_component_has_to_be() {
        let half = Tolerance { relative: Some(0.5), ulp: None };
        assert!(apart(&[1.0], &[0.5], half).agrees);
        assert!(!apart(&[1.0], &[0.25], half).agrees);
        // The largest component is 1: the differences are 0.75 and 0.25.
        for (a, b) in [([1.0, 0.5], [0.25, 0.25]), ([0.5, 1.0], [0.25, 0.25])] {
            assert!(!apart(&a, &b, half).agrees, "{a:?} {b:?}");
        }
    }

    #[test]
    fn a_number_is_written_as_what_it_is() {
        let sum = Sum { hi: 0.1, lo: 3e-18 };
        for (number, written) in [
            (Number::of(0.1), trace_line::Number::Finite(0.1)),
            (Number::sum(0.1, 3e-18), trace_line::Number::Sum(sum)),
            (Number::of(f64::INFINITY), trace_line::Number::Other(NotFinite::Infinity)),
            (Number::of(-f64::INFINITY), trace_line::Number::Other(NotFinite::NegativeInfinity)),
        ] {
            assert_eq!(trace_line::Number::from(number), written);
        }
    }
}
