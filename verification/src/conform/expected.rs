//! What the reference gives, and how much of it rounding explains.
//!
//! The same source runs in the number type of the candidate and with 106 bits. The greatest difference
//! of a quantity so far, and half a unit in the last place of its size, is its **rounding envelope**:
//! what an order of operations may do that is as good as the reference's.

use std::collections::BTreeMap;

use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::discretisation::{Discretisation, Properties};
use crossfibre::double_double::DoubleDouble;
use crossfibre::errata::Corrections;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront};

use super::by_name::{self, Inputs};
use super::protocol::{Edition, Form, Precision, StateRecord};
use super::quantity::{Quantity, natural_size, numbers};
use crate::planted::{self, march};

/// What is expected of a question.
#[derive(Clone, Debug)]
pub struct Expected {
    /// The quantities, in order.
    pub quantities: Vec<ExpectedQuantity>,
    /// Whole numbers that must be equal.
    pub counts: Vec<(&'static str, u64)>,
    /// How the run ends; of a step or an equation, completed.
    pub outcome: Outcome,
    /// Why only equal bits can be demanded, if so.
    pub beyond: Option<String>,
}

/// A list of numbers and its envelope.
#[derive(Clone, Debug)]
pub struct ExpectedQuantity {
    /// Which.
    pub quantity: Quantity,
    /// The reference's numbers.
    pub values: Vec<f64>,
    /// What rounding explains, in the quantity's unit.
    pub envelope: f64,
}

/// The unit roundoff: half the distance of 1 to the next number.
pub fn unit_roundoff(precision: Precision) -> f64 {
    match precision {
        Precision::F64 => f64::EPSILON / 2.0,
        Precision::F32 => f64::from(f32::EPSILON) / 2.0,
    }
}

/// An edition, in both number types.
trait Both<W: Number>: Paper<W> + Paper<DoubleDouble> + Paper<f64> {}
impl<W: Number, P: Paper<W> + Paper<DoubleDouble> + Paper<f64>> Both<W> for P {}

macro_rules! with_edition {
    ($strain:expr, $corrections:expr, $paper:ident => $work:expr) => {
        match $strain {
            strain if planted::edition::is_another() => {
                let $paper = &planted::edition(strain, $corrections);
                $work
            }
            Strain::Incremental => {
                let $paper = &Corrected::<Incremental>::new($corrections);
                $work
            }
            Strain::Engineering => {
                let $paper = &Corrected::<Engineering>::new($corrections);
                $work
            }
        }
    };
}

impl Edition {
    /// The corrections that it makes.
    fn corrections(self) -> Corrections {
        match self.corrections {
            Form::All => Corrections::ALL,
            Form::None => Corrections::NONE,
        }
    }
}

// -------------------------------------------------------------------------------- equations

/// Inputs beyond these sizes, or their inverses, may over- or underflow on the way.
const SAFE: f64 = 1e100;

/// What an equation gives.
///
/// # Panics
/// If the inputs are not those of the equation: a fault of this program.
pub fn of_equation(
    edition: Edition,
    equation: u8,
    inputs: &BTreeMap<String, Vec<f64>>,
    precision: Precision,
) -> Expected {
    with_edition!(edition.strain, edition.corrections(), paper => match precision {
        Precision::F64 => equation_in::<f64>(paper, equation, inputs, precision),
        Precision::F32 => equation_in::<f32>(paper, equation, inputs, precision),
    })
}

fn equation_in<W: Number>(
    paper: &impl Both<W>,
    equation: u8,
    inputs: &BTreeMap<String, Vec<f64>>,
    precision: Precision,
) -> Expected {
    let values: Vec<f64> =
        evaluated(paper, equation, &converted::<W>(inputs)).iter().map(|x| x.to_f64()).collect();
    let is_safe = |x: &f64| *x == 0.0 || (SAFE.recip()..SAFE).contains(&x.abs());
    let safe = inputs.values().flatten().all(is_safe) && values.iter().all(|x| x.is_finite());
    let envelope = conditioning(paper, equation, &converted(inputs), unit_roundoff(precision));
    Expected {
        quantities: vec![ExpectedQuantity {
            quantity: Quantity::Equation(equation),
            values,
            envelope,
        }],
        counts: vec![],
        outcome: Outcome::Completed,
        beyond: (!safe || !envelope.is_finite()).then(|| "over- or underflow".into()),
    }
}

fn converted<S: Number>(inputs: &BTreeMap<String, Vec<f64>>) -> Inputs<S> {
    let numbers = |v: &Vec<f64>| v.iter().map(|x| S::from_f64(*x)).collect();
    inputs.iter().map(|(name, v)| (name.clone(), numbers(v))).collect()
}

fn evaluated<S: Number>(paper: &impl Paper<S>, equation: u8, inputs: &Inputs<S>) -> Vec<S> {
    by_name::evaluate(paper, equation, inputs)
        .unwrap_or_else(|fault| panic!("({equation}): {fault}"))
}

/// What the output does, at most, if every input is off by half a unit in its last place, and half a
/// unit of the output itself.
fn conditioning(
    paper: &impl Paper<DoubleDouble>,
    equation: u8,
    inputs: &Inputs<DoubleDouble>,
    unit: f64,
) -> f64 {
    let out = evaluated(paper, equation, inputs);
    let mut moved = vec![0.0; out.len()];
    for (name, numbers) in inputs {
        for i in 0..numbers.len() {
            let mut perturbed = inputs.clone();
            if let Some(numbers) = perturbed.get_mut(name) {
                let half_a_unit = numbers[i] * DoubleDouble::from_f64(unit);
                numbers[i] += half_a_unit;
            }
            let other = evaluated(paper, equation, &perturbed);
            for (sum, (a, b)) in moved.iter_mut().zip(out.iter().zip(&other)) {
                *sum += Number::abs(*b - *a).to_f64();
            }
        }
    }
    let size = out.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    moved.into_iter().fold(0.0, f64::max) + unit * size
}

// -------------------------------------------------------------------------------- steps and runs

/// What a step from a recorded state gives.
///
/// # Errors
/// If the step diverges, or in what the record does not fit the scene.
pub fn of_step(
    scene: &Scene,
    before: &StateRecord,
    precision: Precision,
) -> Result<Expected, String> {
    with_edition!(scene.strain, scene.corrections, paper => match precision {
        Precision::F64 => step_in::<f64>(paper, scene, before, precision),
        Precision::F32 => step_in::<f32>(paper, scene, before, precision),
    })
}

fn step_in<W: Number>(
    paper: &impl Both<W>,
    scene: &Scene,
    before: &StateRecord,
    precision: Precision,
) -> Result<Expected, String> {
    let mut state = before.state::<W>(scene)?;
    let mut precise = before.state::<DoubleDouble>(scene)?;
    for ended in [march::step(paper, &mut state), march::step(paper, &mut precise)] {
        ended.map_err(|outcome| outcome.to_string())?;
    }
    let mut envelope = Envelope::new(unit_roundoff(precision));
    envelope.widen(&state, &precise);
    Ok(Expected {
        quantities: envelope.around(&state),
        counts: counts(&state),
        outcome: Outcome::Completed,
        beyond: None,
    })
}

/// What a scene comes to.
pub fn of_run(scene: &Scene, precision: Precision) -> Expected {
    with_edition!(scene.strain, scene.corrections, paper => match precision {
        Precision::F64 => run_in::<f64>(paper, scene, precision),
        Precision::F32 => run_in::<f32>(paper, scene, precision),
    })
}

/// Energies are compared at so many times of a run.
const ENERGIES: u64 = 32;

fn run_in<W: Number>(paper: &impl Both<W>, scene: &Scene, precision: Precision) -> Expected {
    let mut state = planted::at_impact::<W>(scene, Wavefront::Flagged);
    let mut precise = planted::at_impact::<DoubleDouble>(scene, Wavefront::Flagged);
    let mut envelope = Envelope::new(unit_roundoff(precision));
    let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
    let mut ended = Ok(());
    let mut ended_precisely = Ok(());
    while state.step < steps && ended.is_ok() && ended_precisely.is_ok() {
        ended = march::step(paper, &mut state);
        ended_precisely = march::step(paper, &mut precise);
        if ended.is_ok() && ended_precisely.is_ok() {
            envelope.widen(&state, &precise);
            if state.step.is_multiple_of((steps / ENERGIES).max(1)) || state.step == steps {
                envelope.widen_by(
                    Quantity::Energy,
                    (energy(paper, scene, &state) - energy(paper, scene, &precise)).abs(),
                );
            }
        }
    }
    let outcome = ended.map_or_else(|outcome| outcome, |()| Outcome::Completed);
    let outcome_precisely = ended_precisely.map_or_else(|outcome| outcome, |()| Outcome::Completed);
    let [node, node_precisely] = [place(&state), place(&precise)];
    let beyond = (kind(&outcome) != kind(&outcome_precisely) || node != node_precisely)
        .then(|| "how it ends, or where the crossover is, hangs on rounding".into());
    let outcome = RunResult::of(scene, &state, paper, outcome).outcome;
    let mut quantities = envelope.around(&state);
    let position = state.primary.position[0].dot(&state.projectile.axis).to_f64();
    // It is the position of a node of the primary.
    let of_nodes = quantities.first().map_or(0.0, |positions| positions.envelope);
    quantities.push(ExpectedQuantity {
        quantity: Quantity::ProjectilePosition,
        values: vec![position],
        envelope: of_nodes,
    });
    if !scene.has_other_laws() {
        // In doubles, as it is drawn from a candidate's numbers.
        let (value, size) = (energy_of_record(scene, &state), energy_moved_by_one(&state));
        quantities.push(envelope.of(Quantity::Energy, vec![value], value.abs() + size));
    }
    Expected { quantities, counts: counts(&state), outcome, beyond }
}

/// Name of an outcome, as results have it. That the energy is unbalanced is found by drawing a
/// balance, which a candidate need not: to it such a run has completed.
pub fn kind(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Completed | Outcome::EnergyUnbalanced { .. } => "completed",
        Outcome::Diverged { .. } => "diverged",
        Outcome::CrossoverLeft { .. } => "crossover_left",
        Outcome::CourantExceeded { .. } => "courant_exceeded",
        Outcome::NoWaves { .. } => "no_waves",
        _ => "another end",
    }
}

