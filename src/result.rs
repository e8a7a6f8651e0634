//! The result of a run, format `crossfibre-result/1`, and how a scene becomes one.
//!
//! Arrays run from the impact point (the crossover) outward; indices are 0-based. Strain is what the
//! scene's measure accumulated. The arrays hold finite numbers only: those of a run that diverged are
//! of the last step that was whole.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::balance::Balance;
use crate::corrected::{Corrected, Engineering, Incremental};
use crate::discretisation::Discretisation;
use crate::march;
use crate::number::Number;
use crate::outcome::Outcome;
use crate::paper::Paper;
use crate::scene::{Scene, Strain};
use crate::state::{FibreState, State, Wavefront, Work};

/// The format that this version writes and reads ([`crate::result_file`]).
pub const FORMAT: &str = "crossfibre-result/1";

/// A run whose energy balance is off by more than this many times the energy put in, or the balance of
/// its fibres by more than this many times what they were given, has not completed.
///
/// Engineering strain is off by 4 % at most, on two elements; the printed crossover by 1.5 %; (4) by
/// 8 % where its strain is wrong by 8 %, and from there on its instability takes over
/// (`docs/extremes`).
pub const MOST_IMBALANCE: f64 = 0.1;

/// A result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RunResult {
    /// `crossfibre-result/1`.
    pub format: String,
    /// How the run ended.
    pub outcome: Outcome,
    /// Time reached, s: steps × Δt.
    pub time: f64,
    /// Steps made; of a run that diverged, the whole ones.
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FibreResult {
    /// Δx, the distance of nodes in the unstrained fibre, m.
    pub spacing: f64,
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProjectileResult {
    /// Velocity for the next step, m/s.
    pub velocity: f64,
    /// Distance travelled, m.
    pub position: f64,
}

/// The crossover at the end of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

/// How a scene is run: by [`march::run`], or by the same compiled otherwise.
pub trait Marcher {
    /// As [`State::at_impact`], with the paper's flags.
    fn at_impact(&self, scene: &Scene) -> State<f64> {
        State::at_impact(scene, Wavefront::Flagged)
    }

    /// As [`with_paper`].
    fn with_paper<W: WithPaper<f64>>(&self, scene: &Scene, work: W) -> W::Out {
        with_paper(scene, work)
    }

    /// As [`march::run`].
    fn march<P: Paper<f64>>(
        &self,
        paper: &P,
        state: &mut State<f64>,
        steps: u64,
        watch: impl FnMut(&State<f64>),
    ) -> Outcome;
}

/// [`march::run`] as it stands.
#[derive(Clone, Copy, Debug)]
pub struct Plain;

impl Marcher for Plain {
    fn march<P: Paper<f64>>(
        &self,
        paper: &P,
        state: &mut State<f64>,
        steps: u64,
        watch: impl FnMut(&State<f64>),
    ) -> Outcome {
        march::run(paper, state, steps, watch)
    }
}

/// Runs a scene that has passed [`Scene::check`]. `watch` sees every step.
pub fn run(scene: &Scene, watch: impl FnMut(&State<f64>)) -> RunResult {
    run_with(&Plain, scene, watch)
}

/// Runs a scene that has passed [`Scene::check`] by this marcher. `watch` sees every step.
///
/// A run that diverges or breaks the bounds of the scheme stops amid a step. Its result is that of the
/// last whole step, the one before the step that the outcome names: all its numbers are finite.
pub fn run_with(
    marcher: &impl Marcher,
    scene: &Scene,
    watch: impl FnMut(&State<f64>),
) -> RunResult {
    struct Run<'a, M, F> {
        marcher: &'a M,
        scene: &'a Scene,
        watch: F,
    }
    impl<M: Marcher, F: FnMut(&State<f64>)> WithPaper<f64> for Run<'_, M, F> {
        type Out = RunResult;
        fn with(self, paper: &impl Paper<f64>) -> RunResult {
            let Self { marcher, scene, watch } = self;
            let mut state = marcher.at_impact(scene);
            let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
            let outcome = marcher.march(paper, &mut state, steps, watch);
            if let Some(step) = outcome.broken_step() {
                // Marching again costs time once; a copy of the state would cost it in every step.
                state = marcher.at_impact(scene);
                let again = marcher.march(paper, &mut state, step - 1, |_| ());
                debug_assert!(again.is_completed(), "{again}");
            }
            let outcome = match outcome {
                Outcome::CourantExceeded { place, courant, .. } => {
                    let found = serving_courant(marcher, paper, scene, courant, MOST_SEARCHED);
                    Outcome::CourantExceeded {
                        place,
                        courant,
                        would_serve: found.unwrap_or_default(),
                        search_given_up: found.is_err(),
                    }
                }
                other => other,
            };
            RunResult::of(scene, &state, paper, outcome)
        }
    }
    marcher.with_paper(scene, Run { marcher, scene, watch })
}

/// How much smaller the next Courant number to be tried is.
const SMALLER: f64 = 0.95;

/// The least Courant number to be tried.
const LEAST_COURANT: f64 = 0.01;

