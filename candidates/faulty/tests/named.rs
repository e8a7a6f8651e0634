//! The comparison of traces names the equation of every fault, and says that its inputs are equal.

#![allow(clippy::unwrap_used)] // a test may

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use crossfibre::scene::Scene;
use crossfibre_faulty::answer::Change;
use crossfibre_faulty::traced::trace;
use crossfibre_verification::cases::support::shipped;
use crossfibre_verification::diff::record::{Kind, Record};
use crossfibre_verification::diff::{Comparison, Options, Tolerance};
use crossfibre_verification::faulty::catalogue::Wrong;
use crossfibre_verification::faulty::rewritten::Style;

/// Two different fibres that slide, so near to the impact and for so long that the kink passes the
/// crossover: every equation of a step has something to do.
fn scene() -> Scene {
    let mut scene = shipped("unequal");
    scene.primary.elements = 17;
    scene.duration *= 1.7;
    let secondary = scene.secondary.as_mut().unwrap();
    secondary.elements = 9;
    secondary.at = 0.019;
    secondary.slide_factor = 0.61;
    scene
}

fn written(folder: &Path, name: &str, change: Change) -> std::path::PathBuf {
    let path = folder.join(name);
    let events = trace(change, &scene(), BufWriter::new(File::create(&path).unwrap())).unwrap();
    assert!(events > 0, "{name}");
    path
}

fn compared(a: &Path, b: &Path, tolerance: Tolerance) -> Record {
    let options = Options { tolerance, ..Options::default() };
    let mut comparison = Comparison::open(a, b, options).unwrap();
    comparison.run().unwrap();
    comparison.record()
}

#[test]
fn the_first_difference_is_in_the_equation_that_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let reference = written(folder.path(), "reference", Change::Nothing);
    for &wrong in Wrong::ALL {
        let fault = wrong.fault();
        // No step evaluates these, and no element of this scene is folded.
        if matches!(fault.equation, 1 | 3 | 19 | 20) || wrong == Wrong::AngleQuadrant {
            continue;
        }
        let mine = written(folder.path(), "mine", Change::Wrong(wrong));
        let record = compared(&reference, &mine, Tolerance::default());
        let first = record.first_difference.as_ref().unwrap();
        assert_eq!(first.evaluation.eq, fault.equation.to_string(), "{}", record.verdict);
        assert_eq!(first.kind, Kind::Output, "{}", record.verdict);
        let sentence = format!("the fault is in ({})", fault.equation);
        assert!(record.verdict.contains(&sentence), "{}", record.verdict);
    }
}

#[test]
fn rewrites_agree_within_a_tolerance_and_not_to_the_bit() {
    let folder = tempfile::tempdir().unwrap();
    let reference = written(folder.path(), "reference", Change::Nothing);
    assert!(compared(&reference, &reference, Tolerance::default()).agree);
    for style in Style::ALL {
        let mine = written(folder.path(), "mine", Change::Rewritten(style));
        let record = compared(&reference, &mine, Tolerance::default());
        assert!(!record.agree && record.first_difference.unwrap().kind == Kind::Output);
        // Strains of 1e-2 are known to some 1e-14 of themselves after these steps, and just behind
        // the front they are smaller; tensions across the fibre are differences of larger numbers.
        let tolerance = Tolerance { relative: Some(1e-6), ulp: Some(1 << 40) };
        let near = compared(&reference, &mine, tolerance);
        let differing: u64 = near.equations.iter().map(|e| e.differing).sum();
        let all: u64 = near.equations.iter().map(|e| e.events).sum();
        assert!(differing * 50 < all, "{differing} of {all}: {}", near.verdict);
    }
}
