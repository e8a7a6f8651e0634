//! The ways in which a problem is run.

use crossfibre::errata::{Corrections, Erratum};
use crossfibre::material::Coefficients;
use crossfibre::scene::{Scene, Strain};
use serde::{Deserialize, Serialize};

use super::problems::Problem;

/// The number in which a run is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Precision {
    /// 24 bits.
    Single,
    /// 53 bits.
    Double,
    /// 106 bits.
    DoubleDouble,
}

/// A way to run a problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variant {
    /// Its name in ids, tables and legends.
    pub name: &'static str,
    /// The measure of strain.
    pub strain: Strain,
    /// What is corrected.
    pub corrections: Corrections,
    /// α.
    pub courant: f64,
    /// Whether there is artificial viscosity.
    pub viscous: bool,
    /// The number.
    pub precision: Precision,
    /// Whether only elements up to the wavefront are visited.
    pub flagged: bool,
}

/// The page, corrected, as it is meant to be run.
const PAGE: Variant = Variant {
    name: "eqn (4), α = 1",
    strain: Strain::Incremental,
    corrections: Corrections::ALL,
    courant: 1.0,
    viscous: false,
    precision: Precision::Double,
    flagged: true,
};

const ENGINEERING: Variant =
    Variant { name: "engineering, α = 1", strain: Strain::Engineering, ..PAGE };

const PRINTED: Variant =
    Variant { name: "eqn (4), α = 1, printed", corrections: Corrections::NONE, ..PAGE };

/// Every variant, the page's first.
pub const VARIANTS: [Variant; 18] = [
    PAGE,
    Variant { name: "eqn (4), α = 0.95", courant: 0.95, ..PAGE },
    Variant { name: "eqn (4), α = 0.5", courant: 0.5, ..PAGE },
    Variant { name: "eqn (4), α = 0.5, viscous", courant: 0.5, viscous: true, ..PAGE },
    ENGINEERING,
    Variant { name: "engineering, α = 0.95", courant: 0.95, ..ENGINEERING },
    Variant { name: "engineering, α = 0.5", courant: 0.5, ..ENGINEERING },
    Variant { name: "engineering, α = 0.5, viscous", courant: 0.5, viscous: true, ..ENGINEERING },
    Variant {
        name: "engineering, α = 0.95, viscous", courant: 0.95, viscous: true, ..ENGINEERING
    },
    PRINTED,
    Variant { name: "engineering, α = 1, printed", corrections: Corrections::NONE, ..ENGINEERING },
    Variant {
        name: "engineering, α = 1, no inertia",
        corrections: Corrections::ALL.without(Erratum::CrossoverInertia),
        ..ENGINEERING
    },
    Variant { name: "eqn (4), α = 1, f32", precision: Precision::Single, ..PAGE },
    Variant { name: "engineering, α = 1, f32", precision: Precision::Single, ..ENGINEERING },
    Variant { name: "eqn (4), α = 1, 106 bits", precision: Precision::DoubleDouble, ..PAGE },
    Variant {
        name: "engineering, α = 1, 106 bits",
        precision: Precision::DoubleDouble,
        ..ENGINEERING
    },
    Variant {
        name: "eqn (4), α = 1, printed, 106 bits",
        precision: Precision::DoubleDouble,
        ..PRINTED
    },
    Variant { name: "eqn (4), α = 1, no flags", flagged: false, ..PAGE },
];

/// ζ and its square's coefficient of the viscous variants: those of the shipped scene.
const VISCOSITY: Coefficients = Coefficients { linear: 0.3, quadratic: 1.0 };

impl Variant {
    /// The variant of a name.
    ///
    /// # Panics
    /// If there is none: a fault of this program.
    pub fn named(name: &str) -> Self {
        let found = VARIANTS.into_iter().find(|variant| variant.name == name);
        found.unwrap_or_else(|| panic!("no variant is called {name}"))
    }

    /// The name as a part of a file's: letters, digits, `-` and `.`.
    pub fn slug(&self) -> String {
        let plain = self.name.replace("eqn (4)", "eqn-4").replace("α = ", "").replace(", ", "-");
        plain.replace(' ', "-")
    }

    /// Whether a problem is run in this way: what would be the same run as another is not.
    pub fn applies_to(&self, problem: Problem) -> bool {
        // Nothing that the ledger corrects is in a single fibre struck at a constant velocity.
        self.corrections == Corrections::ALL || problem.has_crossover()
    }

    /// The scene run in this way.
    pub fn of(&self, mut scene: Scene) -> Scene {
        scene.strain = self.strain;
        scene.courant = self.courant;
        scene.corrections = self.corrections;
        let viscosity = self.viscous.then_some(VISCOSITY);
        scene.primary.material.artificial_viscosity = viscosity;
        if let Some(secondary) = &mut scene.secondary {
            secondary.material.artificial_viscosity = viscosity;
        }
        scene
    }
}
