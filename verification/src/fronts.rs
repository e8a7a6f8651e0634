//! Where the fronts of a crossover's waves are, and windows that none of them touches.

use crossfibre::scene::Scene;

use crate::cases::support::exact_crossover;

/// Share of the way between two fronts that a window keeps clear at both of its ends: room for what a
/// mesh makes of a front. Behind the crossover there is less way, and smaller fronts.
const CLEAR: f64 = 0.25;
const CLEAR_BEHIND: f64 = 0.2;

/// The fronts at one time, as Lagrangian distances, m: on the primary from the impact point, on the
/// secondary from the crossover.
///
/// From the incident wave's passing of the crossover until the reflected wave is at the impact point,
/// t = 2X_c/c (`docs/exact/crossover.md`, "Range").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fronts {
    /// The primary's kink, Ut.
    pub kink: f64,
    /// Time at which the reflected wave meets the primary's kink, t₁ = 2X_c/(c + U), s.
    pub meeting: f64,
    /// The wavelet that the reflected wave sheds at the kink, Ut₁ + c(t − t₁); none before.
    pub wavelet: Option<f64>,
    /// The reflected wave, 2X_c − ct, before and after it has met the kink.
    pub reflected: f64,
    /// The crossover, X_c.
    pub crossover: f64,
    /// The transmitted wave, ct, or the clamp.
    pub transmitted: f64,
    /// The secondary's kink, U₂(t − X_c/c).
    pub secondary_kink: f64,
    /// The secondary's longitudinal wave, c₂(t − X_c/c).
    pub secondary_front: f64,
}

impl Fronts {
    /// The fronts of a scene with a crossover.
    pub fn of(scene: &Scene, time: f64) -> Self {
        let exact = exact_crossover(scene);
        let at = scene.secondary.as_ref().map_or(0.0, |secondary| secondary.at);
        let c = exact.incident.front_speed;
        let kink_speed = exact.incident.kink_speed_lagrangian;
        let since = time - at / c;
        let meeting = (at + at) / (kink_speed + c);
        Self {
            kink: kink_speed * time,
            meeting,
            wavelet: (time >= meeting).then_some(kink_speed * meeting + c * (time - meeting)),
            reflected: at - c * since,
            crossover: at,
            transmitted: (c * time).min(scene.primary.length),
            secondary_kink: exact.diverted.kink_speed_lagrangian * since,
            secondary_front: exact.diverted.front_speed * since,
        }
    }
}

/// Intervals of Lagrangian distance, m, over which a mean is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Windows {
    /// On the primary, before the crossover.
    pub behind: (f64, f64),
    /// On the primary, beyond it.
    pub ahead: (f64, f64),
    /// On the secondary.
    pub diverted: (f64, f64),
}

/// Windows in which the exact strain is uniform, clear of every front.
pub fn between_fronts(scene: &Scene, time: f64) -> Windows {
    let fronts = Fronts::of(scene, time);
    let inside =
        |from: f64, to: f64, share: f64| (from + share * (to - from), to - share * (to - from));
    let behind = fronts.wavelet.unwrap_or(fronts.reflected);
    Windows {
        behind: inside(behind, fronts.crossover, CLEAR_BEHIND),
        ahead: inside(fronts.crossover, fronts.transmitted, CLEAR),
        diverted: inside(fronts.secondary_kink, fronts.secondary_front, CLEAR),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    /// By hand as the plateaus of `summary::exact`: c = 6968.6 m/s, U = 0.11926 c and 0.046037 c on the
    /// secondary, to 0.02 mm.
    #[test]
    fn fronts_are_where_they_are_by_hand() {
        let near = |found: f64, expected: f64| {
            assert!((1e3 * found - expected).abs() < 0.02, "{found} {expected}");
        };
        let early = Fronts::of(&shipped("fig3"), 22.0e-6);
        near(early.kink, 18.284);
        near(early.reflected, 46.691);
        near(early.transmitted, 153.309);
        near(early.secondary_kink, 2.454);
        near(early.secondary_front, 53.309);
        assert_eq!(early.wavelet, None);
        // The wave met the kink at 25.641 µs and 21.310 mm, 3.059 µs before.
        let late = Fronts::of(&shipped("fig3"), 28.7e-6);
        near(1e3 * late.meeting, 25.641);
        near(late.wavelet.unwrap_or(f64::NAN), 42.623);
        near(late.reflected, 0.0);
    }
}
