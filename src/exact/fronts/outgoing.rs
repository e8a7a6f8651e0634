//! The waves that leave a joint along one arm, without those too weak to follow.

use super::material::PiecewiseLinear;
use crate::exact::riemann::{Arm, State};

/// What moves along a fibre.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// A jump of strain, at the speed of sound.
    Longitudinal,
    /// A jump of direction.
    Kink,
}

/// A wave that leaves a joint; directions point away from the joint.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outgoing {
    /// Lagrangian speed away from the joint, m/s.
    pub speed: f64,
    pub family: Family,
    /// Jump of strain, or jump of velocity over the longitudinal speed.
    pub strength: f64,
    /// The state between it and the joint.
    pub behind: State,
}

/// The waves of an arm, the foremost first.
#[derive(Debug, Clone, Default)]
pub(super) struct Waves {
    pub kept: Vec<Outgoing>,
    /// Sum of the strengths of the waves left out.
    pub dropped: f64,
}

impl Waves {
    /// The waves of at least strength `weakest`. Where one is left out, the state ahead of it
    /// stands for the state behind it up to the next wave kept.
    pub fn of(material: &impl PiecewiseLinear, arm: &Arm, weakest: f64) -> Self {
        let mut waves = Self::default();
        let (ahead, t) = (arm.ahead, arm.ahead.direction);
        for jump in material.pieces(ahead.strain, arm.between.strain) {
            let velocity = ahead.velocity - t * material.wave_velocity(ahead.strain, jump.to);
            let wave = Outgoing {
                speed: jump.speeds.0,
                family: Family::Longitudinal,
                strength: (jump.to - jump.from).abs(),
                behind: State { strain: jump.to, velocity, ..arm.between },
            };
            waves.add(wave, weakest);
        }
        let strain = arm.between.strain;
        let turned = (arm.behind.velocity - arm.between.velocity).norm();
        let kink = Outgoing {
            speed: material.kink_speed(strain),
            family: Family::Kink,
            strength: turned / material.wave_speeds(strain, strain).0,
            behind: arm.behind,
        };
        waves.add(kink, weakest);
        waves
    }

    fn add(&mut self, wave: Outgoing, weakest: f64) {
        if wave.strength >= weakest && wave.strength > 0.0 {
            self.kept.push(wave);
        } else {
            self.dropped += wave.strength;
        }
    }

    /// The state between the last wave kept and the joint.
    pub fn at_joint(&self, ahead: State) -> State {
        self.kept.last().map_or(ahead, |wave| wave.behind)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn waves_as_strong_as_the_weakest_are_kept_and_those_without_strength_never() {
        let behind = State { strain: 0.01, velocity: Vector3::zeros(), direction: Vector3::x() };
        let wave = |strength| Outgoing { speed: 1.0, family: Family::Kink, strength, behind };
        let mut waves = Waves::default();
        for (strength, weakest) in [(0.0, 0.0), (1e-3, 1e-3), (2e-3, 1e-3), (0.9e-3, 1e-3)] {
            waves.add(wave(strength), weakest);
        }
        let kept: Vec<f64> = waves.kept.iter().map(|wave| wave.strength).collect();
        assert_eq!((kept, waves.dropped), (vec![1e-3, 2e-3], 0.9e-3));
    }
}
