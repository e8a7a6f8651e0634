//! Sine, cosine and inverse tangent.
//!
//! Series for sine and cosine; the inverse tangent is the double nearest to it, corrected by one
//! step of Newton's method on them.

use num_traits::One;

use super::DoubleDouble;
use super::error_free::{power_of_two, two_product, two_sum};
use crate::number::Number;

/// π/2 in five parts.
const HALF_PI: [f64; 5] = [
    std::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591698e-33,
    5.562271104316826e-50,
    2.836115989820158e-66,
];

/// Up to here the multiple of π/2 next to an angle is a whole number that the double quotient finds.
const MOST: f64 = power_of_two(50);

impl DoubleDouble {
    pub(super) fn sine(self) -> Self {
        self.turned(0)
    }

    pub(super) fn cosine(self) -> Self {
        self.turned(1)
    }

    /// sin(x + quarters × π/2).
    fn turned(self, quarters: i64) -> Self {
        if self.hi.is_nan() || self.hi.abs() > MOST {
            return Self::double(f64::NAN);
        }
        let (multiple, r) = self.modulo_half_pi();
        let sine = || r + r.sine_less_angle();
        let cosine = || Self::one() + r.cosine_less_one();
        match (multiple + quarters).rem_euclid(4) {
            0 => sine(),
            1 => cosine(),
            2 => -sine(),
            _ => -cosine(),
        }
    }

    /// k and r with x = k π/2 + r, |r| ≤ π/4 or hardly more.
    ///
    /// x − k π/2 may cancel all 106 bits of x, so its twelve terms are added in sevenfold precision
    /// (Ogita, Rump and Oishi 2005, "SumK").
    fn modulo_half_pi(self) -> (i64, Self) {
        let multiple = (self.hi / HALF_PI[0]).round();
        let mut terms = [0.0; 12];
        for (pair, part) in terms.chunks_exact_mut(2).zip(HALF_PI) {
            (pair[0], pair[1]) = two_product(-multiple, part);
        }
        (terms[10], terms[11]) = (self.lo, self.hi);
        for _ in 0..6 {
            for i in 1..terms.len() {
                (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
            }
        }
        let rest = terms[..11].iter().sum();
        (multiple as i64, Self::new(terms[11], rest))
    }

    /// sin r − r = −r r²/6 (1 − r²/20 (…)).
    fn sine_less_angle(self) -> Self {
        let square = self * self;
        -(self * square / Self::count(6) * nested(square, 4))
    }

    /// cos r − 1 = −r²/2 (1 − r²/12 (…)).
    fn cosine_less_one(self) -> Self {
        let square = self * self;
        -(square * Self::half() * nested(square, 3))
    }

    /// Beyond one the inverse tangent of the reciprocal is taken from a right angle. Within, with y
    /// the double nearest to it, it is y + arctan((x cos y − sin y)/(cos y + x sin y)), whose
    /// numerator is written (x − y) + x (cos y − 1) − (sin y − y): the difference is exact and the
    /// rest is smaller by y².
    pub(super) fn inverse_tangent(self) -> Self {
        if self.hi.abs() > 1.0 {
            let right_angle = Self::new(HALF_PI[0], HALF_PI[1]);
            let rest = (Self::one() / self).inverse_tangent();
            return if self.hi > 0.0 { right_angle - rest } else { -right_angle - rest };
        }
        let y = Self::double(pxfm::f_atan(self.hi));
        let (sine, cosine) = (y.sine_less_angle(), y.cosine_less_one());
        let across = (self - y) + (self * cosine - sine);
        let along = Self::one() + cosine + self * (y + sine);
        y + across / along
    }
}

/// 1 − r²/(n(n+1)) (1 − r²/((n+2)(n+3)) (…)), to the thirtieth power of r ≤ π/4: what follows is less
/// than 1e-35.
fn nested(square: DoubleDouble, first: usize) -> DoubleDouble {
    let one = DoubleDouble::one();
    (first..first + 28)
        .step_by(2)
        .rev()
        .fold(one, |inner, n| one - square * inner / DoubleDouble::count(n * (n + 1)))
}
