//! How a run ends: always a type, never a silent not-a-number.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::place::{Fibre, Place};

/// The end of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Outcome {
    /// All steps were made and every number is finite.
    Completed,
    /// A number left the range of its type.
    Diverged {
        /// Where it was first seen.
        #[serde(flatten)]
        place: Place,
        /// The first equation of that place whose result is not finite.
        equation: u8,
    },
    /// The crossover slid off the modelled part of the primary fibre.
    CrossoverLeft {
        /// The step after which its nearest node was an end of the fibre.
        step: u64,
        /// Which end.
        end: End,
    },
    /// Every number is finite, but the energy balance is broken ([`crate::result::MOST_IMBALANCE`]):
    /// the equations were used where they do not hold, or an instability has run away.
    EnergyUnbalanced {
        /// The step at which the balance was drawn.
        step: u64,
        /// Residual of the balance over the energy put in, without its sign; none where the sum is
        /// not finite.
        #[serde(skip_serializing_if = "Option::is_none")]
        residual: Option<f64>,
    },
}

/// An end of the primary fibre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// The projectile's node.
    ImpactPoint,
    /// The clamped node.
    Clamp,
}

impl Outcome {
    /// The run came to its planned end.
    pub fn is_completed(&self) -> bool {
        *self == Self::Completed
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Completed => write!(f, "completed"),
            Self::Diverged { place: Place { step, fibre, index }, equation } => write!(
                f,
                "diverged: eqn ({equation}) is not finite at step {step}, {} {} {index}",
                fibre.name(),
                if matches!(equation, 4..=7) { "element" } else { "node" },
            ),
            Self::CrossoverLeft { step, end } => {
                let end = match end {
                    End::ImpactPoint => "the impact point",
                    End::Clamp => "the clamp",
                };
                write!(
                    f,
                    "crossover left the {} fibre: at step {step} it slid to {end}",
                    Fibre::Primary.name()
                )
            }
            Self::EnergyUnbalanced { step, residual: Some(residual) } => write!(
                f,
                "energy unbalanced: at step {step} the balance is off by {} times the energy put in",
                if *residual < 100.0 {
                    format!("{residual:.2}")
                } else {
                    format!("{residual:.1e}")
                }
            ),
            Self::EnergyUnbalanced { step, residual: None } => {
                write!(f, "energy unbalanced: at step {step} the energy is beyond all numbers")
            }
        }
    }
}
