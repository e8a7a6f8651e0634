//! The study `extremes`: the committed page is what the command writes.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;

use cli_support::crossfibre;

#[test]
fn the_committed_page_is_what_the_study_writes() {
    let folder = tempfile::tempdir().unwrap();
    let ended = crossfibre(folder.path(), &["study", "extremes", "--out", "page"]);
    assert_eq!((ended.code, ended.stdout.as_str(), ended.stderr.as_str()), (0, "", ""));
    let written = fs::read_to_string(folder.path().join("page/README.md")).unwrap();
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/extremes/README.md");
    assert!(
        fs::read_to_string(committed).unwrap() == written,
        "docs/extremes/README.md is stale: look at what `crossfibre study extremes --out \
         docs/extremes` changes, and commit it if it is meant"
    );
    assert!(!written.contains("**failed**"), "a row of the page fails its own bound");
}

#[test]
fn a_folder_that_cannot_be_made_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "").unwrap();
    let ended = crossfibre(folder.path(), &["study", "extremes", "--out", "file"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, ""));
    assert!(ended.stderr.contains("file: cannot be made a folder"), "{}", ended.stderr);
}
