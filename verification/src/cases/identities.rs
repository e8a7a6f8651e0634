//! Runs that must agree to the bit, and numbers that must be exactly zero.

use crossfibre::errata::Corrections;
use crossfibre::scene::Scene;
use crossfibre::state::{FibreState, State, Wavefront};

use super::support::{check, different_bits, marched, marched_from, shipped, sliding_by, watched};
use super::{Bound, Case, Check};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "identity.both-at-origin",
        title: "The paper's experiment: both fibres at the impact point",
        equations: &[2, 4, 5, 6, 7, 14],
        run: both_at_origin,
    },
    Case {
        id: "identity.free-sliding",
        title: "α_s = 0: the crossover is not felt until the kink arrives",
        equations: &[9, 10, 12, 13, 15, 16, 17, 18],
        run: free_sliding,
    },
    Case {
        id: "identity.wavefront-flags",
        title: "The paper's flags change no bit",
        equations: &[2, 4, 5, 6, 7],
        run: wavefront_flags,
    },
    Case {
        id: "identity.causality",
        title: "Nothing moves ahead of the front",
        equations: &[2, 4, 5, 6, 7],
        run: causality,
    },
];

const BITS: &str = "positions, velocities, strains and tensions whose bits differ";
const EXACT: &str = "the same operations on the same numbers";

fn both_at_origin() -> Vec<Check> {
    let single = marched(shipped("single-400"));
    let both = marched(shipped("both-at-origin"));
    let secondary = &both.state.crossover.as_ref().expect("both fibres").fibre;
    let single = &single.state.primary;
    vec![
        check(
            "The primary fibre responds as a single fibre",
            "the run of the single fibre",
            BITS,
            different_bits(single, &both.state.primary, |k| k),
            Bound::Exactly(0.0),
            EXACT,
        ),
        check(
            "So does the secondary, in its own plane",
            "the run of the single fibre, x for z",
            BITS,
            different_bits(single, secondary, |k| [2, 1][k]),
            Bound::Exactly(0.0),
            "0 + y² + z² is x² + y² with the names changed; addition commutes to the bit",
        ),
        check(
            "and it does not leave that plane",
            "symmetry",
            "nodes with x or u other than zero",
            off_plane(secondary) as f64,
            Bound::Exactly(0.0),
            EXACT,
        ),
    ]
}

/// Nodes that are out of the plane x = 0, or move out of it.
fn off_plane(fibre: &FibreState<f64, 3>) -> usize {
    let nodes = fibre.position.iter().zip(&fibre.velocity);
    nodes.filter(|(x, v)| x.x != 0.0 || v.x != 0.0).count()
}

fn free_sliding() -> Vec<Check> {
    let single = marched(shipped("single-400"));
    let crossed = |corrections| marched(Scene { corrections, ..sliding_by(0.0, shipped("fig3")) });
    let single = &single.state.primary;
    let corrected = crossed(Corrections::ALL);
    let corrected = &corrected.state.primary;
    let printed = crossed(Corrections::NONE);
    // Of the corrected run, everything but motion across the fibre.
    let axial = {
        let mut axial = corrected.clone();
        for (i, (x, v)) in single.position.iter().zip(&single.velocity).enumerate() {
            (axial.position[i].y, axial.velocity[i].y) = (x.y, v.y);
        }
        different_bits(single, &axial, |k| k)
    };
    let pairs = single.position.iter().zip(&corrected.position);
    let across = pairs.map(|(a, b)| (a.y - b.y).abs()).fold(0.0, worse);
    vec![
        check(
            "As printed the primary is a single fibre at 28.7 µs",
            "the run of the single fibre",
            BITS,
            different_bits(single, &printed.state.primary, |k| k),
            Bound::Exactly(0.0),
            "every term of the coupling has a factor that is exactly zero; the kink arrives at \
             120 µs",
        ),
        check(
            "Corrected it is one in strain, tension and motion along the fibre",
            "the run of the single fibre",
            BITS,
            axial,
            Bound::Exactly(0.0),
            "along the fibre the secondary's share of the inertia is α_s² = 0",
        ),
        check(
            "and across it but for the forerunners of the kink, which feel the secondary's inertia",
            "the run of the single fibre",
            "greatest difference of y, m",
            across,
            Bound::AtMost(1e-59),
            "on a mesh the kink has a forerunner that decays by a factor of 50 an element: 1e-60 m \
             at the crossover",
        ),
    ]
}

fn wavefront_flags() -> Vec<Check> {
    ["single-400", "fig3", "fig3-printed", "unequal", "sliding"]
        .into_iter()
        .map(|name| {
            let with = marched(shipped(name));
            let without = marched_from(shipped(name), Wavefront::Ignored, &|_| {});
            check(
                format!("{name}: with the flags and without them"),
                "the run that visits every element in every step",
                BITS,
                different_in_both(&with.state, &without.state),
                Bound::Exactly(0.0),
                "ahead of the front every operation has zero for its result",
            )
        })
        .collect()
}

/// [`different_bits`] of both fibres.
fn different_in_both(a: &State<f64>, b: &State<f64>) -> f64 {
    let mut different = different_bits(&a.primary, &b.primary, |k| k);
    if let (Some(a), Some(b)) = (&a.crossover, &b.crossover) {
        different += different_bits(&a.fibre, &b.fibre, |k| k);
    }
    different
}

