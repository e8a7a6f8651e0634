//! Any scene that passes its check ends in finite numbers and says how it ended, over the whole box of
//! parameters.

#![allow(clippy::unwrap_used)] // a test may

mod common;

use std::collections::BTreeMap;

use common::{cases, shipped, trace};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::outcome::Outcome;
use crossfibre::plan::Plan;
use crossfibre::result::{self, FibreResult, RunResult};
use crossfibre::scene::{Material, Primary, Projectile, Scene, Secondary, Strain};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

/// Ten to a power between two.
fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(pxfm::f_exp10)
}

/// Length, elements, density, area, modulus.
type Numbers = (f64, usize, f64, f64, f64);

/// Fibres that could be made, and more.
fn sensible() -> BoxedStrategy<Numbers> {
    let (length, density, area) = (decades(-3.0, 2.0), decades(1.0, 5.0), decades(-9.0, -2.0));
    (length, 2..40_usize, density, area, decades(6.0, 12.0)).boxed()
}

/// Fibres from the edge of the numbers to the other.
fn wild() -> BoxedStrategy<Numbers> {
    let any = || decades(-60.0, 60.0);
    (any(), 2..40_usize, any(), any(), any()).boxed()
}

fn corrections() -> impl Strategy<Value = Corrections> {
    let subset = any::<u32>().prop_map(|bits| {
        let chosen = Erratum::ALL.iter().enumerate().filter(|(i, _)| bits >> i & 1 == 1);
        chosen.map(|(_, &erratum)| erratum).collect()
    });
    prop_oneof![2 => Just(Corrections::ALL), 1 => Just(Corrections::NONE), 2 => subset]
}

/// Scenes of such fibres: any velocity up to four wave speeds, any mass, Courant numbers on both sides
/// of the limit, every subset of the corrections, up to 120 steps.
fn scenes(numbers: fn() -> BoxedStrategy<Numbers>) -> impl Strategy<Value = Scene> {
    let slide_factor = prop_oneof![Just(0.0), Just(1.0), decades(-12.0, 0.0), 0.0..1.0];
    let at = prop_oneof![1 => Just(0.0), 4 => 0.0..1.0];
    let secondary = prop::option::of((numbers(), slide_factor, at));
    let projectile = (decades(-8.0, 0.6), prop::option::of(decades(-14.0, 14.0)));
    let courant = prop_oneof![Just(1.0), 0.5..1.0, decades(-3.0, 0.5)];
    let strain = prop_oneof![Just(Strain::Incremental), Just(Strain::Engineering)];
    (numbers(), secondary, projectile, courant, 1..120_u32, strain, corrections()).prop_map(
        |(primary, secondary, (mach, mass), courant, steps, strain, corrections)| {
            let (length, elements, density, area, modulus) = primary;
            let material = Material::Linear { modulus };
            let node = density * area * length / elements as f64;
            let velocity = mach * (modulus / density).sqrt();
            let secondary = secondary.map(|(numbers, slide_factor, at)| {
                let at = at * length;
                let (length, elements, density, area, modulus) = numbers;
                let material = Material::Linear { modulus };
                Secondary { at, length, elements, density, area, material, slide_factor }
            });
            let mut scene = Scene {
                primary: Primary { length, elements, density, area, material },
                secondary,
                projectile: Projectile { velocity, mass: mass.map(|m| m * node) },
                courant,
                strain,
                corrections,
                ..shipped("single-400")
            };
            scene.duration = f64::from(steps) * Discretisation::<f64>::of(&scene).time_step;
            scene
        },
    )
}

fn all_finite(result: &RunResult) -> bool {
    let fibre = |f: &FibreResult| {
        let vectors = f.position.iter().chain(&f.velocity).flatten();
        vectors.chain(&f.strain).chain(&f.tension).all(|x| x.is_finite())
    };
    let projectile = &result.projectile;
    fibre(&result.primary)
        && result.secondary.as_ref().is_none_or(fibre)
        && [projectile.velocity, projectile.position, result.time].iter().all(|x| x.is_finite())
        && result.crossover.as_ref().is_none_or(|c| c.distance.is_finite())
}

/// The kind of the end of a scene that may be run, if all is as it must be; of another, that it is
/// refused.
fn ends_well(scene: &Scene) -> Result<&'static str, TestCaseError> {
    if scene.check().is_err() {
        return Ok("refused");
    }
    let result = result::run(scene, |_| ());
    prop_assert!(all_finite(&result), "{}", result.outcome);
    let planned = Plan::of(scene).steps;
    prop_assert_eq!(result.time, result.steps as f64 * result.time_step);
    match &result.outcome {
        Outcome::Completed => {
            let balance = result.balance.unwrap();
            prop_assert!(balance.is_finite());
            prop_assert!(balance.energy.relative_residual().abs() <= result::MOST_IMBALANCE);
            prop_assert_eq!(result.steps, planned);
            // One fibre: the equations telescope to the tensions of its ends. Rounding: 120 steps
            // and 40 nodes.
            if scene.secondary.is_none() && scene.corrections == Corrections::ALL {
                let momentum = balance.momentum;
                let entered = [momentum.initial, momentum.drive, momentum.clamps, momentum.fibres];
                let size = entered.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                prop_assert!(momentum.residual.abs() <= 1e-13 * size, "{momentum:?}");
            }
            Ok("completed")
        }
        Outcome::Diverged { place, equation } => {
            prop_assert_eq!(result.steps, place.step - 1);
            // The first number of the trace that is not finite is the one that is named.
            let (_, outcome, events) = trace(scene);
            prop_assert_eq!(&outcome, &result.outcome);
            let first = events.iter().find(|e| e.output.iter().any(|x| !x.is_finite())).unwrap();
            prop_assert_eq!((first.place, first.equation), (*place, *equation));
            Ok("diverged")
        }
        Outcome::CrossoverLeft { step, .. } => {
            prop_assert_eq!(result.steps, *step);
            Ok("crossover left")
        }
        Outcome::EnergyUnbalanced { step, .. } => {
            prop_assert_eq!((result.steps, *step), (planned, planned));
            Ok("energy unbalanced")
        }
        other => Err(TestCaseError::fail(format!("what is {other}?"))),
    }
}

/// Runs so many scenes; every kind of end must have been among them.
fn all_end_well(scenes: impl Strategy<Value = Scene>, count: u32) {
    let mut kinds = BTreeMap::new();
    let config = ProptestConfig { rng_seed: RngSeed::Fixed(0x1980), ..cases(count) };
    let counts = std::cell::RefCell::new(&mut kinds);
    TestRunner::new(config)
        .run(&scenes, |scene| {
            let kind = ends_well(&scene)?;
            *counts.borrow_mut().entry(kind).or_insert(0_u32) += 1;
            Ok(())
        })
        .unwrap();
    let all = ["completed", "crossover left", "diverged", "energy unbalanced", "refused"];
    assert_eq!(kinds.keys().copied().collect::<Vec<_>>(), all, "{kinds:?}");
    assert!(kinds["completed"] > count / 10, "{kinds:?}");
}

#[test]
fn fibres_that_could_be_made_end_in_a_number_or_an_outcome() {
    all_end_well(scenes(sensible), 4000);
}

#[test]
fn fibres_from_one_edge_of_the_numbers_to_the_other_do_so_too() {
    all_end_well(scenes(wild), 6000);
}
