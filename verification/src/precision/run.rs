//! A run of the study, and what is kept of it.

use crossfibre::discretisation::Discretisation;
use crossfibre::double_double::DoubleDouble;
use crossfibre::number::{Number, Vector};
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::{RunResult, WithPaper};
use crossfibre::scene::Scene;
use crossfibre::state::{State, Wavefront};
use serde::{Deserialize, Serialize};

use super::exact::{Arrival, Exact};
use super::reading::{Reading, readings};
use super::variants::Precision;
use crate::planted::{self, with_paper};

/// What is run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The scene.
    pub scene: Scene,
    /// Whether the projectile pulls along the fibre, not across it.
    pub pulled_along: bool,
    /// The number.
    pub precision: Precision,
    /// Whether only elements up to the wavefront are visited.
    pub flagged: bool,
}

/// What is kept: all of it deterministic.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Found {
    /// How it ended. Of a run that did not complete there are no readings.
    pub outcome: Outcome,
    /// Time reached, s.
    pub time: f64,
    /// Steps made.
    pub steps: u64,
    /// Elements visited.
    pub element_steps: u64,
    /// Evaluations of numbered equations.
    pub evaluations: u64,
    /// What was read, and what it ought to be.
    pub readings: Vec<Reading>,
    /// Error of the exact profile that the exact solution admits, as the L1 norm has it; none where
    /// there is no exact solution.
    pub floor: Option<f64>,
}

/// A march under way, as a reading sees it.
pub struct Marched<S: Number> {
    /// The last state.
    pub state: State<S>,
    /// When the strain at the station first reached its level, s.
    pub arrived: Option<f64>,
}

/// Makes a run and reads it.
pub fn found(run: &Run) -> Found {
    match run.precision {
        Precision::Single => found_in::<f32>(run),
        Precision::Double => found_in::<f64>(run),
        Precision::DoubleDouble => found_in::<DoubleDouble>(run),
    }
}

fn found_in<S: Number>(run: &Run) -> Found {
    struct Work<'a>(&'a Run);
    impl<S: Number> WithPaper<S> for Work<'_> {
        type Out = (Marched<S>, RunResult);
        fn with(self, paper: &impl Paper<S>) -> Self::Out {
            let run = self.0;
            let scene = &run.scene;
            let (mut state, steps) = at_impact::<S>(run);
            let mut gate = Arrival::of(run).map(Gate::of);
            let outcome = planted::march::wide(paper, &mut state, steps, |state| {
                if let Some(gate) = &mut gate {
                    gate.watch(state);
                }
            });
            let result = RunResult::of(scene, &state, paper, outcome);
            (Marched { state, arrived: gate.and_then(|gate| gate.arrived) }, result)
        }
    }
    let (marched, result) = with_paper::<S, _>(&run.scene, Work(run));
    let counts = &result.counts;
    let mut found = Found {
        outcome: result.outcome,
        time: result.time,
        steps: result.steps,
        element_steps: counts.element_steps,
        evaluations: counts.equations.values().sum(),
        readings: Vec::new(),
        floor: None,
    };
    if found.outcome.is_completed() {
        let exact = Exact::of(run, found.time).ok();
        let residual = result.balance.map(|balance| balance.energy.relative_residual());
        found.readings = readings(run, &marched, exact.as_ref(), residual);
        found.floor = exact.map(|exact| exact.floor);
    }
    found
}

/// The state before the first step, and the steps to make.
pub fn at_impact<S: Number>(run: &Run) -> (State<S>, u64) {
    let wavefront = if run.flagged { Wavefront::Flagged } else { Wavefront::Ignored };
    let mut state = planted::at_impact::<S>(&run.scene, wavefront);
    if run.pulled_along {
        state.projectile.axis = Vector::<S, 2>::new(-S::one(), S::zero());
    }
    (state, Discretisation::<S>::of(&run.scene).steps(run.scene.duration))
}

/// Waits for a front.
struct Gate {
    arrival: Arrival,
    /// Strain at the station and time, after the step before.
    before: (f64, f64),
    arrived: Option<f64>,
}

impl Gate {
    fn of(arrival: Arrival) -> Self {
        Self { arrival, before: (0.0, 0.0), arrived: None }
    }

    fn watch<S: Number>(&mut self, state: &State<S>) {
        if self.arrived.is_some() {
            return;
        }
        let level = self.arrival.level;
        let now = (strain_at(state, self.arrival.station), state.time().to_f64());
        let before = std::mem::replace(&mut self.before, now);
        if now.0 >= level {
            let share = (level - before.0) / (now.0 - before.0);
            self.arrived = Some(before.1 + share * (now.1 - before.1));
        }
    }
}

/// Strain of the primary at a place, m: linear between the middles of elements.
fn strain_at<S: Number>(state: &State<S>, place: f64) -> f64 {
    let fibre = &state.primary;
    let along = place / fibre.properties.spacing.to_f64() - 0.5;
    let last = fibre.elements() - 2;
    let index = (along.max(0.0) as usize).min(last);
    let [here, ahead] = [index, index + 1].map(|i| fibre.strain[i].to_f64());
    here + (along - index as f64) * (ahead - here)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    /// Middles at 0.5, 1.5, … elements; beyond the last the line goes on.
    #[test]
    fn a_strain_is_linear_between_the_middles_of_elements_and_beyond_the_ends() {
        let mut state = State::<f64>::at_impact(&shipped("single-400"), Wavefront::Flagged);
        let fibre = &mut state.primary;
        let (n, dx) = (fibre.elements(), fibre.properties.spacing);
        (fibre.strain[0], fibre.strain[1], fibre.strain[2]) = (0.01, 0.03, 0.02);
        (fibre.strain[n - 2], fibre.strain[n - 1]) = (0.01, 0.02);
        let at = |elements: f64| strain_at(&state, elements * dx);
        for (place, strain) in [(0.0, 0.0), (0.5, 0.01), (1.0, 0.02), (1.75, 0.0275)] {
            assert!((at(place) - strain).abs() < 1e-14, "{place}: {}", at(place));
        }
        assert!((at(n as f64) - 0.025).abs() < 1e-12, "{}", at(n as f64));
    }
}
