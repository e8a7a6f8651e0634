//! A run that ended before its time: what happened, and what to try.

use crossfibre::errata::Erratum;
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Material, Scene};

use crate::exit::{Exit, say};

/// The exit code of an outcome; an early end is told on standard error.
pub fn told(scene: &Scene, outcome: &Outcome) -> Exit {
    if outcome.is_completed() {
        return Exit::Well;
    }
    say(&format!("{outcome}\n  help: {}", advice(scene, outcome)));
    Exit::RunEnded
}

/// The greatest stable Courant number of the fibres with artificial viscosity, at rest.
fn viscous_limit(scene: &Scene) -> Option<f64> {
    scene
        .materials()
        .filter_map(|material| material.artificial_viscosity)
        .map(|viscosity| viscosity.greatest_courant_at_rest())
        .reduce(f64::min)
}

fn advice(scene: &Scene, outcome: &Outcome) -> String {
    if matches!(outcome, Outcome::CrossoverLeft { .. }) {
        return "shorten the duration, move the crossover away from that end, \
                or raise the slide factor"
            .into();
    }
    if let Outcome::CourantExceeded { would_serve, .. } = outcome {
        return match would_serve {
            Some(courant) => {
                format!(
                    "set \"courant\" to {courant:.3}: the scene has been run to its end with it"
                )
            }
            None => "lower the Courant number, or the velocity".into(),
        };
    }
    if matches!(outcome, Outcome::NoWaves { .. }) {
        return "the law must keep a positive slope over the strains of the run: lower the velocity, \
                change the coefficients, or set \"tension_only\" if it is in compression"
            .into();
    }
    if scene.materials().any(Material::is_literal) {
        return "forward differences of stiff arms are stable for short steps only: leave out \
                \"update\": \"literal\", or lower the Courant number"
            .into();
    }
    if scene.materials().any(|material| material.tension_only) {
        return "elements that go slack and taut again make energy: lower the Courant number, well \
                below 1/2, or add \"artificial_viscosity\""
            .into();
    }
    if let Some(most) = viscous_limit(scene).filter(|&most| scene.courant > most) {
        return format!(
            "the Courant number is {}; with this artificial viscosity the limit is {most:.3}",
            scene.courant
        );
    }
    if scene.courant > 1.0 {
        return format!("the Courant number is {}; the limit of the scheme is 1", scene.courant);
    }
    let missing: Vec<_> = Erratum::ALL
        .iter()
        .filter(|erratum| erratum.changes_a_run() && !scene.corrections.has(**erratum))
        .map(|erratum| erratum.entry().id)
        .collect();
    if missing.is_empty() {
        "lower the Courant number, or the velocity".into()
    } else {
        format!(
            "lower the Courant number, or make the corrections left out: {}",
            missing.join(", ")
        )
    }
}
