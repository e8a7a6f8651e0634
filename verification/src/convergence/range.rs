//! Whether errors on a ladder of meshes are in the asymptotic range, and from which mesh on.
//!
//! **The rule.** The asymptotic range is the longest run of meshes, of at least [`LEAST`], that ends
//! with the finest one above the floor, in which
//!
//! 1. the signed error keeps its sign,
//! 2. every order between two successive meshes is within the band of the order fitted to all of the
//!    run, and
//! 3. the fitted order is greater than the band.
//!
//! **Its reasons.**
//!
//! *The finest meshes.* An order is a statement about h → 0. A run of agreeing orders among coarse
//! meshes, with others below it, is a coincidence or a term that has been overtaken.
//!
//! *Pairwise orders against the fit,* not the fit's interval: a slow bend gives a narrow interval
//! about a wrong order, but the orders of its ends show it.
//!
//! *Signs.* The mean of a strain over a fixed window behind a front is C hᵖ plus what the ringing
//! leaves at the ends of the window. Its wavelength is some elements, so its phase at the ends changes
//! with every mesh, and so may the sign of the sum. Where the sign of an error changes, two
//! contributions at least are of one size, and one power of h does not describe their sum. Its
//! size has a dip there: the order before is too large and the one after too small or negative,
//! and with a few meshes they may agree with any fit. Errors ∓C hᵖ that alternate have perfect
//! orders, but of their envelope: what was fitted is a bound, not a value that could be
//! extrapolated. So no run goes over a change of sign, however well its orders agree. One change
//! is a crossing of two terms and asks for finer meshes; two changes or more of the error, or of its
//! differences from mesh to mesh (then the error swings about another one that keeps its sign), are
//! an oscillation, and [`super::envelope`] is what can be fitted.
//!
//! *An order greater than the band.* Otherwise an order of zero is within the band, and errors that do
//! not fall, as those of a wrong limit, would be asymptotic with order zero.
//!
//! *The floor.* The error is known to ± floor: the rounding of the march, or the bound of the oracle. An
//! error is on the floor if that uncertainty alone could change the order of its mesh and the one
//! before by more than the band. The finest meshes on the floor say nothing about order; they are
//! left out, and the verdict says so. But a first mesh on the floor whose error is smaller than the
//! order of the run before it allows, even with the floor added, has not met the floor: the error
//! passes through zero there.

mod series;

use crossfibre::number::Number;
use serde::{Deserialize, Serialize};

use super::Fault;
use super::fault::{descending, enough};
use super::limit::best_order;
use super::line::Line;
use super::orders::pairwise;
use super::richardson;
use series::Series;

/// The fewest errors, or differences of values, that make a run: two orders that agree.
pub const LEAST: usize = 3;

/// Orders between which the limit of values is fitted.
const ORDERS: (f64, f64) = (0.05, 10.0);

/// What counts as agreement, and as nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rule {
    /// The greatest difference of a pairwise order from the fitted one.
    pub band: f64,
    /// What an error is known to, in its unit; of differences of values, what they are known to. Zero
    /// if only an exact zero is nothing.
    pub floor: f64,
}

/// Meshes in the asymptotic range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The coarsest of them, from 0.
    pub from: usize,
    /// How many there are.
    pub meshes: usize,
    /// p, fitted to all of them.
    pub order: f64,
    /// The greatest difference of a pairwise order from it.
    pub within: f64,
}

/// What a ladder of meshes shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The finest meshes are in the asymptotic range.
    Asymptotic(Run),
    /// The finest meshes are on the floor.
    Floor {
        /// The coarsest of them, from 0.
        from: usize,
        /// The asymptotic range that ends above the floor.
        before: Option<Run>,
    },
    /// The error, or its differences, change sign again and again.
    Oscillating {
        /// How often.
        changes: usize,
    },
    /// Nothing of this.
    NotYet(Reason),
}

/// Why a ladder shows no asymptotic range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// Too few meshes for any run.
    TooFew,
    /// The error changes sign once, among the [`LEAST`] finest.
    Crossing,
    /// The finest mesh above the floor is followed by one whose error is too small for the order.
    Dip {
        /// Which mesh, from 0.
        mesh: usize,
    },
    /// The last order, or the one fitted to the [`LEAST`] finest, is not greater than the band.
    NotFalling,
    /// The finest orders do not agree.
    Scattered,
}

/// The verdict on signed errors (h, value − exact), coarse to fine, with any refinement ratios.
///
/// # Errors
/// No mesh at all, a mesh that is not finer than the one before, an error that is not finite, a band
/// that is not positive, a floor that is negative.
pub fn of_errors(errors: &[(f64, f64)], rule: Rule) -> Result<Verdict, Fault> {
    enough(errors, 1)?;
    descending(errors)?;
    let orders = pairwise(errors);
    let fit = |from: usize, to: usize| {
        let logarithms: Vec<_> =
            errors[from..to].iter().map(|p| (Number::ln(p.0), Number::ln(p.1.abs()))).collect();
        Some(Line::through(&logarithms).slope)
    };
    let signed: Vec<_> = errors.iter().map(|p| p.1).collect();
    Series { spacings: errors, signed, orders, meshes_more: 0, fit: &fit }.verdict(rule)
}

/// The verdict on (h, value) without an exact value, coarse to fine, with any refinement ratios.
///
/// The same rule, with differences of successive values for errors, the order of three meshes
/// ([`mod@super::richardson`]) for that of two, and the order of the best curve limit + C hᵖ for the
/// fitted one. A run takes four meshes.
///
/// # Errors
/// As [`of_errors`].
pub fn of_values(values: &[(f64, f64)], rule: Rule) -> Result<Verdict, Fault> {
    enough(values, 1)?;
    descending(values)?;
    let signed = values.windows(2).map(|pair| pair[1].1 - pair[0].1).collect();
    let orders =
        values.windows(3).map(|three| richardson::order(three).unwrap_or(f64::NAN)).collect();
    let fit = |from: usize, to: usize| best_order(&values[from..to], ORDERS).ok();
    Series { spacings: values, signed, orders, meshes_more: 1, fit: &fit }.verdict(rule)
}

#[cfg(test)]
mod tests;