fn place<S: Number>(state: &State<S>) -> Option<(usize, u64)> {
    state.crossover.as_ref().map(|crossover| (crossover.node, crossover.moves))
}

fn counts<S: Number>(state: &State<S>) -> Vec<(&'static str, u64)> {
    let of_crossover =
        |(node, moves)| [("crossover node", node as u64), ("crossover moves", moves)];
    let crossover = place(state).map(of_crossover);
    [("steps", state.step)].into_iter().chain(crossover.into_iter().flatten()).collect()
}

/// Energy of both halves of the fibres and of the projectile, J, of fibres of the page's law.
pub fn energy<S: Number>(paper: &impl Paper<S>, scene: &Scene, state: &State<S>) -> f64 {
    let energy = state.balance(paper, scene.strain).energy;
    energy.kinetic + energy.stored + energy.projectile
}

/// The energy of what is written of a state.
fn energy_of_record<S: Number>(scene: &Scene, state: &State<S>) -> f64 {
    StateRecord::of(state).state(scene).map_or(f64::NAN, |state| energy_of(scene, &state))
}

/// The energy of a state that a candidate says that it has reached.
pub fn energy_of(scene: &Scene, state: &State<f64>) -> f64 {
    with_edition!(scene.strain, scene.corrections, paper => energy(paper, scene, state))
}

