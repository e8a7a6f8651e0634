//! The limit of values on three meshes, and the grid convergence index.

use crossfibre::number::Number;
use serde::{Deserialize, Serialize};

use super::Fault;
use super::fault::{descending, enough};

/// How values on three meshes go on, by the sign of ε32/ε21 and the order p that solves for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Trend {
    /// Differences of one sign that fall: ε32/ε21 > 0 and p > 0.
    Monotone,
    /// Differences that alternate and fall: ε32/ε21 < 0 and p > 0.
    Oscillatory,
    /// Differences of one sign that do not fall: ε32/ε21 > 0 and p ≤ 0.
    MonotoneDivergence,
    /// Differences that alternate and do not fall: ε32/ε21 < 0 and p ≤ 0.
    OscillatoryDivergence,
}

/// The safety factor of a grid convergence index (Roache, 1994, 1998).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Safety {
    /// 1.25: three meshes or more, known to be in the asymptotic range (by [`super::of_values`], or by
    /// an order that theory gives). The three meshes of an extrapolation do not show it themselves: an
    /// order that is solved from them always fits them.
    Asymptotic,
    /// 3: all else, and everything oscillatory.
    Unproven,
}

impl Safety {
    /// The factor.
    pub fn factor(self) -> f64 {
        match self {
            Self::Asymptotic => 1.25,
            Self::Unproven => 3.0,
        }
    }
}

/// What the three finest meshes say. Index 1 is the finest, as in the sources.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Richardson {
    /// How the values go on.
    pub trend: Trend,
    /// p, the observed order.
    pub order: f64,
    /// The limit, if there is one.
    pub extrapolation: Option<Extrapolation>,
}

/// A limit by Richardson's extrapolation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Extrapolation {
    /// φ_ext = (r21ᵖ φ1 − φ2)/(r21ᵖ − 1).
    ///
    /// For an oscillatory trend the sources use the same formula. Errors ∓C hᵖ that alternate have
    /// their limit at φ1 + (φ2 − φ1)/(r21ᵖ + 1) instead, on the other side of φ1; it lies within
    /// [`Extrapolation::uncertainty`] with [`Safety::Unproven`], for any order.
    pub limit: f64,
    /// φ1, the value on the finest mesh.
    pub finest: f64,
    /// |φ1 − φ2|, the difference of the two finest.
    pub difference: f64,
    /// |φ_ext − φ1| = |φ1 − φ2|/(r21ᵖ − 1).
    pub correction: f64,
}

impl Extrapolation {
    /// e_a = |(φ1 − φ2)/φ1|, the approximate relative error; none of a φ1 of zero.
    pub fn approximate_error(&self) -> Option<f64> {
        relative(self.difference, self.finest)
    }

    /// e_ext = |(φ_ext − φ1)/φ_ext|, the extrapolated relative error; none of a limit of zero.
    pub fn extrapolated_error(&self) -> Option<f64> {
        relative(self.correction, self.limit)
    }

    /// GCI = F e_a/(r21ᵖ − 1), relative to φ1; none of a φ1 of zero.
    pub fn grid_convergence_index(&self, safety: Safety) -> Option<f64> {
        relative(self.uncertainty(safety), self.finest)
    }

    /// F |φ_ext − φ1|, the index as a number in the unit of the values. The sources draw it about φ1;
    /// drawn about the limit it holds φ1 as well.
    pub fn uncertainty(&self, safety: Safety) -> f64 {
        safety.factor() * self.correction
    }
}

fn relative(size: f64, of: f64) -> Option<f64> {
    let quotient = (size / of).abs();
    quotient.is_finite().then_some(quotient)
}

