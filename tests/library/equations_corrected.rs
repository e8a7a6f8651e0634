//! Each erratum that changes an equation, against numbers worked by hand and against the physics
//! that the printed form fails.
//!
//! Inputs are short binary fractions where the comment says "exact"; tolerances as in
//! `equations_as_printed.rs`.

#![allow(clippy::excessive_precision)] // seventeen digits of what was worked by hand

use crate::common::{assert_far, assert_ulps, cases, exact};
use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, Printed, ProjectilePush,
};
use proptest::prelude::*;

/// The edition with one correction.
fn only(erratum: Erratum) -> Corrected<Incremental> {
    Corrected::new(Corrections::NONE.with(erratum))
}

/// The edition with several.
fn with(errata: &[Erratum]) -> Corrected<Incremental> {
    Corrected::new(errata.iter().copied().collect())
}

fn all() -> Corrected<Incremental> {
    Corrected::new(Corrections::ALL)
}

/// A direction from its angle.
fn at_angle(angle: f64) -> Cosines<f64> {
    Cosines { x: Number::cos(angle), y: Number::sin(angle) }
}

// ---------------------------------------------------------------- strain-denominator

#[test]
fn strain_denominator_divides_by_the_length_before() {
    // (3/64)/(19/64) = 3/19; printed 3/22. One rounding.
    let (now, previous) = (exact(0.34375), exact(0.296875));
    let expected = 0.157_894_736_842_105_25;
    let got = only(Erratum::StrainDenominator).eqn_3_strain_increment(now, previous);
    assert_ulps::<f64>(got, expected, 1.0);
    assert_far(Printed.eqn_3_strain_increment(now, previous), expected);
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn strain_denominator_makes_3_the_increment_of_4(
        now in 0.0017_f64..0.0031, previous in 0.0017_f64..0.0031, strain in -0.031_f64..0.37,
    ) {
        prop_assume!((now / previous - 1.0).abs() > 0.01);
        let lengths = Lengths { now, previous, unstrained: 0.0023 };
        let increment = all().eqn_4_strain(strain, lengths) - strain;
        // (4) rounds the quotient and two sums, all below 4: half a unit of 2 each; and the
        // difference taken here.
        let tolerance = 4.0 * f64::EPSILON;
        let corrected = all().eqn_3_strain_increment(now, previous);
        prop_assert!((corrected - increment).abs() < tolerance, "{corrected} {increment}");
        // Printed is less by the square of the increment over 1 + itself: 1e-4 at 0.01.
        let printed = Printed.eqn_3_strain_increment(now, previous);
        prop_assert!((printed - increment).abs() > 0.9e-4 * 0.9, "{printed} {increment}");
    }
}

// ---------------------------------------------------------------- engineering strain

#[test]
fn engineering_strain_is_the_length_over_the_unstrained_length_less_one() {
    // (11/32)/(9/32) − 1 = 2/9; the quotient is rounded, half a unit of 1, 4 units of 0.22.
    let lengths =
        Lengths { now: exact(0.34375), previous: exact(0.296875), unstrained: exact(0.28125) };
    let edition = Corrected::<Engineering>::new(Corrections::ALL);
    let got: f64 = edition.eqn_4_strain(exact(0.01171875), lengths);
    assert_ulps(got, 0.222_222_222_222_222_22, 4.5);
    assert!(!Paper::<f64>::uses_previous_length(&edition));
    assert!(Paper::<f64>::uses_previous_length(&all()));
}

// ---------------------------------------------------------------- projectile

/// t = 19/256, Δt = 3/256, m_p = 7/32, m_node = 3/64, T_y = −271.8125.
fn projectile() -> ProjectilePush<f64> {
    ProjectilePush {
        velocity: exact(387.5),
        tension_y: exact(-271.8125),
        mass: exact(0.21875),
        node_mass: exact(0.046875),
        time_step: exact(0.01171875),
        time: exact(0.07421875),
    }
}

