//! Logarithm and exponential.
//!
//! The logarithm is a series; the exponential is the double nearest to it, corrected by one step of
//! Newton's method on the logarithm.

use num_traits::One;

use super::DoubleDouble;
use super::error_free::power_of_two;
use crate::number::Number;

/// ln 2 in three parts; an exponent times one of the first two, of 42 bits, is exact.
const LN_2: [f64; 3] = [0.6931471805598903, 5.4979230187085024e-14, -1.3124698417785255e-27];

impl DoubleDouble {
    /// ln x = k ln 2 + ln m, √½ ≤ m < √2.
    pub(super) fn logarithm(self) -> Self {
        if self.hi <= 0.0 || !self.hi.is_finite() {
            return Self::double(pxfm::f_log(self.hi));
        }
        let (exponent, m) = self.mantissa();
        let [leading, middle, rest] = LN_2.map(|part| exponent * part);
        Self::normalised(leading, middle)
            + ((m - Self::one()).logarithm_near_one() + Self::double(rest))
    }

    /// ln(1 + x): near zero the series in x itself.
    pub(super) fn logarithm_of_one_more(self) -> Self {
        if (-0.29..=0.41).contains(&self.hi) {
            self.logarithm_near_one()
        } else {
            (Self::one() + self).logarithm()
        }
    }

    /// ln(1 + f), √½ ≤ 1 + f ≤ √2: 2 artanh s with s = f/(2 + f) is f − s (f − R),
    /// R = 2 (s²/3 + s⁴/5 + …), in which f, the greater part, has not been rounded.
    fn logarithm_near_one(self) -> Self {
        /// s² ≤ (3 − √8)² = 0.0295, so that what follows s⁴⁴ is less than 1e-35 of the sum.
        const LAST: usize = 22;
        let s = self / (Self::two() + self);
        let square = s * s;
        let mut series = Self::double(0.0);
        for n in (1..=LAST).rev() {
            series = (series + Self::one() / Self::count(2 * n + 1)) * square;
        }
        self - s * (self - Self::two() * series)
    }

    /// k and m with x = 2ᵏ m, √½ ≤ m < √2, for a positive x.
    fn mantissa(self) -> (f64, Self) {
        if self.hi < f64::MIN_POSITIVE {
            let (exponent, m) = self.scaled(power_of_two(60)).mantissa();
            return (exponent - 60.0, m);
        }
        let exponent = (self.hi.to_bits() >> 52) as i32 - 1023;
        let m = self.times_two_to(-exponent);
        if m.hi < std::f64::consts::SQRT_2 {
            (f64::from(exponent), m)
        } else {
            (f64::from(exponent + 1), m.scaled(0.5))
        }
    }

    /// eˣ = 2ᵏ (1 + (eʳ − 1)).
    pub(super) fn exponential(self) -> Self {
        if self.hi.is_nan() || self.hi.abs() > 750.0 {
            return Self::double(pxfm::f_exp(self.hi));
        }
        let (exponent, r) = self.modulo_ln_2();
        (Self::one() + r.exponential_near_one()).times_two_to(exponent)
    }

    /// eˣ − 1 = 2ᵏ ((eʳ − 1) + (1 − 2⁻ᵏ)).
    pub(super) fn exponential_less_one(self) -> Self {
        // What is not a number is in no range.
        if !(-100.0..750.0).contains(&self.hi) {
            return Self::double(pxfm::f_expm1(self.hi));
        }
        let (exponent, r) = self.modulo_ln_2();
        let shift = Self::one() - Self::one().times_two_to(-exponent);
        (r.exponential_near_one() + shift).times_two_to(exponent)
    }

    /// eʳ − 1 for |r| ≤ ½ ln 2: with y the double nearest to it and e = r − ln(1 + y), whose square
    /// is beyond the digits, it is y + (1 + y) e.
    fn exponential_near_one(self) -> Self {
        let y = Self::double(pxfm::f_expm1(self.hi));
        let e = self - y.logarithm_near_one();
        y + (Self::one() + y) * e
    }

    /// k and r with x = k ln 2 + r, |r| ≤ ½ ln 2 or hardly more.
    fn modulo_ln_2(self) -> (i32, Self) {
        let exponent = (self.hi / std::f64::consts::LN_2).round();
        let r = LN_2.iter().fold(self, |r, part| r - Self::double(exponent * part));
        (exponent as i32, r)
    }

    /// Times 2ᵏ in two halves, either of which is a normal double.
    fn times_two_to(self, exponent: i32) -> Self {
        let half = exponent / 2;
        self.scaled(power_of_two(half)).scaled(power_of_two(exponent - half))
    }
}
