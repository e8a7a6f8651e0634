//! Scenes drawn for conformance: small, awkward, and the same for the same seed.

use crossfibre::errata::Corrections;
use crossfibre::material::Arm;
use crossfibre::scene::{FORMAT, Law, Material, Primary, Projectile, Scene, Secondary, Strain};

use crate::random::SplitMix;

/// A scene of linear fibres: a third of them single, one in six with both fibres at the impact point,
/// some with all or nothing sliding, a half with a projectile of finite mass, a third in engineering
/// strain, a sixth as printed.
pub fn scene(random: &mut SplitMix) -> Scene {
    let elements = random.whole(5..41);
    let primary = Primary {
        length: random.between(0.11, 0.43),
        elements,
        density: random.between(870.0, 2140.0),
        area: random.between(0.31e-6, 2.3e-6),
        material: Material::linear(random.between(17e9, 133e9)),
    };
    let length = primary.length;
    let secondary = (!random.chance(1.0 / 3.0)).then(|| Secondary {
        at: if random.chance(0.25) {
            0.0
        } else {
            length * random.between((0.7 / elements as f64).max(0.06), 0.71)
        },
        length: random.between(0.11, 0.37),
        elements: random.whole(4..31),
        density: random.between(870.0, 2140.0),
        area: random.between(0.31e-6, 2.3e-6),
        material: Material::linear(random.between(17e9, 133e9)),
        slide_factor: [0.0, 1.0, 1.0, random.between(0.13, 0.97)][random.whole(0..4)],
    });
    let mass = random.chance(0.5).then(|| random.between(0.11e-3, 2.7e-3));
    let mut scene = Scene {
        format: FORMAT.into(),
        title: String::new(),
        projectile: Projectile { velocity: random.between(83.0, 570.0), mass },
        courant: random.between(0.43, 0.97),
        duration: 1.0,
        strain: if random.chance(1.0 / 3.0) { Strain::Engineering } else { Strain::Incremental },
        corrections: if random.chance(1.0 / 6.0) { Corrections::NONE } else { Corrections::ALL },
        primary,
        secondary,
    };
    if scene.secondary.as_ref().is_some_and(|secondary| secondary.at == 0.0) {
        // (11) as printed is undefined there.
        scene.corrections = Corrections::ALL;
    }
    // From half the way of the first wave to the clamp up to twice there and back.
    scene.duration = scene.primary.length / wave_speed(&scene) * random.between(0.5, 4.0);
    scene
}

/// The same with another law in both fibres, of the same modulus at rest.
pub fn scene_of_another_law(random: &mut SplitMix) -> Scene {
    let mut scene = scene(random);
    scene.corrections = Corrections::ALL;
    scene.courant *= 0.61;
    let kind = random.whole(0..4);
    let (s, t) = (random.between(0.3, 0.9), random.between(0.07, 0.93));
    let law = |modulus: f64| match kind {
        0 => Law::Polynomial { coefficients: vec![modulus, -2.3 * s * modulus, 7.1 * t * modulus] },
        1 => Law::Exponential { a: modulus / (11.0 * s), b: 11.0 * s },
        2 => Law::Viscoelastic {
            equilibrium_modulus: (1.0 - s) * modulus,
            arms: vec![Arm { modulus: s * modulus, relaxation_time: 19e-6 * t }],
            update: Default::default(),
        },
        _ => Law::Eyring {
            equilibrium_modulus: (1.0 - s) * modulus,
            modulus: s * modulus,
            rate: 1.3e3 * t,
            stress: 5.7e7 * s,
            update: Default::default(),
        },
    };
    let other = |material: &mut Material| {
        *material = Material::from(law(material.instantaneous_modulus()));
    };
    other(&mut scene.primary.material);
    if let Some(secondary) = &mut scene.secondary {
        other(&mut secondary.material);
    }
    scene
}

