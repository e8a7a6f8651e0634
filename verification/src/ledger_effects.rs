//! What each departure from the page does, measured: alone, left out, and together.

use crossfibre::discretisation::Discretisation;
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::number::Number;
use crossfibre::paper::{Lengths, Paper, Printed};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cases::crossover::{exact_coefficients, measured, sideways};
use crate::cases::invariance::moved_along;
use crate::cases::support::{
    Marched, exact_crossover, exact_single, kinked, marched, measured_by, refined, shipped,
    sliding_by,
};
use crate::closed_form::component;
use crate::conform::real::{self, Real};
use crate::planted::{self, march};

/// Times that the mesh of Fig. 3 is refined for the table: 0.25 mm.
const REFINED: usize = 8;

/// What a set of corrections gives for Fig. 3.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CrossoverRow {
    /// Which corrections.
    pub corrections: String,
    /// Mean strain of the primary behind the crossover.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub strain_behind: f64,
    /// R.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub reflection: f64,
    /// T.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub transmission: f64,
    /// D of each arm.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub diversion: f64,
    /// Residual of the energy balance over the energy put in.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub energy: f64,
    /// Velocity of the crossover's node across the primary, m/s.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub sideways: f64,
    /// Residual of the energy balance when the kink has passed a crossover 12 mm from the impact;
    /// none where the run has run away.
    pub energy_after_kink: Option<f64>,
}

/// What a set of corrections gives for a projectile of finite mass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProjectileRow {
    /// Which corrections.
    pub corrections: String,
    /// How the run ended.
    pub outcome: String,
    /// Velocity at the end, m/s.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub velocity: f64,
    /// Residual of the energy balance over the energy put in.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub energy: f64,
    /// Residual of the momentum balance over the momentum at impact.
    #[serde(with = "real::plain")]
    #[schemars(with = "Real")]
    pub momentum: f64,
}

/// What a departure that changes no equation amounts to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Remark {
    /// Id in the ledger.
    pub id: String,
    /// The measured effect, in words and numbers.
    pub effect: String,
}

/// All measured effects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Effects {
    /// Fig. 3.
    pub crossover: Vec<CrossoverRow>,
    /// The closed form beside it.
    pub exact: CrossoverRow,
    /// The projectile of finite mass.
    pub projectile: Vec<ProjectileRow>,
    /// Everything else.
    pub remarks: Vec<Remark>,
}

/// Errata that change the coupling of the fibres.
const COUPLING: [Erratum; 4] = [
    Erratum::ThetaAtOrigin,
    Erratum::PerpendicularResolution,
    Erratum::PerpendicularSign,
    Erratum::CrossoverInertia,
];

/// Errata that change (8).
const PROJECTILE: [Erratum; 3] =
    [Erratum::ProjectileInterval, Erratum::ProjectileSign, Erratum::ProjectileInertia];

/// Named sets: none, each alone, each left out, all.
fn sets(errata: &[Erratum]) -> Vec<(String, Corrections)> {
    let mut sets = vec![("none: as printed".to_owned(), Corrections::NONE)];
    sets.extend(
        errata.iter().map(|&e| (format!("only {}", e.entry().id), Corrections::NONE.with(e))),
    );
    sets.extend(
        errata.iter().map(|&e| (format!("all but {}", e.entry().id), Corrections::ALL.without(e))),
    );
    sets.push(("all".to_owned(), Corrections::ALL));
    sets
}

/// A run whose energy is off by this many times the energy put in has run away.
const RUNS_AWAY: f64 = 1.0;

/// Measures everything.
pub fn measure() -> Effects {
    let fig3 = || refined(shipped("fig3"), REFINED);
    let crossover = sets(&COUPLING)
        .into_iter()
        .map(|(name, corrections)| row(name, Scene { corrections, ..fig3() }, marched))
        .collect();
    let projectile = sets(&PROJECTILE)
        .into_iter()
        .map(|(name, corrections)| projectile_row(name, corrections))
        .collect();
    Effects { crossover, exact: exact_row(&fig3()), projectile, remarks: remarks() }
}

