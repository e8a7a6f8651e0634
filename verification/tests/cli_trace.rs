//! `crossfibre trace`: lines that keep to their type, evaluations worked by hand, and choices that
//! come to nothing.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;

use cli_support::{Ended, assert_snapshot, crossfibre, scenes};
use crossfibre_verification::trace_line::TraceLine;

#[test]
fn equations_are_worked_as_by_hand() {
    let worked = |scene: &str, choice: &[&str]| {
        let ended = crossfibre(&scenes(), &[&["trace", scene, "--worked"], choice].concat());
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
        ended.stdout
    };
    let at_front = ["--step", "57", "--index", "50", "--eq", "4", "--fibre", "primary"];
    assert_snapshot("worked-fig3-eqn-4", &worked("fig3.json", &at_front));
    let at_crossover = ["--step", "57", "--eq", "17"];
    assert_snapshot("worked-fig3-eqn-17", &worked("fig3.json", &at_crossover));
    let printed = ["--step", "57", "--eq", "16,17"];
    assert_snapshot("worked-fig3-printed-eqns-16-17", &worked("fig3-printed.json", &printed));
    let vectors = ["--step", "61", "--index", "1", "--eq", "2,6", "--fibre", "secondary"];
    assert_snapshot("worked-unequal-eqns-2-6", &worked("unequal.json", &vectors));
}

/// Every line of every equation, by an evaluator that shares nothing with the scheme. The printed
/// (11) alone may differ, by the rounding of tan⁻¹, sine and cosine.
#[test]
fn the_lines_of_every_equation_give_what_the_march_gave() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join("unequal.json")).unwrap();
    for (corrections, strain) in [("all", "incremental"), ("none", "engineering")] {
        let text = text
            .replace("\"corrections\": \"all\"", &format!("\"corrections\": \"{corrections}\""))
            .replace("\"incremental\"", &format!("\"{strain}\""));
        fs::write(folder.path().join("scene.json"), text).unwrap();
        let choice = ["trace", "scene.json", "--worked", "--step", "1..70"];
        let ended = crossfibre(folder.path(), &choice);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        let verdicts = ended.stdout.lines().filter(|line| line.starts_with("  traced "));
        let (same, other): (Vec<_>, Vec<_>) =
            verdicts.partition(|line| line.ends_with("the same to the last bit"));
        // 70 steps of (9)–(14) on one node, and thousands of the rest.
        assert!(same.len() > 10_000, "{} verdicts", same.len());
        assert!(other.len() <= 70, "{other:?}");
        assert!(corrections == "none" || other.is_empty(), "{other:?}");
    }
}

#[test]
fn lines_are_chosen_by_step_index_fibre_and_equation() {
    let choice = "trace fig3.json --step 3..4 --node 1..2 --fibre primary --eq 4,6,7";
    let ended = crossfibre(&scenes(), &choice.split(' ').collect::<Vec<_>>());
    assert_eq!(ended.code, 0);
    let (header, events) = ended.stdout.split_once('\n').unwrap();
    assert!(header.starts_with("{\"format\":\"crossfibre-trace/1\""), "{header}");
    assert_snapshot("trace-fig3", events);
}

#[test]
fn every_line_is_of_the_type_that_the_schema_describes() {
    for scene in ["unequal", "both-at-origin", "viscoelastic"] {
        let file = format!("{scene}.json");
        let ended = crossfibre(&scenes(), &["trace", &file, "--step", "1..60"]);
        let mut lines = ended.stdout.lines().map(|line| {
            serde_json::from_str::<TraceLine>(line).unwrap_or_else(|e| panic!("{e}: {line}"))
        });
        let Some(TraceLine::Header(header)) = lines.next() else { panic!("no header") };
        let text = fs::read_to_string(scenes().join(&file)).unwrap();
        assert_eq!(header.scene, crossfibre::scene_file::read(&text).unwrap());
        assert_eq!(header.equations.len(), 20);
        let known = |name: &str| header.symbols.iter().any(|symbol| symbol.name == name);
        let mut events = 0;
        for line in lines {
            let TraceLine::Event(event) = line else { panic!("a second header") };
            let unknown: Vec<_> = event.inputs.keys().filter(|name| !known(name)).collect();
            assert!(unknown.is_empty(), "({}) {unknown:?}", event.eq);
            events += 1;
        }
        // Steps 1 to 60 visit 1 + 2 + … + 60 elements of the primary, by four equations or more.
        assert!(events > 4 * 1830, "{scene}: {events}");
    }
}

#[test]
fn a_choice_that_comes_to_nothing_says_why_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("trace.jsonl");
    let mut seen = String::new();
    for choice in [
        "fig3.json --step 500",
        "fig3.json --step 0",
        "fig3.json --step 9..3",
        "fig3.json --step three",
        "fig3.json --index 151",
        "fig3.json --step 7 --index 140",
        "fig3.json --step 3 --eq 17",
        "fig3.json --eq 8",
        "fig3.json --eq 1,20",
        "fig3.json --eq 21",
        "fig3.json --fibre third",
        "single-400.json --fibre secondary",
        "single-400.json --eq 17 --worked",
    ] {
        let choice: Vec<_> = choice.split(' ').collect();
        let file = ["-o", out.to_str().unwrap()];
        for output in [&[][..], &file] {
            let ended = crossfibre(&scenes(), &[&["trace"], &choice[..], output].concat());
            assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{choice:?}");
            if output.is_empty() {
                let message = ended.stderr.replace("\n\nFor more information, try '--help'.", "");
                seen += &format!("trace {}\n{message}\n", choice.join(" "));
            }
        }
    }
    assert_snapshot("trace-nothing", &seen);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// It is the work up to the last step that counts: 287 km of travel, 10¹² steps.
#[test]
fn the_first_steps_of_a_run_of_hours_are_traced_and_the_last_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join("fig3.json")).unwrap();
    fs::write(folder.path().join("scene.json"), text.replacen("28.7e-6", "287e3", 1)).unwrap();
    let traced = |step: &str| {
        crossfibre(folder.path(), &["trace", "scene.json", "--step", step, "--eq", "4"])
    };
    let of_fig3 = crossfibre(&scenes(), &["trace", "fig3.json", "--step", "3", "--eq", "4"]);
    let events =
        |ended: &Ended| ended.stdout.lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
    let first = events(&traced("3"));
    assert!(!first.is_empty());
    assert_eq!(first, events(&of_fig3));
    let last = traced("900000000000");
    assert_eq!((last.code, last.stdout.as_str()), (1, ""));
    assert!(last.stderr.ends_with("help: choose an earlier --step\n"), "{}", last.stderr);
}

#[test]
fn a_trace_of_a_run_that_diverges_is_written_up_to_there() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join("single-400.json")).unwrap();
    let text = text
        .replace("\"courant\": 1.0", "\"courant\": 1.7")
        .replace("28.7e-6", "370e-6")
        .replace("incremental", "engineering");
    fs::write(folder.path().join("scene.json"), text).unwrap();
    let choice = ["trace", "scene.json", "--index", "1", "--eq", "2", "-o", "trace.jsonl"];
    let ended = crossfibre(folder.path(), &choice);
    assert_eq!(ended.code, 3, "{}", ended.stderr);
    assert!(ended.stderr.starts_with("diverged: "), "{}", ended.stderr);
    let trace = fs::read_to_string(folder.path().join("trace.jsonl")).unwrap();
    assert!(trace.lines().count() > 10);
    assert!(trace.lines().all(|line| serde_json::from_str::<TraceLine>(line).is_ok()));
}
