//! What a run ought to show, from solutions that share nothing with the scheme.

use crossfibre::exact::fronts::Segment;
use crossfibre::exact::smith as exact;
use crossfibre::exact::viscoelastic::{Arm, PulledRod};
use crossfibre::material;
use crossfibre::place::Fibre;
use crossfibre::scene::{Law, Scene};

use super::run::Run;
use crate::closed_form::{self, component, law};
use crate::oracle::{motion, pulled_rod, rod_at};
use crate::summary::exact as summary;

/// A piece of a fibre that is strained uniformly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where it begins, unstrained, m from the impact point (the crossover).
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Its strain, in the scene's measure.
    pub strain: f64,
}

/// Uniform strain in a window that no front touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// The window, m.
    pub window: (f64, f64),
    /// The strain.
    pub strain: f64,
}

/// What the crossover makes of the wave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Around {
    /// On the primary, between the impact point and the crossover.
    pub behind: Plateau,
    /// On the primary, beyond it.
    pub ahead: Plateau,
    /// On the secondary.
    pub diverted: Plateau,
    /// The strain that comes in.
    pub incident: f64,
}

/// Where a fibre turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kink {
    /// Where, m.
    pub at: f64,
    /// Half-way between the inclinations on both sides: sines.
    pub level: f64,
}

/// When the front passes a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The place, m.
    pub station: f64,
    /// The strain that counts as arrived: half of what follows.
    pub level: f64,
    /// When, s.
    pub time: f64,
}

/// The exact answer at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact {
    /// The primary, outward.
    pub primary: Vec<Piece>,
    /// The secondary, outward; empty if there is none.
    pub secondary: Vec<Piece>,
    /// The widest plateau of the primary.
    pub plateau: Option<Plateau>,
    /// The crossover's coefficients, as long as they last.
    pub around: Option<Around>,
    /// The primary's sharpest kink.
    pub kink: Option<Kink>,
    /// Velocity of the projectile, m/s.
    pub projectile_velocity: f64,
    /// Mean error of these strains along a fibre that the solution admits itself, over the mean strain
    /// of the primary.
    pub floor: f64,
}

/// Part of the way to the crossover, or of the fibre, at which the front is awaited.
const STATION: f64 = 0.617;

/// Cells in which the profile of a rod is sampled, at least.
const SAMPLES: usize = 512;

/// Pairs of them in an element, at least. Pairs, because ∫|ε − exact| over an element that crosses the
/// profile in its middle is met by an even number of cells, and missed by an odd one.
const PAIRS: usize = 2;

/// Share of a plateau that its window keeps clear at both ends.
const CLEAR: f64 = 0.25;

impl Exact {
    /// The answer to a run at the time that it has reached; an error says why there is none.
    pub fn of(run: &Run, time: f64) -> Result<Self, String> {
        if run.pulled_along {
            Self::of_rod(&run.scene, time)
        } else {
            Self::of_fronts(&run.scene, time)
        }
    }

    fn of_rod(scene: &Scene, time: f64) -> Result<Self, String> {
        let rod = rod(scene)?;
        let front = rod.front_speed() * time;
        if front > scene.primary.length {
            return Err("the front has reached the clamp".into());
        }
        let elements = scene.primary.elements;
        let cells = 2 * elements * SAMPLES.div_ceil(2 * elements).max(PAIRS);
        let dx = scene.primary.length / cells as f64;
        let mut primary = Vec::new();
        for k in 0..cells {
            let (from, to) = (k as f64 * dx, ((k + 1) as f64 * dx).min(front));
            if from >= to {
                break;
            }
            let state = rod_at(&rod, 0.5 * (from + to), time).map_err(|error| error.to_string())?;
            primary.push(Piece { from, to, strain: state.strain });
        }
        primary.push(Piece { from: front, to: scene.primary.length, strain: 0.0 });
        // What a sum over middles leaves of an integral: a bend by a second difference, over 24. Norms
        // have corners where the error changes its sign: three times that.
        let bends = primary.windows(3).filter(|three| three[2].strain != 0.0);
        let bend = |three: &[Piece]| three[0].strain - 2.0 * three[1].strain + three[2].strain;
        let apart: f64 = bends.map(|three| 0.125 * bend(three).abs() * dx).sum();
        Ok(Self {
            floor: apart / integral(&primary),
            plateau: None,
            primary,
            secondary: Vec::new(),
            around: None,
            kink: None,
            projectile_velocity: scene.projectile.velocity,
        })
    }

    fn of_fronts(scene: &Scene, time: f64) -> Result<Self, String> {
        if let Some(why) = closed_form::beyond(scene) {
            return Err(why);
        }
        let solved = motion(&closed_form::problem(scene), scene.projectile.mass, time);
        if let Some(ended) = solved.ended {
            return Err(ended.to_string());
        }
        let [primary, secondary] =
            [&solved.primary, &solved.secondary].map(|segments| pieces(scene, segments));
        // Where a closed form holds it is taken: it has no chords.
        let around = around(scene, &summary::Exact::of(scene, time).plateaus);
        let plateau = only_plateau(scene, time).or_else(|| widest(&primary));
        Ok(Self {
            floor: solved.error_bound * scene.primary.length / integral(&primary),
            plateau,
            around,
            kink: kink(&solved.primary),
            projectile_velocity: solved.projectile_velocity,
            primary,
            secondary,
        })
    }
}

