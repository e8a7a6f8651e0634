//! (1) to (7), (19) and (20). The working: docs/exact/by-hand.md.

use crossfibre::errata::Corrections;
use crossfibre::number::Vector;
use crossfibre::paper::{Lengths, Paper, Remembered, StressByLaw};
use crossfibre::scene::Strain;

use super::{Check, Worked, corrected, equation, printed};
use crate::planted;

fn plane(x: f64, y: f64) -> Vector<f64, 2> {
    Vector::<f64, 2>::new(x, y)
}

fn space(x: f64, y: f64, z: f64) -> Vector<f64, 3> {
    Vector::<f64, 3>::new(x, y, z)
}

/// The numbered equations of a fibre.
pub fn equations() -> Vec<Check> {
    vec![
        balance(),
        velocity(),
        increment(),
        increment_as_printed(),
        strain(),
        engineering_strain(),
        length_before(),
        length_now(),
        tension(),
        tension_by_law(),
        wave_equation(),
        courant(),
    ]
}

fn balance() -> Check {
    let residual = corrected().eqn_1_impulse_residual(
        space(91.7, -36.3, 12.9),
        space(-18.4, 55.1, -70.3),
        0.7,
        space(23.3, 41.9, 7.7),
        space(-11.3, -63.8, 19.1),
    );
    let in_plane = corrected().eqn_1_impulse_residual(
        plane(88.1, 23.1),
        plane(-69.6, 9.3),
        0.7,
        plane(-0.3, 13.2),
        plane(-13.5, -63.4),
    );
    equation(
        "(1) is the difference of the tensions less the change of momentum in a time step",
        &[
            (residual.x, (8588, 100)),
            (residual.y, (-16_539, 100)),
            (residual.z, (9118, 100)),
            (in_plane.x, (14_846, 100)),
            (in_plane.y, (-3982, 100)),
        ],
    )
}

fn velocity() -> Check {
    let v = corrected().eqn_2_velocity(
        space(-11.3, -63.8, 19.1),
        0.7,
        space(91.7, -36.3, 12.9),
        space(-18.4, 55.1, -70.3),
    );
    let w =
        corrected().eqn_2_velocity(plane(-13.5, -63.4), 0.7, plane(88.1, 23.1), plane(-69.6, 9.3));
    equation(
        "(2) adds to the velocity of a node A times the difference of the tensions beside it",
        &[
            (v.x, (6577, 100)),
            (v.y, (-12778, 100)),
            (v.z, (7734, 100)),
            (w.x, (9689, 100)),
            (w.y, (-5374, 100)),
        ],
    )
}

fn increment() -> Check {
    let of = |now, before| corrected().eqn_3_strain_increment(now, before);
    equation(
        "(3) with its correction is the change of length over the length before",
        &[
            (of(2.9, 2.1), (8, 21)),
            (of(0.37, 0.65), (-28, 65)),
            (of(2.7, 1.9), (8, 19)),
            (of(0.71, 0.13), (58, 13)),
            (of(5.3, 9.7), (-44, 97)),
        ],
    )
}

fn increment_as_printed() -> Check {
    let of = |now, before| printed().eqn_3_strain_increment(now, before);
    equation(
        "(3) as printed is the change of length over the length now",
        &[
            (of(2.9, 2.1), (8, 29)),
            (of(0.37, 0.65), (-28, 37)),
            (of(2.7, 1.9), (8, 27)),
            (of(0.71, 0.13), (58, 71)),
            (of(5.3, 9.7), (-44, 53)),
        ],
    )
}

fn strain() -> Check {
    let of = |before, now, previous| {
        corrected().eqn_4_strain(before, Lengths { now, previous, unstrained: 1.7 })
    };
    equation(
        "(4) adds to the strain the change of length over the length before",
        &[
            (of(0.013, 2.9, 2.1), (8273, 21_000)),
            (of(-0.217, 0.37, 0.65), (-8421, 13_000)),
            (of(0.031, 2.7, 1.9), (8589, 19_000)),
            (of(0.47, 0.71, 0.13), (6411, 1300)),
            (of(-0.19, 5.3, 9.7), (-6243, 9700)),
        ],
    )
}

