//! Energy and momentum of the whole system.

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::paper::{Paper, magnitude};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::Wavefront;

use super::support::{check, kinked, marched, measured_by, order, refined, shipped, sliding_by};
use super::{Bound, Case, Check};
use crate::planted::{self, march};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "energy.engineering",
        title: "Energy balance with engineering strain, and its order",
        equations: &[2, 6, 7, 17, 18],
        run: engineering,
    },
    Case {
        id: "energy.incremental",
        title: "Energy balance with the strain of (4)",
        equations: &[2, 4, 5, 6, 7, 17, 18],
        run: incremental,
    },
    Case {
        id: "energy.kink",
        title: "Energy and momentum when the kink has passed the crossover",
        equations: &[9, 10, 11, 12, 13, 15, 16, 17, 18],
        run: kink,
    },
    Case {
        id: "energy.printed",
        title: "The printed coupling makes energy",
        equations: &[16, 17, 18],
        run: printed,
    },
    Case {
        id: "momentum.fig3",
        title: "Momentum balance of Fig. 3, and (1) at every node",
        equations: &[1, 2, 17, 18],
        run: momentum,
    },
];

const ENERGY: &str = "first law: kinetic + stored = at impact + work of the driven node";
const NORM: &str = "residual over the energy in the fibres";

fn residual(scene: Scene, factor: usize) -> f64 {
    let energy = marched(refined(scene, factor)).balance.energy;
    energy.residual / (energy.kinetic + energy.stored)
}

fn engineering() -> Vec<Check> {
    ["single-400", "fig3", "unequal"]
        .into_iter()
        .flat_map(|name| {
            let scene = || measured_by(Strain::Engineering, shipped(name));
            let [coarse, fine] = [1, 16].map(|factor| residual(scene(), factor));
            [
                check(
                    format!("{name}: energy is conserved"),
                    ENERGY,
                    NORM,
                    coarse.abs(),
                    Bound::AtMost(if name == "unequal" { 1e-4 } else { 2e-4 }),
                    "a front of one element, and the mean of two velocities at a jump: O(Δx/ct)",
                ),
                check(
                    format!("{name}: the residual vanishes with the element"),
                    ENERGY,
                    "observed order over a factor of 16",
                    order(coarse, fine, 16.0),
                    Bound::Within(0.8, 1.2),
                    "the number of elements in a front is constant: order one",
                ),
            ]
        })
        .collect()
}

fn incremental() -> Vec<Check> {
    ["single-400", "fig3", "unequal", "finite-projectile"]
        .into_iter()
        .flat_map(|name| {
            let [coarse, fine] = [1, 16].map(|factor| residual(shipped(name), factor));
            [
                check(
                    format!("{name}: energy is conserved but for the path error of (4)"),
                    ENERGY,
                    NORM,
                    coarse.abs(),
                    Bound::AtMost(1e-3),
                    "(4) is not a function of the length: ε oscillates around ln(L/L⁰) by up to \
                     ε²/2 at a front of one step, and the stored energy with it",
                ),
                check(
                    format!("{name}: the path error closes slowly if at all"),
                    ENERGY,
                    "observed order over a factor of 16",
                    order(coarse, fine, 16.0),
                    Bound::Within(-0.2, 0.8),
                    "expected between 0 and about 1/3: the steps in which a front rises grow as \
                     Δx^(-1/3)",
                ),
            ]
        })
        .collect()
}

