//! A run that ended before its time: what happened, and what to try.

use crossfibre::errata::Erratum;
use crossfibre::outcome::Outcome;
use crossfibre::scene::Scene;

use crate::exit::{Exit, say};

/// The exit code of an outcome; an early end is told on standard error.
pub fn told(scene: &Scene, outcome: &Outcome) -> Exit {
    if outcome.is_completed() {
        return Exit::Well;
    }
    say(&format!("{outcome}\n  help: {}", advice(scene, outcome)));
    Exit::RunEnded
}

fn advice(scene: &Scene, outcome: &Outcome) -> String {
    if matches!(outcome, Outcome::CrossoverLeft { .. }) {
        return "shorten the duration, move the crossover away from that end, \
                or raise the slide factor"
            .into();
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
