//! Machine instructions of a command, counted by callgrind.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result};
use crossfibre::scene::Scene;

use crate::interrupt::Scratch;

/// Whether there is anything to count with.
pub fn has_callgrind() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok_and(|o| o.status.success())
}

/// Instructions that a command takes with a scene, from start to end.
pub fn instructions(program: &Path, command: &[&str], scene: &Scene) -> Result<f64> {
    let folder = Scratch::new()?;
    let file = folder.path().join("scene.json");
    fs::write(&file, serde_json::to_vec(scene)?)?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(command)
        .arg(&file)
        .output()
        .context("valgrind cannot be started")?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected =
        said.split("Collected :").nth(1).and_then(|rest| rest.split_whitespace().next());
    collected
        .and_then(|number| number.parse().ok())
        .with_context(|| format!("callgrind gave no count for `{}`: {said}", scene.title))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    /// `true` reads no scene. A program that is linked, started and ended takes many thousands.
    #[test]
    fn instructions_are_counted_where_callgrind_is() {
        let counted = instructions(Path::new("true"), &[], &shipped("single-400"));
        assert_eq!(counted.is_ok(), has_callgrind(), "{counted:?}");
        assert!(counted.is_err() || counted.is_ok_and(|number| number > 1e3));
    }
}