/// What 387.5 m/s becomes. Roundings: the division (and the sum); at most a unit and a half with
/// the literal's, twice that where the sum falls into a lower binade than 387.5's.
#[track_caller]
fn assert_projectile(errata: &[Erratum], expected: f64) {
    let got = with(errata).eqn_8_projectile_velocity(projectile());
    assert_ulps(got, expected, 3.0);
    let printed = Printed.eqn_8_projectile_velocity(projectile());
    assert_far(printed, expected);
}

#[test]
fn every_subset_of_the_projectile_corrections_gives_its_own_velocity() {
    use Erratum::{ProjectileInertia, ProjectileInterval, ProjectileSign};
    // 387.5 ± 543.625 × (19 or 3)/256 ÷ (7/32 or 17/64):
    // 19/56 = 0.33928571428571430, 19/68 = 0.27941176470588236,
    //  3/56 = 0.05357142857142857,  3/68 = 0.04411764705882353.
    let printed = Printed.eqn_8_projectile_velocity(projectile());
    assert_ulps(printed, 571.944_196_428_571_44, 1.5); // + 543.625 × 19/56
    assert_projectile(&[ProjectileSign], 203.055_803_571_428_58); // − 543.625 × 19/56
    assert_projectile(&[ProjectileInterval], 416.622_767_857_142_83); // + 543.625 × 3/56
    assert_projectile(&[ProjectileInertia], 539.395_220_588_235_25); // + 543.625 × 19/68
    let sign_and_interval = [ProjectileSign, ProjectileInterval];
    assert_projectile(&sign_and_interval, 358.377_232_142_857_17); // − 543.625 × 3/56
    let sign_and_inertia = [ProjectileSign, ProjectileInertia];
    assert_projectile(&sign_and_inertia, 235.604_779_411_764_7); // − 543.625 × 19/68
    let interval_and_inertia = [ProjectileInterval, ProjectileInertia];
    assert_projectile(&interval_and_inertia, 411.483_455_882_352_93); // + 543.625 × 3/68
    let all_three = [ProjectileSign, ProjectileInterval, ProjectileInertia];
    assert_projectile(&all_three, 363.516_544_117_647_07); // − 543.625 × 3/68
}

prop_compose! {
    /// Numbers of the size of the paper's, on a fibre that trails the projectile.
    fn trailing()(
        velocity in 113.0_f64..887.0, tension_y in -719.0_f64..-17.0, mass in 0.31e-3_f64..7.3e-3,
        node_mass in 0.17e-5_f64..0.93e-3, time_step in 0.13e-7_f64..3.7e-7, steps in 3_u32..997,
    ) -> ProjectilePush<f64> {
        let time = time_step * f64::from(steps);
        ProjectilePush { velocity, tension_y, mass, node_mass, time_step, time }
    }
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn projectile_sign_slows_the_projectile_that_the_page_accelerates(push in trailing()) {
        let corrected = only(Erratum::ProjectileSign).eqn_8_projectile_velocity(push);
        prop_assert!(corrected < push.velocity);
        prop_assert!(Printed.eqn_8_projectile_velocity(push) > push.velocity);
    }

    #[test]
    fn projectile_interval_does_not_depend_on_the_time_since_impact(push in trailing()) {
        let later = ProjectilePush { time: push.time * 1.37, ..push };
        let edition = only(Erratum::ProjectileInterval);
        prop_assert_eq!(
            edition.eqn_8_projectile_velocity(push).to_bits(),
            edition.eqn_8_projectile_velocity(later).to_bits()
        );
        let change = |push| Printed.eqn_8_projectile_velocity(push) - push.velocity;
        prop_assert!((change(later) / change(push) - 1.37).abs() < 1e-3);
    }

    #[test]
    fn projectile_inertia_balances_the_momentum_of_everything_that_moves(push in trailing()) {
        // (m_p + Δm) Δv = 2 T_y Δt. Δv is the difference of two velocities near 900 m/s, each
        // rounded by half a unit (6e-14 m/s); the rest is four relative roundings.
        let impulse = 2.0 * push.tension_y * push.time_step;
        let residual = |change: f64| (push.mass + push.node_mass) * change - impulse;
        let rounding = (push.mass + push.node_mass) * 1.2e-13 + impulse.abs() * 4.0 * f64::EPSILON;
        let change = all().eqn_8_projectile_velocity(push) - push.velocity;
        prop_assert!(residual(change).abs() < rounding, "{} {rounding}", residual(change));
        // Without it the node's share of the momentum is missing.
        let without = Corrected::<Incremental>::new(
            Corrections::ALL.without(Erratum::ProjectileInertia),
        );
        let change = without.eqn_8_projectile_velocity(push) - push.velocity;
        let missing = residual(change) / (push.node_mass * change);
        prop_assert!((missing - 1.0).abs() < 1e-6, "{missing}"); // the same rounding, over Δm Δv
    }
}