impl Arrival {
    /// When the front passes a place of its own choice; none where no solution says.
    pub fn of(run: &Run) -> Option<Self> {
        let scene = &run.scene;
        let way = scene.secondary.as_ref().map_or(scene.primary.length, |secondary| secondary.at);
        let station = STATION * way;
        if run.pulled_along {
            let rod = rod(scene).ok()?;
            let level = 0.5 * rod.front(station).strain;
            return Some(Self { station, level, time: station / rod.front_speed() });
        }
        if scene.projectile.mass.is_some() || closed_form::beyond(scene).is_some() {
            return None;
        }
        let impact =
            closed_form::struck(scene, &scene.primary.material, scene.primary.density).ok()?;
        let half = match law(scene) {
            exact::Law::Engineering => {
                exact::Strain::from_engineering(0.5 * impact.strain.engineering)
            }
            exact::Law::Logarithmic => {
                exact::Strain::from_logarithmic(0.5 * impact.strain.logarithmic)
            }
        };
        // In the fan of a law that softens each strain has its own speed.
        let speed = impact.front_speed * law(scene).longitudinal_speed(half);
        Some(Self { station, level: component(scene, half), time: station / speed })
    }
}

/// The rod that a scene pulls at.
pub fn rod(scene: &Scene) -> Result<PulledRod, String> {
    let Law::Viscoelastic { equilibrium_modulus, arms, .. } = &scene.primary.material.law else {
        return Err("the pulled rod is known for viscoelastic fibres only".into());
    };
    let arm = |arm: &material::Arm| {
        let material::Arm { modulus, relaxation_time } = *arm;
        Arm { modulus, relaxation_time }
    };
    let arms: Vec<_> = arms.iter().map(arm).collect();
    pulled_rod(scene.primary.density, *equilibrium_modulus, &arms, scene.projectile.velocity)
        .map_err(|error| error.to_string())
}

/// Segments in the scene's measure.
fn pieces(scene: &Scene, segments: &[Segment]) -> Vec<Piece> {
    let strain = |of: &Segment| component(scene, exact::Strain::from_engineering(of.state.strain));
    segments.iter().map(|s| Piece { from: s.from, to: s.to, strain: strain(s) }).collect()
}

/// ∫|ε| dX.
pub fn integral(pieces: &[Piece]) -> f64 {
    pieces.iter().map(|piece| (piece.to - piece.from) * piece.strain.abs()).sum()
}

/// The middle of an interval.
fn middle((from, to): (f64, f64)) -> (f64, f64) {
    (from + CLEAR * (to - from), to - CLEAR * (to - from))
}

fn clear(of: &summary::Plateau) -> Plateau {
    Plateau { window: middle((of.from, of.to)), strain: of.strain }
}

/// The plateau of a fibre that has only one, by the closed form of any elastic law.
pub fn only_plateau(scene: &Scene, time: f64) -> Option<Plateau> {
    match &summary::Exact::of(scene, time).plateaus[..] {
        [only] => Some(clear(only)),
        _ => None,
    }
}

/// The widest piece that is strained.
fn widest(pieces: &[Piece]) -> Option<Plateau> {
    let strained = pieces.iter().filter(|piece| piece.strain != 0.0);
    let width = |piece: &Piece| piece.to - piece.from;
    let widest = strained.max_by(|a, b| width(a).total_cmp(&width(b)))?;
    Some(Plateau { window: middle((widest.from, widest.to)), strain: widest.strain })
}

/// The plateaus around a crossover, as long as they last.
fn around(scene: &Scene, lasting: &[summary::Plateau]) -> Option<Around> {
    let named = |what| lasting.iter().find(|plateau| plateau.what == what).map(clear);
    let diverted = lasting.iter().find(|plateau| plateau.fibre == Fibre::Secondary).map(clear)?;
    let incident =
        closed_form::struck(scene, &scene.primary.material, scene.primary.density).ok()?;
    Some(Around {
        behind: named("strain before crossover")?,
        ahead: named("strain beyond crossover")?,
        diverted,
        incident: component(scene, incident.strain),
    })
}

/// Where the direction changes most.
fn kink(segments: &[Segment]) -> Option<Kink> {
    let turn = |pair: &[Segment]| (pair[0].state.direction - pair[1].state.direction).norm();
    let sharpest = segments.windows(2).max_by(|a, b| turn(a).total_cmp(&turn(b)))?;
    let level = 0.5 * (sharpest[0].state.direction.y + sharpest[1].state.direction.y);
    (turn(sharpest) > 0.0).then_some(Kink { at: sharpest[0].to, level })
}

#[cfg(test)]
mod tests {
    use crossfibre::exact::riemann::State;
    use nalgebra::Vector3;

    use super::*;
    use crate::cases::support::shipped;
    use crate::precision::variants::Precision;

    #[test]
    fn a_kink_is_where_the_direction_changes_most_and_between_its_directions() {
        let segment = |from: f64, to: f64, y: f64| {
            let direction = Vector3::new((1.0 - y * y).sqrt(), y, 0.0);
            let state = State { strain: 0.013, direction, velocity: Vector3::zeros() };
            Segment { from, to, state }
        };
        let bent = [segment(0.0, 0.3, 0.31), segment(0.3, 0.7, 0.3), segment(0.7, 1.1, 0.1)];
        let kink = kink(&bent).unwrap();
        assert_eq!((kink.at, kink.level), (0.7, 0.2));
        assert!(super::kink(&[segment(0.0, 0.3, 0.3), segment(0.3, 0.7, 0.3)]).is_none());
    }

    #[test]
    fn no_front_is_awaited_whose_time_no_solution_knows() {
        let is_awaited = |name| {
            let scene = shipped(name);
            let precision = Precision::Double;
            let run = Run { scene, pulled_along: false, precision, flagged: true };
            Arrival::of(&run).is_some()
        };
        assert!(is_awaited("single-400") && is_awaited("fig3"));
        for name in ["finite-projectile", "hardening", "viscoelastic"] {
            assert!(!is_awaited(name), "{name}");
        }
    }
}
