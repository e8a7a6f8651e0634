//! What the march asks of a processor's vectors, and the three answers.
//!
//! Every operation of a lane is one of IEEE 754, correctly rounded: `+ − × ÷ √`. How an
//! implementation comes to a quotient or a root is its own affair ([`crate::division`]); its bits are
//! not.

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)] // the intrinsics
mod avx2;
#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)] // the intrinsics
mod avx512;
mod portable;

#[cfg(target_arch = "x86_64")]
pub use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub use avx512::Avx512;
pub use portable::Portable;

/// Work to be compiled for an implementation's instructions.
///
/// `run` and all that it calls must be `#[inline(always)]`.
pub trait Work<L> {
    /// Does it.
    fn run(self, lanes: L);
}

/// Vectors of doubles. A value of an implementation is the proof that the processor has them.
pub trait Lanes: Copy + Send + Sync + 'static {
    /// How many doubles a vector holds.
    const COUNT: usize;
    /// How many blocks of a fibre, nine vectors each, stay in the first-level cache: 18 KiB.
    const PIECE: usize = 320 / Self::COUNT;
    /// A vector.
    type V: Copy + Send + Sync;
    /// Its doubles.
    type Array: Copy + AsRef<[f64]> + AsMut<[f64]>;

    /// Does the work with the implementation's instructions.
    fn compile(self, work: impl Work<Self>);

    /// The same double in all lanes.
    fn splat(self, x: f64) -> Self::V;
    /// A vector of an array.
    fn vector(self, x: Self::Array) -> Self::V;
    /// The array of a vector.
    fn array(self, x: Self::V) -> Self::Array;
    /// `x + y`
    fn add(self, x: Self::V, y: Self::V) -> Self::V;
    /// `x − y`
    fn sub(self, x: Self::V, y: Self::V) -> Self::V;
    /// `x × y`
    fn mul(self, x: Self::V, y: Self::V) -> Self::V;
    /// `√x`
    fn root(self, x: Self::V) -> Self::V;
    /// What [`Lanes::divide`] wants to know of a divisor.
    fn reciprocal(self, x: Self::V) -> Self::V;
    /// `x ÷ y`, `reciprocal` being that of `y`, within the range that [`crate::division`] asks for.
    fn divide(self, x: Self::V, y: Self::V, reciprocal: Self::V) -> Self::V;
    /// The lanes moved up by one: the last of `before`, then all but the last of `here`.
    fn one_before(self, before: Self::V, here: Self::V) -> Self::V;
    /// The lanes moved down by one: all but the first of `here`, then the first of `after`.
    fn one_ahead(self, here: Self::V, after: Self::V) -> Self::V;
    /// Whether in all lanes a length is at least [`crate::division::LEAST_LENGTH`] and a strain less
    /// than a bound. Not with what is not a number.
    fn is_ordinary(self, length: Self::V, strain: Self::V, most_strain: Self::V) -> bool;
    /// Whether a lane of `x` is `y` or less.
    fn any_at_most(self, x: Self::V, y: Self::V) -> bool;
}
