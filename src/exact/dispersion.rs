//! Waves, and growth, of the lumped leapfrog scheme on a uniform linear fibre.
//!
//! Eqns (2), (6) and (7) together are (u⁺ − 2u + u⁻)/Δt² = c²(u_{i+1} − 2u_i + u_{i−1})/Δx². A wave
//! exp(i(kjΔx − ωnΔt)) solves it where
//!
//! ```text
//! sin(ωΔt/2) = α sin(kΔx/2),   α = cΔt/Δx
//! ```
//!
//! and a single mode is multiplied by g in each step, g² − 2(1 − 2α² sin²(kΔx/2))g + 1 = 0.
//! Derivation and tests: `docs/exact/axial-and-dispersion.md`.

use pxfm::{f_asin, f_sin};

/// Angular frequency ω (rad/s), 0 ≤ ω ≤ π/Δt, of wave number k ≥ 0 (rad/m, kΔx ≤ π) at element
/// length Δx (m), time step Δt (s) and Courant number α > 0; `None` where the mode grows instead.
pub fn frequency(k: f64, dx: f64, dt: f64, alpha: f64) -> Option<f64> {
    half_phase(alpha, k * dx).map(|half| 2.0 * half / dt)
}

/// Phase speed of the scheme over that of the fibre, (ω/k)/c, at phase per element kΔx.
///
/// 1 in the limit of long waves, and at α = 1 for every wave; `None` where the mode grows.
pub fn phase_speed_ratio(alpha: f64, k_dx: f64) -> Option<f64> {
    if k_dx == 0.0 {
        return Some(1.0);
    }
    half_phase(alpha, k_dx).map(|half| 2.0 * half / (alpha * k_dx))
}

/// The larger |g| of the two roots: growth per step of a mode of phase kΔx per element.
///
/// 1 where a = α|sin(kΔx/2)| ≤ 1, else (a + √(a² − 1))². At a = 1 the roots coincide and the mode
/// grows in proportion to the number of steps: stable only in this weak sense. The highest mode
/// of the mesh is kΔx = π.
pub fn amplification(alpha: f64, k_dx: f64) -> f64 {
    let a = sine(alpha, k_dx).abs();
    if a <= 1.0 {
        return 1.0;
    }
    let root = a + ((a - 1.0) * (a + 1.0)).sqrt();
    root * root
}

/// α sin(kΔx/2).
fn sine(alpha: f64, k_dx: f64) -> f64 {
    alpha * f_sin(k_dx / 2.0)
}

/// ωΔt/2.
fn half_phase(alpha: f64, k_dx: f64) -> Option<f64> {
    let sine = sine(alpha, k_dx);
    (sine.abs() <= 1.0).then(|| f_asin(sine))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use pxfm::f_cos;

    use super::*;

    #[test]
    fn wave_of_the_stated_frequency_solves_the_difference_equation() {
        let (dx, dt) = (1.37e-3, 2.11e-7);
        for alpha in [0.31, 0.873, 1.0] {
            for k in [211.0, 1_103.0, 2_203.0] {
                let omega = frequency(k, dx, dt, alpha).unwrap();
                let u = |j: f64, n: f64| f_cos(k * j * dx - omega * n * dt + 0.371);
                let (j, n) = (3.0, 5.0);
                let time = u(j, n + 1.0) - 2.0 * u(j, n) + u(j, n - 1.0);
                let space = u(j + 1.0, n) - 2.0 * u(j, n) + u(j - 1.0, n);
                // Amplitude 1, four terms, phases of 15 rad rounded to 2e-15 each.
                assert!((time - alpha * alpha * space).abs() < 2e-14, "{alpha} {k}");
            }
        }
    }

    #[test]
    fn every_wave_has_the_right_speed_at_courant_number_one() {
        for k_dx in [1.3e-7, 0.37, 1.91, 3.07] {
            let ratio = phase_speed_ratio(1.0, k_dx).unwrap();
            // asin(sin θ) near π/2 magnifies an ulp by 1/cos θ, 28 at 3.07.
            assert!((ratio - 1.0).abs() < 2e-15, "{k_dx}: {ratio}");
        }
        // The highest mode as well, ωΔt = π.
        assert_eq!(phase_speed_ratio(1.0, PI), Some(1.0));
        assert_eq!(phase_speed_ratio(0.731, 0.0), Some(1.0));
    }

    #[test]
    fn long_waves_lag_by_the_second_order_term() {
        // (ω/k)/c = 1 − (1 − α²)(kΔx)²/24 + O((kΔx)⁴); the next term is below (kΔx)⁴/1920·4.
        for alpha in [0.31, 0.873] {
            let k_dx = 0.0371;
            let lag = 1.0 - phase_speed_ratio(alpha, k_dx).unwrap();
            let leading = (1.0 - alpha * alpha) * k_dx * k_dx / 24.0;
            assert!((lag / leading - 1.0).abs() < k_dx * k_dx, "{alpha}: {lag:e} {leading:e}");
        }
    }

    #[test]
    fn frequency_and_phase_speed_agree_and_end_where_growth_begins() {
        let (dx, dt, alpha) = (1.37e-3, 2.11e-7, 1.0173);
        // α sin(kΔx/2) = 1 by hand: kΔx = 2 asin(1/α).
        let edge = 2.0 * f_asin(1.0 / alpha);
        for (k_dx, grows) in [(0.999 * edge, false), (1.001 * edge, true), (PI, true)] {
            let omega = frequency(k_dx / dx, dx, dt, alpha);
            let ratio = phase_speed_ratio(alpha, k_dx);
            assert_eq!((omega.is_none(), ratio.is_none()), (grows, grows), "{k_dx}");
            assert_eq!(amplification(alpha, k_dx) > 1.0, grows, "{k_dx}");
            if let (Some(omega), Some(ratio)) = (omega, ratio) {
                let speed = omega / (k_dx / dx) / (alpha * dx / dt);
                // Five roundings, magnified by 1/cos(ωΔt/2) = 20.
                assert!((speed / ratio - 1.0).abs() < 2e-14, "{speed} {ratio}");
            }
        }
    }

    #[test]
    fn amplification_is_the_growth_of_a_marched_mode() {
        for (alpha, k_dx) in [(1.0037, PI), (1.0173, PI), (1.31, 2.03)] {
            let b = 1.0 - alpha * alpha * (1.0 - f_cos(k_dx));
            // u⁺ = 2bu − u⁻, in units of u, until the decaying root is gone: (g₂/g₁)^400 < 1e-50.
            let (mut before, mut now) = (0.0, 1.0);
            for _ in 0..400 {
                (before, now) = (1.0, 2.0 * b - before / now);
            }
            let marched = now.abs();
            let found = amplification(alpha, k_dx);
            // b is rounded, and g magnifies it by 1/√(b² − 1) = 8.
            assert!((found / marched - 1.0).abs() < 1e-14, "{alpha}: {found} {marched}");
            // The product of the roots is 1.
            let g = -found;
            assert!((g * g - 2.0 * b * g + 1.0).abs() < 1e-14 * g * g, "{alpha}: {g}");
        }
        for (alpha, k_dx) in [(0.97, PI), (1.0, PI), (1.31, 0.83)] {
            assert_eq!(amplification(alpha, k_dx), 1.0);
        }
    }
}
