//! Polynomial strain hardening.

use super::Law;
use super::parameter::{ParameterError, finite, not_empty, positive};
use crate::number::Number;

/// σ = E₁ε + E₂ε² + … + Eₙεⁿ.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial<S> {
    coefficients: Vec<S>,
    /// E₁, 2E₂, 3E₃, …
    slope: Vec<S>,
    /// E₁/2, E₂/3, …
    energy: Vec<S>,
}

impl<S: Number> Polynomial<S> {
    /// The law with the coefficients E₁ > 0, E₂, …, Pa.
    pub fn new(coefficients: &[f64]) -> Result<Self, ParameterError> {
        not_empty("coefficients", coefficients)?;
        let coefficients = coefficients
            .iter()
            .enumerate()
            .map(|(i, &e)| {
                let check = if i == 0 { positive } else { finite };
                check(&format!("coefficients[{i}]"), e)
            })
            .collect::<Result<Vec<S>, _>>()?;
        let numbered = || coefficients.iter().enumerate();
        let slope = numbered().map(|(i, &e)| S::count(i + 1) * e).collect();
        let energy = numbered().map(|(i, &e)| e / S::count(i + 2)).collect();
        Ok(Self { coefficients, slope, energy })
    }
}

/// Σ cₖxᵏ, by Horner's rule.
#[inline(always)]
fn value<S: Number>(coefficients: &[S], x: S) -> S {
    coefficients.iter().rev().fold(S::zero(), |sum, &c| sum * x + c)
}

impl<S: Number> Law<S> for Polynomial<S> {
    fn prepared(self, _time_step: S) -> Self {
        self
    }

    fn memory(&self) -> usize {
        0
    }

    #[inline]
    fn stress(&self, _before: S, now: S, _memory: &mut [S]) -> S {
        value(&self.coefficients, now) * now
    }

    #[inline]
    fn tangent_modulus(&self, _before: S, now: S, _memory: &[S]) -> S {
        value(&self.slope, now)
    }

    /// E₁ + 2E₂ε + 3E₃ε² + …, which a softening law makes negative at some strain: there it has
    /// no waves.
    #[inline]
    fn instantaneous_modulus(&self, strain: S, _memory: &[S]) -> S {
        value(&self.slope, strain)
    }

    fn can_outgrow_the_step(&self) -> bool {
        self.coefficients[1..].iter().any(|&e| e != S::zero())
    }

    /// ½E₁ε² + ⅓E₂ε³ + …
    fn stored(&self, strain: S, _memory: &[S]) -> S {
        value(&self.energy, strain) * strain * strain
    }

    fn dissipated(&self, _memory: &[S]) -> S {
        S::zero()
    }

    #[inline]
    fn taut_strain(&self, _before: S, now: S, _memory: &[S]) -> S {
        now.max(S::zero())
    }
}
