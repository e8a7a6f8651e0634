//! The order of the equations within a step, and the time level of everything that enters them.

use std::cmp::max_by;

use crate::common::{bits, run, shipped, short_scenes, steps, trace};
use crossfibre::corrected::{Corrected, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::Vector;
use crossfibre::outcome::Outcome;
use crossfibre::paper::{Cosines, CrossoverPush, Lengths, Paper, Printed, ProjectilePush};
use crossfibre::place::Fibre::{self, Primary, Secondary};
use crossfibre::place::Place;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront};
use crossfibre::trace::{Event, Traced};

/// The equations of one step in the paper's order: fibre, 0-based node or element, number.
fn order_of_the_page(scene: &Scene, before: &State<f64>) -> Vec<(Fibre, usize, u8)> {
    let mut order = Vec::new();
    let along = |fibre, elements: usize, visited: usize, ix: Option<usize>| {
        // "Proceeding from one element to the next along the fibre length."
        let mut order = Vec::new();
        for i in 0..visited {
            if i + 1 < elements {
                order.push((fibre, i + 1, 2)); // the clamped node needs none
            }
            if ix == Some(i + 1) {
                order.extend([15, 16, 17, 18].map(|equation| (fibre, i + 1, equation)));
            }
            if scene.strain == Strain::Incremental {
                order.push((fibre, i, 5));
            }
            order.extend([6, 4, 7].map(|equation| (fibre, i, equation)));
        }
        order
    };
    let ix = before.crossover.as_ref().map(|c| c.node);
    let primary = &before.primary;
    let push = scene.projectile.mass.map(|_| (Primary, 0, 8));
    let mut primary = along(Primary, primary.elements(), primary.visited, ix);
    order.append(&mut primary);
    match &before.crossover {
        None => order.extend(push),
        Some(crossover) => {
            let fibre = &crossover.fibre;
            let secondary = along(Secondary, fibre.elements(), fibre.visited, None);
            if crossover.node == 0 {
                // Struck together: the projectile drives both, and feels both.
                order.push((Secondary, 0, 14));
                order.extend(secondary);
                order.extend(push);
            } else {
                order.extend(push);
                order.extend([11, 9, 10, 12, 13, 14].map(|equation| (Secondary, 0, equation)));
                order.extend(secondary);
            }
        }
    }
    order
}

#[test]
fn every_step_goes_through_the_equations_in_the_order_of_the_page() {
    for (name, scene) in short_scenes() {
        let mut expected = Vec::new();
        let mut before = State::at_impact(&scene, Wavefront::Flagged);
        let (_, outcome) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
            let step = order_of_the_page(&scene, &before);
            expected.extend(step.into_iter().map(|event| (state.step, event)));
            before = state.clone();
        });
        assert_eq!(outcome, Outcome::Completed, "{name}");
        let (_, _, events) = trace(&scene);
        let got: Vec<_> = events
            .iter()
            .map(|e| (e.place.step, (e.place.fibre, e.place.index, e.equation)))
            .collect();
        if let Some(i) = (0..got.len().min(expected.len())).find(|&i| got[i] != expected[i]) {
            panic!("{name}: event {i} is {:?}, not {:?}", got[i], expected[i]);
        }
        assert_eq!(got.len(), expected.len(), "{name}");
    }
}

// ---------------------------------------------------------------- the time levels

/// One fibre at one time.
#[derive(Clone)]
struct Level<const D: usize> {
    x: Vec<Vector<f64, D>>,
    v: Vec<Vector<f64, D>>,
    pull: Vec<Vector<f64, D>>,
    strain: Vec<f64>,
    tension: Vec<f64>,
}

impl<const D: usize> Level<D> {
    fn of(state: &FibreState<f64, D>) -> Self {
        Self {
            x: state.position.clone(),
            v: state.velocity.clone(),
            pull: state.pull.clone(),
            strain: state.strain.clone(),
            tension: state.tension.clone(),
        }
    }

