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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn root_and_exponential_are_right_in_all_quadrants() {
        // The square of a root, and e^z e^(−z) = 1 with an argument of Im z; roundings of a few
        // products.
        for (re, im) in [(1.7, 0.3), (0.3, -1.7), (-0.3, 1.7), (-1.7, -3e-9), (0.7, 0.0)] {
            let z = Complex::new(re, im);
            let root = square_root(z);
            assert!(root.re > 0.0 && (root * root - z).norm_sqr() < 1e-31 * z.norm_sqr(), "{z}");
            let (power, inverse) = (exponential(z), exponential(-z));
            assert!((power * inverse - 1.0).norm_sqr() < 1e-31, "{z}");
            assert!((power.im - pxfm::f_exp(re) * pxfm::f_sin(im)).abs() < 1e-15, "{z}");
        }
    }

    #[test]
    fn lag_and_its_slope_are_those_of_the_slowness() {
        // h = s(1/√e − 1), here with an e that is not near 1; the slope by a central difference of
        // step 1e-5 s, which is off by some 1e-10.
        let arms = [(7.3e9, 1.3e-5), (2.9e9, 2.7e-4)]
            .map(|(modulus, relaxation_time)| Arm { modulus, relaxation_time });
        let relaxation = Relaxation::new(1.1e9, &arms, 11.3e9);
        let lag = |s: f64| {
            let e = relaxation.modulus(Complex::from(s));
            relaxation.lag(Complex::from(s), e, square_root(e)).re
        };
        for s in [3.1e2, 7.7e3, 1.9e5] {
            let e = 1.1 / 11.3
                + 7.3 / 11.3 * s / (s + 1.0 / 1.3e-5)
                + 2.9 / 11.3 * s / (s + 1.0 / 2.7e-4);
            assert!((lag(s) / (s * (1.0 / e.sqrt() - 1.0)) - 1.0).abs() < 1e-13, "{s}");
            let slope = (lag(s * 1.00001) - lag(s * 0.99999)) / (2e-5 * s);
            assert!((relaxation.lag_slope(s) / slope - 1.0).abs() < 1e-8, "{s}");
        }
    }
}
