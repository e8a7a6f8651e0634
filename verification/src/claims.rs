//! What the paper claims, and what comes of it here.

use crossfibre::exact::crossover::Coefficients;
use crossfibre::exact::smith::{Fibre, Law};
use crossfibre::scene::{Scene, Strain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cases::crossover::{exact_coefficients, measured};
use crate::cases::materials::front_of;
use crate::cases::support::{
    Marched, different_bits, exact_crossover, exact_single, marched, measured_by, refined,
    relative, shipped,
};
use crate::cases::{self, Verdict};

/// What came of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Finding {
    /// Found here as claimed.
    Reproduced,
    /// Found otherwise.
    NotReproduced,
    /// The page does not say enough.
    Undecidable,
    /// Needs work that is not done yet.
    NotExamined,
}

/// One claim of the paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// What the paper says, in our words.
    pub claim: String,
    /// What came of it.
    pub finding: Finding,
    /// The evidence, with numbers.
    pub evidence: String,
}

/// All claims, with their evidence measured.
pub fn examine() -> Vec<Claim> {
    vec![
        strain_line(),
        both_at_origin(),
        overshoot(),
        reflection(),
        diversion(),
        sum_of_squares(),
        modulus(),
        sliding(),
        accuracy(),
        stability(),
        cost(),
        flags(),
        computer_time(),
        other_laws(),
        artificial_viscosity(),
    ]
}

fn claim(claim: &str, holds: bool, evidence: String) -> Claim {
    let finding = if holds { Finding::Reproduced } else { Finding::NotReproduced };
    Claim { claim: claim.into(), finding, evidence }
}

fn strain_line() -> Claim {
    let scene = shipped("single-400");
    let log = 100.0 * exact_single(&scene).strain.logarithmic;
    let engineering = measured_by(Strain::Engineering, scene.clone());
    let engineering = 100.0 * exact_single(&engineering).strain.engineering;
    let marched = 100.0 * marched(scene).primary_strain(0.075, 0.1125);
    claim(
        "A single fibre struck at 400 m/s is strained by 1.45 % (dotted line of Fig. 3)",
        (engineering - 1.45).abs() < 0.01,
        format!(
            "Smith's relation gives {engineering:.4} % (engineering law) and {log:.4} % (the law of \
             (4) and (7)), the march at 2 mm {marched:.4} %, with the density that the page implies, \
             1206.7 kg/m³; not with 1440."
        ),
    )
}

fn both_at_origin() -> Claim {
    let single = marched(shipped("single-400"));
    let both = marched(shipped("both-at-origin"));
    let different = different_bits(&single.state.primary, &both.state.primary, |k| k);
    claim(
        "With both fibres at the impact point both respond as single fibres, identically",
        different == 0.0,
        format!(
            "{different} of all positions, velocities, strains and tensions differ in any bit."
        ),
    )
}

fn overshoot() -> Claim {
    let at = |factor| {
        let scene = refined(shipped("single-400"), factor);
        let plateau = exact_single(&scene).strain.logarithmic;
        let run = marched(scene);
        let greatest = run.state.primary.strain.iter().fold(0.0_f64, |a, &b| a.max(b));
        100.0 * (greatest / plateau - 1.0)
    };
    let (coarse, fine) = (at(1), at(16));
    claim(
        "Overshoot and oscillation near the wavefront",
        coarse > 5.0 && fine > 5.0,
        format!(
            "The greatest strain is {coarse:.1} % over the plateau at 2 mm and {fine:.1} % at \
             0.125 mm: it narrows with the mesh but does not shrink."
        ),
    )
}

/// R from the mean strain of the primary between two distances, in per cent.
fn reflection_between(run: &Marched, incident: f64, (from, to): (f64, f64)) -> f64 {
    100.0 * (run.primary_strain(from, to) / incident - 1.0)
}

fn reflection() -> Claim {
    let scene = shipped("fig3");
    let exact = 100.0 * exact_coefficients(&scene).reflection;
    let incident = exact_single(&scene).strain.logarithmic;
    // Between the kink and the crossover, at all times at which the reflected wave is in between.
    let at = |microseconds: f64| {
        let run = marched(Scene { duration: microseconds * 1e-6, ..scene.clone() });
        reflection_between(&run, incident, (0.022, 0.098))
    };
    let times = [15.5, 17.2, 19.8, 22.6, 25.6];
    let rising = times.map(|t| format!("{:.1} % at {t} µs", at(t))).join(", ");
    // Behind the reflected wave only, at the paper's time.
    let windows = [(0.044, 0.056), (0.05, 0.098), (0.06, 0.07), (0.08, 0.098)];
    let scatter = |factor| {
        let run = marched(refined(scene.clone(), factor));
        let found = windows.map(|window| reflection_between(&run, incident, window));
        let low = found.iter().fold(f64::MAX, |a, &b| a.min(b));
        let high = found.iter().fold(0.0_f64, |a, &b| a.max(b));
        format!("{low:.2} to {high:.2} %")
    };
    let (coarse, middle, fine) = (scatter(1), scatter(4), scatter(16));
    claim(
        "Reflection coefficients are near 1 %, with considerable scatter",
        exact < 2.0,
        format!(
            "Fig. 3 has R = {exact:.2} % (closed form). A mean between kink and crossover is any value \
             below, by how much of it the reflected wave has filled: at 2 mm {rising}. Four windows \
             behind the reflected wave at 28.7 µs give {coarse} at 2 mm, {middle} at 0.5 mm and {fine} \
             at 0.125 mm: the scatter is the mesh's, the value near 1 % the window's."
        ),
    )
}

