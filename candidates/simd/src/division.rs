//! Quotients by multiplication, equal to `÷` to the bit.
//!
//! A step divides twice by a length: L^t by L^{t−1}, and a tension by L^t. The reciprocal of a length is
//! kept for both, and [`Lanes::divide`] makes quotients of it with fused multiply-adds, which leaves one
//! quotient a step to the divider. A fused multiply-add (one rounding) is a means here: the result is that
//! of the rounded operation `÷` that the equations ask for.
//!
//! # Why it is right
//!
//! Let p = 53, u = 2⁻⁵³ and RN rounding to nearest; `y = RN(1/b)`, `q = RN(a y)`, `r = RN(a − b q)`,
//! `q' = RN(q + r y)`. Then `q' = RN(a/b)`, if nothing under- or overflows.
//!
//! Markstein's theorem (*IBM J. Res. Dev.* 34, 1990; *IA-64 and Elementary Functions*, 2000; Cornea,
//! Harrison & Tang, *Scientific Computing on Itanium-based Systems*, 2002; Muller et al., *Handbook of
//! Floating-Point Arithmetic*, 2nd ed., 4.7) says so for `y = RN(1/b)` and `q` within one unit in the
//! last place (ulp) of a/b. Its exception, a `b` whose significand is all ones, concerns ways to reach `y`
//! by multiplication; here the divider rounds `y`. And that `q` may be 1.5 ulp off does no harm. Let A, B
//! in [2⁵², 2⁵³) be the significands and Q = a/b in its ulps; no midpoint of two numbers is nearer to Q
//! than 1/(2B).
//!
//! - `y` is off by half its ulp at most, relatively by B·2⁻¹⁰⁶, so |Q − q| ≤ 1/2 + Q·B·2⁻¹⁰⁶.
//! - What is rounded to `q'` is off by |Q − q|·B·2⁻¹⁰⁶, and by 1/B more where `r` has 54 bits and is
//!   rounded, which needs |Q − q| > 1. All of it is below 4u.
//! - Only a midpoint within 4u of Q could be rounded to the wrong side. If it is 1/2 from `q`, `r` is
//!   exact, and what is rounded is off by no more than B·2⁻¹⁰⁷(1 + 8u) < 1/(2B): right.
//! - If it is 3/2 from `q`, then |Q − q| > 3/2 − 4u. For A ≥ B, Q·B = 2⁵²·A and |Q − q| < 1: impossible.
//!   For A < B, Q·B = 2⁵³·A and |Q − q| ≤ 1/2 + A·2⁻⁵³, so 2⁵³ − A < 4, B = A + k with k ≤ 3, and
//!   Q = 2⁵³ − k − k(2⁵³ − B)/B is within 12u of a whole number, not of a midpoint: impossible.
//!
//! # Range
//!
//! There must be room for the remainder `r`, 2⁻⁵³ of `a`. Two numbers are watched in every step: the
//! length, at least [`LEAST_LENGTH`], and the new strain, below [`MOST_STRAIN`]. No root of a double is above
//! 2⁵¹². An L^{t−1} that is too small makes a quotient above 2⁶⁰ or one that is not a number, and so a strain
//! that is seen. A strain by (4) or L/L⁰ − 1 is zero or at least 2⁻⁵⁴ in size; with a stiffness within
//! [`STIFFNESS`] the tension and its quotient are then zero or between 2⁻⁸⁶⁶ and 2⁸⁴⁰. A zero tension gives
//! the zero that `÷` gives, since (4) never leaves −0. What is out of range goes to the divider.
//!
//! [`Lanes::divide`]: crate::lanes::Lanes::divide

use std::ops::RangeInclusive;

/// Modulus × area, N, with which tensions are in range: 2⁻³⁰⁰ to 2³⁰⁰.
pub const STIFFNESS: RangeInclusive<f64> = power_of_two(-300)..=power_of_two(300);

/// The least ordinary length, m: 2⁻⁴⁷⁹.
pub const LEAST_LENGTH: f64 = power_of_two(-479);

