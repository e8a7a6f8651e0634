//! A number of 32 digits: the unevaluated sum of two doubles.
//!
//! It is for telling rounding from everything else: march the same scene in `f64` and in
//! [`DoubleDouble`], and what differs is the rounding of `f64`.
//!
//! **A double stays the double it is.** `from_f64(0.1)` is the double next to 0.1, which is
//! 5.6e-18 off; one tenth is `from_f64(1.0) / from_f64(10.0)`. So a scene means the same numbers in
//! both types. What is reported as doubles stays so: of a [`crate::balance::Balance`] the residual of
//! momentum is formed in all digits, that of energy is not.
//!
//! **Precision.** Greatest relative error in units of u² = 2⁻¹⁰⁶ = 1.23e-32, found against 71 digits,
//! rounded up, on 300 000 random arguments each (three million pairs for the operations), half of them near one;
//! and the bounds that are proven (Joldes, Muller and Popescu 2017; Muller and Rideau 2022; for the
//! root Lefèvre, Louvet, Muller, Picot and Rideau 2023):
//!
//! | | found | proven |
//! |---|---|---|
//! | + − | 2.4 | 3 |
//! | × | 4.0 | 5 |
//! | ÷ | 1.9 | |
//! | √ | 2.9 | 3.125 |
//! | sine, cosine | 2.2 | |
//! | inverse tangent | 2.3 | |
//! | exponential | 1.2 | |
//! | logarithm | 1.9 | |
//! | exp x − 1 | 2.2 | |
//! | ln(1 + x) | 2.7 | |
//!
//! So every function is within 5e-32 where it was tried, beside zeros and multiples of π/2 too; none
//! is correctly rounded.
//!
//! **Range.** That of `f64`: what overflows there is infinite here, and what has no value is NaN. A
//! number is finite if its first part is. Within 2⁻⁵² of overflow, where one of the two may overflow
//! alone, the result is infinite or NaN, never finite and wrong.
//! Numbers below 2⁻⁹⁶⁸ = 3e-292 have fewer digits, because the smallest double, 5e-324, is more than
//! their 106th bit; so do products, quotients and roots that are or come from such numbers. Below
//! 2⁻¹⁰²² there is no more than in `f64`. Sine and cosine of more than 2⁵⁰ are NaN, not a guess. The
//! sign of zero is not kept.
//!
//! Nothing is fused and nothing is the platform's but + − × ÷ √ of doubles: the bits are the same
//! everywhere. A march takes 40 to 70 times as long as in `f64`.

use std::fmt::{self, Display, Formatter};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use serde::Serialize;

use self::error_free::{fast_two_sum, power_of_two, two_product, two_sum};
use crate::number::Number;

mod circular;
mod error_free;
mod exponential;
#[cfg(test)]
mod tests;

