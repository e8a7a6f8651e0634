//! The study `stability`: the committed tables and pictures are what the command computes.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cli_support::assert_snapshot_in;
use crossfibre_verification::bits::fnv;
use crossfibre_verification::stability::growth::{Growth, Shaken};
use crossfibre_verification::stability::maps::{Map, maps};
use crossfibre_verification::stability::rows::{Row, measure_name, rows};
use crossfibre_verification::stability::tasks::{Found, SHAKEN, Task, compute, points, shakings};
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
fn results(points: Vec<Point<Task>>) -> Results {
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

/// Numbers of no march: all that a page has words for is there.
fn made_up(k: usize, task: &Task) -> Found {
    let near_one = |of: usize| 0.4 + (k % of) as f64 / 16.0;
    let cell = |(j, courant): (usize, &f64)| Growth {
        rate: if *courant > near_one(13) { 1e-3 * (j + 1) as f64 } else { 1e-9 },
        diverged: (j + k).is_multiple_of(7).then_some(17 * j as u64 + 1),
    };
    match task {
        Task::Limits(_) => Found::Limits {
            predicted: Some(near_one(13)),
            measured: (!k.is_multiple_of(7)).then(|| near_one(13) + 1e-3 * (k % 3) as f64),
            allowed: (!k.is_multiple_of(5)).then(|| near_one(17)),
        },
        Task::Shaken { sizes, .. } => {
            let shaken = |j: usize| Shaken {
                wound: 1e-3 * (j + k) as f64,
                diverged: (j + k).is_multiple_of(3).then_some(17 * j as u64 + 1),
            };
            Found::Shaken((0..sizes.len()).map(shaken).collect())
        }
        Task::Edge(_) => Found::Edge((!k.is_multiple_of(5)).then(|| near_one(11))),
        Task::Perturbed { courant, .. } | Task::Struck { courant, .. } => {
            Found::Cells(courant.iter().enumerate().map(cell).collect())
        }
    }
}

/// The page as a text, tables and pictures by a number for each. What is computed has tests of its own.
#[test]
fn files_of_made_up_numbers_are_as_they_were() {
    let points = points();
    let values =
        points.iter().enumerate().map(|(k, point)| made_up(k, &point.parameters)).collect();
    let mut seen = String::new();
    for (name, text) in files(&Results::new(&points, values)) {
        if name == "README.md" {
            assert_snapshot_in("study", "stability-made-up", &text);
        } else {
            seen += &format!("{name} {:016x}\n", fnv(text.bytes()));
        }
    }
    assert_snapshot_in("study", "stability-made-up-files", &seen);
}

/// Fibres that swing, all of them: the page has them in words.
#[test]
fn fibres_that_are_shaken_are_those_of_the_committed_page() {
    let page = committed("README.md");
    let mut run_away = 0;
    for ((courant, measure), point) in shakings() {
        let Found::Shaken(found) = compute(&point.parameters) else { panic!("{}", point.id) };
        let words = |shaken: &Shaken| match shaken.diverged {
            Some(step) => format!("runs away, step {step}"),
            None => format!("{:+.1e}", shaken.wound),
        };
        let words: Vec<String> = found.iter().map(words).collect();
        let line = format!("| {} | {courant} | {} |", measure_name(measure), words.join(" | "));
        assert!(
            page.lines().any(|known| known == line),
            "the page is stale, it has no line\n{line}"
        );
        // What has run away has three times its strain: two more.
        for shaken in found.iter().filter(|shaken| shaken.diverged.is_some()) {
            assert_eq!(shaken.wound.to_bits(), (2.0 * SHAKEN).to_bits());
            run_away += 1;
        }
    }
    assert_eq!(run_away, 3);
}

/// Impacts by (4) at a velocity at which every march runs away, and one of another that lasts.
#[test]
fn some_of_the_committed_impacts_are_computed_anew() {
    let maps = maps();
    let map = maps.iter().find(|map| map.id == "velocity-4").unwrap();
    let columns = [(map, 0.95), (map, 0.6)];
    let point = |(map, x): (&Map, f64)| {
        map.points().into_iter().find(|point| point.id == map.cells_id(x)).unwrap()
    };
    let mut points = columns.map(point);
    let Task::Struck { courant, .. } = &mut points[1].parameters else { panic!("no impact") };
    courant.truncate(1);
    let table = cells(&results(points.into()), &columns);
    assert_eq!(table.lines().count(), 1 + map.courant.0.count + 1);
    is_part_of(&table, "maps.csv", CELLS);
}

/// The scenes, strains and Courant numbers, by a number for each part of the study.
#[test]
fn what_is_computed_is_what_it_was() {
    let mut parts: BTreeMap<String, String> = BTreeMap::new();
    for point in points() {
        let part = point.id.split('-').next().unwrap().to_owned();
        let parameters = serde_json::to_string(&point.parameters).unwrap();
        *parts.entry(part).or_default() += &format!("{} {parameters}\n", point.id);
    }
    let line = |(part, text): (&String, &String)| {
        format!("{part} {} {:016x}\n", text.lines().count(), fnv(text.bytes()))
    };
    assert_snapshot_in("study", "stability-points", &parts.iter().map(line).collect::<String>());
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
