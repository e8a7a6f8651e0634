//! One scene, and the same with one thing more.

use crossfibre::material::{Arm, Coefficients, Update};
use crossfibre::scene::{Law, Material, Scene, Secondary, Strain};

use crate::cases::support::shipped;

/// A scene with one thing more than the first.
pub struct Variant {
    /// What it has.
    pub what: &'static str,
    /// The scene.
    pub scene: Scene,
    /// The command that runs it, before the scene's file.
    pub command: &'static [&'static str],
}

const RUN: &[&str] = &["run", "--quiet"];

/// Every event is made; none is kept, for nothing gets that far.
const TRACE: &[&str] = &["trace", "--index", "2399", "--output", "/dev/null"];

const ELEMENTS: usize = 2400;
const STEPS: f64 = 500.0;

/// The scene that the others are held against: one fibre of the page's law, a projectile of constant
/// velocity, the strain of (4), no trace. The front stays in the fibre.
fn plain() -> Scene {
    let mut scene = shipped("single-400");
    scene.primary.length *= ELEMENTS as f64 / scene.primary.elements as f64;
    scene.primary.elements = ELEMENTS;
    // A law that hardens by a few per cent must not outgrow the step.
    scene.courant = 0.87;
    let spacing = scene.primary.length / ELEMENTS as f64;
    let wave_speed = (modulus(&scene) / scene.primary.density).sqrt();
    scene.duration = STEPS * scene.courant * spacing / wave_speed;
    scene
}

fn modulus(scene: &Scene) -> f64 {
    scene.primary.material.instantaneous_modulus()
}

/// The scene with another law of the same initial modulus E.
fn made_of(law: impl FnOnce(f64) -> Law) -> Scene {
    let mut scene = plain();
    scene.primary.material = law(modulus(&scene)).into();
    scene
}

fn viscoelastic(modulus: f64, arms: usize) -> Law {
    let share = modulus / (arms + 1) as f64;
    let arm = |k: usize| Arm { modulus: share, relaxation_time: 3.1e-6 * (k + 1) as f64 };
    Law::Viscoelastic {
        equilibrium_modulus: share,
        arms: (0..arms).map(arm).collect(),
        update: Update::Exact,
    }
}

fn changed(change: impl FnOnce(&mut Material)) -> Scene {
    let mut scene = plain();
    change(&mut scene.primary.material);
    scene
}

fn crossed() -> Scene {
    let scene = plain();
    let spacing = scene.primary.length / ELEMENTS as f64;
    let secondary = Secondary {
        at: 37.0 * spacing,
        length: scene.primary.length,
        elements: ELEMENTS,
        density: scene.primary.density,
        area: scene.primary.area,
        material: scene.primary.material.clone(),
        slide_factor: 1.0,
    };
    Scene { secondary: Some(secondary), ..scene }
}

/// All of them, the plain one first.
pub fn variants() -> Vec<Variant> {
    let run = |what, scene| Variant { what, scene, command: RUN };
    let mut heavy = plain();
    heavy.projectile.mass = Some(0.00113);
    vec![
        run("nothing more", plain()),
        run("engineering strain", Scene { strain: Strain::Engineering, ..plain() }),
        run("a projectile with a mass", heavy),
        run("a crossing fibre, in three dimensions", crossed()),
        run("tension only", changed(|material| material.tension_only = true)),
        run(
            "artificial viscosity",
            changed(|material| {
                material.artificial_viscosity = Some(Coefficients { linear: 0.06, quadratic: 0.0 });
            }),
        ),
        run(
            "a softening polynomial of three terms",
            made_of(|e| Law::Polynomial { coefficients: vec![e, -3.0 * e, -7.0 * e] }),
        ),
        run("a softening exponential", made_of(|e| Law::Exponential { a: -e / 9.0, b: -9.0 })),
        run("one Maxwell arm", made_of(|e| viscoelastic(e, 1))),
        run("three Maxwell arms", made_of(|e| viscoelastic(e, 3))),
        run(
            "an Eyring arm",
            made_of(|e| Law::Eyring {
                equilibrium_modulus: 0.6 * e,
                modulus: 0.4 * e,
                rate: 1.3e3,
                stress: 5.7e7,
                update: Update::Exact,
            }),
        ),
        Variant { what: "a trace, nothing of it kept", scene: plain(), command: TRACE },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_variant_can_be_run_and_no_front_reaches_a_clamp() {
        for Variant { what, mut scene, .. } in variants() {
            scene.duration *= 2.0;
            scene.check().unwrap_or_else(|problem| panic!("{what}: {problem}"));
            let result = crate::wide::run(&scene, |_| ());
            assert!(result.outcome.is_completed(), "{what}: {}", result.outcome);
            assert_eq!(result.primary.strain.last(), Some(&0.0), "{what}");
        }
    }

    /// What is compared differs in nothing but the one thing: the spacing of the shipped scene, its wave
    /// speed but for rounding, and so many steps.
    #[test]
    fn every_variant_has_the_same_mesh_steps_and_initial_modulus() {
        let shipped = shipped("single-400");
        let spacing = shipped.primary.length / shipped.primary.elements as f64;
        for Variant { what, scene, .. } in variants() {
            let found = scene.primary.length / scene.primary.elements as f64;
            // Relative, 1e-15: roundings of four operations of half a unit each.
            assert!((found / spacing - 1.0).abs() < 1e-15, "{what}: {found}");
            assert_eq!(crate::timing::march::steps(&scene), 500, "{what}");
            // Relative, 1e-15: a sum of four quarters of it.
            let ratio = modulus(&scene) / modulus(&shipped);
            assert!((ratio - 1.0).abs() < 1e-15, "{what}: {ratio}");
        }
    }

    /// 125 µs are run: within that all three relax, each by itself.
    #[test]
    fn arms_relax_at_multiples_of_the_first_time() {
        let Law::Viscoelastic { arms, .. } = viscoelastic(1e9, 3) else { unreachable!() };
        let tenths = arms.iter().map(|arm| (1e7 * arm.relaxation_time).round());
        assert_eq!(tenths.collect::<Vec<_>>(), [31.0, 62.0, 93.0]);
    }

    #[test]
    fn what_a_scene_does_not_have_is_not_evaluated() {
        let counts = |what: &str| {
            let variant = variants().into_iter().find(|variant| variant.what == what).unwrap();
            crate::wide::run(&variant.scene, |_| ()).counts
        };
        let numbers = |what| counts(what).equations.into_keys().collect::<Vec<_>>();
        assert_eq!(numbers("nothing more"), [2, 4, 5, 6, 7]);
        assert_eq!(numbers("engineering strain"), [2, 4, 6, 7]);
        assert_eq!(numbers("a projectile with a mass"), [2, 4, 5, 6, 7, 8]);
        let crossed = numbers("a crossing fibre, in three dimensions");
        assert_eq!(crossed, [2, 4, 5, 6, 7, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18]);
        // (7) by a law is one evaluation an element, as by the page.
        let arm = counts("an Eyring arm");
        assert!(arm.equations.values().all(|&times| times == arm.element_steps), "{arm:?}");
        assert_eq!(numbers("an Eyring arm"), [2, 4, 5, 6, 7]);
    }
}
