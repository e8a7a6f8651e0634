//! Reports of a record that was made up, and the pictures of today's, are what they were when people last
//! looked at them.

#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use cli_support::assert_snapshot_in;
use crossfibre_verification::bits::fnv;
use crossfibre_verification::pictures;
use crossfibre_verification::precision::answer::wanted;
use crossfibre_verification::record::{Build, Record, made_up};
use crossfibre_verification::report::{self, html};

/// Every verdict, every kind of bound, names that are hostile, and what fails.
#[test]
fn the_files_of_a_made_up_record_are_as_they_were() {
    let record = Record {
        build: Build {
            compiler: "rustc".into(),
            commit: Some("0123abc".into()),
            ..Build::default()
        },
        cost: wanted::stored(),
        left_out: vec!["axial.impact".into()],
        ..made_up::record()
    };
    for (name, text) in report::files(&record) {
        // An element a line, so that a difference can be read.
        assert_snapshot_in("report", name, &text.replace("><", ">\n<"));
    }
    let passing = Record { build: Build::default(), ..made_up::passing() };
    for (name, text) in report::files(&passing) {
        assert_snapshot_in("report", &format!("passing-{name}"), &text.replace("><", ">\n<"));
    }
}

/// By a number for each: drawings are large. Look at one that has changed in
/// `target/verification/report.html`, which `verify` writes.
#[test]
fn the_pictures_are_as_they_were_looked_at() {
    let mut lines = String::new();
    for picture in pictures::all() {
        let words = serde_json::to_string(&picture).unwrap();
        lines += &format!("{} {:016x}\n", picture.id, fnv(words.bytes()));
    }
    let moving = Record { motion: Some(pictures::motion::fig3()), ..made_up::passing() };
    let page = html::render(&Record { build: Build::default(), ..moving });
    lines += &format!("moving {:016x}\n", fnv(page.bytes()));
    assert_snapshot_in("report", "pictures", &lines);
}
