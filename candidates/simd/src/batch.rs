//! Many scenes on all cores.

use crossfibre::scene::Scene;
use rayon::prelude::*;

use crate::engine::Unsupported;
use crate::result::{SimdResult, run};

/// [`run`] of each scene, in their order: scenes have nothing to do with each other, and the bits
/// are those of one after the other.
pub fn batch(scenes: &[Scene]) -> Vec<Result<SimdResult, Unsupported>> {
    scenes.par_iter().map(run).collect()
}
