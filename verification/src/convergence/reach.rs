//! The mesh on which a fitted law comes to a wanted error.

use crossfibre::number::Number;
use serde::{Deserialize, Serialize};

use super::{Fault, PowerLaw};

/// A mesh against those that the law was fitted to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Where {
    /// Between the coarsest and the finest.
    Measured,
    /// Extrapolated: so many times as fine as the finest.
    Finer(f64),
    /// Extrapolated: so many times as coarse as the coarsest.
    Coarser(f64),
}

/// The spacing on which a law comes to a wanted error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reach {
    /// h with C hᵖ = wanted.
    pub spacing: f64,
    /// The spacings between which the line may have the wanted error, at the law's level, finest
    /// first. None if the interval of p holds zero: then any spacing may.
    pub between: Option<(f64, f64)>,
    /// Whether the spacing was measured.
    pub place: Where,
}

/// Whole numbers of elements. As doubles: an extrapolation may be beyond what can be counted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Elements {
    /// As many as the law asks for.
    pub best: f64,
    /// The fewest and the most that its interval allows.
    pub between: Option<(f64, f64)>,
}

impl PowerLaw {
    /// The spacing on which the law comes to a wanted value.
    ///
    /// With d = ln h − mean ln h, Y = ln wanted − mean ln value, w the half width of the interval of p
    /// and σ² the mean square of d over the points, the line has the value Y, at the level of the
    /// law, for all d with |Y − p d| ≤ w √(σ² + d²), that is (Fieller, 1940) between
    ///
    /// d = (p Y ± w √(Y² + (p² − w²) σ²)) / (p² − w²),    if w < |p|.
    ///
    /// This is the interval of the line. A single mesh lies off the line by [`PowerLaw::scatter`]
    /// besides. It is as good as the assumptions of the law's own interval, and an extrapolation adds
    /// one: that the law goes on.
    ///
    /// # Errors
    /// A wanted value that is not positive and finite; a spacing, or a bound of it, that is beyond the
    /// range of the numbers, as of a law without slope.
    pub fn reach(&self, wanted: f64) -> Result<Reach, Fault> {
        if !(wanted.is_finite() && wanted > 0.0) {
            return Err(Fault::Wanted(wanted));
        }
        let (p, w) = (self.order, self.half_width);
        let y = Number::ln(wanted) - self.mean_ln_value;
        let spacing = self.away(y / p)?;
        let leading = (p - w) * (p + w);
        let between = if leading > 0.0 {
            let root = w * (y * y + leading * self.variance_ln_spacing).sqrt();
            let (a, b) =
                (self.away((p * y - root) / leading)?, self.away((p * y + root) / leading)?);
            Some((a.min(b), a.max(b)))
        } else {
            None
        };
        let place = if spacing < self.finest {
            Where::Finer(self.finest / spacing)
        } else if spacing > self.coarsest {
            Where::Coarser(spacing / self.coarsest)
        } else {
            Where::Measured
        };
        Ok(Reach { spacing, between, place })
    }

    /// The spacing whose logarithm is so far from the mean.
    fn away(&self, d: f64) -> Result<f64, Fault> {
        let spacing = Number::exp(self.mean_ln_spacing + d);
        if spacing.is_finite() && spacing > 0.0 { Ok(spacing) } else { Err(Fault::OutOfRange) }
    }
}

