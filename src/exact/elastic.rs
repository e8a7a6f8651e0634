//! What a wave must know of the fibre that it runs on.

use super::hyperelastic::{Law, Strain};
use super::smith::Fibre;

/// The material of an elastic fibre, as waves see it.
///
/// ε = λ − 1 is engineering strain, T nominal tension (Pa), ρ reference density (kg/m³); speeds
/// are Lagrangian (m/s).
pub trait Elastic {
    /// ρ, kg/m³.
    fn density(&self) -> f64;

    /// T(ε), Pa.
    fn tension(&self, strain: f64) -> f64;

    /// W, the particle velocity (m/s) that a longitudinal wave from strain `from` (ahead of it) to
    /// strain `to` (behind it) gives to the fibre, towards where the wave comes from if positive.
    ///
    /// It has the sign of `to − from`, and is ∫√(T̂′/ρ) dε, where T̂ is the least concave function
    /// above T between the two strains in a loading wave, the greatest convex one below T in an
    /// unloading wave: where T̂ = T the wave is a fan, where T̂ is a chord it is a shock.
    fn wave_velocity(&self, from: f64, to: f64) -> f64;

    /// The speeds of the first and of the last disturbance of that wave, m/s.
    fn wave_speeds(&self, from: f64, to: f64) -> (f64, f64);

    /// The greatest strain at which the laws of waves hold: at most where a kink, √(T/(ρλ)), gets
    /// as fast as the last disturbance of a loading wave from rest, or where T′ is no longer positive.
    fn greatest_strain(&self) -> f64;

    /// U = √(T/(ρλ)), the Lagrangian speed of a transverse kink, m/s.
    fn kink_speed(&self, strain: f64) -> f64 {
        (self.tension(strain) / (self.density() * (1.0 + strain))).sqrt()
    }
}

/// A fibre whose tension follows one of the two laws with closed forms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hyperelastic {
    /// The shape of the law.
    pub law: Law,
    /// Its modulus, density and area.
    pub fibre: Fibre,
}

impl Elastic for Hyperelastic {
    fn density(&self) -> f64 {
        self.fibre.density
    }

    fn tension(&self, strain: f64) -> f64 {
        self.fibre.modulus * self.law.tension(Strain::from_engineering(strain))
    }

    fn wave_velocity(&self, from: f64, to: f64) -> f64 {
        let c = self.fibre.wave_speed();
        match self.law {
            Law::Engineering => c * (to - from),
            // A concave law: loading spreads, unloading is one shock.
            Law::Logarithmic if to >= from => {
                c * 2.0 * (to - from) / ((1.0 + to).sqrt() + (1.0 + from).sqrt())
            }
            Law::Logarithmic => {
                let logarithm = pxfm::f_log1p((to - from) / (1.0 + from));
                -c * (logarithm * (to - from)).sqrt()
            }
        }
    }

    fn wave_speeds(&self, from: f64, to: f64) -> (f64, f64) {
        let c = self.fibre.wave_speed();
        let speed = |strain| c * self.law.longitudinal_speed(Strain::from_engineering(strain));
        if self.law == Law::Logarithmic && to < from {
            let shock = self.wave_velocity(from, to) / (to - from);
            (shock, shock)
        } else {
            (speed(from), speed(to))
        }
    }

    fn greatest_strain(&self) -> f64 {
        self.law.largest_kinked_strain()
    }
}
