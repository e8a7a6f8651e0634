//! All that a step leaves behind: what a run can be taken up from.

use crossfibre::scene::Scene;
use serde::{Deserialize, Serialize};

use crate::mesh::Mesh;

/// A fibre: nodes `0..=n` from the impact point (the crossover) to the clamp, elements `0..n`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(bound = "[f64; D]: Serialize + for<'a> Deserialize<'a>")]
pub struct FibreState<const D: usize> {
    /// Of each node, m.
    pub position: Vec<[f64; D]>,
    /// Of each node, m/s; it has carried the node to its position.
    pub velocity: Vec<[f64; D]>,
    /// Of each element.
    pub strain: Vec<f64>,
    /// Of each element, N; as a vector it lies along the element.
    pub tension: Vec<f64>,
}

/// Where the fibres cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Crossover {
    /// `ix`: the nearest node of the primary, from 0.
    pub node: usize,
    /// How often it has changed since impact.
    pub moves: u64,
}

/// A scene after a number of steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Steps made.
    pub step: u64,
    /// The struck fibre.
    pub primary: FibreState<2>,
    /// The crossing fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<FibreState<3>>,
    /// Where it crosses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossover: Option<Crossover>,
    /// For the next step, m/s.
    pub projectile_velocity: f64,
}

impl<const D: usize> FibreState<D> {
    fn at_rest(elements: usize, node: impl Fn(usize) -> [f64; D]) -> Self {
        Self {
            position: (0..=elements).map(node).collect(),
            velocity: vec![[0.0; D]; elements + 1],
            strain: vec![0.0; elements],
            tension: vec![0.0; elements],
        }
    }

    /// Elements that a step visits: up to one beyond the last that has been under tension.
    pub(crate) fn visited(&self) -> usize {
        let under_tension = self.tension.iter().rposition(|&t| t != 0.0).map_or(0, |last| last + 1);
        (under_tension + 1).min(self.tension.len())
    }

    /// Whether the lengths of its lists are those of so many elements.
    pub(crate) fn has(&self, elements: usize) -> bool {
        let Self { position, velocity, strain, tension } = self;
        [position.len(), velocity.len(), strain.len() + 1, tension.len() + 1] == [elements + 1; 4]
    }
}

impl State {
    /// The scene at the moment of impact.
    pub(crate) fn at_impact(scene: &Scene, mesh: &Mesh) -> Self {
        let primary = FibreState::at_rest(mesh.primary.elements, |i| [mesh.primary.node(i), 0.0]);
        let crossing = mesh.secondary.zip(scene.secondary.as_ref());
        Self {
            step: 0,
            primary,
            secondary: crossing.map(|((fibre, _), secondary)| {
                FibreState::at_rest(fibre.elements, |i| [secondary.at, 0.0, fibre.node(i)])
            }),
            crossover: crossing.map(|((_, node), _)| Crossover { node, moves: 0 }),
            projectile_velocity: scene.projectile.velocity,
        }
    }
}

/// `x − y`
#[inline(always)]
pub(crate) fn difference<const D: usize>(x: [f64; D], y: [f64; D]) -> [f64; D] {
    std::array::from_fn(|c| x[c] - y[c])
}

/// `|v|`, the bars of (5) and (6): square root of the sum of squares, in the order of components.
#[inline(always)]
pub(crate) fn magnitude<const D: usize>(v: [f64; D]) -> f64 {
    v[1..].iter().fold(v[0] * v[0], |sum, x| sum + x * x).sqrt()
}
