//! Vectors of whole runs: the shipped scenes.

use std::collections::BTreeMap;

use crossfibre::balance::Balance;
use crossfibre::outcome::Outcome;
use crossfibre::result::FibreResult;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::effect::Effect;
use super::file::Flag;
use crate::bits::fnv;
use crate::cases::support::{SCENES, shipped};
use crate::planted;

/// A run of a shipped scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunVector {
    /// Name of the scene.
    pub id: String,
    /// The edition.
    pub flags: Vec<Flag>,
    /// Name of the scene's file.
    pub scene_file: String,
    /// How it ends.
    pub outcome: Outcome,
    /// Steps made.
    pub steps: u64,
    /// Δt, s.
    pub time_step: f64,
    /// Time reached, s.
    pub time: f64,
    /// What it amounts to.
    pub effect: Effect,
    /// The struck fibre.
    pub primary: Samples,
    /// The crossing fibre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub secondary: Option<Samples>,
    /// Distance travelled by the projectile, m.
    pub projectile_position: f64,
    /// Where the fibres cross.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crossover: Option<Crossover>,
    /// Energy and momentum; none where a sum is not finite.
    pub balance: Option<Balance>,
    /// Elements visited, summed over the steps and the fibres.
    pub element_steps: u64,
    /// Evaluations of each numbered equation.
    pub evaluations: BTreeMap<String, u64>,
}

/// A fibre at the end of a run: some of its numbers, and a digest of all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Samples {
    /// FNV-1a, 64 bits, in hexadecimal, of the little-endian bytes of all positions, then all
    /// velocities (both node by node, component by component), then all strains, then all tensions.
    pub digest: String,
    /// Nodes, evenly spread from end to end.
    pub nodes: Vec<Node>,
    /// Elements, likewise.
    pub elements: Vec<Element>,
}

/// A node at the end of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Node {
    /// From 0.
    pub index: usize,
    /// m.
    pub position: Vec<f64>,
    /// m/s.
    pub velocity: Vec<f64>,
}

/// An element at the end of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Element {
    /// From 0.
    pub index: usize,
    /// As the scene measures it.
    pub strain: f64,
    /// N.
    pub tension: f64,
}

/// Where the fibres cross.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Crossover {
    /// `ix`, from 0.
    pub node: usize,
    /// How often it has changed.
    pub moves: u64,
    /// Distance of the secondary's first node from that node, m.
    pub distance: f64,
}

/// Every shipped scene.
pub fn vectors() -> Vec<RunVector> {
    SCENES.iter().map(|(name, _)| vector(name)).collect()
}

fn vector(name: &str) -> RunVector {
    let scene = shipped(name);
    let result = planted::run(&scene, |_| ());
    let equations = &result.counts.equations;
    RunVector {
        id: name.into(),
        flags: Flag::of(&scene),
        scene_file: format!("{name}.json"),
        effect: Effect::of(&scene, &result),
        steps: result.steps,
        time_step: result.time_step,
        time: result.time,
        primary: Samples::of(&result.primary),
        secondary: result.secondary.as_ref().map(Samples::of),
        projectile_position: result.projectile.position,
        crossover: result.crossover.as_ref().map(|crossover| Crossover {
            node: crossover.node,
            moves: crossover.moves,
            distance: crossover.distance,
        }),
        balance: result.balance,
        element_steps: result.counts.element_steps,
        evaluations: equations.iter().map(|(eq, &times)| (eq.to_string(), times)).collect(),
        outcome: result.outcome,
    }
}

/// How many nodes and elements of a fibre are shown.
const SHOWN: usize = 12;

impl Samples {
    fn of(fibre: &FibreResult) -> Self {
        let vectors = fibre.position.iter().chain(&fibre.velocity).flatten();
        let numbers = vectors.chain(&fibre.strain).chain(&fibre.tension);
        Self {
            digest: format!("{:016x}", fnv(numbers.flat_map(|x| x.to_le_bytes()))),
            nodes: spread(fibre.position.len())
                .map(|i| Node {
                    index: i,
                    position: fibre.position[i].clone(),
                    velocity: fibre.velocity[i].clone(),
                })
                .collect(),
            elements: spread(fibre.strain.len())
                .map(|i| Element { index: i, strain: fibre.strain[i], tension: fibre.tension[i] })
                .collect(),
        }
    }
}

/// Indices from the first to the last of `count`.
fn spread(count: usize) -> impl Iterator<Item = usize> {
    (0..SHOWN).map(move |k| k * (count - 1) / (SHOWN - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_run_from_end_to_end() {
        let indices: Vec<_> = spread(151).collect();
        assert_eq!((indices.len(), indices[0], indices[1], indices[11]), (12, 0, 13, 150));
    }
}
