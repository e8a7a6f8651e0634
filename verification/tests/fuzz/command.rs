//! Spoilt files given to the command itself: it ends by itself, with a documented exit code, and says
//! why.

use std::fs;
use std::path::Path;

use crossfibre::plan::Plan;
use crossfibre::scene_file::read_bytes;

use super::cli_support::crossfibre;
use super::corpus::Corpus;
use super::readers::{READERS, Reader};
use super::{mutate, random};

/// Files for each kind of command.
const FILES: u64 = 50;

fn reader(name: &str) -> &'static Reader {
    READERS.iter().find(|reader| reader.name == name).unwrap()
}

/// The command ends with one of these codes, and with words where there is something to say.
fn ends(folder: &Path, arguments: &[&str], codes: &[i32], input: &str) -> i32 {
    // A command that a signal has ended has no code, and the support panics.
    let ended = crossfibre(folder, arguments);
    let told = format!("{input}: {arguments:?}\n{}", ended.seen());
    assert!(codes.contains(&ended.code), "{told}");
    match ended.code {
        0 => {}
        4 => assert!(!ended.stdout.is_empty(), "{told}"),
        1 => assert!(ended.stderr.starts_with("error: ") && ended.stdout.is_empty(), "{told}"),
        _ => assert!(!ended.stderr.trim().is_empty(), "{told}"),
    }
    ended.code
}

#[test]
fn commands_that_read_a_scene_end_with_a_documented_code() {
    let folder = tempfile::tempdir().unwrap();
    let corpus = Corpus::of(reader("scene"));
    let mut seen = [0; 4];
    for number in 0..FILES {
        let (_, bytes) = mutate::mutated(&corpus, &mut random("command-scene", number));
        fs::write(folder.path().join("s.json"), &bytes).unwrap();
        let input = String::from_utf8_lossy(&bytes);
        let plan = read_bytes(&bytes).ok().map(|scene| Plan::of(&scene));
        // Longer ones are run, too, by whoever asks for it.
        let is_short = plan.is_none_or(|plan| plan.element_steps < 1e6 && plan.memory < 1e8);
        let mut ends = |arguments: &[&str], codes: &[i32]| {
            seen[ends(folder.path(), arguments, codes, &input) as usize] += 1;
        };
        ends(&["plan", "s.json"], &[0, 1]);
        if is_short {
            ends(&["run", "s.json"], &[0, 1, 3]);
            ends(&["trace", "s.json", "--step", "2"], &[0, 1, 3]);
            ends(&["exact", "s.json"], &[0, 1, 3]);
        }
    }
    assert!(seen[0] > 10 && seen[1] > 20 && seen[3] > 0, "{seen:?}");
}

#[test]
fn a_comparison_of_traces_ends_with_a_documented_code() {
    let folder = tempfile::tempdir().unwrap();
    let corpus = Corpus::of(reader("trace"));
    let mut seen = [0; 5];
    for number in 0..FILES {
        let (origin, bytes) = mutate::mutated(&corpus, &mut random("command-trace", number));
        fs::write(folder.path().join("a"), &corpus.files[origin]).unwrap();
        fs::write(folder.path().join("b"), &bytes).unwrap();
        let input = String::from_utf8_lossy(&bytes);
        seen[ends(folder.path(), &["diff", "a", "b"], &[0, 1, 4], &input) as usize] += 1;
    }
    assert!(seen[1] > 5 && seen[4] > 1, "{seen:?}");
}

/// The candidate says hello as it should and answers every question with the same rubbish.
#[test]
#[cfg(unix)]
fn a_candidate_that_answers_rubbish_does_not_conform() {
    let folder = tempfile::tempdir().unwrap();
    let [hello, answer] = ["hello", "answer"].map(|name| Corpus::of(reader(name)));
    for number in 0..FILES {
        let mut random = random("command-answer", number);
        let (_, rubbish) = mutate::mutated(&answer, &mut random);
        // Every other one has its hello spoilt, too.
        let hello = match number % 2 {
            0 => hello.files[0].clone(),
            _ => mutate::mutated(&hello, &mut random).1,
        };
        fs::write(folder.path().join("hello"), hello).unwrap();
        fs::write(folder.path().join("rubbish"), &rubbish).unwrap();
        let candidate = "read -r q; cat hello; while read -r q; do cat rubbish; echo; done";
        let arguments =
            ["conform", "--filter", "drawn-1", "--timeout", "20", "--", "sh", "-c", candidate];
        ends(folder.path(), &arguments, &[1, 4], &String::from_utf8_lossy(&rubbish));
    }
}
