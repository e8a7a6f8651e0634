//! Constitutive laws: from the strain of an element to its nominal stress.
//!
//! "Other constitutive models could also be used without difficulty, and the code as presently
//! developed contains routines for nonlinear elasticity (polynomial or exponential strain
//! hardening), and for both linear and nonlinear viscoelasticity"; oscillations "could be diminished
//! by incorporating artificial viscosity into the material constitutive model". Derivations, units
//! and ranges: `docs/materials.md`.
//!
//! The march does not use them yet: it has (7) alone.
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
pub use parameter::{ParameterError, ParameterFault};
pub use polynomial::Polynomial;
pub use tension_only::TensionOnly;
pub use viscoelastic::{Arm, Viscoelastic};

use crate::number::Number;

/// How a law with a dashpot goes through a time step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// The solution of the law for a strain that changes linearly over the step, at any length of
    /// the step.
    Exact,
    /// Forward differences, σ ← σ + EΔε − E × flow(σ)Δt: kept to show where it breaks.
    Literal,
}

/// A law between strain and stress.
///
/// A new element has a strain of zero and a memory of zeros. In every step `memory` is the
/// element's own slice of [`Law::memory`] numbers.
pub trait Law<S: Number>: Sync {
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
}
