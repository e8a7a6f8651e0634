//! `crossfibre run`: what it prints, what it writes, and how it ends.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use cli_support::{assert_snapshot, crossfibre, scenes};
use serde_json::Value;

/// A shipped scene with pieces of its text replaced, in a folder of its own.
fn changed(scene: &str, pieces: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join(scene)).unwrap();
    let text = pieces.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from} is not in {scene}");
        text.replacen(from, to, 1)
    });
    fs::write(folder.path().join("scene.json"), text).unwrap();
    folder
}

#[test]
fn a_run_ends_in_a_summary() {
    for scene in ["fig3", "single-400", "unequal"] {
        let ended = crossfibre(&scenes(), &["run", &format!("{scene}.json")]);
        assert_snapshot(&format!("run-{scene}"), &ended.seen());
    }
}

/// Bits, not tolerances: the command adds nothing to the library's result but its JSON form.
#[test]
fn the_result_is_the_librarys_to_the_last_bit() {
    let text = fs::read_to_string(scenes().join("unequal.json")).unwrap();
    let scene = crossfibre::scene_file::read(&text).unwrap();
    let expected = crossfibre::result::run(&scene, |_| {});
    let ended = crossfibre(&scenes(), &["run", "unequal.json", "--json"]);
    let result: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert_eq!(result["format"], "crossfibre-result/1");
    let strain = result["secondary"]["strain"].as_array().unwrap();
    let bits: Vec<_> = strain.iter().map(|x| x.as_f64().unwrap().to_bits()).collect();
    let expected: Vec<_> = expected.secondary.unwrap().strain.iter().map(|x| x.to_bits()).collect();
    assert_eq!(bits, expected);
}

#[test]
fn a_file_gets_the_result_and_standard_output_the_summary() {
    let folder = changed("single-400.json", &[("28.7e-6", "11.3e-6")]);
    let run = |more: &[&str]| crossfibre(folder.path(), &[&["run", "scene.json"], more].concat());
    let to_file = run(&["-o", "result.json"]);
    assert!(to_file.stdout.contains("outcome      completed"), "{}", to_file.stdout);
    let written = fs::read_to_string(folder.path().join("result.json")).unwrap();
    assert_eq!(run(&["-o", "-"]).stdout, written);
    assert_eq!(run(&["--json"]).stdout, written);
    assert_eq!(run(&["--json", "-o", "result.json"]).stdout, "");
    assert_eq!(run(&["--quiet"]).stdout, "");
    assert!(!to_file.stdout.contains('\u{1b}'), "colours where there is no terminal");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn a_scene_may_come_from_standard_input() {
    let scene = fs::read(scenes().join("fig3.json")).unwrap();
    let run = |arguments: &[&str]| {
        let mut command = assert_cmd::cargo::cargo_bin_cmd!("crossfibre");
        command.args(arguments).current_dir(scenes()).write_stdin(scene.clone()).output().unwrap()
    };
    let (piped, named) = (run(&["run", "-"]), run(&["run", "fig3.json"]));
    assert_eq!(piped.status.code(), Some(0));
    assert_eq!(piped.stdout, named.stdout);
}

#[test]
fn a_run_that_ends_early_has_code_3_a_reason_and_a_result() {
    // At α = 1.7 engineering strain overflows.
    let diverges = changed(
        "single-400.json",
        &[("\"courant\": 1.0", "\"courant\": 1.7"), ("incremental", "engineering")],
    );
    // Nine elements, and a crossover that begins nearest to the last of their inner nodes.
    let slides = changed(
        "unequal.json",
        &[
            ("139", "9"),
            ("97", "8"),
            ("0.0773", "0.26828"),
            ("0.73", "0.05"),
            ("317.0, \"mass\": 0.00091", "732.0"),
        ],
    );
    for (name, folder) in [("diverges", &diverges), ("crossover-leaves", &slides)] {
        let scene = folder.path().join("scene.json");
        let text = fs::read_to_string(&scene).unwrap();
        fs::write(&scene, text.replace("28.7e-6", "370e-6").replace("31.3e-6", "370e-6")).unwrap();
        let ended = crossfibre(folder.path(), &["run", "scene.json", "-o", "result.json"]);
        assert_snapshot(&format!("run-{name}"), &ended.seen());
        assert_eq!(ended.code, 3);
        let result = fs::read_to_string(folder.path().join("result.json")).unwrap();
        let result: Value = serde_json::from_str(&result).unwrap();
        assert_ne!(result["outcome"]["kind"], "completed");
        let strain = result["primary"]["strain"].as_array().unwrap();
        assert!(strain.iter().all(Value::is_f64), "a strain that is not a number");
    }
}

#[test]
fn a_run_of_hours_has_to_be_asked_for_twice() {
    // 287 km of travel: 10¹² steps.
    let folder = changed("fig3.json", &[("28.7e-6", "287e3")]);
    let ended = crossfibre(folder.path(), &["run", "scene.json", "-o", "result.json"]);
    assert_snapshot("run-too-long", &ended.seen());
    assert!(!folder.path().join("result.json").exists());
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let mut child = Command::new(assert_cmd::cargo::cargo_bin!("crossfibre"))
        .current_dir(scenes())
        .args(["trace", "sliding.json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut some = [0; 99];
    // Takes the pipe, reads the beginning and closes it.
    child.stdout.take().unwrap().read_exact(&mut some).unwrap();
    let ended = child.wait_with_output().unwrap();
    assert_eq!((ended.status.code(), ended.stderr.as_slice()), (Some(0), &b""[..]));
}

#[cfg(target_os = "linux")]
#[test]
fn an_output_that_cannot_be_written_is_an_error() {
    let ended = crossfibre(&scenes(), &["run", "fig3.json", "-o", "/dev/full"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.starts_with("error: "), "{}", ended.stderr);
}
