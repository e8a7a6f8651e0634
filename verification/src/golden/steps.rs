//! Vectors of one time step: a state, and the state one step later.

use crossfibre::discretisation::Properties;
use crossfibre::errata::Corrections;
use crossfibre::number::Vector;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront, Work};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::file::Flag;
use crate::cases::support::shipped;
use crate::planted::{at_impact, march, with_paper};

/// A state, and the state one step later.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepVector {
    /// What kind of step it is.
    pub id: String,
    /// The edition.
    pub flags: Vec<Flag>,
    /// The shipped scene that this scene was coarsened from.
    pub scene_file: String,
    /// The scene.
    pub scene: Scene,
    /// What no step changes.
    pub constants: Constants,
    /// The state before the step.
    pub before: StateRecord,
    /// The state after it.
    pub after: StateRecord,
}

/// What no step changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Constants {
    /// Δt, s.
    pub time_step: f64,
    /// The struck fibre.
    pub primary: FibreConstants,
    /// The crossing fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreConstants>,
}

/// What no step changes in a fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FibreConstants {
    /// Δm, kg.
    pub mass: f64,
    /// E × area, N.
    pub stiffness: f64,
    /// A = Δt/Δm, s/kg.
    pub a: f64,
    /// L⁰ of each element, m.
    pub unstrained: Vec<f64>,
}

/// What a step reads and writes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StateRecord {
    /// Steps made.
    pub step: u64,
    /// The struck fibre.
    pub primary: FibreRecord,
    /// The crossing fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreRecord>,
    /// Where it crosses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossover: Option<CrossoverRecord>,
    /// Velocity of the projectile, m/s.
    pub projectile_velocity: f64,
    /// What crossed the boundary of the system since impact.
    pub accounts: AccountsRecord,
    /// Work done since impact.
    pub work: WorkRecord,
}

/// What a step reads and writes of a fibre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FibreRecord {
    /// Of each node, m.
    pub position: Vec<Vec<f64>>,
    /// Of each node, m/s.
    pub velocity: Vec<Vec<f64>>,
    /// Tension of each element as a vector, N.
    pub pull: Vec<Vec<f64>>,
    /// Of each element.
    pub strain: Vec<f64>,
    /// Of each element, N.
    pub tension: Vec<f64>,
    /// Elements from the driven end that a step visits.
    pub visited: usize,
}

/// Where the fibres cross.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CrossoverRecord {
    /// `ix`, from 0.
    pub node: usize,
    /// How often it has changed.
    pub moves: u64,
}

/// What crossed the boundary of the system since impact.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccountsRecord {
    /// Impulse of what keeps a projectile without mass at its velocity, N s.
    pub drive_impulse: f64,
    /// Impulse of the clamps, N s.
    pub clamp_impulse: f64,
    /// Work of what keeps a projectile without mass at its velocity, J.
    pub drive_work: f64,
}

/// How often the parts of a step were entered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkRecord {
    /// Elements visited, both fibres.
    pub elements: u64,
    /// Of these, elements at a clamp.
    pub clamped: u64,
    /// Steps with (15) to (18).
    pub pushes: u64,
    /// Steps with (9) to (13).
    pub drives: u64,
    /// Steps with (14).
    pub secondary: u64,
    /// Steps with (8).
    pub projectile: u64,
}

/// A kind of step: a shipped scene, changed, at a step.
struct Kind {
    id: &'static str,
    scene: &'static str,
    step: u64,
    change: fn(&mut Scene),
}

/// The meshes are so coarse that a person can read a vector, and all waves that there are have
/// started: in most, the front has come back from a clamp.
const KINDS: &[Kind] = &[
    Kind { id: "impact", scene: "single-400", step: 1, change: |scene| coarse(scene, 9, 0) },
    Kind { id: "single-fibre", scene: "single-400", step: 13, change: |scene| coarse(scene, 9, 0) },
    Kind { id: "crossed-fibres", scene: "unequal", step: 17, change: |scene| coarse(scene, 11, 8) },
    Kind {
        id: "front-not-at-crossover",
        scene: "unequal",
        step: 2,
        change: |scene| coarse(scene, 11, 8),
    },
    Kind {
        id: "crossover-node-moves",
        scene: "sliding",
        step: 20,
        change: |scene| coarse(scene, 12, 8),
    },
    Kind { id: "both-at-origin", scene: "both-at-origin", step: 7, change: at_origin },
    Kind {
        id: "finite-projectile",
        scene: "finite-projectile",
        step: 23,
        change: |scene| coarse(scene, 10, 0),
    },
    Kind {
        id: "engineering-strain",
        scene: "unequal",
        step: 17,
        change: |scene| {
            coarse(scene, 11, 8);
            scene.strain = Strain::Engineering;
        },
    },
    Kind {
        id: "printed",
        scene: "unequal",
        step: 17,
        change: |scene| {
            coarse(scene, 11, 8);
            scene.corrections = Corrections::NONE;
        },
    },
];