/// Strains below this are ordinary.
pub const MOST_STRAIN: f64 = power_of_two(60);

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;
    use crate::lanes::{Avx2, Avx512, Lanes, Work};

    /// SplitMix64.
    struct Draw(u64);

    impl Draw {
        fn bits(&mut self) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }

        /// A significand in [2⁵², 2⁵³): any, or next to an end of the range, or of few bits.
        fn significand(&mut self) -> u64 {
            let fraction = self.bits() >> 12;
            let near = self.bits() % 64;
            (1 << 52)
                | match self.bits() % 8 {
                    0 => near,
                    1 => (1 << 52) - 1 - near,
                    2 => fraction & !((1 << 40) - 1),
                    _ => fraction,
                }
        }
    }

    /// The quotient nearest to a midpoint between two doubles, or to a double, for an odd B: A such that
    /// 2⁵⁴A or 2⁵³A is c more than a multiple of B.
    fn hard_dividend(b: u64, c: i64) -> u64 {
        let half = |x: u64| if x.is_multiple_of(2) { x / 2 } else { x.midpoint(b) };
        let a = (0..54).fold(c.rem_euclid(b.cast_signed()).cast_unsigned(), |x, _| half(x));
        // Of its class it is the one that is a significand, for one of the two powers.
        if a >= 1 << 52 { a } else { a + b }
    }

    /// A double of a significand and an exponent.
    fn double(significand: u64, exponent: i64) -> f64 {
        significand as f64 * power_of_two(exponent)
    }

    /// Eight pairs.
    fn pairs(draw: &mut Draw) -> [[f64; 8]; 2] {
        let mut pairs = [[0.0; 8]; 2];
        let [dividends, divisors] = &mut pairs;
        for (dividend, divisor) in dividends.iter_mut().zip(divisors) {
            let mut b = draw.significand();
            let a = match draw.bits() % 4 {
                0 => {
                    b |= 1;
                    hard_dividend(b, (draw.bits() % 9).cast_signed() - 4)
                }
                // A length and what has become of it, as in (4).
                1 => b.saturating_add_signed((draw.bits() % 1999).cast_signed() - 999),
                _ => draw.significand(),
            };
            let exponent = |draw: &mut Draw, most: u64| (draw.bits() % most).cast_signed();
            let sign = if draw.bits().is_multiple_of(2) { 1.0 } else { -1.0 };
            *dividend = sign * double(a, exponent(draw, 700) - 350);
            *divisor = double(b, exponent(draw, 900) - 480);
        }
        pairs
    }

    /// How many of so many quotients are not those of `÷`.
    struct Wrong<'a> {
        quotients: u64,
        seed: u64,
        wrong: &'a mut u64,
    }

    impl<L: Lanes> Work<L> for Wrong<'_> {
        #[inline(always)]
        fn run(self, lanes: L) {
            let mut draw = Draw(self.seed);
            for _ in 0..self.quotients / 8 {
                let [a, b] = pairs(&mut draw);
                for at in (0..8).step_by(L::COUNT) {
                    let vector = |x: &[f64; 8]| {
                        let mut array = lanes.array(lanes.splat(0.0));
                        array.as_mut().copy_from_slice(&x[at..at + L::COUNT]);
                        lanes.vector(array)
                    };
                    let (x, y) = (vector(&a), vector(&b));
                    let quotient = lanes.array(lanes.divide(x, y, lanes.reciprocal(y)));
                    for (i, q) in quotient.as_ref().iter().enumerate() {
                        *self.wrong += u64::from(q.to_bits() != (a[at + i] / b[at + i]).to_bits());
                    }
                }
            }
        }
    }

    fn wrong(quotients: u64) -> u64 {
        let mut wrong = 0;
        for seed in [0x17, 0x2b] {
            if let Some(lanes) = Avx512::detect() {
                lanes.compile(Wrong { quotients, seed, wrong: &mut wrong });
            }
            if let Some(lanes) = Avx2::detect() {
                lanes.compile(Wrong { quotients, seed, wrong: &mut wrong });
            }
        }
        wrong
    }

    /// No tolerance: a quotient is that of `÷` or it is not.
    #[test]
    fn quotients_by_multiplication_are_those_of_the_divider() {
        assert_eq!(wrong(400_000), 0);
    }

    /// 400 million for each kind of vectors; half a minute, in release:
    /// `cargo test --release -p crossfibre-simd -- --ignored`.
    #[test]
    #[ignore = "takes half a minute"]
    fn hundreds_of_millions_of_quotients_are_those_of_the_divider() {
        assert_eq!(wrong(200_000_000), 0);
    }

    /// That the constructed pairs are hard: the remainder of 2⁵⁴A, or of 2⁵³A, is c.
    #[test]
    fn hard_dividends_are_hard() {
        let mut draw = Draw(0x51);
        for _ in 0..1000 {
            let (b, c) = (draw.significand() | 1, 3);
            let a = hard_dividend(b, c);
            assert!(a >= 1 << 52, "{a} / {b}");
            assert_eq!((u128::from(a) << 54) % u128::from(b), 3, "{a} / {b}");
        }
    }
}