// ---------------------------------------------------------------- theta-at-origin

#[test]
fn theta_at_origin_uses_direction_cosines() {
    // Δx = 17/64, Δy = −42/64: cos = 17/√2053, sin = −42/√2053. Root and division are rounded; the
    // root's half unit counts up to twice.
    let here = Vector::<f64, 2>::new(exact(0.84375), exact(-0.265625));
    let behind = Vector::<f64, 2>::new(exact(0.578125), exact(0.390625));
    let got = only(Erratum::ThetaAtOrigin).eqn_11_direction(here, behind);
    assert_ulps(got.cos, 0.375_192_757_733_183_17, 2.0);
    assert_ulps(got.sin, -0.926_946_813_223_158_42, 2.0);
    // Folded back, Δx = −17/64: the page's angle lies in (−90°, 90°) and points the other way.
    let (x, y) = (2.0 * behind.x - here.x, here.y);
    let folded = Vector::<f64, 2>::new(x, y);
    let got = only(Erratum::ThetaAtOrigin).eqn_11_direction(folded, behind);
    assert_ulps(got.cos, -0.375_192_757_733_183_17, 2.0);
    assert_ulps(got.sin, -0.926_946_813_223_158_42, 2.0);
    let printed = Printed.eqn_11_direction(folded, behind);
    assert_far(printed.cos, got.cos);
    assert_far(printed.sin, got.sin);
}

#[test]
fn theta_at_origin_knows_the_direction_of_an_element_along_y() {
    // Δx = 0: tan⁻¹(±∞) is the double nearest to ±π/2, whose cosine is 6.1e-17 and not 0.
    let behind = Vector::<f64, 2>::new(0.03125, 0.171875);
    for (dy, sin) in [(0.40625, 1.0), (-0.40625, -1.0)] {
        let here = behind + Vector::<f64, 2>::new(0.0, dy);
        let got = all().eqn_11_direction(here, behind);
        assert_eq!((got.cos, got.sin), (0.0, sin));
        let printed = Printed.eqn_11_direction(here, behind);
        assert_eq!(printed.sin, sin);
        assert!(printed.cos > 6.1e-17 && printed.cos < 6.2e-17);
    }
}

