//! What a crossover reflects, lets through and diverts, until a wave shed by the kink returns.
//!
//! A primary fibre struck at velocity V carries Smith's state to a secondary fibre that lies
//! across it. The junction moves along the primary, towards the impact point, at a velocity u;
//! it drags the secondary along at α_s·u, which for the secondary is a transverse impact. With
//! index i for the incident state, a ahead of the junction, b behind it, 2 on the secondary, and
//! W(λ), U(λ) as in [`smith`]:
//!
//! ```text
//! W(λ_a) = u                        transmitted wave into fibre at rest
//! W(λ_b) = 2W_i − u                 reflected wave into the incident state
//! λ₂ = Smith⁻¹(α_s u)               each arm of the secondary
//! F = 2α_s·ρ₂A₂U₂·α_s u             two arms, their tension along the primary, times α_s
//! A₁T(λ_b) − A₁T(λ_a) = F           balance of force at the junction
//! ```
//!
//! Exact for the engineering law; for the logarithmic law, whose incident wave is a fan, it is
//! what the junction tends to after the fan has passed. Derivation, range and tests:
//! `docs/exact/crossover.md`.

use pxfm::{f_log1p, f_tanh};
use serde::{Deserialize, Serialize};

use super::root::first_reaching;
use super::smith::{
    Fibre, Law, Smith, SmithError, Strain, impact_velocity, positive, smith, state, velocity_limit,
};

/// Strains around a crossover as fractions of the incident strain.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Coefficients {
    /// R = (ε_b − ε_i)/ε_i.
    pub reflection: f64,
    /// T = ε_a/ε_i.
    pub transmission: f64,
    /// D = ε₂/ε_i, of each arm.
    pub diversion: f64,
}

/// The state around a crossover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossover {
    /// The state that the impact sends along the primary.
    pub incident: Smith,
    /// u, the velocity of the junction towards the impact point, m/s.
    pub junction_speed: f64,
    /// Strain of the primary beyond the junction, λ_a.
    pub transmitted: Strain,
    /// Strain of the primary between the junction and the reflected wave, λ_b.
    pub reflected: Strain,
    /// The state of each arm of the secondary, λ₂.
    pub diverted: Smith,
    /// The coefficients as ratios of engineering strain λ − 1.
    pub engineering: Coefficients,
    /// The coefficients as ratios of logarithmic strain ln λ.
    pub logarithmic: Coefficients,
    /// Power lost by the primary less power gained by the secondary, over the incident power.
    pub power_residual: f64,
}

/// The state around a crossover of a primary struck at transverse velocity V (m/s).
///
/// `slide_factor` is α_s: 0 (free sliding), or 1e-60 to 1 (no sliding).
pub fn crossover(
    law: Law,
    primary: &Fibre,
    secondary: &Fibre,
    slide_factor: f64,
    velocity: f64,
) -> Result<Crossover, SmithError> {
    for fibre in [primary, secondary] {
        positive("modulus", fibre.modulus)?;
        positive("density", fibre.density)?;
        positive("area", fibre.area)?;
    }
    if slide_factor != 0.0 {
        positive("slide factor", slide_factor)?;
    }
    if slide_factor > 1.0 {
        return Err(SmithError::Input { name: "slide factor", value: slide_factor });
    }
    let (c1, c2) = (primary.wave_speed(), secondary.wave_speed());
    let incident = smith(law, c1, velocity)?;
    let junction = Junction {
        law,
        w: law.particle_velocity(incident.strain),
        speed_ratio: c2 / c1,
        stiffness_ratio: secondary.modulus * secondary.area / (primary.modulus * primary.area),
        slide_factor,
    };
    let Motion { u, deficit, epsilon2 } = junction
        .motion()
        .ok_or_else(|| SmithError::KinkOvertakes { limit: velocity_limit(law, c2) })?;

    let diverted = state(law, c2, epsilon2);
    let transmitted = law.strain_at_particle_velocity(u);
    let added = law.strain_added(junction.w, deficit);
    let (epsilon, e) = (incident.strain.engineering, incident.strain.logarithmic);
    let reflected = Strain::from_engineering(epsilon + added);
    let gained = junction.stiffness_ratio * secondary_power(&diverted, c2, slide_factor * u * c1);
    let lost = (law.tension(reflected) - law.tension(transmitted)) * u * c1;
    Ok(Crossover {
        incident,
        junction_speed: c1 * u,
        transmitted,
        reflected,
        diverted,
        engineering: Coefficients {
            reflection: added / epsilon,
            transmission: transmitted.engineering / epsilon,
            diversion: epsilon2 / epsilon,
        },
        logarithmic: Coefficients {
            reflection: f_log1p(added / incident.strain.stretch()) / e,
            transmission: transmitted.logarithmic / e,
            diversion: diverted.strain.logarithmic / e,
        },
        power_residual: (lost - gained) / (incident.tension * incident.inflow_velocity),
    })
}

