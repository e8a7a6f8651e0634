//! The number type the equations are written over.
//!
//! `+ − × ÷ √` are correctly rounded on every machine; sine, cosine, inverse tangent, exponential
//! and logarithm are not, so they come from one correctly rounded crate. Nothing here fuses or
//! reorders an operation: the same scene gives the same bits everywhere.

use std::fmt::{Debug, Display};
use std::ops::Neg;

use nalgebra::{
    ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, SVector, Scalar,
};
use num_traits::{One, Zero};
use serde::Serialize;

/// A vector of `D` components: two on the primary fibre, three on the secondary.
pub type Vector<S, const D: usize> = SVector<S, D>;

/// A real number the scheme can be run in.
pub trait Number:
    Scalar
    + Copy
    + PartialOrd
    + Debug
    + Display
    + Zero
    + One
    + Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + Send
    + Sync
    + Serialize
{
    /// The nearest number to a double.
    fn from_f64(x: f64) -> Self;
    /// The nearest double.
    fn to_f64(self) -> f64;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// Inverse tangent, in (−π/2, π/2).
    fn atan(self) -> Self;
    /// Natural exponential.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// exp(x) − 1, with the digits that the difference would lose at small x.
    fn exp_m1(self) -> Self;
    /// ln(1 + x), with the digits that the sum would lose at small x.
    fn ln_1p(self) -> Self;
    /// Neither infinite nor not-a-number.
    fn is_finite(self) -> bool;

    /// A small whole number.
    fn count(n: usize) -> Self {
        Self::from_f64(n as f64)
    }
    /// Size without sign.
    fn abs(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
    /// The greater of two.
    fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
    /// Two: the factor of symmetry in (8), (17) and (18).
    fn two() -> Self {
        Self::one() + Self::one()
    }
    /// One half.
    fn half() -> Self {
        Self::one() / Self::two()
    }
}

impl Number for f64 {
    fn from_f64(x: f64) -> Self {
        x
    }
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn sin(self) -> Self {
        pxfm::f_sin(self)
    }
    fn cos(self) -> Self {
        pxfm::f_cos(self)
    }
    fn atan(self) -> Self {
        pxfm::f_atan(self)
    }
    fn exp(self) -> Self {
        pxfm::f_exp(self)
    }
    fn ln(self) -> Self {
        pxfm::f_log(self)
    }
    fn exp_m1(self) -> Self {
        pxfm::f_expm1(self)
    }
    fn ln_1p(self) -> Self {
        pxfm::f_log1p(self)
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        Self::is_finite(self)
    }
}

impl Number for f32 {
    fn from_f64(x: f64) -> Self {
        x as Self
    }
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    fn sin(self) -> Self {
        pxfm::f_sinf(self)
    }
    fn cos(self) -> Self {
        pxfm::f_cosf(self)
    }
    fn atan(self) -> Self {
        pxfm::f_atanf(self)
    }
    fn exp(self) -> Self {
        pxfm::f_expf(self)
    }
    fn ln(self) -> Self {
        pxfm::f_logf(self)
    }
    fn exp_m1(self) -> Self {
        pxfm::f_expm1f(self)
    }
    fn ln_1p(self) -> Self {
        pxfm::f_log1pf(self)
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        Self::is_finite(self)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn transcendental_pairs<S: Number>(tolerance: f64) {
        let x = S::from_f64(0.731);
        let (s, c) = (x.sin().to_f64(), x.cos().to_f64());
        let back = [
            (s * s + c * c, 1.0),
            (S::from_f64(s / c).atan().to_f64(), 0.731),
            (x.exp().ln().to_f64(), 0.731),
            ((x.sqrt() * x.sqrt()).to_f64(), 0.731),
            // A value that is not special, by a library of arbitrary precision.
            (s, 0.667_614_475_847_057_2),
            (x.exp_m1().to_f64(), 1.077156726168034),
            (x.ln_1p().to_f64(), 0.5486992761940722),
        ];
        for (found, expected) in back {
            assert_relative_eq!(found, expected, epsilon = 0.0, max_relative = tolerance);
        }
    }

    #[test]
    fn sine_and_its_companions_are_the_functions_of_their_names() {
        // Two or three roundings of half a unit, 1.1e-16 and 6e-8.
        transcendental_pairs::<f64>(4e-16);
        transcendental_pairs::<f32>(3e-7);
    }

    fn small_numbers_keep_their_digits<S: Number>(small: f64, tolerance: f64) {
        // x + x²/2 + x³/6 and x − x²/2 + x³/3: what follows is below x⁴/4.
        let x = S::from_f64(small);
        let y = x.to_f64();
        let grown = y * (1.0 + y / 2.0 * (1.0 + y / 3.0));
        let logarithm = y * (1.0 - y * (0.5 - y / 3.0));
        assert_relative_eq!(x.exp_m1().to_f64(), grown, epsilon = 0.0, max_relative = tolerance);
        assert_relative_eq!(x.ln_1p().to_f64(), logarithm, epsilon = 0.0, max_relative = tolerance);
    }

    #[test]
    fn exponential_and_logarithm_next_to_one_keep_the_digits_of_small_numbers() {
        // Half a unit of the function and a few roundings of the sum; x³/4 is far below.
        small_numbers_keep_their_digits::<f64>(-3.17e-7, 4e-16);
        small_numbers_keep_their_digits::<f32>(-3.17e-4, 2e-7);
    }

    #[test]
    fn size_and_greater_of_two_are_those_of_the_standard_library() {
        for (x, y) in [(-3.1, 2.7), (2.7, -3.1), (-3.1, -4.9), (0.0, 0.3)] {
            assert_eq!(Number::abs(x), f64::abs(x));
            assert_eq!(Number::max(x, y), f64::max(x, y));
        }
        assert!(Number::abs(0.0_f64).is_sign_positive());
    }
}
