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
    /// Neither infinite nor not-a-number.
    fn is_finite(self) -> bool;

    /// A small whole number.
    fn count(n: usize) -> Self {
        Self::from_f64(n as f64)
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
}
