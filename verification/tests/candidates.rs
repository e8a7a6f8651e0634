//! The candidates in other languages, built and judged; where a compiler or NumPy is missing, that is
//! said and nothing is judged.

#![cfg(unix)] // they are built by `make`
#![allow(clippy::unwrap_used)] // a test may

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use crossfibre_verification::conform::interview::conform;
use crossfibre_verification::conform::record::{Report, Verdict};
use crossfibre_verification::conform::session::Options;

fn candidates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../candidates")
}

/// Whether a program runs, or the words for its absence.
fn has(program: &str, arguments: &[&str]) -> bool {
    let runs = Command::new(program).args(arguments).output().is_ok_and(|o| o.status.success());
    if !runs {
        eprintln!("skipped: {program} {} does not run here", arguments.join(" "));
    }
    runs
}

/// Builds a copy of a candidate, so that its folder stays as it is.
fn built(name: &str) -> PathBuf {
    let to = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("candidate-{name}"));
    std::fs::create_dir_all(&to).unwrap();
    for file in std::fs::read_dir(candidates().join(name)).unwrap() {
        let file = file.unwrap();
        if file.file_type().unwrap().is_file() {
            std::fs::copy(file.path(), to.join(file.file_name())).unwrap();
        }
    }
    let made = Command::new("make").arg("--always-make").current_dir(&to).output().unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    to
}

fn judged(command: &[OsString], exact: bool) -> Report {
    let options = Options {
        depths: vec![],
        filter: None,
        seed: 5,
        exact,
        single: false,
        timeout: Duration::from_secs(600),
    };
    let report = conform(command, &options, |_, _| ()).unwrap().0;
    let failures: Vec<_> = report.failures().map(|f| (&f.id, &f.reason)).collect();
    assert!(report.conforms, "{}: {failures:?}", report.candidate.name);
    // It was asked, and at every depth.
    assert_eq!(report.quantities.iter().filter(|row| row.quantity == "energy").count(), 1);
    assert!(report.count(Verdict::Bits) > 300);
    report
}

#[test]
fn the_c_candidate_is_equal_to_the_bit() {
    if has("gcc", &["--version"]) && has("make", &["--version"]) {
        judged(&[built("c").join("march").into(), "--conform".into()], true);
    }
}

#[test]
fn the_fortran_candidate_is_equal_to_the_bit() {
    if has("gfortran", &["--version"]) && has("make", &["--version"]) {
        judged(&[built("fortran").join("fibres").into()], true);
    }
}

/// Its inverse tangent of the printed (11) is the platform's: equal but for rounding.
#[test]
fn the_numpy_candidate_conforms() {
    if has("python3", &["-c", "import numpy"]) {
        judged(&["python3".into(), candidates().join("python/fibres.py").into()], false);
    }
}
