//! `crossfibre report`: the same files again from a record, and what it says of one that it cannot read.

#![allow(clippy::unwrap_used)] // a test may

mod cli_support;
mod report_support;

use std::fs;
use std::path::Path;

use cli_support::crossfibre;
use crossfibre_verification::record::{RIGHT_FILE, Record};
use crossfibre_verification::report;

#[test]
fn a_record_gives_the_same_files_every_time_beside_it_or_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    let record = report_support::record();
    fs::create_dir(folder.path().join("made")).unwrap();
    fs::write(folder.path().join("made/report.json"), record.json()).unwrap();
    let beside = crossfibre(folder.path(), &["report", "--from", "made/report.json"]);
    assert_eq!(
        beside.stdout,
        "report.html, junit.xml, VALIDATION.md, summary.md, sensitivity.md in made\n"
    );
    assert_eq!((beside.code, beside.stderr.as_str()), (0, ""));
    let elsewhere =
        crossfibre(folder.path(), &["report", "--from", "made/report.json", "--out", "a/b"]);
    assert_eq!(elsewhere.code, 0, "{}", elsewhere.stderr);
    for (name, text) in report::files(&record) {
        for out in ["made", "a/b"] {
            let written = fs::read_to_string(folder.path().join(out).join(name)).unwrap();
            assert!(written == text, "{out}/{name}");
        }
    }
}

#[test]
fn a_record_that_cannot_be_read_is_told_in_a_line_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let whole = report_support::record().json();
    let half: String = whole.chars().take(whole.len() / 3).collect();
    let lines = half.lines().count();
    let help = format!("\n  help: {RIGHT_FILE}\n");
    let bad = [
        (b"".to_vec(), format!("the file is empty{help}")),
        (half.into_bytes(), format!("ends at line {lines}: cut short?{help}")),
        (
            whole.replacen("report/1", "report/2", 1).into_bytes(),
            format!(
                "the format is `crossfibre-report/2`; this version reads `crossfibre-report/1`{help}"
            ),
        ),
        (b"{\"scene\": 1}".to_vec(), format!("no report: it has no `format`{help}")),
        (b"\xff\xfe{".to_vec(), format!("not UTF-8: the byte at offset 0{help}")),
    ];
    for (bytes, message) in bad {
        fs::write(folder.path().join("bad.json"), bytes).unwrap();
        let ended = crossfibre(folder.path(), &["report", "--from", "bad.json", "--out", "out"]);
        assert_eq!(ended.code, 1);
        assert_eq!(ended.stderr, format!("error: bad.json: {message}"));
        assert!(!folder.path().join("out").exists());
    }
    for (name, message) in
        [("none.json", "there is no such file"), (".", "is a directory, not a file")]
    {
        let ended = crossfibre(folder.path(), &["report", "--from", name]);
        assert_eq!((ended.code, ended.stderr), (1, format!("error: {name}: {message}\n")));
    }
    fs::write(folder.path().join("whole.json"), whole).unwrap();
    let refused =
        crossfibre(folder.path(), &["report", "--from", "whole.json", "--out", "bad.json"]);
    assert_eq!(refused.code, 1);
    assert!(
        refused.stderr.starts_with("error: bad.json: cannot be made a folder: "),
        "{}",
        refused.stderr
    );
}

#[test]
fn a_record_is_what_the_schema_says() {
    let schema = crossfibre(Path::new("."), &["schema", "report"]).stdout;
    let mut schemas = boon::Schemas::new();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("report", serde_json::from_str(&schema).unwrap()).unwrap();
    let id = compiler.compile("report", &mut schemas).unwrap();
    let mut record = serde_json::from_str(&report_support::record().json()).unwrap();
    if let Err(error) = schemas.validate(&record, id) {
        panic!("{error:#}");
    }
    // A number that is none is a word, and an unknown field is an error.
    assert_eq!(record["cases"][1]["checks"][3]["measured"], "NaN");
    record["cases"][0]["checks"][0]["mesured"] = 1.into();
    assert!(schemas.validate(&record, id).is_err());
    assert!(Record::read(&record.to_string()).is_err());
}
