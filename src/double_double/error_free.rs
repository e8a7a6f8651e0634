//! Sums and products of doubles with the error that was made: a ∘ b = result + error, exactly.
//!
//! Exact unless a result overflows (the error is then NaN), or the error of a product falls below
//! the smallest double, 2⁻¹⁰⁷⁴.

/// a + b (Knuth 1969, "2Sum").
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// a + b where |a| ≥ |b| or a = 0 (Dekker 1971, "Fast2Sum").
#[inline(always)]
pub(super) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a × b (Dekker 1971), with no fused multiply-add.
#[inline(always)]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if a.abs().max(b.abs()).max(product.abs()) < SPLIT_OVERFLOWS {
        (product, product_error(a, b, product))
    } else {
        two_product_of_huge(a, b)
    }
}

/// From here on (2²⁷ + 1) × a, or a product of halves, might overflow where a × b does not.
const SPLIT_OVERFLOWS: f64 = power_of_two(990);

#[cold]
fn two_product_of_huge(a: f64, b: f64) -> (f64, f64) {
    const DOWN: f64 = power_of_two(-120);
    const UP: f64 = power_of_two(120);
    let (greater, smaller) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
    let greater = greater * DOWN;
    let product = greater * smaller;
    (product * UP, product_error(greater, smaller, product) * UP)
}

#[inline(always)]
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
}

/// Two halves of 26 bits with a = high + low (Veltkamp 1968).
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let spread = SPLITTER * a;
    let high = spread - (spread - a);
    (high, a - high)
}

/// 2^`exponent` for a normal double.
pub(super) const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
