//! The study `figures`: the committed pictures are what the command draws, from however many parts,
//! and what it is given wrongly is refused with what to do.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cli_support::{Ended, crossfibre};

/// The pictures, tables and the page of the repository.
fn committed() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures")
}

/// Every file of a folder, by name.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|e| (e.file_name().into_string().unwrap(), fs::read(e.path()).unwrap()))
        .collect()
}

fn study(folder: &Path, arguments: &str) -> Ended {
    let arguments = arguments.split_whitespace();
    crossfibre(folder, &["study", "figures"].into_iter().chain(arguments).collect::<Vec<_>>())
}

/// The whole study in two parts. The committed files came from one run, so this also holds the parts
/// against the whole.
#[test]
fn two_parts_united_draw_the_committed_figures() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for (part, points) in [("1/2", "one"), ("2/2", "two")] {
        let ended = study(folder.path(), &format!("--shard {part} --points {points} --out out"));
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
        assert!(ended.stdout.contains("nothing is drawn yet"), "{}", ended.stdout);
        assert_eq!(files(&path("out")).len(), 0);
    }
    let ended = study(folder.path(), "--points all --from one --from two --out out");
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let both = files(&path("one")).into_iter().chain(files(&path("two")));
    assert_eq!(files(&path("all")), both.collect());

    let (drawn, committed) = (files(&path("out")), files(&committed()));
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&drawn), names(&committed));
    for (name, bytes) in drawn {
        assert!(
            bytes == committed[&name],
            "docs/figures/{name} is stale: look at what `crossfibre study figures --out docs/figures` \
             changes, and commit it if it is meant"
        );
    }
}

#[test]
fn what_is_wrong_is_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in ["other", "rubbish"] {
        fs::create_dir(path(name)).unwrap();
    }
    fs::write(path("file"), "").unwrap();
    fs::write(path("other/thesis.txt"), "").unwrap();
    fs::write(path("rubbish/fig3-printed-2mm.json"), "{\"origin\":").unwrap();
    for (arguments, says) in [
        ("--shard 3/2", "the parts of 2 are 1/2 to 2/2"),
        ("--shard 0/3", "the parts of 3 are 1/3 to 3/3"),
        ("--shard 0/0", "there cannot be 0 parts; 1/1 is the whole"),
        ("--shard two", "must be I/N, part I of N, such as 2/5"),
        ("--points other", "other/thesis.txt: is not a point of the study `figures/1`\n  help: "),
        ("--points rubbish", "rubbish/fig3-printed-2mm.json: EOF while parsing"),
        ("--points rubbish", "\n  help: remove it, or empty the folder"),
        ("--points p --from other", "other/thesis.txt: is not a point of the study"),
        ("--points p --from rubbish", "fig3-printed-2mm.json: EOF while parsing"),
        ("--points p --from nowhere", "nowhere: cannot be read as a folder of points"),
        ("--points file", "file: cannot be made a folder of points; name another by --points"),
        ("--points p --out file", "file: cannot be made a folder"),
    ] {
        let ended = study(folder.path(), arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{arguments}");
        assert!(ended.stderr.contains(says), "{arguments}: {}", ended.stderr);
    }
}
