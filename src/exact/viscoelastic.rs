//! Longitudinal waves on a long viscoelastic rod whose end is pulled, for all times.
//!
//! The rod lies along x ≥ 0, at rest and unstrained. From t = 0 on its end x = 0 is pulled away
//! from it at velocity v₀. Strain and stress are positive in tension, velocities in the direction of
//! the pull. The material is an equilibrium spring E∞ beside any number of Maxwell arms
//! {E_k, τ_k}; strains are small:
//!
//! ```text
//! ∂ε/∂t = −∂v/∂x      ρ ∂v/∂t = −∂σ/∂x      σ = E∞ε + Σσ_k      ∂σ_k/∂t = E_k ∂ε/∂t − σ_k/τ_k
//! ```
//!
//! With Ê(s) = E∞ + Σ E_k s/(s + 1/τ_k) and k(s) = s√(ρ/Ê), the Laplace transforms are
//!
//! ```text
//! v̄ = (v₀/s) e^(−kx)      ε̄ = (k/s) v̄      σ̄ = (ρs/k) v̄
//! ```
//!
//! [`PulledRod`] inverts them numerically (`inversion`), up to and at the front; [`Maxwell`] has
//! the closed form of one arm without a spring. Derivation, range and tests:
//! `docs/exact/viscoelastic.md`.

mod inversion;
mod maxwell;
mod relaxation;

use std::fmt;

pub use maxwell::Maxwell;

use relaxation::Relaxation;

/// A spring E_k in series with a dashpot E_kτ_k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm {
    /// E_k, Pa.
    pub modulus: f64,
    /// τ_k, s.
    pub relaxation_time: f64,
}

/// The state of the rod at one place and time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodState {
    /// σ, Pa, positive in tension.
    pub stress: f64,
    /// ε, positive in tension.
    pub strain: f64,
    /// Velocity in the direction of the pull, m/s.
    pub velocity: f64,
}

impl RodState {
    /// Ahead of the front.
    const REST: Self = Self { stress: 0.0, strain: 0.0, velocity: 0.0 };
}

/// Why there is no state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RodError {
    /// An input that is not a positive number (from 1e-60 to 1e60, in SI units), nor 0 where that
    /// is allowed.
    Input {
        /// Which one.
        name: &'static str,
        /// What it was.
        value: f64,
    },
    /// The inversion did not settle: the time is too late, by more than about 10⁷ of the shortest
    /// relaxation time.
    Unsettled {
        /// Points on the contour, at the last attempt.
        points: u64,
    },
}

impl fmt::Display for RodError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input { name, value } => write!(f, "{name} = {value:e} is out of range"),
            Self::Unsettled { points } => {
                write!(f, "the inversion did not settle with {points} points: too late a time")
            }
        }
    }
}

impl std::error::Error for RodError {}

/// A long rod, pulled at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct PulledRod {
    density: f64,
    glassy_modulus: f64,
    relaxation: Relaxation,
    velocity: f64,
}

impl PulledRod {
    /// The rod of density ρ (kg/m³), equilibrium modulus E∞ (Pa, may be 0) and arms {E_k, τ_k},
    /// pulled at v₀ (m/s, negative for a push). Without arms it is elastic, and E∞ is not 0.
    pub fn new(
        density: f64,
        equilibrium_modulus: f64,
        arms: &[Arm],
        velocity: f64,
    ) -> Result<Self, RodError> {
        positive("density", density)?;
        if arms.is_empty() || equilibrium_modulus != 0.0 {
            positive("equilibrium modulus", equilibrium_modulus)?;
        }
        for arm in arms {
            positive("modulus", arm.modulus)?;
            positive("relaxation time", arm.relaxation_time)?;
        }
        if velocity != 0.0 {
            positive("velocity", velocity.abs())?;
        }
        let glassy_modulus = equilibrium_modulus + arms.iter().map(|arm| arm.modulus).sum::<f64>();
        let relaxation = Relaxation::new(equilibrium_modulus, arms, glassy_modulus);
        Ok(Self { density, glassy_modulus, relaxation, velocity })
    }

    /// c = √(E₀/ρ) with the glassy modulus E₀ = E∞ + ΣE_k, the speed of the front, m/s.
    pub fn front_speed(&self) -> f64 {
        (self.glassy_modulus / self.density).sqrt()
    }

    /// The state just behind the front as it passes x (m): every jump is that of the elastic rod of
    /// modulus E₀, times exp(−(x/2c) Σ(E_k/τ_k)/E₀).
    pub fn front(&self, x: f64) -> RodState {
        let path = x / self.front_speed();
        let left = pxfm::f_exp(-self.relaxation.front_decay() * path);
        self.scaled(left, left, left)
    }

    /// The state at x ≥ 0 (m) and t ≥ 0 (s). A front counts from the moment of its arrival, and
    /// the state is [`front`](Self::front) then.
    pub fn at(&self, x: f64, t: f64) -> Result<RodState, RodError> {
        not_negative("x", x)?;
        not_negative("t", t)?;
        let path = x / self.front_speed();
        let since = t - path;
        if since < 0.0 {
            return Ok(RodState::REST);
        }
        if since == 0.0 || self.relaxation.is_elastic() {
            return Ok(self.front(x));
        }
        let [stress, strain, velocity] = inversion::at(&self.relaxation, path, since)?;
        Ok(self.scaled(stress, strain, velocity))
    }

    /// From units of ρcv₀, v₀/c and v₀.
    fn scaled(&self, stress: f64, strain: f64, velocity: f64) -> RodState {
        let c = self.front_speed();
        RodState {
            stress: self.density * c * self.velocity * stress,
            strain: self.velocity / c * strain,
            velocity: self.velocity * velocity,
        }
    }
}

/// An error unless the value is in the range within which no product here can overflow.
fn positive(name: &'static str, value: f64) -> Result<(), RodError> {
    if (1e-60..=1e60).contains(&value) { Ok(()) } else { Err(RodError::Input { name, value }) }
}

fn not_negative(name: &'static str, value: f64) -> Result<(), RodError> {
    if value == 0.0 { Ok(()) } else { positive(name, value) }
}

#[cfg(test)]
mod tests;
