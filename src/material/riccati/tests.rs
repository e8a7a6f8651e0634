use approx::assert_relative_eq;
use pxfm::{f_exp, f_log, f_log1p, f_tanh};

use super::*;

/// y₀, a, b, y₁, dy₁/db: decay and drive of all sizes, y through zero, stiff and hardly flowing.
///
/// From the closed form to 60 digits or more in another language; where that language could, checked
/// to 30 digits against ∫ dy/(b − a sinh y) = 1.
const CASES: [(f64, f64, f64, f64, f64); 18] = [
    (1.7, 0.83, 0.0, 0.6219863350351864, 0.5916926226156007),
    (2.3, 0.91, 1.31, 1.3173917275149367, 0.4270425293093923),
    (2.3, 0.91, -7.3, -2.717910925448864, 0.18377753595964466),
    (-1.9, 3.7, 0.6, 0.1199566097363937, 0.26086718391377356),
    (0.0, 5.3, 2.9, 0.5216133675990834, 0.16565713409971197),
    (1.3e-09, 2.7e-12, 3.1e-12, 1.303099999996486e-09, 0.99999999999865),
    (0.73, 1.7e-12, 0.0, 0.7299999999986457, 0.9999999999989133),
    (3.1e-07, 37.3, 0.0, 1.9596455193197733e-23, 0.02680965147453083),
    (41.3, 2.7e-12, 0.0, 27.330915665840354, 0.5000004288187443),
    (41.3, 2.7e-12, 3.9, 28.71234259371379, 0.235750197627583),
    (913.7, 1.3e-12, -0.37, 27.871106358753096, 0.5307632104743549),
    (913.7, 410000000000.0, 0.0, 0.0, 2.4390243902439026e-12),
    (17.3, 6100.0, 611.0, 0.0999971984255418, 0.00016311820111251875),
    (-23.9, 1.9e-12, 1700.0, 35.12069794036041, 0.000588235294117647),
    (6.7, 3.3e-05, -2.9e-09, 6.686684369362086, 0.9933862962620941),
    (0.37, 1100000000000.0, -23000.0, -2.0909090909090907e-08, 9.090909090909089e-13),
    (12.7, 0.0, -19.3, -6.600000000000001, 1.0),
    (61.37, 6.61e-12, -7.59e-12, 26.4355846426211, 0.5000000000006328),
];

