//! Crossovers beside the impact point and the clamp; slide factors of 0, 1e-6 and 1; slip over many nodes.

use crossfibre::exact::fronts::Segment;
use crossfibre::exact::smith::Strain as ExactStrain;
use crossfibre::outcome::{End, Outcome};
use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Secondary, Strain};

use super::{Group, Row, checks, refused, row, run, verdict};
use crate::cases::support::{exact_primary, exact_single, measured_by, refined, shipped};
use crate::cases::{Bound, Case};
use crate::closed_form::{component, problem};
use crate::oracle::motion;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.crossover",
        title: "Crossover beside either end, slide factors 0 and 1e-6, slip over many nodes",
        equations: &[9, 10, 11, 12, 13, 14, 15, 16, 17, 18],
        run: || checks(rows()),
    },
    rows,
    found: "\
A crossover one node from either end is solved like any other; nearer than half an element it is refused.
Sliding freely, the primary runs through the crossover, whose node follows to the nearest as long as the
fibre is straight there. Behind the kink nothing keeps the secondary on the primary (ledger `slip-drift`):
the distance between them is in every result, it does not vanish with the element, and the run completes.",
};

/// Fig. 3 with engineering strain and another secondary.
fn crossed(factor: usize, change: impl FnMut(&mut Secondary)) -> Scene {
    let mut scene = measured_by(Strain::Engineering, refined(shipped("fig3"), factor));
    scene.secondary.iter_mut().for_each(change);
    scene
}

/// The crossover at a node, for as long as waves need to come back from the clamps.
fn at_node(factor: usize, node: impl Fn(usize) -> usize) -> Scene {
    let mut scene = crossed(factor, |_| {});
    let elements = scene.primary.elements;
    let spacing = scene.primary.length / elements as f64;
    scene.secondary.iter_mut().for_each(|s| s.at = spacing * node(elements) as f64);
    Scene { duration: 61.7e-6, ..scene }
}

/// Mean strain along a fibre.
fn mean(strain: &[f64]) -> f64 {
    strain.iter().sum::<f64>() / strain.len() as f64
}

/// The same of an exact motion, in a scene's measure.
fn exact_mean(scene: &Scene, segments: &[Segment]) -> f64 {
    let strain = |s: &Segment| component(scene, ExactStrain::from_engineering(s.state.strain));
    let (sum, length) = segments.iter().fold((0.0, 0.0), |(sum, length), s| {
        (sum + strain(s) * (s.to - s.from), length + (s.to - s.from))
    });
    sum / length
}

/// Greatest relative error of the mean strains of both fibres, by the exact motion of a scene.
fn error(result: &RunResult, exact: &Scene, both: bool) -> f64 {
    let motion = motion(&problem(exact), None, result.time);
    assert!(motion.ended.is_none(), "the exact motion ends early");
    let primary = mean(&result.primary.strain) / exact_mean(exact, &motion.primary) - 1.0;
    let secondary = result
        .secondary
        .as_ref()
        .filter(|_| both)
        .map_or(0.0, |s| mean(&s.strain) / exact_mean(exact, &motion.secondary) - 1.0);
    worse(primary.abs(), secondary.abs())
}

const MOTION: &str = "every front of the exact motion followed";
const MEANS: &str = "relative error of the mean strain at 61.7 µs, 0.125 mm";

fn places() -> Vec<Row> {
    let origin = at_node(16, |_| 0);
    let [together, first, last] =
        [origin.clone(), at_node(16, |_| 1), at_node(16, |n| n - 1)].map(|s| run(&s));
    let coarse_first = error(&run(&at_node(4, |_| 1)), &at_node(4, |_| 0), true);
    let near = |part: f64| {
        let mut scene = crossed(1, |_| {});
        let (length, spacing) = (scene.primary.length, scene.primary.length / 150.0);
        let at = if part < 0.0 { length + part * spacing } else { part * spacing };
        scene.secondary.iter_mut().for_each(|s| s.at = at);
        scene
    };
    let refusal = |what: &str, scene: &Scene| {
        row(
            what,
            "Refused, with the nearest place that is possible",
            verdict(scene),
            "typed problem",
            "1 if refused",
            refused(scene),
            Bound::Exactly(1.0),
            "the nearest node is an end",
        )
    };
    vec![
        row(
            "both fibres at the impact point",
            "Each is struck as if alone",
            together.outcome.to_string(),
            MOTION,
            MEANS,
            error(&together, &origin, true),
            Bound::AtMost(4e-3),
            "fronts of one element that have gone two passages",
        ),
        row(
            "crossover at node 1",
            "As if it were at the impact point",
            first.outcome.to_string(),
            "the exact motion with the crossover at the impact point",
            MEANS,
            error(&first, &origin, true),
            Bound::AtMost(3e-2),
            "one element of fibre between: order one",
        ),
        row(
            "crossover at node 1",
            "and the sooner the finer the mesh",
            first.outcome.to_string(),
            "the same",
            "error at 0.5 mm over that at 0.125 mm",
            coarse_first / error(&first, &origin, true),
            Bound::Within(3.0, 5.0),
            "order one: a factor of four",
        ),
        row(
            "crossover at the node before the clamp",
            "The primary does not feel it",
            last.outcome.to_string(),
            MOTION,
            "relative error of the primary's mean strain at 61.7 µs, 0.125 mm",
            error(&last, &at_node(16, |n| n - 1), false),
            Bound::AtMost(4e-3),
            "fronts of one element that have gone two passages",
        ),
        refusal("crossover 0.4 elements from the impact point", &near(0.4)),
        refusal("crossover 0.4 elements from the clamp", &near(-0.4)),
    ]
}

