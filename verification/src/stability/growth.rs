//! Growth of a small perturbation over ten thousand steps of the march, or more.

use crossfibre::number::Number;
use crossfibre::paper::Paper;
use crossfibre::result::WithPaper;
use crossfibre::state::{FibreState, State};
use serde::{Deserialize, Serialize};

use super::base::Base;
use crate::planted::{march, with_paper};

/// Steps over which growth is judged. What seems to grow over the first of them and is small still is
/// judged again over the next: energy that goes slowly from one fibre to a very different one and
/// back looks like growth until it comes back.
pub const STEPS: [u64; 3] = [10_000, 100_000, 1_000_000];

/// The greatest velocity of the perturbation, over the wave speed. Squares of it are below rounding.
const PERTURBATION: f64 = 1e-10;

/// Perturbations between these are taken as grown, and still linear.
const GROWN: std::ops::Range<f64> = 1e-8..1e-4;

/// A march is called unstable from this rate on, ln of the growth in a step.
///
/// Beats between modes of nearly one frequency come to half of this.
pub const THRESHOLD: f64 = 2e-4;

/// What came of a perturbation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Growth {
    /// ln of its growth in a step.
    pub rate: f64,
    /// The step in which a velocity exceeded the wave speed, or the march ended.
    pub diverged: Option<u64>,
}

impl Growth {
    /// Whether it is more than that of a stable march.
    pub fn is_unstable(&self) -> bool {
        self.rate > THRESHOLD || self.diverged.is_some()
    }
}

/// Marches a base state with a perturbation of all velocities.
pub fn growth(base: &Base, courant: f64) -> Growth {
    with_paper(&base.scene, March { base, courant })
}

struct March<'a> {
    base: &'a Base,
    courant: f64,
}

impl WithPaper<f64> for March<'_> {
    type Out = Growth;

    fn with(self, paper: &impl Paper<f64>) -> Growth {
        let mut state = self.base.state::<f64>(self.courant);
        disturb(&mut state, PERTURBATION, self.base.axial);
        let (mut steps, mut quarters) = (STEPS[0], [0.0; 4]);
        // The step of the first size that is in the range of what has grown, and that size.
        let (mut first, mut rate) = ((0, PERTURBATION), None);
        for step in 1.. {
            let ended = march::step(paper, &mut state).is_err();
            let size = size(&state);
            if rate.is_none() && size.is_finite() {
                if size >= GROWN.end {
                    rate = Some(Number::ln(size / first.1) / (step - first.0) as f64);
                } else if first.0 == 0 && size > GROWN.start {
                    first = (step, size);
                }
            }
            if ended || size.is_nan() || size > 1.0 {
                return Growth { rate: rate.unwrap_or(f64::MAX), diverged: Some(step) };
            }
            quarters[((step - 1) * 4 / steps) as usize] += size * size;
            if step == steps {
                let found =
                    Growth { rate: rate.unwrap_or(late_rate(steps, quarters)), diverged: None };
                let further = STEPS.into_iter().find(|&more| more > steps);
                match further {
                    // The first quarter of ten times as many steps is not over yet.
                    Some(more) if found.is_unstable() && rate.is_none() => {
                        (steps, quarters) = (more, [0.0; 4]);
                    }
                    _ => return found,
                }
            }
        }
        unreachable!("a march ends with the last number of steps")
    }
}

/// The rate r of ln(size) = rt + p ln t + const with p ≥ 0, from sums of size² over quarters of the
/// march.
///
/// Where two eigenvalues meet on the unit circle, at the limit itself or where two parts of the
/// mesh are in resonance, a perturbation grows with a power p of time. That is no instability.
fn late_rate(steps: u64, [_, second, third, fourth]: [f64; 4]) -> f64 {
    let gain = |from: f64, to: f64| {
        0.5 * Number::ln(to.max(f64::MIN_POSITIVE) / from.max(f64::MIN_POSITIVE))
    };
    let (before, last) = (gain(second, third), gain(third, fourth));
    // Between the middles of quarters, which are as 3, 5 and 7.
    let (power_before, power_last) = (Number::ln(5.0 / 3.0), Number::ln(7.0 / 5.0));
    let power = ((before - last) / (power_before - power_last)).max(0.0);
    (last - power * power_last) / (steps / 4) as f64
}

/// What a march makes of a perturbation that is not small.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shaken {
    /// By how much the mean strain has grown in the first of [`STEPS`].
    pub wound: f64,
    /// The step in which the strain was beyond three times what it was, or the march ended.
    pub diverged: Option<u64>,
}

