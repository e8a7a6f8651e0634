//! The runs of the study, and what is kept of each.

use crossfibre::errata::Corrections;
use crossfibre::exact::crossover::Coefficients;
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Material, Scene, Strain};
use serde::{Deserialize, Serialize};

use crate::cases::support::{exact_single, measured_by, refined, shipped, sliding_by};
use crate::closed_form::component;
use crate::fronts::{Windows, between_fronts};
use crate::planted;
use crate::sweep::Point;

/// How often the paper's mesh of 2 mm is refined for a converged curve: to 0.125 mm.
pub const CONVERGED: usize = 16;

/// Times that the paper's mesh is refined for profiles: 2, 0.5 and 0.125 mm.
pub const PROFILE_MESHES: [usize; 3] = [1, 4, CONVERGED];

/// The curves of Figs 4 to 7: equations, and times that the paper's mesh is refined.
pub const CURVES: [(Edition, usize); 5] = [
    (Edition::Printed, 1),
    (Edition::Printed, CONVERGED),
    (Edition::Corrected, 1),
    (Edition::Corrected, CONVERGED),
    (Edition::Engineering, CONVERGED),
];

/// Which equations run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edition {
    /// As printed.
    Printed,
    /// With all corrections.
    Corrected,
    /// With all corrections, and the strain L/L⁰ − 1 in place of (4).
    Engineering,
}

impl Edition {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Printed, Self::Corrected, Self::Engineering];

    /// Its name in ids and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Corrected => "corrected",
            Self::Engineering => "engineering",
        }
    }

    /// Its name in legends.
    pub fn label(self) -> &'static str {
        match self {
            Self::Printed => "as printed",
            Self::Corrected => "corrected",
            Self::Engineering => "corrected, engineering strain",
        }
    }

    /// Its measure of strain.
    pub fn measure(self) -> Strain {
        match self {
            Self::Printed | Self::Corrected => Strain::Incremental,
            Self::Engineering => Strain::Engineering,
        }
    }

    fn of(self, scene: Scene) -> Scene {
        match self {
            Self::Printed => Scene { corrections: Corrections::NONE, ..scene },
            Self::Corrected => scene,
            Self::Engineering => measured_by(Strain::Engineering, scene),
        }
    }
}

/// Scenes that are run with elements half as long as the converged ones, to see what that moves.
pub const HALVED: [(Abscissa, f64); 4] = [
    (Abscissa::Modulus, 10.0),
    (Abscissa::Modulus, 200.0),
    (Abscissa::Slide, 0.5),
    (Abscissa::Slide, 1.0),
];

/// What Figs 4 to 7 are drawn over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Abscissa {
    /// The modulus of both fibres, Fig. 4, in GPa: the paper's 58.6 within a range from soft nylon to
    /// stiff carbon.
    Modulus,
    /// The slide factor, Figs 5 to 7.
    Slide,
}

impl Abscissa {
    /// Its name in ids.
    fn name(self) -> &'static str {
        match self {
            Self::Modulus => "modulus",
            Self::Slide => "slide",
        }
    }

    /// The values at which the scheme runs.
    pub fn values(self) -> Vec<f64> {
        match self {
            Self::Modulus => {
                let mut moduli: Vec<f64> = (1..=20).map(|k| 10.0 * f64::from(k)).collect();
                moduli.insert(5, 58.6);
                moduli
            }
            Self::Slide => (0..=20).map(|k| f64::from(k) / 20.0).collect(),
        }
    }

    /// The scene of Fig. 3 with another modulus or slide factor, until the longitudinal wave has gone
    /// twice the way to the crossover, 0.2 m.
    pub fn scene(self, value: f64) -> Scene {
        let scene = shipped("fig3");
        match self {
            Self::Modulus => of_modulus(1e9 * value, scene),
            Self::Slide => sliding_by(value, of_modulus(58.6e9, scene)),
        }
    }
}

