//! Rounding in (4): what L^t/L^(t−1) − 1 loses of a small strain.

use std::cell::Cell;

use crossfibre::double_double::DoubleDouble;
use crossfibre::errata::Corrections;
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{Lengths, Paper, Printed};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::Wavefront;

use super::{Group, Row, checks, row, run};
use crate::cases::support::{exact_primary, measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::planted::{at_impact, edition, march};
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.rounding",
        title: "Rounding in (4) at 1 mm/s",
        equations: &[4, 5, 6],
        run: || checks(rows()),
    },
    rows,
    found: "\
At first a fibre that is hit slowly is strained in second order: its first element is turned by Vt/Δx, and
the rest follows along the fibre. To that order the scheme at α = 1 has a closed form, ε_i = (V/c)² (t − i − ½)
after t steps for elements i < t: the turned element adds ½(Vt/cΔt)² to its strain, its free end gives way
at the speed of sound, and on the uniform fibre the scheme carries a wave without change. At 1 mm/s a step
adds 2e-14, a hundred units of the last digit of L^t/L^(t−1); and far from the impact point, where positions are
large, it is as much as their last digit. Engineering strain, L/L⁰ − 1, fares no better. The same increment
as (2d·Δ + Δ·Δ)/[(L^t + L^(t−1)) L^(t−1)], with d the element before and Δ what the step adds to it by its
velocities, keeps its digits. Below about 0.1 mm/s on this scene the printed form has none left: the run
completes, and what it shows is rounding.",
};

/// Steps: so few that terms of higher order are nothing, so many that the wave is far.
const STEPS: u64 = 100;

/// The paper's fibre, struck slowly; α = 1.
fn slow(velocity: f64, strain: Strain) -> Scene {
    let mut scene = measured_by(strain, shipped("single-400"));
    scene.projectile.velocity = velocity;
    scene
}

/// ε_i/[(V/c)² (t − i − ½)] − 1 of the elements that the wave has long passed.
fn errors(scene: &Scene, strain: &[f64]) -> Vec<f64> {
    let mach = scene.projectile.velocity / exact_primary(scene).wave_speed();
    let passed = strain[..STEPS as usize - 5].iter().enumerate();
    passed.map(|(i, e)| e / (mach * mach * ((STEPS as f64 - 0.5) - i as f64)) - 1.0).collect()
}

/// Root mean square of errors.
fn size(errors: &[f64]) -> f64 {
    let sum = errors.iter().fold(0.0, |sum, error| sum + error * error);
    (sum / errors.len() as f64).sqrt()
}

/// The fibre struck at a velocity, by the page: how the run ends, and its errors.
fn printed(velocity: f64, measure: Strain) -> (String, Vec<f64>) {
    let scene = slow(velocity, measure);
    let result = run(&scene);
    assert_eq!(result.steps, STEPS);
    (result.outcome.to_string(), errors(&scene, &result.primary.strain))
}

/// By what: the errors of the elements, from the impact point on.
pub fn drawn() -> Vec<(&'static str, Vec<f64>)> {
    let printed = |velocity, measure| printed(velocity, measure).1;
    let scene = slow(1e-3, Strain::Incremental);
    let (_, rewritten) = strain::<f64>(&scene, &Rewritten::default());
    vec![
        ("10 µm/s, (4) as printed", printed(1e-5, Strain::Incremental)),
        ("1 mm/s, (4) as printed", printed(1e-3, Strain::Incremental)),
        ("1 mm/s, engineering strain", printed(1e-3, Strain::Engineering)),
        ("1 cm/s, (4) as printed", printed(1e-2, Strain::Incremental)),
        ("1 mm/s, (4) rewritten", errors(&scene, &rewritten)),
    ]
}

/// The page with (4) rewritten: L^t − L^(t−1) from what the step adds to the element.
#[derive(Default)]
struct Rewritten {
    /// (L^t)² − (L^(t−1))² of the element under way, from (6) to (4).
    growth: Cell<f64>,
}

