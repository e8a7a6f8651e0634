//! The study `cost`: what each part of a scene costs, by counts that do not depend on the clock.
//!
//! One scene is run again and again with one thing more. Evaluations of equations are counted by the
//! program itself; instructions by callgrind, as the difference between a run and one of twice as many
//! steps, so that reading, writing and starting fall out.

pub mod instructions;
mod page;
mod scenes;

use std::path::Path;

use anyhow::Result;
use crossfibre::scene::Scene;
use indicatif::ProgressIterator;

use crate::wide;
use instructions::{has_callgrind, instructions};
pub use page::page;
pub use scenes::{Variant, variants};

/// What a variant costs for each element of each step.
pub struct Cost {
    /// The variant.
    pub variant: Variant,
    /// Evaluations of each numbered equation.
    pub evaluations: Vec<(u8, f64)>,
    /// Machine instructions; none where callgrind is not there.
    pub instructions: Option<f64>,
}

/// Measures all variants. `program` is this command's own file.
pub fn costs(program: &Path) -> Result<Vec<Cost>> {
    let with_callgrind = has_callgrind();
    variants()
        .into_iter()
        .progress()
        .map(|variant| {
            let (once, twice) = (&variant.scene, &twice_as_long(&variant.scene));
            let [few, many] = [once, twice].map(|scene| wide::run(scene, |_| ()).counts);
            let element_steps = (many.element_steps - few.element_steps) as f64;
            let evaluations = many
                .equations
                .iter()
                .map(|(number, &many)| {
                    let few = few.equations.get(number).copied().unwrap_or(0);
                    (*number, (many - few) as f64 / element_steps)
                })
                .collect();
            let instructions = match with_callgrind {
                false => None,
                true => {
                    let count = |scene| instructions(program, variant.command, scene);
                    Some((count(twice)? - count(once)?) / element_steps)
                }
            };
            Ok(Cost { variant, evaluations, instructions })
        })
        .collect()
}

fn twice_as_long(scene: &Scene) -> Scene {
    Scene { duration: 2.0 * scene.duration, ..scene.clone() }
}
