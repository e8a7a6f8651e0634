//! A time step allocates nothing.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::Scene;
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
