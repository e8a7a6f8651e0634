//! A projectile of finite mass, eqn (8).

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::outcome::Outcome;
use crossfibre::scene::Scene;

use super::support::{check, marched, order, refined, relative, shipped};
use super::{Bound, Case, Check};

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
        .fold(0.0, f64::max);
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
