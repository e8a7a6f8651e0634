//! Laws at their ends: slack fibres, wave speeds that outgrow the step, dashpots that are rigid or absent.

use crossfibre::material::{Arm, Update};
use crossfibre::outcome::Outcome;
use crossfibre::result::RunResult;
use crossfibre::scene::{Law, Material, Scene, Strain};

use super::{Group, Row, checks, row, run};
use crate::cases::support::{exact_primary, mean, measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::closed_form;
use crate::planted;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.laws",
        title: "Slack after the rebound, wave speeds that outgrow the step, dashpots that do nothing",
        equations: &[2, 6, 7, 8],
        run: || checks(rows()),
    },
    rows,
    found: "\
A fibre of a law without compression goes slack after the rebound, carries nothing, and keeps its energy and
momentum, if the step is short: elements that go slack and taut again in every other step make energy,
without bounds near α = 1 and by 7 % at α = 0.4, 2 % at 0.3 and 0.3 % at 0.1. Artificial viscosity prevents
it. A hardening law whose waves outgrow the step ends in the step and at the element where they do,
with a Courant number that has been run to the end; a law that softens until it has no waves says so. A
dashpot that relaxes in a billionth of a step leaves the springs beside it, one that takes a billion steps is
rigid.",
};

/// One fibre, engineering strain, 600 elements.
fn fibre(material: impl Into<Material>, courant: f64) -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("single-400"));
    scene.primary.elements = 600;
    scene.primary.material = material.into();
    Scene { courant, ..scene }
}

/// A projectile lighter than a node: its fibre goes slack after the rebound.
fn rebounding(tension_only: bool, courant: f64) -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("finite-projectile"));
    scene.projectile.mass = Some(1e-7);
    scene.primary.material.tension_only = tension_only;
    Scene { courant, duration: 400e-6, ..scene }
}

/// The least tension of any element in any step, N, and the result.
fn least_tension(scene: &Scene) -> (f64, RunResult) {
    let mut least = 0.0_f64;
    let result = planted::run(scene, |state| {
        least = state.primary.tension.iter().fold(least, |least, &t| least.min(t));
    });
    (least, result)
}

fn slack() -> Vec<Row> {
    let (pushed, pushing) = least_tension(&rebounding(false, 0.1));
    let (least, result) = least_tension(&rebounding(true, 0.1));
    let chatters = run(&rebounding(true, 0.9));
    let slack = result.primary.strain.iter().filter(|&&e| e < 0.0).count();
    let (energy, momentum) = result.balance.map_or((f64::NAN, f64::NAN), |b| {
        (b.energy.relative_residual(), b.momentum.residual / b.momentum.initial)
    });
    let what = format!("0.1 mg, 400 µs, tension only, α = 0.1: {slack} of 150 elements end slack");
    let says = result.outcome.to_string();
    vec![
        row(
            "0.1 mg, 400 µs, (7) in compression too",
            "Elements push: the scene is one that goes slack",
            pushing.outcome.to_string(),
            "the law",
            "greatest thrust, N",
            -pushed,
            Bound::AtLeast(200.0),
            "compressed by 1 % of 58.6 kN",
        ),
        row(
            what.clone(),
            "No element ever pushes",
            says.clone(),
            "the law",
            "least tension of any element in any step, N",
            least,
            Bound::Exactly(0.0),
            "a slack fibre carries nothing",
        ),
        row(
            what.clone(),
            "Energy is kept",
            says.clone(),
            "first law",
            "residual over the energy put in",
            energy.abs(),
            Bound::AtMost(1e-2),
            "elements that go slack and taut again in every other step",
        ),
        row(
            what,
            "Momentum is kept",
            says,
            "second law for the whole system",
            "residual over the momentum at impact",
            momentum.abs(),
            Bound::AtMost(5e-14),
            "rounding: a slack element pulls neither of its ends",
        ),
        row(
            "the same at α = 0.9",
            "Found: near α = 1 that makes energy without end, and the run says so",
            chatters.outcome.to_string(),
            "typed outcome",
            "1 if unbalanced",
            f64::from(u8::from(matches!(chatters.outcome, Outcome::EnergyUnbalanced { .. }))),
            Bound::Exactly(1.0),
            "the step is stable for a spring and for none, not for one that comes and goes",
        ),
    ]
}

/// Stiffer by `hardening` × strain.
fn hardening(hardening: f64) -> Law {
    Law::Polynomial { coefficients: vec![58.6e9, hardening * 58.6e9] }
}

/// Mean strain over the middle half between kink and front, over the exact one of the law, less 1.
fn departure(scene: &Scene, result: &RunResult) -> f64 {
    let fibre = &scene.primary;
    let smith = closed_form::struck(scene, &fibre.material, fibre.density)
        .expect("a curved elastic law in engineering strain has a solution");
    let kink = smith.kink_speed_lagrangian * result.time;
    let way = smith.tail_speed * result.time - kink;
    let spacing = fibre.length / fibre.elements as f64;
    let found = mean(spacing, &result.primary.strain, kink + 0.25 * way, kink + 0.75 * way);
    (found / smith.strain.engineering - 1.0).abs()
}

