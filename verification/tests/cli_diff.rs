//! `crossfibre diff`: verdicts, messages and exit codes.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use cli_support::{assert_snapshot, crossfibre, scenes};
use crossfibre_verification::diff::record::Record;
use tempfile::TempDir;

/// A folder with `a.trace`, five steps of the unequal fibres, and its text.
fn traced() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.trace");
    let to = path.to_str().unwrap();
    let ended = crossfibre(&scenes(), &["trace", "unequal.json", "--step", "1..5", "-o", to]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let text = fs::read_to_string(path).unwrap();
    (folder, text)
}

/// The line of an event.
fn line_of<'a>(trace: &'a str, head: &str) -> &'a str {
    trace.lines().find(|line| line.starts_with(head)).unwrap()
}

const LENGTH: &str = r#"{"step":4,"fibre":"primary","index":2,"eq":"6","#;

/// The line with the last digit of a number exchanged: of the output, or of the first number after a
/// name.
fn nudged(line: &str, name: &str) -> String {
    let start = line.find(&format!("\"{name}\":")).unwrap() + name.len() + 3;
    let start = start + usize::from(line[start..].starts_with('['));
    let end = start + line[start..].find([',', ']', '}']).unwrap();
    let last = if &line[end - 1..end] == "3" { "5" } else { "3" };
    format!("{}{last}{}", &line[..end - 1], &line[end..])
}

fn write(folder: &Path, text: impl AsRef<[u8]>) {
    fs::write(folder.join("b.trace"), text).unwrap();
}