fn diversion() -> Claim {
    let scene = refined(shipped("fig3"), 8);
    let found = measured(scene.clone(), marched).coefficients;
    let exact = exact_coefficients(&scene);
    claim(
        "Diversion is much stronger than reflection",
        exact.diversion > 3.0 * exact.reflection,
        format!(
            "Fig. 3: D = {:.4} of each arm, R = {:.4} (closed form {:.4} and {:.4}).",
            found.diversion, found.reflection, exact.diversion, exact.reflection
        ),
    )
}

fn sum_of_squares() -> Claim {
    let scene = measured_by(Strain::Engineering, shipped("fig3"));
    let exact = exact_crossover(&scene);
    let Coefficients { reflection: r, transmission: t, diversion: d } = exact.engineering;
    let one_arm = r * r + t * t + d * d;
    let both_arms = r * r + t * t + 2.0 * d * d;
    let added = r * r + t * t + 4.0 * d * d;
    let strain = exact.diverted.strain.engineering;
    let s = (strain / (1.0 + strain)).sqrt();
    let power = r * r + t * t + 2.0 * s * t * t - 1.0;
    Claim {
        claim: "R² + T² + D² = 1, which conservation of energy demands".into(),
        finding: Finding::NotReproduced,
        evidence: format!(
            "One arm gives {one_arm:.4}, each arm's D² {both_arms:.4}, the arms' strains added before \
             squaring {added:.4}: the page does not say which, and the last, near 1, is no sum of \
             energies. Half of the diverted power is sideways motion that no strain shows. The exact \
             balance of power is R² + T² + 2sT² = 1, s = √(ε₂/(1 + ε₂)): off by {:.0e} here, and for \
             any fibres and α_s in case crossover.power.",
            power.abs()
        ),
    }
}

/// The closed form for Fig. 3 with another modulus and slide factor.
fn exact_with(modulus: f64, slide_factor: f64) -> Coefficients {
    let fibre = Fibre { modulus, density: 1206.7, area: 1e-6 };
    crate::oracle::crossover(Law::Engineering, &fibre, &fibre, slide_factor, 400.0)
        .expect("in the range of the closed form")
        .engineering
}

fn modulus() -> Claim {
    let [soft, stiff] = [20e9, 200e9].map(|modulus| exact_with(modulus, 1.0));
    let change = |a: f64, b: f64| 100.0 * relative(b, a);
    let (d, t) =
        (change(soft.diversion, stiff.diversion), change(soft.transmission, stiff.transmission));
    claim(
        "Diversion decreases with the modulus, and varies more strongly with it than transmission",
        stiff.diversion < soft.diversion && d > t,
        format!(
            "From 20 to 200 GPa, closed form: D falls from {:.4} to {:.4} ({d:.0} %), T rises from \
             {:.4} to {:.4} ({t:.1} %), R falls from {:.4} to {:.4}.",
            soft.diversion,
            stiff.diversion,
            soft.transmission,
            stiff.transmission,
            soft.reflection,
            stiff.reflection
        ),
    )
}

fn sliding() -> Claim {
    let [one, half, tenth] = [1.0, 0.5, 0.1].map(|slide| exact_with(58.6e9, slide));
    claim(
        "As the slide factor falls to zero, R and D tend to zero and T to one",
        tenth.reflection < 0.01 && tenth.diversion < 0.01 && tenth.transmission > 0.99,
        format!(
            "Closed form at α_s = 1, 0.5, 0.1: R = {:.4}, {:.4}, {:.5}; D = {:.4}, {:.4}, {:.4}; T = \
             {:.4}, {:.4}, {:.5}. At α_s = 0: case identity.free-sliding.",
            one.reflection,
            half.reflection,
            tenth.reflection,
            one.diversion,
            half.diversion,
            tenth.diversion,
            one.transmission,
            half.transmission,
            tenth.transmission
        ),
    )
}

