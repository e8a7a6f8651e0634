//! A time step allocates nothing, and a run what its scene is refused for if it is too much.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::plan::Plan;
use crossfibre::result::{self, WithPaper, with_paper};
use crossfibre::scene::Scene;
use crossfibre::scene_check::MAX_MEMORY;
use crossfibre::scene_file;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::{Event, Traced};
use crossfibre_verification::wide;

/// What 200 steps of a scene ask of the heap, plain, dispatched and traced to a sink that keeps
/// nothing.
struct Allocations<'a>(&'a Scene);
impl WithPaper<f64> for Allocations<'_> {
    type Out = [u64; 3];
    fn with(self, paper: &impl Paper<f64>) -> [u64; 3] {
        let at_impact = State::<f64>::at_impact(self.0, Wavefront::Flagged);
        let mut states = [at_impact.clone(), at_impact.clone(), at_impact];
        let [plain, dispatched, traced] = &mut states;
        // The processor is asked for its vectors once, before the march.
        wide::march(paper, dispatched, 1, |_| ());
        let count = |f: &mut dyn FnMut()| allocation_counter::measure(f).count_total;
        let counts = [
            count(&mut || assert!(march::run(paper, plain, 200, |_| ()).is_completed())),
            count(&mut || assert!(wide::march(paper, dispatched, 199, |_| ()).is_completed())),
            count(&mut || {
                let paper = Traced::new(paper, |_: &Event<'_, f64>| ());
                assert!(march::run(&paper, traced, 200, |_| ()).is_completed());
            }),
        ];
        assert_eq!(states.map(|s| s.step), [200; 3]);
        counts
    }
}

#[test]
fn two_hundred_steps_allocate_nothing() {
    // The counter does count: the states of two fibres are twelve vectors.
    let scene = scene_file::read(include_str!("../scenes/unequal.json")).unwrap();
    let state = || drop(State::<f64>::at_impact(&scene, Wavefront::Flagged));
    assert!(allocation_counter::measure(state).count_total >= 12);
    for text in [
        include_str!("../scenes/single-400.json"),
        include_str!("../scenes/both-at-origin.json"),
        include_str!("../scenes/unequal.json"),
        include_str!("../scenes/fig3-printed.json"),
        include_str!("../scenes/softening.json"),
        include_str!("../scenes/hardening.json"),
        include_str!("../scenes/viscoelastic.json"),
        include_str!("../scenes/eyring.json"),
        include_str!("../scenes/slack.json"),
    ] {
        let scene = scene_file::read(text).unwrap();
        assert_eq!(with_paper(&scene, Allocations(&scene)), [0; 3], "{}", scene.title);
    }
}

/// The memory of a run, bytes for each element of its fibres, all of one number.
fn measured(mut scene: Scene, elements: usize) -> f64 {
    let plan = Plan::of(&with(&scene, elements));
    scene.duration = 5.0 * plan.time_step;
    let scene = with(&scene, elements);
    let run = || assert_eq!(result::run(&scene, |_| ()).steps, 5);
    allocation_counter::measure(run).bytes_max as f64 / elements as f64
}

fn with(scene: &Scene, elements: usize) -> Scene {
    let mut scene = scene.clone();
    scene.primary.elements = elements;
    scene.secondary.iter_mut().for_each(|secondary| secondary.elements = elements);
    scene
}

#[test]
fn a_run_takes_the_memory_that_its_scene_is_refused_for() {
    for text in [
        include_str!("../scenes/single-400.json"),
        include_str!("../scenes/fig3.json"),
        include_str!("../scenes/viscoelastic.json"),
    ] {
        let scene = scene_file::read(text).unwrap();
        // The most elements that pass.
        let (mut passes, mut refused) = (1000, 1_000_000_000);
        while refused - passes > 1 {
            let middle = (passes + refused) / 2;
            match with(&scene, middle).check() {
                Ok(()) => passes = middle,
                Err(problem) => {
                    assert!(problem.message.contains("GB of memory"), "{problem}");
                    refused = middle;
                }
            }
        }
        let counted = MAX_MEMORY / passes as f64;
        let ratio = measured(scene.clone(), 30_000) / counted;
        // A node more than elements, and the lists of a law for one block: 3e-3 at the most here.
        assert!((0.999..1.01).contains(&ratio), "{}: {ratio}", scene.title);
    }
}
