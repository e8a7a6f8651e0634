//! Which mesh a scene of the user's own needs for an accuracy.
//!
//! The scene is run on a ladder of meshes about its own. An error is held against the exact answer
//! where there is one, else against the limit of the ladder. A mesh that is asked for is run, if it is
//! not too long a run, and the error that it has is told: the law that leads there only leads there.

use crossfibre::outcome::Outcome;
use crossfibre::plan::Plan;
use crossfibre::scene::Scene;
use indicatif::{ProgressBar, ProgressStyle};
use schemars::JsonSchema;
use serde::Serialize;

use super::exact::Exact;
use super::reading::{Quantity, Reading};
use super::run::{Found, Run, found};
use super::variants::Precision;
use crate::convergence::{
    PowerLaw, Rule, Verdict, envelope, fitted_limit, of_errors, of_values, power_law,
};

/// Element-steps of a run of the ladder, and of one that shows whether an advice holds: a tenth of a
/// second and a second or two on an ordinary machine.
const TRIAL: f64 = 2e7;
const PROOF: f64 = 3e8;

/// How many times finer than what was run a mesh is believed in.
const FARTHEST: f64 = 100.0;

/// Elements of the primary on the coarsest mesh tried, and doublings of the mesh, at the most.
const COARSEST: usize = 16;
const DOUBLINGS: i32 = 7;

/// Attempts to find the mesh by the law.
const ATTEMPTS: usize = 3;

/// Level of the interval of an order, and how near pairwise orders are to the fitted one in the
/// asymptotic range.
const LEVEL: f64 = 0.95;
const BAND: f64 = 0.25;

/// What accuracy takes.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Accuracy {
    /// The error that is wanted: relative, or of a norm or residual itself.
    pub wanted: f64,
    /// What errors are held against.
    pub against: Against,
    /// The error that the exact profile admits itself, as the L1 norm has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub floor: Option<f64>,
    /// The runs made to find out.
    pub trials: Vec<Trial>,
    /// What each quantity needs; empty if a trial did not complete.
    pub quantities: Vec<Advice>,
}

/// What errors are held against.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// The exact answer.
    Exact,
    /// The limit of the meshes themselves, since nothing says what is exact.
    Limit {
        /// Why there is no exact answer.
        why: String,
    },
}

/// A run made to find out.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Trial {
    /// Elements of the primary.
    pub elements: usize,
    /// Elements visited.
    pub element_steps: u64,
    /// How it ended.
    pub outcome: Outcome,
}

/// What a quantity needs.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Advice {
    /// Which.
    pub quantity: Quantity,
    /// The size of its error on the scene's own mesh.
    pub now: f64,
    /// The order with which it falls, and half the width of the order's interval; none where its errors
    /// follow no law.
    pub order: Option<(f64, f64)>,
    /// The mesh.
    pub needs: Needs,
}

/// A mesh that gives an accuracy.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Needs {
    /// A mesh that has been run.
    Run {
        /// Elements of the primary.
        elements: usize,
        /// Elements visited.
        element_steps: u64,
        /// The error that it has.
        found: f64,
        /// Whether the law led there; otherwise it is one of the ladder, and all finer ones keep the
        /// accuracy too.
        by_the_law: bool,
    },
    /// A mesh that the law asks for, too fine to be run to see.
    TooLong {
        /// Elements of the primary.
        elements: f64,
        /// Elements visited.
        element_steps: f64,
        /// How many times finer than the finest that was run.
        beyond: f64,
    },
    /// None that could be found: the errors follow no law, or fall too slowly.
    Unknown {
        /// The error on the finest mesh.
        error: f64,
        /// Its elements of the primary.
        elements: usize,
    },
}

