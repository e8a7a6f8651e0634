//! The mathematics of convergence: what a ladder of meshes says about an error, and how surely.
//!
//! Pure functions on slices of (h, value), coarse to fine; h is the element's length or any other
//! measure of the mesh, in any unit. They know nothing of scenes. The theory is in
//! `docs/convergence.md`; read the files in this order:
//!
//! - [`mod@orders`]: the order between each two meshes, and the envelope of errors that change sign;
//! - [`mod@power_law`]: error = C hᵖ through all of them, with an interval of p;
//! - [`reach`]: the mesh on which a law comes to a wanted error;
//! - [`range`]: whether, and from which mesh on, there is such a law at all;
//! - [`mod@richardson`]: the limit of values without an exact one, from three meshes, and the grid
//!   convergence index;
//! - [`limit`]: the same from four meshes or more, by least squares.
//!
//! Logarithms and exponentials are those of the reference. Student's t comes from `statrs`, which
//! uses the platform's: an interval may differ in its last digits from machine to machine.

pub mod fault;
pub mod limit;
mod line;
pub mod orders;
pub mod power_law;
pub mod range;
pub mod reach;
pub mod richardson;
mod student;

pub use fault::Fault;
pub use limit::{Limit, fitted_limit};
pub use orders::{envelope, orders};
pub use power_law::{PowerLaw, power_law};
pub use range::{Reason, Rule, Run, Verdict, of_errors, of_values};
pub use reach::{Elements, Reach, Where};
pub use richardson::{Extrapolation, Richardson, Safety, Trend, richardson};

#[cfg(test)]
mod theory;

#[cfg(test)]
mod synthetic {
    //! Ladders of known order with scatter of known kind, for the tests.

    use crossfibre::number::Number;

    use crate::random::SplitMix;

    /// Spacings that have no constant ratio.
    pub const SPACINGS: [f64; 7] = [3.1, 2.03, 1.37, 0.81, 0.59, 0.33, 0.217];

    /// A normal deviate of unit variance (Box and Muller, 1958).
    pub fn normal(random: &mut SplitMix) -> f64 {
        let radius = (-2.0 * Number::ln(1.0 - random.between(0.0, 1.0))).sqrt();
        radius * Number::cos(std::f64::consts::TAU * random.between(0.0, 1.0))
    }

    /// hᵖ.
    pub fn power(h: f64, p: f64) -> f64 {
        Number::exp(p * Number::ln(h))
    }

    /// A function of h on spacings.
    pub fn ladder(spacings: &[f64], of: impl FnMut(f64) -> f64) -> Vec<(f64, f64)> {
        spacings.iter().copied().zip(spacings.iter().copied().map(of)).collect()
    }
}
