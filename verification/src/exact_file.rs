//! The exact motion of a scene as a file, `crossfibre-exact/1`.

use crossfibre::exact::crossover::Coefficients;
use crossfibre::exact::fronts::{Ended, Segment};
use crossfibre::exact::motion::Motion;
use crossfibre::exact::smith::Strain as ExactStrain;
use crossfibre::scene::{Scene, Strain};
use schemars::JsonSchema;
use serde::Serialize;

use crate::closed_form;
use crate::oracle::motion;

/// Uniform pieces of both fibres at one time. Lengths are unstrained.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExactFile {
    /// `crossfibre-exact/1`.
    pub format: &'static str,
    /// The scene's.
    pub title: String,
    /// The time solved to, s.
    pub time: f64,
    /// Why that is earlier than what was asked for; none if it is not.
    pub ended: Option<Ended>,
    /// The measure of every strain here: ln λ for `incremental`, λ − 1 for `engineering`.
    pub measure: Strain,
    /// How it was solved.
    pub solution: Solution,
    /// The primary from the impact point outward.
    pub primary: Vec<Piece>,
    /// The secondary from the crossover outward; empty if there is none.
    pub secondary: Vec<Piece>,
    /// Velocity of the projectile, m/s.
    pub projectile_velocity: f64,
    /// What the crossover makes of the incident strain until a wave shed by the kink comes back to
    /// it; none without one, and for a projectile that slows down.
    pub coefficients: Option<Coefficients>,
    /// Bound of the mean error of strain (λ − 1) along a fibre.
    pub error_bound: f64,
}

/// A uniform piece of a fibre.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Piece {
    /// Where it begins, m from the impact point (the crossover).
    pub from: f64,
    /// Where it ends, m.
    pub to: f64,
    /// Strain in the scene's measure.
    pub strain: f64,
    /// Velocity, m/s: x and y on the primary; x, y and z on the secondary.
    pub velocity: Vec<f64>,
    /// Unit vector along the fibre, outward.
    pub direction: Vec<f64>,
}

/// How the motion was solved.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Solution {
    /// Whether nothing but waves below the resolution is left out.
    pub exact: bool,
    /// Chords by which the curved law is replaced up to the strain of the impact; none for a
    /// straight law.
    pub chords: Option<usize>,
    /// Steps by which the falling velocity of the projectile is replaced; none for a constant one.
    pub velocity_steps: Option<usize>,
    /// Strain below which a wave is left out, and strain times fraction of the length below which
    /// two fronts are one.
    pub resolution: f64,
    /// Meetings of fronts.
    pub meetings: u64,
}

impl ExactFile {
    /// The exact motion of a scene up to a time, s.
    pub fn of(scene: &Scene, time: f64) -> (Self, Motion) {
        let solved = motion(&closed_form::problem(scene), scene.projectile.mass, time);
        let file = Self {
            format: "crossfibre-exact/1",
            title: scene.title.clone(),
            time: solved.time,
            ended: solved.ended,
            measure: scene.strain,
            solution: Solution::of(&solved),
            primary: pieces(scene, &solved.primary, 2),
            secondary: pieces(scene, &solved.secondary, 3),
            projectile_velocity: solved.projectile_velocity,
            coefficients: closed_form::coefficients(scene),
            error_bound: solved.error_bound,
        };
        (file, solved)
    }
}

impl Solution {
    fn of(solved: &Motion) -> Self {
        let approximation = solved.approximation;
        Self {
            exact: approximation == Default::default(),
            chords: approximation.chords,
            velocity_steps: approximation.velocity_steps,
            resolution: solved.resolution,
            meetings: solved.events,
        }
    }
}

fn pieces(scene: &Scene, segments: &[Segment], dimensions: usize) -> Vec<Piece> {
    let components = |vector: &[f64]| vector[..dimensions].to_vec();
    segments
        .iter()
        .map(|segment| {
            let strain = ExactStrain::from_engineering(segment.state.strain);
            Piece {
                from: segment.from,
                to: segment.to,
                strain: closed_form::component(scene, strain),
                velocity: components(segment.state.velocity.as_slice()),
                direction: components(segment.state.direction.as_slice()),
            }
        })
        .collect()
}
