//! Extrapolation to h → 0, held against known answers, and against itself where there is none.

use crossfibre::discretisation::Discretisation;
use crossfibre::scene::{Law, Scene, Strain};
use rayon::prelude::*;

use crate::cases::support::{check, refined, shipped};
use crate::cases::{Bound, Check};
use crate::convergence::{
    Extrapolation, Rule, Safety, Verdict, fitted_limit, of_values, richardson,
};
use crate::figures::points::mean_over;
use crate::planted;
use crate::precision::orders::{BAND, LEVEL, ROUNDING};
use crate::precision::{Problem, Quantity, Record, ladders};
use crate::worse::worse;

const VARIANT: &str = "engineering, α = 1";

/// Values on meshes, (Δx, value), the coarsest first.
type Values = Vec<(f64, f64)>;

pub fn checks() -> Vec<Check> {
    let problems = [Problem::Single, Problem::Crossed];
    let record = Record::computed(&ladders(&problems, &[VARIANT], (2.0, 32.0)));
    let mut series = Vec::new();
    for problem in problems {
        for quantity in FALLING {
            series.extend(known(&record, problem, quantity));
        }
    }
    let mut checks = vec![index(&series), limit(&series)];
    checks.extend(swinging(&record));
    checks.extend(unknown());
    checks
}

/// Quantities whose errors fall with a power of h.
const FALLING: [Quantity; 6] = [
    Quantity::MeanStrain,
    Quantity::SecondaryMean,
    Quantity::Arrival,
    Quantity::Kink,
    Quantity::StrainL2,
    Quantity::Energy,
];

/// The values of a quantity, and the exact one.
fn known(record: &Record, problem: Problem, quantity: Quantity) -> Option<(Values, f64)> {
    let series = record.series(problem, VARIANT);
    let exact = series.last()?.reading(quantity)?.exact?;
    let value =
        |entry: &&crate::precision::Entry| Some((entry.spacing, entry.reading(quantity)?.value));
    Some((series.iter().filter_map(value).collect(), exact))
}

/// |limit − exact| over the index, of three meshes; beyond every number without a limit.
fn missed(three: &[(f64, f64)], exact: f64, safety: Safety) -> f64 {
    let limit = richardson(three).ok().and_then(|found| found.extrapolation);
    limit.map_or(f64::INFINITY, |limit: Extrapolation| {
        (limit.limit - exact).abs() / limit.uncertainty(safety)
    })
}

fn index(series: &[(Values, f64)]) -> Check {
    let triplets = series.iter().flat_map(|(values, exact)| {
        values.windows(3).map(|three| missed(three, *exact, Safety::Asymptotic))
    });
    check(
        "The interval of the index holds the exact number: mean strains, arrival of the front, position of \
         the kink, L2 norm, energy residual",
        "exact solution",
        "|limit − exact| over 1.25 |limit − finest|, greatest of three triplets of meshes to 0.06 mm of each; \
         one fibre and Fig. 3, engineering strain",
        triplets.fold(0.0, worse),
        Bound::AtMost(1.0),
        "the safety factor of three meshes of the asymptotic range (Roache), at orders of 1, 2/3 and 1/2",
    )
}

fn limit(series: &[(Values, f64)]) -> Check {
    let left = series.iter().map(|(values, exact)| {
        let finest = values.last().map_or(f64::NAN, |last| (last.1 - exact).abs());
        let found = fitted_limit(values, (0.15, 6.0), LEVEL);
        found.map_or(f64::INFINITY, |limit| (limit.limit - exact).abs() / finest)
    });
    check(
        "The limit fitted to five meshes is the exact number, but for a part of what the finest mesh is off",
        "exact solution",
        "|limit − exact| over the error of the finest mesh, greatest of the same",
        left.fold(0.0, worse),
        Bound::AtMost(0.3),
        "the kink, whose place on a mesh is not smooth in h: terms beside the fitted power",
    )
}

