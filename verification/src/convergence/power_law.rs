//! The power law through errors or costs on several meshes.

use crossfibre::number::Number;
use serde::{Deserialize, Serialize};

use super::Fault;
use super::fault::{enough, positive};
use super::line::Line;
use super::student;

/// value = C hᵖ, fitted by least squares on logarithms: ln value = ln C + p ln h.
///
/// **What the interval of p means.** A march is no experiment: the same mesh gives the same error to
/// the bit, and nothing here is chance. The interval measures how far the points lie off the
/// straight line. It is what Student's t would give if the departures of ln value from the line were
/// independent, normal and of one size on all meshes; for departures that are the phase of a ringing
/// tail against the mesh this is a fair picture, for a bend (a second term that has not died out)
/// it is not: then the true order at h → 0 may lie well outside, and [`super::range`] is the judge.
/// With three points it has one degree of freedom and is 13 standard errors wide each way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PowerLaw {
    /// p.
    pub order: f64,
    /// Half the width of the interval of p, t s / √Σ(ln h − mean)², with Student's t of n − 2
    /// degrees of freedom.
    pub half_width: f64,
    /// Probability that t is for, such as 0.95.
    pub level: f64,
    /// C, the value at h = 1.
    pub coefficient: f64,
    /// s = √(Σ(ln value − ln law)²/(n − 2)), the scatter of ln value about the line.
    pub scatter: f64,
    /// n, the number of points.
    pub points: usize,
    /// The finest spacing of them.
    pub finest: f64,
    /// The coarsest spacing of them.
    pub coarsest: f64,
    /// Mean of ln h.
    pub mean_ln_spacing: f64,
    /// Mean of ln value.
    pub mean_ln_value: f64,
    /// Mean of (ln h − mean)².
    pub variance_ln_spacing: f64,
}

impl PowerLaw {
    /// C hᵖ.
    pub fn at(&self, spacing: f64) -> f64 {
        let away = Number::ln(spacing) - self.mean_ln_spacing;
        Number::exp(self.mean_ln_value + self.order * away)
    }
}

/// The power law through (h, value) on at least three meshes, in any order of the meshes.
///
/// # Errors
/// Fewer than three points; a spacing or value that is not positive and finite; all spacings equal; a
/// level outside (0, 1); a C that is beyond the range of the numbers.
pub fn power_law(points: &[(f64, f64)], level: f64) -> Result<PowerLaw, Fault> {
    enough(points, 3)?;
    positive(points.iter().map(|p| p.0))?;
    positive(points.iter().map(|p| p.1))?;
    let spacings = || points.iter().map(|p| p.0);
    let (finest, coarsest) =
        (spacings().fold(f64::MAX, f64::min), spacings().fold(0.0_f64, f64::max));
    if finest == coarsest {
        return Err(Fault::OneSpacing);
    }
    let n = points.len();
    let logarithms: Vec<_> = points.iter().map(|p| (Number::ln(p.0), Number::ln(p.1))).collect();
    let line = Line::through(&logarithms);
    let scatter = (line.residual / (n - 2) as f64).sqrt();
    let law = PowerLaw {
        order: line.slope,
        half_width: student::quantile(level, n - 2)? * scatter / line.squares_x.sqrt(),
        level,
        coefficient: Number::exp(line.at(0.0)),
        scatter,
        points: n,
        finest,
        coarsest,
        mean_ln_spacing: line.mean_x,
        mean_ln_value: line.mean_y,
        variance_ln_spacing: line.squares_x / n as f64,
    };
    let whole = law.coefficient > 0.0
        && [law.order, law.half_width, law.coefficient].iter().all(|x| x.is_finite());
    if whole { Ok(law) } else { Err(Fault::OutOfRange) }
}

#[cfg(test)]
mod tests {
    use super::super::synthetic::{SPACINGS, ladder, normal, power};
    use super::*;
    use crate::random::SplitMix;

