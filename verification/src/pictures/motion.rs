//! The fibres of Fig. 3 in motion: a few nodes of both at evenly spaced times, as whole numbers.

use crossfibre::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cases::support::{refined, shipped};
use crate::wide;
use crossfibre::state::State;

/// When the motion ends, s: the kink has passed the crossover.
const UNTIL: f64 = 150e-6;

/// Frames beside the first, at rest.
const FRAMES: u64 = 50;

/// Times that the paper's mesh is refined: 1 mm.
const REFINED: usize = 2;

/// From node to node that is kept.
const NODES: usize = 10;

/// From element to element whose strain is kept.
const ELEMENTS: usize = 4;

/// Both fibres at some times. Positions are in hundredths of a millimetre, strains in millionths,
/// times in nanoseconds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The scene's title.
    pub title: String,
    /// From strain to strain along a fibre, unstrained, hundredths of a millimetre.
    pub spacing: i32,
    /// The times.
    pub frames: Vec<Frame>,
}

/// Both fibres at a time: the half of the primary, and the arm of the secondary, that are modelled.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// When, ns.
    pub time: u32,
    /// x and y of nodes of the primary, from the impact point to the clamp.
    pub primary: Vec<[i32; 2]>,
    /// x, y and z of nodes of the secondary, from the crossover to the clamp.
    pub secondary: Vec<[i32; 3]>,
    /// Strains of the primary.
    pub primary_strain: Vec<i32>,
    /// Strains of the secondary.
    pub secondary_strain: Vec<i32>,
}

/// Means over groups of elements, in millionths.
fn strains(of: &[f64]) -> Vec<i32> {
    let mean = |group: &[f64]| group.iter().sum::<f64>() / group.len() as f64;
    of.chunks(ELEMENTS).map(|group| (1e6 * mean(group)).round() as i32).collect()
}

fn hundredths(metres: f64) -> i32 {
    (1e5 * metres).round() as i32
}

fn frame(state: &State<f64>) -> Frame {
    let secondary = state.crossover.as_ref().map(|crossover| &crossover.fibre);
    let nodes = |x: &crossfibre::number::Vector<f64, 3>| [x[0], x[1], x[2]].map(hundredths);
    Frame {
        time: (1e9 * state.time()).round() as u32,
        primary: (state.primary.position.iter().step_by(NODES))
            .map(|x| [x[0], x[1]].map(hundredths))
            .collect(),
        secondary: secondary.map_or_else(Vec::new, |fibre| {
            fibre.position.iter().step_by(NODES).map(nodes).collect()
        }),
        primary_strain: strains(&state.primary.strain),
        secondary_strain: secondary.map_or_else(Vec::new, |fibre| strains(&fibre.strain)),
    }
}

/// That of Fig. 3, corrected, until the kink has passed the crossover.
pub fn fig3() -> Motion {
    let scene = Scene { duration: UNTIL, ..refined(shipped("fig3"), REFINED) };
    let rest = State::<f64>::at_impact(&scene, crossfibre::state::Wavefront::Flagged);
    let mut frames = vec![frame(&rest)];
    wide::run(&scene, |state| {
        if state.time() >= UNTIL * frames.len() as f64 / FRAMES as f64 {
            frames.push(frame(state));
        }
    });
    let spacing =
        hundredths(ELEMENTS as f64 * scene.primary.length / scene.primary.elements as f64);
    Motion { title: scene.title, spacing, frames }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_projectile_moves_steadily_and_the_crossover_is_on_the_primary() {
        let Motion { frames, .. } = fig3();
        assert!(frames.len() >= 50, "{}", frames.len());
        for frame in &frames {
            // 400 m/s for so many ns, in 0.01 mm; absolute, 1: rounding of both to whole numbers, of
            // a nanosecond 0.04.
            let expected = 0.04 * f64::from(frame.time);
            assert!((f64::from(frame.primary[0][1]) - expected).abs() <= 1.0, "{frame:?}");
            // The secondary crosses at 0.1 m: node 100, the tenth that is kept. They are one point but
            // for the ledger's `slip-drift`; absolute, 1: rounding.
            let [x, y, z] = frame.secondary[0];
            let [on_x, on_y] = frame.primary[10];
            assert!((x - on_x).abs() <= 1 && (y - on_y).abs() <= 1 && z == 0, "{frame:?}");
        }
        // The kink has passed the crossover: it has been carried along with the primary.
        assert!(frames.last().is_some_and(|frame| frame.secondary[0][1] > 300));
    }
}