    /// The level `t` from this one, `t−1`: every node, then every element, nothing in place.
    fn next(
        &self,
        paper: &impl Paper<f64>,
        fibre: &FibreState<f64, D>,
        dt: f64,
        driven: Vector<f64, D>,
        crossed: impl Fn(usize, Vector<f64, D>) -> Vector<f64, D>,
    ) -> Self {
        let n = self.strain.len();
        let mut new = self.clone();
        for i in 0..=n {
            new.v[i] = match i {
                0 => driven,
                i if i == n => Vector::zeros(),
                i => {
                    let (ahead, here) = (self.pull[i], self.pull[i - 1]);
                    let v = paper.eqn_2_velocity(self.v[i], fibre.properties.a, ahead, here);
                    crossed(i, v)
                }
            };
            new.x[i] = self.x[i] + new.v[i] * dt;
        }
        for i in 0..n {
            let length = Lengths {
                now: paper.eqn_6_length(self.x[i + 1], new.v[i + 1], self.x[i], new.v[i], dt),
                previous: paper.eqn_5_previous_length(self.x[i + 1], self.x[i]),
                unstrained: fibre.unstrained[i],
            };
            new.strain[i] = paper.eqn_4_strain(self.strain[i], length);
            new.tension[i] = paper.eqn_7_tension(fibre.properties.stiffness, new.strain[i]);
            new.pull[i] = (new.x[i + 1] - new.x[i]) * (new.tension[i] / length.now);
        }
        new
    }
}

fn cosines<const D: usize>(from: Vector<f64, D>, to: Vector<f64, D>) -> Cosines<f64> {
    let element = to - from;
    let length = element.iter().map(|c| c * c).sum::<f64>().sqrt();
    Cosines { x: element[0] / length, y: element[1] / length }
}

/// The march written with two whole levels: no recursion in place, no blocks, no wavefront, and the
/// nearest node by a search of the whole fibre. The equations are those of the edition.
struct TwoLevels<'a>(&'a Scene);

impl WithPaper<f64> for TwoLevels<'_> {
    type Out = Vec<Vec<u64>>;

    fn with(self, paper: &impl Paper<f64>) -> Self::Out {
        let start: State<f64> = State::at_impact(self.0, Wavefront::Ignored);
        let dt = start.time_step;
        let mut primary = Level::of(&start.primary);
        let mut secondary = start.crossover.as_ref().map(|c| (Level::of(&c.fibre), c.node));
        let mut v_p = start.projectile.velocity;
        let mut levels = Vec::new();
        for step in 1..=steps(self.0) {
            let old = primary.clone();
            let driven = Vector::<f64, 2>::new(0.0, v_p);
            let crossing = start.crossover.as_ref().zip(secondary.as_ref());
            primary = old.next(paper, &start.primary, dt, driven, |i, v| match crossing {
                Some((crossover, (second, ix))) if *ix == i => {
                    let phi_1 = cosines(old.x[i - 1], old.x[i]);
                    let phi_2 = cosines(second.x[0], second.x[1]);
                    let t2 = second.tension[0];
                    let push = CrossoverPush {
                        a: start.primary.properties.a,
                        slide_factor: crossover.slide_factor,
                        perpendicular: paper.eqn_16_perpendicular_tension(t2, phi_2, phi_1),
                        parallel: paper.eqn_15_parallel_tension(t2, phi_2, phi_1),
                        primary: phi_1,
                        change: (old.pull[i] - old.pull[i - 1]) * start.primary.properties.a,
                        mass: start.primary.properties.mass,
                        secondary_mass: crossover.fibre.properties.mass,
                    };
                    Vector::<f64, 2>::new(
                        paper.eqn_17_u_at_crossover(v.x, push),
                        paper.eqn_18_v_at_crossover(v.y, push),
                    )
                }
                _ => v,
            });
            let mut at_origin = None;
            if let Some((crossover, (second, ix))) =
                start.crossover.as_ref().zip(secondary.as_mut())
            {
                let driven = if *ix == 0 {
                    Vector::<f64, 3>::new(0.0, v_p, 0.0)
                } else {
                    let theta = paper.eqn_11_direction(primary.x[*ix], primary.x[*ix - 1]);
                    let (u, v) = (primary.v[*ix].x, primary.v[*ix].y);
                    let along = paper.eqn_9_parallel_velocity(u, v, theta);
                    let across = paper.eqn_10_perpendicular_velocity(u, v, theta);
                    let slide = crossover.slide_factor;
                    Vector::<f64, 3>::new(
                        paper.eqn_12_secondary_u(slide, along, across, theta),
                        paper.eqn_13_secondary_v(slide, along, across, theta),
                        paper.eqn_14_secondary_w(),
                    )
                };
                *second = second.next(paper, &crossover.fibre, dt, driven, |_, v| v);
                if *ix == 0 {
                    at_origin = Some((second.pull[0].y, crossover.fibre.properties.mass));
                } else {
                    let first = second.x[0];
                    let distance = |p: &Vector<f64, 2>| {
                        let (dx, dy, dz) = (p.x - first.x, p.y - first.y, -first.z);
                        (dx * dx + dy * dy + dz * dz).sqrt()
                    };
                    let all: Vec<f64> = primary.x.iter().map(distance).collect();
                    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                    *ix = all.iter().position(|&d| d == least).unwrap();
                }
            }
            if let Some(mass) = start.projectile.mass {
                let (second_pull, second_mass) = at_origin.unwrap_or((0.0, 0.0));
                v_p = paper.eqn_8_projectile_velocity(ProjectilePush {
                    velocity: v_p,
                    tension_y: primary.pull[0].y + second_pull,
                    mass,
                    node_mass: start.primary.properties.mass + second_mass,
                    time_step: dt,
                    time: step as f64 * dt, // at the end of the first step it is Δt, not zero
                });
            }
            levels.push(numbers(&primary, secondary.as_ref(), v_p));
        }
        levels
    }
}

