//! The motion of two crossed fibres by whichever solution fits: exact, or converging to it.
//!
//! With the engineering law and a projectile of constant velocity the fronts are followed exactly
//! ([`fronts`](super::fronts)). The logarithmic law is replaced by polygons with ever shorter
//! chords, a projectile of finite mass by one whose velocity changes in ever shorter steps; the
//! difference between the last two bounds what is left. Derivation, range and tests:
//! `docs/exact/fronts.md`.

use super::elastic::{Elastic, Hyperelastic};
use super::fronts::{
    Ended, Fronts, Limits, Line, PiecewiseLinear, Polygon, Problem, Segment, Track, finest,
};
use super::hyperelastic::Law;
use super::smith::smith;
use crate::place::Fibre;

/// Chords between zero strain and the strain that the impact would give.
const CHORDS: usize = 16;

/// Steps of the velocity of a projectile of finite mass.
const STEPS: usize = 32;

/// The motion up to a time.
#[derive(Debug, Clone)]
pub struct Motion {
    /// The time reached, s: the one asked for unless the motion ended.
    pub time: f64,
    /// Why it ended, if it did.
    pub ended: Option<Ended>,
    /// What stands in for what is not solved exactly.
    pub approximation: Approximation,
    /// The primary from the impact point outward.
    pub primary: Vec<Segment>,
    /// The secondary from the crossover outward.
    pub secondary: Vec<Segment>,
    /// The ways of all fronts.
    pub tracks: Vec<Track>,
    /// Velocity of the projectile, m/s.
    pub projectile_velocity: f64,
    /// Meetings of fronts.
    pub events: u64,
    /// What waves and distances were resolved ([`Limits::resolution`]).
    pub resolution: f64,
    /// Bound of the mean error of strain along a fibre: [`Fronts::error_bound`], and the mean
    /// difference from the solution with half as many chords and steps where there are any.
    pub error_bound: f64,
}

/// What stands in for what is not solved exactly; neither in an exact solution.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Approximation {
    /// Chords of a curved law up to the strain that the impact would give.
    pub chords: Option<usize>,
    /// Steps of the velocity of a projectile of finite mass.
    pub velocity_steps: Option<usize>,
}

/// The motion up to a time (s) of a problem whose projectile has a mass (kg), or none if its
/// velocity is constant.
pub fn motion(problem: &Problem<Hyperelastic>, mass: Option<f64>, time: f64) -> Motion {
    match problem.primary.material.law {
        Law::Engineering => {
            let line = problem.map(Line::of);
            converged(None, mass, |_| &line, time)
        }
        Law::Logarithmic => {
            let polygons = [1, 2].map(|part| polygonal(problem, CHORDS / part));
            converged(Some(CHORDS), mass, |part| &polygons[part - 1], time)
        }
    }
}

/// The problem with polygons of so many chords up to the strain of the impact.
fn polygonal(problem: &Problem<Hyperelastic>, chords: usize) -> Problem<Polygon> {
    let struck = &problem.primary.material;
    let incident = smith(struck.law, struck.fibre.wave_speed(), problem.velocity);
    let strain = incident.map_or(struck.greatest_strain(), |smith| smith.strain.engineering);
    let spacing = strain / chords as f64;
    problem.map(|law| {
        // Far beyond what reflections add up to, or to the end of the law.
        let most = (law.greatest_strain() / spacing).min(64.0 * chords as f64);
        Polygon::inscribed(law, spacing, most as usize)
    })
}

/// The solution with all chords and steps (part 1), bounded by the one with half of them (part 2).
fn converged<'p, M: PiecewiseLinear + Clone + 'p>(
    chords: Option<usize>,
    mass: Option<f64>,
    problem: impl Fn(usize) -> &'p Problem<M>,
    time: f64,
) -> Motion {
    let solve = |part: usize| {
        finest(|limits| match mass {
            None => free(problem(part), time, limits),
            Some(mass) => braked(problem(part), mass, time, STEPS / part, limits),
        })
    };
    let approximation = Approximation { chords, velocity_steps: mass.map(|_| STEPS) };
    let fronts = solve(1);
    let [primary, secondary] = [Fibre::Primary, Fibre::Secondary].map(|f| fronts.segments(f));
    let mut error_bound = fronts.error_bound();
    if approximation != Approximation::default() {
        let coarse = solve(2);
        let apart = |fibre, fine| mean_difference(fine, &coarse.segments(fibre));
        let difference = apart(Fibre::Primary, &primary).max(apart(Fibre::Secondary, &secondary));
        error_bound += coarse.error_bound() + difference;
    }
    let velocity = mass.map_or(0.0, |mass| fronts.accounts().braking / mass);
    Motion {
        time: fronts.time(),
        ended: fronts.ended(),
        approximation,
        primary,
        secondary,
        tracks: fronts.tracks(),
        projectile_velocity: problem(1).velocity - velocity,
        events: fronts.events(),
        resolution: fronts.limits().resolution,
        error_bound,
    }
}

/// The fronts of a projectile with constant velocity.
fn free<M: PiecewiseLinear + Clone>(problem: &Problem<M>, time: f64, limits: Limits) -> Fronts<M> {
    let mut fronts = Fronts::new(problem, limits);
    fronts.record();
    // An early end is kept in the fronts.
    let _ = fronts.advance(time);
    fronts
}

/// The fronts of a projectile that the fibres brake, m dv/dt = −F.
///
/// In each of the equal steps the velocity is the one that the projectile is to have in the middle:
/// the momentum lost so far is known, half a step more is taken from the step before.
fn braked<M: PiecewiseLinear + Clone>(
    problem: &Problem<M>,
    mass: f64,
    time: f64,
    steps: usize,
    limits: Limits,
) -> Fronts<M> {
    let step = time / steps as f64;
    let mut fronts = Fronts::new(problem, limits);
    fronts.record();
    let mut last = fronts.resistance() * step;
    for k in 1..=steps {
        let before = fronts.accounts().braking;
        fronts.strike(problem.velocity - (before + last / 2.0) / mass);
        if fronts.advance(time * (k as f64 / steps as f64)).is_err() {
            break;
        }
        last = fronts.accounts().braking - before;
    }
    fronts
}

/// ∫|ε_a − ε_b| dX over the length, of two profiles of one fibre.
pub fn mean_difference(a: &[Segment], b: &[Segment]) -> f64 {
    let (mut i, mut j, mut from, mut sum) = (0, 0, 0.0_f64, 0.0);
    while let (Some(p), Some(q)) = (a.get(i), b.get(j)) {
        let to = p.to.min(q.to);
        sum += (to - from).max(0.0) * (p.state.strain - q.state.strain).abs();
        from = from.max(to);
        i += usize::from(p.to <= to);
        j += usize::from(q.to <= to);
    }
    if from > 0.0 { sum / from } else { 0.0 }
}

#[cfg(test)]
mod tests;
