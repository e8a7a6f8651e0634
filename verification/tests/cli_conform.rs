//! `crossfibre conform` against programs that misbehave: each gets its verdict, and none harms the
//! runner.

#![cfg(unix)] // the programs are those of any Unix
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;
use std::time::Instant;

use cli_support::{Ended, assert_snapshot, crossfibre};
use crossfibre_verification::conform::protocol::Question;
use crossfibre_verification::conform::questions;
use crossfibre_verification::conform::record::{Report, Verdict};
use serde_json::json;

/// Judges a shell script, with few questions.
fn judged(script: &str, more: &[&str]) -> Ended {
    let arguments = [&["conform", "--filter", "equation/7/"], more].concat();
    let arguments = [&arguments, &["--", "sh", "-c", script][..]].concat();
    crossfibre(Path::new("."), &arguments)
}

const HELLO: &str = r#"read q; echo '{"id":0,"format":"crossfibre-conformance/1","name":"a"}'; "#;

fn after_hello(script: &str) -> Ended {
    judged(&format!("{HELLO}{script}"), &[])
}

/// Answers (7) by whatever the shell is told to print for a question of the id in `$id`.
fn answering(answer: &str) -> Ended {
    after_hello(&format!(
        r#"while read q; do id=${{q#*:}}; id=${{id%%,*}}; printf '{answer}\n' "$id"; done"#
    ))
}

