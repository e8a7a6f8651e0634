//! The first law with dashpots, softening, shocks and slack.

use crossfibre::constitution::Constitution;
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

use crate::cases::support::{check, marched, measured_by, order, refined, shipped, watched};
use crate::cases::{Bound, Check};
use crate::planted;

const FIRST_LAW: &str =
    "first law: kinetic + stored + dissipated = at impact + work of the driven node";
const NORM: &str = "residual over the energy in the fibres";

fn residual(scene: Scene, factor: usize) -> f64 {
    let run = marched(refined(scene, factor));
    assert!(run.outcome.is_completed(), "{}", run.outcome);
    let energy = run.balance.energy;
    energy.residual / (energy.kinetic + energy.stored + energy.dissipated)
}

/// The scenes with the bounds of their residuals, engineering strain and (4).
const SCENES: [(&str, [f64; 2]); 5] = [
    ("softening", [5e-5, 2e-4]),
    ("hardening", [2e-4, 3e-5]),
    ("viscoelastic", [2e-4, 3e-4]),
    ("eyring", [3e-4, 3e-4]),
    ("artificial-viscosity", [1e-4, 2e-4]),
];

/// Stored, dissipated and kinetic against work.
pub fn balance() -> Vec<Check> {
    let mut checks = Vec::new();
    for (name, bounds) in SCENES {
        for (strain, bound) in [Strain::Engineering, Strain::Incremental].into_iter().zip(bounds) {
            let scene = || measured_by(strain, shipped(name));
            let measure = match strain {
                Strain::Engineering => "engineering strain",
                Strain::Incremental => "(4)",
            };
            let [coarse, fine] = [1, 8].map(|factor| residual(scene(), factor));
            checks.push(check(
                format!("{name}, {measure}: energy is conserved"),
                FIRST_LAW,
                NORM,
                coarse.abs(),
                Bound::AtMost(bound),
                "fronts of a few elements, and the mean of two velocities at a jump: O(Δx/ct)",
            ));
            let steady = name == "hardening" && strain == Strain::Engineering;
            let (range, why) = if steady {
                let why = "a shock of some steps on any mesh: the mean of the tensions before and \
                           after a step is not the integral of a curved law: order zero";
                (Bound::Within(0.0, 0.3), why)
            } else {
                let why = "the number of elements in a front grows more slowly than the mesh is \
                           refined, and (4) books the work of its own path: order one";
                (Bound::Within(0.8, 1.2), why)
            };
            checks.push(check(
                format!("{name}, {measure}: order of the residual"),
                FIRST_LAW,
                "observed order over a factor of 8",
                order(coarse, fine, 8.0),
                range,
                why,
            ));
        }
    }
    checks.push(at_a_shock());
    checks.push(check(
        "No dashpot and no artificial viscosity gives energy in any step of these scenes",
        "second law",
        "elements whose dissipated energy falls in a step, over all steps, both measures",
        SCENES
            .into_iter()
            .flat_map(|(name, _)| [Strain::Engineering, Strain::Incremental].map(|s| (name, s)))
            .map(|(name, strain)| gains(measured_by(strain, shipped(name))))
            .sum(),
        Bound::Exactly(0.0),
        "a square integrated, or a product of one sign: no tolerance",
    ));
    checks
}

/// What the mesh leaves of the residual at a shock, the time step takes.
fn at_a_shock() -> Check {
    let at = |courant: f64| {
        let scene = measured_by(Strain::Engineering, shipped("hardening"));
        residual(Scene { courant, ..scene }, 8)
    };
    check(
        "hardening, engineering strain: the residual falls with the Courant number",
        FIRST_LAW,
        "observed order from α = 0.37 to 0.185, 0.15 mm",
        order(at(0.37), at(0.185), 2.0),
        Bound::Within(1.5, 2.5),
        "twice the steps in a shock: the trapezoidal rule is of order two",
    )
}

/// How often the dissipated energy of an element falls in a step.
fn gains(scene: Scene) -> f64 {
    let (mut dissipated, mut fallen) = (Dissipated::default(), 0);
    watched(scene, Wavefront::Flagged, &|_| {}, |state| fallen += dissipated.fallen(state));
    fallen as f64
}

/// The dissipated energy of each element of the primary and of the secondary, a step ago.
#[derive(Default)]
struct Dissipated([Vec<f64>; 2]);

impl Dissipated {
    /// The elements that have less than a step ago.
    fn fallen(&mut self, state: &State<f64>) -> usize {
        let crossing = state.crossover.as_ref();
        let [primary, secondary] = &mut self.0;
        fallen(primary, state.primary.constitution.as_ref())
            + fallen(secondary, crossing.and_then(|c| c.fibre.constitution.as_ref()))
    }
}

