//! A turn of a program that measures itself and prints what came of it: a line of JSON with `seconds`,
//! `element_steps` and, in sixteen digits of a hexadecimal number, `checksum` ([`super::march::checksum`]).

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use crossfibre::scene::Scene;
use crossfibre::state::Wavefront;
use serde::Deserialize;

use super::march::steps;
use super::{Contestant, Turn};

#[derive(Deserialize)]
struct Line {
    seconds: f64,
    element_steps: u64,
    checksum: Option<String>,
}

/// Runs a program once.
///
/// # Errors
/// It cannot be started, it fails, or it prints something else.
pub fn turn(command: &mut Command) -> Result<Turn> {
    let output = command.output().with_context(|| format!("{command:?} cannot be started"))?;
    let said = String::from_utf8_lossy(if output.status.success() {
        &output.stdout
    } else {
        &output.stderr
    });
    ensure!(output.status.success(), "{command:?} fails: {}", said.trim());
    read(&said).with_context(|| format!("{command:?} prints {}", said.trim()))
}

/// What a program printed of itself.
///
/// # Errors
/// It is no such line.
pub fn read(text: &str) -> Result<Turn> {
    let Line { seconds, element_steps, checksum } = serde_json::from_str(text)?;
    let checksum = checksum.map(|digits| u64::from_str_radix(&digits, 16)).transpose()?;
    Ok(Turn { seconds, element_steps, checksum })
}

/// A program as a contestant.
pub fn contestant<'a>(name: impl Into<String>, mut command: Command) -> Contestant<'a> {
    Contestant::new(name, move || turn(&mut command))
}

/// The march of a single fibre by `candidates/c/march` or, with `--time` before all this, by
/// `candidates/fortran/fibres`. The programs know no other law than (7).
pub fn single_fibre(command: &mut Command, scene: &Scene, wavefront: Wavefront, repeats: u32) {
    let fibre = &scene.primary;
    for (name, value) in [
        ("--length", fibre.length),
        ("--density", fibre.density),
        ("--area", fibre.area),
        ("--modulus", fibre.material.instantaneous_modulus()),
        ("--velocity", scene.projectile.velocity),
        ("--courant", scene.courant),
        ("--elements", fibre.elements as f64),
        ("--steps", steps(scene) as f64),
        ("--repeat", f64::from(repeats)),
    ] {
        command.arg(name).arg(value.to_string());
    }
    command.args((wavefront == Wavefront::Ignored).then_some("--all"));
}

/// Builds a program of `source` into another folder by its own Makefile.
///
/// # Errors
/// There is no `make` or no compiler, or it does not build.
pub fn build(source: &Path, into: &Path, program: &str) -> Result<PathBuf> {
    std::fs::create_dir_all(into).with_context(|| format!("{}", into.display()))?;
    let made = Command::new("make")
        .args(["--always-make".as_ref(), "--directory".as_ref(), into.as_os_str()])
        .args(["--file".as_ref(), source.join("Makefile").as_os_str()])
        .args([format!("VPATH={}", source.display()), program.to_owned()])
        .output()
        .context("make cannot be started")?;
    if !made.status.success() {
        bail!("{program} does not build: {}", String::from_utf8_lossy(&made.stderr).trim());
    }
    Ok(into.join(program))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn a_line_is_a_turn() {
        let line =
            r#"{"steps":7,"element_steps":370,"seconds":0.031,"checksum":"00f17ac3d9b1e2c4"}"#;
        let expected =
            Turn { seconds: 0.031, element_steps: 370, checksum: Some(0x00f1_7ac3_d9b1_e2c4) };
        assert_eq!(read(line).unwrap(), expected);
        let without = read(r#"{"element_steps":370,"seconds":0.031}"#).unwrap();
        assert_eq!(without, Turn { checksum: None, ..expected });
        for wrong in ["", "{}", r#"{"element_steps":370,"seconds":0.031,"checksum":"xyz"}"#] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_program_that_is_not_there_is_named() {
        let missing = turn(&mut Command::new("no-such-program-of-crossfibre")).unwrap_err();
        assert!(missing.to_string().contains("no-such-program-of-crossfibre"), "{missing}");
    }

    #[test]
    #[cfg(unix)]
    fn a_program_is_built_beside_its_source_or_it_is_said_why_not() {
        if Command::new("make").arg("--version").output().is_err() {
            return; // nothing to build with
        }
        let [source, elsewhere] = [(); 2].map(|()| tempfile::tempdir().unwrap());
        std::fs::write(source.path().join("part"), "a part").unwrap();
        let rules = "march: part\n\tcp $< $@\nbroken:\n\t@echo no such thing >&2; false\n";
        std::fs::write(source.path().join("Makefile"), rules).unwrap();
        let into = elsewhere.path().join("new");
        let built = build(source.path(), &into, "march").unwrap();
        assert_eq!(built, into.join("march"));
        assert_eq!(std::fs::read_to_string(built).unwrap(), "a part");
        let error = build(source.path(), &into, "broken").unwrap_err().to_string();
        assert!(error.starts_with("broken does not build: no such thing"), "{error}");
    }

    #[test]
    fn the_arguments_read_back_to_the_numbers_of_the_scene() {
        let scene = shipped("single-400");
        let mut command = Command::new("march");
        single_fibre(&mut command, &scene, Wavefront::Ignored, 3);
        let said: Vec<_> = command.get_args().map(|arg| arg.to_str().unwrap()).collect();
        let value = |name: &str| {
            let at = said.iter().position(|&arg| arg == name).unwrap();
            said[at + 1].parse::<f64>().unwrap()
        };
        // A shortest decimal reads back to the same bits.
        assert_eq!(value("--modulus"), 58.6e9);
        assert_eq!(value("--density"), scene.primary.density);
        assert_eq!(value("--steps"), 100.0);
        assert_eq!(value("--repeat"), 3.0);
        assert_eq!(said.last(), Some(&"--all"));
    }
}
