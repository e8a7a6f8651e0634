//! `crossfibre verify` as people and programs use it: the list, parts of the cases, JSON alone.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::process::Command;

use assert_cmd::cargo::cargo_bin;
use cli_support::crossfibre;
use crossfibre_verification::cases::{all, full};
use serde_json::Value;

/// A case of a second, and another.
const PART: [&str; 5] = ["verify", "--filter", "identity.both", "--filter", "momentum."];

#[test]
fn filters_add_up_and_the_lines_come_in_the_order_of_the_list() {
    let folder = tempfile::tempdir().unwrap();
    let ended = crossfibre(folder.path(), &PART);
    let names: Vec<_> = ended
        .stdout
        .lines()
        .filter_map(|line| line.strip_prefix("ok     ")?.split(' ').next())
        .collect();
    assert_eq!(names, ["momentum.fig3", "identity.both-at-origin"], "{}", ended.stdout);
    assert!(ended.stdout.ends_with("passed, 0 failed, in 2 cases\n"), "{}", ended.stdout);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "a bar where there is no terminal");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "a part has no reports");
}

#[test]
fn a_part_has_reports_where_a_folder_is_named_but_no_validation() {
    let folder = tempfile::tempdir().unwrap();
    crossfibre(folder.path(), &["verify", "--filter", "identity.both", "--out", "reports"]);
    let mut files: Vec<_> = fs::read_dir(folder.path().join("reports"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    assert_eq!(files, ["junit.xml", "report.html", "report.json", "sensitivity.md", "summary.md"]);
    // Every case but the one that was run is named as left out.
    let report = fs::read_to_string(folder.path().join("reports/report.json")).unwrap();
    let report: Value = serde_json::from_str(&report).unwrap();
    let left_out: Vec<_> = report["left_out"].as_array().unwrap().iter().collect();
    let others = all().into_iter().filter(|case| case.id != "identity.both-at-origin");
    assert_eq!(left_out, others.map(|case| case.id).collect::<Vec<_>>());
}

#[test]
fn json_is_all_that_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let ended = crossfibre(folder.path(), &[&PART[..], &["--json"]].concat());
    let records: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(records[1]["id"], "identity.both-at-origin");
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
}

#[test]
fn the_list_has_every_case_and_quick_is_most_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let list =
        |more: &[&str]| crossfibre(folder.path(), &[&["verify", "--list"], more].concat()).stdout;
    let names = |text: String| -> Vec<String> {
        text.lines().map(|line| line.split(' ').next().unwrap().into()).collect()
    };
    assert_eq!(names(list(&[])), all().iter().map(|case| case.id).collect::<Vec<_>>());
    assert_eq!(names(list(&["--full"])), full().iter().map(|case| case.id).collect::<Vec<_>>());
    let quick: Vec<_> = all().into_iter().filter(|case| case.is_quick()).collect();
    assert_eq!(names(list(&["--quick"])), quick.iter().map(|case| case.id).collect::<Vec<_>>());
    assert!(list(&[]).contains("smith.plateau              quick   5  "), "{}", list(&[]));
    let listed: Value = serde_json::from_str(&list(&["--json", "--filter", "golden"])).unwrap();
    assert_eq!((&listed[0]["id"], &listed[0]["quick"]), (&"golden.vectors".into(), &true.into()));
}

#[test]
fn colours_are_for_terminals_and_for_those_who_ask_for_them() {
    let run = |variables: &[(&str, &str)], arguments: &[&str]| {
        let mut command = Command::new(cargo_bin!("crossfibre"));
        command.args(arguments).env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
        let output = command.envs(variables.iter().copied()).output().unwrap();
        [output.stdout, output.stderr].map(|bytes| bytes.contains(&0x1B))
    };
    let part = ["verify", "--filter", "identity.both"];
    assert_eq!(run(&[], &part), [false, false]);
    assert_eq!(run(&[("CLICOLOR_FORCE", "1")], &part), [true, false]);
    assert_eq!(run(&[("CLICOLOR_FORCE", "0"), ("NO_COLOR", "1")], &part), [false, false]);
    let bad = ["run", "nowhere.json"];
    assert_eq!(run(&[("CLICOLOR_FORCE", "1")], &bad), [false, true]);
    assert_eq!(run(&[], &bad), [false, false]);
}

#[test]
fn what_reports_cannot_be_written_to_or_compared_with_is_told_before_the_checks() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "mine").unwrap();
    for (arguments, part) in [
        (&["--filter", "identity.both", "--out", "file"][..], "file: cannot be made a folder: "),
        (&["--compare", "none.md", "--out", "out"], "none.md: there is no such file"),
    ] {
        let ended = crossfibre(folder.path(), &[&["verify"], arguments].concat());
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""));
        assert!(ended.stderr.starts_with(&format!("error: {part}")), "{}", ended.stderr);
    }
}

#[test]
fn what_contradicts_itself_is_bad_usage() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, part) in [
        (
            &["--filter", "golden", "--filter", "smiht"][..],
            "no case has `smiht` in its name, did you mean `smith`?",
        ),
        (&["--quick", "--filter", "precision.gci"], "none of these cases is quick"),
        (&["--quick", "--full"], "cannot be used with"),
        (&["--quick", "--compare", "a.md"], "cannot be used with"),
    ] {
        let ended = crossfibre(folder.path(), &[&["verify"], arguments].concat());
        assert_eq!(ended.code, 1);
        assert!(ended.stderr.contains(part), "{}", ended.stderr);
    }
}