fn outgrown() -> Vec<Row> {
    const HARDENING: f64 = 17.0;
    let scene = fibre(hardening(HARDENING), 0.9);
    // T'/T'(0) = 1 + 2 × 17 ε.
    let mut greatest = 0.0_f64;
    let result = planted::run(&scene, |state| {
        let strain = state.primary.strain.iter().fold(0.0_f64, |most, &e| most.max(e));
        greatest = greatest.max(scene.courant * (1.0 + 2.0 * HARDENING * strain).sqrt());
    });
    let (exceeded, served) = match result.outcome {
        Outcome::CourantExceeded { courant, would_serve, .. } => (courant, would_serve),
        _ => (f64::NAN, None),
    };
    let served = Scene { courant: served.unwrap_or(f64::NAN), ..scene };
    let again = run(&served);
    let softening = fibre(hardening(-20.0), 0.9);
    let ended = run(&Scene {
        projectile: crossfibre::scene::Projectile { velocity: 1000.0, mass: None },
        ..softening
    });
    let says = result.outcome.to_string();
    let oracle = "α √(T′(ε)/T′(0)) from the strains of the whole steps";
    vec![
        row(
            "T = E(ε + 17ε²), α = 0.9",
            "Until the step that is named the waves keep within the step",
            says.clone(),
            oracle,
            "greatest local Courant number of any step before",
            greatest,
            Bound::Within(0.9, 1.0),
            "at 1 a wave crosses an element in a step",
        ),
        row(
            "T = E(ε + 17ε²), α = 0.9",
            "in that step they do not",
            says.clone(),
            oracle,
            "the Courant number that is reported",
            exceeded,
            Bound::Within(1.0, 1.05),
            "just beyond it",
        ),
        row(
            format!(
                "T = E(ε + 17ε²), α = {:.3}: the number that would have served",
                served.courant
            ),
            "It serves: the plateau is that of the law",
            again.outcome.to_string(),
            "Smith's impact on a fibre of this law",
            "relative error of the mean over the middle half between kink and front",
            departure(&served, &again),
            Bound::AtMost(1e-3),
            "a shock, with oscillations behind it",
        ),
        row(
            "T = E(ε − 20ε²), 1000 m/s",
            "A law that has no waves beyond 2.5 % ends as a typed outcome",
            ended.outcome.to_string(),
            "typed outcome",
            "1 if so",
            f64::from(u8::from(matches!(ended.outcome, Outcome::NoWaves { .. }))),
            Bound::Exactly(1.0),
            "",
        ),
    ]
}

fn dashpots() -> Vec<Row> {
    const EQUILIBRIUM: f64 = 31.7e9;
    const ARM: f64 = 26.9e9;
    let viscoelastic = |relaxation_time| Law::Viscoelastic {
        equilibrium_modulus: EQUILIBRIUM,
        arms: vec![Arm { modulus: ARM, relaxation_time }],
        update: Update::Exact,
    };
    let eyring = |rate| Law::Eyring {
        equilibrium_modulus: EQUILIBRIUM,
        modulus: ARM,
        rate,
        stress: 1e8,
        update: Update::Exact,
    };
    // The same time step, whatever the law: α × Δx over the speed of all springs.
    let springs = |modulus: f64| {
        fibre(Material::linear(modulus), 0.9 * (modulus / (EQUILIBRIUM + ARM)).sqrt())
    };
    let time_step = 0.9 * 0.3 / 600.0 / exact_primary(&fibre(viscoelastic(1.0), 0.9)).wave_speed();
    let (rigid, gone) = (run(&springs(EQUILIBRIUM + ARM)), run(&springs(EQUILIBRIUM)));
    let line = |what: &str, law: Law, like: &RunResult, most, reason: &str| {
        let result = run(&fibre(law, 0.9));
        let greatest = like.primary.strain.iter().fold(0.0_f64, |most, &e| most.max(e));
        let pairs = result.primary.strain.iter().zip(&like.primary.strain);
        let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, worse) / greatest;
        row(
            what,
            "As the springs alone",
            result.outcome.to_string(),
            "the linear law of the springs that are left, same time step",
            "greatest difference of strain, over the greatest strain",
            apart,
            Bound::AtMost(most),
            reason,
        )
    };
    vec![
        line(
            "a Maxwell arm that relaxes in a billionth of a step",
            viscoelastic(1e-9 * time_step),
            &gone,
            1e-8,
            "what is left of the arm's stress, τ/Δt",
        ),
        line(
            "a Maxwell arm that relaxes in a billion steps",
            viscoelastic(1e9 * time_step),
            &rigid,
            5e-7,
            "what has relaxed, t/τ = 6e-7 for the oldest part of the wave",
        ),
        line(
            "an Eyring arm of 10³⁰ per second",
            eyring(1e30),
            &gone,
            1e-10,
            "rounding of positions, 3e-17 m of 0.3 m over 0.5 mm, in 600 steps",
        ),
        line(
            "an Eyring arm of 10⁻⁶⁰ per second",
            eyring(1e-60),
            &rigid,
            3e-10,
            "rounding of positions, as above",
        ),
    ]
}

fn rows() -> Vec<Row> {
    [slack(), outgrown(), dashpots()].into_iter().flatten().collect()
}