#[test]
fn an_element_without_length_has_no_direction_in_either_form() {
    let x = Vector::<f64, 2>::new(0.03125, 0.171875);
    let (printed, corrected) = (Printed.eqn_11_direction(x, x), all().eqn_11_direction(x, x));
    for number in [printed.cos, printed.sin, corrected.cos, corrected.sin] {
        assert!(number.is_nan());
    }
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn both_forms_of_11_agree_ahead_and_are_opposite_on_a_folded_element(
        length in 0.13e-3_f64..7.1e-3, angle in -3.13_f64..3.13, x in 0.017_f64..0.29,
        y in -0.031_f64..0.031,
    ) {
        let behind = Vector::<f64, 2>::new(x, y);
        let element = at_angle(angle);
        prop_assume!(element.x.abs() > 1e-3);
        let here = behind + Vector::<f64, 2>::new(element.x, element.y) * length;
        let (printed, corrected) =
            (Printed.eqn_11_direction(here, behind), all().eqn_11_direction(here, behind));
        let sign = if element.x > 0.0 { 1.0 } else { -1.0 };
        // Angle: two roundings of at most a unit of 1 (2.2e-16); cosine and sine, root and quotient.
        prop_assert!((corrected.cos - sign * printed.cos).abs() < 8e-16);
        prop_assert!((corrected.sin - sign * printed.sin).abs() < 8e-16);
        // It is a direction, and that of the element: the ends' rounding, 3e-17 of 1.3e-4.
        prop_assert!((corrected.cos - element.x).abs() < 1e-12);
        prop_assert!((corrected.sin - element.y).abs() < 1e-12);
    }

    #[test]
    fn every_use_of_the_direction_is_even_in_it(
        u in -431.0_f64..431.0, v in -431.0_f64..431.0, slide in 0.0_f64..1.0, angle in -3.1_f64..3.1,
    ) {
        let Cosines { x: cos, y: sin } = at_angle(angle);
        let imposed = |theta: Direction<f64>| {
            let parallel = all().eqn_9_parallel_velocity(u, v, theta);
            let perpendicular = all().eqn_10_perpendicular_velocity(u, v, theta);
            [
                all().eqn_12_secondary_u(slide, parallel, perpendicular, theta),
                all().eqn_13_secondary_v(slide, parallel, perpendicular, theta),
            ]
            .map(f64::to_bits)
        };
        // Changing the sign of both factors of a product changes no bit of it.
        let reversed = Direction { cos: -cos, sin: -sin };
        prop_assert_eq!(imposed(Direction { cos, sin }), imposed(reversed));
    }
}

// ---------------------------------------------------------------- perpendicular-resolution

#[test]
fn perpendicular_resolution_takes_the_component_along_the_normal() {
    // 640.125 × (−0.78125 × 0.90625 − 0.34375 × 0.40625)
    //   = 640.125 × (−0.7080078125 − 0.1396484375) = 640.125 × −0.84765625, exact.
    let secondary = Cosines { x: exact(0.34375), y: exact(-0.78125) };
    let primary = Cosines { x: exact(0.90625), y: exact(0.40625) };
    let tension = exact::<f64>(640.125);
    let expected = -542.605_957_031_25;
    let edition = only(Erratum::PerpendicularResolution);
    let got = edition.eqn_16_perpendicular_tension(tension, secondary, primary);
    assert_ulps(got, expected, 0.5);
    let printed = Printed.eqn_16_perpendicular_tension(tension, secondary, primary);
    assert_far(printed, expected);
}

/// (15) and (16).
fn resolved(
    paper: &impl Paper<f64>,
    t: f64,
    second: Cosines<f64>,
    prime: Cosines<f64>,
) -> [f64; 2] {
    [
        paper.eqn_15_parallel_tension(t, second, prime),
        paper.eqn_16_perpendicular_tension(t, second, prime),
    ]
}

prop_compose! {
    /// A tension, the in-plane part of the secondary's direction, and the primary's angle, none so
    /// near to an axis that the printed form is right by accident.
    fn crossing()(
        tension in 13.0_f64..971.0, in_plane in 0.07_f64..0.97, angle_2 in -3.1_f64..3.1,
        angle_1 in 0.2_f64..1.3,
    ) -> (f64, f64, f64, f64) { (tension, in_plane, angle_2, angle_1) }
}

