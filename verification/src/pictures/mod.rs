//! The pictures of a report: those stored in `docs/`, which studies have drawn, and those that are drawn
//! with the record. Each has its own ground, light and dark.

mod conformance;
mod energy;
mod frames;
mod history;
mod laws;
mod momentum;
pub mod motion;
mod rounding;
mod step;
mod stored;
mod units;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// Its name in links.
    pub id: String,
    /// Where it stands in the report.
    pub section: Section,
    /// What stands over it.
    pub title: String,
    /// What it shows, and what to see in it.
    pub caption: String,
    /// The same for those who do not see it.
    pub alt: String,
    /// The drawing.
    pub svg: String,
}

/// A part of the report that has pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Section {
    /// The paper's figures, and the motion.
    Figures,
    /// Errors against work.
    Cost,
    /// Stable and unstable steps.
    Stability,
}

/// Cases by their names or the beginnings of them, and the pictures that show what they are about. The
/// first that fits counts.
const OF_CASES: &[(&str, &[&str])] = &[
    ("by-hand.crossover", &["motion"]),
    ("by-hand.", &["step"]),
    ("smith.", &["fig3-plateaus", "fig3"]),
    ("axial.", &["stability-velocity"]),
    ("courant.", &["stability-velocity"]),
    ("stability.projectile", &["stability-mass"]),
    ("stability.crossover", &["stability-slide", "stability-modulus"]),
    ("stability.", &["stability-velocity"]),
    ("crossover.inertia", &["stability-slide"]),
    ("crossover.", &["fig3-plateaus", "fig4", "fig5", "fig6", "fig7"]),
    ("projectile.momentum", &["momentum", "stability-mass"]),
    ("projectile.", &["stability-mass"]),
    ("energy.", &["energy"]),
    ("momentum.", &["momentum"]),
    ("motion.", &["xt", "xt-exact", "motion"]),
    ("identity.free-sliding", &["fig5", "fig6", "fig7"]),
    ("identity.wavefront-flags", &["xt"]),
    ("identity.causality", &["xt"]),
    ("identity.both-at-origin", &["motion"]),
    ("invariance.", &["frames"]),
    ("conformance.", &["conformance"]),
    ("material.rod", &["work-rod"]),
    ("material.", &["laws"]),
    ("extreme.velocity", &["stability-velocity"]),
    ("extreme.rounding", &["rounding"]),
    ("extreme.ratios", &["stability-modulus"]),
    ("extreme.crossover", &["stability-modulus"]),
    ("extreme.mesh", &["work-single"]),
    ("extreme.long", &["energy", "momentum"]),
    ("extreme.projectile", &["stability-mass"]),
    ("extreme.laws", &["laws"]),
    ("extreme.scaling", &["units"]),
    ("golden.", &["fig3", "step"]),
    ("record.", &["work-single", "work-crossed", "work-unequal"]),
    ("precision.cost", &["time"]),
    ("precision.split", &["work-single", "work-crossed", "work-unequal", "rounding"]),
    ("precision.", &["work-single", "work-crossed", "work-unequal"]),
];

/// The pictures that show what a case is about.
pub fn of_case(case: &str) -> Vec<String> {
    let found = OF_CASES.iter().find(|(name, _)| case.starts_with(name));
    found.map_or_else(Vec::new, |(_, ids)| ids.iter().map(|id| (*id).to_owned()).collect())
}

/// Every picture, in the order of the report.
pub fn all() -> Vec<Picture> {
    let mut pictures = vec![];
    for picture in stored::PICTURES.iter().map(stored::Stored::picture) {
        let drawn = drawn_after(&picture.id);
        pictures.push(picture);
        pictures.extend(drawn);
    }
    pictures
}

/// The pictures that are drawn with the record and stand after a stored one.
fn drawn_after(id: &str) -> Vec<Picture> {
    match id {
        "motion" => vec![
            step::picture(),
            energy::picture(),
            momentum::picture(),
            frames::picture(),
            laws::picture(),
        ],
        "time" => vec![rounding::picture(), units::picture(), conformance::picture()],
        _ => vec![],
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_picture_has_a_name_of_its_own_and_says_what_it_shows() {
        let pictures = all();
        let ids: BTreeSet<&str> = pictures.iter().map(|picture| picture.id.as_str()).collect();
        assert_eq!(ids.len(), pictures.len());
        for picture in &pictures {
            assert!(picture.svg.starts_with("<svg ") && picture.svg.trim_end().ends_with("</svg>"));
            assert!(picture.alt.len() > 40 && picture.alt != picture.caption, "{}", picture.id);
            assert!(picture.svg.contains("prefers-color-scheme:dark"), "{}", picture.id);
        }
        for case in crate::cases::all() {
            assert!(!of_case(case.id).is_empty(), "{}", case.id);
        }
        for (case, shown) in OF_CASES {
            assert!(shown.iter().all(|id| ids.contains(id)), "{case}");
            assert!(crate::cases::all().iter().any(|known| known.id.starts_with(case)), "{case}");
        }
    }

    #[test]
    fn a_case_has_the_pictures_of_the_first_name_that_fits() {
        assert_eq!(of_case("by-hand.crossover"), ["motion"]);
        assert_eq!(of_case("by-hand.equations"), ["step"]);
        assert_eq!(of_case("momentum.fig3"), ["momentum"]);
        assert!(of_case("no-case").is_empty());
    }
}
