//! What must be equal, exactly: counts and events, traced and untraced, with the wavefront's flags
//! and without, planned and done, f32 and f64 within the rounding of f32.

#![allow(clippy::excessive_precision)] // seventeen digits of what was worked by hand

use std::cmp::max_by;
use std::collections::{BTreeMap, BTreeSet};

use crate::common::{assert_ulps, bits, run, shipped, short_scenes, trace};
use crossfibre::discretisation::Discretisation;
use crossfibre::outcome::Outcome;
use crossfibre::plan::Plan;
use crossfibre::result;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

#[test]
fn the_mesh_is_what_the_scene_says() {
    // The scene without special numbers. c = √(71.3e9/1443) = 7029.312… and √(43.1e9/973) =
    // 6655.51…; Δx = 0.2871/139 and 0.1639/97; Δx/c = 2.9383e-7 and 2.5388e-7, so that the secondary
    // sets Δt = 0.937 × 2.5388e-7. Δm = ρ × area × Δx. 0.0773/Δx1 = 37.43, nearest node 37.
    let mesh = Discretisation::<f64>::of(&shipped("unequal"));
    let crossing = mesh.secondary.unwrap();
    let (primary, secondary) = (mesh.primary, crossing.fibre);
    // Up to five roundings each, the inputs' not counted: they are the same decimals.
    let tolerance = 4.0;
    assert_ulps(primary.spacing, MESH[0], tolerance);
    assert_ulps(secondary.spacing, MESH[1], tolerance);
    assert_ulps(mesh.time_step, MESH[2], tolerance);
    assert_ulps(primary.mass, MESH[3], tolerance);
    assert_ulps(secondary.mass, MESH[4], tolerance);
    assert_ulps(primary.a, MESH[5], tolerance);
    assert_ulps(secondary.a, MESH[6], tolerance);
    assert_ulps(primary.stiffness, 62_031.0, tolerance); // 71.3e9 × 0.87e-6
    assert_ulps(secondary.stiffness, 56_461.0, tolerance); // 43.1e9 × 1.31e-6
    assert_eq!(crossing.node, 37);
    assert_eq!(crossing.slide_factor, 0.73);
}

/// Worked with thirty digits: Δx1, Δx2 (m), Δt (s), Δm1, Δm2 (kg), A1, A2 (s/kg).
const MESH: [f64; 7] = [
    0.0020654676258992804,
    0.0016896907216494845,
    2.3788365093734962e-07,
    2.5930087122302158e-06,
    2.1537304845360823e-06,
    0.091740397868832743,
    0.11045191245857776,
];

#[test]
fn the_counts_of_a_result_are_the_events_of_a_trace() {
    for (name, scene) in short_scenes() {
        let (_, outcome, events) = trace(&scene);
        assert_eq!(outcome, Outcome::Completed, "{name}");
        let mut seen = BTreeMap::<u8, u64>::new();
        for event in &events {
            *seen.entry(event.equation).or_default() += 1;
        }
        let counts = result::run(&scene, |_| ()).counts;
        assert_eq!(counts.equations, seen, "{name}");
        assert_eq!(counts.element_steps, seen[&6], "{name}");
    }
}

#[test]
fn a_traced_run_is_the_untraced_run_to_the_bit() {
    for (name, scene) in short_scenes() {
        let (plain, outcome) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let (traced, traced_outcome, events) = trace(&scene);
        assert_eq!(outcome, traced_outcome, "{name}");
        assert!(bits(&plain) == bits(&traced), "{name}");
        assert_eq!(plain.work, traced.work, "{name}");
        assert!(events.len() > 5_000, "{name}: {}", events.len());
    }
}

#[test]
fn the_elements_ahead_of_the_wavefront_need_not_be_visited() {
    for (name, scene) in short_scenes() {
        let mut flagged = Vec::new();
        let (with_flags, _) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
            flagged.push(bits(state));
        });
        let mut step = 0;
        let (without, _) = run(&scene, Wavefront::Ignored, |state: &State<f64>| {
            assert!(bits(state) == flagged[step], "{name}: step {}", state.step);
            step += 1;
        });
        assert_eq!(step, flagged.len());
        assert!(with_flags.work.elements < without.work.elements, "{name}");
    }
}

