//! The march against the exact motion at any time: reflections, kinks that waves have crossed, and
//! two different fibres.

use crossfibre::exact::fronts::Segment;
use crossfibre::exact::motion::Motion;
use crossfibre::exact::smith::Strain as ExactStrain;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::FibreState;

use super::support::{check, kinked, marched, measured_by, order, refined, shipped, sliding_by};
use super::{Bound, Case, Check};
use crate::closed_form::{component, problem};
use crate::oracle::motion;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "motion.engineering",
        title: "Strain along both fibres at late times, engineering strain",
        equations: &[2, 6, 7, 9, 10, 11, 12, 13, 15, 16, 17, 18],
        run: engineering,
    },
    Case {
        id: "motion.incremental",
        title: "Strain along both fibres at late times, the strain of (4)",
        equations: &[2, 4, 5, 6, 7, 9, 10, 11, 12, 13, 15, 16, 17, 18],
        run: incremental,
    },
    Case {
        id: "motion.projectile",
        title: "Strain along both fibres behind a projectile that slows down",
        equations: &[2, 6, 7, 8, 17, 18],
        run: projectile,
    },
];

const ORACLE: &str = "every front of the exact motion followed (docs/exact/fronts.md)";
const NORM: &str = "mean of |strain − exact mean over the element|, over the greatest mean strain";

/// A scene at another time.
fn until(duration: f64, scene: Scene) -> Scene {
    Scene { duration, ..scene }
}

/// Two different fibres with a projectile of constant velocity.
fn unequal(slide_factor: f64, duration: f64) -> Scene {
    let mut scene = sliding_by(slide_factor, until(duration, shipped("unequal")));
    scene.projectile.mass = None;
    scene
}

/// Mean error of the strain of both fibres over the greatest strain: (primary, secondary).
fn errors(scene: &Scene) -> (f64, f64) {
    let run = marched(scene.clone());
    let exact = motion(&problem(scene), scene.projectile.mass, run.state.time());
    assert!(exact.ended.is_none(), "the exact motion ends early");
    let Motion { primary, secondary, .. } = &exact;
    let across = run.state.crossover.as_ref().map(|crossover| &crossover.fibre);
    (
        error(scene, &run.state.primary, primary),
        across.map_or(0.0, |fibre| error(scene, fibre, secondary)),
    )
}

/// Mean over the elements of |strain − exact mean|, over the greatest exact mean.
fn error<const D: usize>(scene: &Scene, fibre: &FibreState<f64, D>, exact: &[Segment]) -> f64 {
    let means = element_means(scene, exact, fibre.properties.spacing, fibre.strain.len());
    let greatest = means.iter().fold(0.0_f64, |a, &b| a.max(b));
    let apart = fibre.strain.iter().zip(&means).map(|(a, b)| (a - b).abs());
    apart.sum::<f64>() / (greatest * means.len() as f64)
}

/// The exact strain in the scene's measure, averaged over each element.
fn element_means(scene: &Scene, exact: &[Segment], spacing: f64, elements: usize) -> Vec<f64> {
    let mut sums = vec![0.0; elements];
    for segment in exact {
        let strain = component(scene, ExactStrain::from_engineering(segment.state.strain));
        let (first, last) = ((segment.from / spacing) as usize, (segment.to / spacing) as usize);
        for (index, sum) in sums.iter_mut().enumerate().take(last + 1).skip(first) {
            let (from, to) = (index as f64 * spacing, (index + 1) as f64 * spacing);
            *sum += strain * (segment.to.min(to) - segment.from.max(from)).max(0.0) / spacing;
        }
    }
    sums
}

/// Checks of one scene on meshes 4 and 16 times as fine: primary, then secondary, if it has one.
fn checks(name: &str, scene: &Scene, most: [f64; 2], orders: (f64, f64), why: &str) -> Vec<Check> {
    let [coarse, fine] = [4, 16].map(|factor| errors(&refined(scene.clone(), factor)));
    let fibres = [("primary", coarse.0, fine.0, most[0]), ("secondary", coarse.1, fine.1, most[1])];
    let fibres = fibres.into_iter().take(if scene.secondary.is_some() { 2 } else { 1 });
    fibres
        .flat_map(|(fibre, coarse, fine, most)| {
            [
                check(
                    format!("{name}: the {fibre}'s strain is the exact one"),
                    ORACLE,
                    NORM,
                    fine,
                    Bound::AtMost(most),
                    "a sixteenth of the scene's element; fronts are spread, plateaus are not",
                ),
                check(
                    format!("{name}: the {fibre}'s strain converges"),
                    ORACLE,
                    "observed order of that mean from a fourth to a sixteenth of the element",
                    order(coarse, fine, 4.0),
                    Bound::Within(orders.0, orders.1),
                    why,
                ),
            ]
        })
        .collect()
}