fn wave_speed(scene: &Scene) -> f64 {
    (scene.primary.material.instantaneous_modulus() / scene.primary.density).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_drawn_scene_passes_the_check_and_a_seed_draws_the_same_again() {
        let scenes = |seed| {
            let random = &mut SplitMix::new(seed);
            let linear = (0..200).map(|_| scene(random)).collect::<Vec<_>>();
            let others = (0..50).map(|_| scene_of_another_law(random));
            linear.into_iter().chain(others).collect::<Vec<_>>()
        };
        let drawn = scenes(11);
        for scene in &drawn {
            scene.check().unwrap_or_else(|problem| panic!("{problem:?}: {scene:?}"));
        }
        assert_eq!(drawn, scenes(11));
        assert_ne!(drawn, scenes(12));
        let of = |what: fn(&Scene) -> bool| drawn.iter().filter(|s| what(s)).count();
        assert!(of(|s| s.secondary.is_none()) > 50);
        assert!(of(|s| s.secondary.as_ref().is_some_and(|f| f.at == 0.0)) > 20);
        assert!(of(|s| s.projectile.mass.is_some()) > 80);
        assert!(of(|s| s.corrections == Corrections::NONE) > 15);
        assert!(of(Scene::has_other_laws) >= 50);
    }

    /// A seed draws the same scene first, whichever law it is then given. What a parameter may be follows
    /// from 0.3 ≤ s < 0.9 and 0.07 ≤ t < 0.93.
    #[test]
    fn another_law_has_the_modulus_at_rest_that_was_drawn_and_parameters_in_their_ranges() {
        let mut kinds = [0; 4];
        for seed in 0..80 {
            let linear = scene(&mut SplitMix::new(seed));
            let other = scene_of_another_law(&mut SplitMix::new(seed));
            assert_eq!((&other.projectile, other.strain), (&linear.projectile, linear.strain));
            assert_eq!(other.courant, 0.61 * linear.courant);
            assert_eq!(other.materials().count(), linear.materials().count());
            for (other, linear) in other.materials().zip(linear.materials()) {
                let modulus = linear.instantaneous_modulus();
                // A product or a sum of two parts, each of them rounded once or twice.
                let apart = other.instantaneous_modulus() / modulus - 1.0;
                assert!(apart.abs() < 1e-15, "{other:?} of {modulus}");
                let is_part = |part: f64| (0.3..0.9).contains(&(part / modulus));
                match &other.law {
                    Law::Polynomial { coefficients } => {
                        kinds[0] += 1;
                        let [_, second, third] = coefficients[..] else { panic!("{other:?}") };
                        assert!((-2.07..-0.69).contains(&(second / modulus)), "{other:?}");
                        assert!((0.497..6.603).contains(&(third / modulus)), "{other:?}");
                    }
                    Law::Exponential { b, .. } => {
                        kinds[1] += 1;
                        assert!((3.3..9.9).contains(b), "{other:?}");
                    }
                    Law::Viscoelastic { arms, .. } => {
                        kinds[2] += 1;
                        let [Arm { modulus: arm, relaxation_time }] = arms[..] else {
                            panic!("{other:?}")
                        };
                        assert!(is_part(arm), "{other:?}");
                        assert!((1.33e-6..17.67e-6).contains(&relaxation_time), "{other:?}");
                    }
                    Law::Eyring { modulus: arm, rate, stress, .. } => {
                        kinds[3] += 1;
                        assert!(is_part(*arm), "{other:?}");
                        assert!((91.0..1209.0).contains(rate), "{other:?}");
                        assert!((1.71e7..5.13e7).contains(stress), "{other:?}");
                    }
                    Law::Linear { .. } => panic!("{other:?}"),
                }
            }
        }
        // Each law is as likely as the others; none in 80 throws would be one chance in 10¹⁰.
        assert!(kinds.iter().all(|&drawn| drawn > 0), "{kinds:?}");
    }
}