/// Marches a uniform fibre with a perturbation of all velocities of a size, over the wave speed.
pub fn shaken(base: &Base, courant: f64, size: f64) -> Shaken {
    struct March<'a>(&'a Base, f64, f64);
    impl WithPaper<f64> for March<'_> {
        type Out = Shaken;
        fn with(self, paper: &impl Paper<f64>) -> Shaken {
            let Self(base, courant, size) = self;
            let mut state = base.state::<f64>(courant);
            disturb(&mut state, size, base.axial);
            let mean = |state: &State<f64>| {
                state.primary.strain.iter().sum::<f64>() / state.primary.elements() as f64
            };
            for step in 1..=STEPS[0] {
                let ended = march::step(paper, &mut state).is_err();
                if ended || mean(&state) > 3.0 * base.strain {
                    return Shaken { wound: 2.0 * base.strain, diverged: Some(step) };
                }
            }
            Shaken { wound: mean(&state) - base.strain, diverged: None }
        }
    }
    with_paper(&base.scene, March(base, courant, size))
}

/// Gives every free velocity its own small number. Along the fibre only for an axial projectile: a
/// straight fibre without tension resists nothing else.
fn disturb(state: &mut State<f64>, size: f64, axial: bool) {
    let size = size * state.primary.properties.wave_speed;
    disturb_fibre(&mut state.primary, size, if axial { 1 } else { 2 });
    if let Some(crossover) = &mut state.crossover {
        disturb_fibre(&mut crossover.fibre, size, 3);
    }
    if state.projectile.mass.is_some() {
        state.projectile.velocity += 0.7 * size;
    }
}

fn disturb_fibre<const D: usize>(fibre: &mut FibreState<f64, D>, size: f64, components: usize) {
    /// Multiples of the golden ratio leave every remainder only once.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let n = fibre.elements();
    let free = fibre.velocity[1..n].iter_mut().flat_map(|v| v.iter_mut().take(components));
    for (k, v) in free.enumerate() {
        let x = GOLDEN * (k + 1) as f64;
        *v += size * (2.0 * (x - x.floor()) - 1.0);
    }
}

/// Root mean square of all velocities over the wave speed of the primary; a base state has none.
fn size(state: &State<f64>) -> f64 {
    let (mut sum, mut count) = squares(&state.primary);
    if let Some(crossover) = &state.crossover {
        let (more, others) = squares(&crossover.fibre);
        (sum, count) = (sum + more, count + others);
    }
    (sum / count as f64).sqrt() / state.primary.properties.wave_speed
}

fn squares<const D: usize>(fibre: &FibreState<f64, D>) -> (f64, usize) {
    (fibre.velocity.iter().map(|v| v.dot(v)).sum(), fibre.velocity.len())
}

#[cfg(test)]
mod tests {
    use crossfibre::scene::Strain;

    use super::super::rows::{ALONE, at_rest, fibre};
    use super::*;

    /// Sums of t^2p exp(2rt) over quarters. A sum over a quarter is not the value in its middle: worst
    /// 2.7e-5, of t², a seventh of what is called unstable.
    #[test]
    fn growth_with_a_power_of_time_is_told_from_exponential_growth() {
        for (rate, power) in [(0.0, 0), (0.0, 1), (0.0, 2), (3.7e-4, 0), (3.7e-4, 1), (-2.1e-4, 0)]
        {
            let (steps, mut quarters) = (STEPS[0], [0.0; 4]);
            for step in 0..steps {
                let t = (step + 1) as f64;
                let size = t.powi(power) * Number::exp(rate * t);
                quarters[(step * 4 / steps) as usize] += size * size;
            }
            let found = late_rate(steps, quarters);
            assert!((found - rate).abs() < 5e-5, "{rate} {power}: {found}");
        }
    }

    #[test]
    fn a_march_is_unstable_beyond_a_rate_or_if_it_ended() {
        let is_unstable = |rate, diverged| Growth { rate, diverged }.is_unstable();
        assert!(!is_unstable(THRESHOLD, None) && is_unstable(1.01 * THRESHOLD, None));
        assert!(is_unstable(0.0, Some(7)) && is_unstable(1.0, Some(7)));
    }

    /// Nodes that move by 1e190 elements in a step: the square of a length is beyond all numbers. By
    /// 1e140: that of a velocity, a step later.
    #[test]
    fn a_march_that_ends_before_anything_has_grown_has_diverged() {
        let base = at_rest(fibre(ALONE, Strain::Engineering), 0.0145);
        for (courant, step) in [(1e200, 1), (1e150, 2)] {
            let expected = Growth { rate: f64::MAX, diverged: Some(step) };
            assert_eq!(growth(&base, courant), expected, "{courant}");
        }
    }
}