    #[test]
    fn a_power_law_is_found_again() {
        for p in [2.0 / 3.0, 0.29, -1.87] {
            let law = power_law(&ladder(&SPACINGS, |h| 0.0371 * power(h, p)), 0.95).unwrap();
            // Roundings of logarithms up to 4; the interval is made of them alone.
            assert!((law.order - p).abs() < 1e-14, "{}", law.order);
            assert!((law.coefficient / 0.0371 - 1.0).abs() < 1e-14, "{}", law.coefficient);
            assert!(law.half_width < 1e-14, "{}", law.half_width);
            assert!((law.at(0.047) / (0.0371 * power(0.047, p)) - 1.0).abs() < 2e-14);
        }
    }

    /// The same points by another program (mpmath, 30 digits, normal equations).
    #[test]
    fn scattered_points_give_the_line_that_another_program_finds() {
        let points =
            [(2.3, 0.0417), (1.45, 0.0263), (0.93, 0.0221), (0.52, 0.0129), (0.31, 0.0101)];
        let law = power_law(&points, 0.95).unwrap();
        // Some roundings; the quantile of t is good to ten digits.
        for (found, expected, tolerance) in [
            (law.order, ORDER, 1e-13),
            (law.coefficient, COEFFICIENT, 1e-13),
            (law.scatter, SCATTER, 1e-13),
            (law.half_width, HALF_WIDTH, 1e-9),
        ] {
            assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
        }
        assert_eq!((law.points, law.finest, law.coarsest), (5, 0.31, 2.3));
        // The order of the meshes is of no account.
        let mut turned = points;
        turned.reverse();
        assert!((power_law(&turned, 0.95).unwrap().order - law.order).abs() < 1e-14);
    }

    /// Scatter of the kind that the interval is exact for.
    #[test]
    fn an_interval_of_95_per_cent_holds_the_true_order_95_times_of_100() {
        let mut random = SplitMix::new(20_240_611);
        let held = (0..2000)
            .filter(|_| {
                let points = ladder(&SPACINGS, |h| {
                    0.0371 * power(h, 0.61) * Number::exp(0.23 * normal(&mut random))
                });
                let law = power_law(&points, 0.95).unwrap();
                (law.order - 0.61).abs() <= law.half_width
            })
            .count();
        // The binomial distribution of 2000 throws with 0.95 lies in this range but for 0.05 % at
        // each end.
        assert!((1867..=1931).contains(&held), "{held}");
    }

    #[test]
    fn what_is_no_ladder_is_refused() {
        let points = [(2.3, 0.041), (1.4, 0.026), (0.9, 0.022)];
        let with = |index: usize, point| {
            let mut points = points;
            points[index] = point;
            power_law(&points, 0.95)
        };
        assert_eq!(power_law(&points[..2], 0.95), Err(Fault::TooFew { found: 2, needed: 3 }));
        assert_eq!(with(1, (1.4, -0.026)), Err(Fault::NotPositive { index: 1, value: -0.026 }));
        assert_eq!(with(0, (0.0, 0.041)), Err(Fault::NotPositive { index: 0, value: 0.0 }));
        assert!(matches!(with(2, (0.9, f64::NAN)), Err(Fault::NotPositive { index: 2, .. })));
        assert!(matches!(with(2, (f64::INFINITY, 0.1)), Err(Fault::NotPositive { index: 2, .. })));
        assert_eq!(power_law(&[(1.3, 0.1), (1.3, 0.2), (1.3, 0.4)], 0.95), Err(Fault::OneSpacing));
        assert_eq!(power_law(&points, 1.0), Err(Fault::Level(1.0)));
        let steep = [(1.1e-3, 1.0), (1.2e-3, 1e200), (1.3e-3, 1e300)];
        assert_eq!(power_law(&steep, 0.95), Err(Fault::OutOfRange));
        let steep = [(1.1e3, 1e-300), (1.2e3, 1e-200), (1.3e3, 1.0)];
        assert_eq!(power_law(&steep, 0.95), Err(Fault::OutOfRange));
    }

    const ORDER: f64 = 0.7052699564313888;
    const COEFFICIENT: f64 = 0.02199602514270767;
    const SCATTER: f64 = 0.08229539203078566;
    const HALF_WIDTH: f64 = 0.16432314684278587;
}
