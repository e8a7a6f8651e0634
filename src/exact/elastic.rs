//! What a wave must know of the fibre that it runs on.

use std::fmt;

use super::hyperelastic::{Law, Strain};
use super::smith::Fibre;
use super::wave::{Kind, Piece};

/// The material of an elastic fibre, as waves see it.
///
/// ε = λ − 1 is engineering strain, T nominal tension (Pa), ρ reference density (kg/m³); speeds
/// are Lagrangian (m/s). Everything holds for strains ε ≥ 0 up to the first at which T′ is no longer
/// positive. Derivations: `docs/exact/smith.md`.
pub trait Elastic {
    /// ρ, kg/m³.
    fn density(&self) -> f64;

    /// T(ε), Pa.
    fn tension(&self, strain: f64) -> f64;

    /// T′(ε), Pa.
    fn tangent_modulus(&self, strain: f64) -> f64;

    /// ψ(ε) = ∫₀^ε T dε, the energy stored per reference volume, J/m³.
    fn stored_energy(&self, strain: f64) -> f64;

    /// The fans and shocks of the longitudinal wave from strain `from` (ahead of it) to strain `to`
    /// (behind it), from the first disturbance to the last. There is at least one.
    ///
    /// Their speeds decrease in that order, to within rounding where a shock touches a fan.
    fn pieces(&self, from: f64, to: f64) -> Vec<Piece>;

    /// W, the particle velocity (m/s) that a longitudinal wave from strain `from` (ahead of it) to
    /// strain `to` (behind it) gives to the fibre, towards where the wave comes from if positive.
    ///
    /// It has the sign of `to − from`, and is ∫√(T̂′/ρ) dε, where T̂ is the least concave function
    /// above T between the two strains in a loading wave, the greatest convex one below T in an
    /// unloading wave: where T̂ = T the wave is a fan, where T̂ is a chord it is a shock.
    fn wave_velocity(&self, from: f64, to: f64) -> f64 {
        self.pieces(from, to).iter().map(|piece| piece.velocity).sum()
    }

    /// The speeds of the first and of the last disturbance of that wave, m/s.
    fn wave_speeds(&self, from: f64, to: f64) -> (f64, f64) {
        let pieces = self.pieces(from, to);
        let speed = |piece: Option<&Piece>, of: fn((f64, f64)) -> f64| {
            piece.map_or(f64::NAN, |piece| of(piece.speeds))
        };
        (speed(pieces.first(), |s| s.0), speed(pieces.last(), |s| s.1))
    }

    /// The greatest strain at which the laws of waves hold: where a kink, √(T/(ρλ)), first gets as
    /// fast as the last disturbance of a loading wave from rest. T′ is still positive there.
    ///
    /// Without such a strain it is the greatest at which nothing overflows, or `f64::MAX`.
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

    fn tangent_modulus(&self, strain: f64) -> f64 {
        match self.law {
            Law::Engineering => self.fibre.modulus,
            Law::Logarithmic => self.fibre.modulus / (1.0 + strain),
        }
    }

    fn stored_energy(&self, strain: f64) -> f64 {
        self.fibre.modulus * self.law.stored_energy(Strain::from_engineering(strain))
    }

    fn pieces(&self, from: f64, to: f64) -> Vec<Piece> {
        let kind = match self.law {
            Law::Logarithmic if to > from => Kind::Fan,
            _ => Kind::Shock,
        };
        let (speeds, velocity) = (self.wave_speeds(from, to), self.wave_velocity(from, to));
        vec![Piece { kind, from, to, speeds, velocity }]
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

/// Why numbers make no elastic law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LawError {
    /// A density that is not a positive number.
    Density(f64),
    /// A polynomial without a coefficient.
    NoCoefficient,
    /// A parameter that is not a finite number.
    NotFinite {
        /// Its place: 1 for E₁ or a, 2 for E₂ or b, and so on.
        place: usize,
        /// What it was.
        value: f64,
    },
    /// An initial modulus T′(0), which is E₁ or a·b, that is not a positive number.
    InitialModulus(f64),
}

impl fmt::Display for LawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Density(value) => write!(f, "the density is {value:e}: it must be positive"),
            Self::NoCoefficient => write!(f, "a polynomial law needs at least one coefficient"),
            Self::NotFinite { place, value } => {
                write!(f, "parameter {place} of the law is {value}: it must be a finite number")
            }
            Self::InitialModulus(value) => write!(
                f,
                "the modulus at zero strain, E1 or a*b, is {value:e}: it must be positive and finite"
            ),
        }
    }
}

impl std::error::Error for LawError {}

/// An error unless the numbers make a law of waves: ρ > 0, finite parameters, T′(0) > 0.
pub(super) fn checked(density: f64, parameters: &[f64], modulus: f64) -> Result<(), LawError> {
    let positive = |x: f64| x > 0.0 && x.is_finite();
    if !positive(density) {
        return Err(LawError::Density(density));
    }
    if let Some((i, &value)) = parameters.iter().enumerate().find(|(_, x)| !x.is_finite()) {
        return Err(LawError::NotFinite { place: i + 1, value });
    }
    if positive(modulus) { Ok(()) } else { Err(LawError::InitialModulus(modulus)) }
}
