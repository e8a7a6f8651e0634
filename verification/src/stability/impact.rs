//! A fibre that is struck: does the march hold, and for how long?

use crossfibre::number::Number;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::scene::Scene;
use crossfibre::state::Wavefront;

use super::growth::{Growth, STEPS};
use crate::planted::{self, with_paper};

/// Between two looks at the state.
const CHUNK: u64 = 50;

/// A strain of so many times the exact one is no overshoot.
const BEYOND: f64 = 3.0;

/// Strikes a fibre with as many elements as there are steps, so that no wave comes back, and follows
/// the greatest strain. `exact` is what it should be behind the front.
///
/// An impact excites every mode of the mesh at a finite size: this sees what a small perturbation
/// does not.
pub fn impact(scene: &Scene, exact: f64) -> Growth {
    with_paper(scene, Impact { scene, exact })
}

struct Impact<'a> {
    scene: &'a Scene,
    exact: f64,
}

impl WithPaper<f64> for Impact<'_> {
    type Out = Growth;

    fn with(self, paper: &impl Paper<f64>) -> Growth {
        let Self { scene, exact } = self;
        let mut state = planted::at_impact(scene, Wavefront::Flagged);
        let steps = STEPS[0];
        let mut quarters = [0.0_f64; 4];
        while state.step < steps {
            let ended = !planted::march::wide(paper, &mut state, CHUNK, |_| {}).is_completed();
            let strains = state.primary.strain.iter();
            let greatest = strains.fold(0.0_f64, |most, e| Number::max(most, Number::abs(*e)));
            if ended || greatest > BEYOND * exact {
                let rate = Number::ln(BEYOND) / state.step as f64;
                return Growth { rate, diverged: Some(state.step) };
            }
            let quarter = &mut quarters[((state.step - 1) * 4 / steps) as usize];
            *quarter = quarter.max(greatest);
        }
        let rate = Number::ln(quarters[3] / quarters[2]) / (steps / 4) as f64;
        Growth { rate, diverged: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    /// Artificial viscosity leaves no room below the Courant limit there: the strain stays what it is.
    #[test]
    fn a_march_that_ends_by_itself_has_diverged() {
        let mut scene = shipped("artificial-viscosity");
        scene.courant = 0.95;
        let diverged = impact(&scene, 1.0).diverged;
        assert!(diverged.is_some_and(|step| step < CHUNK), "{diverged:?}");
    }
}
