//! Velocities from 0.1 m/s to one and a half wave speeds, strains beyond 100 %.

use crossfibre::result::MOST_IMBALANCE;
use crossfibre::scene::{Scene, Strain};

use super::{Group, Row, checks, row, run, tally};
use crate::cases::support::{exact_primary, exact_single, mean, measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::closed_form::component;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.velocity",
        title: "Impact from 0.1 m/s to 1.5 c, strains beyond 100 %",
        equations: &[2, 4, 5, 6, 7],
        run: || checks(rows()),
    },
    rows,
    found: "\
With engineering strain the plateau is Smith's at every velocity, to 114 % of strain. With (4) it is not:
what (4) adds for a front of one step is not what it adds for a slow one (ledger `strain-path`), and from
about half the wave speed on the run becomes unstable, the sooner the finer the mesh. Such a run may stop
before its energy has grown beyond bounds. A run has completed only if its balance is off by less than 10 %:
engineering strain keeps well clear of that even on two elements, and (4) reaches it where its strain is wrong
by as much.",
};

const SMITH: &str = "Smith's relation for the law that the equations amount to";

/// One fibre, until the front has nearly reached the clamp; α = 1.
fn impact(velocity: f64, elements: usize, strain: Strain) -> Scene {
    let mut scene = measured_by(strain, shipped("single-400"));
    scene.primary.elements = elements;
    scene.projectile.velocity = velocity;
    scene.duration = 0.29 / exact_primary(&scene).wave_speed();
    scene
}

/// Mean strain over the middle half between kink and front, over Smith's, less 1.
fn departure(scene: &Scene, strain: &[f64]) -> f64 {
    let smith = exact_single(scene);
    let kink = smith.kink_speed_lagrangian * scene.duration;
    let way = smith.tail_speed * scene.duration - kink;
    let spacing = scene.primary.length / scene.primary.elements as f64;
    let found = mean(spacing, strain, kink + 0.25 * way, kink + 0.75 * way);
    (found / component(scene, smith.strain) - 1.0).abs()
}

fn rows() -> Vec<Row> {
    let c = exact_primary(&shipped("single-400")).wave_speed();
    let plateau = |what: &str, velocity, elements, strain, bound, reason: &str| {
        let scene = impact(velocity, elements, strain);
        let result = run(&scene);
        let error = departure(&scene, &result.primary.strain);
        row(
            what,
            "The plateau is Smith's",
            result.outcome.to_string(),
            SMITH,
            "relative error of the mean over the middle half between kink and front",
            error,
            bound,
            reason,
        )
    };
    use Strain::{Engineering, Incremental};
    vec![
        plateau(
            "0.1 m/s, 12000 elements, (4)",
            0.1,
            12000,
            Incremental,
            Bound::AtMost(2.5e-2),
            "the kink has passed five elements only, and is not yet itself",
        ),
        plateau(
            "c, engineering strain (68 %)",
            c,
            600,
            Engineering,
            Bound::AtMost(5e-4),
            "oscillations behind the front",
        ),
        plateau(
            "1.4 c, engineering strain (104 %)",
            1.4 * c,
            600,
            Engineering,
            Bound::AtMost(1e-3),
            "the same",
        ),
        plateau(
            "1.5 c, engineering strain (114 %)",
            1.5 * c,
            600,
            Engineering,
            Bound::AtMost(3e-4),
            "the same",
        ),
        plateau(
            "c/2, 600 elements, (4)",
            0.5 * c,
            600,
            Incremental,
            Bound::AtMost(0.1),
            "path error of (4): the limit of what it can be used for",
        ),
        beyond(c),
        coarse(c),
    ]
}

/// (4) at and beyond the velocities where it runs away.
fn beyond(c: f64) -> Row {
    let mut outcomes = Vec::new();
    let mut worst = 0.0_f64;
    for elements in [20, 150, 600, 2400] {
        for velocity in [0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.4, 1.5] {
            let scene = impact(velocity * c, elements, Strain::Incremental);
            let result = run(&scene);
            if result.outcome.is_completed() {
                worst = worse(worst, departure(&scene, &result.primary.strain));
            }
            outcomes.push(result.outcome);
        }
    }
    row(
        "0.4 to 1.5 c, 20 to 2400 elements, (4)",
        "A run that says completed is not far off",
        tally(&outcomes),
        SMITH,
        "greatest relative error of the plateau in the runs that completed",
        worst,
        Bound::AtMost(0.15),
        "the balance shows an error of the strain of about its own size; its limit is 10 %",
    )
}

/// Engineering strain where it is coarsest: what the limit of the energy balance must let pass.
fn coarse(c: f64) -> Row {
    let mut outcomes = Vec::new();
    let mut worst = 0.0_f64;
    for elements in [2, 3, 5, 10] {
        for velocity in [0.1, 0.3, 0.5, 0.8, 1.1, 1.5] {
            for passages in [0.9, 3.0] {
                let mut scene = impact(velocity * c, elements, Strain::Engineering);
                scene.duration = passages * 0.3 / c;
                let result = run(&scene);
                let balance = result.balance.map_or(f64::NAN, |b| b.energy.relative_residual());
                worst = worse(worst, balance.abs());
                outcomes.push(result.outcome);
            }
        }
    }
    row(
        "0.1 to 1.5 c, 2 to 10 elements, engineering strain",
        "No run is called unbalanced for being coarse",
        tally(&outcomes),
        "first law",
        "greatest residual over the energy put in",
        worst,
        Bound::AtMost(MOST_IMBALANCE),
        "the limit of the outcome: fronts of one element on a mesh of a few",
    )
}