fn engineering_strain() -> Check {
    let paper = planted::edition(Strain::Engineering, Corrections::ALL);
    let of =
        |now, unstrained| paper.eqn_4_strain(0.013, Lengths { now, previous: 2.3, unstrained });
    equation(
        "Engineering strain is the change of length over the unstrained length, whatever came between",
        &[
            (of(2.9, 1.7), (12, 17)),
            (of(0.37, 0.53), (-16, 53)),
            (of(2.7, 1.9), (8, 19)),
            (of(0.71, 0.13), (58, 13)),
        ],
    )
}

fn length_before() -> Check {
    let paper = corrected();
    let here = space(0.3, -0.7, 0.2);
    equation(
        "(5) is the distance of two nodes: 2-3-6-7, 8-9-12-17, 1-4-8-9 and 20-21-29",
        &[
            (paper.eqn_5_previous_length(space(0.5, -0.4, 0.8), here), (7, 10)),
            (paper.eqn_5_previous_length(space(1.1, 0.2, 1.4), here), (17, 10)),
            (paper.eqn_5_previous_length(space(0.4, -1.1, 1.0), here), (9, 10)),
            (paper.eqn_5_previous_length(plane(3.3, -1.7), plane(1.3, 0.4)), (29, 10)),
        ],
    )
}

fn length_now() -> Check {
    let paper = corrected();
    let in_space = paper.eqn_6_length(
        space(0.5, -0.4, 0.8),
        space(12.9, 32.9, 23.7),
        space(0.3, -0.7, 0.2),
        space(-7.1, 12.9, 3.7),
        0.03,
    );
    let in_plane = paper.eqn_6_length(
        plane(1.8, -0.8),
        plane(28.3, -23.2),
        plane(1.3, 0.4),
        plane(3.3, -8.2),
        0.06,
    );
    let folded = paper.eqn_6_length(
        plane(0.9, 1.3),
        plane(-8.7, 3.6),
        plane(1.1, 0.7),
        plane(5.3, -8.4),
        0.05,
    );
    equation(
        "(6) is the distance of two nodes that have moved on: 8-9-12-17, 20-21-29 and 3-4-5",
        &[(in_space, (17, 10)), (in_plane, (29, 10)), (folded, (15, 10))],
    )
}

fn tension() -> Check {
    let of = |stiffness, strain| corrected().eqn_7_tension(stiffness, strain);
    equation(
        "(7) is modulus times area times strain",
        &[
            (of(58.7, 0.0137), (80_419, 100_000)),
            (of(71_300.7, -0.00231), (-164_704_617, 1_000_000)),
            (of(613.9, 0.0411), (2_523_129, 100_000)),
            (of(37.3, 0.0297), (110_781, 100_000)),
        ],
    )
}

fn tension_by_law() -> Check {
    let memory = Remembered { of_all: &[], each: 0, element: 0 };
    let of = |area, stress| {
        let by = StressByLaw { stress, strain_before: 0.0113, strain: 0.0137, memory };
        corrected().eqn_7_tension_by_law(area, by)
    };
    let worked: [Worked; 4] = [
        (of(1.3e-6, 8.39e8), (10_907, 10)),
        (of(0.7e-6, -3.17e7), (-2219, 100)),
        (of(2.3e-6, 1.91e9), (4393, 1)),
        (of(1.9e-6, 7.31e8), (13_889, 10)),
    ];
    equation("(7) with another law is area times stress", &worked)
}

fn wave_equation() -> Check {
    let of = |wave_speed, curvature| corrected().eqn_19_acceleration(wave_speed, curvature);
    equation(
        "(19) is the square of the wave speed times the curvature",
        &[
            (of(6968.6, 0.37), (44_919_282_013, 2500)),
            (of(3517.9, -1.3), (-16_088_306_533, 1000)),
            (of(71.3, 0.11), (5_592_059, 10_000)),
            (of(5.3, -0.7), (-19_663, 1000)),
        ],
    )
}

fn courant() -> Check {
    let of = |c, time_step, spacing| corrected().eqn_20_courant(c, time_step, spacing);
    equation(
        "(20) is the way of a wave in a time step over the length of an element",
        &[
            (of(6968.6, 2.3e-7, 1.7e-3), (801_389, 850_000)),
            (of(3517.9, 1.9e-7, 8.3e-4), (668_401, 830_000)),
            (of(713.1, 3.1e-7, 3.7e-4), (221_061, 370_000)),
            (of(9241.7, 1.3e-7, 1.9e-3), (1_201_421, 1_900_000)),
        ],
    )
}
