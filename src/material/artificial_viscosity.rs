//! Artificial viscosity, against the oscillations at a front.

use serde::{Deserialize, Serialize};

use super::Law;
use super::parameter::{ParameterError, not_negative, positive};
use crate::number::Number;

/// A law beside a dashpot that is there for the numerics: σ + q with
///
/// q = ρΔx (linear × c + quadratic × Δx|ε̇|) ε̇,   ε̇ = (`now` − `before`)/Δt,
///
/// c = √(E/ρ) at zero strain. It acts in extension and in contraction: the front of a fibre under
/// impact is an extension, and where the law is linear a front that unloads rings as much.
///
/// A law that carries no compression gets no viscous stress while it is slack, and never so much
/// that the sum would be compressive. [`super::TensionOnly`] belongs inside.
///
/// Memory: the energy dissipated by q (J/m³), then what the law within remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArtificialViscosity<L, S> {
    law: L,
    /// ρΔx × linear × c, Pa s.
    linear: S,
    /// ρΔx² × quadratic, Pa s².
    quadratic: S,
    /// ρcΔx, Pa s.
    impedance: S,
    /// `linear`/Δt (Pa) and `quadratic`/Δt² (Pa).
    per_step: (S, S),
}

/// What artificial viscosity has to know of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// ρ, kg/m³.
    pub density: f64,
    /// Δx, unstrained length of an element, m.
    pub spacing: f64,
}

/// The coefficients of artificial viscosity, without unit; either may be zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Coefficients {
    /// Of the part that grows with the strain rate. Of order 0.1.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub linear: f64,
    /// Of the part that grows with its square. Of order 1.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub quadratic: f64,
}

impl Coefficients {
    /// The greatest stable Courant number where the strain does not change yet, √(1 + ζ²) − ζ with
    /// ζ = linear.
    pub fn greatest_courant_at_rest(&self) -> f64 {
        greatest_courant(self.linear)
    }
}

/// √(1 + ζ²) − ζ, without its difference.
fn greatest_courant<S: Number>(zeta: S) -> S {
    S::one() / ((S::one() + zeta * zeta).sqrt() + zeta)
}

impl<S: Number, L: Law<S>> ArtificialViscosity<L, S> {
    /// The law with viscosity for elements of one mesh.
    pub fn new(law: L, mesh: Mesh, coefficients: Coefficients) -> Result<Self, ParameterError> {
        let density: S = positive("density", mesh.density)?;
        let spacing: S = positive("spacing", mesh.spacing)?;
        let linear: S = not_negative("linear", coefficients.linear)?;
        let quadratic: S = not_negative("quadratic", coefficients.quadratic)?;
        let modulus = law.instantaneous_modulus(S::zero(), &vec![S::zero(); law.memory()]);
        let impedance = (density * modulus).sqrt() * spacing;
        Ok(Self {
            law,
            linear: linear * impedance,
            quadratic: quadratic * density * spacing * spacing,
            impedance,
            per_step: (S::zero(), S::zero()),
        })
    }

    /// The greatest stable Courant number at a strain rate (1/s), for a law whose modulus is that of
    /// zero strain: √(1 + ζ²) − ζ with ζ = linear + 2 × quadratic × Δx|ε̇|/c.
    ///
    /// The viscous stress is one step late, so viscosity costs step length where an implicit one
    /// would not.
    pub fn greatest_courant(&self, strain_rate: S) -> S {
        let slope = self.linear + S::two() * self.quadratic * strain_rate.abs();
        greatest_courant(slope / self.impedance)
    }

    /// dq/d(`now`), Pa.
    #[inline]
    fn viscous_slope(&self, added: S) -> S {
        self.per_step.0 + S::two() * self.per_step.1 * added.abs()
    }

    /// q, Pa, at a step's strain increment.
    #[inline]
    fn viscous(&self, added: S) -> S {
        (self.per_step.0 + self.per_step.1 * added.abs()) * added
    }
}

impl<S: Number, L: Law<S>> Law<S> for ArtificialViscosity<L, S> {
    fn prepared(self, time_step: S) -> Self {
        let per_step = (self.linear / time_step, self.quadratic / time_step / time_step);
        Self { law: self.law.prepared(time_step), per_step, ..self }
    }

    fn memory(&self) -> usize {
        1 + self.law.memory()
    }

    #[inline]
    fn stress(&self, before: S, now: S, memory: &mut [S]) -> S {
        let (dissipated, inner) = memory.split_at_mut(1);
        let stress = self.law.stress(before, now, inner);
        let mut viscous = self.viscous(now - before);
        if !self.law.bears_compression() {
            viscous = if stress > S::zero() { viscous.max(-stress) } else { S::zero() };
        }
        dissipated[0] += viscous * (now - before);
        stress + viscous
    }

    /// Where a law that carries no compression cuts q, this is still the tangent with all of it.
    fn tangent_modulus(&self, before: S, now: S, memory: &[S]) -> S {
        self.law.tangent_modulus(before, now, &memory[1..]) + self.viscous_slope(now - before)
    }

    /// That of the law within: the wave speed is the material's.
    fn instantaneous_modulus(&self, strain: S, memory: &[S]) -> S {
        self.law.instantaneous_modulus(strain, &memory[1..])
    }

    /// On α²(1 + 2ζ/α) ≤ 1, see [`Self::greatest_courant`]: ζα is the slope of q over ρΔx²/Δt².
    fn step_modulus(&self, before: S, now: S, memory: &[S]) -> S {
        let within = self.law.step_modulus(before, now, &memory[1..]);
        if within == S::zero() && !self.law.bears_compression() {
            return within; // slack: no viscous stress either
        }
        within + S::two() * self.viscous_slope(now - before)
    }

    fn can_outgrow_the_step(&self) -> bool {
        self.quadratic != S::zero() || self.law.can_outgrow_the_step()
    }

    fn stored(&self, strain: S, memory: &[S]) -> S {
        self.law.stored(strain, &memory[1..])
    }

    fn dissipated(&self, memory: &[S]) -> S {
        memory[0] + self.law.dissipated(&memory[1..])
    }

    fn taut_strain(&self, before: S, now: S, memory: &[S]) -> S {
        self.law.taut_strain(before, now, &memory[1..])
    }

    fn bears_compression(&self) -> bool {
        self.law.bears_compression()
    }
}

#[cfg(test)]
mod tests;
