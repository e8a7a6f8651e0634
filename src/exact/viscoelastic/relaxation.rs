//! How the material relaxes, in the variable s of the Laplace transform.
//!
//! Moduli are in units of the glassy modulus E₀, so that with f_k = E_k/E₀ and a_k = 1/τ_k
//!
//! ```text
//! e(s) = Ê/E₀ = E∞/E₀ + Σ f_k s/(s + a_k)
//! c k(s) = s/√e = s + h(s)      h(s) = Σ f_k a_k s/(s + a_k) / (e + √e)
//! ```
//!
//! h is what relaxation adds to the exponent of an elastic wave. The form above comes from
//! s(1/√e − 1) by s(1 − e) = Σ f_k a_k s/(s + a_k); it keeps its digits where e → 1.

use nalgebra::Complex;

use super::Arm;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Relaxation {
    /// E∞/E₀.
    equilibrium: f64,
    /// (f_k, a_k).
    arms: Vec<(f64, f64)>,
}

impl Relaxation {
    pub fn new(equilibrium_modulus: f64, arms: &[Arm], glassy_modulus: f64) -> Self {
        let relative = |arm: &Arm| (arm.modulus / glassy_modulus, 1.0 / arm.relaxation_time);
        Self {
            equilibrium: equilibrium_modulus / glassy_modulus,
            arms: arms.iter().map(relative).collect(),
        }
    }

    /// No arms.
    pub fn is_elastic(&self) -> bool {
        self.arms.is_empty()
    }

    /// The largest a_k, 1/s: all singularities of the transforms lie in −a ≤ s ≤ 0.
    pub fn fastest_rate(&self) -> f64 {
        self.arms.iter().fold(0.0, |fastest, &(_, a)| fastest.max(a))
    }

    /// h(∞) = ½Σ f_k a_k, the decay of the front in the time x/c, 1/s.
    pub fn front_decay(&self) -> f64 {
        0.5 * self.arms.iter().map(|&(f, a)| f * a).sum::<f64>()
    }

    /// e(s).
    pub fn modulus(&self, s: Complex<f64>) -> Complex<f64> {
        self.arms.iter().fold(Complex::from(self.equilibrium), |e, &(f, a)| e + s / (s + a) * f)
    }

    /// h(s) for e = e(s) and √e.
    pub fn lag(&self, s: Complex<f64>, e: Complex<f64>, root: Complex<f64>) -> Complex<f64> {
        self.lost(s) / (e + root)
    }

    /// Σ f_k a_k s/(s + a_k) = s(1 − e).
    fn lost(&self, s: Complex<f64>) -> Complex<f64> {
        self.arms.iter().fold(Complex::from(0.0), |sum, &(f, a)| sum + s / (s + a) * (f * a))
    }

    /// h′(s) at real s > 0.
    pub fn lag_slope(&self, s: f64) -> f64 {
        let e = self.modulus(Complex::from(s)).re;
        let lost = self.lost(Complex::from(s)).re;
        let squared = |a: f64| (s + a) * (s + a);
        let e_slope = self.arms.iter().map(|&(f, a)| f * a / squared(a)).sum::<f64>();
        let lost_slope = self.arms.iter().map(|&(f, a)| f * a * a / squared(a)).sum::<f64>();
        let below = e + e.sqrt();
        let below_slope = e_slope * (1.0 + 0.5 / e.sqrt());
        (lost_slope - lost / below * below_slope) / below
    }
}

/// √z, the root of positive real part, by real square roots alone.
pub(super) fn square_root(z: Complex<f64>) -> Complex<f64> {
    let half = 0.5 * ((z.re * z.re + z.im * z.im).sqrt() + z.re.abs());
    let (larger, smaller) = (half.sqrt(), 0.5 * z.im.abs() / half.sqrt());
    let (re, im) = if z.re >= 0.0 { (larger, smaller) } else { (smaller, larger) };
    Complex::new(re, im.copysign(z.im))
}

/// eᶻ.
pub(super) fn exponential(z: Complex<f64>) -> Complex<f64> {
    let (sine, cosine) = pxfm::f_sincos(z.im);
    Complex::new(cosine, sine) * pxfm::f_exp(z.re)
}