/// Element-steps that the search for a Courant number that serves takes at most: ten seconds or more at
/// 10⁸ a second.
pub const MOST_SEARCHED: f64 = 1e9;

/// The search was given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct GivenUp;

/// A Courant number with which a scene whose wave speed outgrows the step runs to its end, tried from
/// the one that would have served up to where it was outgrown; none if none serves. The search takes
/// `most` element-steps at most: a trial that might not come to its end within them is not begun.
fn serving_courant<P: Paper<f64>>(
    marcher: &impl Marcher,
    paper: &P,
    scene: &Scene,
    exceeded: f64,
    most: f64,
) -> Result<Option<f64>, GivenUp> {
    let mut trial = Scene { courant: scene.courant / exceeded, ..scene.clone() };
    let mut left = most;
    while trial.courant > LEAST_COURANT {
        let mesh = Discretisation::<f64>::of(&trial);
        let steps = mesh.steps(trial.duration);
        let elements = mesh.primary.elements + mesh.secondary.map_or(0, |s| s.fibre.elements);
        if steps as f64 * elements as f64 > left {
            return Err(GivenUp);
        }
        let mut state = marcher.at_impact(&trial);
        let outcome = marcher.march(paper, &mut state, steps, |_| ());
        left -= state.work.elements as f64;
        match RunResult::of(&trial, &state, paper, outcome).outcome {
            Outcome::Completed => return Ok(Some(trial.courant)),
            Outcome::CourantExceeded { .. } => trial.courant *= SMALLER,
            _ => return Ok(None),
        }
    }
    Ok(None)
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
        let residual = balance
            .map(|b| b.energy.imbalance().max(state.fibre_imbalance(&b.energy).abs()))
            .filter(|r| r.is_finite());
        let outcome = match outcome {
            Outcome::Completed if residual.is_none_or(|r| r > MOST_IMBALANCE) => {
                Outcome::EnergyUnbalanced { step: state.step, residual }
            }
            other => other,
        };
        Self {
            format: FORMAT.into(),
            outcome,
            time: state.time().to_f64(),
            steps: state.step,
            time_step: state.time_step.to_f64(),
            primary: FibreResult::of(&state.primary),
            secondary: state.crossover.as_ref().map(|c| FibreResult::of(&c.fibre)),
            projectile: ProjectileResult {
                velocity: state.projectile.velocity.to_f64(),
                position: state.primary.position[0].dot(&state.projectile.axis).to_f64(),
            },
            crossover: state.crossover.as_ref().map(|c| CrossoverResult {
                node: c.node,
                moves: c.moves,
                distance: c.distance(&state.primary).to_f64(),
            }),
            balance,
            counts: Counts::of(scene.strain, &state.work),
        }
    }
}

impl FibreResult {
    /// Memory of the vectors above, bytes an element: position and velocity, a vector a node each with
    /// so many components; strain and tension.
    pub(crate) fn bytes_per_element(components: usize) -> f64 {
        let number = size_of::<f64>();
        (2 * (size_of::<Vec<f64>>() + components * number) + 2 * number) as f64
    }

    fn of<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> Self {
        let numbers = |v: &[S]| v.iter().map(|x| x.to_f64()).collect::<Vec<_>>();
        Self {
            spacing: fibre.properties.spacing.to_f64(),
            position: fibre.position.iter().map(|v| numbers(v.as_slice())).collect(),
            velocity: fibre.velocity.iter().map(|v| numbers(v.as_slice())).collect(),
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
            equations.extend(numbers.iter().map(|&n| (n, times)).filter(|&(_, times)| times > 0));
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
        Self { element_steps: work.elements, equations }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene_file;

    /// The first trials break off, the last one runs to its end. What those take is counted in runs of
    /// their scenes, whose results leave out the broken step s, of up to s elements; the last is reckoned
    /// with all elements in all steps.
    #[test]
    fn a_search_is_given_up_before_it_takes_more_than_it_may() {
        let mut scene =
            scene_file::read(include_str!("../verification/scenes/hardening.json")).unwrap();
        scene.primary.material.artificial_viscosity = None;
        scene.courant = 0.83;
        let Outcome::CourantExceeded { courant: exceeded, would_serve: Some(serves), .. } =
            run(&scene, |_| ()).outcome
        else {
            panic!("0.83 serves, or nothing does")
        };
        let (mut taken, mut broken, mut trials) = (0, 0, 0);
        let mut trial = Scene { courant: scene.courant / exceeded, ..scene.clone() };
        let needed = loop {
            let result = run(&trial, |_| ());
            trials += 1;
            if result.outcome.is_completed() {
                break result.steps * 240;
            }
            taken += result.counts.element_steps;
            broken += result.steps + 1;
            trial.courant *= 0.95;
        };
        assert_eq!(trial.courant, serves);
        assert!(trials > 2 && taken > 1000, "{trials} {taken}");
        let paper = Corrected::<Engineering>::new(scene.corrections);
        let search = |most: u64| serving_courant(&Plain, &paper, &scene, exceeded, most as f64);
        assert_eq!(search(taken + broken + needed), Ok(Some(serves)));
        assert_eq!(search(taken + needed), Err(GivenUp));
    }
}
