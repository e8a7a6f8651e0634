//! Where an equation is evaluated.

use serde::{Deserialize, Serialize};

/// One of the two fibres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Fibre {
    /// The struck fibre, in the x-y plane.
    Primary,
    /// The crossing fibre, in three dimensions.
    Secondary,
}

impl Fibre {
    /// The name used in files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Secondary => "secondary",
        }
    }
}

/// Step, fibre and index of an evaluation.
///
/// The index is the 0-based node for velocities and crossover quantities, and the 0-based element
/// for lengths, strains and tensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Place {
    /// The time step, from 1.
    pub step: u64,
    /// The fibre.
    pub fibre: Fibre,
    /// Node or element.
    pub index: usize,
}
