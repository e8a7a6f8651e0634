//! A run that goes wrong ends with a type that says where.

use crate::common::{Recorder, run, shipped, steps, trace};
use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::Vector;
use crossfibre::outcome::Outcome;
use crossfibre::paper::{Paper, Printed};
use crossfibre::place::{Fibre, Place};
use crossfibre::result;
use crossfibre::scene::{Law, Material, Scene, Strain};
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::Traced;

/// A coarse mesh, so that a run into infinity is short.
fn coarse(name: &str, courant: f64, duration: f64) -> Scene {
    let mut scene = shipped(name);
    scene.primary.elements = 23;
    if let Some(secondary) = &mut scene.secondary {
        secondary.elements = 17;
    }
    (scene.courant, scene.duration) = (courant, duration);
    scene.check().unwrap();
    scene
}

#[test]
fn a_run_above_the_stable_courant_number_does_not_complete() {
    for name in ["single-400", "unequal"] {
        for courant in [1.2, 1.7] {
            let scene = Scene { courant, duration: 61.3e-6, ..shipped(name) };
            let result = result::run(&scene, |_| ());
            assert!(!result.outcome.is_completed(), "{name} at {courant}");
        }
        // And the same scene at its own Courant number does.
        let scene = Scene { duration: 61.3e-6, ..shipped(name) };
        assert_eq!(result::run(&scene, |_| ()).outcome, Outcome::Completed, "{name}");
    }
}

/// Runs into infinity: an unstable single fibre, an unstable crossover, a struck pair, and projectiles
/// that the printed sign throws away.
fn diverging() -> Vec<(&'static str, Scene)> {
    // Without the node's inertia a mass near the end of the numbers throws the projectile there.
    let light = |mass| {
        let mut scene = coarse("finite-projectile", 0.937, 9.7e-3);
        scene.corrections = Corrections::NONE;
        scene.projectile.mass = Some(mass);
        scene
    };
    // Engineering strain follows the length, so that growth goes on to the end of the numbers.
    let engineering = |name| Scene { strain: Strain::Engineering, ..coarse(name, 2.9, 9.7e-3) };
    vec![
        ("single", engineering("single-400")),
        ("crossed", engineering("unequal")),
        ("at origin", engineering("both-at-origin")),
        ("light projectile", light(1.3e-306)),
        ("lighter projectile", light(1.3e-315)),
    ]
}

#[test]
fn a_diverged_run_names_the_first_equation_of_the_step_that_is_not_finite() {
    let mut equations = Vec::new();
    for (name, scene) in diverging() {
        let (_, outcome, events) = trace(&scene);
        let Outcome::Diverged { place, equation } = outcome else {
            panic!("{name}: {outcome}");
        };
        let first = events.iter().find(|e| e.output.iter().any(|x| !x.is_finite())).map_or_else(
            || panic!("{name}: all is finite, but {outcome}"),
            |e| (e.place, e.equation),
        );
        assert_eq!((place, equation), first, "{name}");
        // The same from the march in blocks.
        let (state, untraced) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
            let fibre = &state.primary;
            assert!(fibre.tension.iter().all(|t| t.is_finite()), "{name}");
            assert!(fibre.velocity.iter().flatten().all(|v| v.is_finite()), "{name}");
        });
        assert_eq!(untraced, outcome, "{name}");
        assert_eq!(state.step, place.step, "{name}");
        assert!(place.step < steps(&scene), "{name}: {}", place.step);
        equations.push(equation);
    }
    assert!(equations.contains(&6) && equations.contains(&8), "{equations:?}");
}

#[test]
fn the_place_that_is_named_is_where_a_number_was_spoilt() {
    // One number of a run in its middle, beyond what the next equation can bear.
    type Spoil = fn(&mut State<f64>);
    let spoiled: [(Fibre, usize, u8, Spoil); 6] = [
        (Fibre::Primary, 9, 7, |s| s.primary.strain[9] = 1.3e307),
        (Fibre::Primary, 11, 6, |s| s.primary.velocity[12].x = 1.9e173),
        // The difference of two tensions, in (2); elsewhere they are equal.
        (Fibre::Primary, 13, 2, |s| {
            s.primary.pull.fill(Vector::<f64, 2>::new(1.3e308, 0.0));
            s.primary.pull[..13].fill(Vector::<f64, 2>::new(-1.3e308, 0.0));
        }),
        // A strain near the end of the numbers, to which (4) adds the growth of a length from next to nothing.
        (Fibre::Primary, 9, 4, |s| {
            s.primary.strain[9] = f64::MAX;
            s.primary.position[9] = Vector::<f64, 2>::zeros();
            s.primary.position[10] = Vector::<f64, 2>::new(1.3e-150, 0.0);
            s.primary.velocity[10].x = 1.3e152;
        }),
        (Fibre::Secondary, 3, 7, |s| s.crossover.as_mut().unwrap().fibre.strain[3] = 1.3e307),
        (Fibre::Secondary, 6, 6, |s| {
            s.crossover.as_mut().unwrap().fibre.velocity[7].z = 1.9e173;
        }),
    ];
    let scene = coarse("unequal", 0.937, 31.3e-6);
    let paper = Corrected::<Incremental>::new(scene.corrections);
    for (fibre, index, equation, spoil) in spoiled {
        let mut state: State<f64> = State::at_impact(&scene, Wavefront::Ignored);
        assert_eq!(march::run(&paper, &mut state, 9, |_| ()), Outcome::Completed);
        spoil(&mut state);
        let expected = Outcome::Diverged { place: Place { step: 10, fibre, index }, equation };
        let traced = Traced::new(&paper, Recorder::default());
        assert_eq!(march::run(&traced, &mut state.clone(), 3, |_| ()), expected);
        let events = traced.into_sink().0;
        let first = events.iter().find(|e| e.output.iter().any(|x| !x.is_finite())).unwrap();
        assert_eq!((first.place, first.equation), (Place { step: 10, fibre, index }, equation));
        assert_eq!(march::run(&paper, &mut state, 3, |_| ()), expected);
    }
}

