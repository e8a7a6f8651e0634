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
    use crate::conform::session::up_to;

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

    fn count_of_steps(scene: &Scene) -> u64 {
        Discretisation::<f64>::of(scene).steps(scene.duration)
    }

    #[test]
    fn all_that_is_not_needed_goes_in_the_end() {
        // Another law and all else that is not the simplest, of which only the crossing fibre matters.
        let mut scene = shipped("viscoelastic");
        scene.strain = Strain::Engineering;
        let small = shrink(&scene, 1000, |scene| scene.secondary.is_some());
        let secondary = small.secondary.as_ref().unwrap();
        assert_eq!((count_of_steps(&small), secondary.elements), (1, 2));
        assert_eq!((small.projectile.mass, small.strain), (None, Strain::Incremental));
        assert!(!small.has_other_laws());
        assert_eq!((secondary.slide_factor, secondary.density), (1.0, small.primary.density));
        assert_eq!(secondary.material, small.primary.material);
        assert_eq!((small.projectile.velocity, small.courant), (320.0, 0.94));
        // 317 m/s and 0.937 before that.
        assert_eq!((scene.projectile.velocity, scene.courant), (317.0, 0.937));
    }

    /// A fault that needs five steps as long as the projectile has a mass: that the mass can go is seen
    /// after no fewer steps would do.
    #[test]
    fn what_becomes_possible_by_a_later_change_is_tried_again() {
        let scene = shipped("finite-projectile");
        assert!(scene.projectile.mass.is_some() && count_of_steps(&scene) > 5);
        let shows = |scene: &Scene| scene.projectile.mass.is_none() || count_of_steps(scene) >= 5;
        let small = shrink(&scene, 1000, shows);
        assert_eq!((small.projectile.mass, count_of_steps(&small)), (None, 1));
    }

    #[test]
    fn fewer_elements_are_a_shorter_fibre_of_two_at_least_that_reaches_the_crossover() {
        let mut scene = shipped("fig3");
        (scene.primary.length, scene.primary.elements) = (0.5, 8);
        let at = |at: f64, scene: &Scene| {
            let mut scene = scene.clone();
            scene.secondary.as_mut().unwrap().at = at;
            scene
        };
        let shorter = primary_elements(&at(0.2, &scene), |n| n / 2).unwrap().primary;
        assert_eq!((shorter.length, shorter.elements), (0.25, 4));
        assert_eq!(primary_elements(&at(0.25, &scene), |n| n / 2), None);
        assert_eq!(primary_elements(&at(0.3, &scene), |n| n / 2), None);
        scene.secondary.as_mut().unwrap().elements = 3;
        let two = secondary_elements(&scene, |n| n - 1).unwrap().secondary.unwrap();
        assert_eq!(two.elements, 2);
        assert_eq!(secondary_elements(&scene, |n| n / 2), None);
        scene.secondary = None;
        assert_eq!(secondary_elements(&scene, |n| n / 2), None);
        let elements =
            |fewer: fn(usize) -> usize| primary_elements(&scene, fewer).map(|s| s.primary.elements);
        assert_eq!((elements(|_| 2), elements(|_| 1)), (Some(2), None));
    }

    #[test]
    fn a_change_that_changes_nothing_is_none() {
        let scene = shipped("fig3");
        assert_eq!(changed(&scene, |scene| scene.strain = Strain::Incremental), None);
        let other = changed(&scene, |scene| scene.strain = Strain::Engineering).unwrap();
        assert_eq!(other.strain, Strain::Engineering);
        assert_eq!(round(&scene, |scene| &mut scene.projectile.velocity), None); // 400
        let round = round(&scene, |scene| &mut scene.primary.density).unwrap(); // 1206.7
        assert_eq!(round.primary.density, 1200.0);
        let one = up_to(&scene, 1, Discretisation::of(&scene).time_step);
        assert_eq!(steps(&one, |steps| steps - 1), None);
        let two = up_to(&scene, 2, Discretisation::of(&scene).time_step);
        assert_eq!(steps(&two, |steps| steps - 1).map(|scene| count_of_steps(&scene)), Some(1));
        assert_eq!(materials(&mut scene.clone()).count(), 2);
    }
}
