//! Numerical integration, the independent route by which the tests check the closed forms.

/// ∫ from `a` to `b` by the three-point Gauss rule on 256 panels.
///
/// The error of a panel of width h is h⁷ f⁽⁶⁾ / 2016000; for the smooth integrands here and
/// b − a ≤ 2 the sum is below 1e-16, so what remains is the rounding of 768 additions (about
/// 1e-14 relative at worst, 1e-15 as seen).
pub(super) fn integral(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    const PANELS: usize = 256;
    let half = (b - a) / (2 * PANELS) as f64;
    let node = half * 0.6_f64.sqrt();
    (0..PANELS)
        .map(|panel| {
            let middle = a + half * (2 * panel + 1) as f64;
            (5.0 * f(middle - node) + 8.0 * f(middle) + 5.0 * f(middle + node)) * (half / 9.0)
        })
        .sum()
}

#[test]
fn integral_of_a_known_function_is_found() {
    // ∫₀^b 1/(1+s)² ds = b/(1+b); tolerance: 768 roundings of an ulp, in practice a few.
    let b = 1.37;
    let error = integral(0.0, b, |s| 1.0 / ((1.0 + s) * (1.0 + s))) / (b / (1.0 + b)) - 1.0;
    assert!(error.abs() < 1e-14, "{error:e}");
}