impl Paper<f64> for Rewritten {
    fn eqn_6_length<const D: usize>(
        &self,
        position_ahead: Vector<f64, D>,
        velocity_ahead: Vector<f64, D>,
        position_here: Vector<f64, D>,
        velocity_here: Vector<f64, D>,
        time_step: f64,
    ) -> f64 {
        let before = position_ahead - position_here;
        let added = (velocity_ahead - velocity_here) * time_step;
        self.growth.set(2.0 * before.dot(&added) + added.dot(&added));
        Printed.eqn_6_length(
            position_ahead,
            velocity_ahead,
            position_here,
            velocity_here,
            time_step,
        )
    }

    fn eqn_4_strain(&self, previous_strain: f64, length: Lengths<f64>) -> f64 {
        previous_strain + self.growth.get() / ((length.now + length.previous) * length.previous)
    }
}

/// The strain after [`STEPS`] steps, by an edition of the page and with a number's digits.
fn strain<S: Number>(scene: &Scene, paper: &impl Paper<S>) -> (String, Vec<f64>) {
    let mut state = at_impact::<S>(scene, Wavefront::Flagged);
    let outcome = march::run(paper, &mut state, STEPS, |_| {});
    (outcome.to_string(), state.primary.strain.iter().map(|e| e.to_f64()).collect())
}

/// Greatest relative difference of two strains over the elements that the wave has long passed.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let passed = a.iter().zip(b).take(STEPS as usize - 5);
    passed.map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, worse)
}

fn rows() -> Vec<Row> {
    const CLOSED_FORM: &str = "ε_i = (V/c)² (t − i − ½), exact in second order";
    const NORM: &str = "root mean square of the relative error, elements 0 to 94 after 100 steps";
    let line = |what: &str, claim: &str, says: String, error, bound, reason: &str| {
        row(what, claim, says, CLOSED_FORM, NORM, error, bound, reason)
    };
    let scene = slow(1e-3, Strain::Incremental);
    let (rewritten_says, rewritten) = strain::<f64>(&scene, &Rewritten::default());
    let (long_says, long) =
        strain::<DoubleDouble>(&scene, &edition(Strain::Incremental, Corrections::NONE));
    let (says, as_printed) = printed(1e-3, Strain::Incremental);
    let (says_engineering, engineering) = printed(1e-3, Strain::Engineering);
    let (says_faster, faster) = printed(1e-2, Strain::Incremental);
    let (says_gone, gone) = printed(1e-5, Strain::Incremental);
    vec![
        line(
            "1 mm/s, (4) as printed",
            "(4) loses digits",
            says,
            size(&as_printed),
            Bound::Within(0.02, 0.15),
            "half a unit of L/L, 1.1e-16, and of positions of up to 0.2 m, in each step of 2e-14",
        ),
        line(
            "1 mm/s, engineering strain",
            "So does L/L⁰ − 1",
            says_engineering,
            size(&engineering),
            Bound::Within(0.02, 0.15),
            "the same",
        ),
        line(
            "1 mm/s, (4) rewritten",
            "An algebraically equal form does not",
            rewritten_says.clone(),
            size(&errors(&scene, &rewritten)),
            Bound::AtMost(2e-8),
            "terms of the next order: the tension, 2e-12 of the modulus, pulls the second node along",
        ),
        line(
            "1 mm/s, (4) as printed in double-double",
            "Nor does (4) itself with 32 digits",
            long_says,
            size(&errors(&scene, &long)),
            Bound::AtMost(2e-8),
            "the same",
        ),
        row(
            "1 mm/s, (4) rewritten",
            "It has the digits that a double has",
            rewritten_says.clone(),
            "(4) as printed in double-double",
            "greatest relative difference, elements 0 to 94 after 100 steps",
            apart(&rewritten, &long),
            Bound::AtMost(5e-14),
            "rounding of a hundred steps",
        ),
        line(
            "1 cm/s, (4) as printed",
            "Ten times as fast it has two digits more",
            says_faster,
            size(&faster),
            Bound::AtMost(3e-3),
            "the increments are a hundred times as large",
        ),
        line(
            "10 µm/s, (4) as printed",
            "A hundred times slower none is left, and nothing says so",
            says_gone,
            size(&gone),
            Bound::AtLeast(50.0),
            "a step adds 2e-18, which no L/L can show: found, not mended",
        ),
    ]
}