fn row(corrections: String, scene: Scene, march: impl Fn(Scene) -> Marched) -> CrossoverRow {
    let near = {
        let near = refined(kinked(), scene.primary.elements / kinked().primary.elements);
        let run = march(Scene { corrections: scene.corrections, ..near });
        Some(run.balance.energy.relative_residual()).filter(|r| r.abs() < RUNS_AWAY)
    };
    let measured = measured(scene, march);
    let found = measured.coefficients;
    CrossoverRow {
        corrections,
        strain_behind: measured.strain_behind,
        reflection: found.reflection,
        transmission: found.transmission,
        diversion: found.diversion,
        energy: measured.run.balance.energy.relative_residual(),
        sideways: sideways(&measured.run),
        energy_after_kink: near,
    }
}

fn exact_row(scene: &Scene) -> CrossoverRow {
    let exact = exact_coefficients(scene);
    CrossoverRow {
        corrections: "closed form".to_owned(),
        strain_behind: component(scene, exact_crossover(scene).reflected),
        reflection: exact.reflection,
        transmission: exact.transmission,
        diversion: exact.diversion,
        energy: 0.0,
        sideways: 0.0,
        energy_after_kink: Some(0.0),
    }
}

fn projectile_row(name: String, corrections: Corrections) -> ProjectileRow {
    let scene = Scene { corrections, ..shipped("finite-projectile") };
    let outcome = planted::run(&scene, |_| {}).outcome;
    let run = marched(scene);
    let momentum = run.balance.momentum;
    ProjectileRow {
        corrections: name,
        outcome: outcome.to_string(),
        velocity: run.state.projectile.velocity,
        energy: run.balance.energy.relative_residual(),
        momentum: momentum.residual / momentum.initial,
    }
}

fn remarks() -> Vec<Remark> {
    let remark =
        |erratum: Erratum, effect: String| Remark { id: erratum.entry().id.into(), effect };
    vec![
        remark(Erratum::StrainDenominator, strain_denominator()),
        remark(Erratum::StrainPath, strain_path()),
        remark(
            Erratum::CrossSection,
            "None on strain or velocity: with one cross-section it cancels between (2) and (7)."
                .into(),
        ),
        remark(Erratum::TimeLevel, time_level()),
        remark(Erratum::SlipDrift, slip_drift()),
        remark(Erratum::SlideFrame, slide_frame()),
        remark(Erratum::EnergyClaim, energy_claim()),
        remark(Erratum::Density, density()),
    ]
}

/// The page's (3) in place of (4), to see what the denominator does.
#[derive(Clone, Copy)]
struct MarchedByThree;

impl<S: Number> Paper<S> for MarchedByThree {
    fn eqn_4_strain(&self, previous_strain: S, length: Lengths<S>) -> S {
        previous_strain + Printed.eqn_3_strain_increment(length.now, length.previous)
    }
}

fn strain_denominator() -> String {
    let scene = refined(shipped("single-400"), REFINED);
    let by_four = marched(scene.clone());
    let mut state = planted::at_impact::<f64>(&scene, Wavefront::Flagged);
    march::run(&MarchedByThree, &mut state, by_four.state.step, |_| {});
    let middle = state.primary.elements() / 3;
    let window = |strain: &[f64]| strain[middle - 100..middle + 100].iter().sum::<f64>() / 200.0;
    let (three, four) = (window(&state.primary.strain), window(&by_four.state.primary.strain));
    format!(
        "None on a run, which advances by (4) in every edition. Advanced by the printed (3), the \
         plateau at 400 m/s would be {:.4} % instead of {:.4} %.",
        100.0 * three,
        100.0 * four
    )
}

fn strain_path() -> String {
    let scene = shipped("single-400");
    let residual = |strain| {
        marched(refined(measured_by(strain, scene.clone()), REFINED))
            .balance
            .energy
            .relative_residual()
    };
    format!(
        "Energy balance of one fibre at 400 m/s and 0.25 mm: off by {:.1e} with (4), by {:.1e} with \
         engineering strain.",
        residual(Strain::Incremental),
        residual(Strain::Engineering)
    )
}

