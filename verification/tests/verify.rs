//! `crossfibre verify`: the reports, the exit codes, and that they are functions of the record.

#![allow(clippy::unwrap_used)] // a test may

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use crossfibre_verification::golden::{FILES, embedded};
use crossfibre_verification::record::Record;
use crossfibre_verification::report;

fn verify(arguments: &[&str], folder: &Path) -> assert_cmd::assert::Assert {
    Command::cargo_bin("crossfibre")
        .unwrap()
        .arg("verify")
        .args(arguments)
        .current_dir(folder)
        .assert()
}

fn stdout(assert: &assert_cmd::assert::Assert) -> String {
    String::from_utf8(assert.get_output().stdout.clone()).unwrap()
}

#[test]
fn everything_passes_and_the_reports_are_functions_of_the_record() {
    let folder = tempfile::tempdir().unwrap();
    verify(&[], folder.path()).success();
    let reports = folder.path().join("target/verification");
    let read = |name: &str| fs::read_to_string(reports.join(name)).unwrap();
    let record = Record::read(&read("report.json")).unwrap();
    assert_eq!(record.json(), read("report.json"));
    for (name, text) in report::files(&record) {
        assert!(text == read(name), "{name}");
    }
    // The same by the command, twice, to the byte.
    for again in ["first", "second"] {
        let out = folder.path().join(again);
        Command::cargo_bin("crossfibre")
            .unwrap()
            .args(["report", "--from", "target/verification/report.json", "--out", again])
            .current_dir(folder.path())
            .assert()
            .success();
        for (name, _) in report::files(&record) {
            assert!(fs::read_to_string(out.join(name)).unwrap() == read(name), "{again} {name}");
        }
    }
    let page = read("report.html");
    assert!(page.len() < 3_000_000, "{}", page.len());

    // The kill matrix is of the quick checks of today, one by one: one that was added, renamed or moved
    // since has not been tried on the faults, or its column is another's.
    let quick_cases = record.cases.iter().filter(|case| case.quick);
    let today: Vec<_> = quick_cases
        .flat_map(|case| case.checks.iter().map(|of| (case.id.as_str(), of.check.claim.as_str())))
        .collect();
    let matrix = record.sensitivity.as_ref().unwrap();
    let quick_checks = matrix.checks.iter().filter(|check| check.quick);
    let kept: Vec<_> = quick_checks.map(|of| (of.case.as_str(), of.claim.as_str())).collect();
    if let Some(k) = (0..kept.len().max(today.len())).find(|&k| kept.get(k) != today.get(k)) {
        panic!(
            "docs/sensitivity is stale from check {k} on: it has {:?}, `verify` has {:?}; measure it again by \
             `crossfibre verify --sensitivity --quick --out docs/sensitivity`, read what has changed in its \
             README.md, and commit both",
            kept.get(k),
            today.get(k)
        );
    }

    // The checked-in report is that of today.
    let checked_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("../VALIDATION.md");
    assert!(
        fs::read_to_string(checked_in).unwrap() == read("VALIDATION.md"),
        "VALIDATION.md is stale: run `cargo run --release -- verify`, read the difference, and copy \
         target/verification/VALIDATION.md over it"
    );
}

#[test]
fn a_stale_report_is_told_by_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let stale = folder.path().join("stale.md");
    // The two lines with which every report of this version begins.
    let begins = format!("# Validation of crossfibre {}\n\n", env!("CARGO_PKG_VERSION"));
    fs::write(&stale, begins + "All is well.\n").unwrap();
    let assert = verify(&["--compare", "stale.md"], folder.path()).code(2);
    let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert!(message.contains("stale.md is stale from line 3 on"), "{message}");
}

/// Since all checks pass but those on the vectors themselves.
#[test]
fn a_vector_that_is_another_is_blessed_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in FILES.into_iter().zip(embedded()) {
        fs::write(folder.path().join(name), text.unwrap()).unwrap();
    }
    let runs = folder.path().join("runs.json");
    let right = fs::read_to_string(&runs).unwrap();
    let wrong = right.replacen("\"steps\":100", "\"steps\":101", 1);
    assert_ne!(wrong, right);
    fs::write(&runs, wrong).unwrap();
    let assert = Command::cargo_bin("crossfibre")
        .unwrap()
        .args(["vectors", "--dir", ".", "--bless", "--reason", "a step\ntoo many"])
        .current_dir(folder.path())
        .assert()
        .success();
    let text = stdout(&assert);
    assert!(text.ends_with("written: runs.json, HISTORY.md\n"), "{text}");
    let json = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    let blessed = json(&fs::read_to_string(&runs).unwrap());
    assert_eq!(blessed["vectors"], json(&right)["vectors"]);
    assert_eq!(blessed["provenance"]["reason"], "a step too many");
}

#[test]
fn a_filter_runs_the_cases_of_that_name_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(&verify(&["--filter", "identity"], folder.path()).success());
    let count = text.lines().filter(|line| line.starts_with("ok     identity.")).count();
    // An empty line and the tally stand below.
    assert_eq!(count + 2, text.lines().count(), "{text}");
    assert!(count >= 4);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_filter_that_names_no_case_is_bad_usage() {
    let folder = tempfile::tempdir().unwrap();
    let assert = verify(&["--filter", "smit.plateau"], folder.path()).code(1);
    let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert!(message.contains("no case has `smit.plateau` in its name"), "{message}");
}

#[test]
fn the_list_names_every_case() {
    let folder = tempfile::tempdir().unwrap();
    let text = stdout(&verify(&["--list"], folder.path()).success());
    for case in crossfibre_verification::cases::all() {
        assert!(text.contains(case.id), "{text}");
    }
}
