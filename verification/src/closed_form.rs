//! A scene in the terms of the closed forms, which know nothing of scenes.

use crossfibre::exact::crossover::{Coefficients, crossover};
use crossfibre::exact::elastic::Hyperelastic;
use crossfibre::exact::fronts::{Across, Clamped, Problem};
use crossfibre::exact::smith::{Fibre, Law, Strain as ExactStrain};
use crossfibre::scene::{Primary, Scene, Secondary, Strain};

/// The law that a scene's equations amount to: (4) and (7) are T = E ln λ.
pub fn law(scene: &Scene) -> Law {
    match scene.strain {
        Strain::Incremental => Law::Logarithmic,
        Strain::Engineering => Law::Engineering,
    }
}

/// The component of an exact strain that a scene's measure accumulates.
pub fn component(scene: &Scene, strain: ExactStrain) -> f64 {
    match law(scene) {
        Law::Logarithmic => strain.logarithmic,
        Law::Engineering => strain.engineering,
    }
}

/// The struck fibre.
pub fn primary(fibre: &Primary) -> Fibre {
    let modulus = fibre.material.instantaneous_modulus();
    Fibre { modulus, density: fibre.density, area: fibre.area }
}

/// The crossing fibre.
pub fn secondary(fibre: &Secondary) -> Fibre {
    let modulus = fibre.material.instantaneous_modulus();
    Fibre { modulus, density: fibre.density, area: fibre.area }
}

/// The whole scene, for the motion at any time; its projectile's mass is apart.
pub fn problem(scene: &Scene) -> Problem<Hyperelastic> {
    let law = law(scene);
    let clamped = |fibre: Fibre, length| Clamped {
        material: Hyperelastic { law, fibre },
        area: fibre.area,
        length,
    };
    Problem {
        primary: clamped(primary(&scene.primary), scene.primary.length),
        secondary: scene.secondary.as_ref().map(|fibre| Across {
            fibre: clamped(secondary(fibre), fibre.length),
            at: fibre.at,
            slide_factor: fibre.slide_factor,
        }),
        velocity: scene.projectile.velocity,
    }
}

/// What the crossover reflects, lets through and diverts, in the scene's measure of strain; none
/// without a crossover away from the impact point, with a projectile that slows down, or beyond the
/// range of the closed form.
pub fn coefficients(scene: &Scene) -> Option<Coefficients> {
    let across = scene.secondary.as_ref().filter(|secondary| secondary.at > 0.0)?;
    if scene.projectile.mass.is_some() {
        return None;
    }
    let fibres = (primary(&scene.primary), secondary(across));
    let velocity = scene.projectile.velocity;
    let around = crossover(law(scene), &fibres.0, &fibres.1, across.slide_factor, velocity).ok()?;
    Some(match law(scene) {
        Law::Logarithmic => around.logarithmic,
        Law::Engineering => around.engineering,
    })
}
