use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::*;

const STUDY: &str = "cubes/1";

fn points() -> Vec<Point<f64>> {
    let numbers = [0.731, -17.3, 4.9e-7, 6.02e23, 2.0 / 3.0];
    numbers
        .into_iter()
        .enumerate()
        .map(|(k, parameters)| Point { id: format!("cube-{k}"), parameters })
        .collect()
}

fn places(points: &Path, from: &[&Path], shard: Option<&str>) -> Places {
    Places {
        points: points.into(),
        from: from.iter().map(|&path| path.into()).collect(),
        shard: shard.map(|text| text.parse().unwrap()),
    }
}

fn cube(x: &f64) -> f64 {
    x * x * x
}

/// The values, and how many were computed.
fn swept(places: &Places) -> Result<(Vec<Option<f64>>, usize)> {
    let count = AtomicUsize::new(0);
    let values = sweep(STUDY, &points(), places, |x| {
        count.fetch_add(1, Ordering::Relaxed);
        cube(x)
    })?;
    Ok((values, count.into_inner()))
}

/// Every file of a folder, by name.
fn files(folder: &Path) -> Vec<(String, String)> {
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|e| (e.file_name().into_string().unwrap(), fs::read_to_string(e.path()).unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn what_is_stored_is_not_computed_again() {
    let folder = tempfile::tempdir().unwrap();
    let all = places(folder.path(), &[], None);
    let expected: Vec<_> = points().iter().map(|p| Some(cube(&p.parameters))).collect();
    assert_eq!(swept(&all).unwrap(), (expected.clone(), 5));
    assert_eq!(swept(&all).unwrap(), (expected.clone(), 0));
    // As after an interruption: two points are missing, and a third was being written.
    fs::remove_file(folder.path().join("cube-1.json")).unwrap();
    fs::remove_file(folder.path().join("cube-4.json")).unwrap();
    fs::write(folder.path().join(".crossfibre-x1y2"), "{\"origin\": {\"for").unwrap();
    assert_eq!(swept(&all).unwrap(), (expected, 2));
}

#[test]
fn parts_united_are_the_whole_to_the_bit() {
    let [whole, one, two, united] = [(); 4].map(|()| tempfile::tempdir().unwrap());
    swept(&places(whole.path(), &[], None)).unwrap();
    let (values, computed) = swept(&places(one.path(), &[], Some("1/2"))).unwrap();
    assert_eq!((values.iter().flatten().count(), computed), (3, 3));
    swept(&places(two.path(), &[], Some("2/2"))).unwrap();
    let both = places(united.path(), &[one.path(), two.path()], None);
    assert_eq!(swept(&both).unwrap().1, 0);
    assert_eq!(files(united.path()), files(whole.path()));
    // Once more: both have every point, and the same.
    assert_eq!(swept(&both).unwrap().1, 0);
    // A plain copy does as well.
    for (name, text) in files(two.path()) {
        fs::write(one.path().join(name), text).unwrap();
    }
    assert_eq!(swept(&places(one.path(), &[], None)).unwrap().1, 0);
    assert_eq!(files(one.path()), files(whole.path()));
}

/// What the message says when a stored point is changed.
fn complaint(from: &str, to: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let all = places(folder.path(), &[], None);
    swept(&all).unwrap();
    let file = folder.path().join("cube-2.json");
    let text = fs::read_to_string(&file).unwrap();
    assert!(text.contains(from), "{text}");
    fs::write(&file, text.replacen(from, to, 1)).unwrap();
    let error = format!("{:#}", swept(&all).unwrap_err());
    assert!(error.contains("cube-2.json: ") && error.contains("help: remove it"), "{error}");
    error
}

#[test]
fn what_another_program_or_study_stored_is_not_taken() {
    let program = format!("{}+", env!("CARGO_PKG_VERSION"));
    for (from, to, what) in [
        ("point/1", "point/2", "another format"),
        ("cubes/1", "cubes/2", "another study"),
        (program.as_str(), "0.0.9+", "another version of the program"),
        ("\"cube-2\"", "\"cube-3\"", "another point"),
        ("4.9e-7", "4.8e-7", "parameters differ"),
        ("\"value\"", "\"values\"", "unknown field"),
        ("}\n", "", "EOF"),
        ("{", "rubbish", "expected"),
        ("\"value\":", "\"value\":null,\"v\":", "unknown field"),
    ] {
        let error = complaint(from, to);
        assert!(error.contains(what), "{error}");
    }
}

#[test]
fn a_value_that_is_no_number_is_not_taken_for_one() {
    let folder = tempfile::tempdir().unwrap();
    let all = places(folder.path(), &[], None);
    let error = sweep(STUDY, &points(), &all, |_| f64::NAN).unwrap_err();
    assert!(error.to_string().contains("null"), "{error}");
}

#[test]
fn a_point_that_cannot_be_read_is_not_computed_again() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("cube-2.json")).unwrap();
    let computed = AtomicUsize::new(0);
    let compute = |x: &f64| {
        computed.fetch_add(1, Ordering::Relaxed);
        cube(x)
    };
    let error = sweep(STUDY, &points(), &places(folder.path(), &[], None), compute).unwrap_err();
    assert!(error.to_string().contains("cube-2.json"), "{error}");
    assert_eq!(computed.into_inner(), 0);
}

#[test]
fn two_folders_that_disagree_are_not_united() {
    let [one, two] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    sweep(STUDY, &points(), &places(one.path(), &[], None), cube).unwrap();
    sweep(STUDY, &points(), &places(two.path(), &[], None), |x| 2.0 * cube(x)).unwrap();
    let error = swept(&places(one.path(), &[two.path()], None)).unwrap_err().to_string();
    assert!(error.contains("differ\n  help: "), "{error}");
}

#[test]
fn a_folder_of_other_things_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("notes.txt"), "").unwrap();
    let error = swept(&places(folder.path(), &[], None)).unwrap_err().to_string();
    assert!(error.contains("notes.txt: is not a point of the study `cubes/1`"), "{error}");
    assert_eq!(files(folder.path()).len(), 1);
    let error = swept(&places(&folder.path().join("notes.txt"), &[], None)).unwrap_err();
    assert!(error.to_string().contains("cannot be made a folder of points"), "{error}");
    let nowhere = folder.path().join("nowhere");
    let error = swept(&places(&folder.path().join("new"), &[&nowhere], None)).unwrap_err();
    assert!(error.to_string().contains("nowhere: cannot be read"), "{error}");
}
