//! A projectile of finite mass, eqn (8).

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Law, Scene};
use crossfibre::state::FibreState;

use super::support::{check, marched, order, refined, relative, shipped};
use super::{Bound, Case, Check};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "projectile.momentum",
        title: "What the projectile loses the fibre gains",
        equations: &[2, 8],
        run: momentum,
    },
    Case {
        id: "projectile.limits",
        title: "Heavy projectiles, and (8) as printed",
        equations: &[8],
        run: limits,
    },
    Case {
        id: "projectile.two-fibres",
        title: "A projectile that strikes two fibres at once is slowed by both",
        equations: &[2, 8, 14],
        run: two_fibres,
    },
];

fn momentum() -> Vec<Check> {
    let residual = |corrections, factor| {
        let scene = refined(Scene { corrections, ..shipped("finite-projectile") }, factor);
        let momentum = marched(scene).balance.momentum;
        (momentum.residual / momentum.initial).abs()
    };
    let all = Corrections::ALL;
    let without = all.without(Erratum::ProjectileInertia);
    let (coarse, fine) = (residual(without, 1), residual(without, 8));
    vec![
        check(
            "With the node's mass on the projectile momentum is conserved",
            "momentum before impact, and the impulse of the clamps",
            "residual over the momentum at impact, 80 µs, front reflected at the clamp",
            residual(all, 1),
            Bound::AtMost(2e-15),
            "rounding: a sum over 300 steps and 150 nodes",
        ),
        check(
            "Without it, as printed, it is not",
            "the same",
            "residual over the momentum at impact, 2 mm",
            coarse,
            Bound::AtLeast(4e-4),
            "Δm/m_p = 0.35 % of the 18 % of velocity lost",
        ),
        check(
            "and what is missing is of the order of the element",
            "Δm ∝ Δx",
            "observed order from 2 mm to 0.25 mm",
            order(coarse, fine, 8.0),
            Bound::Within(0.9, 1.1),
            "the charge is exactly Δm times the velocity lost",
        ),
    ]
}

fn limits() -> Vec<Check> {
    let heavy = {
        let mut scene = shipped("single-400");
        scene.projectile.mass = Some(1e6);
        marched(scene)
    };
    let constant = marched(shipped("single-400"));
    let worst = heavy
        .state
        .primary
        .strain
        .iter()
        .zip(&constant.state.primary.strain)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, worse);
    let corrected = marched(shipped("finite-projectile"));
    let lost = 1.0 - corrected.state.projectile.velocity / 400.0;
    let wrong_sign = Scene {
        corrections: Corrections::ALL.without(Erratum::ProjectileSign),
        ..shipped("finite-projectile")
    };
    let gained = marched(wrong_sign).state.projectile.velocity / 400.0 - 1.0;
    let as_printed = Scene { corrections: Corrections::NONE, ..shipped("finite-projectile") };
    let result = crate::planted::run(&as_printed, |_| {});
    let energy = corrected.balance.energy;
    let kinetic = energy.projectile / energy.initial;
    vec![
        check(
            "A projectile of 10⁶ kg keeps its velocity",
            "the run with constant velocity",
            "greatest difference of strain",
            worst,
            Bound::AtMost(1e-11),
            "impulse of 28.7 µs over 10⁶ kg slows it by 1e-8 m/s: 3e-11 of the strain's 1.4 %",
        ),
        check(
            "A projectile as heavy as the fibre slows down",
            "energy: what it has left of its kinetic energy is its velocity squared",
            "relative difference of (v/v₀)² and the energy left to it",
            relative(kinetic, (1.0 - lost) * (1.0 - lost)),
            Bound::AtMost(2e-2),
            "Δm/m_p of node mass counted with the fibre, and half a step between the velocities",
        ),
        check(
            "With the printed sign it gains velocity instead",
            "a fibre that trails can only pull back",
            "relative gain of velocity",
            gained,
            Bound::AtLeast(0.1),
            "−2T_y with T_y < 0",
        ),
        check(
            "With sign and interval as printed it runs away, and the run says so",
            "typed outcome",
            "1 if the outcome is anything but completed",
            f64::from(u8::from(result.outcome != Outcome::Completed)),
            Bound::Exactly(1.0),
            "the impulse of the whole time since impact in every step",
        ),
    ]
}

/// What the nodes of a fibre beyond the first have of momentum along y, both halves, kg m/s.
fn momentum_of<const D: usize>(fibre: &FibreState<f64, D>) -> f64 {
    let along_y: f64 = fibre.velocity[1..].iter().map(|v| v[1]).sum();
    2.0 * fibre.properties.mass * along_y
}

fn two_fibres() -> Vec<Check> {
    let mass = 0.0007;
    let struck = |mass| {
        let mut scene = shipped("both-at-origin");
        scene.projectile.mass = Some(mass);
        scene
    };
    let of_pair = marched(struck(2.0 * mass)).state.projectile.velocity;
    let of_one = {
        let mut scene = struck(mass);
        scene.secondary = None;
        marched(scene).state.projectile.velocity
    };
    let mut unequal = struck(mass);
    if let Some(fibre) = &mut unequal.secondary {
        (fibre.density, fibre.area) = (1443.7, 1.37e-6);
        fibre.material = Law::Linear { modulus: 91.3e9 }.into();
    }
    let initial = unequal.projectile.velocity;
    let state = marched(unequal).state;
    let secondary = &state.crossover.as_ref().expect("both fibres").fibre;
    let first_node = state.primary.properties.mass + secondary.properties.mass;
    // The first node's velocity is the projectile's of half a step ago, as that of every node.
    let along_y = (mass + first_node) * state.primary.velocity[0].y
        + momentum_of(&state.primary)
        + momentum_of(secondary);
    vec![
        check(
            "Two equal fibres slow a projectile as one of them slows one of half the mass",
            "symmetry: each half of the projectile has a fibre for itself",
            "relative difference of the velocities after 28.7 µs",
            relative(of_pair, of_one),
            Bound::Exactly(0.0),
            "masses and tensions are doubled, which no rounding sees",
        ),
        check(
            "What it loses two unequal fibres gain",
            "momentum at impact: that of projectile and first nodes",
            "relative difference of the momentum, summed over the nodes after 28.7 µs",
            relative(along_y, (mass + first_node) * initial),
            Bound::AtMost(4e-15),
            "rounding: a sum over 300 nodes; no wave has come to a clamp",
        ),
    ]
}
