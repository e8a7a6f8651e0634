//! `crossfibre verify --sensitivity`: every fault in a process of its own, and the matrix that is stored.

#![allow(clippy::unwrap_used)] // a test may

use std::collections::BTreeSet;
use std::fs;
use std::panic;
use std::path::Path;
use std::sync::Mutex;

use assert_cmd::Command;
use crossfibre_verification::cases::{self, Bound, Case, Check};
use crossfibre_verification::planted;
use crossfibre_verification::sensitivity::matrix::{Matrix, Row};
use crossfibre_verification::sensitivity::one::tell;
use crossfibre_verification::sensitivity::page::page;
use crossfibre_verification::sensitivity::{judge::judge, stored::stored};

fn verify(arguments: &[&str], folder: &Path) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("crossfibre").unwrap();
    command.arg("verify").args(arguments).current_dir(folder).assert()
}

/// A case that holds momentum against impulses notices a node that is pushed twice, and not what is wrong in
/// an exact solution that it does not ask for.
#[test]
fn the_matrix_of_one_case_has_every_fault_and_those_that_it_misses_fail_it() {
    let folder = tempfile::tempdir().unwrap();
    let assert = verify(&["--sensitivity", "--filter", "momentum.fig3"], folder.path()).code(2);
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert!(text.contains("no check notices `exact-"), "{text}");

    let stored = folder.path().join("target/sensitivity");
    let matrix: Matrix =
        serde_json::from_str(&fs::read_to_string(stored.join("matrix.json")).unwrap()).unwrap();
    assert_eq!(fs::read_to_string(stored.join("README.md")).unwrap(), page(&matrix));
    let planted: Vec<_> = planted::all().iter().map(|fault| fault.id).collect();
    assert_eq!(ids(&matrix.faults), planted);
    assert!(matrix.checks.iter().all(|check| check.case == "momentum.fig3"));
    let noticing = |row| matrix.noticing(row).count();
    let noticed = |id: &str| noticing(matrix.faults.iter().find(|row| row.id == id).unwrap());
    assert!(noticed("2-twice") > 0);
    assert_eq!(noticed("exact-density"), 0);
    assert!(matrix.rewrites.iter().all(|row| noticing(row) == 0), "{:?}", matrix.rewrites);
}

#[test]
fn a_fault_that_is_not_in_the_catalogue_is_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let assert = verify(&["--plant", "2-twise"], folder.path()).code(1);
    let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert!(message.contains("did you mean `2-twice`?"), "{message}");
}

fn ids(rows: &[Row]) -> Vec<&str> {
    rows.iter().map(|row| row.id.as_str()).collect()
}

/// Checks with a bound of 2: one that keeps to it, one at eight times it, one twenty times below it, and one
/// that is farther above; and one that is no error.
fn made_up() -> Vec<Check> {
    let check = |claim: &str, measured, bound| {
        let [oracle, norm, reason] = [(); 3].map(|()| String::new());
        Check { claim: claim.into(), oracle, norm, measured, bound, reason }
    };
    vec![
        check("kept", 1.9, Bound::AtMost(2.0)),
        check("at eight times the bound", 16.0, Bound::AtMost(2.0)),
        check("loose", 0.1, Bound::AtMost(2.0)),
        check("loose in a window", 0.1, Bound::Within(0.0, 1.0)),
        check("beyond", 16.1, Bound::AtMost(2.0)),
        check("less than it must be", 0.7, Bound::AtLeast(2.0)),
    ]
}

/// Other words have other errors of rounding, so what is planted here is equal in algebra. It stays for the
/// whole process, whose other tests march and solve nothing.
#[test]
fn where_words_are_others_an_error_may_be_eight_times_the_bound() {
    let told = || {
        let said = Mutex::new(Vec::new());
        let case = Case { id: "made-up", title: "", equations: &[], run: made_up };
        tell(&[case], |case| said.lock().unwrap().extend(case.checks.clone()));
        drop(panic::take_hook());
        said.into_inner().unwrap().into_iter().map(|(_, stands)| stands).collect::<Vec<_>>()
    };
    assert_eq!(told(), [true, false, false, false, false, false]);
    planted::plant("rewrite-factored").unwrap();
    assert_eq!(told(), [true, true, true, true, false, false]);
    // What is as printed is not rewritten: it has the energy that the page gives it.
    let printed = cases::all().into_iter().find(|case| case.id == "energy.printed").unwrap();
    let checks = (printed.run)();
    assert!(checks.iter().all(|check| check.verdict() == cases::Verdict::Passed), "{checks:?}");
}

/// Measured by `verify --sensitivity --quick --out docs/sensitivity`; whoever adds a fault or a case measures
/// it again.
#[test]
fn the_stored_matrix_has_the_faults_and_the_cases_of_today_and_no_gap() {
    let matrix = stored();
    assert_eq!(ids(&matrix.faults), planted::all().iter().map(|f| f.id).collect::<Vec<_>>());
    assert_eq!(ids(&matrix.rewrites), planted::rewrites().iter().map(|f| f.id).collect::<Vec<_>>());
    let all = cases::all();
    let quick: BTreeSet<_> =
        all.iter().filter(|case| case.is_quick()).map(|case| case.id).collect();
    let asked: BTreeSet<_> = matrix.checks.iter().map(|check| check.case.as_str()).collect();
    assert!(quick.is_subset(&asked), "{:?}", quick.difference(&asked));
    assert_eq!(judge(matrix).lines(), Vec::<String>::new());
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/sensitivity/README.md");
    assert_eq!(
        fs::read_to_string(kept).unwrap(),
        page(matrix),
        "docs/sensitivity/README.md is stale"
    );
}
