//! The march compiled for the widest vectors that the machine has, chosen at run time.
//!
//! The source is [`crossfibre::march::run`] and nothing else. Every lane of a vector rounds as a
//! single number does, and the compiler neither fuses nor reorders, so the bits are the same; that
//! they are is tested (`tests/same_bits.rs`). Only the time differs: it is set by square roots and
//! divisions, and the vectors of the x86-64 baseline hold two doubles.
//!
//! All that the march calls within a step must be `#[inline(always)]`: a function compiled apart is
//! compiled for the baseline.

use crossfibre::march;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::{self, Marcher, RunResult};
use crossfibre::scene::Scene;
use crossfibre::state::State;
use multiversion::multiversion;

/// [`crossfibre::march::run`], with 512-bit or 256-bit vectors where there are any.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub fn march<S: Number, P: Paper<S>, W: FnMut(&State<S>)>(
    paper: &P,
    state: &mut State<S>,
    steps: u64,
    watch: W,
) -> Outcome {
    march::run(paper, state, steps, watch)
}

/// Marches by [`march()`].
#[derive(Clone, Copy, Debug)]
pub struct Wide;

impl Marcher for Wide {
    fn march<P: Paper<f64>>(
        &self,
        paper: &P,
        state: &mut State<f64>,
        steps: u64,
        watch: impl FnMut(&State<f64>),
    ) -> Outcome {
        march(paper, state, steps, watch)
    }
}

/// [`crossfibre::result::run`] by [`march()`]: the same result, sooner.
pub fn run(scene: &Scene, watch: impl FnMut(&State<f64>)) -> RunResult {
    result::run_with(&Wide, scene, watch)
}
