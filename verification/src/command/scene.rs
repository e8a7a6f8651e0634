//! Reading the scene that a command is given, and refusing a run that is too long.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use anyhow::{Context, Result, bail};
use crossfibre::plan::{MANY_ELEMENT_STEPS, Plan};
use crossfibre::scene::Scene;
use crossfibre::scene_file::read_bytes;

use super::diagnostic::BadScene;

/// The scene of a file, or of standard input for `-`.
pub fn read(path: &Path) -> Result<Scene> {
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("<stdin>")?;
        return of_bytes("<stdin>", &bytes);
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
    of_bytes(&name, &bytes)
}

/// The scene in the bytes of a file of this name.
fn of_bytes(file: &str, bytes: &[u8]) -> Result<Scene> {
    read_bytes(bytes).map_err(|fault| {
        let text = String::from_utf8_lossy(bytes).into_owned();
        BadScene { file: file.into(), text, fault }.into()
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
