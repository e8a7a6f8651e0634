//! Energy and momentum of a scene from the impact on.

use crossfibre::balance::Balance;
use crossfibre::discretisation::Discretisation;
use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

use crate::cases::support::{measured_by, refined, shipped};
use crate::plot::Axis;

/// When the history ends, s: waves from the clamp have been back.
const UNTIL: f64 = 90e-6;

/// Times that the paper's mesh is refined: 0.5 mm.
pub const REFINED: usize = 4;

/// Every how many steps the balance is drawn: 1.15 µs.
const EVERY: u64 = 16;

/// Times, s, with the balance then.
pub type History = Vec<(f64, Balance)>;

/// Fig. 3, finer and longer.
pub fn fig3(strain: Strain) -> Scene {
    Scene { duration: UNTIL, ..measured_by(strain, refined(shipped("fig3"), REFINED)) }
}

/// The history of a scene.
pub fn history(scene: &Scene) -> History {
    struct March<'a>(&'a Scene);
    impl WithPaper<f64> for March<'_> {
        type Out = History;
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            let scene = self.0;
            let mut state = State::at_impact(scene, Wavefront::Flagged);
            let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
            let mut history = vec![];
            march::run(paper, &mut state, steps, |state: &State<f64>| {
                if state.step.is_multiple_of(EVERY) {
                    history.push((state.time(), state.balance(paper, scene.strain)));
                }
            });
            history
        }
    }
    with_paper(scene, March(scene))
}

/// A number of each balance, over µs.
pub fn along(history: &[(f64, Balance)], of: impl Fn(&Balance) -> f64) -> Vec<(f64, f64)> {
    history.iter().map(|(time, balance)| (1e6 * time, of(balance))).collect()
}

/// The axis of the times.
pub fn time_axis() -> Axis {
    Axis::new("time after impact, µs", 0.0, 1e6 * UNTIL, 15.0)
}
