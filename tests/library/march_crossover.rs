//! The crossover's node `ix`: the nearest node of the primary, and what happens at the ends.

use crate::common::{run, shipped, steps};
use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::Vector;
use crossfibre::outcome::{End, Outcome};
use crossfibre::result::{self, RunResult};
use crossfibre::scene::{Material, Primary, Projectile, Scene, Secondary, Strain};
use crossfibre::state::{Crossover, FibreState, State, Wavefront};

/// The nearest node by a search of the whole fibre, the lowest of equals.
fn full_search(crossover: &Crossover<f64>, primary: &FibreState<f64, 2>) -> usize {
    let first = crossover.fibre.position[0];
    let mut nearest = 0;
    let mut least = f64::INFINITY;
    for (i, p) in primary.position.iter().enumerate() {
        let (dx, dy, dz) = (p.x - first.x, p.y - first.y, -first.z);
        let distance = (dx * dx + dy * dy + dz * dz).sqrt();
        if distance < least {
            (nearest, least) = (i, distance);
        }
    }
    nearest
}

#[test]
fn the_crossover_is_at_the_nearest_node_of_the_whole_fibre_in_every_step() {
    let scene = Scene { duration: 73.1e-6, ..shipped("sliding") };
    let (mut moves, mut last) = (0, None);
    let (state, outcome) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
        let crossover = state.crossover.as_ref().unwrap();
        assert_eq!(crossover.node, full_search(crossover, &state.primary), "step {}", state.step);
        moves += u64::from(last.is_some_and(|node| node != crossover.node));
        last = Some(crossover.node);
    });
    assert_eq!(outcome, Outcome::Completed);
    assert_eq!(state.crossover.unwrap().moves, moves);
    // Inward through the crossover: later nodes come by, more than one, one at a time.
    assert!(moves >= 2, "{moves}");
    assert!(last.unwrap() > 100);
}

/// The printed coupling folds the fibre onto itself: the nearest node may be no neighbour of the last.
#[test]
fn a_folded_fibre_is_searched_as_a_whole() {
    let mut scene = shipped("sliding");
    (scene.duration, scene.corrections) = (4.0 * scene.duration, Corrections::NONE);
    let mut leaps = 0;
    let mut last = 0;
    run(&scene, Wavefront::Flagged, |state: &State<f64>| {
        let crossover = state.crossover.as_ref().unwrap();
        assert_eq!(crossover.node, full_search(crossover, &state.primary), "step {}", state.step);
        leaps += usize::from(last > 0 && crossover.node.abs_diff(last) > 1);
        last = crossover.node;
    });
    assert!(leaps > 0, "the fibre has not folded at the crossover");
}

#[test]
fn the_nearest_node_does_not_depend_on_the_one_before() {
    // A fibre stretched and bent by a run, and the crossover's first node put beside it.
    let scene = Scene { duration: 23.9e-6, ..shipped("sliding") };
    let (state, _) = run(&scene, Wavefront::Ignored, |_: &State<f64>| ());
    let mut crossover = state.crossover.unwrap();
    for (target, off) in [(0, 0.37), (3, -0.41), (101, 0.23), (409, -0.29), (600, -0.17)] {
        for start in [0, 1, 57, 402, 599, 600] {
            crossover.node = start;
            let x = state.primary.position[target];
            crossover.fibre.position[0] =
                Vector::<f64, 3>::new(x.x + off * 0.0005, x.y + 0.00003, 0.00007);
            let expected = full_search(&crossover, &state.primary);
            assert_eq!(crossover.nearest_node(&state.primary), expected);
            assert!(expected.abs_diff(target) <= 1);
        }
    }
}

