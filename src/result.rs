//! The result of a run, format `crossfibre-result/1`, and how a scene becomes one.
//!
//! Arrays run from the impact point (the crossover) outward; indices are 0-based. Strain is what the
//! scene's measure accumulated.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::balance::Balance;
use crate::corrected::{Corrected, Engineering, Incremental};
use crate::discretisation::Discretisation;
use crate::march;
use crate::number::Number;
use crate::outcome::Outcome;
use crate::paper::Paper;
use crate::scene::{Scene, Strain};
use crate::state::{FibreState, State, Wavefront, Work};

/// The format that this version writes.
pub const FORMAT: &str = "crossfibre-result/1";

/// A run whose fibres hold more than this many times the energy put in is called unstable.
///
/// As printed, the crossover gains 1.5 %; the worst of the shipped stable scenes gains less. An
/// unstable march gains orders of magnitude.
pub const MOST_ENERGY: f64 = 2.0;

/// A result.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RunResult {
    /// `crossfibre-result/1`.
    pub format: &'static str,
    /// How the run ended.
    pub outcome: Outcome,
    /// Time reached, s: steps × Δt.
    pub time: f64,
    /// Steps made.
    pub steps: u64,
    /// Δt, s.
    pub time_step: f64,
    /// The struck fibre, in two dimensions.
    pub primary: FibreResult,
    /// The crossing fibre, in three dimensions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreResult>,
    /// The projectile.
    pub projectile: ProjectileResult,
    /// Where the fibres cross.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crossover: Option<CrossoverResult>,
    /// Energy and momentum; none where a sum is not finite.
    pub balance: Option<Balance>,
    /// Work done, deterministic.
    pub counts: Counts,
}

/// A fibre at the end of a run.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FibreResult {
    /// Of each node, m.
    pub position: Vec<Vec<f64>>,
    /// Of each node, m/s; it has carried the node to its position over the last step.
    pub velocity: Vec<Vec<f64>>,
    /// Of each element.
    pub strain: Vec<f64>,
    /// Of each element, N.
    pub tension: Vec<f64>,
}

/// The projectile at the end of a run.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProjectileResult {
    /// Velocity for the next step, m/s.
    pub velocity: f64,
    /// Distance travelled, m.
    pub position: f64,
}

/// The crossover at the end of a run.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CrossoverResult {
    /// `ix`, the nearest node of the primary.
    pub node: usize,
    /// How often it changed.
    pub moves: u64,
    /// Distance of the secondary's first node from that node, m (ledger `slip-drift`).
    pub distance: f64,
}

/// Work done by a run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Counts {
    /// Elements visited, summed over the steps and the fibres.
    pub element_steps: u64,
    /// Evaluations of each numbered equation in the steps.
    pub equations: BTreeMap<u8, u64>,
}

/// Something to be done with the edition of the paper that a scene asks for.
pub trait WithPaper<S: Number> {
    /// What comes of it.
    type Out;
    /// Does it.
    fn with(self, paper: &impl Paper<S>) -> Self::Out;
}

/// Chooses the edition that a scene asks for.
pub fn with_paper<S: Number, W: WithPaper<S>>(scene: &Scene, work: W) -> W::Out {
    match scene.strain {
        Strain::Incremental => work.with(&Corrected::<Incremental>::new(scene.corrections)),
        Strain::Engineering => work.with(&Corrected::<Engineering>::new(scene.corrections)),
    }
}

/// Runs a scene that has passed [`Scene::check`]. `watch` sees every step.
pub fn run(scene: &Scene, watch: impl FnMut(&State<f64>)) -> RunResult {
    struct Run<'a, F>(&'a Scene, F);
    impl<F: FnMut(&State<f64>)> WithPaper<f64> for Run<'_, F> {
        type Out = RunResult;
        fn with(self, paper: &impl Paper<f64>) -> RunResult {
            let mut state = State::at_impact(self.0, Wavefront::Flagged);
            let steps = Discretisation::<f64>::of(self.0).steps(self.0.duration);
            let outcome = march::run(paper, &mut state, steps, self.1);
            RunResult::of(self.0, &state, paper, outcome)
        }
    }
    with_paper(scene, Run(scene, watch))
}

impl RunResult {
    /// The result of a finished march. `paper` must be its edition, without a tracer.
    pub fn of<S: Number>(
        scene: &Scene,
        state: &State<S>,
        paper: &impl Paper<S>,
        outcome: Outcome,
    ) -> Self {
        let balance = Some(state.balance(paper, scene.strain)).filter(Balance::is_finite);
        let gain = balance.map_or(f64::INFINITY, |b| 1.0 + b.energy.relative_residual());
        let outcome = match outcome {
            Outcome::Completed if gain > MOST_ENERGY => Outcome::EnergyGained {
                step: state.step,
                ratio: gain.min(f64::MAX),
            },
            other => other,
        };
        Self {
            format: FORMAT,
            outcome,
            time: state.time().to_f64(),
            steps: state.step,
            time_step: state.time_step.to_f64(),
            primary: FibreResult::of(&state.primary),
            secondary: state.crossover.as_ref().map(|c| FibreResult::of(&c.fibre)),
            projectile: ProjectileResult {
                velocity: state.projectile.velocity.to_f64(),
                position: state.primary.position[0]
                    .dot(&state.projectile.axis)
                    .to_f64(),
            },
            crossover: state.crossover.as_ref().map(|c| CrossoverResult {
                node: c.node,
                moves: c.moves,
                distance: c.distance_to(&state.primary, c.node).to_f64(),
            }),
            balance,
            counts: Counts::of(scene.strain, &state.work),
        }
    }
}

impl FibreResult {
    fn of<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> Self {
        let numbers = |v: &[S]| v.iter().map(|x| x.to_f64()).collect::<Vec<_>>();
        Self {
            position: fibre
                .position
                .iter()
                .map(|v| numbers(v.as_slice()))
                .collect(),
            velocity: fibre
                .velocity
                .iter()
                .map(|v| numbers(v.as_slice()))
                .collect(),
            strain: numbers(&fibre.strain),
            tension: numbers(&fibre.tension),
        }
    }
}

impl Counts {
    /// The evaluations that a march with this work has made. That a tracer sees just these is
    /// tested.
    fn of(strain: Strain, work: &Work) -> Self {
        let mut equations = BTreeMap::new();
        let mut count = |numbers: &[u8], times: u64| {
            equations.extend(
                numbers
                    .iter()
                    .map(|&n| (n, times))
                    .filter(|&(_, times)| times > 0),
            );
        };
        count(&[2], work.elements - work.clamped);
        count(&[4, 6, 7], work.elements);
        if strain == Strain::Incremental {
            count(&[5], work.elements);
        }
        count(&[8], work.projectile);
        count(&[9, 10, 11, 12, 13], work.drives);
        count(&[14], work.secondary);
        count(&[15, 16, 17, 18], work.pushes);
        Self {
            element_steps: work.elements,
            equations,
        }
    }
}