#[test]
fn two_traces_are_compared_and_the_fault_is_found() {
    let (folder, text) = traced();
    let line = line_of(&text, LENGTH);
    let exchanged = |by: &str| text.replacen(line, by, 1);
    let five =
        line_of(&text, r#"{"step":2,"fibre":"secondary","index":0,"eq":"5","#).to_owned() + "\n";
    let scene = text.replacen("\"courant\":0.937", "\"courant\":0.9", 1);
    assert!(scene != text);
    for (name, b, options, code) in [
        ("identical", text.clone(), "", 0),
        ("output", exchanged(&nudged(line, "out")), "", 4),
        ("input", exchanged(&nudged(line, "v_ahead")), "", 4),
        ("missing", text.replacen(&five, "", 1), "", 4),
        ("tolerance", exchanged(&nudged(line, "out")), "--tolerance 1e-12", 0),
        ("other-scene", scene, "--eq 4,7 --step 2..3 --first", 0),
    ] {
        write(folder.path(), b);
        let options = options.split_whitespace();
        let arguments: Vec<_> = ["diff", "a.trace", "b.trace"].into_iter().chain(options).collect();
        let ended = crossfibre(folder.path(), &arguments);
        assert_eq!((ended.code, ended.stderr.as_str()), (code, ""), "{name}");
        assert_snapshot(&format!("diff-{name}"), &ended.seen());
    }
}

#[test]
fn a_malformed_trace_is_refused_with_its_line_and_what_had_come_of_it() {
    let (folder, text) = traced();
    let line = line_of(&text, LENGTH);
    let next = text[text.find(line).unwrap() + line.len() + 1..].lines().next().unwrap();
    let (header, events) = text.split_once('\n').unwrap();
    let mut seen = String::new();
    for (name, b) in [
        ("empty", String::new()),
        ("no header", events.into()),
        ("a header only", format!("{header}\n")),
        ("wrong version", text.replacen("crossfibre-trace/1", "crossfibre-trace/2", 1)),
        ("a scene", fs::read_to_string(scenes().join("unequal.json")).unwrap()),
        ("cut", text[..text.len() - 30].into()),
        ("out of order", text.replacen(&format!("{line}\n{next}"), &format!("{next}\n{line}"), 1)),
        ("unknown equation", text.replacen(line, &line.replace("\"6\"", "\"22\""), 1)),
        ("no number", text.replacen(line, &line.replace("\"out\":", "\"out\":x"), 1)),
    ] {
        write(folder.path(), b);
        let arguments = ["diff", "a.trace", "b.trace", "-o", "report.txt"];
        let ended = crossfibre(folder.path(), &arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{name}");
        seen += &format!("{name}\n{}\n", ended.stderr);
    }
    for arguments in [
        &["diff", "a.trace", "nowhere.trace"][..],
        &["diff", ".", "a.trace"],
        &["diff", "-", "-"],
        &["diff", "a.trace", "a.trace", "--eq", "1"],
        &["diff", "a.trace", "a.trace", "--tolerance", "-1e-9"],
        &["diff", "a.trace", "a.trace", "--tolerance", "NaN"],
    ] {
        let ended = crossfibre(folder.path(), arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{arguments:?}");
        seen += &format!("{}\n{}\n", arguments.join(" "), ended.stderr);
    }
    assert_snapshot("diff-malformed", &seen);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn the_record_is_of_the_type_that_the_schema_describes() {
    let (folder, text) = traced();
    let line = line_of(&text, LENGTH);
    write(folder.path(), text.replacen(line, &nudged(line, "v_ahead"), 1));
    let arguments = ["diff", "a.trace", "b.trace", "--json", "-o", "diff.json", "--ulp", "0"];
    let ended = crossfibre(folder.path(), &arguments);
    assert_eq!((ended.code, ended.stdout.as_str(), ended.stderr.as_str()), (4, "", ""));
    let written = fs::read_to_string(folder.path().join("diff.json")).unwrap();
    let record: Record = serde_json::from_str(&written).unwrap();
    assert_eq!((record.format.as_str(), record.ulp), ("crossfibre-diff/1", Some(0)));
    let first = record.first_difference.unwrap();
    assert_eq!((first.evaluation.step, first.evaluation.index), (4, 2));
    assert_eq!(first.quantities[0].name, "v_ahead");

    let schema = crossfibre(folder.path(), &["schema", "diff"]).stdout;
    let schema: serde_json::Value = serde_json::from_str(&schema).unwrap();
    let mut schemas = boon::Schemas::new();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("diff.json", schema).unwrap();
    let index = compiler.compile("diff.json", &mut schemas).unwrap();
    let mut json: serde_json::Value = serde_json::from_str(&written).unwrap();
    schemas.validate(&json, index).unwrap();
    json["first_difference"]["kind"] = "inputz".into();
    assert!(schemas.validate(&json, index).is_err());
}

#[test]
fn a_tolerance_is_a_number_from_0_up() {
    let (folder, text) = traced();
    write(folder.path(), text);
    for (tolerance, code) in
        [("0", 0), ("1e-300", 0), ("-1e-300", 1), ("inf", 1), ("-inf", 1), ("a", 1)]
    {
        let arguments = ["diff", "a.trace", "b.trace", "--tolerance", tolerance];
        assert_eq!(crossfibre(folder.path(), &arguments).code, code, "{tolerance}");
    }
}

#[test]
fn one_of_the_two_may_come_from_standard_input() {
    let (folder, text) = traced();
    for (arguments, code) in [(["diff", "-", "a.trace"], 0), (["diff", "a.trace", "-"], 0)] {
        let mut command = cargo_bin_cmd!("crossfibre");
        command.current_dir(folder.path()).args(arguments).write_stdin(text.clone());
        command.assert().code(code);
    }
}

/// Bits of different scenes differ from the first step on; the report must come to its end.
#[test]
fn traces_of_different_scenes_are_compared_to_their_ends() {
    let folder = tempfile::tempdir().unwrap();
    for scene in ["fig3", "fig3-printed"] {
        let path = folder.path().join(format!("{scene}.trace"));
        let to = path.to_str().unwrap();
        let scene = format!("{scene}.json");
        assert_eq!(crossfibre(&scenes(), &["trace", &scene, "--step", "1..60", "-o", to]).code, 0);
    }
    let ended = crossfibre(folder.path(), &["diff", "fig3.trace", "fig3-printed.trace"]);
    assert_eq!(ended.code, 4, "{}", ended.stderr);
    assert_snapshot("diff-fig3-printed", &ended.seen());
}