fn numbers(primary: &Level<2>, secondary: Option<&(Level<3>, usize)>, v_p: f64) -> Vec<u64> {
    fn fibre<const D: usize>(level: &Level<D>) -> Vec<f64> {
        let vectors = [&level.x, &level.v, &level.pull].into_iter().flatten();
        let scalars = level.strain.iter().chain(&level.tension).copied();
        vectors.flat_map(|v| v.iter().copied()).chain(scalars).collect()
    }
    let mut all = fibre(primary);
    all.push(v_p);
    if let Some((level, node)) = secondary {
        all.extend(fibre(level));
        all.push(*node as f64);
    }
    all.into_iter().map(f64::to_bits).collect()
}

#[test]
fn the_march_in_place_is_the_march_with_two_levels_to_the_bit() {
    for (name, scene) in short_scenes() {
        let expected = with_paper(&scene, TwoLevels(&scene));
        let mut seen = 0;
        let (_, outcome) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
            let secondary = state.crossover.as_ref().map(|c| (Level::of(&c.fibre), c.node));
            let got =
                numbers(&Level::of(&state.primary), secondary.as_ref(), state.projectile.velocity);
            assert!(got == expected[seen], "{name}: step {}", state.step);
            seen += 1;
        });
        assert_eq!(outcome, Outcome::Completed);
        assert_eq!(seen as u64, steps(&scene), "{name}");
    }
}

#[test]
fn both_fibres_at_the_impact_point_with_a_mass_are_marched_alike() {
    // None of the shipped scenes lets (8) feel two fibres.
    let (_, mut scene) = short_scenes().swap_remove(3);
    assert_eq!(scene.secondary.as_ref().unwrap().at, 0.0);
    scene.projectile.mass = Some(0.000_83);
    scene.primary.density *= 1.19;
    let expected = with_paper(&scene, TwoLevels(&scene));
    let (state, _) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
    let crossover = state.crossover.as_ref().unwrap();
    let secondary = (Level::of(&crossover.fibre), crossover.node);
    let got = numbers(&Level::of(&state.primary), Some(&secondary), state.projectile.velocity);
    assert!(got == *expected.last().unwrap());
    assert!(state.projectile.velocity < 399.0);
    assert!(bits(&state).len() > got.len());
}

// ---------------------------------------------------------------- audits

