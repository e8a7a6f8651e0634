//! The worse of two errors, of which one may be no number.

/// The greater of two errors, and NaN where either is: `f64::max` passes over NaN, so that the
/// greatest of many errors would say nothing of those that could not be reckoned.
pub fn worse(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_worse_than_any() {
        assert_eq!((worse(1.7, 2.9), worse(2.9, 1.7), worse(0.0, 0.0)), (2.9, 2.9, 0.0));
        for (a, b) in [(f64::NAN, 1.7), (1.7, f64::NAN), (f64::INFINITY, f64::NAN)] {
            assert!(worse(a, b).is_nan(), "{a} {b}");
        }
    }

    #[test]
    fn error_that_is_no_number_stays_in_a_row() {
        assert!([0.3, f64::NAN, 0.7].into_iter().fold(0.0, worse).is_nan());
    }
}
