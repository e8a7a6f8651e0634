//! The study `work-precision`: what is stored is what the command computes and draws.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::{Path, PathBuf};

use cli_support::crossfibre;
use crossfibre_verification::precision::{
    Entry, FINEST, Found, QUICK, Record, STUDY, Times, VARIANTS, files, id, points, record,
};
use crossfibre_verification::sweep::folder::Folder;

fn stored(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/work-precision").join(name)
}

fn read(name: &str) -> String {
    fs::read_to_string(stored(name)).unwrap()
}

fn stored_record() -> Record {
    serde_json::from_str(&read("record.json")).unwrap()
}

/// Bytes: the pictures, the page and the tables are functions of the record, and of the times if there
/// are any.
#[test]
fn the_stored_files_are_drawn_from_the_stored_record() {
    let record = stored_record();
    assert_eq!(record.format, record::FORMAT);
    let times: Option<Times> =
        stored("times.json").exists().then(|| serde_json::from_str(&read("times.json")).unwrap());
    let drawn = files(&record, times.as_ref());
    for (name, text) in &drawn {
        assert!(
            *text == read(name),
            "docs/work-precision/{name} is stale: look at what `crossfibre study work-precision --out \
             docs/work-precision` changes, and commit it if it is meant"
        );
    }
    // Nothing else is there.
    let mut names: Vec<String> = drawn.into_iter().map(|(name, _)| name.into()).collect();
    names.extend(times.map(|_| "times.json".into()));
    let there = fs::read_dir(stored("")).unwrap();
    for entry in there.map(|entry| entry.unwrap().file_name().into_string().unwrap()) {
        assert!(names.contains(&entry), "docs/work-precision/{entry} is drawn by nothing");
    }
}

/// Runs of the stored record are drawn by the command, with the times of an earlier study or with none.
#[test]
fn what_is_drawn_of_an_earlier_study_is_what_was_stored_with_its_times_or_without() {
    let folder = tempfile::tempdir().unwrap();
    let record = stored_record();
    let points = points(FINEST);
    assert_eq!(points.len(), record.entries.len());
    let store = folder.path().join("points");
    let store = Folder::open(&store, STUDY, &points).unwrap();
    for (point, entry) in points.iter().zip(&record.entries) {
        store.store(point, &entry.found).unwrap();
    }
    let times = stored("times.json");
    let with_times: Times = serde_json::from_str(&read("times.json")).unwrap();
    for (out, options, times) in [
        ("with", ["--times", times.to_str().unwrap()].as_slice(), Some(with_times)),
        ("without", &["--no-times"], None),
    ] {
        let arguments = ["study", "work-precision", "--points", "points", "--out", out];
        let ended = crossfibre(folder.path(), &[&arguments[..], options].concat());
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
        let drawn = files(&record, times.as_ref());
        for (name, text) in &drawn {
            let written = fs::read_to_string(folder.path().join(out).join(name)).unwrap();
            assert!(*text == written, "{out}/{name}");
        }
        let there = fs::read_dir(folder.path().join(out)).unwrap().count();
        assert_eq!(there, drawn.len(), "{out}");
    }
}

/// A part of the quick study by the command, against the stored record, to the bit. The rest takes
/// minutes.
#[test]
fn a_part_of_the_stored_runs_is_computed_anew() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["study", "work-precision", "--quick", "--shard", PART, "--points", "points"];
    let ended = crossfibre(folder.path(), &[&arguments[..], &["--out", "out"]].concat());
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert!(ended.stdout.contains("nothing is drawn yet"), "{}", ended.stdout);

    let record = stored_record();
    let id_of = |entry: &Entry| {
        let variant = VARIANTS.iter().find(|variant| variant.name == entry.variant).unwrap();
        id(entry.problem, variant, entry.refinement)
    };
    let mut compared = 0;
    for entry in &record.entries {
        let path = folder.path().join(format!("points/{}.json", id_of(entry)));
        let Ok(text) = fs::read_to_string(path) else { continue };
        let point: serde_json::Value = serde_json::from_str(&text).unwrap();
        let found: Found = serde_json::from_value(point["value"].clone()).unwrap();
        assert_eq!(found, entry.found, "{}", id_of(entry));
        compared += 1;
    }
    let all = fs::read_dir(folder.path().join("points")).unwrap().count();
    assert_eq!(compared, all);
    assert_eq!(compared, points(QUICK).len().div_ceil(PARTS));
}

/// The part, of how many.
const PART: &str = "1/11";
const PARTS: usize = 11;
