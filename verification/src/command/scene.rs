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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn as_much_work_as_is_many_is_done_and_more_is_refused_with_its_hours() {
        let mut plan = Plan::of(&shipped("fig3"));
        plan.element_steps = MANY_ELEMENT_STEPS;
        refuse_if_long(&plan, "take less").unwrap();
        // 3.6 × 10¹¹ at 10⁸ a second.
        plan.element_steps = 3.6e11;
        let refused = refuse_if_long(&plan, "take less").unwrap_err().to_string();
        assert!(refused.ends_with("3.6e11 element-steps: about 1.0 hours\n  help: take less"));
    }
}
