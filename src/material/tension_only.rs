//! A fibre that goes slack.

use super::Law;
use crate::number::Number;

/// A law of which a slack fibre carries nothing: σ = max(0, …).
///
/// A fibre that gets shorter than its material buckles. The material then is at the strain at which
/// its law carries nothing, no matter how short the element is; a law with a dashpot recovers in the
/// meantime, and the fibre is taut again when the element has the strain of its material. So the
/// law within sees the strain of the material, which is remembered, and all energy is accounted for
/// along it.
///
/// Memory: the strain of the material, then what the law within remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TensionOnly<L> {
    law: L,
}

impl<L> TensionOnly<L> {
    /// The law without its compression.
    pub fn new(law: L) -> Self {
        Self { law }
    }
}

impl<S: Number, L: Law<S>> Law<S> for TensionOnly<L> {
    fn prepared(self, time_step: S) -> Self {
        Self::new(self.law.prepared(time_step))
    }

    fn memory(&self) -> usize {
        1 + self.law.memory()
    }

    #[inline]
    fn stress(&self, _before: S, now: S, memory: &mut [S]) -> S {
        let (material, inner) = memory.split_at_mut(1);
        let before = material[0];
        material[0] = self.law.taut_strain(before, now, inner);
        let stress = self.law.stress(before, material[0], inner);
        if now < material[0] { S::zero() } else { stress.max(S::zero()) }
    }

    /// Zero in a fibre that is slack at the end of the step.
    fn tangent_modulus(&self, _before: S, now: S, memory: &[S]) -> S {
        let (before, inner) = (memory[0], &memory[1..]);
        if self.law.taut_strain(before, now, inner) > now {
            S::zero()
        } else {
            self.law.tangent_modulus(before, now, inner)
        }
    }

    /// Zero in a slack fibre, which has no longitudinal waves.
    fn instantaneous_modulus(&self, strain: S, memory: &[S]) -> S {
        if strain < memory[0] {
            S::zero()
        } else {
            self.law.instantaneous_modulus(strain, &memory[1..])
        }
    }

    fn can_outgrow_the_step(&self) -> bool {
        self.law.can_outgrow_the_step()
    }

    fn stored(&self, _strain: S, memory: &[S]) -> S {
        self.law.stored(memory[0], &memory[1..])
    }

    fn dissipated(&self, memory: &[S]) -> S {
        self.law.dissipated(&memory[1..])
    }

    fn taut_strain(&self, _before: S, now: S, memory: &[S]) -> S {
        self.law.taut_strain(memory[0], now, &memory[1..])
    }

    fn bears_compression(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests;
