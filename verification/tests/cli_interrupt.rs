//! An interrupt: code 130, no half-written file, no temporary file, and what was there is as it was.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use assert_cmd::cargo::cargo_bin;
use cli_support::scenes;
use crossfibre_verification::precision::stored::stored;
use crossfibre_verification::precision::{QUICK, STUDY, points};
use crossfibre_verification::sweep::folder::Folder;
use rustix::process::{Pid, Signal, kill_process};

/// The command in a folder. Where the tests themselves run with interrupts ignored, as behind `&` in a
/// script, it would inherit that: env sets them right and becomes the command.
fn start(folder: &Path, arguments: &[&str]) -> Child {
    Command::new("env")
        .args(["--default-signal=INT,TERM,HUP"])
        .arg(cargo_bin!("crossfibre"))
        .args(arguments)
        .current_dir(folder)
        .env("TMPDIR", folder.join("scratch"))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

/// Waits for something to happen while the command runs.
fn until(child: &mut Child, what: impl Fn() -> bool) {
    let start = Instant::now();
    while !what() {
        assert!(child.try_wait().unwrap().is_none(), "the command ended by itself");
        assert!(start.elapsed() < Duration::from_secs(120), "nothing happens");
        sleep(Duration::from_millis(1));
    }
}

fn interrupted(mut child: Child, signal: Signal) {
    kill_process(Pid::from_child(&child), signal).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

#[test]
fn an_interrupted_trace_leaves_the_file_that_was_there() {
    let folder = tempfile::tempdir().unwrap();
    // Ten times as fine, some millions of events.
    let scene = fs::read_to_string(scenes().join("sliding.json")).unwrap();
    let scene = scene.replace("\"elements\": 600", "\"elements\": 6000");
    fs::write(
        folder.path().join("scene.json"),
        scene.replace("\"elements\": 400", "\"elements\": 4000"),
    )
    .unwrap();
    fs::write(folder.path().join("trace.jsonl"), "old").unwrap();
    for signal in [Signal::INT, Signal::TERM] {
        let mut child = start(folder.path(), &["trace", "scene.json", "-o", "trace.jsonl"]);
        let is_temporary = |name: &String| name.starts_with(".crossfibre-");
        until(&mut child, || names(folder.path()).iter().any(is_temporary));
        interrupted(child, signal);
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(left, ["scene.json", "trace.jsonl"]);
        assert_eq!(fs::read_to_string(folder.path().join("trace.jsonl")).unwrap(), "old");
    }
}

#[test]
fn an_interrupted_study_leaves_whole_points_and_goes_on_from_them() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["study", "figures", "--points", "points", "--out", "pictures"];
    let points = folder.path().join("points");
    let mut child = start(folder.path(), &arguments);
    until(&mut child, || names(&points).iter().filter(|name| !name.starts_with('.')).count() > 0);
    interrupted(child, Signal::INT);
    let left = names(&points);
    for name in &left {
        assert!(!name.starts_with('.'), "{name}");
        let text = fs::read_to_string(points.join(name)).unwrap();
        assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok(), "{name}");
    }
    assert!(!folder.path().join("pictures").exists());
    let mut again = start(folder.path(), &arguments);
    until(&mut again, || names(&points).len() > left.len());
    interrupted(again, Signal::INT);
}

/// Of the checks nothing is written before they are done; the folder that was there already stays.
#[test]
fn an_interrupted_verification_leaves_no_folder() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("there")).unwrap();
    let mut child = start(folder.path(), &["verify", "--out", "there/new/reports"]);
    until(&mut child, || folder.path().join("there/new/reports").exists());
    interrupted(child, Signal::INT);
    assert_eq!(names(folder.path()), ["there"]);
    assert_eq!(names(&folder.path().join("there")), [""; 0]);
}

/// The runs are those of the stored record, so that the study goes straight to its timings. Their folder
/// is made first, and the turns take many seconds.
#[test]
fn an_interrupted_timing_leaves_no_scratch_folder() {
    let folder = tempfile::tempdir().unwrap();
    let scratch = folder.path().join("scratch");
    fs::create_dir(&scratch).unwrap();
    let points = points(QUICK);
    let store = folder.path().join("points");
    let store = Folder::open(&store, STUDY, &points).unwrap();
    let entries = stored().entries.iter().filter(|entry| entry.refinement <= QUICK);
    for (point, entry) in points.iter().zip(entries) {
        store.store(point, &entry.found).unwrap();
    }
    let arguments =
        ["study", "work-precision", "--quick", "--points", "points", "--out", "pictures"];
    let mut child = start(folder.path(), &arguments);
    until(&mut child, || !names(&scratch).is_empty());
    interrupted(child, Signal::INT);
    assert_eq!(names(&scratch), [""; 0]);
    assert!(!folder.path().join("pictures").exists());
}
