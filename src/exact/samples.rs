//! Laws that the tests of waves share. Densities and coefficients are of the order of a stiff
//! fibre's; the reference values of the tests are for the doubles written here.

use proptest::prelude::*;

use super::elastic::Elastic;
use super::exponential::Exponential;
use super::polynomial::Polynomial;

/// kg/m³.
pub(super) const DENSITY: f64 = 1371.3;

fn polynomial(coefficients: &[f64]) -> Polynomial {
    Polynomial::new(DENSITY, coefficients).unwrap()
}

/// Concave throughout.
pub(super) fn softening() -> Polynomial {
    polynomial(&[58.6e9, -3.17e11])
}

/// Concave to ε = 0.0288, then convex.
pub(super) fn concave_convex() -> Polynomial {
    polynomial(&[61.7e9, -1.13e12, 1.31e13])
}

/// Convex to ε = 0.0388, then concave.
pub(super) fn convex_concave() -> Polynomial {
    polynomial(&[37.9e9, 1.27e12, -1.09e13])
}

/// Concave to ε = 0.0210, convex to 0.0530, then concave.
pub(super) fn twice_inflected() -> Polynomial {
    polynomial(&[61.3e9, -2.2263e12, 4.9333e13, -3.3333e14])
}

/// Convex.
pub(super) fn exponential_hardening() -> Exponential {
    Exponential::new(DENSITY, 1.913e9, 23.7).unwrap()
}

/// Concave.
pub(super) fn exponential_softening() -> Exponential {
    Exponential::new(DENSITY, -2.717e9, -19.3).unwrap()
}

/// The polynomial of modulus E₁ whose T″ has the given roots and sign at ε = 0, scaled so that T′
/// changes by at most `change`·E₁ on (0, 0.1).
pub(super) fn with_inflections(
    density: f64,
    modulus: f64,
    roots: &[f64],
    convex: bool,
    change: f64,
) -> Polynomial {
    // Lowest power first; an odd number of roots makes the product negative at 0.
    let mut curvature = vec![if convex == roots.len().is_multiple_of(2) { 1.0 } else { -1.0 }];
    for root in roots {
        let raised = [0.0].into_iter().chain(curvature.iter().copied());
        let scaled = curvature.iter().map(|c| -root * c).chain([0.0]);
        curvature = raised.zip(scaled).map(|(a, b)| a + b).collect();
    }
    let slope_change = |x: f64| {
        curvature
            .iter()
            .enumerate()
            .fold(0.0, |sum, (k, c)| sum + c * x.powi(k as i32 + 1) / (k + 1) as f64)
    };
    let greatest = (1..=1000).map(|i| slope_change(1e-4 * f64::from(i)).abs()).fold(0.0, f64::max);
    let scale = change * modulus / greatest;
    let higher = curvature.iter().enumerate().map(|(k, c)| scale * c / ((k + 1) * (k + 2)) as f64);
    let coefficients: Vec<f64> = [modulus].into_iter().chain(higher).collect();
    Polynomial::new(density, &coefficients).unwrap()
}

/// Polynomials of degree 2 to 6 with up to four inflections below ε = 0.1, where T′ > 0.
pub(super) fn any_polynomial() -> impl Strategy<Value = Polynomial> {
    let roots = prop::collection::vec(0.003..0.097_f64, 0..5);
    (317.0..7.3e3_f64, 1.7e6..2.3e11_f64, roots, any::<bool>(), 0.05..0.95_f64).prop_map(
        |(rho, e, roots, convex, change)| with_inflections(rho, e, &roots, convex, change),
    )
}

/// The last strain up to 0.1 that a law is tried at.
pub(super) fn last_strain(law: &impl Elastic) -> f64 {
    law.greatest_strain().min(0.0997)
}
