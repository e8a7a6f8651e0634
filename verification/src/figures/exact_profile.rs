//! The exact strain along both fibres as long as closed forms give it, for the engineering law.

use anyhow::{Result, ensure};
use crossfibre::exact::crossover::Crossover;
use crossfibre::scene::{Scene, Strain};

use crate::cases::support::{exact_crossover, measured_by};
use crate::fronts::Fronts;

/// A stretch of fibre of uniform strain, between two Lagrangian distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Where it begins, m.
    pub from: f64,
    /// Where it ends, m.
    pub to: f64,
    /// Engineering strain λ − 1.
    pub strain: f64,
}

/// Both fibres: the primary from the impact point, the secondary from the crossover.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// The struck fibre.
    pub primary: Vec<Segment>,
    /// An arm of the crossing fibre.
    pub secondary: Vec<Segment>,
}

/// What the reflected wave's time at the impact point is exceeded by when a duration in microseconds
/// is rounded to a tenth.
const ROUNDED: f64 = 1e-4;

/// The exact profile of a scene with a crossover, at a time after the incident wave has met it and
/// before the reflected wave is at the impact point, t = 2X_c/c.
pub fn exact_profile(scene: &Scene, time: f64) -> Result<Profile> {
    let scene = measured_by(Strain::Engineering, scene.clone());
    let exact = exact_crossover(&scene);
    let fronts = Fronts::of(&scene, time);
    let arrival = fronts.crossover / exact.incident.front_speed;
    ensure!(
        arrival <= time && time <= 2.0 * arrival * (1.0 + ROUNDED),
        "the closed forms give no profile at {time:e} s: the incident wave meets the crossover at \
         {arrival:e} s, and twice that the reflected wave is at the impact point"
    );
    let strains = [exact.incident, exact.diverted].map(|state| state.strain.engineering);
    let [incident, diverted] = strains;
    let (ahead, behind) = (exact.transmitted.engineering, exact.reflected.engineering);
    let reflected = fronts.reflected.max(0.0);
    // The strain does not change across the kink, so the wavelet is the first front in its way.
    let at_kink = fronts.wavelet.map(|wavelet| (wavelet, strain_at_kink(&exact)));
    let begins = at_kink.map_or(reflected, |(wavelet, _)| wavelet);
    let segment = |from, to, strain| (from < to).then_some(Segment { from, to, strain });
    let primary = [
        segment(0.0, reflected, incident),
        at_kink.and_then(|(wavelet, strain)| segment(reflected, wavelet, strain)),
        segment(begins, fronts.crossover, behind),
        segment(fronts.crossover, fronts.transmitted, ahead),
        segment(fronts.transmitted, scene.primary.length, 0.0),
    ];
    let length = scene.secondary.as_ref().map_or(0.0, |secondary| secondary.length);
    let front = fronts.secondary_front.min(length);
    let secondary = [segment(0.0, front, diverted), segment(front, length, 0.0)];
    Ok(Profile {
        primary: primary.into_iter().flatten().collect(),
        secondary: secondary.into_iter().flatten().collect(),
    })
}

/// The engineering strain left where the reflected wave meets the primary's kink.
///
/// Velocities in units of c. Left of the kink the fibre moves with the projectile, v_L = (0, V), along
/// t_L; right of it it flows in at the junction's speed, v_R = (−u, 0), along t_R = (1, 0). The meeting
/// sends longitudinal waves and kinks both ways, with one strain λ* and one direction t* between:
///
/// ```text
/// v_L* = v_L + (λ* − λ_L)t_L      v_R* = v_R − (λ* − λ_R)t_R      U = √((λ* − 1)/λ*)
/// t* = (t_L + t_R)/2 + (v_R* − v_L*)/(2Uλ*)                       |t*| = 1
/// ```
fn strain_at_kink(exact: &Crossover) -> f64 {
    let i = &exact.incident;
    let c = i.front_speed;
    let (e_left, e_right) = (i.strain.engineering, exact.reflected.engineering);
    let left = [i.angle_cosine, -i.angle_sine];
    let right = [1.0, 0.0];
    let v_left = [0.0, i.kink_speed_lagrangian * i.strain.stretch() * i.angle_sine / c];
    let v_right = [-exact.junction_speed / c, 0.0];
    let too_short = |e: f64| {
        let twice_u_stretch = 2.0 * (e * (1.0 + e)).sqrt();
        let squared: f64 = (0..2)
            .map(|k| {
                let from_left = v_left[k] + (e - e_left) * left[k];
                let from_right = v_right[k] - (e - e_right) * right[k];
                0.5 * (left[k] + right[k]) + (from_right - from_left) / twice_u_stretch
            })
            .map(|component| component * component)
            .sum();
        squared < 1.0
    };
    // More strain means less motion for the middle to span: |t*| falls as λ* grows.
    let (mut low, mut high) = (0.0, 2.0 * e_right);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if too_short(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Enough to halve any interval down to neighbouring doubles, if its root is not tiny.
const BISECTIONS: usize = 64;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::{marched, refined, relative, shipped};

    /// Against the march with engineering strain, which has the same solution in the limit. The worst
    /// plateau is off by 8e-5, the one at the kink, across which the mesh spreads the kinks.
    #[test]
    fn every_plateau_is_that_of_the_march() {
        let scene = refined(measured_by(Strain::Engineering, shipped("fig3")), 16);
        let profile = exact_profile(&scene, scene.duration).unwrap();
        let run = marched(scene);
        let mut compared = 0;
        for segment in profile.primary.iter().filter(|segment| segment.strain > 0.0) {
            let clear = 0.25 * (segment.to - segment.from);
            let found = run.primary_strain(segment.from + clear, segment.to - clear);
            assert!(relative(found, segment.strain) < 2e-4, "{segment:?} {found}");
            compared += 1;
        }
        assert_eq!(compared, 3); // the state at the kink, behind the crossover, and ahead of it
        let arm = profile.secondary[0];
        let found = run.secondary_strain(0.25 * arm.to, 0.75 * arm.to);
        assert!(relative(found, arm.strain) < 2e-4, "{arm:?} {found}");
    }

    #[test]
    fn before_the_kink_is_met_there_are_two_strains_behind_the_crossover() {
        let scene = shipped("fig3");
        let profile = exact_profile(&scene, 21.3e-6).unwrap();
        assert_eq!(profile.primary.len(), 4);
        let exact = exact_crossover(&measured_by(Strain::Engineering, scene.clone()));
        let c = exact.incident.front_speed;
        // Symmetry about the crossover: the reflected wave is as far from it as the transmitted one.
        let [incident, behind, ahead] = [0, 1, 2].map(|k| profile.primary[k]);
        let ways = [behind.to - behind.from, ahead.to - ahead.from, c * 21.3e-6 - 0.1];
        assert!(relative(ways[0], ways[2]) < 1e-12 && relative(ways[1], ways[2]) < 1e-12);
        assert_eq!(incident.strain, exact.incident.strain.engineering);
        assert_eq!(behind.strain, exact.reflected.engineering);
    }

    #[test]
    fn times_beyond_the_closed_forms_are_refused() {
        for time in [14.2e-6, 29.1e-6] {
            assert!(exact_profile(&shipped("fig3"), time).is_err());
        }
    }
}
