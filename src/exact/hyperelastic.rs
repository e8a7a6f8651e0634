//! The two elastic laws that have closed forms, and their stored energy.
//!
//! Notation: λ stretch (deformed over reference length), ε = λ − 1 engineering strain, T nominal
//! tension (force per reference area, Pa), E modulus (Pa), ρ reference density (kg/m³),
//! c = √(E/ρ). Everything is a function of ε, not of λ: at the strains of a slow impact (1e-9)
//! λ would keep seven digits of it.

use pxfm::{f_expm1, f_log1p, f_log1pmx};

/// How the tension depends on the stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// T = E(λ − 1): eqn (7) with engineering strain.
    Engineering,
    /// T = E ln λ: what eqns (4) and (7) tend to as the time step tends to zero.
    Logarithmic,
}

/// One deformation in both measures of strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strain {
    /// Engineering strain λ − 1.
    pub engineering: f64,
    /// Logarithmic strain ln λ.
    pub logarithmic: f64,
}

impl Strain {
    /// The deformation of engineering strain ε > −1.
    pub fn from_engineering(strain: f64) -> Self {
        Self { engineering: strain, logarithmic: f_log1p(strain) }
    }

    /// The deformation of logarithmic strain e.
    pub fn from_logarithmic(strain: f64) -> Self {
        Self { engineering: f_expm1(strain), logarithmic: strain }
    }

    /// Stretch λ.
    pub fn stretch(self) -> f64 {
        1.0 + self.engineering
    }
}

impl Law {
    /// T/E, which is the law's own measure of strain: λ − 1 or ln λ.
    pub fn tension(self, strain: Strain) -> f64 {
        match self {
            Self::Engineering => strain.engineering,
            Self::Logarithmic => strain.logarithmic,
        }
    }

    /// √(T′(λ)/ρ)/c: the Lagrangian speed of a small longitudinal wave; 1 or 1/√λ.
    ///
    /// It does not grow with λ (the law is linear or concave), so a tensile front spreads and
    /// never becomes a shock.
    pub fn longitudinal_speed(self, strain: Strain) -> f64 {
        match self {
            Self::Engineering => 1.0,
            Self::Logarithmic => 1.0 / strain.stretch().sqrt(),
        }
    }

    /// W/c with W = ∫₁^λ √(T′(s)/ρ) ds, the particle velocity that a longitudinal wave of this
    /// strain gives to fibre at rest; ε, or 2(√λ − 1) = 2ε/(√λ + 1).
    pub fn particle_velocity(self, strain: Strain) -> f64 {
        match self {
            Self::Engineering => strain.engineering,
            Self::Logarithmic => 2.0 * strain.engineering / (strain.stretch().sqrt() + 1.0),
        }
    }

    /// The inverse of [`Law::particle_velocity`]: ε = w, or λ = (1 + w/2)².
    pub fn strain_at_particle_velocity(self, w: f64) -> Strain {
        Strain::from_engineering(self.strain_added(0.0, w))
    }

    /// What a further d adds to the engineering strain at w of the same wave:
    /// d, or (1 + (w + d)/2)² − (1 + w/2)² = d(1 + w/2 + d/4).
    pub(super) fn strain_added(self, w: f64, d: f64) -> f64 {
        match self {
            Self::Engineering => d,
            Self::Logarithmic => d * (1.0 + w / 2.0 + d / 4.0),
        }
    }

    /// Stored energy per reference volume over E, ψ = ∫₁^λ T(s)/E ds.
    ///
    /// ½ε² for the engineering law. For T = E ln λ, with e = ln λ, (e − 1)exp(e) + 1, which is
    /// written ε² + λ(ln λ − ε) because the first form loses all digits as e → 0; ½e² is not the
    /// energy of that law.
    pub fn stored_energy(self, strain: Strain) -> f64 {
        let epsilon = strain.engineering;
        match self {
            Self::Engineering => epsilon * epsilon / 2.0,
            Self::Logarithmic => epsilon * epsilon + strain.stretch() * f_log1pmx(epsilon),
        }
    }

