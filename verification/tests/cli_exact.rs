//! `crossfibre exact`: what it prints, what it writes, and how it ends.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;

use cli_support::{assert_snapshot, crossfibre, scenes};
use serde_json::Value;

/// A shipped scene with engineering strain, in a folder of its own.
fn engineering(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join(scene)).unwrap();
    let mut json: Value = serde_json::from_str(&text).unwrap();
    json["strain"] = "engineering".into();
    fs::write(folder.path().join("scene.json"), json.to_string()).unwrap();
    folder
}

#[test]
fn the_solution_is_told_in_pieces() {
    let exact = crossfibre(engineering("fig3.json").path(), &["exact", "scene.json"]);
    assert_snapshot("exact-fig3-engineering", &exact.seen());
    let converging = crossfibre(&scenes(), &["exact", "single-400.json"]);
    assert_snapshot("exact-single-400", &converging.seen());
}

#[test]
fn a_file_gets_the_solution_and_standard_output_the_summary_unless_it_is_the_file() {
    let folder = engineering("fig3.json");
    let run = |more: &[&str]| crossfibre(folder.path(), &[&["exact", "scene.json"], more].concat());
    let (summary, json) = (run(&[]).stdout, run(&["--json"]).stdout);
    assert!(json.starts_with('{') && !summary.contains('{'), "{summary}");
    assert_eq!(run(&["-o", "-"]).stdout, json);
    assert_eq!(run(&["-o", "exact.json"]).stdout, summary);
    assert_eq!(run(&["-o", "exact.json", "--json"]).stdout, "");
    assert_eq!(run(&["--plot", "exact.svg"]).stdout, summary);
    let picture = fs::read_to_string(folder.path().join("exact.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.contains("fronts on the secondary"));
    assert_eq!(fs::read_to_string(folder.path().join("exact.json")).unwrap(), json);
}

#[test]
fn the_file_keeps_to_its_schema() {
    let schema = crossfibre(&scenes(), &["schema", "exact"]).stdout;
    let mut compiler = boon::Compiler::new();
    let mut schemas = boon::Schemas::new();
    compiler.add_resource("exact.json", serde_json::from_str(&schema).unwrap()).unwrap();
    let compiled = compiler.compile("exact.json", &mut schemas).unwrap();
    for scene in ["fig3.json", "finite-projectile.json", "sliding.json"] {
        let ended = crossfibre(&scenes(), &["exact", scene, "--time", "60e-6", "--json"]);
        let file: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_eq!(file["format"], "crossfibre-exact/1");
        if let Err(error) = schemas.validate(&file, compiled) {
            panic!("{scene}: {error}");
        }
    }
}

/// The published coefficients (docs/exact/crossover.md), to their last digit, and pieces that leave
/// no gap.
#[test]
fn the_file_has_the_coefficients_and_the_whole_of_both_fibres() {
    let folder = engineering("fig3.json");
    let ended = crossfibre(folder.path(), &["exact", "scene.json", "-o", "exact.json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let text = fs::read_to_string(folder.path().join("exact.json")).unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    for (name, expected) in
        [("reflection", 0.043_991), ("transmission", 0.956_009), ("diversion", 0.146_708)]
    {
        let found = file["coefficients"][name].as_f64().unwrap();
        assert!((found - expected).abs() < 0.6e-6, "{name} = {found}");
    }
    for (fibre, length) in [("primary", 0.3), ("secondary", 0.2)] {
        let pieces = file[fibre].as_array().unwrap();
        let end = pieces.iter().fold(0.0, |at, piece| {
            assert_eq!(piece["from"].as_f64().unwrap(), at);
            piece["to"].as_f64().unwrap()
        });
        // The offset of the crossover and the rest of the length are added: one rounding.
        assert!((end - length).abs() < 1e-15, "{fibre} ends at {end}");
    }
}

#[test]
fn a_motion_that_ends_early_is_written_and_told_with_code_3() {
    let ended = crossfibre(&scenes(), &["exact", "sliding.json", "--time", "100e-6", "--json"]);
    assert_eq!(ended.code, 3);
    assert!(ended.stderr.contains("a kink reaches the sliding crossover"), "{}", ended.stderr);
    let file: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(file["ended"]["kind"], "slides_on_kink");
    assert!(file["time"].as_f64().unwrap() < 100e-6);
}

#[test]
fn a_time_that_is_none_is_refused() {
    for time in ["-1e-6", "0", "NaN", "inf", "soon"] {
        let ended = crossfibre(&scenes(), &["exact", "fig3.json", "--time", time]);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{time}");
        assert!(!ended.stderr.contains("unexpected argument"), "{}", ended.stderr);
        assert!(ended.stderr.contains("--time"), "{}", ended.stderr);
    }
}
