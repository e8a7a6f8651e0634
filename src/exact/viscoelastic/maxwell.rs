//! The Maxwell rod: one arm, no spring.
//!
//! With b = 1/(2τ), X = x/c and c = √(E/ρ), k = √(s(s + 2b))/c, and for t ≥ X
//!
//! ```text
//! σ = ρcv₀ e^(−bt) I₀(b√(t² − X²))
//! v = v₀ [ e^(−bX) + ∫_X^t e^(−bt′) bX I₁(b√(t′² − X²))/√(t′² − X²) dt′ ]
//! ε = (σ + ∫_X^t σ dt′/τ)/E
//! ```
//!
//! The integrals are taken over y from 0 to arcosh(t/X), t′ = X cosh y, where
//! e^(−bt′) Iₙ(b√(t′² − X²)) = exp(−bX e⁻ʸ) [e⁻ᶻ Iₙ(z)] with z = bX sinh y: nothing overflows.

use super::super::gauss::integral;
use super::{RodError, RodState, not_negative, positive};

/// A long Maxwell rod, pulled at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Maxwell {
    /// ρ, kg/m³.
    pub density: f64,
    /// E, Pa.
    pub modulus: f64,
    /// τ, s.
    pub relaxation_time: f64,
    /// v₀, m/s; negative for a push.
    pub velocity: f64,
}

impl Maxwell {
    /// The state at x ≥ 0 (m) and t ≥ 0 (s). A front counts from the moment of its arrival.
    pub fn at(&self, x: f64, t: f64) -> Result<RodState, RodError> {
        positive("density", self.density)?;
        positive("modulus", self.modulus)?;
        positive("relaxation time", self.relaxation_time)?;
        not_negative("x", x)?;
        not_negative("t", t)?;
        let c = (self.modulus / self.density).sqrt();
        let b = 0.5 / self.relaxation_time;
        let path = x / c;
        if t < path {
            return Ok(RodState::REST);
        }
        let root = (t - path).sqrt() * (t + path).sqrt();
        // bt − b√(t² − X²), without the difference.
        let lag = if t > 0.0 { b * path * (path / (t + root)) } else { 0.0 };
        let stress = pxfm::f_exp(-lag) * pxfm::f_i0e(b * root);
        let relaxed = 2.0 * b * stress_integral(b, path, t);
        Ok(RodState {
            stress: self.density * c * self.velocity * stress,
            strain: self.velocity / c * (stress + relaxed),
            velocity: self.velocity * (pxfm::f_exp(-b * path) + slow_velocity(b, path, t)),
        })
    }
}

/// ∫_X^t e^(−bt′) I₀(b√(t′² − X²)) dt′, s.
fn stress_integral(b: f64, path: f64, t: f64) -> f64 {
    if path == 0.0 {
        return t * (pxfm::f_i0e(b * t) + pxfm::f_i1e(b * t));
    }
    integral(0.0, pxfm::f_acosh(t / path), &|y| {
        let root = path * pxfm::f_sinh(y);
        pxfm::f_exp(-b * path * pxfm::f_exp(-y)) * pxfm::f_i0e(b * root) * root
    })
}

/// What of v/v₀ comes after the front.
fn slow_velocity(b: f64, path: f64, t: f64) -> f64 {
    if path == 0.0 {
        return 0.0;
    }
    integral(0.0, pxfm::f_acosh(t / path), &|y| {
        let z = b * path * pxfm::f_sinh(y);
        b * path * pxfm::f_exp(-b * path * pxfm::f_exp(-y)) * pxfm::f_i1e(z)
    })
}