/// Other meshes.
fn coarse(scene: &mut Scene, primary: usize, secondary: usize) {
    scene.primary.elements = primary;
    if let Some(fibre) = &mut scene.secondary {
        fibre.elements = secondary;
    }
}

/// Two unlike fibres at the impact point, and a projectile that feels both.
fn at_origin(scene: &mut Scene) {
    coarse(scene, 8, 9);
    scene.projectile.mass = Some(0.00087);
    if let Some(fibre) = &mut scene.secondary {
        fibre.area = 1.31e-6;
        fibre.length = 0.271;
    }
}

/// All kinds of step.
pub fn vectors() -> Vec<StepVector> {
    KINDS.iter().map(vector).collect()
}

fn vector(kind: &Kind) -> StepVector {
    let mut scene = shipped(kind.scene);
    (kind.change)(&mut scene);
    let state = at_impact(&scene, Wavefront::Flagged);
    let before = stepped(&scene, state, kind.step - 1);
    let after = stepped(&scene, before.clone(), 1);
    StepVector {
        id: kind.id.into(),
        flags: Flag::of(&scene),
        scene_file: format!("{}.json", kind.scene),
        constants: Constants::of(&before),
        before: StateRecord::of(&before),
        after: StateRecord::of(&after),
        scene,
    }
}

/// A state of a scene so many steps later.
///
/// # Panics
/// If a step diverges: these scenes do not.
pub fn stepped(scene: &Scene, state: State<f64>, steps: u64) -> State<f64> {
    struct Steps(State<f64>, u64);
    impl WithPaper<f64> for Steps {
        type Out = State<f64>;
        fn with(mut self, paper: &impl Paper<f64>) -> State<f64> {
            let outcome = march::run(paper, &mut self.0, self.1, |_| ());
            assert!(outcome.is_completed(), "{outcome}");
            self.0
        }
    }
    with_paper(scene, Steps(state, steps))
}

impl Flag {
    /// The edition that a scene asks for.
    pub fn of(scene: &Scene) -> Vec<Self> {
        let printed = scene.corrections == Corrections::NONE;
        let mut flags = vec![if printed { Self::Printed } else { Self::Corrected }];
        if scene.strain == Strain::Engineering {
            flags.push(Self::Engineering);
        }
        flags
    }
}

impl Constants {
    fn of(state: &State<f64>) -> Self {
        let secondary = state.crossover.as_ref().map(|crossover| &crossover.fibre);
        Self {
            time_step: state.time_step,
            primary: FibreConstants::of(&state.primary.properties, &state.primary.unstrained),
            secondary: secondary
                .map(|fibre| FibreConstants::of(&fibre.properties, &fibre.unstrained)),
        }
    }
}

impl FibreConstants {
    fn of(properties: &Properties<f64>, unstrained: &[f64]) -> Self {
        let Properties { mass, stiffness, a, .. } = *properties;
        Self { mass, stiffness, a, unstrained: unstrained.into() }
    }
}

impl StateRecord {
    /// What a step reads and writes of a state.
    pub fn of(state: &State<f64>) -> Self {
        let accounts = &state.accounts;
        let Work { elements, clamped, pushes, drives, secondary, projectile } = state.work;
        let crossover = state.crossover.as_ref();
        Self {
            step: state.step,
            primary: FibreRecord::of(&state.primary),
            secondary: crossover.map(|crossover| FibreRecord::of(&crossover.fibre)),
            crossover: crossover
                .map(|crossover| CrossoverRecord { node: crossover.node, moves: crossover.moves }),
            projectile_velocity: state.projectile.velocity,
            accounts: AccountsRecord {
                drive_impulse: accounts.drive_impulse,
                clamp_impulse: accounts.clamp_impulse,
                drive_work: accounts.drive_work,
            },
            work: WorkRecord { elements, clamped, pushes, drives, secondary, projectile },
        }
    }
}

impl FibreRecord {
    fn of<const D: usize>(fibre: &FibreState<f64, D>) -> Self {
        let rows = |vectors: &[Vector<f64, D>]| {
            vectors.iter().map(|v| v.as_slice().to_vec()).collect::<Vec<_>>()
        };
        Self {
            position: rows(&fibre.position),
            velocity: rows(&fibre.velocity),
            pull: rows(&fibre.pull),
            strain: fibre.strain.clone(),
            tension: fibre.tension.clone(),
            visited: fibre.visited,
        }
    }
}
