//! The result of a run, in the form of `crossfibre-result/1` as far as an engine can say it.

use crossfibre::outcome::Outcome;
use crossfibre::scene::Scene;
use serde::Serialize;

use crate::crossover::square_of_distance;
use crate::engine::{Engine, Unsupported};
use crate::state::FibreState;

/// A result. The energy balance is left to the reference: an outcome here is never
/// [`Outcome::EnergyUnbalanced`].
#[derive(Clone, Debug, Serialize)]
pub struct SimdResult {
    /// `crossfibre-result/1`.
    pub format: &'static str,
    /// How the run ended.
    pub outcome: Outcome,
    /// Time reached, s.
    pub time: f64,
    /// Steps made; of a run that diverged, the whole ones.
    pub steps: u64,
    /// Δt, s.
    pub time_step: f64,
    /// The struck fibre.
    pub primary: FibreState<2>,
    /// The crossing fibre.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreState<3>>,
    /// The projectile.
    pub projectile: ProjectileResult,
    /// Where the fibres cross.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crossover: Option<CrossoverResult>,
    /// Elements visited, summed over the steps and the fibres.
    pub element_steps: u64,
}

/// The projectile at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ProjectileResult {
    /// Velocity for the next step, m/s.
    pub velocity: f64,
    /// Distance travelled, m.
    pub position: f64,
}

/// The crossover at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CrossoverResult {
    /// `ix`, the nearest node of the primary.
    pub node: usize,
    /// How often it changed.
    pub moves: u64,
    /// Distance of the secondary's first node from that node, m.
    pub distance: f64,
}

/// Runs a scene that has passed [`Scene::check`].
pub fn run(scene: &Scene) -> Result<SimdResult, Unsupported> {
    let mut engine = Engine::new(scene)?;
    engine.run(engine.planned_steps());
    Ok(SimdResult::of(&engine))
}

impl SimdResult {
    /// Where an engine is now.
    pub fn of(engine: &Engine) -> Self {
        let state = engine.state();
        let [x, y] = state.primary.position[0];
        let crossover = state.crossover.zip(state.secondary.as_ref()).map(|(at, secondary)| {
            let place = state.primary.position[at.node];
            let distance = square_of_distance(secondary.position[0], place).sqrt();
            CrossoverResult { node: at.node, moves: at.moves, distance }
        });
        Self {
            format: crossfibre::result::FORMAT,
            outcome: engine.outcome().clone(),
            time: state.step as f64 * engine.time_step(),
            steps: state.step,
            time_step: engine.time_step(),
            projectile: ProjectileResult {
                velocity: state.projectile_velocity,
                position: x * 0.0 + y * 1.0,
            },
            primary: state.primary,
            secondary: state.secondary,
            crossover,
            element_steps: engine.element_steps(),
        }
    }
}
