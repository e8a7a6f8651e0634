//! Transverse impact on one long fibre (Smith, McCrackin and Schiefer 1958; the paper's ref. 1).
//!
//! A point of a straight fibre at rest moves sideways at constant velocity V from time 0 on. A
//! longitudinal wave runs ahead, stretches the fibre to λ and makes it flow towards the impact
//! point at velocity W; a kink follows and turns that inflow into motion with the projectile.
//! With ρ, T, c as in [`hyperelastic`](super::hyperelastic) and Lagrangian kink speed U:
//!
//! ```text
//! W = ∫₁^λ √(T′(s)/ρ) ds        U = √(T/(ρλ))        V² = (λU)² − (λU − W)²
//! ```
//!
//! Derivation, range and tests: `docs/exact/smith.md`. The solution holds until a wave reflected
//! at a clamp or a crossover comes back.

use std::fmt;

use super::root::first_reaching;

pub use super::hyperelastic::{Law, Strain};

/// Material and section of a uniform fibre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fibre {
    /// Modulus E, Pa.
    pub modulus: f64,
    /// Reference density ρ, kg/m³.
    pub density: f64,
    /// Reference area A, m².
    pub area: f64,
}

impl Fibre {
    /// c = √(E/ρ), m/s.
    pub fn wave_speed(&self) -> f64 {
        (self.modulus / self.density).sqrt()
    }
}

/// Why there is no solution of Smith's kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SmithError {
    /// An input that is not a positive number (from 1e-60 to 1e60, in SI units).
    Input {
        /// Which one.
        name: &'static str,
        /// What it was.
        value: f64,
    },
    /// The kink would be faster than the slowest longitudinal wave ahead of it.
    KinkOvertakes {
        /// The greatest transverse velocity of the struck fibre that has a solution, m/s.
        limit: f64,
    },
}

impl fmt::Display for SmithError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input { name, value } => write!(f, "{name} = {value:e} is out of range"),
            Self::KinkOvertakes { limit } => {
                write!(f, "above {limit} m/s the kink overtakes the longitudinal wave")
            }
        }
    }
}

impl std::error::Error for SmithError {}

/// The state of a fibre struck transversely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smith {
    /// Strain behind the longitudinal wave, on both sides of the kink.
    pub strain: Strain,
    /// T/E there: λ − 1 for the engineering law, ln λ for the logarithmic.
    pub tension: f64,
    /// W, the velocity of the straight part towards the impact point, m/s.
    pub inflow_velocity: f64,
    /// U, the speed of the kink in the Lagrangian coordinate, m/s.
    pub kink_speed_lagrangian: f64,
    /// λU − W, the speed of the kink along the straight fibre in the laboratory, m/s.
    pub kink_speed: f64,
    /// Cosine of the angle by which the kink turns the fibre, (λU − W)/(λU).
    pub angle_cosine: f64,
    /// Sine of that angle, V/(λU).
    pub angle_sine: f64,
    /// Lagrangian speed of the first longitudinal disturbance, c, m/s.
    pub front_speed: f64,
    /// Lagrangian speed of the last one, √(T′(λ)/ρ): c, or c/√λ behind a fan, m/s.
    pub tail_speed: f64,
}

/// The state of fibre of wave speed c = √(E/ρ) (m/s) struck at transverse velocity V (m/s).
///
/// `velocity` may be 0 (fibre at rest) and must not exceed [`velocity_limit`].
pub fn smith(law: Law, wave_speed: f64, velocity: f64) -> Result<Smith, SmithError> {
    positive("wave speed", wave_speed)?;
    if velocity == 0.0 {
        return Ok(state(law, wave_speed, 0.0));
    }
    positive("velocity", velocity)?;
    first_reaching(velocity / wave_speed, law.largest_kinked_strain(), |epsilon| {
        impact_velocity(law, epsilon)
    })
    .map(|epsilon| state(law, wave_speed, epsilon))
    .ok_or_else(|| SmithError::KinkOvertakes { limit: velocity_limit(law, wave_speed) })
}

/// The greatest impact velocity that has a solution, m/s.
///
/// The kink must not be faster than the longitudinal wave before it, U ≤ √(T′(λ)/ρ): no limit
/// (infinity) for the engineering law, ln λ ≤ 1 and so 2c√(√e − 1) = 1.6109 c for the logarithmic.
pub fn velocity_limit(law: Law, wave_speed: f64) -> f64 {
    match law {
        Law::Engineering => f64::INFINITY,
        Law::Logarithmic => wave_speed * impact_velocity(law, law.largest_kinked_strain()),
    }
}

/// V/c at engineering strain ε, from V² = (λU)² − (λU − W)² = W(2λU − W).
///
/// The product keeps the digits that the difference of squares loses at small strain, where
/// W ≪ λU. It increases with ε: W′ ≤ 2(λU)′ for both laws.
pub(super) fn impact_velocity(law: Law, epsilon: f64) -> f64 {
    let strain = Strain::from_engineering(epsilon);
    let w = law.particle_velocity(strain);
    let lambda_u = law.tension(strain).sqrt() * strain.stretch().sqrt();
    w.sqrt() * (2.0 * lambda_u - w).sqrt()
}

/// The state whose engineering strain is ε ≥ 0.
pub(super) fn state(law: Law, wave_speed: f64, epsilon: f64) -> Smith {
    let strain = Strain::from_engineering(epsilon);
    let tension = law.tension(strain);
    let w = law.particle_velocity(strain);
    let u = (tension / strain.stretch()).sqrt();
    let lambda_u = tension.sqrt() * strain.stretch().sqrt();
    // W/(λU), which tends to √ε.
    let turned = if epsilon > 0.0 { w / lambda_u } else { 0.0 };
    Smith {
        strain,
        tension,
        inflow_velocity: wave_speed * w,
        kink_speed_lagrangian: wave_speed * u,
        kink_speed: wave_speed * (lambda_u - w),
        angle_cosine: 1.0 - turned,
        angle_sine: (turned * (2.0 - turned)).sqrt(),
        front_speed: wave_speed,
        tail_speed: wave_speed * law.longitudinal_speed(strain),
    }
}

/// An error unless the value is in the range within which no product below can overflow.
pub(super) fn positive(name: &'static str, value: f64) -> Result<(), SmithError> {
    if (1e-60..=1e60).contains(&value) { Ok(()) } else { Err(SmithError::Input { name, value }) }
}

#[cfg(test)]
mod tests;
