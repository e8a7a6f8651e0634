//! Nonlinear viscoelasticity.

use super::parameter::{ParameterError, not_negative, positive};
use super::riccati::{advance, sinh, slope};
use super::{Law, Update};
use crate::number::Number;

/// σ = E∞ε + s: an equilibrium spring beside a spring E in series with a dashpot that flows at
/// rate × sinh(s/stress), ds/dt = E dε/dt − E × rate × sinh(s/stress).
///
/// Memory: the dissipated energy (J/m³), then the stress s of the arm (Pa).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eyring<S> {
    equilibrium_modulus: S,
    modulus: S,
    rate: S,
    /// The stress by which the flow grows e-fold, Pa.
    stress: S,
    update: Update,
    /// a = E × rate × Δt/stress.
    flow: S,
}

impl<S: Number> Eyring<S> {
    /// The law with E∞ ≥ 0 (Pa; a liquid at 0), E (Pa), rate (1/s) and stress (Pa), all positive.
    pub fn new(
        equilibrium_modulus: f64,
        modulus: f64,
        rate: f64,
        stress: f64,
        update: Update,
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            equilibrium_modulus: not_negative("equilibrium_modulus", equilibrium_modulus)?,
            modulus: positive("modulus", modulus)?,
            rate: positive("rate", rate)?,
            stress: positive("stress", stress)?,
            update,
            flow: S::zero(),
        })
    }

    /// EΔε/stress: what the arm would gain without flow, in units of `stress`.
    #[inline]
    fn gain(&self, before: S, now: S) -> S {
        self.modulus * (now - before) / self.stress
    }

    /// The arm's stress after a step, in units of `stress`.
    #[inline]
    fn arm(&self, y: S, gain: S) -> S {
        match self.update {
            Update::Exact => advance(y, self.flow, gain),
            Update::Literal => y + gain - self.flow * sinh(y),
        }
    }

    /// The stress at the end of a step, Pa.
    fn carried(&self, before: S, now: S, memory: &[S]) -> S {
        let arm = self.arm(memory[1] / self.stress, self.gain(before, now));
        self.equilibrium_modulus * now + self.stress * arm
    }
}

impl<S: Number> Law<S> for Eyring<S> {
    fn prepared(self, time_step: S) -> Self {
        Self { flow: self.modulus / self.stress * (self.rate * time_step), ..self }
    }

    fn memory(&self) -> usize {
        2
    }

    /// The energy that goes is the mean of the arm's stress times the strain of its dashpot, so that
    /// stored and dissipated make up the work of the mean stress.
    #[inline]
    fn stress(&self, before: S, now: S, memory: &mut [S]) -> S {
        let gain = self.gain(before, now);
        let y = memory[1] / self.stress;
        let next = self.arm(y, gain);
        let lost = S::half() * (y + next) * (gain - (next - y));
        let unit = self.stress * (self.stress / self.modulus);
        memory[0] += unit
            * match self.update {
                // Below zero only by rounding, or as the stress changes its sign.
                Update::Exact => lost.max(S::zero()),
                Update::Literal => lost,
            };
        memory[1] = next * self.stress;
        self.equilibrium_modulus * now + memory[1]
    }

    fn tangent_modulus(&self, before: S, now: S, memory: &[S]) -> S {
        let arm = match self.update {
            Update::Exact => slope(memory[1] / self.stress, self.flow, self.gain(before, now)),
            Update::Literal => S::one(),
        };
        self.equilibrium_modulus + self.modulus * arm
    }

    fn instantaneous_modulus(&self, _strain: S, _memory: &[S]) -> S {
        self.equilibrium_modulus + self.modulus
    }

    /// ½E∞ε² + s²/(2E).
    fn stored(&self, strain: S, memory: &[S]) -> S {
        let s = memory[1];
        S::half() * (self.equilibrium_modulus * strain * strain + s / self.modulus * s)
    }

    fn dissipated(&self, memory: &[S]) -> S {
        memory[0]
    }

    /// The stress grows with `now` and is not negative where the strain stays as it was, so the
    /// root is between: by Newton's rule, by halves where that leaves the bracket.
    fn taut_strain(&self, before: S, now: S, memory: &[S]) -> S {
        let (mut low, mut high) = (now, now.max(before));
        let mut strain = now;
        let mut carried = self.carried(before, strain, memory);
        if carried < S::zero() {
            loop {
                let newton = strain - carried / self.tangent_modulus(before, strain, memory);
                let middle = low + S::half() * (high - low);
                strain = if low < newton && newton < high { newton } else { middle };
                // Nothing lies between the two, or one of them is not a number.
                if !(low < strain && strain < high) {
                    return high;
                }
                carried = self.carried(before, strain, memory);
                if carried < S::zero() {
                    low = strain;
                } else {
                    high = strain;
                }
            }
        }
        now
    }
}

#[cfg(test)]
mod tests;
