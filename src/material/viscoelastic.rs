//! Linear viscoelasticity.

use serde::{Deserialize, Serialize};

use super::decay::decay;
use super::parameter::{ParameterError, not_empty, not_negative, positive};
use super::{Law, Update};
use crate::number::Number;

/// A spring and a dashpot in series (Maxwell): ds/dt = E dε/dt − s/τ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Arm {
    /// E, Pa.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub modulus: f64,
    /// τ, s.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub relaxation_time: f64,
}

/// σ = E∞ε + Σ s: an equilibrium spring beside Maxwell arms.
///
/// Memory: the dissipated energy (J/m³), then the stress s of each arm (Pa).
#[derive(Clone, Debug, PartialEq)]
pub struct Viscoelastic<S> {
    equilibrium_modulus: S,
    arms: Vec<PreparedArm<S>>,
    update: Update,
}

/// An arm with what a step of given length makes of it. With e = EΔε,
/// s ← left × s + gained × e, and the dissipated energy grows by (ps² + rse + te²)/E.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PreparedArm<S> {
    modulus: S,
    relaxation_time: S,
    left: S,
    gained: S,
    /// p/E, r/E, t/E.
    loss: [S; 3],
}

impl<S: Number> Viscoelastic<S> {
    /// The law with E∞ ≥ 0 (Pa; a liquid at 0) and at least one arm.
    pub fn new(
        equilibrium_modulus: f64,
        arms: &[Arm],
        update: Update,
    ) -> Result<Self, ParameterError> {
        let equilibrium_modulus = not_negative("equilibrium_modulus", equilibrium_modulus)?;
        not_empty("arms", arms)?;
        let arms = arms
            .iter()
            .enumerate()
            .map(|(i, arm)| {
                let modulus = positive(&format!("arms[{i}].modulus"), arm.modulus)?;
                let relaxation_time =
                    positive(&format!("arms[{i}].relaxation_time"), arm.relaxation_time)?;
                Ok(PreparedArm::new(modulus, relaxation_time, S::zero(), update))
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { equilibrium_modulus, arms, update })
    }
}

impl<S: Number> PreparedArm<S> {
    fn new(modulus: S, relaxation_time: S, time_step: S, update: Update) -> Self {
        let x = time_step / relaxation_time;
        let (left, gained, loss) = match update {
            Update::Exact => exact(x),
            Update::Literal => literal(x),
        };
        Self { modulus, relaxation_time, left, gained, loss: loss.map(|c| c / modulus) }
    }

    #[inline(always)]
    fn stress(&self, s: S, added: S) -> S {
        self.left * s + self.gained * (self.modulus * added)
    }

    #[inline(always)]
    fn dissipated(&self, s: S, added: S) -> S {
        let e = self.modulus * added;
        let [p, r, t] = self.loss;
        (p * s + r * e) * s + t * e * e
    }
}

/// For x = Δt/τ and q = exp(−x), m = 1 − q: what is left, q; what is gained, m/x; and what is lost,
/// p = m(1 + q)/2, r = m²/x, t = (x − m − m²/2)/x².
///
/// −ln(1 − m) = x, so x − m − m²/2 is Σ mᵏ/k from k = 3 on, which keeps its digits at small x.
fn exact<S: Number>(x: S) -> (S, S, [S; 3]) {
    if x == S::zero() {
        return (S::one(), S::one(), [S::zero(); 3]);
    }
    let (q, m) = decay(x);
    let rest = if m < S::half() {
        let (mut power, mut sum, mut k) = (m * m * m, S::zero(), 3);
        while sum + power / S::count(k) != sum {
            sum += power / S::count(k);
            power *= m;
            k += 1;
        }
        sum
    } else {
        x - m - S::half() * m * m
    };
    let gained = m / x;
    (q, gained, [S::half() * m * (S::one() + q), m * gained, rest / x / x])
}

/// s ← s + e − sx. The mean stress times the strain of the dashpot, sx/E, is lost.
fn literal<S: Number>(x: S) -> (S, S, [S; 3]) {
    let half_x = S::half() * x;
    (S::one() - x, S::one(), [half_x * (S::two() - x), half_x, S::zero()])
}

impl<S: Number> Law<S> for Viscoelastic<S> {
    fn prepared(self, time_step: S) -> Self {
        let prepare = |arm: &PreparedArm<S>| {
            PreparedArm::new(arm.modulus, arm.relaxation_time, time_step, self.update)
        };
        Self { arms: self.arms.iter().map(prepare).collect(), ..self }
    }

    fn memory(&self) -> usize {
        1 + self.arms.len()
    }

    #[inline]
    fn stress(&self, before: S, now: S, memory: &mut [S]) -> S {
        let added = now - before;
        let (dissipated, stresses) = memory.split_at_mut(1);
        let mut stress = self.equilibrium_modulus * now;
        for (arm, s) in self.arms.iter().zip(stresses) {
            dissipated[0] += arm.dissipated(*s, added);
            *s = arm.stress(*s, added);
            stress += *s;
        }
        stress
    }

    fn tangent_modulus(&self, _before: S, _now: S, _memory: &[S]) -> S {
        let sum = |sum, arm: &PreparedArm<S>| sum + arm.gained * arm.modulus;
        self.arms.iter().fold(self.equilibrium_modulus, sum)
    }

    fn instantaneous_modulus(&self, _strain: S, _memory: &[S]) -> S {
        self.arms.iter().fold(self.equilibrium_modulus, |sum, arm| sum + arm.modulus)
    }

    /// ½E∞ε² + Σ s²/(2E).
    fn stored(&self, strain: S, memory: &[S]) -> S {
        let springs = self.arms.iter().zip(&memory[1..]);
        springs.fold(S::half() * self.equilibrium_modulus * strain * strain, |sum, (arm, &s)| {
            sum + S::half() * s / arm.modulus * s
        })
    }

    fn dissipated(&self, memory: &[S]) -> S {
        memory[0]
    }

    fn taut_strain(&self, before: S, now: S, memory: &[S]) -> S {
        let arms = self.arms.iter().zip(&memory[1..]);
        let held = arms.fold(self.equilibrium_modulus * before, |sum, (arm, &s)| {
            sum + arm.stress(s, S::zero())
        });
        now.max(before - held / self.tangent_modulus(before, now, memory))
    }
}

#[cfg(test)]
mod tests;