fn kink() -> Vec<Check> {
    let engineering = || measured_by(Strain::Engineering, kinked());
    let [coarse, fine] = [1, 16].map(|factor| residual(engineering(), factor));
    let without = |erratum| {
        let corrections = Corrections::ALL.without(erratum);
        residual(Scene { corrections, ..engineering() }, 1).abs()
    };
    let momentum = |slide_factor| {
        let momentum = marched(sliding_by(slide_factor, refined(kinked(), 4))).balance.momentum;
        (momentum.residual / momentum.drive).abs()
    };
    vec![
        check(
            "Energy is conserved while the crossover is swept sideways",
            ENERGY,
            NORM,
            coarse.abs(),
            Bound::AtMost(5e-4),
            "fronts of one element, as without the kink",
        ),
        check(
            "The residual vanishes with the element",
            ENERGY,
            "observed order over a factor of 16",
            order(coarse, fine, 16.0),
            Bound::Within(0.8, 1.2),
            "the number of elements in a front is constant: order one",
        ),
        check(
            "So is momentum",
            "second law for the whole system",
            "residual over the impulse of the drive, 0.5 mm",
            momentum(1.0),
            Bound::AtMost(2e-15),
            "rounding: (2), (17) and (18) telescope over both fibres at α_s = 1",
        ),
        check(
            "At α_s = 0.73 momentum is not conserved once the fibre is turned, in any edition",
            "second law for the whole system",
            "residual over the impulse of the drive, 0.5 mm",
            momentum(0.73),
            Bound::AtLeast(1e-2),
            "ledger slide-frame: of the pull along the primary (1 - α_s) T2_para is taken from one \
             fibre and not given to the other",
        ),
        check(
            "With the sign of (17) as printed energy is not conserved",
            ENERGY,
            NORM,
            without(Erratum::PerpendicularSign),
            Bound::AtLeast(1e-2),
            "the normal force acts along x the wrong way",
        ),
        check(
            "Nor with (16) as printed",
            ENERGY,
            NORM,
            without(Erratum::PerpendicularResolution),
            Bound::AtLeast(5e-2),
            "the normal force is not the normal component",
        ),
    ]
}

fn printed() -> Vec<Check> {
    let scene = || shipped("fig3-printed");
    let [coarse, fine] = [1, 16].map(|factor| residual(scene(), factor));
    vec![
        check(
            "Fig. 3 as printed gains energy",
            ENERGY,
            NORM,
            coarse,
            Bound::AtLeast(1e-2),
            "the normal force of (16) does work on a node that should not move sideways",
        ),
        check(
            "and goes on gaining it on any mesh",
            ENERGY,
            "observed order over a factor of 16",
            order(coarse, fine, 16.0),
            Bound::Within(-0.2, 0.1),
            "an error of the equations, not of the mesh: order zero",
        ),
    ]
}

fn momentum() -> Vec<Check> {
    let residual = |corrections| {
        let momentum = marched(Scene { corrections, ..shipped("fig3") }).balance.momentum;
        (momentum.residual / momentum.drive).abs()
    };
    vec![
        check(
            "Fig. 3: the fibres' momentum is the impulse put in",
            "second law for the whole system",
            "residual over the impulse of the drive",
            residual(Corrections::ALL),
            Bound::AtMost(1e-15),
            "rounding: (2) telescopes; sums of 100 steps and 250 nodes",
        ),
        check(
            "As printed it is not",
            "the same",
            "residual over the impulse of the drive",
            residual(Corrections::NONE),
            Bound::AtLeast(5e-2),
            "the printed normal force comes from nowhere",
        ),
        check(
            "(1) closes at every inner node of every step",
            "(1), of which the march uses the solved form (2)",
            "greatest residual over the greatest tension",
            impulse_audit(),
            Bound::AtMost(1e-15),
            "rounding: (Δm/Δt)(v - v') takes back what (2) multiplied out",
        ),
    ]
}

/// Greatest residual of (1) over a run of one fibre, in units of the greatest tension.
fn impulse_audit() -> f64 {
    let scene = shipped("single-400");
    let paper = planted::edition(scene.strain, scene.corrections);
    let mut state = planted::at_impact::<f64>(&scene, Wavefront::Flagged);
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    let mut before = state.primary.clone();
    march::run(&paper, &mut state, 100, |state| {
        let now = &state.primary;
        let mass_over_time_step = now.properties.mass / state.time_step;
        for i in 1..now.elements() {
            let residual = paper.eqn_1_impulse_residual(
                before.pull[i],
                before.pull[i - 1],
                mass_over_time_step,
                now.velocity[i],
                before.velocity[i],
            );
            worst = worse(worst, magnitude(residual));
            largest = largest.max(magnitude(before.pull[i]));
        }
        before.clone_from(now);
    });
    worst / largest
}
