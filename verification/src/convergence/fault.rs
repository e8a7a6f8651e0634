//! Why numbers allow no answer.

use std::fmt;

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// Fewer meshes than the question needs.
    TooFew {
        /// How many there are.
        found: usize,
        /// How many there must be.
        needed: usize,
    },
    /// A number that must be positive and finite and is not.
    NotPositive {
        /// Which mesh, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A number that must be finite and is not, or whose difference to the one before is not.
    NotFinite {
        /// Which mesh, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A mesh that is not finer than the one before.
    NotFiner {
        /// Which mesh, from 0.
        index: usize,
    },
    /// All meshes are of one spacing.
    OneSpacing,
    /// A value equal to that of the mesh before: no difference, no order.
    SameValue {
        /// Which mesh, from 0.
        index: usize,
    },
    /// A wanted error that is not positive and finite.
    Wanted(f64),
    /// A level of confidence outside (0, 1).
    Level(f64),
    /// A range of orders or a fraction of one that is not positive and rising.
    Orders(f64, f64),
    /// A band that is not positive or a floor that is negative.
    Rule {
        /// The band.
        band: f64,
        /// The floor.
        floor: f64,
    },
    /// The values fit best with an order at the edge of the range that was searched.
    AtTheEdge {
        /// That order.
        order: f64,
    },
    /// A result that is beyond the range of the numbers.
    OutOfRange,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { found, needed } => write!(f, "{found} meshes, {needed} are needed"),
            Self::NotPositive { index, value } => {
                write!(f, "mesh {index}: {value:e} is not a positive number")
            }
            Self::NotFinite { index, value } => {
                write!(f, "mesh {index}: {value:e} is too large or not a number")
            }
            Self::NotFiner { index } => write!(f, "mesh {index} is not finer than the one before"),
            Self::OneSpacing => write!(f, "all meshes have one spacing"),
            Self::SameValue { index } => {
                write!(f, "mesh {index} has the value of the one before: there is no order")
            }
            Self::Wanted(error) => write!(f, "{error:e} cannot be reached: it is not positive"),
            Self::Level(level) => write!(f, "a level of {level} is not between 0 and 1"),
            Self::Orders(from, to) => write!(f, "{from} to {to} is no range of orders"),
            Self::Rule { band, floor } => {
                write!(f, "a band of {band:e} or a floor of {floor:e} makes no sense")
            }
            Self::AtTheEdge { order } => {
                write!(f, "the best order, {order}, is at the edge of the range")
            }
            Self::OutOfRange => write!(f, "the result is beyond the range of the numbers"),
        }
    }
}

impl std::error::Error for Fault {}

/// At least so many meshes.
pub(super) fn enough(ladder: &[(f64, f64)], needed: usize) -> Result<(), Fault> {
    let found = ladder.len();
    if found < needed { Err(Fault::TooFew { found, needed }) } else { Ok(()) }
}

/// Positive, finite numbers only.
pub(super) fn positive(numbers: impl Iterator<Item = f64>) -> Result<(), Fault> {
    for (index, value) in numbers.enumerate() {
        if !(value.is_finite() && value > 0.0) {
            return Err(Fault::NotPositive { index, value });
        }
    }
    Ok(())
}

/// Positive spacings, each finer than the one before, and finite values.
pub(super) fn descending(ladder: &[(f64, f64)]) -> Result<(), Fault> {
    positive(ladder.iter().map(|&(h, _)| h))?;
    for (index, &(_, value)) in ladder.iter().enumerate() {
        if !value.is_finite() {
            return Err(Fault::NotFinite { index, value });
        }
    }
    match ladder.windows(2).position(|pair| pair[0].0 <= pair[1].0) {
        Some(k) => Err(Fault::NotFiner { index: k + 1 }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_fault_is_said_in_words_with_its_numbers() {
        for (fault, words) in [
            (Fault::TooFew { found: 2, needed: 3 }, "2 meshes, 3 are needed"),
            (
                Fault::NotPositive { index: 1, value: -0.5 },
                "mesh 1: -5e-1 is not a positive number",
            ),
            (
                Fault::NotFinite { index: 4, value: f64::INFINITY },
                "mesh 4: inf is too large or not a number",
            ),
            (Fault::NotFiner { index: 2 }, "mesh 2 is not finer than the one before"),
            (Fault::OneSpacing, "all meshes have one spacing"),
            (
                Fault::SameValue { index: 3 },
                "mesh 3 has the value of the one before: there is no order",
            ),
            (Fault::Wanted(0.0), "0e0 cannot be reached: it is not positive"),
            (Fault::Level(1.5), "a level of 1.5 is not between 0 and 1"),
            (Fault::Orders(0.7, 0.2), "0.7 to 0.2 is no range of orders"),
            (
                Fault::Rule { band: 0.1, floor: -1.0 },
                "a band of 1e-1 or a floor of -1e0 makes no sense",
            ),
            (Fault::AtTheEdge { order: 0.05 }, "the best order, 0.05, is at the edge of the range"),
            (Fault::OutOfRange, "the result is beyond the range of the numbers"),
        ] {
            assert_eq!(fault.to_string(), words);
        }
    }
}