/// hi + lo, where hi is the double nearest to the sum.
///
/// Shown as that sum, `0.1+1.3e-18`, each part in the shortest decimals that read back to the same
/// bits, the second left out where it is zero. Written to JSON as `{"hi":0.1,"lo":1.3e-18}`, since a
/// JSON number would come back as a double; [`crate::trace_file`] then has such an object wherever a
/// trace in `f64` has a number.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    /// The sum of any two doubles, exactly.
    pub fn new(hi: f64, lo: f64) -> Self {
        let (hi, lo) = two_sum(hi, lo);
        Self::decided_by(hi, lo)
    }

    /// The nearest double.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// What is left: at most half a unit in the last place of [`Self::hi`].
    pub fn lo(self) -> f64 {
        self.lo
    }

    const fn double(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// A sum whose parts may overlap, |a| ≥ |b| or a = 0.
    #[inline(always)]
    fn normalised(a: f64, b: f64) -> Self {
        let (hi, lo) = fast_two_sum(a, b);
        Self::decided_by(hi, lo)
    }

    /// An infinite or undefined `hi` makes the error of its sum NaN, which means nothing.
    #[inline(always)]
    fn decided_by(hi: f64, lo: f64) -> Self {
        if hi.is_finite() { Self { hi, lo } } else { Self::double(hi) }
    }

    /// Times a power of two, exactly where it neither overflows nor underflows.
    fn scaled(self, power_of_two: f64) -> Self {
        Self::normalised(self.hi * power_of_two, self.lo * power_of_two)
    }

    /// Times a double, within 2u² ("DWTimesFP1", Li et al. 2002).
    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        let (product, error) = two_product(self.hi, factor);
        if !product.is_finite() {
            return Self::double(product);
        }
        let (hi, rest) = fast_two_sum(product, self.lo * factor);
        Self::normalised(hi, rest + error)
    }

    /// A quotient whose first digit times the divisor might overflow.
    #[cold]
    #[inline(never)]
    fn huge_over(self, divisor: Self) -> Self {
        (self.scaled(power_of_two(-60)) / divisor).scaled(power_of_two(60))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

/// "AccurateDWPlusDW" (Joldes, Muller and Popescu 2017): the bound holds where the sum cancels, too.
impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (hi, hi_error) = two_sum(self.hi, other.hi);
        if !hi.is_finite() {
            return Self::double(hi);
        }
        let (lo, lo_error) = two_sum(self.lo, other.lo);
        let (hi, rest) = fast_two_sum(hi, hi_error + lo);
        Self::normalised(hi, lo_error + rest)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// "DWTimesDW1" (Joldes, Muller and Popescu 2017).
impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.hi, other.hi);
        if !product.is_finite() {
            return Self::double(product);
        }
        let cross = self.hi * other.lo + self.lo * other.hi;
        Self::normalised(product, error + cross)
    }
}

/// Long division with three digits, each a double (Hida, Li and Bailey 2001, "QD").
impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: Self) -> Self {
        let first = self.hi / divisor.hi;
        if !first.is_finite() || !divisor.hi.is_finite() {
            return Self::double(first);
        }
        if self.hi.abs() > power_of_two(1000) {
            return self.huge_over(divisor);
        }
        let rest = self - divisor.times(first);
        let second = rest.hi / divisor.hi;
        let rest = rest - divisor.times(second);
        let third = rest.hi / divisor.hi;
        let (hi, lo) = fast_two_sum(first, second);
        Self::normalised(hi, lo + third)
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt),*) => {$(
        impl $trait for DoubleDouble {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for DoubleDouble {
    fn zero() -> Self {
        Self::double(0.0)
    }
    fn is_zero(&self) -> bool {
        self.hi == 0.0
    }
}

impl One for DoubleDouble {
    fn one() -> Self {
        Self::double(1.0)
    }
}

impl Display for DoubleDouble {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.lo == 0.0 {
            write!(f, "{:?}", self.hi)
        } else {
            write!(f, "{:?}{:+?}", self.hi, self.lo)
        }
    }
}

impl Number for DoubleDouble {
    fn from_f64(x: f64) -> Self {
        Self::double(x)
    }
    fn to_f64(self) -> f64 {
        self.hi
    }
    /// √hi, and what its square leaves over twice the root ("SQRTDWtoDW").
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.hi.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::double(root);
        }
        let (square, error) = two_product(root, root);
        let rest = (self.hi - square) - error + self.lo;
        Self::normalised(root, rest / (2.0 * root))
    }
    fn sin(self) -> Self {
        self.sine()
    }
    fn cos(self) -> Self {
        self.cosine()
    }
    fn atan(self) -> Self {
        self.inverse_tangent()
    }
    fn exp(self) -> Self {
        self.exponential()
    }
    fn ln(self) -> Self {
        self.logarithm()
    }
    fn exp_m1(self) -> Self {
        self.exponential_less_one()
    }
    fn ln_1p(self) -> Self {
        self.logarithm_of_one_more()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.hi.is_finite()
    }
}
