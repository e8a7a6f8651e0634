//! Vectors of the twenty equations.

use std::collections::BTreeMap;

use crossfibre::equations::EQUATIONS;
use crossfibre::errata::Corrections;
use crossfibre::number::Vector;
use crossfibre::paper::{Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush};
use crossfibre::scene::Strain;
use crossfibre::trace::{Event, Traced};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::draw::{Draw, Special};
use super::file::Flag;
use super::value::Value;
use crate::planted::{Edition, edition};

/// One evaluation of one equation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EquationVector {
    /// Equation, dimension where there are two, edition, and which set of inputs: the same name is
    /// the same inputs in every edition.
    pub id: String,
    /// The number of the equation on the page, as a name.
    pub eq: String,
    /// Its edition, and what kind of numbers these are.
    pub flags: Vec<Flag>,
    /// What goes in, by the symbols of traces.
    #[serde(rename = "in")]
    pub inputs: BTreeMap<String, Value>,
    /// What comes out.
    pub out: Value,
}

impl EquationVector {
    /// What goes in, as numbers.
    pub fn numbers(&self) -> BTreeMap<String, Vec<f64>> {
        self.inputs.iter().map(|(name, value)| (name.clone(), value.numbers())).collect()
    }
}

/// Sets of awkward inputs for each equation.
const AWKWARD: u64 = 6;

/// Equations of vectors that have as many components as their fibre has dimensions.
const IN_TWO_DIMENSIONS_AND_THREE: [u8; 4] = [1, 2, 5, 6];

/// Every equation in every edition.
pub fn vectors() -> Vec<EquationVector> {
    let awkward = (1..=AWKWARD).map(|k| (format!("awkward-{k}"), k, None));
    let special = Special::ALL.map(|(name, special)| (name.to_owned(), 1, Some(special)));
    of_sets(&awkward.chain(special).collect::<Vec<_>>())
}

/// Every equation in every edition, with as many sets of awkward inputs; another seed, others.
pub fn drawn(seed: u64, sets: u64) -> Vec<EquationVector> {
    let first = AWKWARD.wrapping_add(seed.wrapping_mul(sets));
    let set = |k| (format!("drawn-{}", k + 1), first.wrapping_add(k + 1), None);
    of_sets(&(0..sets).map(set).collect::<Vec<_>>())
}

/// The name of a set of inputs, its seed, and what is special about it.
type Set = (String, u64, Option<Special>);

fn of_sets(sets: &[Set]) -> Vec<EquationVector> {
    let mut vectors = Vec::new();
    for equation in EQUATIONS {
        let number = equation.number;
        if IN_TWO_DIMENSIONS_AND_THREE.contains(&number) {
            editions::<2>(&mut vectors, number, "/2d", sets);
            editions::<3>(&mut vectors, number, "/3d", sets);
        } else {
            editions::<2>(&mut vectors, number, "", sets);
        }
    }
    vectors
}

fn editions<const D: usize>(
    vectors: &mut Vec<EquationVector>,
    number: u8,
    dimension: &str,
    sets: &[Set],
) {
    let name = |edition: &str| format!("{number}{dimension}/{edition}");
    let mut of = |paper: &Edition, edition: &str, flags: &[Flag]| {
        vectors.extend(evaluations::<D>(paper, number, &name(edition), flags, sets));
    };
    of(&edition(Strain::Incremental, Corrections::NONE), "printed", &[Flag::Printed]);
    of(&edition(Strain::Incremental, Corrections::ALL), "corrected", &[Flag::Corrected]);
    if number == 4 {
        let engineering = edition(Strain::Engineering, Corrections::ALL);
        let flags = [Flag::Corrected, Flag::Engineering];
        let name = name("engineering");
        vectors.extend(evaluations::<D>(&engineering, number, &name, &flags, sets));
    }
}

/// The vectors of an equation in an edition. A set that leaves the inputs of this equation as they
/// were is left out.
fn evaluations<const D: usize>(
    paper: &impl Paper<f64>,
    number: u8,
    name: &str,
    edition: &[Flag],
    sets: &[Set],
) -> Vec<EquationVector> {
    let mut vectors = Vec::<EquationVector>::new();
    for &(ref set, k, special) in sets {
        let draw = &mut Draw::new((u64::from(number) << 32).wrapping_add(k), special);
        let (inputs, out) = evaluated::<D>(paper, number, draw);
        let flag = if special.is_some() { Flag::SpecialValue } else { Flag::Awkward };
        let flags = [edition, &[flag]].concat();
        if vectors.iter().all(|before| before.inputs != inputs) {
            let (id, eq) = (format!("{name}/{set}"), number.to_string());
            vectors.push(EquationVector { id, eq, flags, inputs, out });
        }
    }
    vectors
}

/// Inputs and output of an evaluation, named as a tracer names them.
fn evaluated<const D: usize>(
    paper: &impl Paper<f64>,
    number: u8,
    draw: &mut Draw,
) -> (BTreeMap<String, Value>, Value) {
    let mut seen = None;
    let traced = Traced::new(paper, |event: &Event<'_, f64>| {
        let named = event.inputs.iter().map(|(name, value)| ((*name).to_owned(), value.into()));
        seen = Some((named.collect(), (&event.output).into()));
    });
    evaluate::<D>(&traced, number, draw);
    seen.expect("an evaluation is reported")
}

