//! The engine's bits are the reference's, in vectors of each kind.
//!
//! All comparisons are of bits: there is nothing to tolerate.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::result::{self, FibreResult, RunResult};
use crossfibre::scene::{Scene, Strain};
use crossfibre::scene_file;
use crossfibre_simd::state::FibreState;
use crossfibre_simd::{Engine, SimdResult, Vectors, batch};

mod scenes;

/// Kinds of vectors that this machine has.
fn vectors(scene: &Scene) -> impl Iterator<Item = Engine> {
    Vectors::ALL.into_iter().filter_map(|v| Engine::new_in(scene, v).ok())
}

fn bits<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    numbers.into_iter().map(|x| x.to_bits()).collect()
}

/// Compares quantity by quantity, so that a failure names one.
fn same_fibre<const D: usize>(found: &FibreState<D>, expected: &FibreResult, what: &str) {
    let vectors = [
        (&found.position, &expected.position, "position"),
        (&found.velocity, &expected.velocity, "velocity"),
    ];
    for (found, expected, name) in vectors {
        assert_eq!(bits(found.iter().flatten()), bits(expected.iter().flatten()), "{what}: {name}");
    }
    assert_eq!(bits(&found.strain), bits(&expected.strain), "{what}: strain");
    assert_eq!(bits(&found.tension), bits(&expected.tension), "{what}: tension");
}

fn same(found: &SimdResult, expected: &RunResult, what: &str) {
    let unbalanced =
        matches!(expected.outcome, crossfibre::outcome::Outcome::EnergyUnbalanced { .. });
    if unbalanced {
        assert!(found.outcome.is_completed(), "{what}: {}", found.outcome);
    } else {
        assert_eq!(found.outcome, expected.outcome, "{what}");
    }
    assert_eq!(found.steps, expected.steps, "{what}");
    assert_eq!(found.time.to_bits(), expected.time.to_bits(), "{what}: time");
    assert_eq!(found.time_step.to_bits(), expected.time_step.to_bits(), "{what}: time step");
    same_fibre(&found.primary, &expected.primary, what);
    assert_eq!(found.secondary.is_some(), expected.secondary.is_some(), "{what}");
    if let (Some(found), Some(expected)) = (&found.secondary, &expected.secondary) {
        same_fibre(found, expected, &format!("{what}, secondary"));
    }
    let (p, q) = (&found.projectile, &expected.projectile);
    assert_eq!(bits([&p.velocity, &p.position]), bits([&q.velocity, &q.position]), "{what}");
    if let (Some(c), Some(d)) = (&found.crossover, &expected.crossover) {
        assert_eq!((c.node, c.moves), (d.node, d.moves), "{what}");
        assert_eq!(c.distance.to_bits(), d.distance.to_bits(), "{what}: distance");
    }
    assert_eq!(found.element_steps, expected.counts.element_steps, "{what}");
}

/// Runs the scene in vectors of each kind, and in two pieces of which the second is taken up from a
/// state.
fn agrees(scene: &Scene) -> RunResult {
    let expected = result::run(scene, |_| ());
    let whole = |engine: &mut Engine| engine.run(engine.planned_steps());
    let mut kinds = 0;
    for mut engine in vectors(scene) {
        whole(&mut engine);
        let what = format!("{} in {:?}", scene.title, engine.vectors());
        same(&SimdResult::of(&engine), &expected, &what);
        kinds += 1;
    }
    assert!(kinds >= 1);
    expected
}

#[test]
fn shipped_scenes_have_the_bits_of_the_reference() {
    let mut agreed = 0;
    for (name, text) in scenes::SHIPPED {
        for (strain, longer) in
            [(Strain::Incremental, 1.0), (Strain::Incremental, 2.3), (Strain::Engineering, 2.3)]
        {
            let mut scene = scene_file::read(text).unwrap();
            (scene.title, scene.strain) = (format!("{name}, {strain:?} x {longer}"), strain);
            scene.duration *= longer;
            if crossfibre_simd::engine::supports(&scene).is_ok() {
                agrees(&scene);
                agreed += 1;
            }
        }
    }
    assert_eq!(agreed, 3 * 8);
}

