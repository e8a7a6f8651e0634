//! What people are shown of a run, of every shipped scene: the summary, and by a number for each the
//! drawing, which `crossfibre plot` makes of the result.

mod cli_support;

use std::fmt::Write;

use cli_support::assert_snapshot_in;
use crossfibre_verification::bits::fnv;
use crossfibre_verification::cases::support::{SCENES, shipped};
use crossfibre_verification::summary::Summary;
use crossfibre_verification::{result_plot, wide};

#[test]
fn summaries_and_drawings_are_as_they_were_looked_at() {
    let (mut summaries, mut drawings) = (String::new(), String::new());
    for (name, _) in SCENES {
        let scene = shipped(name);
        let result = wide::run(&scene, |_| {});
        let summary = Summary { scene: &scene, result: &result };
        writeln!(summaries, "{name}\n\n{summary}").expect("a string takes everything");
        let drawing = fnv(result_plot::picture(&result).bytes());
        writeln!(drawings, "{name} {drawing:016x}").expect("a string takes everything");
    }
    assert_snapshot_in("runs", "summaries", &summaries);
    assert_snapshot_in("runs", "drawings", &drawings);
}
