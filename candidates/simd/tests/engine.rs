//! What the engine says of itself and of what it does not take.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::outcome::Outcome;
use crossfibre::scene::{Scene, Strain};
use crossfibre::scene_file;
use crossfibre_simd::state::State;
use crossfibre_simd::{Engine, Vectors};

fn unequal() -> Scene {
    scene_file::read(include_str!("../../../verification/scenes/unequal.json")).unwrap()
}

/// What is said of a state other than one after 7 steps.
fn refused(change: impl Fn(&mut State)) -> Option<String> {
    let scene = unequal();
    let mut engine = Engine::new(&scene).unwrap();
    engine.run(7);
    let mut state = engine.state();
    change(&mut state);
    Engine::from_state(&scene, state).err().map(|refused| refused.to_string())
}

#[test]
fn a_state_of_another_mesh_is_refused() {
    assert_eq!(refused(|_| ()), None);
    let last = unequal().primary.elements - 1;
    assert_eq!(refused(|state| state.crossover.as_mut().unwrap().node = last), None);
    let changes: [&dyn Fn(&mut State); 10] = [
        &|state| state.primary.position.truncate(last),
        &|state| state.primary.velocity.truncate(last),
        &|state| state.primary.strain.truncate(last),
        &|state| state.primary.tension.truncate(last),
        &|state| state.primary.strain.push(0.0),
        &|state| state.secondary.as_mut().unwrap().tension.truncate(1),
        &|state| state.crossover.as_mut().unwrap().node = last + 1,
        &|state| state.secondary = None,
        &|state| state.crossover = None,
        &|state| (state.secondary, state.crossover) = (None, None),
    ];
    for (k, change) in changes.iter().enumerate() {
        let said = refused(change).unwrap_or_else(|| panic!("change {k} is taken"));
        assert_eq!(said, "the state is not one of the scene's discretisation");
    }
}

#[test]
fn a_run_that_has_ended_by_itself_does_not_go_on() {
    let mut scene = unequal();
    (scene.courant, scene.duration) = (100.0, 1.0);
    for vectors in Vectors::ALL {
        let Ok(mut engine) = Engine::new_in(&scene, vectors) else { continue };
        assert_eq!(*engine.outcome(), Outcome::Completed);
        let outcome = engine.run(engine.planned_steps());
        let Outcome::Diverged { place, .. } = outcome else { panic!("{outcome}") };
        assert_eq!((engine.step() + 1, engine.state().step + 1), (place.step, place.step));
        assert_eq!(engine.run(5), outcome);
        assert_eq!((engine.outcome(), engine.step() + 1), (&outcome, place.step));
        let said = format!("Engine {{ {vectors:?}, step {}, {outcome} }}", engine.step());
        assert_eq!(format!("{engine:?}"), said);
    }
}

/// It is looked for from the state on, which is later than the steps that are gone back by.
#[test]
fn a_run_taken_up_from_a_state_diverges_where_it_would_have() {
    let mut scene =
        scene_file::read(include_str!("../../../verification/scenes/single-400.json")).unwrap();
    (scene.strain, scene.courant, scene.duration) = (Strain::Engineering, 1.3, 1.0);
    for vectors in Vectors::ALL {
        let Ok(mut engine) = Engine::new_in(&scene, vectors) else { continue };
        let outcome = engine.run(engine.planned_steps());
        let Outcome::Diverged { place, .. } = outcome else { panic!("{outcome}") };
        assert!(place.step > 60, "{outcome}");
        let mut first = Engine::new_in(&scene, vectors).unwrap();
        first.run(place.step - 10);
        let mut second = Engine::from_state_in(&scene, first.state(), &[vectors]).unwrap();
        assert_eq!(second.run(engine.planned_steps()), outcome);
    }
}

#[test]
fn a_state_is_given_back_as_it_came() {
    let scene = unequal();
    let mut engine = Engine::new(&scene).unwrap();
    engine.run(7);
    let mut state = engine.state();
    // Not what its strain makes of it.
    state.primary.tension[0] *= 1.5;
    assert_eq!(Engine::from_state(&scene, state.clone()).unwrap().state(), state);
}

#[cfg(target_arch = "x86_64")]
#[test]
fn a_scene_is_marched_in_the_widest_vectors_that_the_processor_has() {
    use std::arch::is_x86_feature_detected as has;

    let scene = unequal();
    let there = [has!("avx512f"), has!("avx2") && has!("fma"), true];
    for (vectors, is_there) in Vectors::ALL.into_iter().zip(there) {
        assert_eq!(Engine::new_in(&scene, vectors).is_ok(), is_there, "{vectors:?}");
    }
    let widest = Vectors::ALL[there.iter().position(|&is_there| is_there).unwrap()];
    assert_eq!(Engine::new(&scene).unwrap().vectors(), widest);
}