/// Richardson's extrapolation over the three finest of (h, value), coarse to fine, with any refinement
/// ratios.
///
/// With ε32 = φ3 − φ2, ε21 = φ2 − φ1, r21 = h2/h1, r32 = h3/h2 and s the sign of ε32/ε21, the order
/// solves
///
/// p ln r21 = ln|ε32/ε21| + q(p),    q(p) = ln((r21ᵖ − s)/(r32ᵖ − s)).
///
/// Sources: Roache, J. Fluids Eng. 116 (1994) 405; Celik, Ghia, Roache, Freitas, Coleman and Raad,
/// J. Fluids Eng. 130 (2008) 078001. They iterate on p and take the size of the right-hand side,
/// which gives values that diverge a positive order. Here the sign is kept. Written as |ε32/ε21| =
/// (r32ᵖ − s)/(1 − s r21⁻ᵖ), the right-hand side rises from 0 to ∞ with p, so that there is one root
/// for any three values, found by bisection, and its sign tells convergence from divergence. With
/// ratios that are not equal that is no question of |ε32/ε21| > 1: values of one sign converge if it
/// is above ln r32/ln r21.
///
/// # Errors
/// Fewer than three meshes, a mesh that is not finer than the one before, a value that is not finite,
/// two successive values that are equal, a limit beyond the range of the numbers.
pub fn richardson(values: &[(f64, f64)]) -> Result<Richardson, Fault> {
    enough(values, 3)?;
    descending(values)?;
    let three = &values[values.len() - 3..];
    let order = order(three).map_err(|fault| match fault {
        Fault::SameValue { index } => Fault::SameValue { index: index + values.len() - 3 },
        other => other,
    })?;
    let [(_, phi3), (h2, phi2), (h1, phi1)] = [three[0], three[1], three[2]];
    let alternates = (phi3 - phi2 > 0.0) != (phi2 - phi1 > 0.0);
    let trend = match (alternates, order > 0.0) {
        (false, true) => Trend::Monotone,
        (true, true) => Trend::Oscillatory,
        (false, false) => Trend::MonotoneDivergence,
        (true, false) => Trend::OscillatoryDivergence,
    };
    let extrapolation = if order > 0.0 {
        // (r21ᵖ φ1 − φ2)/(r21ᵖ − 1) = φ1 + (φ1 − φ2)/(r21ᵖ − 1), without the difference of two
        // large numbers.
        let correction = (phi1 - phi2) / Number::exp_m1(order * Number::ln(h2 / h1));
        let limit = phi1 + correction;
        if !limit.is_finite() {
            return Err(Fault::OutOfRange);
        }
        let (difference, correction) = ((phi1 - phi2).abs(), correction.abs());
        Some(Extrapolation { limit, finest: phi1, difference, correction })
    } else {
        None
    };
    Ok(Richardson { trend, order, extrapolation })
}

/// The observed order of three values, positive or negative: see [`richardson`].
pub(super) fn order(three: &[(f64, f64)]) -> Result<f64, Fault> {
    let [(h3, phi3), (h2, phi2), (h1, phi1)] = [three[0], three[1], three[2]];
    let (e32, e21) = (phi3 - phi2, phi2 - phi1);
    for (index, phi, difference) in [(1, phi2, e32), (2, phi1, e21)] {
        if difference == 0.0 {
            return Err(Fault::SameValue { index });
        }
        if !difference.is_finite() {
            return Err(Fault::NotFinite { index, value: phi });
        }
    }
    let s = if (e32 > 0.0) == (e21 > 0.0) { 1.0 } else { -1.0 };
    let wanted = Number::ln(e32.abs()) - Number::ln(e21.abs());
    let (a, b) = (Number::ln(h2 / h1), Number::ln(h3 / h2));
    Ok(root(|p| ln_ratio(s, a, b, p) - wanted))
}

/// ln((r32ᵖ − s)/(1 − s r21⁻ᵖ)) with a = ln r21 and b = ln r32, for any p.
fn ln_ratio(s: f64, a: f64, b: f64, p: f64) -> f64 {
    if p == 0.0 {
        // The limits: b/a for s = 1, 2/2 for s = −1.
        return if s > 0.0 { Number::ln(b / a) } else { 0.0 };
    }
    // ln(1 − s exp(−x)) for x > 0. The exponentials that would overflow are taken out.
    let rest = |x: f64| {
        if s > 0.0 { Number::ln(-Number::exp_m1(-x)) } else { Number::ln_1p(Number::exp(-x)) }
    };
    let (growth, size) = if p > 0.0 { (b * p, p) } else { (a * p, -p) };
    growth + rest(b * size) - rest(a * size)
}

