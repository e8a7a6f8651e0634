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

#[cfg(test)]
mod tests {
    use crossfibre::errata::Corrections;

    use super::*;
    use crate::cases::support::shipped;

    /// What is said of a scene whose run has come to no good end for no reason that the end names.
    fn advised(scene: &Scene) -> String {
        advice(scene, &Outcome::EnergyUnbalanced { step: 57, residual: Some(0.37) })
    }

    const LOWER: &str = "lower the Courant number, or the velocity";

    #[test]
    fn who_is_beyond_a_limit_is_told_the_limit_and_who_is_at_it_is_not() {
        let mut scene = shipped("artificial-viscosity");
        let viscosity = scene.primary.material.artificial_viscosity.unwrap();
        // √(1 + 0.3²) − 0.3.
        let limit = "the Courant number is 0.95; with this artificial viscosity the limit is 0.744";
        scene.courant = 0.95;
        assert_eq!(advised(&scene), limit);
        scene.courant = viscosity.greatest_courant_at_rest();
        assert_eq!(advised(&scene), LOWER);

        let mut scene = shipped("single-400");
        scene.courant = 1.01;
        assert_eq!(advised(&scene), "the Courant number is 1.01; the limit of the scheme is 1");
        scene.courant = 1.0;
        assert_eq!(advised(&scene), LOWER);
    }

    #[test]
    fn of_the_corrections_left_out_those_are_named_that_change_a_run() {
        let mut scene = shipped("fig3");
        let mut named = |corrections| {
            scene.corrections = corrections;
            let advised = advised(&scene);
            let ids = advised.split_once("make the corrections left out: ").map(|(_, ids)| ids);
            ids.map(|ids| ids.split(", ").map(str::to_owned).collect::<Vec<_>>())
        };
        assert_eq!(named(Corrections::ALL), None);
        let signs = [Erratum::PerpendicularSign, Erratum::ProjectileSign];
        let but_signs = signs.into_iter().fold(Corrections::ALL, Corrections::without);
        let ids = named(but_signs).unwrap();
        assert_eq!(ids, ["projectile-sign", "perpendicular-sign"]);
        // A density is none of the equations'.
        assert_eq!(named(but_signs.without(Erratum::Density)), Some(ids));
    }
}
