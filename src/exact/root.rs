//! The root of an increasing function, by bisection over the doubles themselves.
//!
//! The bit patterns of the non-negative doubles are ordered as the doubles are, so halving the
//! interval of bit patterns ends at two neighbouring doubles after at most 63 steps, whatever the
//! magnitude of the root: no tolerance, no starting value, no failure to converge.

/// The smallest double x in (0, `high`] with `increasing`(x) ≥ `target`; `None` if there is none.
///
/// `increasing` must not decrease on the interval, and be below `target` at 0.
pub(super) fn first_reaching(
    target: f64,
    high: f64,
    increasing: impl Fn(f64) -> f64,
) -> Option<f64> {
    let reaches = |x: f64| increasing(x) >= target;
    if !reaches(high) {
        return None;
    }
    Some(first_where(0.0, high, reaches))
}

/// The smallest double x in (`low`, `high`] at which `holds`, for 0 ≤ `low` ≤ `high`.
///
/// `holds` must be true at `high`, and from its first true x on.
pub(super) fn first_where(low: f64, high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut below, mut holding) = (low.to_bits(), high.to_bits());
    while holding.saturating_sub(below) > 1 {
        let middle = below + (holding - below) / 2;
        if holds(f64::from_bits(middle)) {
            holding = middle;
        } else {
            below = middle;
        }
    }
    f64::from_bits(holding)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn root_is_exact_to_the_last_bit_at_any_magnitude() {
        // x ↦ 3x rounds monotonically, so the first double that reaches 3·a is a or one of the
        // few below it whose triple rounds to the same double: a distance of at most one ulp.
        for root in [4.731e-300, 8.13e-17, 0.731, 5.77e12, 3.19e300] {
            let found = first_reaching(3.0 * root, f64::MAX, |x| 3.0 * x).unwrap();
            assert!(root.to_bits() - found.to_bits() <= 1, "{found} is not {root}");
        }
    }

    #[test]
    fn value_that_is_never_reached_has_no_root() {
        assert_eq!(first_reaching(2.71, 1.37, |x| x * x), None);
        // At the end of the interval exactly: 1.37² is reached by 1.37 or its lower neighbour.
        let found = first_reaching(1.37 * 1.37, 1.37, |x| x * x).unwrap();
        assert!(1.37_f64.to_bits() - found.to_bits() <= 1);
    }
}
