//! Where the oracles of the cases are derived: pages of `docs/`, by the names of cases.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A page, or a section of one, on which an oracle is derived or a method explained.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Derivation {
    /// What is derived there.
    pub title: String,
    /// The file from the root of the repository, with the section after `#`.
    pub path: String,
}

type Page = (&'static str, &'static str);

const HAND: Page = ("The equations at numbers worked by hand", "docs/exact/by-hand.md");
const HAND_STEP: Page =
    ("A step of four elements", "docs/exact/by-hand.md#a-step-of-four-elements");
const SMITH: Page = ("Transverse impact on one long fibre", "docs/exact/smith.md#derivation");
const LAWS: Page = ("Laws that harden or soften", "docs/exact/smith.md#laws-that-harden-or-soften");
const CROSSOVER: Page =
    ("The crossover before the kink comes", "docs/exact/crossover.md#derivation");
const RIEMANN: Page = ("Riemann problems of strings", "docs/exact/riemann.md");
const FRONTS: Page = ("The motion at any time, front by front", "docs/exact/fronts.md");
const AXIAL: Page =
    ("Axial pull by images", "docs/exact/axial-and-dispersion.md#axial-pull-the-method-of-images");
const DISPERSION: Page = ("Dispersion", "docs/exact/axial-and-dispersion.md#dispersion");
const GROWTH: Page = ("Growth beyond the limit", "docs/exact/axial-and-dispersion.md#growth");
const STABILITY: Page = ("The largest stable Courant number", "docs/exact/stability.md");
const ROD: Page = ("The pulled viscoelastic rod", "docs/exact/viscoelastic.md");
const MATERIALS: Page = ("Constitutive laws", "docs/materials.md");
const SLACK: Page = ("Tension only", "docs/materials.md#tension-only");
const VISCOSITY: Page = ("Artificial viscosity", "docs/materials.md#artificial-viscosity");
const LEVELS: Page =
    ("Which time a number belongs to", "docs/scheme.md#which-time-a-number-belongs-to");
const STEP: Page = ("One step, from t−1 to t", "docs/scheme.md#one-step-from-t1-to-t");
const ORDERS: Page = ("Which orders to expect", "docs/convergence.md#which-orders-to-expect");
const INDEX: Page = (
    "Richardson's extrapolation and the grid convergence index",
    "docs/convergence.md#richardsons-extrapolation-and-the-grid-convergence-index",
);
const WORK: Page = ("Error against work", "docs/work-precision/README.md");
const JUDGED: Page = ("How answers are judged", "docs/conformance.md#how-it-is-judged");
const GOLDEN: Page = ("The golden vectors", "docs/formats.md#crossfibre-vectors1");
const EXTREMES: Page = ("Extreme cases", "docs/extremes/README.md");
const DEPARTURES: Page = ("Departures from the page", "VALIDATION.md#departures-from-the-page");

/// Cases by their names or the beginnings of them, and their pages. The first that fits counts.
const PAGES: &[(&str, &[Page])] = &[
    ("by-hand.step", &[HAND_STEP, STEP]),
    ("by-hand.", &[HAND, DEPARTURES]),
    ("smith.", &[SMITH]),
    ("axial.dispersion", &[DISPERSION]),
    ("axial.", &[AXIAL]),
    ("courant.growth", &[GROWTH]),
    ("courant.impact", &[GROWTH, LEVELS]),
    ("stability.", &[STABILITY]),
    ("crossover.inertia", &[STABILITY, DEPARTURES]),
    ("crossover.printed", &[CROSSOVER, DEPARTURES]),
    ("crossover.", &[CROSSOVER]),
    ("projectile.", &[LEVELS, DEPARTURES]),
    ("energy.printed", &[LEVELS, DEPARTURES]),
    ("energy.", &[LEVELS]),
    ("momentum.", &[LEVELS]),
    ("identity.", &[STEP]),
    ("invariance.", &[STEP, DEPARTURES]),
    ("motion.", &[FRONTS, RIEMANN]),
    ("material.softening", &[LAWS]),
    ("material.hardening", &[LAWS]),
    ("material.inflection", &[LAWS]),
    ("material.rod", &[ROD]),
    ("material.arms", &[ROD, MATERIALS]),
    ("material.stiff", &[ROD, MATERIALS]),
    ("material.slack", &[SLACK]),
    ("material.viscosity", &[VISCOSITY]),
    ("material.", &[MATERIALS]),
    ("conformance.", &[JUDGED]),
    ("golden.", &[GOLDEN]),
    ("precision.gci", &[INDEX]),
    ("precision.orders", &[ORDERS]),
    ("precision.", &[WORK, ORDERS]),
    ("record.", &[WORK, ORDERS]),
    ("extreme.", &[EXTREMES]),
];

/// Where the oracles of a case are derived.
pub fn of(case: &str) -> Vec<Derivation> {
    let pages = PAGES.iter().find(|(name, _)| case.starts_with(name)).map_or(&[][..], |(_, p)| *p);
    pages
        .iter()
        .map(|(title, path)| Derivation { title: (*title).into(), path: (*path).into() })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::cases;

    /// The name that a heading has in links, as code hosts make it: lower case, spaces to hyphens,
    /// everything else but letters, figures, hyphens and underscores left out.
    fn anchor(heading: &str) -> String {
        let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
        let text: String = heading.trim().to_lowercase().chars().filter(kept).collect();
        text.replace(' ', "-")
    }

    #[test]
    fn every_case_has_a_derivation_and_every_line_a_case() {
        let cases = cases::all();
        for case in &cases {
            assert!(!of(case.id).is_empty(), "{}", case.id);
        }
        for (name, _) in PAGES {
            assert!(cases.iter().any(|case| case.id.starts_with(name)), "{name}");
        }
    }

    #[test]
    fn every_page_and_section_is_there() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        for (title, path) in PAGES.iter().flat_map(|(_, pages)| *pages) {
            let (file, section) = path.split_once('#').unwrap_or((path, ""));
            let text = fs::read_to_string(root.join(file)).expect(path);
            let mut headings = text.lines().filter_map(|line| line.strip_prefix('#'));
            let found = headings.any(|h| anchor(h.trim_start_matches('#')) == section);
            assert!(section.is_empty() || found, "{title}: {path}");
        }
    }
}