fn slide_factors() -> Vec<Row> {
    let sliding = |slide_factor| run(&crossed(1, |s| s.slide_factor = slide_factor));
    let alone = run(&Scene { secondary: None, ..crossed(1, |_| {}) });
    let [free, nearly] = [0.0, 1e-6].map(sliding);
    let strained = |result: &RunResult| {
        let secondary = result.secondary.iter().flat_map(|s| &s.strain);
        secondary.filter(|&&e| e != 0.0).count()
    };
    let apart = |a: &RunResult| {
        let pairs = || a.primary.strain.iter().zip(&alone.primary.strain);
        let greatest = pairs().fold(0.0_f64, |most, (_, e)| most.max(*e));
        pairs().map(|(a, b)| (a - b).abs()).fold(0.0, worse) / greatest
    };
    let different = |a: &RunResult| {
        a.primary.strain.iter().zip(&alone.primary.strain).filter(|(a, b)| a != b).count()
    };
    vec![
        row(
            "α_s = 0, before the kink",
            "The primary does as without a secondary, the secondary nothing",
            free.outcome.to_string(),
            "the same scene without a secondary",
            "strains that differ, and strains of the secondary other than zero",
            (different(&free) + strained(&free)) as f64,
            Bound::Exactly(0.0),
            "a straight fibre slides through",
        ),
        row(
            "α_s = 1e-6, before the kink",
            "The primary does as without a secondary",
            nearly.outcome.to_string(),
            "the mass that slides along with the crossover's node, α_s² Δm₂ = 2e-12 of the node's",
            "greatest difference from the strain without a secondary, over the greatest strain",
            apart(&nearly),
            Bound::AtMost(8e-12),
            "that mass; the closed form's R = 0.044 α_s^(8/3) = 4e-18 is less than the last digit",
        ),
    ]
}

/// The node of the primary that has flowed in to where the crossover was.
fn slipped(scene: &Scene, at: f64, time: f64) -> f64 {
    let (inflow, c) = (exact_single(scene).inflow_velocity, exact_primary(scene).wave_speed());
    let spacing = scene.primary.length / scene.primary.elements as f64;
    // X − W(t − X/c) = at.
    (at + inflow * time) / (1.0 + inflow / c) / spacing
}

fn slip() -> Vec<Row> {
    let at = 0.05;
    let mut scene = crossed(4, |s| (s.at, s.slide_factor) = (at, 0.0));
    scene.projectile.velocity = 1000.0;
    scene.duration = 30e-6;
    let result = run(&scene);
    let (node, moves) = result.crossover.as_ref().map_or((0, 0), |c| (c.node, c.moves));
    let expected = slipped(&scene, at, result.time);

    let mut rebound = crossed(1, |s| (s.at, s.slide_factor) = (0.006, 0.7));
    rebound.projectile.velocity = 1000.0;
    rebound.projectile.mass = Some(0.01);
    (rebound.courant, rebound.duration) = (0.7, 1.5e-3);
    let thrown = run(&rebound);
    let left = matches!(thrown.outcome, Outcome::CrossoverLeft { end: End::ImpactPoint, .. });

    let distance = |factor| {
        let mut scene = crossed(factor, |s| (s.at, s.slide_factor) = (0.012, 0.0));
        scene.duration = 61.7e-6;
        let result = run(&scene);
        (result.crossover.map_or(0.0, |c| c.distance), result.outcome)
    };
    let ((coarse, _), (fine, drifted)) = (distance(1), distance(4));
    vec![
        row(
            format!("α_s = 0 at 1000 m/s: {moves} nodes slip through"),
            "The crossover's node is where the primary flows through it",
            result.outcome.to_string(),
            "Smith's inflow W: node X with X − W(t − X/c) at the crossover",
            "distance of the node from there, in elements",
            (node as f64 - expected).abs(),
            Bound::AtMost(0.5),
            "the nearest node",
        ),
        row(
            "α_s = 0.7, 10 g at 1000 m/s: outward by 25 nodes, then back with the projectile",
            "It ends as a typed outcome at the impact point",
            thrown.outcome.to_string(),
            "typed outcome",
            "1 if so",
            f64::from(u8::from(left)),
            Bound::Exactly(1.0),
            "an end of the fibre is no place for a crossover",
        ),
        row(
            "α_s = 0, the kink has passed: 2.6 mm apart, five elements of 0.5 mm",
            "The fibres come apart, on any mesh",
            drifted.to_string(),
            "ledger slip-drift",
            "distance at 0.5 mm over distance at 2 mm",
            fine / coarse,
            Bound::Within(0.7, 1.1),
            "found, not mended: the page moves the secondary's first node by (12) and (13) alone",
        ),
    ]
}

fn rows() -> Vec<Row> {
    [places(), slide_factors(), slip()].into_iter().flatten().collect()
}
