//! Inputs of equations: awkward numbers of a plausible size, or special ones.

use crossfibre::number::Vector;
use crossfibre::paper::magnitude;

use crate::random::SplitMix;

/// What may be special about a set of inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Special {
    /// No velocity, tension or strain; fibres along x; nothing slides.
    AtRest,
    /// Directions along y; everything slides.
    RightAngle,
    /// Directions along −x.
    Folded,
    /// Every number zero.
    Zero,
    /// Ordinary numbers times 2⁻¹⁰²²: squares vanish.
    Tiny,
    /// Ordinary numbers times 2⁵²⁰: squares overflow.
    Huge,
}

impl Special {
    pub const ALL: [(&str, Self); 6] = [
        ("at-rest", Self::AtRest),
        ("right-angle", Self::RightAngle),
        ("folded", Self::Folded),
        ("zero", Self::Zero),
        ("tiny", Self::Tiny),
        ("huge", Self::Huge),
    ];
}

/// Draws the inputs of one evaluation.
pub struct Draw {
    random: SplitMix,
    special: Option<Special>,
}

impl Draw {
    /// The inputs with this seed: always the same.
    pub fn new(seed: u64, special: Option<Special>) -> Self {
        Self { random: SplitMix::new(seed), special }
    }

    /// A number between two, but for what is special.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        let x = self.random.between(low, high);
        match self.special {
            Some(Special::Zero) => 0.0,
            Some(Special::Tiny) => x * f64::MIN_POSITIVE,
            Some(Special::Huge) => x * f64::from_bits((1023 + 520) << 52),
            _ => x,
        }
    }

    /// A number that is zero at rest.
    fn motion(&mut self, low: f64, high: f64) -> f64 {
        let x = self.between(low, high);
        if self.special == Some(Special::AtRest) { 0.0 } else { x }
    }

    fn vector<const D: usize>(mut component: impl FnMut() -> f64) -> Vector<f64, D> {
        Vector::from_fn(|_, _| component())
    }

    /// Velocity, m/s.
    pub fn velocity(&mut self) -> f64 {
        self.motion(-430.0, 430.0)
    }

    /// Velocity as a vector, m/s.
    pub fn velocities<const D: usize>(&mut self) -> Vector<f64, D> {
        Self::vector(|| self.velocity())
    }

    /// Tension, N.
    pub fn tension(&mut self) -> f64 {
        self.motion(-1300.0, 1300.0)
    }

    /// Tension as a vector, N.
    pub fn tensions<const D: usize>(&mut self) -> Vector<f64, D> {
        Self::vector(|| self.tension())
    }

    /// Strain.
    pub fn strain(&mut self) -> f64 {
        self.motion(-0.004, 0.031)
    }

    /// Length of an element, m: any two are near enough to cancel in (3) and (4).
    pub fn length(&mut self) -> f64 {
        self.between(1.93e-3, 2.09e-3)
    }

    /// Position of a node, m.
    pub fn position<const D: usize>(&mut self) -> Vector<f64, D> {
        Self::vector(|| self.between(-0.017, 0.29))
    }

    /// The next node, an element away, m.
    pub fn next_to<const D: usize>(&mut self, node: Vector<f64, D>) -> Vector<f64, D> {
        node + self.direction() * self.length()
    }

    /// A unit vector.
    pub fn direction<const D: usize>(&mut self) -> Vector<f64, D> {
        let random = Self::vector(|| self.between(-1.0, 1.0));
        let along = |axis: usize, sign: f64| {
            let mut v = Vector::zeros();
            v[axis] = sign;
            v
        };
        match self.special {
            None => random / magnitude(random),
            Some(Special::Zero) => Vector::zeros(),
            Some(Special::RightAngle) => along(1, 1.0),
            Some(Special::Folded) => along(0, -1.0),
            Some(Special::AtRest | Special::Tiny | Special::Huge) => along(0, 1.0),
        }
    }

    /// Slide factor.
    pub fn slide_factor(&mut self) -> f64 {
        let x = self.between(0.03, 0.97);
        match self.special {
            None | Some(Special::Folded | Special::Zero) => x,
            Some(Special::RightAngle) => 0.0,
            Some(Special::AtRest | Special::Tiny | Special::Huge) => 1.0,
        }
    }

    /// Mass of a node, kg.
    pub fn node_mass(&mut self) -> f64 {
        self.between(0.9e-6, 7.3e-6)
    }

    /// Mass of a projectile, kg.
    pub fn projectile_mass(&mut self) -> f64 {
        self.between(0.3e-3, 2.9e-3)
    }

    /// Time step, s.
    pub fn time_step(&mut self) -> f64 {
        self.between(0.9e-7, 3.1e-7)
    }

    /// Time since impact, s.
    pub fn time(&mut self) -> f64 {
        self.between(1.1e-6, 83e-6)
    }

    /// Δt/Δm, s/kg.
    pub fn a(&mut self) -> f64 {
        self.between(0.021, 0.31)
    }

    /// Modulus × area, N.
    pub fn stiffness(&mut self) -> f64 {
        self.between(3.7e4, 9.1e4)
    }

    /// Speed of a longitudinal wave, m/s.
    pub fn wave_speed(&mut self) -> f64 {
        self.between(4100.0, 9700.0)
    }

    /// ∂²u/∂x², 1/m.
    pub fn curvature(&mut self) -> f64 {
        self.motion(-13.0, 13.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn awkward_numbers_stay_in_their_range_and_do_not_repeat() {
        let mut draw = Draw::new(0x5eed, None);
        let mut lengths: Vec<_> = (0..1000).map(|_| draw.length()).collect();
        assert!(lengths.iter().all(|l| (1.93e-3..2.09e-3).contains(l)));
        lengths.sort_by(f64::total_cmp);
        lengths.dedup();
        assert_eq!(lengths.len(), 1000);
    }
}
