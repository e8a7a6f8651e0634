//! A million steps, with waves that go back and forth between the clamps.

use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Strain};

use super::{Group, Row, checks, row};
use crate::cases::support::{measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::planted;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.long",
        title: "A million steps: drift of energy and momentum",
        equations: &[2, 4, 6, 7, 8, 17, 18],
        run: || checks(rows()),
    },
    rows,
    found: "\
A light projectile on a clamped fibre swings to and fro for as long as one likes, and every wave comes back
thousands of times. Momentum closes to rounding after a million steps. Energy stays at the level that the
fronts of the first passages give it, as long as no element goes slack; where some do, at ten times the
velocity, it rises tenfold, but slowly. (4) winds strain up at every swing: its energy grows in proportion
to the number of steps until the run is called unbalanced.",
};

const STEPS: u64 = 1_000_000;

/// A million steps, and the worst imbalance of their first and last tenths.
struct Long {
    result: RunResult,
    energy: [f64; 2],
    momentum: f64,
}

/// The tenth that a step is looked at for, the first or the last; every thousandth step is looked at.
fn part(step: u64) -> Option<usize> {
    let tenth = STEPS / 10;
    match step {
        step if step % 1000 > 0 => None,
        step if step <= tenth => Some(0),
        step if step > STEPS - tenth => Some(1),
        _ => None,
    }
}

fn long(mut scene: Scene) -> Long {
    scene.duration = STEPS as f64 * Discretisation::<f64>::of(&scene).time_step;
    let (mut energy, mut momentum) = ([0.0_f64; 2], 0.0_f64);
    let result = planted::run(&scene, |state| {
        let Some(part) = part(state.step) else { return };
        let balance = match scene.strain {
            Strain::Engineering => {
                state.balance(&Corrected::<Engineering>::new(Corrections::ALL), scene.strain)
            }
            Strain::Incremental => {
                state.balance(&Corrected::<Incremental>::new(Corrections::ALL), scene.strain)
            }
        };
        energy[part] = worse(energy[part], balance.energy.relative_residual().abs());
        momentum = worse(momentum, (balance.momentum.residual / balance.momentum.initial).abs());
    });
    assert_eq!(result.steps, STEPS);
    Long { result, energy, momentum }
}

/// Twelve elements and a projectile about as heavy.
fn swinging(velocity: f64, strain: Strain) -> Scene {
    let mut scene = measured_by(strain, shipped("finite-projectile"));
    scene.primary.elements = 12;
    (scene.projectile.velocity, scene.courant) = (velocity, 0.5);
    scene
}

/// Two different fibres that do not slide.
fn crossed() -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("unequal"));
    scene.primary.elements = 13;
    (scene.projectile.velocity, scene.courant) = (1.0, 0.9);
    if let Some(secondary) = &mut scene.secondary {
        (secondary.elements, secondary.slide_factor) = (9, 1.0);
    }
    scene
}

fn rows() -> Vec<Row> {
    const FIRST_LAW: &str = "first law";
    const RESIDUAL: &str = "greatest residual over the energy put in, of the last 100 000 steps";
    const DRIFT: &str = "greatest residual of the last 100 000 steps over that of the first";
    const SECOND_LAW: &str = "second law for the whole system";
    const MOMENTUM: &str = "greatest residual over the momentum at impact";
    let single = long(swinging(10.0, Strain::Engineering));
    let both = long(crossed());
    let faster = long(swinging(100.0, Strain::Engineering));
    let path = long(swinging(10.0, Strain::Incremental));
    let path_faster = long(swinging(100.0, Strain::Incremental));
    let line = |what: &str, of: &Long, claim: &str, oracle, norm, measured, bound, reason| {
        row(what, claim, of.result.outcome.to_string(), oracle, norm, measured, bound, reason)
    };
    let drift = |of: &Long| of.energy[1] / of.energy[0];
    vec![
        line(
            "one fibre, 10 m/s, engineering strain",
            &single,
            "Energy is kept",
            FIRST_LAW,
            RESIDUAL,
            single.energy[1],
            Bound::AtMost(3e-5),
            "fronts of one element, and the mean of two velocities",
        ),
        line(
            "one fibre, 10 m/s, engineering strain",
            &single,
            "and does not drift",
            FIRST_LAW,
            DRIFT,
            drift(&single),
            Bound::Within(0.5, 2.0),
            "no trend",
        ),
        line(
            "one fibre, 10 m/s, engineering strain",
            &single,
            "Momentum is kept",
            SECOND_LAW,
            MOMENTUM,
            single.momentum,
            Bound::AtMost(5e-13),
            "rounding of a million impulses of the clamps",
        ),
        line(
            "two crossed fibres, 1 m/s, engineering strain",
            &both,
            "Energy is kept",
            FIRST_LAW,
            RESIDUAL,
            both.energy[1],
            Bound::AtMost(4e-5),
            "as for one fibre",
        ),
        line(
            "two crossed fibres, 1 m/s, engineering strain",
            &both,
            "Momentum is kept",
            SECOND_LAW,
            MOMENTUM,
            both.momentum,
            Bound::AtMost(5e-13),
            "rounding",
        ),
        line(
            "one fibre, 100 m/s, engineering strain: elements go slack",
            &faster,
            "Energy drifts, but slowly",
            FIRST_LAW,
            RESIDUAL,
            faster.energy[1],
            Bound::AtMost(4e-2),
            "a compressed element buckles, and a fold of one element is not resolved by any mesh",
        ),
        line(
            "one fibre, 10 m/s, (4)",
            &path,
            "(4) winds strain up in proportion to the steps",
            FIRST_LAW,
            DRIFT,
            drift(&path),
            Bound::Within(8.0, 16.0),
            "the last tenth over the first: 10 to 19/1 in the mean of a straight line",
        ),
        line(
            "one fibre, 100 m/s, (4)",
            &path_faster,
            "and ends as a typed outcome",
            "typed outcome",
            "1 if unbalanced",
            f64::from(u8::from(!path_faster.result.outcome.is_completed())),
            Bound::Exactly(1.0),
            "ledger strain-path",
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_thousandth_step_of_the_first_and_the_last_hundred_thousand_is_looked_at() {
        let found = [1000, 100_000, 101_000, 900_000, 901_000, 1_000_000].map(part);
        assert_eq!(found, [Some(0), Some(0), None, None, Some(1), Some(1)]);
        assert_eq!((1..=STEPS).filter(|&step| part(step).is_some()).count(), 200);
    }
}
