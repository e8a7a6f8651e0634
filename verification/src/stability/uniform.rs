//! The largest Courant number of a uniform fibre by hand, for every law: `docs/exact/stability.md`.
//!
//! In the highest mode of the mesh neighbours move against each other, and at the limit its sign
//! changes with every step. Then α² f(α) = λ/cos²(π/2n), where f is what the law makes of such a
//! strain over its modulus at rest, and λ the stretch where strain is that of (4), 1 else.

use crossfibre::material::Update;
use crossfibre::number::Number;
use crossfibre::scene::{Law, Strain};

use super::base::Base;
use super::closed_form::greatest;

/// The largest Courant number of so many elements, held at both ends, over that of a fibre without
/// end: the highest mode has a phase of π − π/n an element.
pub fn finite(elements: usize) -> f64 {
    1.0 / Number::cos(std::f64::consts::FRAC_PI_2 / elements as f64)
}

/// The largest stable Courant number of a uniform fibre without end: zero if it buckles, infinite if
/// it is slack.
pub fn endless(base: &Base) -> f64 {
    limit(base, 1.0)
}

/// The same of the mesh of the scene, held at both ends.
pub fn held(base: &Base) -> f64 {
    let finite = finite(base.scene.primary.elements);
    limit(base, finite * finite)
}

fn limit(base: &Base, factor: f64) -> f64 {
    let material = &base.scene.primary.material;
    if base.strain < 0.0 {
        return if material.tension_only { f64::INFINITY } else { 0.0 };
    }
    let stretch = match base.scene.strain {
        Strain::Incremental => Number::exp(base.strain),
        Strain::Engineering => 1.0,
    };
    let zeta = material.artificial_viscosity.map_or(0.0, |coefficients| coefficients.linear);
    let stable = |courant: f64| {
        let stiffness = stiffness(base, courant);
        stiffness > 0.0 && courant * courant * stiffness + 2.0 * zeta * courant <= factor * stretch
    };
    // No law of the table softens to a hundredth.
    greatest(stable, 0.0, 10.0)
}

/// f: the modulus that an alternating small strain feels, over that of a sudden one at rest;
/// negative where an update by forward differences has no bound.
fn stiffness(base: &Base, courant: f64) -> f64 {
    let primary = &base.scene.primary;
    let at_rest = primary.material.instantaneous_modulus();
    let spacing = primary.length / primary.elements as f64;
    let time_step = courant * spacing * (primary.density / at_rest).sqrt();
    let arm = |modulus: f64, x: f64, update: Update| modulus * alternating(x, update);
    let e = base.strain;
    let modulus = match &primary.material.law {
        Law::Linear { modulus } => *modulus,
        Law::Polynomial { coefficients } => {
            let slope = |(k, c): (usize, &f64)| (k + 1) as f64 * c * e.powi(k as i32);
            coefficients.iter().enumerate().map(slope).sum()
        }
        Law::Exponential { a, b } => a * b * Number::exp(b * e),
        Law::Viscoelastic { equilibrium_modulus, arms, update } => {
            let of_arm = |a: &crossfibre::material::Arm| {
                arm(a.modulus, time_step / a.relaxation_time, *update)
            };
            equilibrium_modulus + arms.iter().map(of_arm).sum::<f64>()
        }
        // sinh(s/S) is s/S at rest.
        Law::Eyring { equilibrium_modulus, modulus, rate, stress, update } => {
            equilibrium_modulus + arm(*modulus, modulus * rate * time_step / stress, *update)
        }
    };
    modulus / at_rest
}

/// What a Maxwell arm makes of a strain that changes its sign with every step, over its modulus;
/// x = Δt/τ.
///
/// s ← s + e − sx gives 2/(2 − x); the exact update tanh(x/2)/(x/2).
fn alternating(x: f64, update: Update) -> f64 {
    match update {
        Update::Literal if x < 2.0 => 2.0 / (2.0 - x),
        Update::Literal => f64::NEG_INFINITY,
        Update::Exact => {
            let q = Number::exp(-x);
            (1.0 - q) / (1.0 + q) * 2.0 / x
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::rows::{ALONE, at_rest, fibre};
    use super::*;

    /// α = √λ, and 1/cos(π/2n) times that on n elements. Some roundings.
    #[test]
    fn a_fibre_without_end_has_the_limit_of_its_stretch() {
        let near = |found: f64, expected: f64| {
            assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
        };
        for (measure, limit) in
            [(Strain::Engineering, 1.0), (Strain::Incremental, Number::exp(0.0145 / 2.0))]
        {
            let base = at_rest(fibre(ALONE, measure), 0.0145);
            near(endless(&base), limit);
            near(held(&base), limit * finite(ALONE));
        }
    }
}
