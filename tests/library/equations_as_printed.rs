//! The twenty equations as printed, against numbers worked by hand.
//!
//! Every input is a short binary fraction, exact in f32 and in f64, so that a decimal calculator
//! reproduces the working to the last digit; each input of an equation is different and none is
//! special, so that a swap of two of them, a sign, a factor, `t` for `Δt`, a sine for a cosine shows.
//! Direction cosines need not belong to a real direction for that.
//!
//! Tolerances are in units of the last place of the number type: half a unit for each rounding,
//! and half for the literal. Where every operation is exact the comment says so, and half a unit
//! then means equality.

#![allow(clippy::excessive_precision)] // seventeen digits of what was worked by hand

use crate::common::{assert_ulps, exact, exact_vector};
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, Printed, ProjectilePush, Remembered,
    StressByLaw,
};

/// Makes a test in f64 and one in f32 of each function.
macro_rules! in_both_precisions {
    ($($name:ident)*) => {
        mod double { $(#[test] fn $name() { super::$name::<f64>(); })* }
        mod single { $(#[test] fn $name() { super::$name::<f32>(); })* }
    };
}

in_both_precisions! {
    eqn_1_is_the_left_side_less_the_right
    eqn_2_adds_the_impulse_of_both_tensions
    eqn_3_divides_by_the_length_now
    eqn_4_divides_by_the_length_before
    eqn_5_is_the_distance_of_the_old_positions
    eqn_6_is_the_distance_of_the_new_positions
    eqn_7_multiplies
    eqn_7_multiplies_by_the_area_where_the_law_is_another
    eqn_8_divides_by_the_time_since_impact_and_accelerates
    eqn_9_resolves_along_the_fibre
    eqn_10_resolves_across_the_fibre
    eqn_11_is_the_inverse_tangent
    eqn_12_slides_the_parallel_part
    eqn_13_slides_the_parallel_part
    eqn_14_is_zero
    eqn_15_adds_the_products_of_cosines
    eqn_16_subtracts_the_products_of_cosines
    eqn_17_pushes_along_x
    eqn_18_pushes_along_y
    eqn_19_squares_the_wave_speed
    eqn_20_is_the_courant_number
}

// Vectors of the momentum balance and of the lengths; the first two components serve D = 2.
const TENSION_AHEAD: [f64; 3] = [913.375, -271.8125, 58.4375];
const TENSION_HERE: [f64; 3] = [640.125, 389.5625, -77.6875];
const VELOCITY: [f64; 3] = [23.625, -41.375, 7.5625];
const PREVIOUS_VELOCITY: [f64; 3] = [-11.25, 63.875, 19.1875];
const POSITION_AHEAD: [f64; 3] = [0.84375, -0.265625, 0.171875];
const POSITION_HERE: [f64; 3] = [0.578125, 0.390625, -0.453125];
/// 89/256.
const A: f64 = 0.34765625;
/// 3/256.
const TIME_STEP: f64 = 0.01171875;

fn vector<S: Number, const D: usize>(all: [f64; 3]) -> Vector<S, D> {
    exact_vector(std::array::from_fn::<f64, D, _>(|i| all[i]))
}

fn assert_components<S: Number, const D: usize>(got: Vector<S, D>, expected: [f64; 3], units: f64) {
    assert!(D == 2 || D == 3);
    for i in 0..D {
        assert_ulps(got[i], expected[i], units);
    }
}

fn eqn_1_is_the_left_side_less_the_right<S: Number>() {
    // x: 913.375 − 640.125 − 0.34765625 × (23.625 + 11.25)     = 273.25 − 12.12451171875
    // y: −271.8125 − 389.5625 − 0.34765625 × (−41.375 − 63.875) = −661.375 + 36.5908203125
    // z: 58.4375 + 77.6875 − 0.34765625 × (7.5625 − 19.1875)    = 136.125 + 4.04150390625
    // Exact: every product has fewer than 24 binary digits.
    let expected = [261.12548828125, -624.7841796875, 140.16650390625];
    fn residual<S: Number, const D: usize>() -> Vector<S, D> {
        Printed.eqn_1_impulse_residual(
            vector::<S, D>(TENSION_AHEAD),
            vector(TENSION_HERE),
            exact(A),
            vector(VELOCITY),
            vector(PREVIOUS_VELOCITY),
        )
    }
    assert_components(residual::<S, 2>(), expected, 0.5);
    assert_components(residual::<S, 3>(), expected, 0.5);
}

fn eqn_2_adds_the_impulse_of_both_tensions<S: Number>() {
    // x: −11.25 + 0.34765625 × 273.25   = −11.25 + 94.9970703125
    // y: 63.875 + 0.34765625 × −661.375 = 63.875 − 229.93115234375
    // z: 19.1875 + 0.34765625 × 136.125 = 19.1875 + 47.32470703125
    // Exact.
    let expected = [83.7470703125, -166.05615234375, 66.51220703125];
    fn velocity<S: Number, const D: usize>() -> Vector<S, D> {
        Printed.eqn_2_velocity(
            vector::<S, D>(PREVIOUS_VELOCITY),
            exact(A),
            vector(TENSION_AHEAD),
            vector(TENSION_HERE),
        )
    }
    assert_components(velocity::<S, 2>(), expected, 0.5);
    assert_components(velocity::<S, 3>(), expected, 0.5);
}

fn eqn_3_divides_by_the_length_now<S: Number>() {
    // (11/32 − 19/64)/(11/32) = (3/64)/(22/64) = 3/22. The difference is exact, the division is
    // the only rounding: half a unit, and half for the literal.
    let got = Printed.eqn_3_strain_increment(exact::<S>(0.34375), exact(0.296875));
    assert_ulps(got, 0.136_363_636_363_636_35, 1.0);
}

fn eqn_4_divides_by_the_length_before<S: Number>() {
    // 3/256 + (11/32)/(19/64) − 1 = 3/256 + 22/19 − 1 = 3/256 + 3/19
    //   = 0.01171875 + 0.15789473684210526
    // The quotient and the first sum, both between 1 and 2, are rounded: half a unit of 1 each, and
    // a unit of 1 is 8 of 0.17. The subtraction of 1 is exact.
    let length =
        Lengths { now: exact::<S>(0.34375), previous: exact(0.296875), unstrained: exact(0.28125) };
    let got = Printed.eqn_4_strain(exact::<S>(0.01171875), length);
    assert_ulps(got, 0.169_613_486_842_105_25, 8.5);
    assert!(Paper::<S>::uses_previous_length(&Printed));
}

fn eqn_5_is_the_distance_of_the_old_positions<S: Number>() {
    // Differences 0.265625, −0.65625, 0.625; squares 0.070556640625, 0.4306640625, 0.390625.
    // √0.501220703125 and √0.891845703125. The root is the only rounding.
    fn length<S: Number, const D: usize>() -> S {
        let here = vector::<S, D>(POSITION_HERE);
        Printed.eqn_5_previous_length(vector(POSITION_AHEAD), here)
    }
    assert_ulps(length::<S, 2>(), 0.707_969_422_450_574_49, 1.0);
    assert_ulps(length::<S, 3>(), 0.944_375_827_266_348_5, 1.0);
}

fn eqn_6_is_the_distance_of_the_new_positions<S: Number>() {
    // Way of the far node: 3/256 × (23.625, −41.375, 7.5625); of the near: 3/256 × (−11.25, 63.875,
    // 19.1875). Differences 0.265625 + 3/256 × 34.875 = 0.67431640625,
    // −0.65625 − 3/256 × 105.25 = −1.8896484375, 0.625 − 3/256 × 11.625 = 0.48876953125: exact.
    // √4.0254738330841064 and √4.264369487762451. In f32 the squares and their sum are rounded,
    // which the root halves: (½ + ½ + ½)/2 + ½ relative, up to twice that in units of 2.0.
    fn length<S: Number, const D: usize>() -> S {
        let (x_here, v_here) = (vector(POSITION_HERE), vector(PREVIOUS_VELOCITY));
        Printed.eqn_6_length::<D>(
            vector(POSITION_AHEAD),
            vector(VELOCITY),
            x_here,
            v_here,
            exact::<S>(TIME_STEP),
        )
    }
    assert_ulps(length::<S, 2>(), 2.006_358_351_113_804_8, 3.0);
    assert_ulps(length::<S, 3>(), 2.065_034_984_634_025_7, 3.0);
}

fn eqn_7_multiplies<S: Number>() {
    // 57343.5 × 3/256 = 671.994140625, exact.
    let got = Printed.eqn_7_tension(exact::<S>(57_343.5), exact(0.01171875));
    assert_ulps(got, 671.994_140_625, 0.5);
}

fn eqn_7_multiplies_by_the_area_where_the_law_is_another<S: Number>() {
    // 37/1024 × 57343.5 = 2071.98193359375, exact; strains and memory are only shown.
    let by = StressByLaw {
        stress: exact::<S>(57_343.5),
        strain_before: exact(0.0234375),
        strain: exact(0.01171875),
        memory: Remembered { of_all: &[exact(913.375)], each: 1, element: 0 },
    };
    assert_ulps(
        Printed.eqn_7_tension_by_law(exact(0.036_132_812_5), by),
        2_071.981_933_593_75,
        0.5,
    );
}

fn eqn_8_divides_by_the_time_since_impact_and_accelerates<S: Number>() {
    // t = 19/256, m_p = 7/32, T_y = −271.8125:
    // 387.5 − 2 × (−271.8125) × (19/256)/(7/32) = 387.5 + 543.625 × 19/56 = 387.5 + 184.444196428…
    // The division and the sum are rounded: half a unit each.
    let push = ProjectilePush {
        velocity: exact::<S>(387.5),
        tension_y: exact(-271.8125),
        mass: exact(0.21875),
        node_mass: exact(0.046875),
        time_step: exact(TIME_STEP),
        time: exact(0.07421875),
    };
    let got = Printed.eqn_8_projectile_velocity(push);
    assert_ulps(got, 571.944_196_428_571_44, 1.5);
}

fn theta<S: Number>() -> Direction<S> {
    Direction { cos: exact(0.8125), sin: exact(-0.59375) }
}

fn eqn_9_resolves_along_the_fibre<S: Number>() {
    // −11.25 × 0.8125 + 63.875 × −0.59375 = −9.140625 − 37.92578125, exact.
    let got = Printed.eqn_9_parallel_velocity(exact::<S>(-11.25), exact(63.875), theta());
    assert_ulps(got, -47.066_406_25, 0.5);
}

fn eqn_10_resolves_across_the_fibre<S: Number>() {
    // 63.875 × 0.8125 − (−11.25) × (−0.59375) = 51.8984375 − 6.6796875, exact.
    let got = Printed.eqn_10_perpendicular_velocity(exact::<S>(-11.25), exact(63.875), theta());
    assert_ulps(got, 45.218_75, 0.5);
}

fn eqn_11_is_the_inverse_tangent<S: Number>() {
    // tan⁻¹[(−0.265625 − 0.390625)/(0.84375 − 0.578125)] = tan⁻¹(−42/17) = −1.1861916119726831 rad.
    // cos = 17/√(17² + 42²) = 17/√2053, sin = −42/√2053.
    // The angle carries about one unit of 1: the ratio's rounding, damped by the tangent's slope,
    // and its own. Times sin = 0.93 that is 4 units of the cosine (0.25 to 0.5), times cos = 0.38 one
    // of the sine (0.5 to 1); half each for the last rounding and the literal.
    let got =
        Printed.eqn_11_direction(vector::<S, 2>(POSITION_AHEAD), vector::<S, 2>(POSITION_HERE));
    assert_ulps(got.cos, 0.375_192_757_733_183_17, 5.0);
    assert_ulps(got.sin, -0.926_946_813_223_158_42, 2.0);
}

fn eqn_12_slides_the_parallel_part<S: Number>() {
    // 0.71875 × −47.0625 × 0.8125 − 31.4375 × −0.59375 = −27.4837646484375 + 18.666015625, exact.
    let (slide, parallel, perpendicular) = (exact::<S>(0.71875), exact(-47.0625), exact(31.4375));
    let got = Printed.eqn_12_secondary_u(slide, parallel, perpendicular, theta());
    assert_ulps(got, -8.817_749_023_437_5, 0.5);
}

fn eqn_13_slides_the_parallel_part<S: Number>() {
    // 0.71875 × −47.0625 × −0.59375 + 31.4375 × 0.8125 = 20.08428955078125 + 25.54296875, exact.
    let (slide, parallel, perpendicular) = (exact::<S>(0.71875), exact(-47.0625), exact(31.4375));
    let got = Printed.eqn_13_secondary_v(slide, parallel, perpendicular, theta());
    assert_ulps(got, 45.627_258_300_781_25, 0.5);
}

fn eqn_14_is_zero<S: Number>() {
    assert_eq!(Paper::<S>::eqn_14_secondary_w(&Printed), S::zero());
}

fn secondary<S: Number>() -> Cosines<S> {
    Cosines { x: exact(0.34375), y: exact(-0.78125) }
}

fn primary<S: Number>() -> Cosines<S> {
    Cosines { x: exact(0.90625), y: exact(0.40625) }
}

fn eqn_15_adds_the_products_of_cosines<S: Number>() {
    // 640.125 × (0.34375 × 0.90625 + −0.78125 × 0.40625)
    //   = 640.125 × (0.3115234375 − 0.3173828125) = 640.125 × −0.005859375, exact.
    let got = Printed.eqn_15_parallel_tension(exact::<S>(640.125), secondary(), primary());
    assert_ulps(got, -3.750_732_421_875, 0.5);
}

fn eqn_16_subtracts_the_products_of_cosines<S: Number>() {
    // 640.125 × (0.3115234375 + 0.3173828125) = 640.125 × 0.62890625, exact.
    let got = Printed.eqn_16_perpendicular_tension(exact::<S>(640.125), secondary(), primary());
    assert_ulps(got, 402.578_613_281_25, 0.5);
}

fn push<S: Number>() -> CrossoverPush<S> {
    CrossoverPush {
        a: exact(A),
        slide_factor: exact(0.71875),
        perpendicular: exact(31.4375),
        parallel: exact(-47.0625),
        primary: primary(),
        change: vector([2.6875, -5.3125, 0.0]),
        mass: exact(0.140625),
        secondary_mass: exact(0.0859375),
    }
}

fn eqn_17_pushes_along_x<S: Number>() {
    // −11.25 + 2 × 0.34765625 × (31.4375 × 0.40625 + 0.71875 × −47.0625 × 0.90625)
    //   = −11.25 + 0.6953125 × (12.771484375 − 30.65496826171875)
    //   = −11.25 + 0.6953125 × −17.88348388671875 = −11.25 − 12.434609889984131
    // Exact in f64; in f32 the product and the sum are rounded.
    let got = Printed.eqn_17_u_at_crossover(exact::<S>(-11.25), push());
    assert_ulps(got, -23.684_609_889_984_131, 1.5);
}

fn eqn_18_pushes_along_y<S: Number>() {
    // 63.875 + 2 × 0.34765625 × (31.4375 × 0.90625 + 0.71875 × −47.0625 × 0.40625)
    //   = 63.875 + 0.6953125 × (28.490234375 − 13.74188232421875)
    //   = 63.875 + 0.6953125 × 14.74835205078125 = 63.875 + 10.254713535308838
    // Exact in f64; in f32 the product and the sum are rounded.
    let got = Printed.eqn_18_v_at_crossover(exact::<S>(63.875), push());
    assert_ulps(got, 74.129_713_535_308_838, 1.5);
}

fn eqn_19_squares_the_wave_speed<S: Number>() {
    // 6968.625² × −7/2048 = 48561734.390625 × −0.00341796875. Exact in f64; in f32 both products are
    // rounded, and the first, near the upper end of its binade, counts up to twice.
    let got = Printed.eqn_19_acceleration(exact::<S>(6968.625), exact(-0.00341796875));
    assert_ulps(got, -165_982.490_592_956_54, 2.0);
}

fn eqn_20_is_the_courant_number<S: Number>() {
    // 6968.625 × (3/256 ÷ 76.4375) = 6968.625 × 1.5331152902698283e-4. Quotient and product are
    // rounded; the quotient's half unit counts up to twice near 1.
    let got = Printed.eqn_20_courant(exact::<S>(6968.625), exact(TIME_STEP), exact(76.4375));
    assert_ulps(got, 1.068_370_553_965_658_3, 2.0);
}
