//! The problems: scenes of which the exact answer is known, on a ladder of meshes.

use crossfibre::material::{Arm, Update};
use crossfibre::scene::{Law, Scene};
use serde::{Deserialize, Serialize};

use crate::cases::support::{shipped, sliding_by};

/// A problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Problem {
    /// One fibre, struck at 400 m/s.
    Single,
    /// The paper's two fibres at the paper's time.
    Crossed,
    /// Two different fibres after reflections at both clamps.
    Unequal,
    /// A viscoelastic fibre, pulled along its axis.
    Rod,
}

/// Refinements of the paper's mesh (2 mm), the coarsest first; below 1 it is coarsened.
pub const REFINEMENTS: [f64; 9] = [0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];

impl Problem {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Single, Self::Crossed, Self::Unequal, Self::Rod];

    /// Its name in ids.
    pub fn id(self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::Crossed => "crossed",
            Self::Unequal => "unequal",
            Self::Rod => "rod",
        }
    }

    /// What it is.
    pub fn title(self) -> &'static str {
        match self {
            Self::Single => "One fibre, 400 m/s, 28.7 µs",
            Self::Crossed => "Fig. 3: two crossed fibres, 400 m/s, 28.7 µs",
            Self::Unequal => "Two unequal fibres, 317 m/s, 73.1 µs",
            Self::Rod => "A viscoelastic rod, pulled at 3.7 m/s, 4.2 relaxation times",
        }
    }

    /// Whether a fibre crosses.
    pub fn has_crossover(self) -> bool {
        matches!(self, Self::Crossed | Self::Unequal)
    }

    /// Whether the projectile pulls along the fibre, not across.
    pub fn is_pulled_along(self) -> bool {
        self == Self::Rod
    }

    /// The scene on a mesh that is the paper's times a refinement.
    pub fn scene(self, refinement: f64) -> Scene {
        let mut scene = match self {
            Self::Single => shipped("single-400"),
            Self::Crossed => shipped("fig3"),
            Self::Unequal => {
                let mut scene = sliding_by(1.0, shipped("unequal"));
                scene.projectile.mass = None;
                scene.duration = 73.1e-6;
                scene
            }
            Self::Rod => rod(),
        };
        let refined = |elements: usize| (elements as f64 * refinement).round() as usize;
        scene.primary.elements = refined(scene.primary.elements);
        if let Some(secondary) = &mut scene.secondary {
            secondary.elements = refined(secondary.elements);
        }
        scene
    }
}

/// A standard linear solid with one arm, until its front is near the clamp.
fn rod() -> Scene {
    let (spring, arm) = (23.7e9, 67.9e9);
    let mut scene = shipped("viscoelastic");
    (scene.secondary, scene.projectile.mass) = (None, None);
    scene.projectile.velocity = 3.7;
    let wave_speed = ((spring + arm) / scene.primary.density).sqrt();
    scene.duration = 0.97 * scene.primary.length / wave_speed;
    let arm = Arm { modulus: arm, relaxation_time: scene.duration / 4.2 };
    scene.primary.material.law =
        Law::Viscoelastic { equilibrium_modulus: spring, arms: vec![arm], update: Update::Exact };
    scene
}