/// Means over a window, whose errors change sign: the index does not hold, and the rule says so.
fn swinging(record: &Record) -> Vec<Check> {
    let windows: Vec<_> = [
        (Problem::Single, Quantity::Plateau),
        (Problem::Crossed, Quantity::Transmission),
        (Problem::Crossed, Quantity::Reflection),
        (Problem::Crossed, Quantity::Diversion),
    ]
    .into_iter()
    .filter_map(|(problem, quantity)| known(record, problem, quantity))
    .collect();
    let all = windows.iter().flat_map(|(values, exact)| values.windows(3).map(move |w| (w, exact)));
    let misses =
        all.filter(|(three, exact)| missed(three, **exact, Safety::Asymptotic) > 1.0).count();
    let rule = Rule { band: BAND, floor: ROUNDING };
    let asymptotic = windows
        .iter()
        .filter(|(values, _)| matches!(of_values(values, rule), Ok(Verdict::Asymptotic(_))))
        .count();
    vec![
        check(
            "Means over a window (plateau, R, T, D) swing: the interval of the index misses the exact value",
            "exact solution",
            "number of intervals that miss it, of twelve",
            misses as f64,
            Bound::Within(3.0, 12.0),
            "ringing meets the ends of the window at another phase on each mesh: an order of three such \
             values is chance",
        ),
        check(
            "None of them is called asymptotic",
            "docs/convergence.md: the rule of the asymptotic range",
            "number of the four that are",
            asymptotic as f64,
            Bound::Exactly(0.0),
            "the rule is there to keep the index from being used on them",
        ),
    ]
}

/// Fig. 3 with a law that softens.
fn softening_scene(refinement: usize) -> Scene {
    let mut scene = shipped("fig3");
    scene.strain = Strain::Engineering;
    let law = Law::Exponential { a: -1.37e9, b: -43.7 };
    scene.primary.material.law = law.clone();
    if let Some(secondary) = &mut scene.secondary {
        secondary.material.law = law;
    }
    // The same time on every mesh: 100 steps of the coarsest.
    scene.duration = 100.0 * Discretisation::<f64>::of(&scene).time_step;
    refined(scene, refinement)
}

/// Its mean strains: nobody knows the exact ones.
fn softening(refinement: usize) -> (f64, [f64; 2]) {
    let scene = softening_scene(refinement);
    let length = [scene.primary.length, scene.secondary.as_ref().map_or(f64::NAN, |s| s.length)];
    let result = planted::run(&scene, |_| ());
    let across = result.secondary.map(|fibre| fibre.strain).unwrap_or_default();
    let means = [
        mean_over(length[0], &result.primary.strain, (0.0, length[0])),
        mean_over(length[1], &across, (0.0, length[1])),
    ];
    (length[0] / scene.primary.elements as f64, means)
}

fn unknown() -> Vec<Check> {
    let triplet =
        |meshes: [usize; 3]| -> Vec<_> { meshes.into_par_iter().map(softening).collect() };
    let (one, other) = rayon::join(|| triplet([2, 4, 8]), || triplet([3, 6, 12]));
    let extrapolated = |runs: &[(f64, [f64; 2])], fibre: usize| {
        let values: Values = runs.iter().map(|&(spacing, means)| (spacing, means[fibre])).collect();
        richardson(&values).ok().and_then(|found| found.extrapolation)
    };
    ["primary", "secondary"]
        .into_iter()
        .enumerate()
        .map(|(fibre, name)| {
            let limits = extrapolated(&one, fibre).zip(extrapolated(&other, fibre));
            let misses = limits.map(|(one, other)| {
                let apart = (one.limit - other.limit).abs();
                let holds = |limit: &Extrapolation| apart <= limit.uncertainty(Safety::Asymptotic);
                [one, other].into_iter().filter(|limit| !holds(limit)).count()
            });
            check(
                format!(
                    "Two crossed fibres that soften, of which no exact answer is known: two disjoint \
                     triplets of meshes agree on the mean strain of the {name}"
                ),
                "the other three meshes",
                "number of the two intervals, limit ∓ 1.25 |limit − finest|, that miss the other's limit",
                misses.map_or(f64::NAN, |misses| misses as f64),
                Bound::Exactly(0.0),
                "both are of one exact value; meshes of 1, 0.5, 0.25 mm against 0.67, 0.33, 0.17 mm",
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_softening_fibres_are_marched_to_one_time_on_every_mesh() {
        for refinement in [1, 2, 3, 12] {
            let scene = softening_scene(refinement);
            let steps = Discretisation::<f64>::of(&scene).steps(scene.duration);
            assert_eq!(steps, 100 * refinement as u64);
        }
    }
}