/// Finds out what an accuracy takes.
pub fn accuracy(scene: &Scene, wanted: f64) -> Accuracy {
    let style = ProgressStyle::with_template("{spinner} trial run {pos}: {msg}")
        .unwrap_or_else(|_| ProgressStyle::default_spinner());
    let mut trials = Trials { scene, runs: Vec::new(), bar: ProgressBar::new_spinner() };
    trials.bar.set_style(style);
    for factor in ladder(scene) {
        trials.add(factor);
    }
    let (against, floor) = match Exact::of(&run_of(scene, 1.0), trials.own().time) {
        Ok(exact) => (Against::Exact, Some(exact.floor)),
        Err(why) => (Against::Limit { why }, None),
    };
    let completed = trials.runs.iter().all(|(_, found)| found.outcome.is_completed());
    let quantities = if completed {
        Quantity::ALL.iter().filter_map(|&q| advice(&mut trials, q, wanted)).collect()
    } else {
        Vec::new()
    };
    trials.bar.finish_and_clear();
    let trial = |(run, found): &(Run, Found)| Trial {
        elements: run.scene.primary.elements,
        element_steps: found.element_steps,
        outcome: found.outcome.clone(),
    };
    Accuracy { wanted, against, floor, trials: trials.runs.iter().map(trial).collect(), quantities }
}

/// Refinements of a scene's own mesh that are tried, the coarsest first.
fn ladder(scene: &Scene) -> Vec<f64> {
    let is_small = |factor: f64| Plan::of(&refined(scene, factor)).element_steps <= TRIAL;
    let least = scene.secondary.as_ref().map_or(usize::MAX, |fibre| fibre.elements);
    let least = least.min(scene.primary.elements) as f64;
    let halved = |k: i32| least * 0.5_f64.powi(k) >= COARSEST as f64;
    let halvings = (1..=DOUBLINGS).take_while(|&k| halved(k));
    let mut factors: Vec<f64> = halvings.map(|k| 0.5_f64.powi(k)).collect();
    factors.reverse();
    factors.push(1.0);
    factors.extend((1..=DOUBLINGS).map(|k| 2.0_f64.powi(k)).take_while(|&f| is_small(f)));
    // Of the coarsest some are left out, never the scene's own.
    let own = factors.iter().position(|&factor| factor == 1.0).unwrap_or(0);
    let spare = factors.len().saturating_sub(DOUBLINGS as usize);
    factors.split_off(spare.min(own))
}

/// The scene with so many times as many elements on each fibre.
fn refined(scene: &Scene, factor: f64) -> Scene {
    let mut scene = scene.clone();
    let times = |elements: usize| ((elements as f64 * factor).round() as usize).max(2);
    scene.primary.elements = times(scene.primary.elements);
    if let Some(secondary) = &mut scene.secondary {
        secondary.elements = times(secondary.elements);
    }
    scene
}

fn run_of(scene: &Scene, factor: f64) -> Run {
    let scene = refined(scene, factor);
    Run { scene, pulled_along: false, precision: Precision::Double, flagged: true }
}

/// The runs made so far, the coarsest first.
struct Trials<'s> {
    scene: &'s Scene,
    runs: Vec<(Run, Found)>,
    bar: ProgressBar,
}

impl Trials<'_> {
    fn add(&mut self, factor: f64) -> usize {
        let run = run_of(self.scene, factor);
        self.bar.set_message(format!("{} elements", run.scene.primary.elements));
        let found = found(&run);
        self.bar.inc(1);
        let elements = |run: &Run| run.scene.primary.elements;
        let index = self.runs.partition_point(|(other, _)| elements(other) < elements(&run));
        self.runs.insert(index, (run, found));
        index
    }

    /// The run on the scene's own mesh.
    fn own(&self) -> &Found {
        let is_own = |run: &Run| run.scene.primary.elements == self.scene.primary.elements;
        let own = self.runs.iter().find(|(run, _)| is_own(run));
        own.map(|(_, found)| found).expect("the ladder has the scene's own mesh")
    }

    /// Lengths of elements and signed errors of a quantity, over the runs that give it; with the
    /// indices of these runs.
    fn errors(&self, quantity: Quantity) -> (Vec<(f64, f64)>, Vec<usize>) {
        let reading = |(index, (run, found)): (usize, &(Run, Found))| {
            let reading = *found.readings.iter().find(|reading| reading.quantity == quantity)?;
            let fibre = &run.scene.primary;
            Some((fibre.length / fibre.elements as f64, reading, index))
        };
        let read: Vec<_> = self.runs.iter().enumerate().filter_map(reading).collect();
        let values: Vec<_> = read.iter().map(|(h, reading, _)| (*h, reading.value)).collect();
        // Without an exact number: the limit if there is a law to extrapolate by, else the finest.
        let known = read.iter().all(|(_, reading, _)| reading.exact.is_some());
        let (exact, count) = match (known, limit(&values)) {
            (true, _) => (None, read.len()),
            (false, Some(limit)) => (Some(limit), read.len()),
            (false, None) => (values.last().map(|value| value.1), read.len().saturating_sub(1)),
        };
        let error = |(h, reading, _): &(f64, Reading, usize)| {
            let error = Reading { exact: exact.or(reading.exact), ..*reading }.error()?;
            Some((*h, error))
        };
        let errors = read[..count].iter().filter_map(error).collect();
        (errors, read.iter().map(|(_, _, index)| *index).collect())
    }
}