#[test]
fn every_way_to_break_has_its_words() {
    let cases = [
        ("a program that is not there", {
            crossfibre(Path::new("."), &["conform", "--", "./no-such-program"])
        }),
        ("ends at once", judged("echo there is no licence >&2; exit 3", &[])),
        ("says something else than hello", judged("echo welcome; cat", &[])),
        ("speaks another version", {
            judged(r#"echo '{"id":0,"format":"crossfibre-conformance/7","name":"a"}'; cat"#, &[])
        }),
        ("computes in f32", {
            judged(
                r#"echo '{"id":0,"format":"crossfibre-conformance/1","name":"a","number":"f32"}'; cat"#,
                &[],
            )
        }),
        ("supports nothing that is asked", {
            judged(
                r#"echo '{"id":0,"format":"crossfibre-conformance/1","name":"a","depths":["run"]}'; cat"#,
                &[],
            )
        }),
        ("crashes at each question", after_hello("read q; echo out of memory >&2; kill -SEGV $$")),
        ("is silent", {
            let silent = format!("{HELLO}while read q; do sleep 100; done");
            judged(&silent, &["--timeout", "0.7"])
        }),
        ("closes its output", after_hello("exec >&-; sleep 100")),
        ("gives the question back", after_hello("cat")),
        ("prints no JSON", after_hello("while read q; do echo 0.1; done")),
        ("answers another question", after_hello(r#"while read q; do echo '{"id":99}'; done"#)),
        ("answers nothing", answering(r#"{"id":%s}"#)),
        ("answers with an error", answering(r#"{"id":%s,"error":"not today"}"#)),
        ("answers a vector", answering(r#"{"id":%s,"out":[0.1,0.2]}"#)),
        ("answers what is no number", answering(r#"{"id":%s,"out":"NaN"}"#)),
        ("answers too large a number", answering(r#"{"id":%s,"out":1e400}"#)),
        ("answers zero", answering(r#"{"id":%s,"out":0}"#)),
        ("skips everything", answering(r#"{"id":%s,"skip":"no time"}"#)),
        ("writes bytes that are no text", after_hello(r"read q; printf '\377\376\n'; cat")),
    ];
    let seen = |(name, ended): &(&str, Ended)| {
        // The questions' numbers are those of `equation/7/`, whose order is fixed; times are not said.
        format!("# {name}\n{}\n", ended.seen())
    };
    assert_snapshot("conform-broken", &cases.iter().map(seen).collect::<String>());
    for (name, ended) in &cases {
        assert!(!ended.stderr.contains("fault:"), "{name}");
    }
}

/// Whether the second line is seen before the next question is put or after, there is no answer.
#[test]
fn who_answers_twice_has_broken() {
    let ended = answering(r#"{"id":%s,"out":0}\n{"id":1,"out":0}"#);
    assert_eq!(ended.code, 4);
    let unasked = "a line that nobody asked for";
    let other = "it answers question 1 and was asked 2";
    assert!(ended.stdout.contains(unasked) || ended.stdout.contains(other), "{}", ended.stdout);
}

/// 10 GB without a line break, and lines without end: the runner cuts both off, soon and with little
/// memory.
#[test]
fn output_without_end_is_cut_off() {
    let start = Instant::now();
    let endless = after_hello("head -c 10000000000 /dev/zero");
    assert_eq!(endless.code, 4);
    assert!(endless.stdout.contains("a line of more than 16 MiB"), "{}", endless.stdout);
    let lines = after_hello("yes");
    assert_eq!(lines.code, 4);
    assert!(lines.stdout.contains("not an answer: y"), "{}", lines.stdout);
    // Far more than this takes, far less than 10 GB would at each of five starts.
    assert!(start.elapsed().as_secs() < 60);
}

/// A candidate of a shell that starts another program: both are ended, or the runner would wait.
#[test]
fn what_a_candidate_has_started_is_ended_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let pid = folder.path().join("pid");
    let script = format!("{HELLO}sleep 1000 & echo $! > {}; wait", pid.display());
    assert_eq!(judged(&script, &["--timeout", "0.7"]).code, 4);
    let child = fs::read_to_string(pid).unwrap();
    let alive = || Path::new("/proc").join(child.trim()).exists();
    // Ended processes are cleared away by whoever inherits them, which may take a moment.
    let start = Instant::now();
    while Path::new("/proc").exists() && alive() && start.elapsed().as_secs() < 20 {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let state = fs::read_to_string(format!("/proc/{}/stat", child.trim())).unwrap_or_default();
    assert!(state.is_empty() || state.contains(") Z "), "{state}");
}

#[test]
fn reports_are_written_whole_and_the_json_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let script = format!(
        r#"{HELLO}while read q; do id=${{q#*:}}; id=${{id%%,*}}; echo "{{\"id\":$id,\"out\":0}}"; done"#
    );
    let ended = crossfibre(
        folder.path(),
        &[
            "conform",
            "--filter",
            "equation/7/",
            "--junit",
            "j.xml",
            "--html",
            "h.html",
            "-o",
            "r.json",
            "--",
            "sh",
            "-c",
            &script,
        ],
    );
    assert_eq!(ended.code, 4, "{}", ended.stderr);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let report: Report = serde_json::from_str(&read("r.json")).unwrap();
    assert!(!report.conforms && report.failures().count() > 5);
    let failed = report.failures().count();
    assert_eq!(read("j.xml").matches("<failure").count(), failed);
    assert_eq!(read("h.html").matches("<td class=\"text bad\">").count(), failed);
}

#[test]
fn json_goes_to_standard_output_or_to_the_file_that_is_named_and_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let run = |more: &[&str]| {
        let arguments = [&["conform", "--filter", "equation/7/", "--json"], more].concat();
        let script = format!("{HELLO}while read q; do echo 0.1; done");
        crossfibre(folder.path(), &[&arguments, &["--", "sh", "-c", &script][..]].concat())
    };
    let report = |text: &str| serde_json::from_str::<Report>(text).unwrap();
    let alone = report(&run(&[]).stdout);
    let beside = run(&["-o", "r.json"]);
    let file = report(&fs::read_to_string(folder.path().join("r.json")).unwrap());
    assert_eq!((file.items.len(), file.conforms), (alone.items.len(), false));
    assert!(beside.stdout.ends_with("does not conform\n"), "{}", beside.stdout);
}

/// Every run diverges, if one believes it: two elements of one fibre show that as well. The scene before
/// is of a law that the candidate does not have, and is not asked for.
#[test]
fn the_scene_of_the_first_wrong_run_is_made_smaller_and_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let fibre = json!({"position": [], "velocity": [], "strain": [], "tension": []});
    let projectile = json!({"velocity": 0, "position": 0});
    let result = json!({
        "outcome": {"kind": "diverged"},
        "steps": 0,
        "time_step": 0,
        "primary": fibre,
        "projectile": projectile,
    });
    let id = "id=${q#*:}; id=${id%%,*}";
    let answer = format!(r#"printf '{{"id":%s,"result":{result}}}\n' "$id""#);
    let script = format!("{HELLO}while read q; do {id}; {answer}; done");
    let run = |filter: &str| {
        let arguments = ["conform", "--filter", filter, "--shrink", "small.json", "-o", "r.json"];
        crossfibre(folder.path(), &[&arguments[..], &["--", "sh", "-c", &script]].concat())
    };
    let small = folder.path().join("small.json");

    let ended = run("equation/7/");
    assert_eq!(ended.code, 4);
    assert_eq!(ended.stderr, "no run is wrong: there is no scene to be made smaller\n");
    assert!(!small.exists());

    // Slack fibres, and sliding ones, of 600 elements and 400.
    let ended = run("run/sl");
    assert_eq!(ended.code, 4, "{}", ended.stderr);
    let report = fs::read_to_string(folder.path().join("r.json")).unwrap();
    let report: Report = serde_json::from_str(&report).unwrap();
    let verdicts: Vec<_> = report.items.iter().map(|i| (i.id.as_str(), i.verdict)).collect();
    assert_eq!(verdicts, [("run/slack", Verdict::Skipped), ("run/sliding", Verdict::Wrong)]);
    assert_eq!(ended.stderr, "run/sliding with 2 elements in the place of 1000\n");
    let scene = crossfibre::scene_file::read(&fs::read_to_string(small).unwrap()).unwrap();
    assert_eq!(scene.title, "run/sliding made smaller while a is wrong");
    assert_eq!((scene.primary.elements, scene.secondary), (2, None));
}

/// A name is text, whatever is in it.
#[test]
fn a_hostile_name_is_escaped() {
    let folder = tempfile::tempdir().unwrap();
    let name = r#"<script>alert(1)</script>&"]]>"#;
    let hello = serde_json::json!({"id": 0, "format": "crossfibre-conformance/1", "name": name});
    fs::write(folder.path().join("hello"), format!("{hello}\n")).unwrap();
    let ended = crossfibre(
        folder.path(),
        &[
            "conform",
            "--filter",
            "equation/7/",
            "--junit",
            "j.xml",
            "--html",
            "h.html",
            "--",
            "sh",
            "-c",
            "read q; cat hello; cat",
        ],
    );
    assert_eq!(ended.code, 4);
    for file in ["j.xml", "h.html"] {
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        assert!(!text.contains("<script") && text.contains("&lt;script"), "{file}");
    }
}

/// The workflow that others copy calls this command as it is.
#[test]
fn the_command_of_the_workflow_file_works() {
    let folder = tempfile::tempdir().unwrap();
    let workflow = include_str!("../../docs/workflows/conform.yml");
    let (_, command) = workflow.split_once("/bin/crossfibre ").unwrap();
    let (command, _) = command.split_once(" -- ./my-solver").unwrap();
    let mut arguments: Vec<_> = command.split_whitespace().filter(|word| *word != "\\").collect();
    assert_eq!(arguments[0], "conform");
    let script = format!("{HELLO}while read q; do echo 0.1; done");
    arguments.extend(["--", "sh", "-c", &script]);
    let ended = crossfibre(folder.path(), &arguments);
    assert_eq!(ended.code, 4, "{}", ended.stderr);
    for report in ["conformance.xml", "conformance.html", "conformance.json"] {
        assert!(folder.path().join(report).is_file(), "{report}");
    }
}

/// Questions, and the answers of the protocol's page, are what the schema says.
#[test]
fn questions_and_the_answers_of_the_page_are_valid_by_the_schema() {
    let schema = crossfibre(Path::new("."), &["schema", "conformance"]).stdout;
    let mut schemas = boon::Schemas::new();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("conformance", serde_json::from_str(&schema).unwrap()).unwrap();
    let id = compiler.compile("conformance", &mut schemas).unwrap();
    let check = |message: serde_json::Value| {
        if let Err(error) = schemas.validate(&message, id) {
            panic!("{error:#}\n{message}");
        }
    };
    for (id, item) in questions::all(1).into_iter().enumerate() {
        let id = id as u64 + 1;
        check(serde_json::to_value(Question { id, ask: item.ask }).unwrap());
    }
    let page = include_str!("../../docs/conformance.md");
    let hello = page.split("## `hello`").nth(1).unwrap().split("```").nth(1).unwrap();
    check(serde_json::from_str(hello.trim_start_matches("json")).unwrap());
    for answer in [
        r#"{"id":7,"skip":"no Eyring law"}"#,
        r#"{"id":7,"error":"…"}"#,
        r#"{"id":1,"out":847.9}"#,
        r#"{"id":1,"out":[0.3,"-inf"]}"#,
    ] {
        check(serde_json::from_str(answer).unwrap());
    }
    for bad in [r#"{"out":0.3}"#, r#"{"id":1,"out":"0.3"}"#, r#"{"id":1,"ask":"walk"}"#] {
        let bad: serde_json::Value = serde_json::from_str(bad).unwrap();
        let valid = schemas.validate(&bad, id).is_ok();
        // `ask` is unknown to an answer, and may be there.
        assert_eq!(valid, bad.get("ask").is_some(), "{bad}");
    }
}
