//! Meshes of two elements and of a million.

use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Strain};

use super::{Group, Row, checks, refused, row, run, verdict};
use crate::cases::support::{exact_primary, measured_by, shipped};
use crate::cases::{Bound, Case};
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.mesh",
        title: "Meshes of two elements and of a million",
        equations: &[2, 4, 5, 6, 7, 8],
        run: || checks(rows()),
    },
    rows,
    found: "\
Two elements are one free node between projectile and clamp: few enough to be worked by hand. A million are
the same as sixty-four, until the wave comes to the end of the sixty-four.",
};

/// Two elements of a fibre with nothing special about it, and a projectile that they slow.
fn two(strain: Strain) -> Scene {
    let mut scene = measured_by(strain, shipped("unequal"));
    scene.secondary = None;
    scene.primary.elements = 2;
    scene
}

/// After [`BY_HAND_STEPS`] steps: strains, velocity of the free node and of the projectile.
///
/// The recursion of the one free node, written out in another language and worked to 60 digits.
const INCREMENTAL: [f64; 5] = [
    0.019715561568264036,
    0.01865547191035129,
    -33.08718147289919,
    51.90751844371439,
    287.8618580716305,
];
const ENGINEERING: [f64; 5] = [
    0.019855098864160113,
    0.018804086290173185,
    -33.14353336769261,
    52.122799487331285,
    287.7081500717344,
];
const BY_HAND_STEPS: u64 = 7;

fn by_hand(strain: Strain, expected: [f64; 5]) -> Row {
    let mut scene = two(strain);
    let wave_speed = exact_primary(&scene).wave_speed();
    scene.duration =
        BY_HAND_STEPS as f64 * scene.courant * scene.primary.length / (2.0 * wave_speed);
    let result = run(&scene);
    assert_eq!(result.steps, BY_HAND_STEPS);
    let (strains, node) = (&result.primary.strain, &result.primary.velocity[1]);
    let found = [strains[0], strains[1], node[0], node[1], result.projectile.velocity];
    let error = found.iter().zip(expected).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, worse);
    let measure = match strain {
        Strain::Incremental => "(4)",
        Strain::Engineering => "engineering strain",
    };
    row(
        format!("2 elements, 7 steps, a projectile of finite mass, {measure}"),
        "All is as worked by hand",
        result.outcome.to_string(),
        "the recursion of the one free node, to 60 digits",
        "greatest relative difference of both strains, the free node's velocity and the projectile's",
        error,
        Bound::AtMost(1e-13),
        "a few hundred roundings",
    )
}

/// A fibre of so many elements of 1/512 m.
fn elements(count: usize) -> Scene {
    let mut scene = shipped("single-400");
    let spacing = 1.0 / 512.0;
    scene.primary.elements = count;
    scene.primary.length = spacing * count as f64;
    scene.duration = 50.0 * spacing / exact_primary(&scene).wave_speed();
    scene
}

/// Numbers of the elements of a short fibre that are others in a long one, strains of the long one beyond
/// them, and how many element-steps one has more than the other.
fn apart(short: &RunResult, long: &RunResult) -> usize {
    let pairs =
        |a: &[f64], b: &[f64]| a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
    let vectors =
        |a: &[Vec<f64>], b: &[Vec<f64>]| a.iter().zip(b).map(|(a, b)| pairs(a, b)).sum::<usize>();
    let (a, b) = (&short.primary, &long.primary);
    let different = pairs(&a.strain, &b.strain)
        + pairs(&a.tension, &b.tension)
        + vectors(&a.position, &b.position)
        + vectors(&a.velocity, &b.velocity);
    let beyond = b.strain[a.strain.len()..].iter().filter(|&&e| e != 0.0).count();
    let visited = (short.counts.element_steps).abs_diff(long.counts.element_steps) as usize;
    different + beyond + visited
}

fn million() -> Row {
    let [short, long] = [64, 1_000_000].map(|count| run(&elements(count)));
    row(
        "1 000 000 elements, 50 steps",
        "The first 64 elements are those of a fibre of 64, the others at rest and not visited",
        long.outcome.to_string(),
        "causality: nothing comes back in 50 steps",
        "numbers whose bits differ, strains beyond, element-steps more",
        apart(&short, &long) as f64,
        Bound::Exactly(0.0),
        "1/512 m is exact, so are the places of the nodes",
    )
}

fn rows() -> Vec<Row> {
    let with = |count| {
        let mut scene = shipped("single-400");
        scene.primary.elements = count;
        scene
    };
    let is_refused = |what: &str, scene: Scene| {
        row(
            what,
            "Refused before anything is run",
            verdict(&scene),
            "typed problem",
            "1 if refused",
            refused(&scene),
            Bound::Exactly(1.0),
            "",
        )
    };
    vec![
        by_hand(Strain::Incremental, INCREMENTAL),
        by_hand(Strain::Engineering, ENGINEERING),
        million(),
        is_refused("1 element", with(1)),
        is_refused("100 000 001 elements", with(100_000_001)),
        is_refused("10²⁰ s", Scene { duration: 1e20, ..shipped("single-400") }),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Other numbers of each kind, so that none makes up for another.
    #[test]
    fn everything_that_a_longer_fibre_has_otherwise_is_counted_once() {
        let short = run(&elements(64));
        let mut long = short.clone();
        long.primary.strain.extend([0.0, 0.0]);
        assert_eq!(apart(&short, &long), 0);
        // 16 strains, 2 tensions, 4 components of positions and 8 of velocities.
        long.primary.strain[..16].fill(-1.0);
        long.primary.tension[..2].fill(-1.0);
        long.primary.position[..2].fill(vec![9.0, 9.0]);
        long.primary.velocity[..4].fill(vec![7e9, 7e9]);
        // A strain beyond, and 32 element-steps.
        long.primary.strain[65] = 0.1;
        long.counts.element_steps += 32;
        assert_eq!(apart(&short, &long), 63);
    }
}
