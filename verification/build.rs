//! Gives the program a digest of its own source: what it has computed and stored is taken again only
//! by the same program (`src/sweep`); and the compiler's name, which times are reported with.

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
    println!("cargo::rustc-env=CROSSFIBRE_SOURCE={:016x}", bits::fnv(bytes));
    if let Some(rustc) = std::env::var_os("RUSTC")
        && let Ok(version) = Command::new(rustc).arg("--version").output()
    {
        let version = String::from_utf8_lossy(&version.stdout);
        println!("cargo::rustc-env=CROSSFIBRE_COMPILER={}", version.trim());
    }
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