fn time_level() -> String {
    let explicit = row(String::new(), shipped("fig3"), marched);
    let implicit = row(String::new(), shipped("fig3"), marched_with_tension_now);
    format!(
        "With T2^t, found by iteration in every step, Fig. 3 at 2 mm gives R = {:.5}, T = {:.5}, \
         D = {:.5}, energy off by {:.1e}; with T2^(t-1) R = {:.5}, T = {:.5}, D = {:.5}, {:.1e}.",
        implicit.reflection,
        implicit.transmission,
        implicit.diversion,
        implicit.energy,
        explicit.reflection,
        explicit.transmission,
        explicit.diversion,
        explicit.energy
    )
}

/// Fig. 3's march with the tension of (15) and (16) at `t`: the step is repeated until the tension
/// that it was given is the one that it makes.
fn marched_with_tension_now(scene: Scene) -> Marched {
    let paper = planted::edition(scene.strain, scene.corrections);
    let mut state = planted::at_impact::<f64>(&scene, Wavefront::Flagged);
    let steps = Discretisation::<f64>::of(&scene).steps(scene.duration);
    let first = |state: &State<f64>| {
        state.crossover.as_ref().map_or(0.0, |crossover| crossover.fibre.tension[0])
    };
    let mut outcome = Ok(());
    for _ in 0..steps {
        let before = state.clone();
        let mut guess = first(&state);
        for _ in 0..200 {
            state = before.clone();
            if let Some(crossover) = &mut state.crossover {
                // Only (15) and (16) read the magnitude; the secondary's own march reads the vector.
                crossover.fibre.tension[0] = guess;
            }
            outcome = march::step(&paper, &mut state);
            if first(&state).to_bits() == guess.to_bits() {
                break;
            }
            guess = first(&state);
        }
    }
    let balance = state.balance(&paper, scene.strain);
    let outcome = outcome.err().unwrap_or(crossfibre::outcome::Outcome::Completed);
    Marched { state, outcome, balance }
}

fn slip_drift() -> String {
    let run = marched(shipped("sliding"));
    let Some(crossover) = &run.state.crossover else { return String::new() };
    let primary = &run.state.primary;
    let (node, first) = (primary.position[crossover.node], crossover.fibre.position[0]);
    let along = primary.position[crossover.node + 1] - primary.position[crossover.node - 1];
    let off_line = ((first.x - node.x) * along.y - (first.y - node.y) * along.x).abs()
        / along.dot(&along).sqrt();
    format!(
        "In `sliding.json` the crossover has moved over {} nodes after {:.1} µs and lies {:.1e} m off \
         the primary's line, {:.1e} of an element.",
        crossover.moves,
        1e6 * run.state.time(),
        off_line,
        off_line / primary.properties.spacing
    )
}

fn slide_frame() -> String {
    format!(
        "Fig. 3 with α_s = 0.73, carried along at 136 m/s with its clamps: a node ends {:.1e} of an \
         element away from where it should be; with α_s = 1, {:.0e}.",
        moved_along(sliding_by(0.73, shipped("fig3"))),
        moved_along(sliding_by(1.0, shipped("fig3")))
    )
}

fn energy_claim() -> String {
    let exact = exact_crossover(&measured_by(Strain::Engineering, shipped("fig3")));
    let c = exact.engineering;
    let e2 = exact.diverted.strain.engineering;
    let s = (e2 / (1.0 + e2)).sqrt();
    let (r, t, d) = (c.reflection, c.transmission, c.diversion);
    format!(
        "From the closed form, engineering strain: R² + T² + D² = {:.4} with D of one arm, {:.4} with \
         2D², {:.4} with (2D)²; R² + T² + 2sT² = 1 {:+.1e}.",
        r * r + t * t + d * d,
        r * r + t * t + 2.0 * d * d,
        r * r + t * t + 4.0 * d * d,
        r * r + t * t + 2.0 * s * t * t - 1.0
    )
}

fn density() -> String {
    let strain = |name| {
        100.0 * exact_single(&measured_by(Strain::Engineering, shipped(name))).strain.engineering
    };
    format!(
        "Smith's strain at 400 m/s, engineering law: {:.4} % with 1206.7 kg/m³, {:.4} % with 1440.",
        strain("single-400"),
        strain("single-400-1440")
    )
}
