//! The study `cost`: the evaluations of the stored page are those that the program counts. Instructions
//! are of a machine, and of no test.
#![allow(clippy::unwrap_used)] // a test may

use std::fs;

use assert_cmd::cargo::cargo_bin_cmd;

const STORED: &str = include_str!("../../docs/cost/README.md");

/// The stored page without what callgrind has counted.
fn without_instructions() -> String {
    let row = |line: &str| {
        let mut cells: Vec<&str> = line.split(" | ").collect();
        let counted = |cell: &str| cell.trim_end_matches(" |").parse::<f64>().is_ok();
        if let [_, _, _, instructions, ratio] = &mut cells[..]
            && counted(instructions)
            && counted(ratio)
        {
            (*instructions, *ratio) = ("–", "– |");
        }
        cells.join(" | ") + "\n"
    };
    STORED.lines().map(row).collect()
}

/// Programs are looked for in a folder that has none: no callgrind.
#[test]
fn the_stored_page_has_the_evaluations_that_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let output = cargo_bin_cmd!("crossfibre")
        .current_dir(folder.path())
        .env("PATH", folder.path())
        .args(["study", "cost", "--out", "out"])
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    assert_eq!((output.status.code(), text(output.stderr)), (Some(0), String::new()));
    let page = fs::read_to_string(folder.path().join("out/README.md")).unwrap();
    assert_eq!(page, without_instructions());
    let said = page + "\nvalgrind is not there: no instructions are counted\n";
    assert_eq!(text(output.stdout), said);
}
