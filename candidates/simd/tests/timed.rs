//! The engine's program, timed: what it marches is what the reference marches.

#![allow(clippy::unwrap_used)] // a test may

use std::path::{Path, PathBuf};
use std::process::Command;

use crossfibre::scene_file;
use crossfibre::state::Wavefront;
use crossfibre_verification::timing::{march, program};

fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../verification/scenes/{name}.json"))
}

fn timing(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_crossfibre-simd"));
    command.arg("--time").args(arguments);
    command
}

#[test]
fn a_timed_march_ends_in_the_bits_of_the_reference() {
    for name in ["single-400", "fig3", "unequal", "both-at-origin"] {
        let file = scene(name);
        let text = std::fs::read_to_string(&file).unwrap();
        let scene = scene_file::read(&text).unwrap();
        let expected = [Wavefront::Flagged, Wavefront::Ignored]
            .map(|w| march::turn::<f64>(&scene, w, 1).unwrap());
        for vectors in [&[][..], &["--vectors", "portable"]] {
            for (ahead, expected) in [&[][..], &["--all"]].into_iter().zip(expected) {
                let path = file.to_str().unwrap();
                let arguments = [&[path, "--repeat", "2"], vectors, ahead].concat();
                let found = program::turn(&mut timing(&arguments)).unwrap();
                assert_eq!(found.checksum, expected.checksum, "{arguments:?}");
                assert_eq!(found.element_steps, expected.element_steps, "{arguments:?}");
            }
        }
    }
}

#[test]
fn what_cannot_be_timed_is_said() {
    let hardening = scene("hardening");
    for (arguments, reason) in [
        (vec![], "lacks the file"),
        (vec!["no-such-scene.json"], "no-such-scene.json"),
        (vec![hardening.to_str().unwrap()], "eqn (7) only"),
        (vec!["-", "--repeat"], "--repeat lacks a number"),
        (vec!["-", "--repeat", "x"], "--repeat x"),
        (vec!["-", "--vectors", "square"], "avx512, avx2 or portable"),
        (vec!["-", "--fast"], "does not know --fast"),
    ] {
        let error = program::turn(&mut timing(&arguments)).unwrap_err().to_string();
        assert!(error.contains(reason), "{arguments:?}: {error}");
    }
}
