//! Arrays of four doubles and the operators of the language: any processor.

use super::{Lanes, Work};
use crate::division::LEAST_LENGTH;

/// Everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

type V = [f64; 4];

#[inline(always)]
fn each(x: V, y: V, f: impl Fn(f64, f64) -> f64) -> V {
    [f(x[0], y[0]), f(x[1], y[1]), f(x[2], y[2]), f(x[3], y[3])]
}

impl Lanes for Portable {
    const COUNT: usize = 4;
    type V = V;
    type Array = V;

    fn compile(self, work: impl Work<Self>) {
        work.run(self);
    }
    #[inline(always)]
    fn splat(self, x: f64) -> V {
        [x; 4]
    }
    #[inline(always)]
    fn vector(self, x: V) -> V {
        x
    }
    #[inline(always)]
    fn array(self, x: V) -> V {
        x
    }
    #[inline(always)]
    fn add(self, x: V, y: V) -> V {
        each(x, y, |x, y| x + y)
    }
    #[inline(always)]
    fn sub(self, x: V, y: V) -> V {
        each(x, y, |x, y| x - y)
    }
    #[inline(always)]
    fn mul(self, x: V, y: V) -> V {
        each(x, y, |x, y| x * y)
    }
    #[inline(always)]
    fn root(self, x: V) -> V {
        [x[0].sqrt(), x[1].sqrt(), x[2].sqrt(), x[3].sqrt()]
    }
    /// Nothing: it divides by the divisor itself.
    #[inline(always)]
    fn reciprocal(self, x: V) -> V {
        x
    }
    #[inline(always)]
    fn divide(self, x: V, y: V, _: V) -> V {
        each(x, y, |x, y| x / y)
    }
    #[inline(always)]
    fn one_before(self, before: V, here: V) -> V {
        [before[3], here[0], here[1], here[2]]
    }
    #[inline(always)]
    fn one_ahead(self, here: V, after: V) -> V {
        [here[1], here[2], here[3], after[0]]
    }
    #[inline(always)]
    fn is_ordinary(self, length: V, strain: V, most_strain: V) -> bool {
        (0..4).all(|i| length[i] >= LEAST_LENGTH && strain[i] < most_strain[i])
    }
    #[inline(always)]
    fn any_at_most(self, x: V, y: V) -> bool {
        x.iter().zip(y).any(|(&x, y)| x <= y)
    }
}
