//! One step of a fibre of four elements, whose numbers are all worked by hand: docs/exact/by-hand.md.

use crossfibre::number::Vector;
use crossfibre::state::{FibreState, State, Wavefront};

use super::{Bound, Check, ROUNDING, check, corrected, fraction};
use crate::cases::support::shipped;
use crate::planted::{at_impact, march};
use crate::worse::worse;

type Point = [f64; 2];

/// Three of the four elements are visited: the far node of the third is pulled by the fourth.
const VISITED: usize = 3;

const TIME_STEP: f64 = 0.1;
const PROJECTILE: f64 = 0.3;

const POSITION: [Point; 5] = [[0.1, 0.2], [0.5, 0.5], [1.0, 1.7], [1.8, 1.1], [3.3, 1.9]];
const VELOCITY: [Point; 5] = [[0.0, 0.37], [-0.1, 1.83], [0.86, 1.05], [-0.06, 0.79], [0.0, 0.0]];
const PULL: [Point; 4] = [[20.0, 15.0], [10.0, 24.0], [-12.0, 9.0], [30.0, 16.0]];
const STRAIN: [f64; 4] = [0.0625, 0.065, -0.0375, 0.085];
const TENSION: [f64; 4] = [25.0, 26.0, -15.0, 34.0];

/// x, y of each node one step later.
const POSITIONS: [[(i64, i64); 2]; 5] = [
    [(10, 100), (23, 100)],
    [(46, 100), (71, 100)],
    [(102, 100), (176, 100)],
    [(192, 100), (120, 100)],
    [(330, 100), (190, 100)],
];
/// u, v.
const VELOCITIES: [[(i64, i64); 2]; 5] = [
    [(0, 1), (3, 10)],
    [(-4, 10), (21, 10)],
    [(2, 10), (6, 10)],
    [(12, 10), (10, 10)],
    [(0, 1), (0, 1)],
];
/// Tension of each element as a vector.
const PULLS: [[(i64, i64); 2]; 4] =
    [[(63, 1), (84, 1)], [(-48, 13), (-90, 13)], [(405, 53), (-252, 53)], [(30, 1), (16, 1)]];
const STRAINS: [(i64, i64); 4] = [(2625, 10_000), (-51, 2600), (225, 10_000), (85, 1000)];

fn vectors(points: &[Point]) -> Vec<Vector<f64, 2>> {
    points.iter().map(|&[x, y]| Vector::<f64, 2>::new(x, y)).collect()
}

/// The state before the step.
fn before() -> State<f64> {
    let mut scene = shipped("single-400");
    scene.primary.elements = 4;
    let mut state = at_impact::<f64>(&scene, Wavefront::Flagged);
    (state.time_step, state.projectile.velocity) = (TIME_STEP, PROJECTILE);
    let FibreState { properties, .. } = &mut state.primary;
    (properties.a, properties.mass, properties.stiffness) = (0.03, 10.0 / 3.0, 400.0);
    state.primary.position = vectors(&POSITION);
    state.primary.velocity = vectors(&VELOCITY);
    state.primary.pull = vectors(&PULL);
    state.primary.strain = STRAIN.into();
    state.primary.tension = TENSION.into();
    state.primary.visited = VISITED;
    state
}

/// The state before the step, and after it.
pub fn four_elements() -> (State<f64>, State<f64>) {
    let mut state = before();
    let before = state.clone();
    let ended = march::step(&corrected(), &mut state);
    assert!(ended.is_ok(), "{ended:?}");
    (before, state)
}

/// What the step makes of every number.
pub fn checks() -> Vec<Check> {
    let (_, after) = four_elements();
    let fibre = &after.primary;
    let strains: Vec<_> = fibre.strain.iter().copied().zip(STRAINS.map(fraction)).collect();
    vec![
        compared(
            "It changes the velocities of nodes",
            &components(&fibre.velocity, &VELOCITIES),
            2.0,
        ),
        compared("It moves the nodes", &components(&fibre.position, &POSITIONS), 2.0),
        compared("It strains the elements", &strains, 16.0),
        compared(
            "It changes the tensions, size and direction",
            &components(&fibre.pull, &PULLS),
            16.0,
        ),
    ]
}

/// Components, and what they are by hand.
fn components(of: &[Vector<f64, 2>], by_hand: &[[(i64, i64); 2]]) -> Vec<(f64, f64)> {
    of.iter().flat_map(|v| [v.x, v.y]).zip(by_hand.iter().flatten().map(|&f| fraction(f))).collect()
}

fn compared(claim: &str, pairs: &[(f64, f64)], most: f64) -> Check {
    let apart = pairs.iter().map(|(got, exact)| (got - exact).abs()).fold(0.0, worse);
    let greatest = pairs.iter().map(|(_, exact)| exact.abs()).fold(0.0, f64::max);
    check(
        claim,
        "the step worked by hand (docs/exact/by-hand.md)",
        "greatest difference over the greatest number, in roundings of 2⁻⁵³",
        apart / (greatest * ROUNDING),
        Bound::AtMost(most),
        "a rounding for each number that is no binary fraction and for each operation; a strain is \
         a difference from 1, a quarter of it, and tensions go by the strains",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A is Δt/Δm: 0.03 = 0.1/(10/3).
    #[test]
    fn the_mass_of_a_node_is_that_of_its_a() {
        let properties = before().primary.properties;
        assert!((properties.a * properties.mass / TIME_STEP - 1.0).abs() < 1e-15);
    }
}
