//! Awkward digits, infinities, the ends of the range, and arguments beside zeros.

use super::*;

/// Parts that make ties, long gaps and the widest second part that there is.
fn awkward() -> Vec<DoubleDouble> {
    let ulp = f64::EPSILON;
    let below_two = 2.0 - ulp;
    [
        (1.0, 0.0),
        (1.0, ulp / 2.0),
        (1.0, -ulp / 4.0),
        (1.0, power_of_two(-120)),
        (1.0 + ulp, ulp / 2.0),
        (1.0 + ulp, -ulp / 2.0 + power_of_two(-106)),
        (below_two, ulp / 2.0 - power_of_two(-106)),
        (below_two, -ulp / 2.0 + power_of_two(-106)),
        (1.0 / 3.0, 1.850371707708594e-17),
        (134_217_729.0, -3.7e-9),
        (-0.1, 5.551115123125783e-18),
    ]
    .into_iter()
    .flat_map(|(hi, lo)| {
        let x = DoubleDouble::new(hi, lo);
        [-301, 0, 299].map(|exponent| x.scaled(power_of_two(exponent)))
    })
    .collect()
}

#[test]
fn awkward_digits_are_no_worse() {
    for x in awkward() {
        for y in awkward() {
            assert_operations(x, y);
        }
        for function in &FUNCTIONS {
            let x = if function.negative { x } else { Number::abs(x) };
            // The ranges that `FUNCTIONS` promises.
            if x.hi().abs() < power_of_two(function.exponents.end) {
                let expected = (function.there)(&exact(x));
                assert_within(function.bound, (function.here)(x), expected, function.name);
            }
        }
    }
}

/// As `f64` has it: the same infinity or zero, or both undefined.
#[track_caller]
fn assert_like_double(got: DoubleDouble, double: f64, what: &str) {
    let like = if double.is_finite() && double != 0.0 {
        got.is_finite() && !got.is_zero()
    } else {
        got.hi() == double || got.hi().is_nan() && double.is_nan()
    };
    assert!(like && got.lo().is_finite(), "{what}: {got}, with doubles {double}");
    assert_eq!(got.is_finite(), double.is_finite(), "{what}");
}

#[test]
fn infinite_and_undefined_results_are_those_of_doubles() {
    let inf = f64::INFINITY;
    let numbers = [0.0, 1.0, 1.3, 0.71, 1.7e308, 3.1e-308, inf, f64::NAN].map(|x| [x, -x]);
    for x in numbers.into_iter().flatten() {
        let here = DoubleDouble::from_f64(x);
        for y in numbers.into_iter().flatten() {
            let and = DoubleDouble::from_f64(y);
            assert_like_double(here + and, x + y, &format!("{x} + {y}"));
            assert_like_double(here - and, x - y, &format!("{x} - {y}"));
            assert_like_double(here * and, x * y, &format!("{x} * {y}"));
            assert_like_double(here / and, x / y, &format!("{x} / {y}"));
        }
        assert_like_double(Number::sqrt(here), Number::sqrt(x), &format!("√{x}"));
        assert_like_double(here.atan(), Number::atan(x), &format!("atan {x}"));
        assert_like_double(here.exp(), Number::exp(x), &format!("exp {x}"));
        assert_like_double(here.ln(), Number::ln(x), &format!("ln {x}"));
        assert_like_double(here.exp_m1(), Number::exp_m1(x), &format!("exp_m1 {x}"));
        assert_like_double(here.ln_1p(), Number::ln_1p(x), &format!("ln_1p {x}"));
        if x.abs() < 1e15 || !x.is_finite() {
            assert_like_double(here.sin(), Number::sin(x), &format!("sin {x}"));
            assert_like_double(here.cos(), Number::cos(x), &format!("cos {x}"));
        }
    }
}

#[test]
fn an_overflow_stays_infinite_through_what_follows() {
    let mut x = DoubleDouble::new(-7.3, 1.3e-17);
    let mut double = x.hi();
    let mut steps = 0;
    while x.is_finite() {
        x = x * x * x + DoubleDouble::from_f64(0.3);
        double = double * double * double + 0.3;
        assert_eq!(x.is_finite(), double.is_finite());
        steps += 1;
    }
    // 7.3^(3ⁿ) reaches 2¹⁰²⁴ at 3ⁿ = 357: in the sixth step.
    assert_eq!(steps, 6);
    assert_eq!((x.hi(), x.lo()), (f64::NEG_INFINITY, 0.0));
    assert_eq!((x / DoubleDouble::from_f64(-2.7)).hi(), f64::INFINITY);
    // Neither the last scaling nor a given pair makes a second part of an infinity.
    for x in [DoubleDouble::new(731.3, 1.3e-14).exp(), DoubleDouble::new(f64::INFINITY, 1.3)] {
        assert_eq!((x.hi(), x.lo()), (f64::INFINITY, 0.0));
    }
}

#[test]
fn angles_too_great_to_be_reduced_are_undefined_and_not_guessed() {
    for x in [1.3e15, -4.7e200, f64::INFINITY].map(DoubleDouble::from_f64) {
        assert!(x.sin().hi().is_nan() && x.cos().hi().is_nan());
    }
    // The last that is reduced is 2⁵⁰; tolerance: a few roundings of 2⁻¹⁰⁵.
    let last = DoubleDouble::from_f64(power_of_two(50));
    let (sine, cosine) = (last.sin(), last.cos());
    let off = sine * sine + cosine * cosine - DoubleDouble::one();
    assert!(off.hi().abs() < 8.0 * power_of_two(-105), "{off}");
}