fn causality() -> Vec<Check> {
    let violations = |name: &str| {
        let mut count = 0;
        let scene = shipped(name);
        watched(scene, Wavefront::Ignored, &|_| {}, |state| count += ahead_of_front(state));
        count as f64
    };
    let late = |name: &str| {
        let mut count = 0;
        watched(shipped(name), Wavefront::Ignored, &|_| {}, |state| {
            count += usize::from(front_is_late(state));
        });
        count as f64
    };
    vec![
        check(
            "Elements that no signal can have reached are unstrained and at rest, single-400",
            "an element a step",
            "elements that are not, over all steps",
            violations("single-400"),
            Bound::Exactly(0.0),
            "exactly zero: nothing but zeros enters",
        ),
        check(
            "The same on both fibres of Fig. 3",
            "an element a step, along the secondary from the step after the front has come",
            "elements that are not, over all steps",
            violations("fig3"),
            Bound::Exactly(0.0),
            "exactly zero: nothing but zeros enters",
        ),
        check(
            "and the signal does take an element a step",
            "the paper: the rate of march matches the rate of propagation",
            "steps in which the front element is still unstrained, single-400",
            late("single-400"),
            Bound::Exactly(0.0),
            "the first strain is small but not zero",
        ),
    ]
}

/// Whether the element that the front must be in is still unstrained; never when the front has passed the
/// last one.
fn front_is_late(state: &State<f64>) -> bool {
    let front = state.step as usize;
    front <= state.primary.elements() && state.primary.strain[front - 1] == 0.0
}

/// Elements and nodes of both fibres that move or are strained though no signal can be there.
fn ahead_of_front(state: &State<f64>) -> usize {
    let step = state.step as usize;
    let mut count = moving_from(&state.primary, step);
    if let Some(crossover) = &state.crossover {
        // Node ix moves from step ix + 1 on.
        count += moving_from(&crossover.fibre, step.saturating_sub(crossover.node));
    }
    count
}

/// Elements from `first` on that are strained, and their far nodes that move.
fn moving_from<const D: usize>(fibre: &FibreState<f64, D>, first: usize) -> usize {
    (first..fibre.elements())
        .filter(|&e| fibre.strain[e] != 0.0 || fibre.velocity[e + 1].iter().any(|&v| v != 0.0))
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::coarse_fig3;

    /// Six elements along, four across from node 2 on.
    fn at_rest() -> State<f64> {
        let mut state = State::at_impact(&coarse_fig3(), Wavefront::Ignored);
        state.crossover.as_mut().unwrap().node = 2;
        state
    }

    #[test]
    fn a_node_is_off_its_plane_by_its_place_or_by_its_velocity() {
        let state = State::<f64>::at_impact(&shipped("both-at-origin"), Wavefront::Flagged);
        let mut fibre = state.crossover.unwrap().fibre;
        assert_eq!(off_plane(&fibre), 0);
        fibre.position[3].x = 1e-300;
        fibre.velocity[5].x = -0.1;
        (fibre.position[7].x, fibre.velocity[7].x) = (0.1, 0.1);
        (fibre.position[8].y, fibre.velocity[9].z) = (0.1, 0.1);
        assert_eq!(off_plane(&fibre), 3);
    }

    #[test]
    fn what_differs_in_either_fibre_is_counted() {
        let (a, mut b) = (at_rest(), at_rest());
        assert_eq!(different_in_both(&a, &b), 0.0);
        b.primary.strain[1] = 0.1;
        let across = &mut b.crossover.as_mut().unwrap().fibre;
        (across.strain[0], across.position[2].y) = (0.1, 0.1);
        assert_eq!(different_in_both(&a, &b), 3.0);
    }

    /// After three steps a signal may be in three elements along and, two elements on, in one across.
    #[test]
    fn what_is_strained_or_moves_ahead_of_the_front_is_counted() {
        fn across(state: &mut State<f64>) -> &mut FibreState<f64, 3> {
            &mut state.crossover.as_mut().unwrap().fibre
        }
        let mut state = at_rest();
        state.step = 3;
        (state.primary.strain[2], state.primary.velocity[3].y) = (0.1, 0.1);
        (across(&mut state).strain[0], across(&mut state).velocity[1].z) = (0.1, 0.1);
        assert_eq!(ahead_of_front(&state), 0);
        state.primary.strain[3] = 0.1;
        (state.primary.strain[4], state.primary.velocity[5].x) = (0.1, 0.1);
        state.primary.velocity[6].y = 0.1;
        across(&mut state).velocity[2].y = 0.1;
        across(&mut state).strain[2] = 0.1;
        assert_eq!(ahead_of_front(&state), 5);
    }

    #[test]
    fn the_front_is_late_while_its_element_is_unstrained_and_never_beyond_the_last() {
        let mut state = at_rest();
        for (step, strain) in [(1, 0.0), (1, 1e-300), (6, 0.0), (6, -0.1)] {
            state.step = step;
            state.primary.strain[step as usize - 1] = strain;
            assert_eq!(front_is_late(&state), strain == 0.0, "{step} {strain}");
        }
        state.step = 7;
        assert!(!front_is_late(&state));
    }
}