#[test]
fn other_laws_and_editions_are_refused_with_a_reason() {
    let refused: Vec<_> = scenes::SHIPPED
        .iter()
        .filter_map(|(name, text)| {
            let scene = scene_file::read(text).unwrap();
            Some((*name, Engine::new(&scene).err()?.to_string()))
        })
        .collect();
    let names: Vec<_> = refused.iter().map(|(name, _)| *name).collect();
    let expected = [
        "artificial-viscosity",
        "eyring",
        "fig3-printed",
        "hardening",
        "slack",
        "softening",
        "viscoelastic",
    ];
    assert_eq!(names, expected);
    for (name, reason) in refused {
        let wanted = if name == "fig3-printed" { "all corrections" } else { "law" };
        assert!(reason.contains(wanted), "{name}: {reason}");
    }
}

#[test]
fn drawn_scenes_have_the_bits_of_the_reference() {
    let mut ended = std::collections::BTreeMap::new();
    let mut moves = 0;
    for scene in scenes::drawn(400) {
        let expected = agrees(&scene);
        let outcome = format!("{:?}", expected.outcome);
        let kind = outcome.split([' ', '{']).next().unwrap().to_owned();
        *ended.entry(kind).or_insert(0) += 1;
        moves += expected.crossover.map_or(0, |c| c.moves);
    }
    println!("{ended:?}, {moves} moves of the crossover");
    // Not a comparison of runs that end at once, nor of those that never do.
    assert!(ended["Completed"] > 200 && ended["Diverged"] > 10 && moves > 100, "{ended:?} {moves}");
}

/// At 8.6 km/s and a Courant number above 1 the crossover overtakes the wavefront, and pulls at a node
/// that would not be visited in that step.
#[test]
fn a_crossover_that_slides_to_the_wavefront_has_the_element_ahead_visited() {
    let text = r#"{
        "format": "crossfibre-scene/1", "title": "overtaken front",
        "primary": {
            "length": 0.11418800179238703, "elements": 27, "density": 1073.1403276219378,
            "area": 4.012865814972713e-7,
            "material": {"law": "linear", "modulus": 60244568339.113976}
        },
        "secondary": {
            "at": 0.06039616234749516, "length": 0.2450716733080675, "elements": 32,
            "density": 2612.4551313795505, "area": 9.201805912560557e-7,
            "material": {"law": "linear", "modulus": 97435867295.91496},
            "slide_factor": 0.8572502053025095
        },
        "projectile": {"velocity": 8647.095651445761},
        "courant": 1.0817687145611021, "duration": 0.000017630901192175374
    }"#;
    let mut scene = scene_file::read(text).unwrap();
    let mut overtaken = false;
    result::run(&scene, |state| {
        overtaken |= state.crossover.as_ref().is_some_and(|c| c.node >= state.primary.visited);
    });
    assert!(overtaken);
    for strain in [Strain::Incremental, Strain::Engineering] {
        scene.strain = strain;
        agrees(&scene);
    }
}

#[test]
fn a_run_taken_up_from_a_state_goes_on_as_it_would_have() {
    for scene in scenes::drawn(60) {
        for mut engine in vectors(&scene) {
            let steps = engine.planned_steps();
            let first = steps / 3;
            let what = format!("{} in {:?}", scene.title, engine.vectors());
            if !engine.run(first).is_completed() {
                continue;
            }
            let state = engine.state();
            let mut second = Engine::from_state_in(&scene, state, &[engine.vectors()]).unwrap();
            for engine in [&mut engine, &mut second] {
                engine.run(1);
                engine.run(steps - first - 1);
            }
            assert_eq!(second.outcome(), engine.outcome(), "{what}");
            let json = |engine: &Engine| serde_json::to_string(&engine.state()).unwrap();
            assert_eq!(json(&second), json(&engine), "{what}");
        }
    }
}

#[test]
fn a_batch_gives_the_results_of_one_after_the_other() {
    let scenes: Vec<_> = scenes::drawn(40).collect();
    let json = |result: &SimdResult| serde_json::to_string(result).unwrap();
    let results = batch(&scenes);
    assert_eq!(results.len(), scenes.len());
    for (scene, result) in scenes.iter().zip(results) {
        let alone = crossfibre_simd::run(scene).unwrap();
        assert_eq!(json(&result.unwrap()), json(&alone), "{}", scene.title);
    }
}
