//! A scene in the terms of the closed forms, which know nothing of scenes.

use crossfibre::exact::crossover::Coefficients;
use crossfibre::exact::elastic::Hyperelastic;
use crossfibre::exact::fronts::{Across, Clamped, Problem};
use crossfibre::exact::smith::{Fibre, Law, Smith, SmithError, Strain as ExactStrain};
use crossfibre::scene::{Law as Constitutive, Material, Primary, Scene, Secondary, Strain};

use crate::oracle;

/// Why the closed forms of the crossover and the motion at any time do not hold for a scene, if so:
/// they are those of eqn (7).
pub fn beyond(scene: &Scene) -> Option<String> {
    scene
        .materials()
        .find(|material| !matches!(material.law, Constitutive::Linear { .. }))
        .map(|material| format!("it is known for eqn (7) only, not for {}", name(material)))
}

/// A law in words.
pub fn name(material: &Material) -> &'static str {
    match material.law {
        Constitutive::Linear { .. } => "eqn (7)",
        Constitutive::Polynomial { .. } => "a polynomial",
        Constitutive::Exponential { .. } => "an exponential",
        Constitutive::Viscoelastic { .. } => "a viscoelastic fibre",
        Constitutive::Eyring { .. } => "an Eyring fibre",
    }
}

/// Smith's solution for a fibre of a scene, of any elastic law; an error says why there is none.
///
/// Artificial viscosity is no part of it, and a fibre that is struck does not go slack.
pub fn struck(scene: &Scene, material: &Material, density: f64) -> Result<Smith, String> {
    let velocity = scene.projectile.velocity;
    let curved = |material: Result<Smith, SmithError>| material.map_err(|e| e.to_string());
    match (&material.law, scene.strain) {
        (Constitutive::Linear { modulus }, _) => {
            curved(oracle::smith(law(scene), (modulus / density).sqrt(), velocity))
        }
        (Constitutive::Viscoelastic { .. } | Constitutive::Eyring { .. }, _) => {
            Err("the arms relax, and no plateau lasts".into())
        }
        (_, Strain::Incremental) => Err(format!(
            "eqn (4) makes another law of {}, without a closed form; \
                         \"strain\": \"engineering\" has one",
            name(material)
        )),
        (Constitutive::Polynomial { coefficients }, Strain::Engineering) => {
            let law = oracle::polynomial(density, coefficients).map_err(|e| e.to_string())?;
            curved(oracle::struck(&law, velocity))
        }
        (Constitutive::Exponential { a, b }, Strain::Engineering) => {
            let law = oracle::exponential(density, *a, *b).map_err(|e| e.to_string())?;
            curved(oracle::struck(&law, velocity))
        }
    }
}

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
    oracle::fibre(Fibre { modulus, density: fibre.density, area: fibre.area })
}

/// The crossing fibre.
pub fn secondary(fibre: &Secondary) -> Fibre {
    let modulus = fibre.material.instantaneous_modulus();
    oracle::fibre(Fibre { modulus, density: fibre.density, area: fibre.area })
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
    if scene.projectile.mass.is_some() || beyond(scene).is_some() {
        return None;
    }
    let fibres = (primary(&scene.primary), secondary(across));
    let velocity = scene.projectile.velocity;
    let around =
        oracle::crossover(law(scene), &fibres.0, &fibres.1, across.slide_factor, velocity).ok()?;
    Some(match law(scene) {
        Law::Logarithmic => around.logarithmic,
        Law::Engineering => around.engineering,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    /// The closed form itself knows of no place, no mass and no law.
    #[test]
    fn coefficients_are_those_of_a_lasting_wave_by_eqn_7_that_comes_to_a_crossover() {
        let with = |change: fn(&mut Scene)| {
            let mut scene = shipped("fig3");
            change(&mut scene);
            coefficients(&scene).is_some()
        };
        assert!(with(|_| ()));
        assert!(!with(|scene| scene.secondary = None));
        assert!(!with(|scene| scene.secondary.as_mut().unwrap().at = 0.0));
        assert!(!with(|scene| scene.projectile.mass = Some(0.0037)));
        // The same at small strains.
        let hardening = Constitutive::Polynomial { coefficients: vec![58.6e9, 1e12] };
        let mut scene = shipped("fig3");
        scene.primary.material = hardening.into();
        assert!(beyond(&scene).is_some() && coefficients(&scene).is_none());
    }
}
