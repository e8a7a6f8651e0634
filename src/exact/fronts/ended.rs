//! How a followed motion ends before its time.

use std::fmt;

use serde::Serialize;

use crate::place::Fibre;

/// Why the solution does not go on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Ended {
    /// A fibre goes slack: it would be [folded](crate::exact::riemann::Arm::is_folded).
    Slack {
        /// Which fibre.
        fibre: Fibre,
        /// Where, m from the impact point (the crossover).
        at: f64,
        /// When, s.
        time: f64,
    },
    /// The tension law has no waves at the strain that would follow.
    BeyondTheLaw {
        /// Which fibre.
        fibre: Fibre,
        /// Where, m.
        at: f64,
        /// When, s.
        time: f64,
    },
    /// A kink reaches a crossover that slides (α_s < 1): along which of the two directions it
    /// slides from there on, the model does not say.
    SlidesOnKink {
        /// When, s.
        time: f64,
    },
    /// The waves left out have grown to more than the strain of the impact: what is left is no
    /// solution.
    Unresolved {
        /// When, s.
        time: f64,
    },
    /// More meetings of fronts than [`Limits`](super::Limits) allow.
    TooMany {
        /// When, s.
        time: f64,
        /// Meetings so far.
        events: u64,
    },
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slack { fibre, at, time } => {
                write!(
                    f,
                    "the {} fibre goes slack at {at:.6} m, {:.4} µs",
                    fibre.name(),
                    time * 1e6
                )
            }
            Self::BeyondTheLaw { fibre, at, time } => write!(
                f,
                "the {} fibre is strained beyond the range of its law at {at:.6} m, {:.4} µs",
                fibre.name(),
                time * 1e6
            ),
            Self::SlidesOnKink { time } => {
                write!(f, "a kink reaches the sliding crossover at {:.4} µs", time * 1e6)
            }
            Self::Unresolved { time } => write!(
                f,
                "by {:.4} µs the waves too weak to follow add up to more than the strain itself",
                time * 1e6
            ),
            Self::TooMany { time, events } => {
                write!(f, "{events} meetings of fronts by {:.4} µs are the limit", time * 1e6)
            }
        }
    }
}

impl std::error::Error for Ended {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_says_where_and_when() {
        let (fibre, at, time) = (Fibre::Primary, 0.0731, 31.37e-6);
        for (ended, words) in [
            (
                Ended::Slack { fibre, at, time },
                "the primary fibre goes slack at 0.073100 m, 31.3700 µs",
            ),
            (
                Ended::BeyondTheLaw { fibre: Fibre::Secondary, at, time },
                "the secondary fibre is strained beyond the range of its law at 0.073100 m, 31.3700 µs",
            ),
            (Ended::SlidesOnKink { time }, "a kink reaches the sliding crossover at 31.3700 µs"),
            (
                Ended::Unresolved { time },
                "by 31.3700 µs the waves too weak to follow add up to more than the strain itself",
            ),
            (
                Ended::TooMany { time, events: 713 },
                "713 meetings of fronts by 31.3700 µs are the limit",
            ),
        ] {
            assert_eq!(ended.to_string(), words);
        }
    }
}
