//! The candidates in other languages, built and judged; where a compiler or NumPy is missing, that is
//! said and nothing is judged.

#![cfg(unix)] // they are built by `make`
#![allow(clippy::unwrap_used)] // a test may

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use crossfibre::state::Wavefront;
use crossfibre_verification::cases::support::shipped;
use crossfibre_verification::conform::interview::conform;
use crossfibre_verification::conform::record::{Report, Verdict};
use crossfibre_verification::conform::session::Options;
use crossfibre_verification::timing::march;
use crossfibre_verification::timing::program::{self, build, single_fibre};

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

/// Builds a candidate, outside of its folder.
fn built(name: &str, program: &str) -> PathBuf {
    let into = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("candidate-{name}"));
    build(&candidates().join(name), &into, program).unwrap()
}

/// Programs that are timed march what the reference marches, with as much work where they visit all.
fn timed(command: impl Fn() -> Command, ahead: &[Wavefront]) {
    let scene = shipped("single-400");
    for &wavefront in ahead {
        let mut command = command();
        single_fibre(&mut command, &scene, wavefront, 2);
        let found = program::turn(&mut command).unwrap();
        let expected = march::turn::<f64>(&scene, wavefront, 1).unwrap();
        assert_eq!(
            (found.element_steps, found.checksum),
            (expected.element_steps, expected.checksum)
        );
        assert!(found.seconds > 0.0);
    }
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
        let march = built("c", "march");
        judged(&[march.clone().into(), "--conform".into()], true);
        timed(|| Command::new(&march), &[Wavefront::Flagged, Wavefront::Ignored]);
    }
}

#[test]
fn the_fortran_candidate_is_equal_to_the_bit() {
    if has("gfortran", &["--version"]) && has("make", &["--version"]) {
        let fibres = built("fortran", "fibres");
        judged(&[fibres.clone().into()], true);
        let time = || {
            let mut command = Command::new(&fibres);
            command.arg("--time");
            command
        };
        // It knows no wavefront.
        timed(time, &[Wavefront::Ignored]);
    }
}

/// Its inverse tangent of the printed (11) is the platform's: equal but for rounding.
#[test]
fn the_numpy_candidate_conforms() {
    if has("python3", &["-c", "import numpy"]) {
        judged(&["python3".into(), candidates().join("python/fibres.py").into()], false);
    }
}
