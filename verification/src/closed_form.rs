//! A scene in the terms of the closed forms, which know nothing of scenes.

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
