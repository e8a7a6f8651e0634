//! The smallest scene that still shows a fault.
//!
//! Each change that makes a scene simpler is tried in turn and kept if the fault is still there, until
//! none is left that can be kept.

use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::scene::{Material, Scene, Strain};

/// A change that may make a scene simpler; none where there is nothing to change.
type Change = fn(&Scene) -> Option<Scene>;

const CHANGES: &[Change] = &[
    |scene| scene.secondary.is_some().then(|| Scene { secondary: None, ..scene.clone() }),
    |scene| steps(scene, |steps| steps / 2),
    |scene| steps(scene, |steps| steps - 1),
    |scene| primary_elements(scene, |n| n / 2),
    |scene| primary_elements(scene, |n| n - 1),
    |scene| secondary_elements(scene, |n| n / 2),
    |scene| secondary_elements(scene, |n| n - 1),
    |scene| {
        let mut simpler = scene.clone();
        simpler.projectile.mass.take().map(|_| simpler)
    },
    |scene| changed(scene, |scene| scene.strain = Strain::Incremental),
    |scene| changed(scene, |scene| scene.corrections = Corrections::ALL),
    |scene| {
        changed(scene, |scene| {
            for material in materials(scene) {
                *material = Material::linear(material.instantaneous_modulus());
            }
        })
    },
    |scene| {
        changed(scene, |scene| {
            if let Some(secondary) = &mut scene.secondary {
                secondary.slide_factor = 1.0;
            }
        })
    },
    |scene| {
        // Two equal fibres are simpler than two unlike ones.
        changed(scene, |scene| {
            if let Some(secondary) = &mut scene.secondary {
                secondary.density = scene.primary.density;
                secondary.area = scene.primary.area;
                secondary.material = scene.primary.material.clone();
            }
        })
    },
    |scene| round(scene, |scene| &mut scene.projectile.velocity),
    |scene| round(scene, |scene| &mut scene.primary.length),
    |scene| round(scene, |scene| &mut scene.primary.density),
    |scene| round(scene, |scene| &mut scene.primary.area),
    |scene| round(scene, |scene| &mut scene.courant),
];

/// A scene made as small as it can be while `shows` says that the fault is in it, in at most so many
/// tries.
pub fn shrink(scene: &Scene, tries: usize, mut shows: impl FnMut(&Scene) -> bool) -> Scene {
    let mut smallest = scene.clone();
    let mut left = tries;
    loop {
        let before = smallest.clone();
        for change in CHANGES {
            while let Some(simpler) = change(&smallest)
                && left > 0
                && simpler != smallest
                && simpler.check().is_ok()
            {
                left -= 1;
                if !shows(&simpler) {
                    break;
                }
                smallest = simpler;
            }
        }
        if smallest == before || left == 0 {
            return smallest;
        }
    }
}

fn changed(scene: &Scene, change: impl FnOnce(&mut Scene)) -> Option<Scene> {
    let mut simpler = scene.clone();
    change(&mut simpler);
    (simpler != *scene).then_some(simpler)
}

fn materials(scene: &mut Scene) -> impl Iterator<Item = &mut Material> {
    let secondary = scene.secondary.as_mut().map(|secondary| &mut secondary.material);
    [Some(&mut scene.primary.material), secondary].into_iter().flatten()
}

fn steps(scene: &Scene, fewer: fn(u64) -> u64) -> Option<Scene> {
    let mesh = Discretisation::<f64>::of(scene);
    let steps = mesh.steps(scene.duration);
    let wanted = fewer(steps);
    (wanted >= 1).then(|| super::session::up_to(scene, wanted, mesh.time_step))
}

/// Fewer elements of the same length: the fibre gets shorter, and the time step stays.
fn primary_elements(scene: &Scene, fewer: fn(usize) -> usize) -> Option<Scene> {
    let elements = fewer(scene.primary.elements);
    let mut simpler = scene.clone();
    simpler.primary.length *= elements as f64 / scene.primary.elements as f64;
    simpler.primary.elements = elements;
    let fits = scene.secondary.as_ref().is_none_or(|s| s.at < simpler.primary.length);
    (elements >= 2 && fits).then_some(simpler)
}

fn secondary_elements(scene: &Scene, fewer: fn(usize) -> usize) -> Option<Scene> {
    let mut simpler = scene.clone();
    let secondary = simpler.secondary.as_mut()?;
    let elements = fewer(secondary.elements);
    secondary.length *= elements as f64 / secondary.elements as f64;
    secondary.elements = elements;
    (elements >= 2).then_some(simpler)
}

/// A number with two digits in the place of all.
fn round(scene: &Scene, number: fn(&mut Scene) -> &mut f64) -> Option<Scene> {
    let mut simpler = scene.clone();
    let number = number(&mut simpler);
    *number = format!("{number:.1e}").parse().ok()?;
    (simpler != *scene).then_some(simpler)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn a_scene_shrinks_to_what_the_fault_needs() {
        let scene = shipped("unequal");
        // A fault that shows from 7 elements of the secondary and 5 steps on, with sliding.
        let steps = |scene: &Scene| Discretisation::<f64>::of(scene).steps(scene.duration);
        let mut tried = 0;
        let shows = |scene: &Scene| {
            let crossing = scene.secondary.as_ref();
            steps(scene) >= 5 && crossing.is_some_and(|s| s.elements >= 7 && s.slide_factor < 1.0)
        };
        assert!(shows(&scene), "{scene:?}");
        let small = shrink(&scene, 1000, |scene| {
            tried += 1;
            shows(scene)
        });
        assert!(shows(&small) && small.check().is_ok());
        assert_eq!((steps(&small), small.secondary.as_ref().map(|s| s.elements)), (5, Some(7)));
        assert_eq!(small.projectile.mass, None);
        assert!(
            small.primary.elements < scene.primary.elements && tried < 200,
            "{small:?} {tried}"
        );
    }

    #[test]
    fn no_more_is_tried_than_allowed_and_what_shows_nothing_smaller_stays() {
        let scene = shipped("fig3");
        let mut tried = 0;
        let same = shrink(&scene, 1000, |_| {
            tried += 1;
            false
        });
        assert_eq!(same, scene);
        assert!(tried <= CHANGES.len());
        tried = 0;
        shrink(&scene, 4, |_| {
            tried += 1;
            true
        });
        assert_eq!(tried, 4);
    }
}