#[test]
fn an_infinite_strain_ends_the_run_of_a_law_with_bounded_stress() {
    let mut scene = coarse("single-400", 0.937, 31.3e-6);
    // T → 2.93 GPa as ε → ∞.
    scene.primary.material = Law::Exponential { a: -2.93e9, b: -20.0 }.into();
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let mut state: State<f64> = State::at_impact(&scene, Wavefront::Ignored);
    assert_eq!(march::run(&paper, &mut state, 1, |_| ()), Outcome::Completed);
    state.primary.velocity[13].x = 1.9e173;
    let place = Place { step: 2, fibre: Fibre::Primary, index: 12 };
    let expected = Outcome::Diverged { place, equation: 6 };
    assert_eq!(march::run(&paper, &mut state, 3, |_| ()), expected);
}

#[test]
fn a_vanished_element_ends_the_run() {
    // E/ρ = 2²⁴, so c = 4096 m/s; Δx = 2⁻⁹ m and Δt = 2⁻²¹ s: struck along its axis at 4096 m/s, the
    // first node arrives in the first step exactly where the second still is.
    let mut scene = shipped("single-400");
    (scene.primary.length, scene.primary.elements) = (0.25, 128);
    scene.primary.density = 1024.0;
    scene.primary.material = Material::linear(1024.0 * 16_777_216.0);
    scene.projectile.velocity = 4096.0;
    let paper = Corrected::<Incremental>::new(Corrections::ALL);
    let mut state: State<f64> = State::at_impact(&scene, Wavefront::Flagged);
    assert_eq!(state.time_step, 2.0_f64.powi(-21));
    state.projectile.axis = Vector::<f64, 2>::new(1.0, 0.0);
    let outcome = march::run(&paper, &mut state, 10, |_| ());
    let place = Place { step: 1, fibre: Fibre::Primary, index: 0 };
    assert_eq!(outcome, Outcome::Diverged { place, equation: 6 });
    // A little slower it does not vanish.
    let mut state: State<f64> = State::at_impact(&scene, Wavefront::Flagged);
    state.projectile.axis = Vector::<f64, 2>::new(1.0, 0.0);
    state.projectile.velocity = 577.0;
    assert_eq!(march::run(&paper, &mut state, 10, |_| ()), Outcome::Completed);
}

/// An edition of a user's own, whose (6) gives no length from the seventh step on: the run ends there
/// and says so, although the nodes themselves are where they should be.
#[test]
fn an_edition_whose_length_vanishes_ends_the_run_with_its_equation() {
    #[derive(Default)]
    struct NoLength(std::cell::Cell<u64>);
    impl Paper<f64> for NoLength {
        fn at(&self, place: Place) {
            self.0.set(place.step);
        }
        fn eqn_6_length<const D: usize>(
            &self,
            x_ahead: Vector<f64, D>,
            v_ahead: Vector<f64, D>,
            x_here: Vector<f64, D>,
            v_here: Vector<f64, D>,
            time_step: f64,
        ) -> f64 {
            let length = Printed.eqn_6_length(x_ahead, v_ahead, x_here, v_here, time_step);
            if self.0.get() < 7 { length } else { 0.0 }
        }
    }
    let scene = shipped("single-400");
    let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
    let outcome = march::run(&NoLength::default(), &mut state, 20, |_| ());
    let place = Place { step: 7, fibre: Fibre::Primary, index: 0 };
    assert_eq!(outcome, Outcome::Diverged { place, equation: 6 });
}

#[test]
fn an_outcome_says_in_words_where_and_what() {
    let place = Place { step: 713, fibre: Fibre::Secondary, index: 29 };
    let node = Outcome::Diverged { place, equation: 2 }.to_string();
    assert_eq!(node, "diverged: eqn (2) is not finite at step 713, secondary node 29");
    let element = Outcome::Diverged { place, equation: 6 }.to_string();
    assert_eq!(element, "diverged: eqn (6) is not finite at step 713, secondary element 29");
}
