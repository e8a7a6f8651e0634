//! A number with its derivative: the march on it is the march, and its exact linearisation beside it.

use std::fmt;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crossfibre::number::Number;
use num_traits::{One, Zero};
use serde::Serialize;

/// A value and its derivative with respect to one parameter.
///
/// Only the value is compared: the derivative of a branch is that of the side that is taken.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Dual {
    /// The value: to the bit what the march of doubles computes.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A function of this number, from its value and derivative there.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, slope: self.slope * slope }
    }
}

impl PartialEq for Dual {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Dual {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl fmt::Display for Dual {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} + {} d", self.value, self.slope)
    }
}

impl Zero for Dual {
    fn zero() -> Self {
        Self::from_f64(0.0)
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0
    }
}

impl One for Dual {
    fn one() -> Self {
        Self::from_f64(1.0)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, y: Self) -> Self {
        Self { value: self.value + y.value, slope: self.slope + y.slope }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, y: Self) -> Self {
        Self { value: self.value - y.value, slope: self.slope - y.slope }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, y: Self) -> Self {
        let slope = self.slope * y.value + self.value * y.slope;
        Self { value: self.value * y.value, slope }
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, y: Self) -> Self {
        let value = self.value / y.value;
        Self { value, slope: (self.slope - value * y.slope) / y.value }
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt;)*) => {$(
        impl $trait for Dual {
            fn $method(&mut self, y: Self) {
                *self = *self $operator y;
            }
        }
    )*};
}

assign! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
}

impl Number for Dual {
    fn from_f64(x: f64) -> Self {
        Self { value: x, slope: 0.0 }
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn sin(self) -> Self {
        self.chain(Number::sin(self.value), Number::cos(self.value))
    }
    fn cos(self) -> Self {
        self.chain(Number::cos(self.value), -Number::sin(self.value))
    }
    fn atan(self) -> Self {
        self.chain(Number::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }
    fn exp(self) -> Self {
        let power = Number::exp(self.value);
        self.chain(power, power)
    }
    fn ln(self) -> Self {
        self.chain(Number::ln(self.value), 1.0 / self.value)
    }
    fn exp_m1(self) -> Self {
        self.chain(Number::exp_m1(self.value), Number::exp(self.value))
    }
    fn ln_1p(self) -> Self {
        self.chain(Number::ln_1p(self.value), 1.0 / (1.0 + self.value))
    }
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function and operation at once, generic over the number.
    fn everything<S: Number>(x: S) -> S {
        let y = S::from_f64(0.731);
        let mut z = (x * y - y / x).sin() + (x + y).cos() * x.atan() - x.sqrt().exp();
        z += x.ln() * (x / y).exp_m1();
        z -= (x * x).ln_1p();
        z *= -(x - y);
        z /= x * x + y;
        z.abs().max(x)
    }

    #[test]
    fn the_derivative_is_that_of_difference_quotients_and_the_value_that_of_doubles() {
        for x in [1.37, 2.11, 3.73] {
            let found = everything(Dual { value: x, slope: 1.0 });
            assert_eq!(found.value.to_bits(), everything(x).to_bits());
            // Richardson's rule on central differences: h⁴ leaves 1e-12 of a function of order 1 to 10
            // whose fifth derivative is of order 100, and rounding 1e-15/h.
            let central = |h: f64| (everything(x + h) - everything(x - h)) / (2.0 * h);
            let expected = (4.0 * central(5e-4) - central(1e-3)) / 3.0;
            let error = (found.slope / expected - 1.0).abs();
            assert!(error < 1e-10, "{x}: {} {expected}", found.slope);
        }
    }

    #[test]
    fn a_branch_is_chosen_by_the_value_alone() {
        let x = Dual { value: 1.5, slope: -7.0 };
        let y = Dual { value: 1.5, slope: 3.0 };
        assert!(x == y && x <= y && x >= y && Dual::from_f64(0.0).is_zero());
        assert_eq!(Number::max(x, Dual::from_f64(2.5)).slope, 0.0);
        assert_eq!(Number::abs(-x).slope, -7.0);
    }

    #[test]
    fn a_comparison_sees_the_value_and_nothing_else() {
        let x = Dual { value: 1.5, slope: -7.0 };
        let other = Dual { value: 2.5, slope: -7.0 };
        assert_ne!(x, other);
        assert_eq!(x.partial_cmp(&other), Some(std::cmp::Ordering::Less));
        assert!(!x.is_zero());
        let is_finite = |value, slope| Number::is_finite(Dual { value, slope });
        assert!(is_finite(1.5, f64::INFINITY) && !is_finite(f64::INFINITY, 0.0));
        assert_eq!(x.to_string(), "1.5 + -7 d");
    }
}
