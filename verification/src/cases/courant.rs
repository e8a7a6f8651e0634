//! Stability: what the paper says of α < 1, = 1, > 1, found by growth rates.

use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::scene::Strain;

use super::axial::{edition, held, linear_scene};
use super::support::{check, marched, measured_by, relative, shipped};
use super::{Bound, Case, Check};
use crate::oracle::amplification;
use crate::planted::march;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "courant.growth",
        title: "α > 1: the highest mode grows as von Neumann says",
        equations: &[2, 6, 7, 20],
        run: growth,
    },
    Case {
        id: "courant.impact",
        title: "Transverse impact at α = 0.5, 0.9, 1 and above",
        equations: &[2, 4, 5, 6, 7, 20],
        run: impact,
    },
];

fn growth() -> Vec<Check> {
    // Steps enough for growth by about e^16: from 1e-11 m to a hundredth of an element.
    [(1.001, 220, 50, 2e-11), (1.01, 58, 15, 4e-7), (1.1, 18, 5, 4e-8)]
        .into_iter()
        .map(|(courant, steps, span, tolerance)| {
            let scene = linear_scene(courant);
            let n = scene.primary.elements;
            let phase = std::f64::consts::PI * (n - 1) as f64 / n as f64;
            let mut state = held(&scene, |i| 1e-5 * Number::sin(phase * i as f64));
            let mut amplitude = Vec::new();
            march::run(&edition(), &mut state, steps, |state| {
                amplitude.push(state.primary.velocity[1].x.abs());
            });
            let last = amplitude.len() - 1;
            let measured = Number::ln(amplitude[last] / amplitude[last - span]) / span as f64;
            let expected = Number::ln(amplification(courant, phase));
            check(
                format!("At α = {courant} the highest mode grows by the larger root"),
                "von Neumann: g² - 2(1 - 2α² sin²(kΔx/2)) g + 1 = 0",
                "relative error of the growth rate ln g",
                relative(measured, expected),
                Bound::AtMost(tolerance),
                "rounding, 1e-5 of the first amplitude, excites the modes beside the highest, which \
                 grow nearly as fast where α leaves room for them",
            )
        })
        .collect()
}

/// The size of a residual; beyond every bound if there is none.
fn size(outcome: &Outcome, residual: f64) -> f64 {
    if outcome.is_completed() && residual.is_finite() { residual.abs() } else { f64::MAX }
}

fn impact() -> Vec<Check> {
    let energy = |courant: f64, duration: f64| {
        let mut scene = measured_by(Strain::Engineering, shipped("single-400"));
        scene.courant = courant;
        scene.duration = duration;
        let run = marched(scene);
        size(&run.outcome, run.balance.energy.relative_residual())
    };
    // Seven passages of the fibre, so that waves of all lengths have met.
    let long = 300e-6;
    let mut checks: Vec<Check> = [0.5, 0.9, 1.0]
        .into_iter()
        .map(|courant| {
            check(
                format!("At α = {courant} the fibre keeps its energy over seven passages"),
                "energy balance",
                "residual over the energy put in, engineering strain",
                energy(courant, long),
                Bound::AtMost(if courant < 0.9 { 4e-5 } else { 1e-4 }),
                "oscillating energy of unresolved fronts, kept but not grown",
            )
        })
        .collect();
    checks.extend([1.01, 1.1].into_iter().map(|courant| {
        check(
            format!("At α = {courant} it does not"),
            "energy balance",
            "residual over the energy put in is beyond 100 %, or a number overflowed: 1 if so",
            f64::from(u8::from(energy(courant, long) > 1.0)),
            Bound::Exactly(1.0),
            "growth of the highest mode by 1.3 a step and more, over a thousand steps",
        )
    }));
    checks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_that_ends_early_and_a_residual_without_a_number_are_beyond_every_bound() {
        let ended = Outcome::EnergyUnbalanced { step: 7, residual: Some(1.3) };
        assert_eq!(size(&Outcome::Completed, -0.37), 0.37);
        assert_eq!(size(&ended, 0.37), f64::MAX);
        for residual in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(size(&Outcome::Completed, residual), f64::MAX);
        }
    }
}