fn scaled(cosines: Cosines<f64>, by: f64) -> Cosines<f64> {
    Cosines { x: cosines.x * by, y: cosines.y * by }
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn perpendicular_resolution_keeps_the_length_of_the_tension(
        (tension, in_plane, angle_2, angle_1) in crossing()
    ) {
        let secondary = scaled(at_angle(angle_2), in_plane);
        let whole = tension * tension * (secondary.x * secondary.x + secondary.y * secondary.y);
        let squares = |[a, b]: [f64; 2]| a * a + b * b;
        let edition = only(Erratum::PerpendicularResolution);
        let got = squares(resolved(&edition, tension, secondary, at_angle(angle_1)));
        // About ten roundings of products no larger than the whole.
        prop_assert!((got / whole - 1.0).abs() < 10.0 * f64::EPSILON, "{got} {whole}");
        // Printed, (15)² + (16)² = T² [2 (c2x c1x)² + 2 (c2y c1y)²].
        let printed = squares(resolved(&Printed, tension, secondary, at_angle(angle_1)));
        let (a, b) = (Number::cos(angle_2) * Number::cos(angle_1),
            Number::sin(angle_2) * Number::sin(angle_1));
        let ratio = 2.0 * (a * a + b * b);
        prop_assume!((ratio - 1.0).abs() > 0.05); // crosses 1 at some angles
        prop_assert!((printed / whole - ratio).abs() < 10.0 * f64::EPSILON);
    }

    #[test]
    fn perpendicular_resolution_does_not_change_when_everything_is_turned(
        (tension, in_plane, angle_2, angle_1) in crossing(), turn in 0.3_f64..1.2,
    ) {
        let pair = |turn: f64| (scaled(at_angle(angle_2 + turn), in_plane), at_angle(angle_1 + turn));
        let change = |paper: &Corrected| {
            let [(s, p), (s_turned, p_turned)] = [pair(0.0), pair(turn)];
            let [_, before] = resolved(paper, tension, s, p);
            let [_, after] = resolved(paper, tension, s_turned, p_turned);
            ((after - before) / (tension * in_plane)).abs()
        };
        // The angles, up to 4.4, are rounded to 4e-16; the cosines and the products to 2e-16.
        prop_assert!(change(&only(Erratum::PerpendicularResolution)) < 3e-15);
        // Printed (16) is T cos(φ1 + φ2) and turns with twice the angle.
        let sum = angle_1 + angle_2;
        let turned = (Number::cos(sum + 2.0 * turn) - Number::cos(sum)).abs();
        let printed = change(&Corrected::new(Corrections::NONE));
        prop_assert!((printed - turned).abs() < 3e-15, "{printed} {turned}");
    }

    #[test]
    fn on_a_straight_fibre_the_page_takes_the_parallel_tension_for_the_perpendicular(
        (tension, in_plane, angle_2, _) in crossing()
    ) {
        let along_x = Cosines { x: 1.0, y: 0.0 };
        let secondary = scaled(at_angle(angle_2), in_plane);
        let [parallel, printed] = resolved(&Printed, tension, secondary, along_x);
        prop_assert_eq!(parallel, printed);
        let [parallel, perpendicular] = resolved(&all(), tension, secondary, along_x);
        prop_assert_eq!(parallel, tension * secondary.x);
        prop_assert_eq!(perpendicular, tension * secondary.y);
    }
}

// ---------------------------------------------------------------- perpendicular-sign

/// A push with cosines exact in binary, not those of a real direction.
fn binary_push() -> CrossoverPush<f64> {
    CrossoverPush {
        a: exact(0.34765625),
        slide_factor: exact(0.71875),
        perpendicular: exact(31.4375),
        parallel: exact(-47.0625),
        primary: Cosines { x: exact(0.90625), y: exact(0.40625) },
        change: Vector::<f64, 2>::new(exact(2.6875), exact(-5.3125)),
        mass: exact(0.140625),
        secondary_mass: exact(0.0859375),
    }
}

