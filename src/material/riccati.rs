//! y′ = b − a sinh y over one unit of time, in closed form: an Eyring arm at a constant strain rate.
//!
//! With w = exp(y) it is the Riccati equation w′ = bw − (a/2)(w² − 1), and w = P/R turns that into
//! P′ = (bP + aR)/2, R′ = (aP − bR)/2. The eigenvalues are ±ρ/2 with ρ² = a² + b², so with α = a/ρ,
//! β = b/ρ, Q = exp(−ρ), m = 1 − Q and u = exp(−y₀)
//!
//! ```text
//! exp(y₁) = N/D,   N = (1 + β) + Q(1 − β) + uαm,   D = αm + u[(1 − β) + Q(1 + β)],
//! N − D = (1 − u)[(1 − α) + Q(1 + α)] + (1 + u)βm.
//! ```
//!
//! For y₀ ≥ 0 no term but those of N − D can be negative, and there only for b < 0, where y may
//! change its sign. So y₁ has the digits that y₀ + b has.

use super::decay::{decay, exp_m1_less_itself};
use crate::number::Number;

/// One unit of time from y₀ ≥ 0.
struct Unit<S> {
    alpha: S,
    beta: S,
    rho: S,
    /// Q and m.
    left: S,
    gone: S,
    /// u and 1 − u.
    start: S,
    start_gone: S,
}

impl<S: Number> Unit<S> {
    /// `None` if nothing happens, a = b = 0.
    #[inline]
    fn new(start: S, a: S, b: S) -> Option<Self> {
        let (large, small) = if a > b.abs() { (a, b.abs()) } else { (b.abs(), a) };
        if large == S::zero() {
            return None;
        }
        let ratio = small / large;
        let rho = large * (S::one() + ratio * ratio).sqrt();
        let (left, gone) = decay(rho);
        let (start, start_gone) = decay(start);
        Some(Self { alpha: a / rho, beta: b / rho, rho, left, gone, start, start_gone })
    }

    /// (1 − c) + Q(1 + c) for c = ±α or ±β, where `other` is the one that makes c² + other² = 1.
    #[inline]
    fn blend(&self, c: S, other: S) -> S {
        let one = S::one();
        let less = if c > S::zero() { other * other / (one + c) } else { one - c };
        let more = if c < S::zero() { other * other / (one - c) } else { one + c };
        less + self.left * more
    }

    #[inline]
    fn numerator(&self) -> S {
        self.blend(-self.beta, self.alpha) + self.start * self.alpha * self.gone
    }

    #[inline]
    fn denominator(&self) -> S {
        self.alpha * self.gone + self.start * self.blend(self.beta, self.alpha)
    }

    /// y₁ = ln(N/D).
    ///
    /// Next to N = D the logarithm needs N − D. Its two terms above are those of a small y₀ and a
    /// small drive; where they cancel to less than N itself, the difference as it stands is better.
    #[inline]
    fn end(&self) -> S {
        let (numerator, denominator) = (self.numerator(), self.denominator());
        let near = numerator < S::two() * denominator && denominator < S::two() * numerator;
        if !near {
            return (numerator / denominator).ln();
        }
        let start = self.start_gone * self.blend(self.alpha, self.beta);
        let drive = (S::one() + self.start) * self.beta * self.gone;
        let difference = if start < numerator { start + drive } else { numerator - denominator };
        if difference >= S::zero() {
            (difference / denominator).ln_1p()
        } else {
            -(-difference / numerator).ln_1p()
        }
    }

    /// dy₁/db, in which m/ρ − Q = Q(exp(ρ) − 1 − ρ)/ρ.
    fn slope(&self) -> S {
        let Self { alpha, beta, rho, left, gone, start, .. } = *self;
        let one = S::one();
        let bend = alpha * alpha * gone / rho;
        let late = if rho < one { left * exp_m1_less_itself(rho) / rho } else { gone / rho - left };
        let cross = alpha * beta * late;
        let numerator = bend - beta * left * (one - beta) - start * cross;
        let denominator = -cross - start * (bend + beta * left * (one + beta));
        numerator / self.numerator() - denominator / self.denominator()
    }
}

/// y after a unit of time, for a ≥ 0.
///
/// Where exp(−|y|) and a/ρ are both below the smallest number, so that ρ > 2, what is above steady
/// flow, ln(2ρ/a), is taken to come down to it at once, and below it nothing flows. Next to steady
/// flow as much flows as would be elastic, so that y₁ is off by ln 2.
#[inline]
pub(super) fn advance<S: Number>(y: S, a: S, b: S) -> S {
    if y < S::zero() {
        return -advance_up(-y, a, -b);
    }
    advance_up(y, a, b)
}

#[inline]
fn advance_up<S: Number>(y: S, a: S, b: S) -> S {
    let Some(unit) = Unit::new(y, a, b) else { return y };
    let end = unit.end();
    if end.is_finite() { end } else { without_flow(y, a, b, unit.rho) }
}

#[cold]
fn without_flow<S: Number>(y: S, a: S, b: S, rho: S) -> S {
    let steady = (rho + rho).ln() - a.ln();
    let elastic = if y > steady { steady + b } else { y + b };
    if elastic > steady { steady } else { elastic.max(-steady) }
}

/// dy₁/db of [`advance`].
pub(super) fn slope<S: Number>(y: S, a: S, b: S) -> S {
    let unit = if y < S::zero() { Unit::new(-y, a, -b) } else { Unit::new(y, a, b) };
    unit.map_or(S::one(), |unit| unit.slope())
}

/// sinh y, to a few units in its last place.
#[inline]
pub(super) fn sinh<S: Number>(y: S) -> S {
    let (left, gone) = decay(y.abs());
    let size = gone * (S::one() + left) / (left + left);
    if y < S::zero() { -size } else { size }
}

#[cfg(test)]
mod tests;