#[test]
fn a_finished_step_satisfies_the_impulse_balance_of_eqn_1() {
    // Everywhere but at the projectile, the clamp and the crossover.
    let (_, scene) = short_scenes().swap_remove(5);
    let mut before = State::at_impact(&scene, Wavefront::Flagged);
    let mut worst = 0.0_f64;
    run(&scene, Wavefront::Flagged, |state: &State<f64>| {
        let (old, new) = (&before.primary, &state.primary);
        let ix = before.crossover.as_ref().unwrap().node;
        for i in (1..old.elements()).filter(|&i| i != ix) {
            let residual = Printed.eqn_1_impulse_residual(
                old.pull[i],
                old.pull[i - 1],
                new.properties.mass / state.time_step,
                new.velocity[i],
                old.velocity[i],
            );
            // Of what was rounded: the velocities, as forces.
            let size = new.velocity[i].amax() * new.properties.mass / state.time_step
                + old.pull[i].amax().max(old.pull[i - 1].amax());
            if size > 0.0 {
                worst = max_by(worst, (residual.amax() / size).abs(), f64::total_cmp);
            }
        }
        before = state.clone();
    });
    // A product and two sums in (2), as many in (1): four half units of the size.
    assert!(worst < 2.0 * f64::EPSILON, "{worst:e}");
    assert!(worst > 0.0);
}

// ---------------------------------------------------------------- blocks

#[test]
fn a_block_of_elements_gives_the_bits_of_the_recursion_wherever_the_crossover_lies() {
    // Crossovers at the last node of the first block and on either side of it; the wave runs well
    // into the second block.
    let block = <Printed as Paper<f64>>::BLOCK;
    for ix in [block - 1, block, block + 1] {
        let mut scene = shipped("unequal");
        scene.primary.elements = 2 * block + 57;
        let spacing = scene.primary.length / scene.primary.elements as f64;
        scene.secondary.as_mut().unwrap().at = ix as f64 * spacing;
        scene.secondary.as_mut().unwrap().elements = 61;
        // The secondary's elements are longer: the primary sets the time step.
        scene.courant = 1.0;
        let paper = Corrected::<Incremental>::new(scene.corrections);
        let at_impact = || State::<f64>::at_impact(&scene, Wavefront::Flagged);
        let (mut whole, mut single, mut events) = (at_impact(), at_impact(), 0_u64);
        assert_eq!(whole.crossover.as_ref().unwrap().node, ix);
        let traced = Traced::new(&paper, |_: &Event<'_, f64>| events += 1);
        let steps = block as u64 + 97;
        assert_eq!(march::run(&paper, &mut whole, steps, |_| ()), Outcome::Completed);
        assert_eq!(march::run(&traced, &mut single, steps, |_| ()), Outcome::Completed);
        assert!(bits(&whole) == bits(&single), "crossover at node {ix} of blocks of {block}");
        assert!(whole.primary.visited > block + 50 && whole.work.pushes > 50);
        assert!(events > whole.work.elements * 4);
        // A number spoilt in the second block is found where it is.
        whole.primary.strain[block + 23] = 1.3e307;
        let place = Place { step: steps + 1, fibre: Primary, index: block + 23 };
        let diverged = Outcome::Diverged { place, equation: 7 };
        assert_eq!(march::run(&paper, &mut whole, 5, |_| ()), diverged);
    }
}

#[test]
fn a_fibre_that_moves_with_its_clamp_and_its_projectile_stays_as_it_is() {
    // Every node moves by v Δt a step, and no element is strained but by the rounding of positions, 3e-17 m
    // of 2 mm a step.
    let mut state = State::<f64>::at_impact(&shipped("single-400"), Wavefront::Ignored);
    let velocity = state.projectile.axis * state.projectile.velocity;
    state.primary.velocity.fill(velocity);
    state.primary.clamp_velocity = velocity;
    let begin = state.primary.position.clone();
    let paper = Corrected::<Incremental>::new(Corrections::ALL);
    assert_eq!(march::run(&paper, &mut state, 37, |_| {}), Outcome::Completed);
    let moved = velocity * (37.0 * state.time_step);
    for (now, begin) in state.primary.position.iter().zip(&begin) {
        assert!((now - begin - moved).norm() < 1e-14, "{now} {begin}");
    }
    assert!(state.primary.strain.iter().all(|strain| strain.abs() < 1e-11));
}
