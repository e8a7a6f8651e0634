//! Exponential strain hardening.

use super::Law;
use super::decay::exp_m1_less_itself;
use super::parameter::{ParameterError, finite, positive};
use crate::number::Number;

/// σ = a(exp(bε) − 1): hardening for a, b > 0, softening for a, b < 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential<S> {
    a: S,
    b: S,
}

impl<S: Number> Exponential<S> {
    /// The law with a (Pa) and b, of the same sign.
    pub fn new(a: f64, b: f64) -> Result<Self, ParameterError> {
        let law = Self { a: finite("a", a)?, b: finite("b", b)? };
        positive::<S>("a*b", a * b)?;
        Ok(law)
    }
}

impl<S: Number> Law<S> for Exponential<S> {
    fn prepared(self, _time_step: S) -> Self {
        self
    }

    fn memory(&self) -> usize {
        0
    }

    #[inline]
    fn stress(&self, _before: S, now: S, _memory: &mut [S]) -> S {
        self.a * (self.b * now).exp_m1()
    }

    #[inline]
    fn tangent_modulus(&self, _before: S, now: S, _memory: &[S]) -> S {
        self.a * self.b * (self.b * now).exp()
    }

    #[inline]
    fn instantaneous_modulus(&self, strain: S, _memory: &[S]) -> S {
        self.a * self.b * (self.b * strain).exp()
    }

    fn can_outgrow_the_step(&self) -> bool {
        true
    }

    /// (a/b)(exp(y) − 1 − y) with y = bε.
    fn stored(&self, strain: S, _memory: &[S]) -> S {
        self.a / self.b * exp_m1_less_itself(self.b * strain)
    }

    fn dissipated(&self, _memory: &[S]) -> S {
        S::zero()
    }

    #[inline]
    fn taut_strain(&self, _before: S, now: S, _memory: &[S]) -> S {
        now.max(S::zero())
    }
}
