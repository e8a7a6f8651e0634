//! Eqn (7).

use super::Law;
use super::parameter::{ParameterError, positive};
use crate::number::Number;

/// **(7)** σ = E ε.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear<S> {
    modulus: S,
}

impl<S: Number> Linear<S> {
    /// The law with Young's modulus E, Pa.
    pub fn new(modulus: f64) -> Result<Self, ParameterError> {
        Ok(Self { modulus: positive("modulus", modulus)? })
    }
}

impl<S: Number> Law<S> for Linear<S> {
    fn prepared(self, _time_step: S) -> Self {
        self
    }

    fn memory(&self) -> usize {
        0
    }

    #[inline(always)]
    fn stress(&self, _before: S, now: S, _memory: &mut [S]) -> S {
        self.modulus * now
    }

    #[inline]
    fn tangent_modulus(&self, _before: S, _now: S, _memory: &[S]) -> S {
        self.modulus
    }

    #[inline]
    fn instantaneous_modulus(&self, _strain: S, _memory: &[S]) -> S {
        self.modulus
    }

    /// ½Eε².
    fn stored(&self, strain: S, _memory: &[S]) -> S {
        S::half() * self.modulus * strain * strain
    }

    fn dissipated(&self, _memory: &[S]) -> S {
        S::zero()
    }

    #[inline]
    fn taut_strain(&self, _before: S, now: S, _memory: &[S]) -> S {
        now.max(S::zero())
    }
}
