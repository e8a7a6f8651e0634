//! The command with other laws than (7): formats, plans, evaluations worked by hand, and ends.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;

use cli_support::{assert_snapshot, crossfibre, scenes};
use serde_json::{Value, json};

/// The shipped scenes of other laws.
const LAWS: [&str; 6] =
    ["softening", "hardening", "viscoelastic", "eyring", "artificial-viscosity", "slack"];

fn scene(name: &str) -> Value {
    let text = fs::read_to_string(scenes().join(name).with_extension("json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// A scene in a folder of its own.
fn folder(scene: &Value) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.json"), scene.to_string()).unwrap();
    folder
}

/// Asserts that values keep to a schema of the command, and a changed one does not.
fn keep_to_schema<'a>(name: &str, values: impl Iterator<Item = (&'a str, Value)>) {
    let schema = crossfibre(&scenes(), &["schema", name]).stdout;
    let mut compiler = boon::Compiler::new();
    let mut schemas = boon::Schemas::new();
    compiler.add_resource("schema.json", serde_json::from_str(&schema).unwrap()).unwrap();
    let compiled = compiler.compile("schema.json", &mut schemas).unwrap();
    for (law, mut value) in values {
        if let Err(error) = schemas.validate(&value, compiled) {
            panic!("{name} {law}: {error:#}");
        }
        value["primary"]["more"] = json!(0.37);
        value["primary"]["strain"] = json!("much");
        assert!(schemas.validate(&value, compiled).is_err(), "{name} {law}");
    }
}

#[test]
fn scenes_and_results_of_every_law_keep_to_their_schemas() {
    keep_to_schema("scene", LAWS.into_iter().map(|law| (law, scene(law))));
    let results = LAWS.into_iter().map(|law| {
        let ended = crossfibre(&scenes(), &["run", &format!("{law}.json"), "--json"]);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{law}");
        let result: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_eq!(result["outcome"]["kind"], "completed");
        (law, result)
    });
    let (broken, results): (Vec<_>, Vec<_>) = (ends(), results.collect());
    let broken = broken.into_iter().map(|(name, scene)| {
        let ended = crossfibre(folder(&scene).path(), &["run", "scene.json", "--json"]);
        assert_eq!(ended.code, 3, "{name}");
        let result: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_ne!(result["outcome"]["kind"], "completed");
        (name, result)
    });
    keep_to_schema("result", results.into_iter().chain(broken));
}

/// Scenes that the laws break off.
fn ends() -> Vec<(&'static str, Value)> {
    let mut hardens = scene("hardening");
    hardens["primary"]["material"] =
        json!({"law": "polynomial", "coefficients": [57.9e9, 1.93e12]});
    hardens["courant"] = json!(0.83);
    let mut softens = hardens.clone();
    softens["primary"]["material"]["coefficients"] = json!([57.9e9, -2.1e12]);
    let mut literal = scene("viscoelastic");
    literal["primary"]["material"]["update"] = json!("literal");
    literal["primary"]["material"]["arms"][0]["relaxation_time"] = json!(0.13e-6);
    let mut viscous = scene("artificial-viscosity");
    viscous["courant"] = json!(0.87);
    let mut slack = scene("slack");
    (slack["courant"], slack["duration"]) = (json!(0.87), json!(500e-6));
    vec![
        ("courant-exceeded", hardens),
        ("no-waves", softens),
        ("literal-update", literal),
        ("viscous-limit", viscous),
        ("slack-unstable", slack),
    ]
}

#[test]
fn a_run_that_a_law_breaks_off_says_why_and_what_to_try() {
    let mut seen = String::new();
    for (name, scene) in ends() {
        let ended = crossfibre(folder(&scene).path(), &["run", "scene.json", "--quiet"]);
        seen += &format!("{name}: {}\n", ended.seen());
    }
    assert_snapshot("run-ended-by-laws", &seen);
}

#[test]
fn a_plan_names_the_law_and_the_limit_that_viscosity_puts_on_the_step() {
    let viscous = ends().into_iter().find(|(name, _)| *name == "viscous-limit").unwrap().1;
    let mut seen = crossfibre(folder(&viscous).path(), &["plan", "scene.json"]).seen();
    seen += &crossfibre(&scenes(), &["plan", "viscoelastic.json"]).seen();
    assert_snapshot("plan-laws", &seen);
}

#[test]
fn a_run_of_a_law_ends_in_a_summary() {
    for scene in ["softening", "viscoelastic", "slack"] {
        let ended = crossfibre(&scenes(), &["run", &format!("{scene}.json")]);
        assert_snapshot(&format!("run-{scene}"), &ended.seen());
    }
}

#[test]
fn the_tension_of_a_law_is_worked_as_by_hand() {
    let choice = ["--worked", "--eq", "7", "--step", "60", "--index", "40"];
    let worked = |scene: &str| {
        let ended = crossfibre(&scenes(), &[&["trace", scene], &choice[..]].concat());
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{scene}");
        assert!(ended.stdout.contains("the same to the last bit"), "{}", ended.stdout);
        ended.stdout
    };
    assert_snapshot("worked-viscoelastic-eqn-7", &worked("viscoelastic.json"));
    // The strain of the material, and the law's own numbers, are inputs too.
    assert_snapshot("worked-softening-eqn-7", &worked("softening.json"));
}