/// Growth of the energy of both arms of the secondary over E₂A₂, m/s:
/// 2[T₂W₂ + ½ρ₂U₂(V₂² − W₂²)], the longitudinal waves and the fibre that the kinks turn.
fn secondary_power(arm: &Smith, wave_speed: f64, velocity: f64) -> f64 {
    let (w, u) = (arm.inflow_velocity, arm.kink_speed_lagrangian);
    let kinetic = (velocity - w) * (velocity + w) / (2.0 * wave_speed * wave_speed);
    2.0 * (arm.tension * w + u * kinetic)
}

/// The equations of the junction in units of c₁ and E₁A₁.
struct Junction {
    law: Law,
    /// W_i/c₁.
    w: f64,
    /// c₂/c₁.
    speed_ratio: f64,
    /// E₂A₂/(E₁A₁).
    stiffness_ratio: f64,
    /// α_s.
    slide_factor: f64,
}

/// How the junction moves.
struct Motion {
    /// u/c₁.
    u: f64,
    /// (W_i − u)/c₁.
    deficit: f64,
    /// Engineering strain of the secondary.
    epsilon2: f64,
}

impl Junction {
    /// The motion at which u and the deficit W_i − u add up to W_i.
    ///
    /// Both are explicit, increasing functions of the strain of the secondary, u by Smith's
    /// relation and the deficit by the balance of force. So neither a light secondary (tiny
    /// deficit) nor a heavy one (tiny u) costs digits. `None` where the secondary would have to
    /// be strained beyond its law's largest kinked strain.
    fn motion(&self) -> Option<Motion> {
        if self.slide_factor == 0.0 {
            return Some(Motion { u: self.w, deficit: 0.0, epsilon2: 0.0 });
        }
        let highest = self.law.largest_kinked_strain();
        let epsilon2 = first_reaching(self.w, highest, |epsilon2| {
            self.velocity(epsilon2) + self.deficit(epsilon2)
        })?;
        let (u, deficit) = (self.velocity(epsilon2), self.deficit(epsilon2));
        Some(Motion { u, deficit, epsilon2 })
    }

    /// u/c₁ that strikes the secondary, at α_s·u, to engineering strain ε₂.
    fn velocity(&self, epsilon2: f64) -> f64 {
        self.speed_ratio * impact_velocity(self.law, epsilon2) / self.slide_factor
    }

    /// (W_i − u)/c₁ that balances F = 2α_s·ρ₂A₂U₂·V₂ at engineering strain ε₂.
    ///
    /// By W(λ_b) = W_i + d and W(λ_a) = W_i − d the balance T(λ_b) − T(λ_a) = F/A₁ is 2d = F for
    /// the engineering law, and 2 ln[(1 + q)/(1 − q)] = F with q = (d/2)/√λ_i for the
    /// logarithmic, in units of c₁ and E₁A₁.
    fn deficit(&self, epsilon2: f64) -> f64 {
        let strain = Strain::from_engineering(epsilon2);
        let kink = (self.law.tension(strain) / strain.stretch()).sqrt();
        let force = 2.0
            * self.slide_factor
            * self.stiffness_ratio
            * kink
            * impact_velocity(self.law, epsilon2);
        match self.law {
            Law::Engineering => force / 2.0,
            Law::Logarithmic => 2.0 * f_tanh(force / 4.0) * (1.0 + self.w / 2.0),
        }
    }
}

#[cfg(test)]
mod tests;
