//! `crossfibre plan`, `crossfibre schema`, and the help.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::collections::BTreeSet;
use std::fs;

use cli_support::{assert_snapshot, crossfibre, scenes};
use serde_json::Value;

#[test]
fn a_plan_says_which_equations_run_and_why() {
    for scene in ["unequal", "single-400"] {
        let ended = crossfibre(&scenes(), &["plan", &format!("{scene}.json")]);
        assert_snapshot(&format!("plan-{scene}"), &ended.seen());
    }
}

/// A straight answer, one where nothing is exact, and one where every trial run fails.
#[test]
fn a_plan_says_what_an_accuracy_takes() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(scenes().join("artificial-viscosity.json")).unwrap();
    let fails = folder.path().join("fails.json");
    fs::write(&fails, text.replace("\"courant\": 0.7", "\"courant\": 0.95")).unwrap();
    for (name, scene) in [
        ("single-400", "single-400.json"),
        ("hardening", "hardening.json"),
        ("fails", fails.to_str().unwrap()),
    ] {
        let ended = crossfibre(&scenes(), &["plan", scene, "--accuracy", "1.5e-2"]);
        assert_snapshot(&format!("plan-accuracy-{name}"), &ended.seen());
    }
    for size in ["0", "1", "-1e-3", "NaN", "inf", "1e-13", "fine", "1%"] {
        let ended = crossfibre(&scenes(), &["plan", "fig3.json", &format!("--accuracy={size}")]);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{size}");
        assert!(ended.stderr.contains("from 1e-12 to below 1, such as 1e-3"), "{}", ended.stderr);
    }
}

fn keys(json: &Value) -> BTreeSet<String> {
    json.as_object().unwrap().keys().cloned().collect()
}

/// A schema that forgets a field or names one that is not written is wrong.
#[test]
fn a_schema_has_the_fields_that_are_written() {
    let json = |arguments: &[&str]| {
        let ended = crossfibre(&scenes(), arguments);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
        serde_json::from_str::<Value>(&ended.stdout).unwrap()
    };
    let scene = fs::read_to_string(scenes().join("unequal.json")).unwrap();
    let mut scene: Value = serde_json::from_str(&scene).unwrap();
    // What a scene may have beside.
    scene["$schema"] = "scene.schema.json".into();
    let event = crossfibre(&scenes(), &["trace", "unequal.json", "--step", "1", "--eq", "8"]);
    let event: Value = serde_json::from_str(event.stdout.lines().nth(1).unwrap()).unwrap();
    let trace_schema = json(&["schema", "trace"]);
    for (written, schema) in [
        (scene, &json(&["schema", "scene"])),
        (json(&["run", "unequal.json", "--json"]), &json(&["schema", "result"])),
        (
            json(&["plan", "hardening.json", "--accuracy", "0.03", "--json"]),
            &json(&["schema", "plan"]),
        ),
        (event, &trace_schema["$defs"]["Event"]),
    ] {
        assert_eq!(keys(&written), keys(&schema["properties"]));
    }
}

#[test]
fn the_help_tells_the_exit_codes_and_bad_usage_has_code_1() {
    let help = crossfibre(&scenes(), &["--help"]);
    assert_eq!((help.code, help.stderr.as_str()), (0, ""));
    for code in [
        "   0  all well",
        "   1  bad input",
        "   3  the run diverged",
        "  70  a fault",
        " 130  interrupted",
    ] {
        assert!(help.stdout.contains(code), "{}", help.stdout);
    }
    assert_eq!(crossfibre(&scenes(), &["--version"]).code, 0);
    for usage in [&[][..], &["run"], &["rum", "fig3.json"], &["plan", "fig3.json", "--force"]] {
        let ended = crossfibre(&scenes(), usage);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{usage:?}");
    }
}
