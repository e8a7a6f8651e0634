//! Reading the scene that a command is given, and refusing a run that is too long.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use crossfibre::plan::{MANY_ELEMENT_STEPS, Plan};
use crossfibre::scene::Scene;
use crossfibre::scene_file::{Fault, read_bytes};

/// The scene of a file, or of standard input for `-`.
pub fn read(path: &Path) -> Result<Scene> {
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("<stdin>")?;
        return read_bytes(&bytes).map_err(|fault| located("<stdin>", &fault));
    }
    let name = path.display().to_string();
    match fs::metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            bail!("{name}: there is no such file")
        }
        Ok(there) if there.is_dir() => bail!("{name}: is a directory, not a scene file"),
        _ => (),
    }
    let bytes = fs::read(path).with_context(|| name.clone())?;
    read_bytes(&bytes).map_err(|fault| located(&name, &fault))
}

/// `FILE:LINE:COLUMN: path: message`, and the help below.
fn located(file: &str, fault: &Fault) -> anyhow::Error {
    let Fault { path, line, column, message, help, .. } = fault;
    let path = if path.is_empty() { String::new() } else { format!("{path}: ") };
    let help = help.as_ref().map_or(String::new(), |help| format!("\n  help: {help}"));
    anyhow!("{file}:{line}:{column}: {path}{message}{help}")
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
