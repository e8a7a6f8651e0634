//! How a run ends: always a type, never a silent not-a-number.

use std::fmt;
use std::ops::Not;

use serde::{Deserialize, Serialize};

use crate::place::{Fibre, Place};
use crate::result::MOST_SEARCHED;

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
    /// A law's wave speed has outgrown the time step.
    CourantExceeded {
        /// The element where it was first seen.
        #[serde(flatten)]
        place: Place,
        /// Its local Courant number, above 1; artificial viscosity counts.
        courant: f64,
        /// The Courant number of a scene, otherwise the same, that has been run to its end; none
        /// where none was found.
        #[serde(skip_serializing_if = "Option::is_none")]
        would_serve: Option<f64>,
        /// Whether the search for that one was given up, since it would have taken more than
        /// [`crate::result::MOST_SEARCHED`] element-steps.
        #[serde(default, skip_serializing_if = "Not::not")]
        search_given_up: bool,
    },
    /// A law has softened so much that its modulus is negative: there are no waves, and the problem
    /// has no solution to converge to.
    NoWaves {
        /// The element where it was first seen.
        #[serde(flatten)]
        place: Place,
        /// Its strain.
        strain: f64,
    },
    /// Every number is finite, but the energy balance is broken ([`crate::result::MOST_IMBALANCE`]):
    /// the equations were used where they do not hold, or an instability has run away.
    EnergyUnbalanced {
        /// The step at which the balance was drawn.
        step: u64,
        /// Residual of the balance over the energy put in, without its sign, or the excess of a part
        /// over it ([`crate::balance::Energy::imbalance`]); or the same of the fibres over what they
        /// were given, whichever is greater; none where a sum is not finite.
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
    /// The step that the run ended in the middle of, if it did.
    pub(crate) fn broken_step(&self) -> Option<u64> {
        match self {
            Self::Diverged { place, .. }
            | Self::CourantExceeded { place, .. }
            | Self::NoWaves { place, .. } => Some(place.step),
            Self::Completed | Self::CrossoverLeft { .. } | Self::EnergyUnbalanced { .. } => None,
        }
    }

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
            Self::CourantExceeded { place, courant, would_serve, search_given_up } => {
                let Place { step, fibre, index } = place;
                write!(
                    f,
                    "Courant limit exceeded: the wave speed outgrew the time step at step {step}, \
                     {} element {index}, where the Courant number is {courant:.4}",
                    fibre.name()
                )?;
                match would_serve {
                    Some(served) => write!(f, "; {served:.3} would have served"),
                    None if *search_given_up => write!(
                        f,
                        "; the search for one that would have served was given up before \
                         {MOST_SEARCHED:.0e} element-steps"
                    ),
                    None => Ok(()),
                }
            }
            Self::NoWaves { place: Place { step, fibre, index }, strain } => write!(
                f,
                "no waves: at step {step}, {} element {index}, strain {strain:.4}, the law has \
                 softened to a negative modulus",
                fibre.name()
            ),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outcome_says_where_and_what_happened() {
        let place = Place { step: 71, fibre: Fibre::Secondary, index: 13 };
        let exceeded = |would_serve, search_given_up| Outcome::CourantExceeded {
            place,
            courant: 1.07318,
            would_serve,
            search_given_up,
        };
        let unbalanced = |residual| Outcome::EnergyUnbalanced { step: 71, residual };
        for (outcome, words) in [
            (Outcome::Completed, "completed"),
            (
                Outcome::Diverged { place, equation: 7 },
                "diverged: eqn (7) is not finite at step 71, secondary element 13",
            ),
            (
                Outcome::Diverged { place, equation: 2 },
                "diverged: eqn (2) is not finite at step 71, secondary node 13",
            ),
            (
                Outcome::CrossoverLeft { step: 71, end: End::ImpactPoint },
                "crossover left the primary fibre: at step 71 it slid to the impact point",
            ),
            (
                Outcome::CrossoverLeft { step: 71, end: End::Clamp },
                "crossover left the primary fibre: at step 71 it slid to the clamp",
            ),
            (
                exceeded(Some(0.8764), false),
                "Courant limit exceeded: the wave speed outgrew the time step at step 71, secondary \
                 element 13, where the Courant number is 1.0732; 0.876 would have served",
            ),
            (
                exceeded(None, false),
                "Courant limit exceeded: the wave speed outgrew the time step at step 71, secondary \
                 element 13, where the Courant number is 1.0732",
            ),
            (
                exceeded(None, true),
                "Courant limit exceeded: the wave speed outgrew the time step at step 71, secondary \
                 element 13, where the Courant number is 1.0732; the search for one that would have \
                 served was given up before 1e9 element-steps",
            ),
            (
                Outcome::NoWaves { place, strain: -0.03137 },
                "no waves: at step 71, secondary element 13, strain -0.0314, the law has softened to a \
                 negative modulus",
            ),
            (
                unbalanced(Some(0.3719)),
                "energy unbalanced: at step 71 the balance is off by 0.37 times the energy put in",
            ),
            (
                unbalanced(Some(371.9)),
                "energy unbalanced: at step 71 the balance is off by 3.7e2 times the energy put in",
            ),
            (unbalanced(None), "energy unbalanced: at step 71 the energy is beyond all numbers"),
        ] {
            assert_eq!(outcome.to_string(), words);
        }
    }
}