    /// The largest engineering strain at which a transverse kink is not faster than the slowest
    /// longitudinal wave, √(T/(ρλ)) ≤ √(T′/ρ): no limit, or ln λ = 1.
    pub fn largest_kinked_strain(self) -> f64 {
        match self {
            Self::Engineering => f64::MAX,
            Self::Logarithmic => std::f64::consts::E - 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::integral;
    use super::*;

    const LAWS: [Law; 2] = [Law::Engineering, Law::Logarithmic];

    #[test]
    fn stored_energy_is_the_integral_of_tension_over_stretch() {
        for law in LAWS {
            for epsilon in [-0.37, 0.014_534, 0.113, 1.69] {
                let strain = Strain::from_engineering(epsilon);
                let expected = integral(0.0, epsilon, |s| law.tension(Strain::from_engineering(s)));
                // Rounding of 768 additions (see `integral`), and a threefold cancellation in ψ.
                let error = law.stored_energy(strain) / expected - 1.0;
                assert!(error.abs() < 2e-15 * 4.0, "{law:?} {epsilon}: {error:e}");
            }
        }
    }

    #[test]
    fn stored_energy_keeps_its_digits_at_small_strain() {
        // ψ = e²(1/2 + e/3 + e²/8 + e³/30 + …), the series of (e − 1)exp(e) + 1; the first term
        // left out is e⁴/144, below 1e-18 of the sum. Tolerance: three roundings and cancellation.
        for e in [-3.1e-5, 1.7e-12, 4.3e-9, 2.9e-5] {
            let series = e * e * (0.5 + e / 3.0 + e * e / 8.0 + e * e * e / 30.0);
            let energy = Law::Logarithmic.stored_energy(Strain::from_logarithmic(e));
            let error = energy / series - 1.0;
            assert!(error.abs() < 2e-15, "{e:e}: {error:e}");
        }
    }

    #[test]
    fn stored_energy_is_the_printed_expression_where_that_has_digits() {
        // (e − 1)exp(e) + 1 loses a factor of about 2/e² of an ulp: 12 at e = 0.41.
        for e in [0.41, 0.83] {
            let printed = (e - 1.0) * pxfm::f_exp(e) + 1.0;
            let energy = Law::Logarithmic.stored_energy(Strain::from_logarithmic(e));
            assert!((energy / printed - 1.0).abs() < 5e-15, "{e}: {energy} {printed}");
        }
    }

    #[test]
    fn particle_velocity_is_the_integral_of_the_wave_speed() {
        for law in LAWS {
            for epsilon in [3.7e-10, 0.014_534, 0.91] {
                let expected =
                    integral(0.0, epsilon, |s| law.longitudinal_speed(Strain::from_engineering(s)));
                let w = law.particle_velocity(Strain::from_engineering(epsilon));
                // Rounding of the 768 additions of the integral.
                assert!((w / expected - 1.0).abs() < 5e-15, "{law:?} {epsilon}: {w}");
                let back = law.strain_at_particle_velocity(w).engineering;
                // Four roundings forth and back.
                assert!((back / epsilon - 1.0).abs() < 1e-15, "{law:?} {epsilon}: {back}");
            }
        }
    }

    #[test]
    fn wave_speed_is_the_slope_of_the_tension() {
        for law in LAWS {
            let (epsilon, h) = (0.371, 1e-5);
            let tension = |s| law.tension(Strain::from_engineering(s));
            let slope = (tension(epsilon + h) - tension(epsilon - h)) / (2.0 * h);
            let speed = law.longitudinal_speed(Strain::from_engineering(epsilon));
            // Central difference: h²T‴/6 ≈ 1e-11 and cancellation ≈ 1e-16/h = 1e-11.
            assert!((speed * speed - slope).abs() < 5e-11, "{law:?}: {speed} {slope}");
        }
    }

    #[test]
    fn kink_and_slowest_longitudinal_wave_have_one_speed_at_the_largest_kinked_strain() {
        let law = Law::Logarithmic;
        let strain = Strain::from_engineering(law.largest_kinked_strain());
        let kink = (law.tension(strain) / strain.stretch()).sqrt();
        // E − 1 is rounded; both speeds are roots: a few ulps.
        assert!((kink / law.longitudinal_speed(strain) - 1.0).abs() < 1e-15);
    }
}