#[test]
fn perpendicular_sign_pushes_against_x() {
    // −11.25 + 0.6953125 × (−31.4375 × 0.40625 + 0.71875 × −47.0625 × 0.90625)
    //   = −11.25 + 0.6953125 × (−12.771484375 − 30.65496826171875), exact;
    // printed −11.25 + 0.6953125 × (12.771484375 − 30.65496826171875) = −23.684609889984131.
    let expected = -41.444_955_348_968_506;
    let got = only(Erratum::PerpendicularSign).eqn_17_u_at_crossover(-11.25, binary_push());
    assert_ulps(got, expected, 0.5);
    assert_far(Printed.eqn_17_u_at_crossover(-11.25, binary_push()), expected);
    // (18) is not touched.
    assert_eq!(
        only(Erratum::PerpendicularSign).eqn_18_v_at_crossover(63.875, binary_push()),
        Printed.eqn_18_v_at_crossover(63.875, binary_push())
    );
}

prop_compose! {
    /// A crossover of the size of the paper's.
    fn pushed()(
        angle in -1.4_f64..1.4, slide_factor in 0.03_f64..0.97,
        perpendicular in 11.0_f64..613.0, parallel in -613.0_f64..-11.0,
        du in -37.0_f64..37.0, dv in -37.0_f64..37.0,
        mass in 0.9e-6_f64..3.7e-6, secondary_mass in 0.9e-6_f64..3.7e-6,
        time_step in 1.3e-7_f64..3.7e-7,
    ) -> CrossoverPush<f64> {
        CrossoverPush {
            a: time_step / mass,
            slide_factor,
            perpendicular,
            parallel,
            primary: at_angle(angle),
            change: Vector::<f64, 2>::new(du, dv),
            mass,
            secondary_mass,
        }
    }
}

/// What (17) and (18) add to a node at rest: along the primary fibre, and across it.
fn added(paper: &impl Paper<f64>, push: CrossoverPush<f64>) -> [f64; 2] {
    let u = paper.eqn_17_u_at_crossover(0.0, push);
    let v = paper.eqn_18_v_at_crossover(0.0, push);
    let Cosines { x, y } = push.primary;
    [u * x + v * y, v * x - u * y]
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn perpendicular_sign_pushes_at_right_angles_to_the_fibre(push in pushed()) {
        prop_assume!(push.primary.y.abs() > 0.1);
        let across_only = CrossoverPush { parallel: 0.0, change: Vector::zeros(), ..push };
        let size = 2.0 * push.a * push.perpendicular;
        for edition in [only(Erratum::PerpendicularSign), all()] {
            let [along, across] = added(&edition, across_only);
            // Half a dozen roundings of parts no larger than the whole.
            prop_assert!(along.abs() < 4.0 * f64::EPSILON * size, "{along} of {size}");
            prop_assert!(across > 0.0);
        }
        // Printed, cos² of the doubled angle is left: 2 cosφ1x cosφ1y of it points along the fibre.
        let [along, _] = added(&Printed, across_only);
        let expected = 2.0 * push.primary.x * push.primary.y * size;
        prop_assert!((along - expected).abs() < 4.0 * f64::EPSILON * size, "{along} {expected}");
    }
}

// ---------------------------------------------------------------- crossover-inertia

/// Cosines 0.96 and 0.28, a direction whose squares add to 1 exactly in decimals.
fn decimal_push() -> CrossoverPush<f64> {
    CrossoverPush { primary: Cosines { x: 0.96, y: 0.28 }, ..binary_push() }
}