#[test]
fn digits_are_kept_next_to_overflow() {
    // Here (2²⁷ + 1) × a, a product of halves, or the first digit of a quotient times its divisor
    // would overflow, but not the result.
    let greatest = DoubleDouble::new(f64::MAX, 9.9e291);
    let [third, three, small] = [(0.3, 1.3e-17), (3.0, -1.7e-16), (7.1e-290, 1.1e-306)]
        .map(|(hi, lo)| DoubleDouble::new(hi, lo));
    for x in [greatest, greatest * third, greatest.scaled(0.125)] {
        assert_operations(x.scaled(0.25), third);
        assert_operations(third, x.scaled(power_of_two(-200)));
        assert_within(QUOTIENT, x / three, exact(x) / exact(three), "huge/3");
        assert_within(PRODUCT, x * small, exact(x) * exact(small), "huge × small");
        assert_within(QUOTIENT, x / -x, f256::from(-1.0), "huge/huge");
        assert_within(3.125, x.sqrt(), exact(x).sqrt(), "√huge");
        assert_within(2.4, x.ln(), exact(x).ln(), "ln huge");
    }
    let root = DoubleDouble::new(1.3407807929942596e154, -5.1e137);
    assert_within(PRODUCT, root * root, exact(root) * exact(root), "nearly infinite square");
    let x = DoubleDouble::new(709.78, 3.1e-14);
    assert_within(1.7, x.exp(), exact(x).exp(), "exp 709.78");
    assert_within(2.7, x.exp_m1(), exact(x).exp_m1(), "exp_m1 709.78");
}

/// Absolute error in units of the smallest double.
fn smallest_units(got: DoubleDouble, expected: f256) -> f64 {
    // 2⁻¹⁰⁷⁴ is to 2⁻⁹⁶⁸ as 2⁻¹⁰⁶, in which `error` counts, is to 1.
    let difference = (exact(got) - expected) * f256::from(power_of_two(968));
    error(DoubleDouble::one(), f256::from(1.0) + difference)
}

#[test]
fn digits_are_kept_to_the_stated_size_and_below_it_to_the_smallest_double() {
    let [x, y] = [(1.7, 1.1e-16), (1.3, -9.7e-17)].map(|(hi, lo)| DoubleDouble::new(hi, lo));
    for exponent in [-400, -480, -484, -490, -520, -530, -536] {
        let [a, b] = [x, y].map(|x| x.scaled(power_of_two(exponent)));
        let (product, expected) = (a * b, exact(a) * exact(b));
        if product.hi() >= power_of_two(-968) {
            assert_within(PRODUCT, product, expected, "small product");
        }
        // Half a unit for each of the low parts of the product, and for the two parts of the result.
        let apart = smallest_units(product, expected);
        let allowed = f64::max(3.0, 5.0 * product.hi() * power_of_two(484).powi(2));
        assert!(apart <= allowed, "2^{exponent}: {apart}");
        // The quotient is not small, and the product of its digits with the divisor not either.
        let [a, b] = [x, y].map(|x| x.scaled(power_of_two(exponent - 400)));
        assert_operations(a, b.scaled(power_of_two(400 - exponent)));
    }
    let x = DoubleDouble::new(-727.3, 3.1e-14);
    // The last scaling rounds each part to the smallest double.
    assert!(smallest_units(x.exp(), exact(x).exp()) <= 1.0, "{}", x.exp());
    // Sums of the smallest numbers are exact, and their logarithms keep their digits.
    let x = DoubleDouble::from_f64(3.7e-320);
    assert_eq!((x + x - x).hi(), 3.7e-320);
    assert_within(2.4, x.ln(), exact(x).ln(), "ln 3.7e-320");
    assert_within(0.0, x.sin(), exact(x), "sin 3.7e-320");
    assert_within(0.0, x.exp_m1(), exact(x), "exp_m1 3.7e-320");
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn digits_are_kept_beside_zeros_and_limits(
        small in numbers(-106..-2, true),
        quarters in 1..1_000_000_000_000_i64,
    ) {
        let one = DoubleDouble::one();
        let x = one + small;
        assert_within(2.4, x.ln(), exact(x).ln(), "ln beside 1");
        assert_within(2.8, x.atan(), exact(x).atan(), "atan beside 1");
        // By the logarithm: `f256::ln_1p`, version 0.11.3, gives NaN at −1 + 2.5e-25.
        let x = Number::abs(small) - one;
        let sum = exact(x) + f256::from(1.0);
        assert_within(3.2, x.ln_1p(), sum.ln(), "ln_1p beside −1");
        // The number nearest to a multiple of π/2: all of its digits cancel.
        let right_angle = one.atan() + one.atan();
        let x = right_angle * DoubleDouble::from_f64(quarters as f64);
        assert_within(2.7, x.sin(), exact(x).sin(), "sin beside k π/2");
        assert_within(2.6, x.cos(), exact(x).cos(), "cos beside k π/2");
    }
}