/// A scene with fibres of another modulus, that ends at t = 2X_c/c.
fn of_modulus(modulus: f64, mut scene: Scene) -> Scene {
    let c = (modulus / scene.primary.density).sqrt();
    scene.primary.material = Material::linear(modulus);
    if let Some(secondary) = &mut scene.secondary {
        secondary.material = Material::linear(modulus);
        scene.duration = 2.0 * secondary.at / c;
    }
    scene
}

/// Length of an element of a mesh, mm.
pub fn element(factor: usize) -> f64 {
    2.0 / factor as f64
}

/// The id of the run that gives a profile.
pub fn profile_id(edition: Edition, factor: usize) -> String {
    format!("fig3-{}-{}mm", edition.name(), element(factor))
}

/// The id of the run that gives a point of a curve.
pub fn curve_id(over: Abscissa, value: f64, edition: Edition, factor: usize) -> String {
    format!("{}-{value}-{}-{}mm", over.name(), edition.name(), element(factor))
}

/// Every run of the study.
pub fn points() -> Vec<Point<Run>> {
    let mut points = Vec::new();
    let mut run = |id, scene: Scene, edition: Edition, factor, profile| {
        let scene = refined(edition.of(scene), factor);
        points.push(Point { id, parameters: Run { scene, profile } });
    };
    for factor in PROFILE_MESHES {
        for edition in Edition::ALL {
            run(profile_id(edition, factor), shipped("fig3"), edition, factor, true);
        }
    }
    let mut curve = |over: Abscissa, value, edition, factor| {
        let id = curve_id(over, value, edition, factor);
        run(id, over.scene(value), edition, factor, false);
    };
    for over in [Abscissa::Modulus, Abscissa::Slide] {
        for value in over.values() {
            for (edition, factor) in CURVES {
                curve(over, value, edition, factor);
            }
        }
    }
    for (over, value) in HALVED {
        for edition in Edition::ALL {
            curve(over, value, edition, 2 * CONVERGED);
        }
    }
    points
}

/// What a run is asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The scene.
    pub scene: Scene,
    /// Whether the strain of every element is kept.
    pub profile: bool,
}

/// What is kept of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Snapshot {
    /// How it ended. Of a run that did not complete nothing else is kept.
    pub outcome: Outcome,
    /// Time reached, s.
    pub time: f64,
    /// Coefficients by means over windows between the exact fronts.
    pub between_fronts: Option<Coefficients>,
    /// Coefficients by means over fixed windows.
    pub fixed: Option<Coefficients>,
    /// The strains of both fibres, where they are asked for.
    pub strains: Option<Strains>,
}

/// The strain of each element, outward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Strains {
    /// The struck fibre.
    pub primary: Vec<f64>,
    /// The crossing fibre.
    pub secondary: Vec<f64>,
}

/// Means over fixed windows, blind to reflected waves: the middle half of the way from the impact point
/// to the crossover, of that from the crossover to the front, and of the same length of the secondary.
///
/// The page says only "a portion of the fibre length away from the oscillation region".
pub fn fixed(at: f64) -> Windows {
    Windows {
        behind: (0.25 * at, 0.75 * at),
        ahead: (1.25 * at, 1.75 * at),
        diverted: (0.25 * at, 0.75 * at),
    }
}

/// The mean over an interval of what is uniform within each element, from 0 to `length`: an element
/// that is in the interval in part counts in part, so that the mean moves with the interval smoothly.
pub fn mean_over(length: f64, of: &[f64], (from, to): (f64, f64)) -> f64 {
    let dx = length / of.len() as f64;
    let share = |i: usize| {
        let (begins, ends) = (i as f64 * dx, (i + 1) as f64 * dx);
        (ends.min(to) - begins.max(from)).max(0.0)
    };
    of.iter().enumerate().map(|(i, x)| share(i) * x).sum::<f64>() / (to - from)
}

