//! Constitutive laws: from the strain of an element to its nominal stress.
//!
//! "Other constitutive models could also be used without difficulty, and the code as presently
//! developed contains routines for nonlinear elasticity (polynomial or exponential strain
//! hardening), and for both linear and nonlinear viscoelasticity"; oscillations "could be diminished
//! by incorporating artificial viscosity into the material constitutive model". Derivations, units
//! and ranges: `docs/materials.md`.
//!
//! The march has (7) by itself; where a scene names another law, [`of_scene`] builds it and the march
//! calls it once for each block of elements.
//!
//! | law | memory of an element |
//! |---|---|
//! | [`Linear`], [`Polynomial`], [`Exponential`] | none |
//! | [`Viscoelastic`] | dissipated energy, stress of each arm |
//! | [`Eyring`] | dissipated energy, stress of the arm |
//! | [`TensionOnly`] of a law | strain of the material, then the law's own |
//! | [`ArtificialViscosity`] of a law | dissipated energy, then the law's own |
//!
//! A stress is force per reference area (Pa), positive in tension; energies are per reference volume
//! (J/m³). Strain is whatever the march accumulates, and work is ∫ stress d(strain).

mod artificial_viscosity;
mod decay;
mod exponential;
mod eyring;
mod linear;
mod of_scene;
mod parameter;
mod polynomial;
mod riccati;
mod tension_only;
#[cfg(test)]
mod tests;
mod viscoelastic;

pub use artificial_viscosity::{ArtificialViscosity, Coefficients, Mesh};
pub use exponential::Exponential;
pub use eyring::Eyring;
pub use linear::Linear;
pub use of_scene::of_scene;
pub use parameter::{ParameterError, ParameterFault};
pub use polynomial::Polynomial;
pub use tension_only::TensionOnly;
pub use viscoelastic::{Arm, Viscoelastic};

use std::fmt::Debug;

use serde::{Deserialize, Serialize};

use crate::number::Number;

/// How a law with a dashpot goes through a time step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Update {
    /// The solution of the law for a strain that changes linearly over the step, at any length of
    /// the step.
    #[default]
    Exact,
    /// Forward differences, σ ← σ + EΔε − E × flow(σ)Δt: kept to show where it breaks.
    Literal,
}

impl Update {
    /// Whether it is the exact one.
    pub fn is_exact(&self) -> bool {
        *self == Self::Exact
    }
}

/// A law between strain and stress.
///
/// A new element has a strain of zero and a memory of zeros. In every step `memory` is the
/// element's own slice of [`Law::memory`] numbers.
pub trait Law<S: Number>: Debug + Send + Sync {
    /// The law for steps of Δt (s). Before this, a step takes no time: dashpots are rigid, and there
    /// is no artificial viscosity.
    fn prepared(self, time_step: S) -> Self
    where
        Self: Sized;

    /// How many numbers an element remembers.
    fn memory(&self) -> usize;

    /// Stress (Pa) at the end of a step in which the strain went from `before` to `now`; updates
    /// the memory.
    fn stress(&self, before: S, now: S, memory: &mut [S]) -> S;

    /// d(stress)/d(`now`) of that update, Pa; `memory` is that of before the step.
    fn tangent_modulus(&self, before: S, now: S, memory: &[S]) -> S;

    /// Modulus (Pa) that a sudden small strain would feel now: it sets the wave speed.
    fn instantaneous_modulus(&self, strain: S, memory: &[S]) -> S;

    /// M, Pa, of the bound MΔt² ≤ ρΔx² that the longitudinal waves of one element put on the step:
    /// the instantaneous modulus, and twice the slope of an artificial viscosity. `memory` is that of
    /// after the step.
    fn step_modulus(&self, _before: S, now: S, memory: &[S]) -> S {
        self.instantaneous_modulus(now, memory)
    }

    /// Whether [`Law::step_modulus`] can become greater than it is at rest.
    fn can_outgrow_the_step(&self) -> bool {
        false
    }

    /// Energy stored, J/m³.
    fn stored(&self, strain: S, memory: &[S]) -> S;

    /// Energy dissipated so far, J/m³.
    fn dissipated(&self, memory: &[S]) -> S;

    /// `now`; or, where [`Law::stress`] would be compressive there, the greater strain at which it
    /// is zero. That is the strain of the material in a slack fibre.
    fn taut_strain(&self, before: S, now: S, memory: &[S]) -> S;

    /// Whether the stress can be negative.
    fn bears_compression(&self) -> bool {
        true
    }

    // ------------------------------------------------- the same for a block of elements, in one call

    /// [`Law::stress`] of each element.
    fn stresses(&self, before: &[S], now: &[S], memory: &mut [S], stress: &mut [S]) {
        let n = self.memory();
        for (i, stress) in stress.iter_mut().enumerate() {
            *stress = self.stress(before[i], now[i], &mut memory[i * n..][..n]);
        }
    }

    /// [`Law::dissipated`] of each element.
    fn dissipations(&self, memory: &[S], dissipated: &mut [S]) {
        let n = self.memory();
        for (i, dissipated) in dissipated.iter_mut().enumerate() {
            *dissipated = self.dissipated(&memory[i * n..][..n]);
        }
    }

    /// [`Law::step_modulus`] of each element.
    fn step_moduli(&self, before: &[S], now: &[S], memory: &[S], modulus: &mut [S]) {
        let n = self.memory();
        for (i, modulus) in modulus.iter_mut().enumerate() {
            *modulus = self.step_modulus(before[i], now[i], &memory[i * n..][..n]);
        }
    }
}