#[test]
fn crossover_inertia_moves_both_masses() {
    // Worked from the balance of momentum, not from the form in the code.
    // Δt = A Δm1 = 0.34765625 × 0.140625 = 0.04888916015625.
    // (2) gave the node (2.6875, −5.3125): 2.6875 × 0.96 − 5.3125 × 0.28 = 1.0925 along and
    // −5.3125 × 0.96 − 2.6875 × 0.28 = −5.8525 across; × Δm1 these are the primary's impulses.
    // Along:  (0.140625 × 1.0925 + 2 Δt × 0.71875 × −47.0625)/(0.140625 + 0.71875² × 0.0859375)
    //         = −17.045864448888706
    // Across: (0.140625 × −5.8525 + 2 Δt × 31.4375)/(0.140625 + 0.0859375) = 9.9349986530172414
    // u = −11.25 − 2.6875 + 0.96 × −17.0458… − 0.28 × 9.9349…
    // v = 63.875 + 5.3125 + 0.28 × −17.0458… + 0.96 × 9.9349…
    let (u, v) = (-33.083_329_493_777_988, 73.952_256_661_207_713);
    let push = decimal_push();
    // 0.96 and 0.28 are rounded, and about ten operations on numbers no larger than the result.
    let tolerance = 8.0;
    let sign = Erratum::PerpendicularSign;
    let edition = with(&[Erratum::CrossoverInertia, sign]);
    assert_ulps(edition.eqn_17_u_at_crossover(-11.25, push), u, tolerance);
    assert_ulps(all().eqn_17_u_at_crossover(-11.25, push), u, tolerance);
    assert_ulps(all().eqn_18_v_at_crossover(63.875, push), v, tolerance);
    assert_far(only(sign).eqn_17_u_at_crossover(-11.25, push), u);
    assert_far(Printed.eqn_18_v_at_crossover(63.875, push), v);
    // Alone, with the printed sign of the push: the part 2 Δt × 31.4375/0.2265625 of the velocity
    // across counts + 0.28 in u, and that of the primary's impulse − 0.28 as before.
    let alone = only(Erratum::CrossoverInertia);
    let u_alone = -25.485_481_972_226_26;
    assert_ulps(alone.eqn_17_u_at_crossover(-11.25, push), u_alone, tolerance);
    assert_ulps(alone.eqn_18_v_at_crossover(63.875, push), v, tolerance);
}

proptest! {
    #![proptest_config(cases(256))]
    #[test]
    fn crossover_inertia_balances_the_momentum_of_both_nodes(push in pushed()) {
        // Along: (Δm1 + α_s² Δm2) Δv = Δt (T_ahead − T_here)·t + 2 Δt α_s T2_para;
        // across: (Δm1 + Δm2) Δv = Δt (T_ahead − T_here)·n + 2 Δt T2_perp.
        // The impulse of the primary's tensions is Δm1 times the change by (2).
        let Cosines { x, y } = push.primary;
        let (du, dv) = (push.change.x, push.change.y);
        let by_2 = [du * x + dv * y, dv * x - du * y];
        let dt = push.a * push.mass;
        let slide = push.slide_factor;
        let impulse = [
            push.mass * by_2[0] + 2.0 * dt * slide * push.parallel,
            push.mass * by_2[1] + 2.0 * dt * push.perpendicular,
        ];
        let moving = [
            push.mass + slide * slide * push.secondary_mass,
            push.mass + push.secondary_mass,
        ];
        // Of everything that is added up: about two dozen roundings.
        let size = dt * (push.parallel.abs() + push.perpendicular)
            + push.mass * (du.abs() + dv.abs());
        let gained = added(&all(), push);
        for i in 0..2 {
            let residual = moving[i] * (by_2[i] + gained[i]) - impulse[i];
            prop_assert!(residual.abs() < 24.0 * f64::EPSILON * size, "{residual} of {size}");
        }
        // Without the correction the secondary's share of the momentum is missing.
        let sign = only(Erratum::PerpendicularSign);
        let across = by_2[1] + added(&sign, push)[1];
        let missing = moving[1] * across - impulse[1] - push.secondary_mass * across;
        prop_assert!(missing.abs() < 24.0 * f64::EPSILON * size, "{missing} of {size}");
    }

    #[test]
    fn a_secondary_without_mass_has_no_inertia(push in pushed()) {
        let massless = CrossoverPush { secondary_mass: 0.0, ..push };
        let sign = only(Erratum::PerpendicularSign);
        prop_assert_eq!(added(&all(), massless), added(&sign, massless));
    }
}
