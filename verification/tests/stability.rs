//! The study `stability`: the committed tables and pictures are what the command computes.
#![allow(clippy::unwrap_used)] // a test may

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crossfibre_verification::stability::maps::{Map, maps};
use crossfibre_verification::stability::rows::{Row, rows};
use crossfibre_verification::stability::tasks::{compute, points};
use crossfibre_verification::stability::{CELLS, LIMITS, Results, STUDY, cells, files, limits};
use crossfibre_verification::sweep::{Places, Point, sweep};

fn committed(name: &str) -> String {
    let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/stability");
    fs::read_to_string(folder.join(name)).unwrap()
}

/// The lines of a table that were computed here are lines of the committed one.
fn is_part_of(table: &str, name: &str, head: &str) {
    let committed = committed(name);
    let lines: BTreeSet<&str> = committed.lines().collect();
    assert!(table.lines().count() > 1 && committed.starts_with(head));
    for line in table.lines() {
        assert!(lines.contains(line), "docs/stability/{name} is stale, it has no line\n{line}");
    }
}

/// What is computed of some points.
fn results(points: Vec<Point<crossfibre_verification::stability::tasks::Task>>) -> Results {
    let values = points.iter().map(|point| compute(&point.parameters)).collect();
    Results::new(&points, values)
}

/// A row of each part of the table of limits, and a column of each map of perturbations. All of them,
/// and the pictures, take minutes: the next test.
#[test]
fn some_of_the_committed_numbers_are_computed_anew() {
    let wanted = [
        "uniform-4-10",
        "law-Maxwell-exact-E-0.4-t-0.7-engineering-1.45",
        "law-stiffening-polynomial-engineering-5",
        "projectile-along-0.1-without",
    ];
    let rows: Vec<Row> = rows().into_iter().filter(|row| wanted.contains(&&*row.id)).collect();
    assert_eq!(rows.len(), wanted.len());
    let maps: Vec<(Map, f64)> = maps()
        .into_iter()
        .filter(|map| !map.id.starts_with("velocity"))
        .map(|map| (map.clone(), map.x.values()[map.x.count / 2 + 2]))
        .collect();
    let ids: BTreeSet<String> = rows
        .iter()
        .map(|row| row.id.clone())
        .chain(maps.iter().map(|(map, x)| map.cells_id(*x)))
        .collect();
    let points = points().into_iter().filter(|point| ids.contains(&point.id)).collect::<Vec<_>>();
    assert_eq!(points.len(), ids.len());
    let results = results(points);
    is_part_of(&limits(&results, &rows), "limits.csv", LIMITS);
    let columns: Vec<(&Map, f64)> = maps.iter().map(|(map, x)| (map, *x)).collect();
    is_part_of(&cells(&results, &columns), "maps.csv", CELLS);
}

#[test]
#[ignore = "takes minutes in a release build: cargo test --release --test stability -- --ignored"]
fn the_committed_files_are_computed_anew() {
    let folder = tempfile::tempdir().unwrap();
    let places = Places { points: folder.path().into(), from: vec![], shard: None };
    let points = points();
    let values = sweep(STUDY, &points, &places, compute).unwrap();
    let results = Results::new(&points, values.into_iter().flatten().collect());
    for (name, text) in files(&results) {
        assert!(
            text == committed(name),
            "docs/stability/{name} is stale: look at what `crossfibre study stability --out \
             docs/stability` changes, and commit it if it is meant"
        );
    }
}

#[test]
fn every_row_and_every_column_is_in_the_committed_tables() {
    let of = |name| committed(name).lines().skip(1).count();
    assert_eq!(of("limits.csv"), rows().len());
    let maps = maps();
    assert_eq!(of("edges.csv"), maps.iter().map(|map| map.x.count).sum::<usize>());
    let cells = |map: &Map| map.x.count * map.courant.0.count;
    assert_eq!(of("maps.csv"), maps.iter().map(cells).sum::<usize>());
}

#[test]
fn ids_name_one_point_each_and_fit_a_file() {
    let points = points();
    let ids: BTreeSet<_> = points.iter().map(|point| &point.id).collect();
    assert_eq!(ids.len(), points.len());
    let fits = |c: char| c.is_ascii_alphanumeric() || "-.".contains(c);
    assert!(ids.iter().all(|id| id.chars().all(fits)), "{ids:?}");
}
