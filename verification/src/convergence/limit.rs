//! The limit of values on four meshes or more, by least squares.

use crossfibre::number::Number;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::fault::{descending, enough};
use super::line::Line;
use super::{Fault, student};

/// value = limit + C hᵖ through values on four meshes or more.
///
/// The intervals are those of linearised least squares, Student's t of n − 3 degrees of freedom times
/// the standard error. As for a [`super::PowerLaw`], they measure how far the points lie off the
/// curve, not chance, and they do not know of terms that the curve has not: where the values bend
/// otherwise than it does, the limit may lie outside. Take the limit for one only where
/// [`super::of_values`] finds the asymptotic range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limit {
    /// The value at h → 0.
    pub limit: f64,
    /// Half the width of its interval.
    pub half_width: f64,
    /// p.
    pub order: f64,
    /// Half the width of its interval.
    pub order_half_width: f64,
    /// C.
    pub coefficient: f64,
    /// Probability that t is for.
    pub level: f64,
    /// Root of the mean square of value − curve, over n − 3.
    pub scatter: f64,
}

/// The best limit, C and p of (h, value), coarse to fine, with p between two bounds.
///
/// For a given p the best limit and C are a straight line in hᵖ. What is left is a function of p
/// alone: its least value is looked for on a grid of ln p, and by golden section about the best of
/// it.
///
/// # Errors
/// Fewer than four meshes, a mesh that is not finer than the one before, a value that is not finite,
/// values that are all equal, a level outside (0, 1), bounds that are not positive and rising, a best
/// order at one of them, a result beyond the range of the numbers.
pub fn fitted_limit(values: &[(f64, f64)], orders: (f64, f64), level: f64) -> Result<Limit, Fault> {
    enough(values, 4)?;
    descending(values)?;
    let (least, most) = orders;
    if !(least > 0.0 && least < most && most.is_finite()) {
        return Err(Fault::Orders(least, most));
    }
    if values.windows(2).all(|pair| pair[0].1 == pair[1].1) {
        return Err(Fault::SameValue { index: 1 });
    }
    let order = best_order(values, orders)?;
    let line = line(values, order);
    let coarsest = values[0].0;

    let freedom = values.len() - 3;
    let scatter = (line.residual / freedom as f64).sqrt();
    let errors = standard_errors(values, order, line.slope).ok_or(Fault::OutOfRange)? * scatter;
    let t = student::quantile(level, freedom)?;
    let limit = Limit {
        limit: line.at(0.0),
        half_width: t * errors[0],
        order,
        order_half_width: t * errors[2],
        coefficient: line.slope * Number::exp(-order * Number::ln(coarsest)),
        level,
        scatter,
    };
    let whole = [limit.limit, limit.half_width, limit.order_half_width, limit.coefficient];
    if whole.iter().all(|x| x.is_finite()) { Ok(limit) } else { Err(Fault::OutOfRange) }
}

/// (h/coarsest)ᵖ: between 0 and 1, whatever the unit of h.
fn abscissa(h: f64, coarsest: f64, p: f64) -> f64 {
    Number::exp(p * Number::ln(h / coarsest))
}

/// The best straight line in (h/coarsest)ᵖ.
fn line(values: &[(f64, f64)], p: f64) -> Line {
    let coarsest = values[0].0;
    let points: Vec<_> = values.iter().map(|&(h, v)| (abscissa(h, coarsest, p), v)).collect();
    Line::through(&points)
}

/// The order with the least sum of squares.
pub(super) fn best_order(values: &[(f64, f64)], (least, most): (f64, f64)) -> Result<f64, Fault> {
    /// Steps of the grid.
    const STEPS: usize = 96;
    /// Each leaves 0.618 of a bracket; 70 leave 2e-15 of it.
    const SECTIONS: usize = 70;
    let stride = Number::ln(most / least) / STEPS as f64;
    let at = |k: usize| least * Number::exp(k as f64 * stride);
    let left = |p: f64| line(values, p).residual;
    let best = (0..=STEPS).min_by(|&j, &k| left(at(j)).total_cmp(&left(at(k)))).unwrap_or(0);
    if best == 0 || best == STEPS {
        return Err(Fault::AtTheEdge { order: at(best) });
    }
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (at(best - 1), at(best + 1));
    for _ in 0..SECTIONS {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if left(a) < left(b) { high = b } else { low = a }
    }
    Ok(0.5 * (low + high))
}