/// Classical Runge–Kutta of order 4.
fn runge_kutta(mut y: f64, a: f64, b: f64, steps: u32) -> f64 {
    let h = 1.0 / f64::from(steps);
    let f = |y: f64| b - a * (f_exp(y) - f_exp(-y)) / 2.0;
    for _ in 0..steps {
        let k1 = f(y);
        let k2 = f(y + h / 2.0 * k1);
        let k3 = f(y + h / 2.0 * k2);
        let k4 = f(y + h * k3);
        y += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    y
}

#[test]
fn all_sizes_agree_with_60_digits() {
    // Three roundings of the greatest number that y₁ is made of: y₁ itself, or, where y goes through
    // zero, what is left of y₀ (1 − t₀² …) after the drive has been taken from it.
    for (y, a, b, expected, _) in CASES {
        for sign in [1.0, -1.0] {
            let found = sign * advance(sign * y, a, sign * b);
            let through_zero = if y * b < 0.0 { 4e-16 * y.abs().min(b.abs()) } else { 0.0 };
            let tolerance = 8e-16 * expected.abs() + through_zero;
            let error = (found - expected).abs();
            assert!(error <= tolerance, "{y} {a} {b}: {found:e} {expected:e} {error:e}");
        }
    }
}

#[test]
fn single_precision_agrees_with_double_over_the_whole_range() {
    // Against the double result at the same inputs, so its own error is only that of the functions:
    // four roundings of 6e-8, of y₁ or, where y goes through zero, of what is taken from y₀.
    let sizes = [0.0, 3.7e-9, 2.9e-4, 0.061, 0.73, 2.3, 17.9, 97.3, 1.3e3];
    let flows = [1.7e-12, 3.1e-7, 4.3e-3, 0.57, 1.9, 23.0, 7.1e3, 1.3e12];
    let mut cases = 0;
    for (y, a, b) in sizes
        .iter()
        .flat_map(|y| flows.iter().map(move |a| (y, a)))
        .flat_map(|(&y, &a)| sizes.iter().flat_map(move |&b| [(y, a, b), (y, a, -b)]))
    {
        let (y, a, b) = (y as f32, a as f32, b as f32);
        let expected = advance(f64::from(y), f64::from(a), f64::from(b));
        let found = f64::from(advance(y, a, b));
        let through_zero = if b < 0.0 { 2.4e-7 * f64::from(y.min(-b)) } else { 0.0 };
        let error = (found - expected).abs();
        let least = f64::from(f32::MIN_POSITIVE);
        assert!(
            error <= 2.4e-7 * expected.abs() + through_zero + least,
            "{y} {a} {b}: {found:e} {expected:e}"
        );
        cases += 1;
    }
    assert_eq!(cases, 9 * 8 * 18);
}

#[test]
fn solution_is_that_of_the_differential_equation() {
    // Order 4 with 4000 steps: h⁴ times a fifth derivative of order a⁵ sinh⁵ leaves 1e-12 here.
    for (y, a, b) in [(2.7, 0.41, 3.9), (-1.3, 1.9, 2.3), (0.29, 2.1, -0.57), (3.1, 0.73, -5.3)] {
        let expected = runge_kutta(y, a, b, 4000);
        assert_relative_eq!(advance(y, a, b), expected, epsilon = 0.0, max_relative = 2e-12);
    }
}

#[test]
fn without_drive_the_hyperbolic_tangent_of_the_half_decays_exponentially() {
    // Tolerance: the arctangent's derivative 1/(1 − t²) is 10 at y₀ = 3.7; a few roundings each.
    for (y, a) in [(3.7, 0.083), (-2.9, 0.57), (0.031, 4.3)] {
        let t = f_tanh(y / 2.0) * f_exp(-a);
        let expected = f_log1p(2.0 * t / (1.0 - t));
        assert_relative_eq!(advance(y, a, 0.0), expected, epsilon = 0.0, max_relative = 8e-15);
    }
}

#[test]
fn two_halves_of_a_step_make_the_whole() {
    // The flow of a differential equation is a semigroup. Tolerance: the roundings of three steps,
    // where none of them goes through zero.
    for (y, a, b) in [(11.3, 0.37, 5.9), (0.17, 1.3e3, 170.0), (-0.003, 0.061, -0.0029)] {
        let halves = advance(advance(y, a / 2.0, b / 2.0), a / 2.0, b / 2.0);
        assert_relative_eq!(advance(y, a, b), halves, epsilon = 0.0, max_relative = 2e-15);
    }
}

#[test]
fn from_any_height_flow_comes_down_to_the_same() {
    // y₀ → ∞: exp(y₁) = (1 + q)/(1 − q), q = exp(−a), and ln of it in a few roundings.
    for a in [1.3e-12, 3.7e-4, 0.29, 2.3] {
        let q = f_exp(-a);
        let expected = f_log((1.0 + q) / -pxfm::f_expm1(-a));
        for y in [1.1e3, 7.7e7] {
            assert_relative_eq!(advance(y, a, 0.0), expected, epsilon = 0.0, max_relative = 2e-15);
        }
    }
}

#[test]
fn numbers_that_vanish_leave_an_elastic_arm_within_the_bound_of_steady_flow() {
    // Nothing flows and nothing is driven.
    assert_eq!(advance(7.3, 0.0, 0.0), 7.3);
    // a below the least number: elastic. exp(−y₀) is zero for the first and the last.
    assert_eq!(advance(811.0, 0.0, 3.25), 814.25);
    assert_eq!(advance(-31.0, 0.0, -1700.5), -1731.5);
    assert_eq!(advance(131.0_f32, 0.0, 3.25), 134.25);
    // A flow of 1e-300 lets y grow to asinh(b/a) = ln(2b/a); N and D underflow on the way down.
    let steady = f_log(2.0 * 2900.0) + 300.0 * f_log(10.0);
    for (y, b) in [(3.1, 2900.0), (811.0, -2900.0), (-811.0, 2900.0)] {
        let found = advance(y, 1e-300, b);
        assert_relative_eq!(found.abs(), steady, epsilon = 0.0, max_relative = 1e-13);
        assert_eq!(found > 0.0, b > 0.0);
    }
}

#[test]
fn what_is_above_steady_flow_comes_down_to_it() {
    // From the closed form to 60 digits in another language, with a the least number. Tolerance:
    // ln 2 next to steady flow would be 9e-4 of it; the last is a tenth of that from it.
    let least = f64::from_bits(1);
    for (y, b, expected) in [
        (745.9, 4.7, 746.6700777699857),
        (760.3, 4.7, 746.689918491145),
        (760.3, -4.7, 741.9899172742634),
        (759.3, 3.1, 746.3107165711688),
        (747.3, -1497.0, -749.6431599329918),
    ] {
        for sign in [1.0, -1.0] {
            let found = sign * advance(sign * y, least, sign * b);
            assert_relative_eq!(found, expected, epsilon = 0.0, max_relative = 1.2e-4);
        }
    }
}

#[test]
fn slope_agrees_with_difference_quotients_of_2600_digits() {
    // Of the closed form, in another language. Tolerance: some ten roundings, but of ∂N/∂b and
    // ∂D/∂b, which can be opposite and several times their sum.
    for (y, a, b, _, expected) in CASES {
        assert_relative_eq!(slope(y, a, b), expected, epsilon = 0.0, max_relative = 4e-15);
        assert_relative_eq!(slope(-y, a, -b), expected, epsilon = 0.0, max_relative = 4e-15);
    }
}

#[test]
fn hyperbolic_sine_keeps_its_digits() {
    // To 40 digits in another language; tolerance: four roundings.
    for (y, expected) in [
        (3.1e-9, 3.1e-09),
        (0.37, 0.3785001420129849),
        (0.53, 0.5551636694700978),
        (17.3, 16302887.860497918),
    ] {
        assert_relative_eq!(sinh(y), expected, epsilon = 0.0, max_relative = 7e-16);
        assert_relative_eq!(sinh(-y), -expected, epsilon = 0.0, max_relative = 7e-16);
    }
    assert_eq!(sinh(1.3e3), f64::INFINITY);
}
