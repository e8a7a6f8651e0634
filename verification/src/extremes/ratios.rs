//! Fibres of very different modulus and density.

use crossfibre::scene::{Material, Scene, Strain};

use super::{Group, Row, checks, row, run};
use crate::cases::support::{exact_crossover, mean, measured_by, refined, shipped};
use crate::cases::{Bound, Case};
use crate::closed_form::{coefficients, component};
use crate::fronts::between_fronts;
use crate::worse::worse;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.ratios",
        title: "Modulus ratios from 1e-4 to 1e4, density ratios from 1e-3 to 1e3",
        equations: &[2, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18],
        run: || checks(rows()),
    },
    rows,
    found: "\
Right from a crossing fibre that is not felt to one that stops nine tenths of the wave, and up to a strain of
34 on the secondary. A secondary much stiffer than the primary needs the finest mesh (here 0.03 mm, else
0.125 mm): measured by its own wave speed it is dragged slowly, and its kink crawls. The kink of the stiffest
and lightest has not left its first element: what it takes of the wave, less than a thousandth, is as small
as the error, and its own strain is off by a third.",
};

/// Fig. 3 with a secondary whose modulus and density are so many times the primary's. The elements of
/// both take a wave equally long, so that α = 1 on both.
fn scene(modulus: f64, density: f64, factor: usize) -> Scene {
    let mut scene = measured_by(Strain::Engineering, refined(shipped("fig3"), factor));
    scene.duration = 28e-6;
    let Some(secondary) = &mut scene.secondary else { return scene };
    secondary.material = Material::linear(modulus * secondary.material.instantaneous_modulus());
    secondary.density *= density;
    secondary.length = 0.1 * (modulus / density).sqrt();
    secondary.elements = 50 * factor;
    scene
}

/// Greatest error of R and T, and relative error of D.
fn errors(scene: &Scene) -> (String, f64, f64) {
    let windows = between_fronts(scene, scene.duration);
    let incident = component(scene, exact_crossover(scene).incident.strain);
    let exact = coefficients(scene).expect("the scene is in the range of the closed form");
    let result = run(scene);
    let spacing = scene.primary.length / scene.primary.elements as f64;
    let over = |(from, to)| mean(spacing, &result.primary.strain, from, to) / incident;
    let reflection = over(windows.behind) - 1.0;
    let transmission = over(windows.ahead);
    let diversion =
        scene.secondary.as_ref().zip(result.secondary.as_ref()).map_or(0.0, |(s, r)| {
            let (from, to) = windows.diverted;
            mean(s.length / s.elements as f64, &r.strain, from, to) / incident
        });
    let worst =
        worse((reflection - exact.reflection).abs(), (transmission - exact.transmission).abs());
    (result.outcome.to_string(), worst, (diversion / exact.diversion - 1.0).abs())
}

fn rows() -> Vec<Row> {
    // Modulus, density, refinement of 2 mm, bounds of R and T and of D.
    [
        (1e-4, 1e-3, 16, 1e-4, 2e-4),
        (1e-4, 1.0, 16, 1e-4, 1e-3),
        (1e-4, 1e3, 16, 3e-4, 0.2),
        (1.0, 1e-3, 16, 5e-5, 4e-2),
        (1.0, 1.0, 16, 1e-4, 5e-4),
        (1.0, 1e3, 16, 5e-5, 3e-4),
        (1e4, 1e-3, 64, 2e-3, 2.0),
        (1e4, 1.0, 64, 5e-3, 2e-2),
        (1e4, 1e3, 64, 2e-3, 3e-2),
    ]
    .into_iter()
    .flat_map(|(modulus, density, factor, most, most_diverted)| {
        let scene = scene(modulus, density, factor);
        let (says, error, diverted) = errors(&scene);
        let what = format!("modulus × {modulus}, density × {density}");
        let reason = if modulus > 1.0 {
            "the secondary's kink has passed a few elements only"
        } else {
            "oscillations of the fronts, averaged over the windows"
        };
        let oracle = "self-similar solution at the crossover, engineering strain";
        [
            row(
                what.clone(),
                "R and T are those of the closed form",
                says.clone(),
                oracle,
                "greatest error, in units of the incident strain",
                error,
                Bound::AtMost(most),
                reason,
            ),
            row(
                what,
                "So is D",
                says,
                oracle,
                "relative error",
                diverted,
                Bound::AtMost(most_diverted),
                reason,
            ),
        ]
    })
    .collect()
}