/// What values on a ladder tend to.
fn limit(values: &[(f64, f64)]) -> Option<f64> {
    let rule = Rule { band: BAND, floor: 0.0 };
    match of_values(values, rule).ok()? {
        Verdict::Asymptotic(run) => {
            fitted_limit(&values[run.from..], (0.1, 4.0), LEVEL).ok().map(|fit| fit.limit)
        }
        _ => None,
    }
}

/// The law that the finest errors follow: in the asymptotic range, else of the envelope.
fn law(errors: &[(f64, f64)]) -> Option<PowerLaw> {
    let rule = Rule { band: BAND, floor: 0.0 };
    let sizes: Vec<_> = errors.iter().map(|&(h, e)| (h, e.abs())).collect();
    match of_errors(errors, rule).ok()? {
        Verdict::Asymptotic(run) => power_law(&sizes[run.from..], LEVEL).ok(),
        // The finest point of the envelope rests on one mesh.
        _ => power_law(envelope(errors).ok()?.split_last()?.1, LEVEL).ok(),
    }
    .filter(|law| law.order > BAND.max(law.half_width))
}

fn advice(trials: &mut Trials, quantity: Quantity, wanted: f64) -> Option<Advice> {
    let (errors, _) = trials.errors(quantity);
    let now = {
        let own = trials.scene.primary.length / trials.scene.primary.elements as f64;
        errors.iter().find(|(h, _)| *h == own).map(|(_, error)| error.abs())?
    };
    let law = law(&errors);
    let order = law.as_ref().map(|law| (law.order, law.half_width));
    let needs = needs(trials, quantity, wanted, law);
    Some(Advice { quantity, now, order, needs })
}

