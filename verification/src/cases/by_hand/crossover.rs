//! (8) to (18). The working: docs/exact/by-hand.md.

use crossfibre::number::Vector;
use crossfibre::paper::{Cosines, CrossoverPush, Direction, Paper, ProjectilePush};

use super::{Bound, Check, Worked, check, corrected, equation, printed};
use crate::planted::Edition;

/// The direction with these legs and this hypotenuse.
fn theta(x: f64, y: f64, length: f64) -> Direction<f64> {
    Direction { cos: x / length, sin: y / length }
}

/// The same in the letters of (15) to (18); the edge along z, if there is one, is not looked at.
fn phi(x: f64, y: f64, length: f64) -> Cosines<f64> {
    Cosines { x: x / length, y: y / length }
}

/// The numbered equations of projectile and crossover.
pub fn equations() -> Vec<Check> {
    vec![
        projectile(),
        projectile_as_printed(),
        along(),
        across(),
        direction(),
        direction_as_printed(),
        secondary_u(),
        secondary_v(),
        secondary_w(),
        tension_along(),
        tension_across(),
        tension_across_as_printed(),
        pushed_u(),
        pushed_v(),
        pushed_u_as_printed(),
        pushed_v_as_printed(),
    ]
}

/// (8) of a fast projectile, a slow one, and one that goes back already.
fn slowed(paper: &Edition, answers: [(i64, i64); 3]) -> [Worked; 3] {
    let push = |velocity, tension_y, mass, node_mass| {
        let (time_step, time) = (0.003, 0.019);
        let push = ProjectilePush { velocity, tension_y, mass, node_mass, time_step, time };
        paper.eqn_8_projectile_velocity(push)
    };
    [
        (push(387.7, -271.9, 0.19, 0.02), answers[0]),
        (push(3.7, -91.3, 0.19, 0.05), answers[1]),
        (push(-9.3, -87.5, 0.53, 0.09), answers[2]),
    ]
}

fn projectile() -> Check {
    equation(
        "(8) with its corrections pulls projectile and node back, for one time step",
        &slowed(&corrected(), [(66_488, 175), (567, 400), (-6291, 620)]),
    )
}

fn projectile_as_printed() -> Check {
    equation(
        "(8) as printed pushes the projectile on, alone, and for the time since impact",
        &slowed(&printed(), [(11_052, 25), (549, 25), (-802, 265)]),
    )
}

fn along() -> Check {
    let of = |u, v, theta| corrected().eqn_9_parallel_velocity(u, v, theta);
    equation(
        "(9) is the velocity along the fibre: directions of 20-21-29, 5-12-13 and 8-15-17",
        &[
            (of(31.9, -20.3, theta(20.0, -21.0, 29.0)), (367, 10)),
            (of(-16.9, 9.1, theta(-5.0, 12.0, 13.0)), (149, 10)),
            (of(8.5, -32.3, theta(-8.0, -15.0, 17.0)), (49, 2)),
        ],
    )
}

fn across() -> Check {
    let of = |u, v, theta| corrected().eqn_10_perpendicular_velocity(u, v, theta);
    equation(
        "(10) is the velocity across the fibre: directions of 20-21-29, 5-12-13 and 8-15-17",
        &[
            (of(31.9, -20.3, theta(20.0, -21.0, 29.0)), (91, 10)),
            (of(-16.9, 9.1, theta(-5.0, 12.0, 13.0)), (121, 10)),
            (of(8.5, -32.3, theta(-8.0, -15.0, 17.0)), (227, 10)),
        ],
    )
}

/// Cosine and sine of four elements, one in each quadrant: 33-56-65, 5-12-13, 8-15-17, 20-21-29.
fn directions(paper: &Edition) -> [Direction<f64>; 4] {
    [
        ([4.0, 5.9], [0.7, 0.3]),
        ([0.2, 1.5], [0.7, 0.3]),
        ([-0.1, -1.2], [0.7, 0.3]),
        ([3.3, -1.7], [1.3, 0.4]),
    ]
    .map(|(here, behind)| {
        let point = |[x, y]: [f64; 2]| Vector::<f64, 2>::new(x, y);
        paper.eqn_11_direction(point(here), point(behind))
    })
}

fn direction() -> Check {
    let [first, second, third, fourth] = directions(&corrected());
    equation(
        "(11) with its correction is the direction of an element in each of the four quadrants",
        &[
            (first.cos, (33, 65)),
            (first.sin, (56, 65)),
            (second.cos, (-5, 13)),
            (second.sin, (12, 13)),
            (third.cos, (-8, 17)),
            (third.sin, (-15, 17)),
            (fourth.cos, (20, 29)),
            (fourth.sin, (-21, 29)),
        ],
    )
}

fn direction_as_printed() -> Check {
    let [first, second, third, fourth] = directions(&printed());
    equation(
        "(11) as printed is the direction of an element, or against it where the element is folded back",
        &[
            (first.cos, (33, 65)),
            (first.sin, (56, 65)),
            (second.cos, (5, 13)),
            (second.sin, (-12, 13)),
            (third.cos, (8, 17)),
            (third.sin, (15, 17)),
            (fourth.cos, (20, 29)),
            (fourth.sin, (-21, 29)),
        ],
    )
}

fn secondary_u() -> Check {
    let of =
        |slide, along, across, theta| corrected().eqn_12_secondary_u(slide, along, across, theta);
    equation(
        "(12) turns the velocities along the fibre, slid, and across it back to x",
        &[
            (of(0.7, 37.7, 26.1, theta(20.0, -21.0, 29.0)), (371, 10)),
            (of(0.3, 14.3, 7.8, theta(-5.0, 12.0, 13.0)), (-177, 20)),
        ],
    )
}