const STEEP: &str = "at α = 1 a longitudinal front stays a few elements wide, order one; a kink, \
                     slower than its mesh, spreads as Δx^(2/3)";
const SPREAD: &str = "kinks, and below α = 1 all fronts, spread as Δx^(2/3), with trains of waves \
                      behind them that shrink more slowly";

fn engineering() -> Vec<Check> {
    let scene = |scene| measured_by(Strain::Engineering, scene);
    let mut all = checks(
        "fig3 at 61.7 µs",
        &scene(until(61.7e-6, shipped("fig3"))),
        [3e-3, 1e-2],
        (0.75, 1.0),
        STEEP,
    );
    all.extend(checks(
        "unequal fibres at 73.1 µs",
        &scene(unequal(1.0, 73.1e-6)),
        [8e-3, 2.5e-2],
        (0.45, 0.9),
        SPREAD,
    ));
    all.extend(checks(
        "unequal fibres that slide, α_s = 0.41, at 37.3 µs",
        &scene(unequal(0.41, 37.3e-6)),
        [8e-3, 2.5e-2],
        (0.45, 0.9),
        SPREAD,
    ));
    all.extend(checks(
        "kink past the crossover",
        &scene(kinked()),
        [1.6e-2, 4e-2],
        (0.3, 0.7),
        SPREAD,
    ));
    all
}

fn incremental() -> Vec<Check> {
    let late = until(61.7e-6, shipped("fig3"));
    let mut all = checks("fig3 at 61.7 µs", &late, [3e-3, 1e-2], (0.75, 1.0), STEEP);
    let scene = unequal(1.0, 73.1e-6);
    all.extend(checks("unequal fibres at 73.1 µs", &scene, [7e-3, 2e-2], (0.45, 0.9), SPREAD));
    all
}

/// Velocity that the projectile has lost, over what it loses exactly, less 1.
fn lost(scene: &Scene) -> f64 {
    let run = marched(scene.clone());
    let exact = motion(&problem(scene), scene.projectile.mass, run.state.time());
    let before = scene.projectile.velocity;
    let now = run.state.projectile.velocity;
    (before - now) / (before - exact.projectile_velocity) - 1.0
}

fn projectile() -> Vec<Check> {
    [Strain::Engineering, Strain::Incremental]
        .into_iter()
        .flat_map(|strain| {
            let scene = measured_by(strain, shipped("finite-projectile"));
            let measure = match strain {
                Strain::Engineering => "engineering strain",
                Strain::Incremental => "the strain of (4)",
            };
            let [half, eighth] = [4, 16].map(|factor| refined(scene.clone(), factor));
            [
                check(
                    format!("With {measure} the fibre slows the projectile as it exactly does"),
                    ORACLE,
                    "velocity lost in 80 µs over the exact loss, less 1",
                    lost(&eighth).abs(),
                    Bound::AtMost(2e-3),
                    "a sixteenth of the scene's element; the exact loss is known to about 1e-4, by other \
                     steps and resolutions",
                ),
                check(
                    format!("With {measure} that closes with the element"),
                    ORACLE,
                    "observed order of the loss from a fourth to a sixteenth of the element",
                    order(lost(&half), lost(&eighth), 4.0),
                    Bound::Within(0.5, 1.5),
                    "the mass of half an element too much or too little: order one",
                ),
                check(
                    format!("With {measure} the strain along the fibre is the exact one"),
                    ORACLE,
                    NORM,
                    errors(&half).0,
                    Bound::AtMost(1.5e-2),
                    "a fourth of the scene's element; no finer, because the steps of the exact \
                     velocity are worth 2e-3 themselves",
                ),
            ]
        })
        .collect()
}