fn ratios(scene: &Scene, strains: &Strains, windows: Windows) -> Coefficients {
    let incident = component(scene, exact_single(scene).strain);
    let over = |length, strain: &[f64], window| mean_over(length, strain, window) / incident;
    let secondary = scene.secondary.as_ref().map_or(0.0, |secondary| secondary.length);
    let Strains { primary: on_primary, secondary: on_secondary } = strains;
    Coefficients {
        reflection: over(scene.primary.length, on_primary, windows.behind) - 1.0,
        transmission: over(scene.primary.length, on_primary, windows.ahead),
        diversion: over(secondary, on_secondary, windows.diverted),
    }
}

/// Runs a scene.
pub fn snapshot(run: &Run) -> Snapshot {
    let Run { scene, profile } = run;
    let result = planted::run(scene, |_| {});
    let time = result.time;
    if !result.outcome.is_completed() {
        let outcome = result.outcome;
        return Snapshot { outcome, time, between_fronts: None, fixed: None, strains: None };
    }
    let strains = Strains {
        primary: result.primary.strain,
        secondary: result.secondary.map_or_else(Vec::new, |fibre| fibre.strain),
    };
    let at = scene.secondary.as_ref().map_or(0.0, |secondary| secondary.at);
    Snapshot {
        outcome: result.outcome,
        time,
        between_fronts: Some(ratios(scene, &strains, between_fronts(scene, time))),
        fixed: Some(ratios(scene, &strains, fixed(at))),
        strains: profile.then_some(strains),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::crossover::exact_coefficients;
    use crate::cases::support::relative;

    #[test]
    fn a_mean_counts_elements_by_their_share() {
        // Elements of 0.5 from 0: half of the first, the second, and a fifth of the third.
        let found = mean_over(2.0, &[3.1, 4.7, 0.9, 100.0], (0.25, 1.1));
        let expected = (0.25 * 3.1 + 0.5 * 4.7 + 0.1 * 0.9) / 0.85;
        // A handful of roundings.
        assert!(relative(found, expected) < 1e-15, "{found} {expected}");
    }

    #[test]
    fn ids_name_one_run_each_and_fit_a_file() {
        let points = points();
        let ids: std::collections::BTreeSet<_> = points.iter().map(|point| &point.id).collect();
        assert_eq!(ids.len(), points.len());
        let fits = |c: char| c.is_ascii_alphanumeric() || "-.".contains(c);
        assert!(ids.iter().all(|id| id.chars().all(fits)), "{ids:?}");
        for id in
            ["fig3-printed-2mm", "modulus-58.6-corrected-0.125mm", "slide-0.5-engineering-0.0625mm"]
        {
            assert!(ids.contains(&id.to_owned()), "{id}");
        }
        // The paper's modulus is the shipped one to the bit, and every scene can be run.
        let scene = Abscissa::Modulus.scene(58.6);
        assert_eq!(scene.primary, shipped("fig3").primary);
        assert!(points.iter().all(|point| point.parameters.scene.check().is_ok()));
    }

    /// Against the closed form, at values that are nothing special, with engineering strain at 0.125 mm.
    /// Worst seen: 8e-5, oscillations of the fronts averaged over some hundred elements.
    #[test]
    fn means_between_the_fronts_are_those_of_the_closed_form() {
        for (over, value) in [(Abscissa::Modulus, 43.7), (Abscissa::Slide, 0.83)] {
            let scene = Edition::Engineering.of(refined(over.scene(value), CONVERGED));
            let exact = exact_coefficients(&scene);
            let found = snapshot(&Run { scene, profile: false }).between_fronts.unwrap();
            for (found, exact) in [
                (found.reflection, exact.reflection),
                (found.transmission, exact.transmission),
                (found.diversion, exact.diversion),
            ] {
                assert!((found - exact).abs() < 3e-4, "{value}: {found} {exact}");
            }
        }
    }

    /// A run that the energy balance ends is kept as ended, without a number.
    #[test]
    fn a_run_that_diverges_has_no_coefficients() {
        let mut scene = Edition::Engineering.of(refined(shipped("fig3"), 2));
        scene.courant = 1.3;
        let found = snapshot(&Run { scene, profile: true });
        assert!(!found.outcome.is_completed(), "{found:?}");
        assert_eq!((found.between_fronts, found.fixed, found.strains), (None, None, None));
    }
}
