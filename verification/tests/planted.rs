//! What is planted stays for the whole process: a process of its own.

#![allow(clippy::unwrap_used)] // a test may

mod planted_support;

use crossfibre_verification::cases;
use crossfibre_verification::planted::{self, Refused};
use crossfibre_verification::sensitivity::stored::stored;
use planted_support::agrees_with_the_matrix;

/// (4) that adds its increment twice is not the law that Smith's relation is held against; a check of
/// the seams themselves, not of the tolerance.
#[test]
fn what_is_planted_fails_the_checks_and_stays() {
    let troubles = || {
        let plateau = cases::all().into_iter().find(|case| case.id == "smith.plateau").unwrap();
        let checks = (plateau.run)();
        checks.iter().filter(|check| check.verdict() != cases::Verdict::Passed).count()
    };
    assert_eq!((planted::now(), troubles()), (None, 0));
    planted::plant("4-twice").unwrap();
    assert!(troubles() > 0);
    assert_eq!(planted::plant("4-sign"), Err(Refused::Twice));
    assert_eq!(planted::now().unwrap().entry().id, "4-twice");
}

/// What is planted in each part of the program, and a quick case that notices it.
const NOTICED: [(&str, &str); 17] = [
    ("4-twice", "smith.plateau"),
    ("march-one-step-less", "smith.plateau"),
    ("march-flags-short", "by-hand.step"),
    ("march-clamp-at-rest", "invariance.galilean"),
    ("march-work-before", "courant.impact"),
    ("material-linear-whole", "smith.plateau"),
    ("material-viscoelastic-exact", "material.stiff"),
    ("material-unchecked", "extreme.scaling"),
    ("exact-density", "smith.density"),
    ("exact-growth-root", "courant.growth"),
    ("exact-motion-law", "motion.projectile"),
    ("exact-motion-one-arm", "motion.engineering"),
    ("exact-motion-slide-once", "motion.engineering"),
    ("exact-motion-density", "motion.engineering"),
    ("exact-motion-clamp", "motion.engineering"),
    ("record-lost", "record.stored"),
    ("rewrite-factored", "identity.free-sliding"),
];

#[test]
fn what_is_planted_in_any_part_is_noticed_by_the_checks_that_the_stored_matrix_names() {
    let matrix = stored();
    for (id, case) in NOTICED {
        let row = matrix.faults.iter().chain(&matrix.rewrites).find(|row| row.id == id).unwrap();
        // Its checks fail one by one.
        assert!(matrix.cases_noticing(row).contains(&case) && !row.stops(case), "{id}, {case}");
        agrees_with_the_matrix(row, case);
    }
}