/// Evaluates an equation for what the paper reports of it.
fn evaluate<const D: usize>(paper: &impl Paper<f64>, number: u8, draw: &mut Draw) {
    match number {
        1 => {
            let (ahead, here) = (draw.tensions::<D>(), draw.tensions());
            let mass_over_time_step = draw.node_mass() / draw.time_step();
            let (now, before) = (draw.velocities(), draw.velocities());
            paper.eqn_1_impulse_residual(ahead, here, mass_over_time_step, now, before);
        }
        2 => {
            let (before, a) = (draw.velocities::<D>(), draw.a());
            paper.eqn_2_velocity(before, a, draw.tensions(), draw.tensions());
        }
        3 => {
            paper.eqn_3_strain_increment(draw.length(), draw.length());
        }
        4 => {
            let lengths =
                Lengths { now: draw.length(), previous: draw.length(), unstrained: draw.length() };
            paper.eqn_4_strain(draw.strain(), lengths);
        }
        5 => {
            let here = draw.position::<D>();
            paper.eqn_5_previous_length(draw.next_to(here), here);
        }
        6 => {
            let here = draw.position::<D>();
            let (ahead, dt) = (draw.next_to(here), draw.time_step());
            paper.eqn_6_length(ahead, draw.velocities(), here, draw.velocities(), dt);
        }
        7 => {
            paper.eqn_7_tension(draw.stiffness(), draw.strain());
        }
        8 => {
            paper.eqn_8_projectile_velocity(ProjectilePush {
                velocity: draw.velocity(),
                tension_y: draw.tension(),
                mass: draw.projectile_mass(),
                node_mass: draw.node_mass(),
                time_step: draw.time_step(),
                time: draw.time(),
            });
        }
        9 => {
            paper.eqn_9_parallel_velocity(draw.velocity(), draw.velocity(), theta(draw));
        }
        10 => {
            paper.eqn_10_perpendicular_velocity(draw.velocity(), draw.velocity(), theta(draw));
        }
        11 => {
            let behind = draw.position();
            paper.eqn_11_direction(draw.next_to(behind), behind);
        }
        12 => {
            let (slide_factor, parallel) = (draw.slide_factor(), draw.velocity());
            paper.eqn_12_secondary_u(slide_factor, parallel, draw.velocity(), theta(draw));
        }
        13 => {
            let (slide_factor, parallel) = (draw.slide_factor(), draw.velocity());
            paper.eqn_13_secondary_v(slide_factor, parallel, draw.velocity(), theta(draw));
        }
        14 => {
            paper.eqn_14_secondary_w();
        }
        15 => {
            paper.eqn_15_parallel_tension(draw.tension(), across(draw), cosines(draw));
        }
        16 => {
            paper.eqn_16_perpendicular_tension(draw.tension(), across(draw), cosines(draw));
        }
        17 => {
            paper.eqn_17_u_at_crossover(draw.velocity(), push(draw));
        }
        18 => {
            paper.eqn_18_v_at_crossover(draw.velocity(), push(draw));
        }
        19 => {
            paper.eqn_19_acceleration(draw.wave_speed(), draw.curvature());
        }
        20 => {
            paper.eqn_20_courant(draw.wave_speed(), draw.time_step(), draw.length());
        }
        _ => unreachable!("the page has (1) to (20)"),
    }
}

fn theta(draw: &mut Draw) -> Direction<f64> {
    let v: Vector<f64, 2> = draw.direction();
    Direction { cos: v.x, sin: v.y }
}

/// Direction cosines of the primary.
fn cosines(draw: &mut Draw) -> Cosines<f64> {
    let v: Vector<f64, 2> = draw.direction();
    Cosines { x: v.x, y: v.y }
}

/// Direction cosines of the secondary, most of which goes along z.
fn across(draw: &mut Draw) -> Cosines<f64> {
    let v: Vector<f64, 3> = draw.direction();
    Cosines { x: v.x, y: v.y }
}

fn push(draw: &mut Draw) -> CrossoverPush<f64> {
    CrossoverPush {
        a: draw.a(),
        slide_factor: draw.slide_factor(),
        perpendicular: draw.tension(),
        parallel: draw.tension(),
        primary: cosines(draw),
        change: draw.velocities(),
        mass: draw.node_mass(),
        secondary_mass: draw.node_mass(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_sets_follow_the_awkward_ones_and_those_of_the_seed_before() {
        let of = |vectors: Vec<EquationVector>| -> Vec<_> {
            let chosen = vectors.into_iter().filter(|vector| vector.id.starts_with("7/corrected/"));
            chosen.map(|vector| (vector.id, vector.inputs)).collect()
        };
        let (stored, two, next) = (of(vectors()), of(drawn(0, 2)), of(drawn(1, 1)));
        let ids: Vec<&str> = two.iter().map(|(id, _)| id.as_str()).collect();
        assert_eq!(ids, ["7/corrected/drawn-1", "7/corrected/drawn-2"]);
        // One set of seed 0, then one of seed 1: the second of two sets of seed 0.
        assert_eq!(next[0].1, two[1].1);
        assert!(two.iter().all(|(_, inputs)| stored.iter().all(|(_, known)| known != inputs)));
    }
}