/// The same of a fibre.
fn fallen(last: &mut Vec<f64>, constitution: Option<&Constitution<f64>>) -> usize {
    let Some(constitution) = constitution else { return 0 };
    let n = constitution.law.memory();
    if n == 0 {
        return 0;
    }
    let elements = constitution.memory.chunks_exact(n);
    let now: Vec<_> = elements.map(|memory| constitution.law.dissipated(memory)).collect();
    let fallen = last.iter().zip(&now).filter(|(last, now)| now < last).count();
    *last = now;
    fallen
}

fn least(tension: &[f64]) -> f64 {
    tension.iter().fold(f64::MAX, |a, &b| a.min(b))
}

/// A rebound that leaves the fibre slack.
pub fn slack() -> Vec<Check> {
    let scene = || shipped("slack");
    let bearing = || {
        let mut scene = scene();
        scene.primary.material.tension_only = false;
        scene
    };
    let watch = |scene| {
        let mut lowest = f64::MAX;
        let run = watched(scene, Wavefront::Flagged, &|_| {}, |state: &State<f64>| {
            lowest = lowest.min(least(&state.primary.tension[..state.primary.visited - 1]));
        });
        assert!(run.outcome.is_completed(), "{}", run.outcome);
        (run, lowest)
    };
    let ((slack, lowest), (_, compressed)) = (watch(scene()), watch(bearing()));
    let fibre = &slack.state.primary;
    let at_rest = fibre.tension.iter().filter(|&&tension| tension == 0.0).count();
    let relative = |scene| marched(scene).balance.energy.relative_residual().abs();
    let hasty = planted::run(&Scene { courant: 0.87, duration: 500e-6, ..scene() }, |_| ());
    let unbalanced = matches!(hasty.outcome, Outcome::EnergyUnbalanced { .. });
    vec![
        check(
            "The fibre has crept, and at the rebound it is slack",
            "lengths and tensions",
            "share of the elements without tension at 401 µs",
            at_rest as f64 / fibre.elements() as f64,
            Bound::Within(0.2, 0.9),
            "its elements are shorter than their material; waves of the last tension run about",
        ),
        check(
            "It is never compressed",
            "the law",
            "least tension behind the front in any step, N",
            lowest,
            Bound::Exactly(0.0),
            "a fibre without compression: no tolerance",
        ),
        check(
            "A fibre that bears compression is",
            "the same scene without tension_only",
            "greatest compression behind the front in any step, N",
            -compressed,
            Bound::AtLeast(20.0),
            "the same fibre, too long by what it crept",
        ),
        check(
            "Energy is in balance while it is slack",
            FIRST_LAW,
            "residual over the energy put in",
            relative(scene()),
            Bound::AtMost(3e-5),
            "fronts of an element, now also where it becomes taut",
        ),
        check(
            "as with compression",
            FIRST_LAW,
            "residual over the energy put in",
            relative(bearing()),
            Bound::AtMost(4e-5),
            "fronts of an element",
        ),
        check(
            "At α = 0.87 a slack fibre is unstable, though no wave outruns the step, and the run \
             says so",
            "typed outcome; the fibre that bears compression completes",
            "1 if the energy is found out of balance, 500 µs",
            f64::from(u8::from(unbalanced)),
            Bound::Exactly(1.0),
            "elements that are now slack, now taut: the bound α = 1 is that of a modulus that stays",
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two viscoelastic fibres, of which one or both are put back to what they were at impact.
    #[test]
    fn dissipated_energy_that_falls_is_counted_in_both_fibres() {
        let impact = State::<f64>::at_impact(&shipped("viscoelastic"), Wavefront::Flagged);
        let end = marched(shipped("viscoelastic")).state;
        let from_to = |before: &State<f64>, after: &State<f64>| {
            let mut dissipated = Dissipated::default();
            assert_eq!(dissipated.fallen(before), 0);
            dissipated.fallen(after)
        };
        let primary = State { primary: impact.primary.clone(), ..end.clone() };
        let secondary = State { crossover: impact.crossover.clone(), ..end.clone() };
        let [along, across] = [primary, secondary].map(|state| from_to(&end, &state));
        assert!(along > 0 && across > 0, "{along} {across}");
        assert_eq!(from_to(&end, &impact), along + across);
        assert_eq!(from_to(&impact, &end), 0);
        assert_eq!(from_to(&end, &end), 0);
    }
}