/// What the energy would change if each strain were off by 1 and each velocity by the wave speed,
/// their natural sizes, times those of the state: Σ T L⁰ + Σ Δm c |v|, both halves, J.
fn energy_moved_by_one<S: Number>(state: &State<S>) -> f64 {
    let secondary = state.crossover.as_ref().map(|crossover| of_fibre(&crossover.fibre));
    return 2.0 * (of_fibre(&state.primary) + secondary.unwrap_or(0.0));

    fn of_fibre<S: Number, const D: usize>(fibre: &FibreState<S, D>) -> f64 {
        let Properties { spacing, mass, wave_speed, .. } = fibre.properties;
        let size = |sum: S, x: &S| sum + Number::abs(*x);
        let tension = fibre.tension.iter().fold(S::zero(), size);
        let velocity = fibre.velocity.iter().flat_map(|v| v.iter()).fold(S::zero(), size);
        (tension * spacing + velocity * mass * wave_speed).to_f64()
    }
}

/// The greatest differences so far.
struct Envelope {
    unit: f64,
    differences: BTreeMap<Quantity, f64>,
}

impl Envelope {
    fn new(unit: f64) -> Self {
        Self { unit, differences: BTreeMap::new() }
    }

    fn widen<W: Number>(&mut self, state: &State<W>, precise: &State<DoubleDouble>) {
        for ((quantity, numbers), (_, precise)) in numbers(state).into_iter().zip(numbers(precise))
        {
            let difference = |(a, b): (&W, &DoubleDouble)| {
                (DoubleDouble::from_f64(a.to_f64()) - *b).to_f64().abs()
            };
            self.widen_by(
                quantity,
                numbers.iter().zip(&precise).map(difference).fold(0.0, f64::max),
            );
        }
    }

    fn widen_by(&mut self, quantity: Quantity, difference: f64) {
        let widest = self.differences.entry(quantity).or_default();
        *widest = widest.max(difference);
    }

    /// The quantities of a state, each with its envelope.
    fn around<W: Number>(&self, state: &State<W>) -> Vec<ExpectedQuantity> {
        numbers(state)
            .into_iter()
            .map(|(quantity, numbers)| {
                let values: Vec<_> = numbers.iter().map(|x| x.to_f64()).collect();
                let greatest = values.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
                self.of(quantity, values, greatest.max(natural_size(quantity, state)))
            })
            .collect()
    }

    fn of(&self, quantity: Quantity, values: Vec<f64>, size: f64) -> ExpectedQuantity {
        let difference = self.differences.get(&quantity).copied().unwrap_or(0.0);
        ExpectedQuantity { quantity, values, envelope: difference + self.unit * size }
    }
}

#[cfg(test)]
mod tests;
