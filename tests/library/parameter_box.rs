//! Any scene that passes its check ends in finite numbers and says how it ended, over the whole box of
//! parameters.

use std::collections::BTreeMap;

use crate::common::{cases, shipped, trace};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::material::{Arm, Coefficients, Update};
use crossfibre::outcome::Outcome;
use crossfibre::plan::Plan;
use crossfibre::result::{self, FibreResult, RunResult};
use crossfibre::scene::{Law, Material, Primary, Projectile, Scene, Secondary, Strain};
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

/// Eqn (7), and nothing else.
fn page() -> BoxedStrategy<Shape> {
    Just(Shape {
        law: |modulus, _, _| Law::Linear { modulus },
        s: 0.0,
        t: 0.0,
        tension_only: false,
        viscosity: None,
    })
    .boxed()
}

/// Any law, with two numbers to shape it and what may be added to it.
fn any_law() -> BoxedStrategy<Shape> {
    let sign = || prop_oneof![Just(1.0), Just(-1.0)];
    let viscosity = (decades(-3.0, 0.0), decades(-2.0, 1.0))
        .prop_map(|(linear, quadratic)| Coefficients { linear, quadratic });
    let signed = || (sign(), decades(-6.0, 3.0)).prop_map(|(sign, size)| sign * size);
    (prop::sample::select(LAWS), signed(), signed(), any::<bool>(), prop::option::of(viscosity))
        .prop_map(|(law, s, t, tension_only, viscosity)| Shape {
            law,
            s,
            t,
            tension_only,
            viscosity,
        })
        .boxed()
}

/// A law of instantaneous modulus E, made by two numbers of any size and sign.
type Make = fn(f64, f64, f64) -> Law;

#[derive(Clone, Copy, Debug)]
struct Shape {
    law: Make,
    s: f64,
    t: f64,
    tension_only: bool,
    viscosity: Option<Coefficients>,
}

impl Shape {
    fn material(self, modulus: f64) -> Material {
        let Self { law, s, t, tension_only, viscosity } = self;
        Material { law: law(modulus, s, t), tension_only, artificial_viscosity: viscosity }
    }
}

const LAWS: &[Make] = &[
    |modulus, _, _| Law::Linear { modulus },
    |e, s, t| Law::Polynomial { coefficients: vec![e, e * s, e * t] },
    |e, s, _| Law::Exponential { a: e / s, b: s },
    |e, s, t| Law::Viscoelastic {
        equilibrium_modulus: if t > 0.0 { 0.37 * e } else { 0.0 },
        arms: vec![
            Arm { modulus: 0.41 * e, relaxation_time: 1e-6 * s.abs() },
            Arm { modulus: 0.22 * e, relaxation_time: 1e-3 * t.abs() },
        ],
        update: if s > 0.0 { Update::Exact } else { Update::Literal },
    },
    |e, s, t| Law::Eyring {
        equilibrium_modulus: if t > 0.0 { 0.37 * e } else { 0.0 },
        modulus: 0.63 * e,
        rate: 1e3 * t.abs() * t.abs(),
        stress: 1e-3 * e * s.abs(),
        update: if s > 0.0 { Update::Exact } else { Update::Literal },
    },
];

