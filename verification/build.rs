//! Gives the program a digest of its own source: what it has computed and stored is taken again only
//! by the same program (`src/sweep`); and what it was built with, and from which commit, for reports.
//!
//! This runs again when the source has changed. The commit is that at which the source was last built:
//! later commits that leave the source alone make no other program.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[allow(dead_code)] // the digest is all that is needed here
#[path = "src/bits.rs"]
mod bits;

/// The library, this crate, and what they are built with.
const SOURCE: [&str; 3] = ["../src", "src", "../Cargo.lock"];

fn main() {
    let mut files = Vec::new();
    for place in SOURCE {
        println!("cargo::rerun-if-changed={place}");
        collect(Path::new(place), &mut files);
    }
    files.sort();
    let bytes = files.iter().flat_map(|file| {
        let name = file.to_string_lossy().into_owned().into_bytes();
        let text = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        name.into_iter().chain(text)
    });
    tell("SOURCE", &format!("{:016x}", bits::fnv(bytes)));
    if let Some(rustc) = std::env::var_os("RUSTC")
        && let Some(version) = said(Command::new(rustc).arg("--version"))
    {
        tell("COMPILER", &version);
    }
    for (name, of_cargo) in [("TARGET", "TARGET"), ("PROFILE", "PROFILE")] {
        if let Ok(value) = std::env::var(of_cargo) {
            tell(name, &value);
        }
    }
    if let Some(commit) = said(Command::new("git").args(["rev-parse", "HEAD"])) {
        tell("COMMIT", &commit);
        let status =
            Command::new("git").args(["status", "--porcelain", "--"]).args(SOURCE).output();
        if let Ok(status) = status.as_ref().map(|output| &output.stdout) {
            tell("MODIFIED", if status.is_empty() { "no" } else { "yes" });
        }
    }
}

/// Gives the program a value under a name.
fn tell(name: &str, value: &str) {
    println!("cargo::rustc-env=CROSSFIBRE_{name}={value}");
}

/// The line that a command prints; none if it cannot be run or fails.
fn said(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    let line = String::from_utf8_lossy(&output.stdout).lines().next()?.trim().to_owned();
    (!line.is_empty()).then_some(line)
}

/// A file, or the files of a folder and of those in it; none if there is no such thing.
fn collect(place: &Path, files: &mut Vec<PathBuf>) {
    if place.is_file() {
        files.push(place.into());
    }
    for entry in fs::read_dir(place).into_iter().flatten().flatten() {
        collect(&entry.path(), files);
    }
}
