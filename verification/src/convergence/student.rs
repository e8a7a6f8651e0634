//! Student's t.

use statrs::distribution::{ContinuousCDF, StudentsT};

use super::Fault;

/// The t that a deviate of `degrees` degrees of freedom exceeds in size with probability 1 − `level`.
pub(super) fn quantile(level: f64, degrees: usize) -> Result<f64, Fault> {
    if !(level > 0.0 && level < 1.0) {
        return Err(Fault::Level(level));
    }
    let student = StudentsT::new(0.0, 1.0, degrees as f64).map_err(|_| Fault::Level(level))?;
    Ok(student.inverse_cdf(0.5 + 0.5 * level))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By another library (mpmath), to 30 digits, from the incomplete beta function. The crate's own
    /// inverse is good to about ten digits; an interval needs three.
    #[test]
    fn quantiles_are_those_of_another_library() {
        for (level, degrees, expected) in TABLE {
            let found = quantile(level, degrees).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-9, "{level} {degrees}: {found}");
        }
    }

    const TABLE: [(f64, usize, f64); 8] = [
        (0.95, 1, 12.7062047361747),
        (0.95, 2, 4.302652729749464),
        (0.95, 3, 3.18244630528371),
        (0.95, 5, 2.570581835636316),
        (0.95, 11, 2.20098516009164),
        (0.683, 4, 1.142464978621401),
        (0.99, 1, 63.65674116287158),
        (0.8, 7, 1.414923927650508),
    ];

    #[test]
    fn a_level_that_is_no_probability_is_refused() {
        for level in [0.0, 1.0, -0.3, 95.0, f64::NAN] {
            assert!(matches!(quantile(level, 4), Err(Fault::Level(_))), "{level}");
        }
    }
}
