//! Laws that are polynomials of engineering strain.

use super::elastic::{Elastic, LawError, checked};
use super::root::{first_reaching, first_where};
use super::wave::{Kind, Piece};
use super::{gauss, hull};

/// T = E₁ε + E₂ε² + … + Eₙεⁿ.
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomial {
    density: f64,
    /// E₁, E₂, …
    coefficients: Vec<f64>,
    /// Coefficients of T′ from the constant one on.
    slope: Vec<f64>,
    /// Coefficients of T″.
    curvature: Vec<f64>,
    /// Where T″ changes its sign, at ε > 0.
    inflections: Vec<f64>,
    greatest: f64,
}

impl Polynomial {
    /// The law of density ρ (kg/m³) and coefficients E₁, E₂, … (Pa).
    pub fn new(density: f64, coefficients: &[f64]) -> Result<Self, LawError> {
        let modulus = *coefficients.first().ok_or(LawError::NoCoefficient)?;
        checked(density, coefficients, modulus)?;
        let slope: Vec<f64> =
            coefficients.iter().enumerate().map(|(i, e)| (i + 1) as f64 * e).collect();
        let curvature = derivative(&slope);
        // Up to here no sum of terms of T or λT′ exceeds 1e150.
        let terms: Vec<f64> = slope.iter().map(|e| e.abs()).collect();
        let highest = first_reaching(1e150, 1e150, |x| x * value(&terms, x)).unwrap_or(1e150);
        let highest = sign_changes(&slope, highest).first().map_or(highest, |x| x.next_down());
        let inflections = sign_changes(&curvature, highest);
        let coefficients = coefficients.to_vec();
        let mut law =
            Self { density, coefficients, slope, curvature, inflections, greatest: highest };
        law.greatest = law.limit_of_kinks(highest);
        Ok(law)
    }

    /// Where T″ changes its sign, at 0 < ε, up to the first root of T′.
    pub(super) fn inflections(&self) -> &[f64] {
        &self.inflections
    }

    /// T″(ε), Pa.
    pub(super) fn curvature(&self, strain: f64) -> f64 {
        value(&self.curvature, strain)
    }

    /// (T(q) − T(p))/(q − p), Pa, without a difference; T′(p) if q = p.
    ///
    /// It is the polynomial that is left when T − T(p) is divided by ε − p.
    pub(super) fn chord(&self, p: f64, q: f64) -> f64 {
        let (mut tension, mut chord) = (0.0, 0.0);
        for e in self.coefficients.iter().rev() {
            chord = chord * q + tension;
            tension = tension * p + e;
        }
        chord * q + tension
    }

    /// √(T′(ε)/ρ), m/s.
    fn speed(&self, strain: f64) -> f64 {
        (self.tangent_modulus(strain) / self.density).sqrt()
    }

    /// The fan or shock between two strains.
    pub(super) fn piece(&self, kind: Kind, from: f64, to: f64) -> Piece {
        let (speeds, velocity) = match kind {
            Kind::Shock => {
                let speed = (self.chord(from, to) / self.density).sqrt();
                ((speed, speed), (to - from) * speed)
            }
            Kind::Fan => {
                let (first, last) = (self.speed(from), self.speed(to));
                ((first, last), self.through_fan(from, to))
            }
        };
        Piece { kind, from, to, speeds, velocity }
    }

    /// ∫√(T′/ρ) dε through a fan, m/s.
    ///
    /// For T = E₁ε + E₂ε² it is (r₂³ − r₁³)ρ/(3E₂) with r = √(T′/ρ), and
    /// `r₂² − r₁² = 2E₂[ε]/ρ` takes the difference out of it.
    fn through_fan(&self, from: f64, to: f64) -> f64 {
        if self.coefficients.len() <= 2 {
            let (first, last) = (self.speed(from), self.speed(to));
            let squares = first * first + first * last + last * last;
            (to - from) * squares / (1.5 * (first + last))
        } else {
            gauss::integral(from, to, &|strain| self.speed(strain))
        }
    }

    /// The first strain up to `highest` at which a kink is as fast as the end of a loading wave.
    ///
    /// Behind a shock λT̂′ − T grows with strain, behind a fan it falls. So it is least where a fan
    /// ends, at an inflection or at `highest`, and its first root lies before the first of these at
    /// which it is negative.
    fn limit_of_kinks(&self, highest: f64) -> f64 {
        let caught = |strain: f64| {
            let pieces = self.pieces(0.0, strain);
            pieces.last().is_some_and(|last| {
                last.kind == Kind::Fan && self.kink_speed(strain) > last.speeds.1
            })
        };
        let mut ends = self.inflections.iter().copied().chain([highest]);
        ends.find(|&end| caught(end)).map_or(highest, |end| first_where(0.0, end, caught))
    }
}

impl Elastic for Polynomial {
    fn density(&self) -> f64 {
        self.density
    }

    fn tension(&self, strain: f64) -> f64 {
        strain * value(&self.coefficients, strain)
    }

    fn tangent_modulus(&self, strain: f64) -> f64 {
        value(&self.slope, strain)
    }

    /// ½E₁ε² + ⅓E₂ε³ + …
    fn stored_energy(&self, strain: f64) -> f64 {
        let terms = self.coefficients.iter().enumerate().rev();
        strain * strain * terms.fold(0.0, |sum, (i, e)| sum * strain + e / (i + 2) as f64)
    }

    fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        let (low, high) = (from.min(to), from.max(to));
        if self.inflections.iter().any(|&x| low < x && x < high) {
            return hull::pieces(self, from, to);
        }
        let bend = self.curvature(low + (high - low) / 2.0);
        let kind = if bend * (to - from) < 0.0 { Kind::Fan } else { Kind::Shock };
        vec![self.piece(kind, from, to)]
    }

    fn greatest_strain(&self) -> f64 {
        self.greatest
    }
}

/// Σ cₖxᵏ, by Horner's rule.
fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

fn derivative(coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect()
}

/// Where Σ cₖxᵏ changes its sign in (0, `high`), in order.
///
/// Between two sign changes of its derivative the polynomial is monotone, so each interval that
/// starts and ends with different signs has one. An interval end that is itself a root is passed
/// over, which joins its two intervals.
fn sign_changes(coefficients: &[f64], high: f64) -> Vec<f64> {
    if coefficients.len() < 2 {
        return Vec::new();
    }
    let mut roots = Vec::new();
    let mut last: Option<(f64, bool)> = None;
    let turns = sign_changes(&derivative(coefficients), high);
    for x in [0.0].into_iter().chain(turns).chain([high]) {
        let there = value(coefficients, x);
        if there == 0.0 {
            continue;
        }
        let positive = there > 0.0;
        if let Some((low, _)) = last.filter(|&(_, before)| before != positive) {
            roots.push(first_where(low, x, |x| (value(coefficients, x) > 0.0) == positive));
        }
        last = Some((x, positive));
    }
    roots
}

#[cfg(test)]
mod tests;