#[test]
fn a_plan_names_the_equations_that_a_trace_contains() {
    for (name, scene) in short_scenes() {
        let plan = Plan::of(&scene);
        let planned: BTreeSet<u8> =
            plan.equations.iter().filter(|e| e.runs).map(|e| e.equation).collect();
        let seen: BTreeSet<u8> = trace(&scene).2.iter().map(|e| e.equation).collect();
        assert_eq!(planned, seen, "{name}");
    }
}

#[test]
fn a_plan_bounds_the_element_steps_and_knows_those_of_a_single_fibre() {
    for (name, scene) in short_scenes() {
        let planned = Plan::of(&scene).element_steps;
        let measured = result::run(&scene, |_| ()).counts.element_steps as f64;
        if scene.secondary.is_none() {
            assert_eq!(planned, measured, "{name}");
        } else {
            assert!(planned >= measured, "{name}: {planned} {measured}");
            // The bound is not idle. Below α = 1 the head of the front is less than rounding, and is
            // reached a little later: 3 % of the element-steps.
            assert!(planned < 1.05 * measured, "{name}: {planned} {measured}");
        }
    }
}

#[test]
fn both_fibres_at_the_impact_point_respond_as_a_single_fibre_to_the_bit() {
    // The page's own experiment: "these results agreed identically".
    let (both, _) = run(&shipped("both-at-origin"), Wavefront::Flagged, |_: &State<f64>| ());
    let (single, _) = run(&shipped("single-400"), Wavefront::Flagged, |_: &State<f64>| ());
    assert_eq!(both.step, single.step);
    let crossing = &both.crossover.as_ref().unwrap().fibre;
    for i in 0..=single.primary.elements() {
        let (x, v) = (single.primary.position[i], single.primary.velocity[i]);
        assert_eq!(both.primary.position[i], x);
        assert_eq!(both.primary.velocity[i], v);
        assert_eq!(crossing.position[i].as_slice(), [0.0, x.y, x.x]);
        assert_eq!(crossing.velocity[i].as_slice(), [0.0, v.y, v.x]);
    }
    for strain in [&both.primary.strain, &crossing.strain] {
        assert_eq!(*strain, single.primary.strain);
    }
}

#[test]
fn single_precision_runs_and_gives_the_strain_of_double_precision() {
    for (name, scene) in short_scenes() {
        let (double, in_double) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let (single, in_single) = run(&scene, Wavefront::Flagged, |_: &State<f32>| ());
        assert_eq!((in_single, in_double), (Outcome::Completed, Outcome::Completed), "{name}");
        let worst = |single: &[f32], double: &[f64]| {
            let apart = single.iter().zip(double).map(|(s, d)| (f64::from(*s) - d).abs());
            apart.max_by(f64::total_cmp).unwrap()
        };
        let mut error = worst(&single.primary.strain, &double.primary.strain);
        if let (Some(s), Some(d)) = (&single.crossover, &double.crossover) {
            assert_eq!(s.node, d.node, "{name}");
            error = max_by(error, worst(&s.fibre.strain, &d.fibre.strain), f64::total_cmp);
        }
        // Positions near 0.3 m are rounded to 1.5e-8 m, on an element of 0.5 to 2 mm: 7.5e-6 to 3e-5
        // of strain in a step, which adds up over hundreds of steps; measured up to
        // 1.2e-3, in the sliding scene.
        assert!(error < SINGLE, "{name}: {error:e}");
        assert!(error > 1e-8, "{name}");
    }
}

/// Largest difference of strain between f32 and f64.
const SINGLE: f64 = 2e-3;

#[test]
fn engineering_strain_is_that_of_the_length_and_incremental_strain_near_its_logarithm() {
    for strain in [Strain::Engineering, Strain::Incremental] {
        let scene = Scene { strain, duration: 23.3e-6, ..shipped("single-400") };
        let (state, _) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let fibre = &state.primary;
        for i in 0..fibre.elements() {
            let ends = fibre.position[i + 1] - fibre.position[i];
            let stretch = ends.dot(&ends).sqrt() / fibre.unstrained[i];
            let e = fibre.strain[i];
            match strain {
                // Position and way are rounded to 3e-17 m of 2 mm.
                Strain::Engineering => assert!((e - (stretch - 1.0)).abs() < 2e-13, "{i}"),
                // Between the logarithm and what a front of one step leaves, λ − 1.
                Strain::Incremental => {
                    let logarithm = crossfibre::number::Number::ln(stretch);
                    let most = (stretch - 1.0).max(logarithm);
                    assert!(e > logarithm - 1e-12 && e < most + 1e-12, "{i}: {e} {stretch}");
                }
            }
        }
    }
}