fn secondary_v() -> Check {
    let of =
        |slide, along, across, theta| corrected().eqn_13_secondary_v(slide, along, across, theta);
    equation(
        "(13) turns the velocities along the fibre, slid, and across it back to y",
        &[
            (of(0.7, 37.7, 26.1, theta(20.0, 21.0, 29.0)), (3711, 100)),
            (of(0.3, 14.3, -7.8, theta(-5.0, 12.0, 13.0)), (174, 25)),
            (of(0.3, 52.0, 71.5, theta(-33.0, -56.0, 65.0)), (-2487, 50)),
        ],
    )
}

fn secondary_w() -> Check {
    check(
        "(14) holds the secondary's first node in the plane of primary and projectile",
        "the page",
        "velocity along z, m/s",
        corrected().eqn_14_secondary_w(),
        Bound::Exactly(0.0),
        "a zero is a zero",
    )
}

fn tension_along() -> Check {
    let of = |tension, phi_2, phi_1| corrected().eqn_15_parallel_tension(tension, phi_2, phi_1);
    equation(
        "(15) is the secondary's tension along the primary: edges of 2-3-6-7 and 1-4-8-9",
        &[
            (of(60.9, phi(2.0, 3.0, 7.0), phi(20.0, 21.0, 29.0)), (309, 10)),
            (of(81.9, phi(-1.0, 4.0, 9.0), phi(-5.0, 12.0, 13.0)), (371, 10)),
            (of(83.3, phi(2.0, -6.0, 7.0), phi(-15.0, -8.0, 17.0)), (63, 5)),
        ],
    )
}

/// (16) of three secondaries.
fn normal_tension(paper: &Edition, answers: [(i64, i64); 3]) -> [Worked; 3] {
    let of = |tension, phi_2, phi_1| paper.eqn_16_perpendicular_tension(tension, phi_2, phi_1);
    [
        (of(60.9, phi(2.0, 3.0, 7.0), phi(20.0, -21.0, 29.0)), answers[0]),
        (of(81.9, phi(-1.0, 4.0, 9.0), phi(5.0, 12.0, 13.0)), answers[1]),
        (of(88.4, phi(-8.0, 9.0, 17.0), phi(-12.0, 5.0, 13.0)), answers[2]),
    ]
}

fn tension_across() -> Check {
    equation(
        "(16) with its correction is the secondary's tension across the primary",
        &normal_tension(&corrected(), [(153, 5), (112, 5), (-136, 5)]),
    )
}

fn tension_across_as_printed() -> Check {
    equation(
        "(16) as printed takes the products of like cosines from each other",
        &normal_tension(&printed(), [(309, 10), (-371, 10), (102, 5)]),
    )
}

/// The node before the push, and the push: three crossovers.
fn pushes() -> [([f64; 2], CrossoverPush<f64>); 3] {
    [
        (
            [7.3, 4.7],
            CrossoverPush {
                a: 0.1,
                slide_factor: 0.6,
                perpendicular: 4.1,
                parallel: 7.9,
                primary: phi(20.0, 21.0, 29.0),
                change: Vector::<f64, 2>::new(1.16, 0.87),
                mass: 0.3,
                secondary_mass: 0.5,
            },
        ),
        (
            [-9.1, 5.9],
            CrossoverPush {
                a: 0.7,
                slide_factor: 0.3,
                perpendicular: 2.31,
                parallel: -4.7,
                primary: phi(-5.0, 12.0, 13.0),
                change: Vector::<f64, 2>::new(-0.39, 1.3),
                mass: 0.18,
                secondary_mass: 0.5,
            },
        ),
        (
            [0.6, 5.7],
            CrossoverPush {
                a: 0.7,
                slide_factor: 0.6,
                perpendicular: 5.4,
                parallel: 7.4,
                primary: phi(-24.0, -7.0, 25.0),
                change: Vector::<f64, 2>::new(1.75, -2.0),
                mass: 0.27,
                secondary_mass: 0.45,
            },
        ),
    ]
}

/// (17) of them.
fn u(paper: &Edition, answers: [(i64, i64); 3]) -> [Worked; 3] {
    let u = pushes().map(|([u, _], push)| paper.eqn_17_u_at_crossover(u, push));
    [(u[0], answers[0]), (u[1], answers[1]), (u[2], answers[2])]
}

/// (18) of them.
fn v(paper: &Edition, answers: [(i64, i64); 3]) -> [Worked; 3] {
    let v = pushes().map(|([_, v], push)| paper.eqn_18_v_at_crossover(v, push));
    [(v[0], answers[0]), (v[1], answers[1]), (v[2], answers[2])]
}

fn pushed_u() -> Check {
    equation(
        "(17) with its corrections gives the impulses of a step to both nodes, along x",
        &u(&corrected(), [(70_075, 10_000), (-9274, 1000), (-316_075, 100_000)]),
    )
}

fn pushed_v() -> Check {
    equation(
        "(18) with its correction gives the impulses of a step to both nodes, along y",
        &v(&corrected(), [(505_625, 100_000), (38_242, 10_000), (3219, 1000)]),
    )
}

fn pushed_u_as_printed() -> Check {
    equation(
        "(17) as printed gives the secondary's pull to the primary's node, its normal turned in x",
        &u(&printed(), [(24_788, 2900), (-69_622, 13_000), (-187_104, 25_000)]),
    )
}

fn pushed_v_as_printed() -> Check {
    equation(
        "(18) as printed gives the secondary's pull to the primary's node",
        &v(&printed(), [(172_608, 29_000), (36_842, 13_000), (-82_452, 25_000)]),
    )
}
