//! The march gives the same bits however it is compiled and cut into blocks.
//!
//! All comparisons here are of bits: + − × ÷ √ are correctly rounded, so there is nothing to
//! tolerate. Run it in both profiles; the checksums are the same.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::discretisation::Discretisation;
use crossfibre::march;
use crossfibre::material::Coefficients;
use crossfibre::number::Number;
use crossfibre::paper::{Paper, Printed};
use crossfibre::result::{self, RunResult, WithPaper, with_paper};
use crossfibre::scene::{Law, Material, Scene, Strain};
use crossfibre::scene_file;
use crossfibre::state::{FibreState, State, Wavefront};
use crossfibre::trace::{Event, Traced};
use crossfibre_verification::wide;
use std::collections::BTreeMap;

const SINGLE: &str = include_str!("../scenes/single-400.json");

/// The scenes: one fibre; two; two unlike in everything, with a projectile that slows down; and a
/// crossover on either side of the boundary between two blocks of elements.
fn scenes() -> Vec<Scene> {
    let read = |text| scene_file::read(text).unwrap();
    let fig3 = read(include_str!("../scenes/fig3.json"));
    let mut scenes = vec![
        read(SINGLE),
        read(include_str!("../scenes/unequal.json")),
        read(include_str!("../scenes/both-at-origin.json")),
    ];
    let block = <Printed as Paper<f64>>::BLOCK;
    for node in [block - 1, block, block + 1] {
        let mut scene = fig3.clone();
        scene.primary.elements = block + 31;
        let secondary = scene.secondary.as_mut().unwrap();
        secondary.at = scene.primary.length / (block + 31) as f64 * node as f64;
        secondary.elements = 47;
        scenes.push(scene);
    }
    scenes.push(fig3);
    scenes.extend(of_other_laws(<Printed as Paper<f64>>::BLOCK_BY_LAW));
    scenes
}

/// Laws with and without memory, also of several numbers in more than one block of elements.
fn of_other_laws(block: usize) -> [Scene; 4] {
    let read = |text| scene_file::read(text).unwrap();
    let viscous = Coefficients { linear: 0.2, quadratic: 1.3 };
    let mut arms = read(include_str!("../scenes/viscoelastic.json"));
    arms.primary.elements = block + 31;
    // The smaller elements set the time step.
    arms.secondary.as_mut().unwrap().elements = 67;
    arms.primary.material.tension_only = true;
    let mut hardening = read(SINGLE);
    hardening.courant = 0.45;
    hardening.primary.material = Material {
        law: Law::Polynomial { coefficients: vec![58.6e9, 0.9e12] },
        tension_only: true,
        artificial_viscosity: Some(viscous),
    };
    let mut softening = read(SINGLE);
    softening.primary.material = Law::Exponential { a: -2.0e9, b: -29.3 }.into();
    softening.courant = 0.87;
    let mut eyring = read(include_str!("../scenes/eyring.json"));
    eyring.primary.material.artificial_viscosity = Some(viscous);
    eyring.courant = 0.7;
    [arms, hardening, softening, eyring]
}

/// What is done with a scene: 2.3 times its duration, in which waves come back from the clamps.
struct With<'a, F>(&'a Scene, F);

/// A march of a state over a number of steps, in any edition.
trait Way {
    fn march<S: Number>(&self, paper: &impl Paper<S>, state: &mut State<S>, steps: u64);
}

struct Undispatched;
impl Way for Undispatched {
    fn march<S: Number>(&self, paper: &impl Paper<S>, state: &mut State<S>, steps: u64) {
        assert!(march::run(paper, state, steps, |_| ()).is_completed());
    }
}

struct Dispatched;
impl Way for Dispatched {
    fn march<S: Number>(&self, paper: &impl Paper<S>, state: &mut State<S>, steps: u64) {
        assert!(wide::march(paper, state, steps, |_| ()).is_completed());
    }
}

struct BlockOfOne;
impl Way for BlockOfOne {
    fn march<S: Number>(&self, paper: &impl Paper<S>, state: &mut State<S>, steps: u64) {
        let traced = Traced::new(paper, |_: &Event<'_, S>| ());
        assert!(march::run(&traced, state, steps, |_| ()).is_completed());
    }
}

impl<S: Number, W: Way> WithPaper<S> for With<'_, (W, Wavefront)> {
    type Out = State<S>;
    fn with(self, paper: &impl Paper<S>) -> State<S> {
        let With(scene, (way, wavefront)) = self;
        let mut state = State::at_impact(scene, wavefront);
        let steps = Discretisation::<S>::of(scene).steps(2.3 * scene.duration);
        way.march(paper, &mut state, steps);
        state
    }
}