fn accuracy() -> Claim {
    let oscillation = |courant| {
        let mut scene = measured_by(Strain::Engineering, refined(shipped("single-400"), 4));
        scene.courant = courant;
        let exact = exact_single(&scene).strain.engineering;
        100.0 * marched(scene).oscillation(exact, 0.1, 0.19)
    };
    let [one, nine, half] = [1.0, 0.9, 0.5].map(oscillation);
    claim(
        "The scheme is accurate at α = 1 and increasingly inaccurate below",
        one < nine && nine < half,
        format!(
            "Root mean square departure from Smith's plateau behind the front, 0.5 mm: {one:.2} % at \
             α = 1, {nine:.2} % at 0.9, {half:.2} % at 0.5. Axial impact at α = 1 is exact to rounding."
        ),
    )
}

/// How many checks of some cases pass, and how many there are.
fn passed(ids: &[&str]) -> (usize, usize) {
    let chosen = cases::all().into_iter().filter(|case| ids.contains(&case.id));
    let checks: Vec<_> = chosen.flat_map(|case| (case.run)()).collect();
    let passed = checks.iter().filter(|check| check.verdict() == Verdict::Passed).count();
    (passed, checks.len())
}

fn stability() -> Claim {
    let cases = ["axial.dispersion", "courant.growth", "courant.impact"];
    let (passed, all) = passed(&cases);
    claim(
        "Stable for α ≤ 1, unstable for α > 1",
        passed == all,
        format!(
            "{passed} of {all} checks of {}: the linear fibre keeps its standing waves at α = 0.5, 0.9 and \
             1, and its highest mode grows by von Neumann's root above. The law of (4) and (7) softens \
             under tension and tolerates a little more; struck at more than half the wave speed it is \
             unstable at α = 1 all the same (ledger strain-path).",
            cases.join(", ")
        ),
    )
}

/// Element-steps of a run.
fn element_steps(scene: &Scene) -> f64 {
    crate::planted::run(scene, |_| {}).counts.element_steps as f64
}

fn cost() -> Claim {
    let [coarse, fine] = [8, 16].map(|factor| element_steps(&refined(shipped("timing"), factor)));
    claim(
        "Cost increases as the square of the number of nodes",
        (fine / coarse - 4.0).abs() < 0.05,
        format!("Twice the nodes cost {:.3} times the element-steps.", fine / coarse),
    )
}

fn flags() -> Claim {
    let scene = shipped("timing");
    let flagged = element_steps(&scene);
    let secondary = scene.secondary.as_ref().map_or(0, |s| s.elements);
    let all = (100 * (scene.primary.elements + secondary)) as f64;
    claim(
        "Flags that end the length loop at the wavefront improve efficiency",
        flagged < all,
        format!(
            "The timing example visits {flagged} elements with the flags, {all} without: {:.0} %.",
            100.0 * flagged / all
        ),
    )
}

fn computer_time() -> Claim {
    let steps = element_steps(&shipped("timing"));
    Claim {
        claim:
            "10.1 s of an IBM 370/168 for 0.2 m of the primary and 0.1 m of the secondary at 2 mm"
                .into(),
        finding: Finding::Undecidable,
        evidence: format!(
            "The page does not say how often it wrote results. The run is {steps} element-steps: {:.2} \
             ms each on that machine. `verify` prints how long this machine takes for them: it is not \
             here because it differs every time.",
            10_100.0 / steps
        ),
    }
}

fn other_laws() -> Claim {
    let cases = [
        "material.softening",
        "material.hardening",
        "material.rod",
        "material.arms",
        "material.energy",
    ];
    let (passed, all) = passed(&cases);
    claim(
        "The model holds nonlinear elasticity (polynomial or exponential), linear and nonlinear \
         viscoelasticity, and other laws without difficulty",
        passed == all,
        format!(
            "{passed} of {all} checks of {}: fans and shocks against Smith's relation with the waves of \
             the law, a viscoelastic rod against its transform, an Eyring element against Runge-Kutta, \
             energy of all. The page prints none of its laws: the forms here are the usual ones. One \
             difficulty: a law that hardens has a shock, and without artificial viscosity the scheme \
             makes a train of waves of it that no mesh removes.",
            cases.join(", ")
        ),
    )
}

fn artificial_viscosity() -> Claim {
    let [bare, viscous] =
        [false, true].map(|viscous| 100.0 * front_of(Strain::Incremental, 1, viscous).overshoot);
    claim(
        "Artificial viscosity diminishes the oscillations",
        viscous < 0.25 * bare,
        format!(
            "One fibre at 400 m/s, 2 mm, α = 0.7: the greatest strain is {bare:.1} % over the plateau \
             without, {viscous:.1} % with linear = 0.3 and quadratic = 1. It costs step length, and \
             the front of a linear law, which nothing holds steep, spreads: case material.viscosity."
        ),
    )
}