/// The root of a function that rises from −∞ to ∞, by bisection to the last bit.
fn root(of: impl Fn(f64) -> f64) -> f64 {
    /// 2^±1000 is beyond any order, and beyond any root that a double can hold.
    const DOUBLINGS: usize = 1000;
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..DOUBLINGS {
        if of(high) < 0.0 {
            high *= 2.0;
        } else if of(low) > 0.0 {
            low *= 2.0;
        } else {
            break;
        }
    }
    loop {
        let middle = 0.5 * (low + high);
        // A root at zero would be approached through all powers of two.
        if middle == low || middle == high || high - low < f64::MIN_POSITIVE {
            return middle;
        }
        if of(middle) < 0.0 { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::super::synthetic::{SPACINGS, ladder, power};
    use super::*;

    /// Table 1 of Celik et al. (2008): three quantities of a backward-facing step on three meshes.
    struct Published {
        values: [f64; 3],
        ratios: [f64; 2],
        trend: Trend,
        order: f64,
        limit: f64,
        /// e_a, e_ext and GCI, per cent.
        errors: [f64; 3],
    }

    const PUBLISHED: [Published; 3] = [
        Published {
            values: [6.063, 5.972, 5.863],
            ratios: [1.5, 1.333],
            trend: Trend::Monotone,
            order: 1.53,
            limit: 6.1685,
            errors: [1.5, 1.7, 2.2],
        },
        Published {
            values: [10.7880, 10.7250, 10.6050],
            ratios: [2.0, 2.143],
            trend: Trend::Monotone,
            order: 0.75,
            limit: 10.8801,
            errors: [0.6, 0.9, 1.1],
        },
        Published {
            values: [6.0042, 5.9624, 6.0909],
            ratios: [2.0, 2.143],
            trend: Trend::Oscillatory,
            order: 1.51,
            limit: 6.0269,
            errors: [0.7, 0.4, 0.5],
        },
    ];

    #[test]
    fn the_published_example_comes_out_to_its_digits() {
        for row in PUBLISHED {
            let [phi1, phi2, phi3] = row.values;
            let [r21, r32] = row.ratios;
            let found = richardson(&[(r32 * r21, phi3), (r21, phi2), (1.0, phi1)]).unwrap();
            let limit = found.extrapolation.unwrap();
            assert_eq!(found.trend, row.trend);
            // Half of the last digit printed; 1.333 is 4/3 in print, which moves p by 0.003 and the
            // limit by 0.0003.
            assert!((found.order - row.order).abs() < 0.008, "{}", found.order);
            assert!((limit.limit - row.limit).abs() < 0.0004, "{}", limit.limit);
            let errors = [
                limit.approximate_error(),
                limit.extrapolated_error(),
                limit.grid_convergence_index(Safety::Asymptotic),
            ];
            for (found, printed) in errors.into_iter().zip(row.errors) {
                let found = 100.0 * found.unwrap();
                // Half of a digit; the 0.9 is 0.847 of numbers that were rounded on the way.
                assert!((found - printed).abs() < 0.055, "{found} {printed}");
            }
        }
    }

    /// The first column with ratios 3/2 and 4/3, by another program (a few lines of Python that bisect
    /// the equation as it is printed): not only to the digits of the print.
    #[test]
    fn all_numbers_of_an_extrapolation_are_those_of_another_program() {
        let found = richardson(&[(2.0, 5.863), (1.5, 5.972), (1.0, 6.063)]).unwrap();
        let limit = found.extrapolation.unwrap();
        for (found, expected) in [
            (found.order, 1.5339690206281957),
            (limit.limit, 6.168495572330159),
            (limit.approximate_error().unwrap(), 0.015009071416790254),
            (limit.extrapolated_error().unwrap(), 0.01710231791417311),
            (limit.grid_convergence_index(Safety::Asymptotic).unwrap(), 0.021749870594210817),
            // The index of 1.25 times e_a, in the unit of the values and with 3.
            (limit.uncertainty(Safety::Unproven), 0.021749870594210817 / 1.25 * 3.0 * 6.063),
        ] {
            // Rounding of 6 over differences of 0.09, twice.
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn a_limit_and_an_order_are_found_again_whatever_the_ratios() {
        for p in [0.29, 2.0 / 3.0, 1.87, 4.1] {
            let values = ladder(&SPACINGS, |h| 1.4430 - 0.0371 * power(h, p));
            let found = richardson(&values).unwrap();
            let limit = found.extrapolation.unwrap();
            // Rounding of values of 1.4, over differences of 1e-4 (order 4.1) or more.
            assert_eq!(found.trend, Trend::Monotone);
            assert!((found.order / p - 1.0).abs() < 1e-11, "{}", found.order);
            assert!((limit.limit / 1.4430 - 1.0).abs() < 1e-13, "{}", limit.limit);
        }
    }

    /// Differences of 2 and 3 on meshes of ratios 1.2 and 2: larger on the coarse meshes, and yet the
    /// values diverge, since |ε32/ε21| is below ln 2/ln 1.2 = 3.8.
    #[test]
    fn divergence_is_told_from_convergence_when_ratios_are_not_equal() {
        let found = richardson(&[(2.4, 1.0), (1.2, 4.0), (1.0, 6.0)]).unwrap();
        assert_eq!((found.trend, found.extrapolation), (Trend::MonotoneDivergence, None));
        // The root of the same equation by another program (mpmath, 30 digits).
        assert!((found.order / DIVERGENT - 1.0).abs() < 1e-13, "{}", found.order);
        // Values made to diverge, and with the meshes turned round to converge.
        let values = ladder(&SPACINGS, |h| 0.31 + 0.0371 * power(h, -0.83));
        let found = richardson(&values).unwrap();
        assert_eq!((found.trend, found.extrapolation), (Trend::MonotoneDivergence, None));
        assert!((found.order / -0.83 - 1.0).abs() < 1e-12, "{}", found.order);
    }

    #[test]
    fn alternating_values_give_the_order_of_their_envelope_and_a_limit_within_the_uncertainty() {
        for (p, trend) in [(1.3, Trend::Oscillatory), (-0.7, Trend::OscillatoryDivergence)] {
            let mut sign = 1.0;
            let values = ladder(&[2.3, 1.1, 0.7], |h| {
                sign = -sign;
                0.9 + 0.0371 * sign * power(h, p)
            });
            let found = richardson(&values).unwrap();
            assert_eq!(found.trend, trend);
            // Rounding of 0.9 over differences of 0.03.
            assert!((found.order / p - 1.0).abs() < 1e-13, "{}", found.order);
            match found.extrapolation {
                Some(limit) => {
                    let off = (limit.limit - 0.9).abs();
                    assert!(off > 0.01 && off < limit.uncertainty(Safety::Unproven), "{off}");
                }
                None => assert!(p < 0.0),
            }
        }
    }

    /// Equal steps on equal ratios: the order is zero, and no limit is made of it.
    #[test]
    fn values_on_a_line_of_the_number_of_the_mesh_diverge() {
        let found = richardson(&[(4.0, 3.0), (2.0, 2.0), (1.0, 1.0)]).unwrap();
        assert_eq!((found.trend, found.extrapolation), (Trend::MonotoneDivergence, None));
        // Beside a logarithm of 33 what is smaller is lost.
        assert!(found.order.abs() < 1e-14, "{}", found.order);
    }

    #[test]
    fn values_that_have_no_order_are_refused() {
        let same = richardson(&[(9.0, 0.2), (4.1, 1.3), (2.0, 1.7), (1.0, 1.7)]);
        assert_eq!(same, Err(Fault::SameValue { index: 3 }));
        assert_eq!(
            richardson(&[(2.0, 1.0), (1.0, 1.1)]),
            Err(Fault::TooFew { found: 2, needed: 3 })
        );
        let coarser = richardson(&[(2.0, 1.0), (1.0, 1.1), (1.5, 1.2)]);
        assert_eq!(coarser, Err(Fault::NotFiner { index: 2 }));
        let huge = richardson(&[(4.0, -1e308), (2.0, 1e308), (1.0, 1.2)]);
        assert!(matches!(huge, Err(Fault::NotFinite { index: 1, .. })));
    }

    /// By the same program.
    const DIVERGENT: f64 = -2.3553683103642813;
}
