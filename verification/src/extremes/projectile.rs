//! Projectiles lighter than a node, heavier than ten million, and thrown back.

use crossfibre::scene::{Scene, Strain};

use super::{Group, Row, checks, row, run};
use crate::cases::support::{exact_primary, measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::planted;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.projectile",
        title: "Projectiles from a billionth of a node to ten million nodes, and thrown back",
        equations: &[8],
        run: || checks(rows()),
    },
    rows,
    found: "\
With the node's mass on the projectile (ledger `projectile-inertia`) nothing happens as its own mass goes to
nothing: the node that it struck is left. A heavy one is slowed by the impulse that a projectile of constant
velocity would need, and thrown back at the velocity at which it came, less what it leaves to the fibre. Beside
the energy of a heavy projectile that of the fibres is nothing, and so is what may be wrong with it: the fibres
have a balance of their own.",
};

/// The paper's fibre, engineering strain, struck by so many nodes' mass.
fn struck(nodes: f64, duration: f64) -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("finite-projectile"));
    let fibre = &scene.primary;
    let node = fibre.density * fibre.area * fibre.length / fibre.elements as f64;
    scene.projectile.mass = Some(nodes * node);
    Scene { duration, ..scene }
}

fn light() -> Vec<Row> {
    let [lightest, light] = [1e-9, 1e-6].map(|nodes| run(&struck(nodes, 28.7e-6)));
    let velocities = lightest.primary.velocity.iter().flatten();
    let pairs = velocities.zip(light.primary.velocity.iter().flatten());
    let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, worse);
    let momentum = lightest.balance.map_or(f64::NAN, |b| b.momentum.residual / b.momentum.initial);
    let says = lightest.outcome.to_string();
    vec![
        row(
            "a billionth of a node",
            "Momentum is kept",
            says.clone(),
            "second law for the whole system",
            "residual over the momentum at impact",
            momentum.abs(),
            Bound::AtMost(3e-15),
            "rounding",
        ),
        row(
            "a billionth of a node",
            "It does as one of a millionth: there is a limit without mass",
            says,
            "(8) is regular in m_p → 0 once it carries the node",
            "greatest difference of a velocity, over 400 m/s, over 1e-6",
            apart / 400.0 / 1e-6,
            Bound::AtMost(1.0),
            "in proportion to the mass",
        ),
    ]
}

fn heavy() -> Row {
    let nodes = 1e7;
    let slowed = run(&struck(nodes, 28.7e-6));
    let mut kept = struck(nodes, 28.7e-6);
    let mass = kept.projectile.mass.take().unwrap_or(f64::NAN);
    let impulse = run(&kept).balance.map_or(f64::NAN, |b| b.momentum.drive);
    // The velocity of the last step; the projectile has already been slowed for the next.
    let lost = mass * (400.0 - slowed.primary.velocity[0][1]);
    row(
        "ten million nodes",
        "It is slowed by the impulse that the fibre takes at constant velocity",
        slowed.outcome.to_string(),
        "the impulse of the drive of the run without a mass",
        "relative difference of the momentum lost",
        (lost / impulse.abs() - 1.0).abs(),
        Bound::AtMost(1e-5),
        "400 m/s less 9e-4 m/s: the second order is 2e-6",
    )
}

/// (4) beyond its velocities, pushed by a projectile that keeps nearly all the energy there is.
fn unstable() -> Row {
    let mut scene = measured_by(Strain::Incremental, struck(1e7, 0.0));
    let wave_speed = exact_primary(&scene).wave_speed();
    scene.projectile.velocity = 1.4 * wave_speed;
    scene.duration = 0.29 / wave_speed;
    let result = run(&scene);
    row(
        "ten million nodes at 1.4 c, (4)",
        "What is wrong with the fibre does not hide behind the projectile's energy",
        result.outcome.to_string(),
        "the same run at constant velocity, where the balance is off by 0.23",
        "1 if unbalanced",
        f64::from(u8::from(!result.outcome.is_completed())),
        Bound::Exactly(1.0),
        "the fibres' own balance is drawn beside the whole one, which is off by 2e-8",
    )
}

fn thrown_back() -> Vec<Row> {
    // 0.24 kg: 660 times the fibre's two halves.
    let mut scene = struck(1e5, 4.5e-3);
    scene.courant = 0.9;
    let mass = scene.projectile.mass.unwrap_or(f64::NAN);
    let (mut top, mut back) = (0.0_f64, 0.0);
    let result = planted::run(&scene, |state| {
        let height = state.primary.position[0].y;
        top = top.max(height);
        if height < 0.0 && back == 0.0 {
            back = state.projectile.velocity;
        }
    });
    let (velocity, length) = (scene.projectile.velocity, scene.primary.length);
    let stiffness = scene.primary.material.instantaneous_modulus() * scene.primary.area;
    // ½ m V² = 2 · ½ EA L (λ − 1)², y² = L² (λ² − 1).
    let stretch = 1.0 + (0.5 * mass * velocity * velocity / (stiffness * length)).sqrt();
    let turning = length * (stretch * stretch - 1.0).sqrt();
    let says = result.outcome.to_string();
    let oracle = "energy of a weight between two springs without mass";
    let reason = "the fibre has 1/330 of the projectile's mass, and waves of its own";
    vec![
        row(
            "a hundred thousand nodes (0.24 kg), thrown back",
            "It turns where the fibre has taken all its energy",
            says.clone(),
            oracle,
            "relative difference of the greatest way",
            (top / turning - 1.0).abs(),
            Bound::AtMost(5e-3),
            reason,
        ),
        row(
            "a hundred thousand nodes (0.24 kg), thrown back",
            "and comes back as fast as it came",
            says,
            oracle,
            "relative difference of the velocity when the fibre is straight again",
            (back / velocity + 1.0).abs(),
            Bound::AtMost(5e-3),
            reason,
        ),
    ]
}

fn rows() -> Vec<Row> {
    [light(), vec![heavy(), unstable()], thrown_back()].into_iter().flatten().collect()
}
