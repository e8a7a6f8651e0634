//! Transverse impact on one long fibre (Smith, McCrackin and Schiefer 1958; the paper's ref. 1).
//!
//! A point of a straight fibre at rest moves sideways at constant velocity V from time 0 on. A
//! longitudinal wave runs ahead, stretches the fibre to λ and makes it flow towards the impact
//! point at velocity W; a kink follows and turns that inflow into motion with the projectile.
//! With ρ, T as in [`elastic`](super::elastic), Lagrangian kink speed U and T̂ the concave hull of T
//! between rest and λ:
//!
//! ```text
//! W = ∫₁^λ √(T̂′(s)/ρ) ds        U = √(T/(ρλ))        V² = (λU)² − (λU − W)²
//! ```
//!
//! [`struck`] solves this for any elastic law, [`smith`] for a fibre of which nothing is known but
//! its wave speed and which of the two laws with closed forms it follows.
//!
//! Derivation, range and tests: `docs/exact/smith.md`. The solution holds until a wave reflected
//! at a clamp or a crossover comes back.

use std::fmt;

use super::elastic::{Elastic, Hyperelastic};
use super::root::first_reaching;
use super::wave::Wave;

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
    /// Nominal tension there: T in Pa from [`struck`]; from [`smith`], which is not told the
    /// modulus, T/E, which is λ − 1 for the engineering law and ln λ for the logarithmic.
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
    /// Lagrangian speed of the first longitudinal disturbance, m/s: c = √(T′(1)/ρ), or that of a
    /// shock from rest.
    pub front_speed: f64,
    /// Lagrangian speed of the last one, m/s: √(T′(λ)/ρ) behind a fan, or that of a shock.
    pub tail_speed: f64,
}

impl Smith {
    /// The longitudinal wave ahead of the kink, in the material that was struck: its fans and
    /// shocks, and its profile.
    pub fn wave<'m, M: Elastic>(&self, material: &'m M) -> Wave<'m, M> {
        Wave::between(material, 0.0, self.strain.engineering)
    }
}

/// The state of a fibre of any elastic law struck at transverse velocity V (m/s).
///
/// `velocity` may be 0 (fibre at rest) and must not exceed [`limit`].
pub fn struck(material: &impl Elastic, velocity: f64) -> Result<Smith, SmithError> {
    if velocity == 0.0 {
        return Ok(state_at(material, 0.0));
    }
    positive("velocity", velocity)?;
    strain_at_impact(material, velocity)
        .map(|strain| state_at(material, strain))
        .ok_or_else(|| SmithError::KinkOvertakes { limit: limit(material) })
}

/// The impact velocity V (m/s) at the material's greatest strain: above it there is no solution.
pub fn limit(material: &impl Elastic) -> f64 {
    velocity_at(material, material.greatest_strain())
}

/// The strain to which an impact at velocity V (m/s) stretches the fibre.
fn strain_at_impact(material: &impl Elastic, velocity: f64) -> Option<f64> {
    first_reaching(velocity, material.greatest_strain(), |strain| velocity_at(material, strain))
}

/// V at engineering strain ε, from V² = (λU)² − (λU − W)² = W(2λU − W), m/s.
///
/// The product keeps the digits that the difference of squares loses at small strain, where
/// W ≪ λU. It increases with ε for every law: `docs/exact/smith.md`, "Range".
fn velocity_at(material: &impl Elastic, strain: f64) -> f64 {
    let w = material.wave_velocity(0.0, strain);
    let velocity = w.sqrt() * (2.0 * laboratory_kink_speed(material, strain) - w).sqrt();
    // ∞ − ∞: past the greatest double.
    if velocity.is_nan() { f64::INFINITY } else { velocity }
}

/// λU = √(Tλ/ρ), the speed at which a kink gains on the fibre that flows in, m/s.
fn laboratory_kink_speed(material: &impl Elastic, strain: f64) -> f64 {
    (material.tension(strain) / material.density()).sqrt() * (1.0 + strain).sqrt()
}

/// The state whose engineering strain is ε ≥ 0.
fn state_at(material: &impl Elastic, strain: f64) -> Smith {
    let w = material.wave_velocity(0.0, strain);
    let lambda_u = laboratory_kink_speed(material, strain);
    // W/(λU), which tends to √ε.
    let turned = if strain > 0.0 { w / lambda_u } else { 0.0 };
    let (front_speed, tail_speed) = material.wave_speeds(0.0, strain);
    Smith {
        strain: Strain::from_engineering(strain),
        tension: material.tension(strain),
        inflow_velocity: w,
        kink_speed_lagrangian: material.kink_speed(strain),
        kink_speed: lambda_u - w,
        angle_cosine: 1.0 - turned,
        angle_sine: (turned * (2.0 - turned)).sqrt(),
        front_speed,
        tail_speed,
    }
}

/// The fibre of E = 1 and ρ = 1: speeds are in units of c, tensions of E.
fn unit(law: Law) -> Hyperelastic {
    Hyperelastic { law, fibre: Fibre { modulus: 1.0, density: 1.0, area: 1.0 } }
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
    strain_at_impact(&unit(law), velocity / wave_speed)
        .map(|strain| state(law, wave_speed, strain))
        .ok_or_else(|| SmithError::KinkOvertakes { limit: velocity_limit(law, wave_speed) })
}

/// The greatest impact velocity that has a solution, m/s.
///
/// The kink must not be faster than the longitudinal wave before it, U ≤ √(T′(λ)/ρ): no limit
/// (infinity) for the engineering law, ln λ ≤ 1 and so 2c√(√e − 1) = 1.6109 c for the logarithmic.
pub fn velocity_limit(law: Law, wave_speed: f64) -> f64 {
    wave_speed * limit(&unit(law))
}

/// V/c at engineering strain ε.
pub(super) fn impact_velocity(law: Law, epsilon: f64) -> f64 {
    velocity_at(&unit(law), epsilon)
}

/// The state whose engineering strain is ε ≥ 0, for wave speed c (m/s).
pub(super) fn state(law: Law, wave_speed: f64, epsilon: f64) -> Smith {
    let unit = state_at(&unit(law), epsilon);
    Smith {
        inflow_velocity: wave_speed * unit.inflow_velocity,
        kink_speed_lagrangian: wave_speed * unit.kink_speed_lagrangian,
        kink_speed: wave_speed * unit.kink_speed,
        front_speed: wave_speed * unit.front_speed,
        tail_speed: wave_speed * unit.tail_speed,
        ..unit
    }
}

/// An error unless the value is in the range within which no product below can overflow.
pub(super) fn positive(name: &'static str, value: f64) -> Result<(), SmithError> {
    if (1e-60..=1e60).contains(&value) { Ok(()) } else { Err(SmithError::Input { name, value }) }
}

#[cfg(test)]
mod tests;
