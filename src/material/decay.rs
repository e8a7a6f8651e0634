//! What is left and what is gone after a decay, and exponentials less their first terms.

use crate::number::Number;

/// exp(−x) and 1 − exp(−x) for x ≥ 0, each to a few units in its own last place.
///
/// Below one half the second comes from exp(x) − 1 and the first is 1 less that, at least 0.6;
/// from one half on it is the other way round, and the second is at least 0.39.
#[inline]
pub(super) fn decay<S: Number>(x: S) -> (S, S) {
    if x < S::half() {
        let gone = -(-x).exp_m1();
        (S::one() - gone, gone)
    } else {
        let left = (-x).exp();
        (left, S::one() - left)
    }
}

/// exp(y) − 1 − y: below one in size the sum Σ yᵏ/k! from k = 2 on, to the last term that counts.
pub(super) fn exp_m1_less_itself<S: Number>(y: S) -> S {
    if y.abs() >= S::one() {
        return y.exp_m1() - y;
    }
    let (mut term, mut sum, mut k) = (S::half() * y * y, S::zero(), 2);
    loop {
        let next = sum + term;
        if next == sum || !next.is_finite() {
            return next;
        }
        sum = next;
        k += 1;
        term = term * y / S::count(k);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_stays_so() {
        assert!(exp_m1_less_itself(f64::NAN).is_nan());
    }

    #[test]
    fn both_parts_keep_their_digits_on_either_side_of_one_half() {
        // exp(−x) and 1 − exp(−x) to 40 digits in another language. Tolerance: half a unit of the
        // function and half a unit of the difference, which is at least 0.39: 4e-16 and 2e-7.
        for (x, left, gone) in [
            (3.7e-13, 0.99999999999963, 3.6999999999993153e-13),
            (0.0173, 0.9828487857665612, 0.017151214233438843),
            (0.4991, 0.607076783025002, 0.39292321697499794),
            (0.5003, 0.6063487278058701, 0.3936512721941298),
            (2.917, 0.054095731306733674, 0.9459042686932664),
            (31.7, 1.7094835407045374e-14, 0.9999999999999829),
        ] {
            let found = decay(x);
            assert!((found.0 / left - 1.0).abs() < 4e-16, "{x} {found:?}");
            assert!((found.1 / gone - 1.0).abs() < 4e-16, "{x} {found:?}");
            let found = decay(x as f32);
            assert!((f64::from(found.0) / left - 1.0).abs() < 2e-7 * x.max(1.0), "{x} {found:?}");
            assert!((f64::from(found.1) / gone - 1.0).abs() < 2e-7, "{x} {found:?}");
        }
        assert_eq!(decay(1e6), (0.0, 1.0));
        assert_eq!(decay(0.0), (1.0, 0.0));
    }
}
