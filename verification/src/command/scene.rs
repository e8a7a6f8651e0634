//! Reading the scene that a command is given, and refusing a run that is too long.

use std::path::Path;

use anyhow::{Result, bail};
use crossfibre::plan::{MANY_ELEMENT_STEPS, Plan};
use crossfibre::scene::Scene;
use crossfibre::scene_file::read_bytes;

use super::diagnostic::BadScene;
use crate::input;

/// The scene of a file, or of standard input for `-`.
pub fn read(path: &Path) -> Result<Scene> {
    let (file, bytes) = input::bytes(path)?;
    read_bytes(&bytes).map_err(|fault| {
        let text = String::from_utf8_lossy(&bytes).into_owned();
        BadScene { file, text, fault }.into()
    })
}

/// An error if the plan is for more work than anyone asks for by accident.
pub fn refuse_if_long(plan: &Plan, instead: &str) -> Result<()> {
    if plan.element_steps <= MANY_ELEMENT_STEPS {
        return Ok(());
    }
    // What an ordinary machine does, element-steps per second.
    let hours = plan.element_steps / 1e8 / 3600.0;
    bail!(
        "this is a run of {} steps and {:.1e} element-steps: about {hours:.1} hours\n  help: {instead}",
        plan.steps,
        plan.element_steps,
    )
}