impl Reach {
    /// How many elements a length takes, of no greater spacing.
    pub fn elements(&self, length: f64) -> Elements {
        // The spacing is good to some roundings: 100.000000000001 elements are 100.
        let count = |spacing: f64| (length / spacing * (1.0 - 1e-11)).ceil();
        Elements {
            best: count(self.spacing),
            between: self.between.map(|(finest, coarsest)| (count(coarsest), count(finest))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::power_law;
    use super::super::synthetic::{SPACINGS, ladder, normal, power};
    use super::*;
    use crate::random::SplitMix;

    #[test]
    fn the_mesh_of_an_exact_law_is_the_one_that_its_formula_names() {
        let law = power_law(&ladder(&SPACINGS, |h| 0.0371 * power(h, 0.61)), 0.95).unwrap();
        for (h, place) in
            [(0.0434, Where::Finer(5.0)), (1.9, Where::Measured), (6.2, Where::Coarser(2.0))]
        {
            let reach = law.reach(0.0371 * power(h, 0.61)).unwrap();
            // Roundings of logarithms up to 4, over an order of 0.61.
            assert!((reach.spacing / h - 1.0).abs() < 1e-13, "{}", reach.spacing);
            let (finest, coarsest) = reach.between.unwrap();
            assert!(finest <= reach.spacing && reach.spacing <= coarsest);
            assert!(coarsest / finest < 1.0 + 1e-12);
            match (reach.place, place) {
                (Where::Measured, Where::Measured) => {}
                (Where::Finer(found), Where::Finer(made))
                | (Where::Coarser(found), Where::Coarser(made)) => {
                    assert!((found / made - 1.0).abs() < 1e-13, "{found}");
                }
                other => panic!("{other:?}"),
            }
            // 137 elements of this length, and 138 where they must be a little shorter.
            assert_eq!(reach.elements(137.0 * h).best, 137.0);
            assert_eq!(reach.elements(137.001 * h).best, 138.0);
        }
    }

    /// The band of confidence about the line, by another program (mpmath, 30 digits), cut with the
    /// wanted error by a root finder: no formula of Fieller's.
    #[test]
    fn the_interval_is_where_the_band_about_the_line_holds_the_wanted_error() {
        let points =
            [(2.3, 0.0417), (1.45, 0.0263), (0.93, 0.0221), (0.52, 0.0129), (0.31, 0.0101)];
        let reach = power_law(&points, 0.95).unwrap().reach(0.003).unwrap();
        let (finest, coarsest) = reach.between.unwrap();
        let Where::Finer(factor) = reach.place else { panic!("{:?}", reach.place) };
        // The quantile of t is good to ten digits.
        for (found, expected) in [
            (reach.spacing, 0.0593202758184241),
            (finest, 0.02566936536119644),
            (coarsest, 0.1007076719112081),
            (factor, 5.2258691606372825),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
        }
        // 0.3 m of them.
        let elements = reach.elements(0.3);
        assert_eq!(elements, Elements { best: 6.0, between: Some((3.0, 12.0)) });
    }

    #[test]
    fn an_interval_of_95_per_cent_holds_the_true_mesh_95_times_of_100() {
        let mut random = SplitMix::new(77_031);
        let held = (0..2000)
            .filter(|_| {
                let points = ladder(&SPACINGS, |h| {
                    0.0371 * power(h, 0.61) * Number::exp(0.11 * normal(&mut random))
                });
                let law = power_law(&points, 0.95).unwrap();
                let (finest, coarsest) =
                    law.reach(0.0371 * power(0.053, 0.61)).unwrap().between.unwrap();
                finest <= 0.053 && 0.053 <= coarsest
            })
            .count();
        // Binomial, 2000 throws with 0.95: 0.05 % beyond each end.
        assert!((1867..=1931).contains(&held), "{held}");
    }

    #[test]
    fn a_law_whose_order_may_be_zero_bounds_no_mesh() {
        let points = [(2.3, 0.041), (1.4, 0.026), (0.9, 0.044), (0.5, 0.024)];
        let law = power_law(&points, 0.95).unwrap();
        assert!(law.half_width > law.order && law.order > 0.0, "{law:?}");
        assert_eq!(law.reach(0.02).unwrap().between, None);
    }

    #[test]
    fn a_cost_that_rises_with_refinement_is_inverted_as_well() {
        let law = power_law(&ladder(&SPACINGS, |h| 3.7e4 * power(h, -2.0)), 0.95).unwrap();
        let reach = law.reach(3.7e4 / (0.11 * 0.11)).unwrap();
        assert!((reach.spacing / 0.11 - 1.0).abs() < 1e-13, "{}", reach.spacing);
    }

    #[test]
    fn what_cannot_be_reached_is_said() {
        let law = power_law(&ladder(&SPACINGS, |h| 0.0371 * power(h, 0.01)), 0.95).unwrap();
        assert_eq!(law.reach(0.0), Err(Fault::Wanted(0.0)));
        assert!(matches!(law.reach(f64::NAN), Err(Fault::Wanted(_))));
        // A hundredth of the error with an order of 0.01: 1e-200 would do, 1e-5000 is no number.
        assert!(law.reach(0.000371).is_ok());
        assert_eq!(law.reach(1e-52), Err(Fault::OutOfRange));
        assert_eq!(law.reach(1e52), Err(Fault::OutOfRange));
        assert_eq!(law.reach(f64::INFINITY), Err(Fault::Wanted(f64::INFINITY)));
        let flat = power_law(&[(2.0, 0.3), (1.0, 0.3), (0.5, 0.3)], 0.95).unwrap();
        assert_eq!(flat.reach(0.1), Err(Fault::OutOfRange));
    }
}