#[test]
fn of_equally_near_nodes_the_lowest_is_taken() {
    // Spacing 2⁻⁹ m: midway between nodes 41 and 42 both distances are 2⁻¹⁰ m to the bit.
    let mut scene = shipped("sliding");
    (scene.primary.length, scene.primary.elements) = (0.25, 128);
    let mut state: State<f64> = State::at_impact(&scene, Wavefront::Ignored);
    let crossover = state.crossover.as_mut().unwrap();
    let spacing = 0.25 / 128.0;
    let midway = 41.5 * spacing;
    crossover.fibre.position[0] = Vector::<f64, 3>::new(midway, 0.0, 0.0);
    for start in [1, 40, 41, 42, 43, 127] {
        crossover.node = start;
        assert_eq!(crossover.nearest_node(&state.primary), 41, "from {start}");
    }
    // And at the start of a run.
    scene.secondary.as_mut().unwrap().at = midway;
    let state: State<f64> = State::at_impact(&scene, Wavefront::Flagged);
    assert_eq!(state.crossover.unwrap().node, 41);
}

/// At 8.6 km/s, beyond the wave speed, and a Courant number above 1 the crossover overtakes the
/// wavefront. What it pulls at there is visited: the flags change no bit.
#[test]
fn a_crossover_that_overtakes_the_wavefront_pulls_at_what_is_ahead_of_it() {
    let mut scene = shipped("sliding");
    scene.primary = Primary {
        length: 0.114_188,
        elements: 27,
        density: 1073.14,
        area: 0.401e-6,
        material: Material::linear(60.24e9),
    };
    scene.secondary = Some(Secondary {
        at: 0.060_396,
        length: 0.245_07,
        elements: 32,
        density: 2612.45,
        area: 0.92e-6,
        material: Material::linear(97.44e9),
        slide_factor: 0.857,
    });
    scene.projectile.velocity = 8647.0;
    (scene.courant, scene.duration) = (1.082, 17.6e-6);
    scene.check().unwrap();
    for strain in [Strain::Incremental, Strain::Engineering] {
        scene.strain = strain;
        let mut overtaken = false;
        let (flagged, _) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
            overtaken |= state.crossover.as_ref().unwrap().node >= state.primary.visited;
        });
        assert!(overtaken);
        let (all, _) = run(&scene, Wavefront::Ignored, |_: &State<f64>| ());
        assert_eq!(flagged.primary.position, all.primary.position);
        assert_eq!(flagged.primary.strain, all.primary.strain);
        let of = |state: &State<f64>| state.crossover.as_ref().unwrap().fibre.velocity.clone();
        assert_eq!(of(&flagged), of(&all));
    }
}

#[test]
fn a_crossover_that_cannot_slide_stays_at_its_node() {
    let (state, outcome) = run(&shipped("fig3"), Wavefront::Flagged, |_: &State<f64>| ());
    assert_eq!(outcome, Outcome::Completed);
    let crossover = state.crossover.unwrap();
    assert_eq!((crossover.node, crossover.moves), (50, 0));
    // cos² + sin² is 1 within a unit or two, of ways that sum to 3 mm in 100 steps.
    let distance = crossover.distance(&state.primary);
    assert!(distance < 1e-15, "{distance:e} m");
    // It has been carried inward.
    assert!(state.primary.position[50].x < 0.0999);
    // Though another node were nearer.
    let mut crossover = crossover;
    crossover.fibre.position[0] = state.primary.position[53].push(0.0);
    assert_eq!(crossover.nearest_node(&state.primary), 50);
}

#[test]
fn a_crossover_that_the_front_has_not_reached_is_not_searched_for() {
    let mut state: State<f64> = State::at_impact(&shipped("sliding"), Wavefront::Flagged);
    let (primary, crossover) = (&state.primary, state.crossover.as_mut().unwrap());
    let node = crossover.node;
    assert!(primary.visited < node);
    crossover.fibre.position[0] = primary.position[node + 3].push(0.0);
    assert_eq!(crossover.nearest_node(primary), node);
    let all: State<f64> = State::at_impact(&shipped("sliding"), Wavefront::Ignored);
    assert_eq!(crossover.nearest_node(&all.primary), node + 3);
}