/// Scenes of such fibres and materials: any velocity up to four wave speeds, any mass, Courant numbers on both sides
/// of the limit, every subset of the corrections, up to 120 steps.
fn scenes(
    numbers: fn() -> BoxedStrategy<Numbers>,
    law: fn() -> BoxedStrategy<Shape>,
) -> impl Strategy<Value = Scene> {
    let slide_factor = prop_oneof![Just(0.0), Just(1.0), decades(-12.0, 0.0), 0.0..1.0];
    let at = prop_oneof![1 => Just(0.0), 4 => 0.0..1.0];
    let secondary = prop::option::of((numbers(), law(), slide_factor, at));
    let projectile = (decades(-8.0, 0.6), prop::option::of(decades(-14.0, 14.0)));
    let courant = prop_oneof![Just(1.0), 0.5..1.0, decades(-3.0, 0.5)];
    let strain = prop_oneof![Just(Strain::Incremental), Just(Strain::Engineering)];
    ((numbers(), law()), secondary, projectile, courant, 1..120_u32, strain, corrections())
        .prop_map(
            |((primary, law), secondary, (mach, mass), courant, steps, strain, corrections)| {
                let (length, elements, density, area, modulus) = primary;
                let material = law.material(modulus);
                let node = density * area * length / elements as f64;
                let velocity = mach * (modulus / density).sqrt();
                let secondary = secondary.map(|(numbers, law, slide_factor, at)| {
                    let at = at * length;
                    let (length, elements, density, area, modulus) = numbers;
                    let material = law.material(modulus);
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
            // The first number of the trace that is not finite is the one that is named. None is
            // where a length vanished, (6), or where a tension is too great for its length, (7).
            let (_, outcome, events) = trace(scene);
            prop_assert_eq!(&outcome, &result.outcome);
            let first = events.iter().find(|e| e.output.iter().any(|x| !x.is_finite()));
            match first {
                Some(first) => prop_assert_eq!((first.place, first.equation), (*place, *equation)),
                None => {
                    prop_assert_eq!(events.last().map(|e| e.place), Some(*place));
                    prop_assert!(matches!(equation, 6 | 7));
                }
            }
            Ok("diverged")
        }
        Outcome::CourantExceeded { place, courant, would_serve, search_given_up } => {
            // Eighty elements at most: far from the bound of the search.
            prop_assert!(!search_given_up);
            prop_assert_eq!(result.steps, place.step - 1);
            prop_assert!(*courant > 1.0);
            prop_assert_eq!(without_advice(&trace(scene).1), without_advice(&result.outcome));
            if let Some(served) = *would_serve {
                prop_assert!(served < scene.courant);
                let again = result::run(&Scene { courant: served, ..scene.clone() }, |_| ());
                prop_assert_eq!(again.outcome, Outcome::Completed);
            }
            Ok("courant exceeded")
        }
        Outcome::NoWaves { place, .. } => {
            prop_assert_eq!(result.steps, place.step - 1);
            prop_assert_eq!(&trace(scene).1, &result.outcome);
            Ok("no waves")
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

/// A march does not know what would have served; the run tries it.
fn without_advice(outcome: &Outcome) -> Outcome {
    match *outcome {
        Outcome::CourantExceeded { place, courant, .. } => {
            Outcome::CourantExceeded { place, courant, would_serve: None, search_given_up: false }
        }
        ref other => other.clone(),
    }
}

/// Runs so many scenes; these kinds of end must have been among them.
fn all_end_well(scenes: impl Strategy<Value = Scene>, count: u32, all: &[&str]) {
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
    assert!(all.iter().all(|kind| kinds.contains_key(kind)), "{kinds:?}");
    assert!(kinds["completed"] > count / 10, "{kinds:?}");
}

/// The literal update of a flowing arm throws the first element out of its law's bounds and the
/// second out of the numbers, in one step.
#[test]
fn of_a_breach_and_an_overflow_in_one_block_the_nearer_to_the_impact_is_named() {
    let mut scene = shipped("single-400");
    (scene.primary.length, scene.primary.elements) = (0.051_107_506_894_972_98, 7);
    (scene.primary.density, scene.primary.area) = (18_358.107_226_044_83, 0.01);
    scene.primary.material = Material {
        law: Law::Eyring {
            equilibrium_modulus: 115_813_918_707.146_33,
            modulus: 197_196_672_393.249_18,
            rate: 1_899_442.997_128_669_6,
            stress: 815_219.113_197_054_6,
            update: Update::Literal,
        },
        tension_only: true,
        artificial_viscosity: Some(Coefficients {
            linear: 1.0,
            quadratic: 0.016_378_134_106_906_632,
        }),
    };
    scene.projectile.velocity = 0.262_304_603_541_088_2;
    (scene.courant, scene.duration) = (0.963_792_559_488_408_8, 6.816_550_416_118_485e-6);
    assert_eq!(ends_well(&scene).unwrap(), "courant exceeded");
}

const OF_THE_PAGE: &[&str] =
    &["completed", "crossover left", "diverged", "energy unbalanced", "refused"];

#[test]
fn fibres_that_could_be_made_end_in_a_number_or_an_outcome() {
    all_end_well(scenes(sensible, page), 4000, OF_THE_PAGE);
}

#[test]
fn fibres_from_one_edge_of_the_numbers_to_the_other_do_so_too() {
    all_end_well(scenes(wild, page), 6000, OF_THE_PAGE);
}

#[test]
fn so_do_fibres_of_any_law() {
    let all = [OF_THE_PAGE, &["courant exceeded", "no waves"]].concat();
    all_end_well(scenes(sensible, any_law), 1500, &all);
}
