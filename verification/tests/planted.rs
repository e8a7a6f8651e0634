//! What is planted stays for the whole process: a process of its own.

#![allow(clippy::unwrap_used)] // a test may

use crossfibre_verification::cases;
use crossfibre_verification::planted::{self, Refused};

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