/// Nearly free, the fibre runs inward through the crossover until the clamped node is the nearest.
fn slides_to_the_clamp() -> (Scene, State<f64>) {
    let mut scene = shipped("unequal");
    scene.primary.elements = 9;
    scene.projectile = Projectile { velocity: 732.0, mass: None };
    let secondary = scene.secondary.as_mut().unwrap();
    secondary.elements = 8;
    secondary.slide_factor = 0.05;
    secondary.at = 8.41 * scene.primary.length / 9.0;
    scene.duration = 3.7e-4;
    scene.check().unwrap();
    let state = State::at_impact(&scene, Wavefront::Flagged);
    (scene, state)
}

/// In mid-run, the secondary moved past the middle of the first element: with the corrections the
/// fibre runs inward, and no scene was found that slides to the impact point by itself.
fn slides_to_the_impact_point() -> (Scene, State<f64>) {
    let (mut scene, _) = slides_to_the_clamp();
    scene.secondary.as_mut().unwrap().at = scene.primary.length / 9.0;
    let mut state: State<f64> = State::at_impact(&scene, Wavefront::Flagged);
    let paper = Corrected::<Incremental>::new(scene.corrections);
    assert_eq!(march::run(&paper, &mut state, 6, |_| ()), Outcome::Completed);
    let (x0, x1) = (state.primary.position[0], state.primary.position[1]);
    let crossover = state.crossover.as_mut().unwrap();
    assert_eq!(crossover.node, 1);
    let first = crossover.fibre.position[0];
    let shift = Vector::<f64, 3>::new(
        0.57 * x0.x + 0.43 * x1.x - first.x,
        0.57 * x0.y + 0.43 * x1.y - first.y,
        0.0,
    );
    for x in &mut crossover.fibre.position {
        *x += shift;
    }
    (scene, state)
}

#[test]
fn a_crossover_that_slides_off_either_end_ends_the_run() {
    for ((scene, mut state), end, node) in [
        (slides_to_the_clamp(), End::Clamp, 9),
        (slides_to_the_impact_point(), End::ImpactPoint, 0),
    ] {
        let paper = Corrected::<Incremental>::new(scene.corrections);
        let mut whole_steps = state.step;
        let outcome = march::run(&paper, &mut state, steps(&scene), |state| {
            whole_steps = state.step;
            let node = state.crossover.as_ref().unwrap().node;
            assert!((1..state.primary.elements()).contains(&node));
        });
        let left = Outcome::CrossoverLeft { step: whole_steps + 1, end };
        assert_eq!(outcome, left);
        assert!(whole_steps < steps(&scene));
        let crossover = state.crossover.as_ref().unwrap();
        assert_eq!(full_search(crossover, &state.primary), node);
    }
}

#[test]
fn a_crossover_that_has_left_still_gives_a_result_with_the_whole_balance() {
    for ((scene, mut state), end) in
        [(slides_to_the_clamp(), End::Clamp), (slides_to_the_impact_point(), End::ImpactPoint)]
    {
        let paper = Corrected::<Incremental>::new(scene.corrections);
        let mut before = state.balance(&paper, scene.strain);
        let outcome = march::run(&paper, &mut state, steps(&scene), |state| {
            before = state.balance(&paper, scene.strain);
        });
        assert!(matches!(outcome, Outcome::CrossoverLeft { end: e, .. } if e == end), "{outcome}");
        let result = RunResult::of(&scene, &state, &paper, outcome.clone());
        assert_eq!(result.outcome, outcome);
        // The last step is booked like every other: the residuals move by rounding and by what one
        // step of sliding does (measured: 0.025 and 0.0001 of the step's work), not by that work or by
        // an arm of the secondary.
        let after = result.balance.unwrap();
        let energy = (after.energy.residual - before.energy.residual).abs();
        let work = (after.energy.work - before.energy.work).abs();
        assert!(work > 0.0, "{end:?}: the work of the last step is missing");
        assert!(energy < 0.1 * work, "{end:?}: {energy} of {work} J");
    }
}

#[test]
fn a_run_that_ends_at_the_clamp_gives_a_result() {
    let (scene, _) = slides_to_the_clamp();
    let result = result::run(&scene, |_| ());
    assert!(
        matches!(result.outcome, Outcome::CrossoverLeft { end: End::Clamp, .. }),
        "{}",
        result.outcome
    );
    assert!(result.balance.is_some());
}