/// Standard errors of limit, C (of the line) and p, for a scatter of 1: roots of the diagonal of
/// (JᵀJ)⁻¹, where J has the derivatives of the curve by the three.
fn standard_errors(values: &[(f64, f64)], p: f64, slope: f64) -> Option<Vector3<f64>> {
    let coarsest = values[0].0;
    let squares: Matrix3<f64> = values
        .iter()
        .map(|&(h, _)| {
            let x = abscissa(h, coarsest, p);
            let row = Vector3::new(1.0, x, slope * x * Number::ln(h / coarsest));
            row * row.transpose()
        })
        .sum();
    Some(squares.try_inverse()?.diagonal().map(f64::sqrt))
}

#[cfg(test)]
mod tests {
    use super::super::synthetic::{SPACINGS, ladder, normal, power};
    use super::*;
    use crate::random::SplitMix;

    const ORDERS: (f64, f64) = (0.05, 6.0);

    #[test]
    fn a_limit_and_an_order_are_found_again() {
        for p in [0.29, 2.0 / 3.0, 1.87] {
            let values = ladder(&SPACINGS, |h| 1.4430 - 0.0371 * power(h, p));
            let found = fitted_limit(&values, ORDERS, 0.95).unwrap();
            // Rounding of 1.4 over a bend of 0.01 or so.
            assert!((found.order / p - 1.0).abs() < 1e-11, "{}", found.order);
            assert!((found.limit / 1.4430 - 1.0).abs() < 1e-12, "{}", found.limit);
            assert!((found.coefficient / -0.0371 - 1.0).abs() < 1e-10, "{}", found.coefficient);
            assert!(found.half_width < 1e-11, "{}", found.half_width);
        }
    }

    /// The same points by another program (mpmath, 40 digits): Newton's method on the derivatives of
    /// the sum of squares by all three, standard errors from (JᵀJ)⁻¹ of h itself.
    #[test]
    fn scattered_values_give_the_curve_that_another_program_finds() {
        let values = [(3.1, 1.331), (2.03, 1.362), (1.37, 1.379), (0.81, 1.403), (0.33, 1.419)];
        let found = fitted_limit(&values, ORDERS, 0.95).unwrap();
        // Golden section halves the digits: squares are flat to 1e-8 of p about their least value.
        for (found, expected) in [
            (found.limit, LIMIT),
            (found.order, ORDER),
            (found.coefficient, COEFFICIENT),
            (found.scatter, SCATTER),
            (found.half_width, HALF_WIDTH),
            (found.order_half_width, ORDER_HALF_WIDTH),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
        }
    }

    #[test]
    fn an_interval_of_95_per_cent_holds_the_true_limit_about_95_times_of_100() {
        let mut random = SplitMix::new(550_113);
        let held = (0..2000)
            .filter(|_| {
                let values = ladder(&SPACINGS, |h| {
                    1.4430 - 0.0371 * power(h, 0.91) + 2e-4 * normal(&mut random)
                });
                let found = fitted_limit(&values, ORDERS, 0.95).unwrap();
                (found.limit - 1.4430).abs() <= found.half_width
            })
            .count();
        // Binomial, 2000 throws with 0.95: 0.05 % beyond each end. At this scatter the curve is
        // nearly linear in its three numbers.
        assert!((1867..=1931).contains(&held), "{held}");
    }

    #[test]
    fn values_without_a_limit_in_the_range_are_refused() {
        let straight = ladder(&SPACINGS, |h| 0.3 + 0.2 * h);
        let edge = fitted_limit(&straight, (0.05, 0.7), 0.95);
        assert!(matches!(edge, Err(Fault::AtTheEdge { order }) if (order - 0.7).abs() < 1e-12));
        let divergent = ladder(&SPACINGS, |h| 0.3 + 0.2 * power(h, -0.6));
        assert!(matches!(fitted_limit(&divergent, ORDERS, 0.95), Err(Fault::AtTheEdge { .. })));
        let flat = ladder(&SPACINGS, |_| 0.3);
        assert_eq!(fitted_limit(&flat, ORDERS, 0.95), Err(Fault::SameValue { index: 1 }));
        let few = fitted_limit(&straight[..3], ORDERS, 0.95);
        assert_eq!(few, Err(Fault::TooFew { found: 3, needed: 4 }));
        for orders in [(0.7, 0.7), (0.0, 2.0), (-1.0, 2.0), (1.0, f64::INFINITY)] {
            let refused = fitted_limit(&straight, orders, 0.95);
            assert_eq!(refused, Err(Fault::Orders(orders.0, orders.1)));
        }
        assert_eq!(fitted_limit(&straight, ORDERS, 0.0), Err(Fault::Level(0.0)));
    }

    const LIMIT: f64 = 1.4385024473738584;
    const ORDER: f64 = 0.7780554373514204;
    const COEFFICIENT: f64 = -0.044588699407522914;
    const SCATTER: f64 = 0.002561838914293978;
    const HALF_WIDTH: f64 = 0.0345171255961386;
    const ORDER_HALF_WIDTH: f64 = 0.5096914129238659;
}
