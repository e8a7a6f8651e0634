use f256::f256;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::*;

mod limits;
mod written;

/// The same number with 71 digits: exact while `lo` is not below 2⁻¹⁸⁰ of `hi`.
fn exact(x: DoubleDouble) -> f256 {
    f256::from(x.hi()) + f256::from(x.lo())
}

/// Relative error in units of u² = 2⁻¹⁰⁶.
fn error(got: DoubleDouble, expected: f256) -> f64 {
    if expected == f256::from(0.0) {
        return if got.is_zero() { 0.0 } else { f64::INFINITY };
    }
    let u_squared = f256::from(power_of_two(-106));
    let units = (exact(got) - expected) / expected / u_squared;
    // To a thousandth of a unit; beyond a thousand units all errors are the same.
    let least = f256::from(1000.0);
    let units = if units.abs() < least { units } else { least };
    let thousandths = i64::try_from(&(units * f256::from(1000.0)).round()).unwrap();
    thousandths.abs() as f64 / 1000.0
}

#[track_caller]
fn assert_within(units: f64, got: DoubleDouble, expected: f256, what: &str) {
    let error = error(got, expected);
    assert!(error <= units, "{what} gave {got}: {error} u², allowed {units}");
}

/// So many random cases; a failing one is printed, and kept by writing a test of it.
fn cases(cases: u32) -> Config {
    Config { cases, failure_persistence: None, ..Config::default() }
}

/// Bounds in u²: of sum, product and root those that are proven; of a quotient and the functions
/// half a unit more than the greatest error found in 150 000 arguments of either range.
const SUM: f64 = 3.0;
const PRODUCT: f64 = 5.0;
const QUOTIENT: f64 = 2.5;

/// A function of one number here and with 71 digits, the binary exponents of its arguments, whether
/// they may be negative, and the bound of its error in u².
struct Function {
    name: &'static str,
    here: fn(DoubleDouble) -> DoubleDouble,
    there: fn(&f256) -> f256,
    exponents: std::ops::Range<i32>,
    negative: bool,
    bound: f64,
}
const FUNCTIONS: [Function; 8] = [
    Function {
        name: "sqrt",
        here: DoubleDouble::sqrt,
        there: |x| x.sqrt(),
        exponents: -900..1023,
        negative: false,
        bound: 3.125,
    },
    Function {
        name: "sin",
        here: DoubleDouble::sin,
        there: f256::sin,
        exponents: -120..50,
        negative: true,
        bound: 2.7,
    },
    Function {
        name: "cos",
        here: DoubleDouble::cos,
        there: f256::cos,
        exponents: -60..50,
        negative: true,
        bound: 2.6,
    },
    Function {
        name: "atan",
        here: DoubleDouble::atan,
        there: f256::atan,
        exponents: -120..120,
        negative: true,
        bound: 2.8,
    },
    Function {
        name: "exp",
        here: DoubleDouble::exp,
        there: f256::exp,
        exponents: -60..9,
        negative: true,
        bound: 1.7,
    },
    Function {
        name: "ln",
        here: DoubleDouble::ln,
        there: f256::ln,
        exponents: -900..1023,
        negative: false,
        bound: 2.4,
    },
    Function {
        name: "exp_m1",
        here: DoubleDouble::exp_m1,
        there: f256::exp_m1,
        exponents: -120..9,
        negative: true,
        bound: 2.7,
    },
    Function {
        name: "ln_1p",
        here: DoubleDouble::ln_1p,
        there: f256::ln_1p,
        exponents: -120..200,
        negative: false,
        bound: 3.2,
    },
];

/// Numbers of random digits, with and without a gap or nothing at all in their second part, their
/// exponents from a range.
fn numbers(exponents: std::ops::Range<i32>, negative: bool) -> impl Strategy<Value = DoubleDouble> {
    let second = prop_oneof![
        6 => (-0.5..0.5).boxed(),
        1 => Just(0.0).boxed(),
        2 => (-0.5..0.5, 0..60).prop_map(|(t, gap): (f64, i32)| t * power_of_two(-gap)).boxed(),
    ];
    (exponents, 1.0..2.0, second, any::<bool>()).prop_map(move |(exponent, hi, second, minus)| {
        let x = DoubleDouble::new(hi, second * f64::EPSILON).scaled(power_of_two(exponent));
        if minus && negative { -x } else { x }
    })
}

#[test]
fn every_function_has_the_digits_that_it_promises() {
    for function in &FUNCTIONS {
        // Of all its exponents, and near one, where its branches meet.
        for exponents in [function.exponents.clone(), -3..3] {
            let numbers = numbers(exponents, function.negative);
            let test = |x| {
                let expected = (function.there)(&exact(x));
                assert_within(function.bound, (function.here)(x), expected, function.name);
                Ok(())
            };
            TestRunner::new(cases(1000)).run(&numbers, test).unwrap();
        }
    }
}

fn assert_operations(x: DoubleDouble, y: DoubleDouble) {
    let (a, b) = (exact(x), exact(y));
    assert_within(SUM, x + y, a + b, &format!("{x} + {y}"));
    assert_within(SUM, x - y, a - b, &format!("{x} - {y}"));
    assert_within(PRODUCT, x * y, a * b, &format!("{x} * {y}"));
    assert_within(QUOTIENT, x / y, a / b, &format!("{x} / {y}"));
}

proptest! {
    #![proptest_config(cases(4000))]

    #[test]
    fn every_operation_has_the_digits_that_it_promises(
        x in numbers(-200..200, true),
        y in numbers(-200..200, true),
        near in numbers(-2..2, true),
    ) {
        assert_operations(x, y);
        // Of like size, so that all digits of both matter; and next to itself, so that they cancel.
        assert_operations(x, x * near);
        assert_operations(x, x + x * near.scaled(power_of_two(-90)));
    }

    #[test]
    fn identities_hold_to_the_errors_of_their_parts(x in numbers(-3..3, true)) {
        let one = f256::from(1.0);
        // Each square has twice the 2.2 u² of the function and the 5 u² of a product, their sum 3 u².
        let squares = x.sin() * x.sin() + x.cos() * x.cos();
        assert_within(2.0 * 2.2 + 5.0 + 3.0, squares, one, "sin² + cos²");
        // A root's error doubles, and the product has its own.
        let size = Number::abs(x);
        assert_within(2.0 * 3.125 + 5.0, size.sqrt() * size.sqrt(), exact(size), "√²");
        // The exponential turns the error of |ln x| < 2.1, of which it is 1.9 u², into a relative one.
        assert_within(2.1 * 1.9 + 1.2, size.ln().exp(), exact(size), "exp ln");
        // (1 + x) ln(1 + x) / x < 2.5 of the 2.7 u² of the logarithm.
        assert_within(2.5 * 2.7 + 2.2, size.ln_1p().exp_m1(), exact(size), "exp_m1 ln_1p");
        // The tangent t has 2.2 u² twice and the quotient's 1.9; t/((1 + t²) arctan t) ≤ 1 of them.
        let angle = size * DoubleDouble::from_f64(0.19);
        let tangent = angle.sin() / angle.cos();
        assert_within(2.0 * 2.2 + 1.9 + 2.3, tangent.atan(), exact(angle), "atan tan");
    }
}