fn marched<S: Number>(scene: &Scene, way: impl Way, wavefront: Wavefront) -> State<S> {
    with_paper(scene, With(scene, (way, wavefront)))
}

fn fibre_bits<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> Vec<u64> {
    let vectors = fibre.position.iter().chain(&fibre.velocity).flat_map(|v| v.iter());
    vectors.chain(&fibre.strain).chain(&fibre.tension).map(|x| x.to_f64().to_bits()).collect()
}

/// Everything that a result reports, as bits.
fn bits<S: Number>(state: &State<S>) -> Vec<u64> {
    let mut bits = fibre_bits(&state.primary);
    if let Some(crossover) = &state.crossover {
        bits.extend(fibre_bits(&crossover.fibre));
        bits.push(crossover.node as u64);
    }
    bits.push(state.projectile.velocity.to_f64().to_bits());
    bits
}

fn all_ways_agree<S: Number>(scene: &Scene) {
    let expected = marched::<S>(scene, Undispatched, Wavefront::Flagged);
    // Not a comparison of fibres at rest.
    assert!(expected.primary.tension.iter().all(|&t| t != S::zero()), "{}", scene.title);
    let expected = bits(&expected);
    let title = &scene.title;
    for wavefront in [Wavefront::Flagged, Wavefront::Ignored] {
        let same = |state: &State<S>| bits(state) == expected;
        assert!(same(&marched(scene, Undispatched, wavefront)), "{title}: {wavefront:?}");
        assert!(same(&marched(scene, Dispatched, wavefront)), "{title}: dispatched {wavefront:?}");
        assert!(same(&marched(scene, BlockOfOne, wavefront)), "{title}: block 1 {wavefront:?}");
    }
}

#[test]
fn dispatched_undispatched_block_of_one_and_wavefront_flags_give_the_same_bits() {
    for mut scene in scenes() {
        for strain in [Strain::Incremental, Strain::Engineering] {
            scene.strain = strain;
            all_ways_agree::<f64>(&scene);
            all_ways_agree::<f32>(&scene);
        }
    }
}

/// FNV-1a over the little-endian bytes of positions, velocities and strains: the checksum of
/// `candidates/c/march.c`.
fn checksum(fibre: &FibreState<f64, 2>) -> u64 {
    let vectors = fibre.position.iter().chain(&fibre.velocity).flat_map(|v| v.iter());
    vectors
        .chain(&fibre.strain)
        .flat_map(|x| x.to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}

/// The checksums that `candidates/c/march.c` prints, in either of its forms.
#[test]
fn debug_and_release_give_the_bits_of_the_c_transcription() {
    for (elements, steps, expected) in
        [(150, 100, 0x2d05_4ee8_9bf6_0827), (1000, 1000, 0x7e1f_18e4_466e_f9ee)]
    {
        let mut scene = scene_file::read(SINGLE).unwrap();
        scene.primary.elements = elements;
        let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
        let mut wide_state = state.clone();
        let paper = Printed;
        march::run(&paper, &mut state, steps, |_| ());
        wide::march(&paper, &mut wide_state, steps, |_| ());
        assert_eq!(checksum(&state.primary), expected, "{elements} elements");
        assert_eq!(checksum(&wide_state.primary), expected, "{elements} elements, dispatched");
    }
}

#[test]
fn results_through_the_dispatch_are_those_of_the_library() {
    for scene in scenes() {
        let json = |result: &RunResult| serde_json::to_string(result).unwrap();
        let mut steps = 0;
        let result = wide::run(&scene, |_| steps += 1);
        assert_eq!(json(&result), json(&result::run(&scene, |_| ())), "{}", scene.title);
        assert_eq!(steps, result.steps);
    }
}

#[test]
fn a_tracer_sees_just_the_evaluations_that_are_counted() {
    struct Count<'a>(&'a Scene);
    impl WithPaper<f64> for Count<'_> {
        type Out = BTreeMap<u8, u64>;
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            let mut counts = BTreeMap::new();
            let mut state = State::at_impact(self.0, Wavefront::Flagged);
            let steps = Discretisation::<f64>::of(self.0).steps(self.0.duration);
            let traced = Traced::new(paper, |event: &Event<'_, f64>| {
                *counts.entry(event.equation).or_insert(0) += 1;
            });
            march::run(&traced, &mut state, steps, |_| ());
            counts
        }
    }
    for mut scene in scenes() {
        for strain in [Strain::Incremental, Strain::Engineering] {
            scene.strain = strain;
            let counted = result::run(&scene, |_| ()).counts.equations;
            assert_eq!(with_paper(&scene, Count(&scene)), counted, "{}", scene.title);
        }
    }
}
