//! Integration where a wave has no closed form.
//!
//! A rule of the library itself: the crates that offer one compute their nodes with the platform's
//! trigonometry, or bring a linear-algebra library along, and this one must give the same bits
//! everywhere.

/// Positive nodes and weights of the 12-point Gauss–Legendre rule on (−1, 1), to 20 digits, from
/// Newton's iteration on P₁₂ with 40 digits.
#[allow(clippy::excessive_precision)]
const RULE: [(f64, f64); 6] = [
    (0.125_233_408_511_468_915_47, 0.249_147_045_813_402_785_00),
    (0.367_831_498_998_180_193_75, 0.233_492_536_538_354_808_76),
    (0.587_317_954_286_617_447_30, 0.203_167_426_723_065_921_75),
    (0.769_902_674_194_304_687_04, 0.160_078_328_543_346_226_33),
    (0.904_117_256_370_474_856_68, 0.106_939_325_995_318_430_96),
    (0.981_560_634_246_719_250_69, 0.047_175_336_386_511_827_195),
];

/// Two halves agree with their whole when they differ by less than this part of the integral.
const AGREEMENT: f64 = 1e-12;

/// Halvings of one interval. A root-like end, √(x − a), needs 27.
const DEPTH: u32 = 40;

/// ∫ from `a` to `b` (either may be the greater) of a positive function.
///
/// The interval is halved until two halves together agree with their whole within 1e-12 of the
/// integral. Halving divides the error by at least 10³ where the nearest singularity is no nearer
/// than a quarter of an interval (by 2²⁴ where it is far), so less than 1e-15 is left, and rounding.
/// A singularity like √(x − a) at an end, where T′ = 0, leaves up to 4e-13; no wave from rest
/// within its law's greatest strain has one. A smaller difference would mistake the rounding of
/// the integrand for an error to be halved away.
pub(super) fn integral(a: f64, b: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let whole = rule(a, b, f);
    halved(a, b, f, whole, AGREEMENT * whole.abs(), DEPTH)
}

fn halved(a: f64, b: f64, f: &impl Fn(f64) -> f64, whole: f64, bound: f64, depth: u32) -> f64 {
    let middle = a + (b - a) / 2.0;
    let (first, second) = (rule(a, middle, f), rule(middle, b, f));
    let sum = first + second;
    if depth == 0 || (sum - whole).abs() <= bound || sum.is_nan() {
        return sum;
    }
    halved(a, middle, f, first, bound, depth - 1) + halved(middle, b, f, second, bound, depth - 1)
}

fn rule(a: f64, b: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let half = (b - a) / 2.0;
    let middle = a + half;
    half * RULE.iter().map(|(x, w)| w * (f(middle - half * x) + f(middle + half * x))).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rule_is_exact_for_the_highest_power_it_should_be() {
        // Degree 23 on (−1.3, 1.7): (1.7²⁴ − 1.3²⁴)/24; tolerance: rounding of 22 products.
        let power = |x: f64, n: i32| x.powi(n);
        let found = rule(-1.3, 1.7, &|x| power(x, 23));
        let expected = (power(1.7, 24) - power(1.3, 24)) / 24.0;
        assert!((found / expected - 1.0).abs() < 2e-14, "{found} {expected}");
    }

    #[test]
    fn integrand_with_a_root_at_its_end_is_found_in_both_directions() {
        // ∫₀^b √x dx = ⅔b√b: the worst that a fan can be, where T′ vanishes at its end. Tolerance:
        // the documented 4e-13 for such an end.
        let b = 0.731_f64;
        let expected = b * b.sqrt() / 1.5;
        for (found, sign) in
            [(integral(0.0, b, &|x| x.sqrt()), 1.0), (integral(b, 0.0, &|x| x.sqrt()), -1.0)]
        {
            assert!((sign * found / expected - 1.0).abs() < 4e-13, "{found} {expected}");
        }
    }

    /// The integral from `a` to `b`, and how often the integrand was asked.
    fn counted(a: f64, b: f64, f: impl Fn(f64) -> f64) -> (f64, u32) {
        let asked = std::cell::Cell::new(0);
        let found = integral(a, b, &|x| {
            asked.set(asked.get() + 1);
            assert!(asked.get() < 100_000, "no end is in sight");
            f(x)
        });
        (found, asked.get())
    }

    #[test]
    fn integral_that_does_not_exist_ends_after_forty_halvings() {
        // Of 1/x every halving leaves as much on its left as there was: one integral to the left
        // end and one more to the right of it at each depth, of which those to the right are done
        // at once. The sum from 2⁻⁴¹ to 1 is 41 ln 2, and the rule makes of the rest, whose integral
        // is infinite, a number between its 24 points and its first.
        let whole = 41.0 * std::f64::consts::LN_2;
        let rules = 1 + 2 * (DEPTH + 1) + 2 * DEPTH;
        let points = 2 * RULE.len() as u32;
        for (a, b, sign) in [(0.0, 1.0, 1.0), (1.0, 0.0, -1.0)] {
            let (found, asked) = counted(a, b, |x| 1.0 / x);
            assert!(whole < sign * found && sign * found < whole + 24.0, "{found}");
            assert_eq!(asked, points * rules);
        }
    }

    #[test]
    fn integrand_that_is_no_number_is_not_halved() {
        let (found, asked) = counted(0.0, 1.0, |_| f64::NAN);
        assert!(found.is_nan());
        assert_eq!(asked, 3 * 2 * RULE.len() as u32);
    }
}