fn needs(trials: &mut Trials, quantity: Quantity, wanted: f64, law: Option<PowerLaw>) -> Needs {
    for attempt in 0.. {
        let (errors, indices) = trials.errors(quantity);
        let keeps = envelope(&errors).unwrap_or_default();
        if let Some(mesh) = keeps.iter().position(|(_, greatest)| *greatest <= wanted) {
            let (run, found) = &trials.runs[indices[mesh]];
            return Needs::Run {
                elements: run.scene.primary.elements,
                element_steps: found.element_steps,
                found: errors[mesh].1.abs(),
                by_the_law: attempt > 0,
            };
        }
        let last = errors.len().saturating_sub(1);
        let (finest, error) = errors.get(last).map_or((0.0, f64::NAN), |&(h, e)| (h, e.abs()));
        let run_with = |index: usize| trials.runs[index].0.scene.primary.elements;
        let elements = indices.get(last).map_or(0, |&index| run_with(index));
        let unknown = Needs::Unknown { error, elements };
        let Some(law) = law.filter(|_| attempt < ATTEMPTS) else { return unknown };
        // A mesh that was not enough leads on by its own error; always to a finer one.
        let wanted_by_law = wanted * (law.at(finest) / error).min(1.0);
        let Ok(reach) = law.reach(wanted_by_law) else { return unknown };
        let spacing = reach.spacing.min(0.98 * finest);
        let own = &trials.scene.primary;
        // A little finer than the law says, which goes through the middle of its points.
        let factor = 1.02 * own.length / spacing / own.elements as f64;
        let element_steps = Plan::of(trials.scene).element_steps * factor * factor;
        let beyond = finest / spacing;
        if beyond > FARTHEST {
            return unknown;
        }
        if element_steps > PROOF {
            let elements = (factor * own.elements as f64).round();
            return Needs::TooLong { elements, element_steps, beyond };
        }
        trials.add(factor);
    }
    unreachable!("attempts are counted")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::{measured_by, shipped};
    use crate::precision::{Problem, Variant, run_of as study_run};
    use crossfibre::number::Number;
    use crossfibre::scene::Strain;

    fn of(accuracy: &Accuracy, quantity: Quantity) -> &Needs {
        &accuracy.quantities.iter().find(|advice| advice.quantity == quantity).unwrap().needs
    }

    /// Seven refinements fit, and none of the coarser meshes is left.
    #[test]
    fn a_small_scene_keeps_its_own_mesh() {
        let mut scene = shipped("single-400");
        scene.primary.elements = 30;
        assert_eq!(ladder(&scene), [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0]);
        assert!(!accuracy(&scene, 0.0137).quantities.is_empty());
    }

    /// What is advised is held against a run of just that mesh, made here.
    #[test]
    fn an_advised_mesh_has_the_error_that_was_wanted() {
        let (scene, wanted) = (measured_by(Strain::Engineering, shipped("single-400")), 0.0137);
        let advised = accuracy(&scene, wanted);
        assert_eq!(advised.against, Against::Exact);
        for quantity in [Quantity::MeanStrain, Quantity::StrainL1, Quantity::Kink] {
            let &Needs::Run { elements, element_steps, found: said, .. } = of(&advised, quantity)
            else {
                panic!("{quantity:?}: {:?}", of(&advised, quantity));
            };
            let mut scene = scene.clone();
            scene.primary.elements = elements;
            let run = found(&run_of(&scene, 1.0));
            let reading = run.readings.iter().find(|r| r.quantity == quantity).unwrap();
            let error = reading.error().unwrap().abs();
            // The same run: to the bit.
            assert_eq!((error.to_bits(), run.element_steps), (said.to_bits(), element_steps));
            assert!(error <= wanted, "{quantity:?}: {error}");
        }
        // The fewest: half the mesh is not enough for a quantity of order one.
        let &Needs::Run { elements, .. } = of(&advised, Quantity::StrainL1) else { panic!() };
        let mut coarse = scene;
        coarse.primary.elements = elements / 2;
        let run = found(&run_of(&coarse, 1.0));
        let l1 = run.readings.iter().find(|r| r.quantity == Quantity::StrainL1).unwrap();
        assert!(l1.value > wanted, "{elements}: {l1:?}");
    }

    /// The limit of the meshes against the exact mean strain, which it is not told. Order one and a ladder
    /// that ends at 1 % leave 1e-4 of it; worst seen 7e-5.
    #[test]
    fn the_limit_of_the_meshes_is_the_exact_number() {
        let variant = Variant::named("engineering, α = 1");
        for problem in [Problem::Single, Problem::Crossed] {
            let meshes = [1.0, 2.0, 4.0, 8.0, 16.0];
            let readings = meshes.map(|refinement| {
                let run = study_run(problem, &variant, refinement);
                let of = found(&run).readings;
                (1.0 / refinement, *of.iter().find(|r| r.quantity == Quantity::MeanStrain).unwrap())
            });
            let values = readings.map(|(h, reading)| (h, reading.value));
            let (limit, exact) = (limit(&values).unwrap(), readings[0].1.exact.unwrap());
            assert!((limit / exact - 1.0).abs() < 3e-4, "{problem:?}: {limit} {exact}");
        }
    }

    #[test]
    fn what_no_mesh_gives_is_not_promised() {
        let printed = accuracy(&shipped("fig3-printed"), 1e-3);
        let needs = of(&printed, Quantity::Reflection);
        assert!(matches!(needs, Needs::Unknown { error, .. } if *error > 0.2), "{needs:?}");
        let mut fails = shipped("artificial-viscosity");
        fails.courant = 0.95;
        let failed = accuracy(&fails, 1e-3);
        assert!(failed.quantities.is_empty() && failed.trials.len() > 3, "{failed:?}");
        assert!(failed.trials.iter().all(|trial| !trial.outcome.is_completed()));
    }

    #[test]
    fn a_scene_without_an_exact_answer_is_held_against_its_own_limit() {
        let advised = accuracy(&shipped("viscoelastic"), 0.0137);
        assert!(matches!(advised.against, Against::Limit { .. }));
        let needs = of(&advised, Quantity::SecondaryMean);
        assert!(matches!(needs, Needs::Run { found, .. } if *found <= 0.0137), "{needs:?}");
    }

    /// Work goes with the square of the elements, errors by the law, and a fiftieth is added.
    #[test]
    fn the_law_leads_on_from_the_finest_mesh_of_the_ladder() {
        let scene = measured_by(Strain::Engineering, shipped("single-400"));
        let mut trials = Trials { scene: &scene, runs: Vec::new(), bar: ProgressBar::hidden() };
        for factor in ladder(&scene) {
            trials.add(factor);
        }
        assert_eq!(trials.own(), &found(&run_of(&scene, 1.0)));
        let finest = trials.runs[trials.runs.len() - 1].0.scene.primary.elements;
        let (errors, _) = trials.errors(Quantity::StrainL1);
        let known = law(&errors).unwrap();
        let (spacing, error) = *errors.last().unwrap();
        let error = error.abs();
        let mut needs = |wanted| advice(&mut trials, Quantity::StrainL1, wanted).unwrap().needs;

        let of_the_ladder = needs(error);
        let Needs::Run { elements, found, by_the_law: false, .. } = of_the_ladder else {
            panic!("{of_the_ladder:?}")
        };
        assert_eq!((elements, found.to_bits()), (finest, error.to_bits()));

        // The law may say a little more or less of the finest mesh than its error is.
        let times_finer = |wanted: f64| {
            Number::exp(Number::ln(error.max(known.at(spacing)) / wanted) / known.order)
        };
        let wanted = 1e-4;
        let too_long = needs(wanted);
        let Needs::TooLong { elements, element_steps, beyond } = too_long else {
            panic!("{too_long:?}")
        };
        // Roundings; elements are whole.
        let near = |a: f64, b: f64, by: f64| assert!((a / b - 1.0).abs() < by, "{too_long:?} {b}");
        near(beyond, times_finer(wanted), 1e-9);
        let whole = 1.0 / elements;
        near(elements, 1.02 * times_finer(wanted) * finest as f64, 1e-9 + whole);
        let more = elements / scene.primary.elements as f64;
        near(element_steps, Plan::of(&scene).element_steps * more * more, 1e-9 + 2.0 * whole);

        let never = needs(1e-7);
        let Needs::Unknown { error: said, elements } = never else { panic!("{never:?}") };
        assert_eq!((elements, said.to_bits()), (finest, error.to_bits()));

        let wanted = 0.8 * error;
        let led = needs(wanted);
        let Needs::Run { elements, found, by_the_law: true, .. } = led else { panic!("{led:?}") };
        assert!(found <= wanted && finest < elements && elements < 2 * finest, "{led:?}");
    }

    /// Of 128 elements down to 16; a second of motion leaves no room for a finer mesh.
    #[test]
    fn a_ladder_goes_down_to_sixteen_elements() {
        let mut scene = shipped("single-400");
        scene.primary.elements = 128;
        scene.duration = 1.0;
        assert_eq!(ladder(&scene), [0.125, 0.25, 0.5, 1.0]);
    }

    /// Laws made up about the finest mesh, that say half of its error: one of order 1, and one so steep
    /// that it asks for next to nothing.
    #[test]
    fn a_mesh_that_was_not_enough_leads_on_by_its_own_error_a_few_times() {
        let scene = measured_by(Strain::Engineering, shipped("single-400"));
        let mut trials = Trials { scene: &scene, runs: Vec::new(), bar: ProgressBar::hidden() };
        for factor in [1.0, 2.0, 4.0] {
            trials.add(factor);
        }
        let of = Quantity::StrainL1;
        let (errors, _) = trials.errors(of);
        let (finest, error) = (errors[2].0, errors[2].1.abs());
        let made_up = |order: f64| {
            let size = |k: f64| 0.5 * error * Number::exp(order * Number::ln(k));
            let sizes = [1.02, 1.01, 1.0].map(|k| (k * finest, size(k)));
            power_law(&sizes, LEVEL).unwrap()
        };
        let far = needs(&mut trials, of, error / 90.0, Some(made_up(1.0)));
        let Needs::TooLong { beyond, .. } = far else { panic!("{far:?}") };
        assert!((beyond / 90.0 - 1.0).abs() < 1e-6, "{beyond}");

        let never = needs(&mut trials, of, 0.5 * error, Some(made_up(60.0)));
        let finer = |elements: usize| (elements as f64 * 1.02 / 0.98).round() as usize;
        let last = finer(finer(finer(4 * scene.primary.elements)));
        let Needs::Unknown { elements, .. } = never else { panic!("{never:?}") };
        assert_eq!((elements, trials.runs.len()), (last, 3 + ATTEMPTS));
    }
}
