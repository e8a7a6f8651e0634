//! What helps to write a scene: a scene to start from, the schema, completions and manual pages.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;

use cli_support::{crossfibre, scenes};
use serde_json::{Value, json};

#[test]
fn every_kind_of_scene_is_planned_and_runs_to_its_end() {
    let folder = tempfile::tempdir().unwrap();
    let list = crossfibre(folder.path(), &["new", "--list"]).stdout;
    let kinds: Vec<_> = list.lines().map(|line| line.split(' ').next().unwrap()).collect();
    assert_eq!(kinds.len(), 6);
    for kind in kinds {
        let file = format!("{kind}.jsonc");
        let written = crossfibre(folder.path(), &["new", kind, "-o", &file]);
        assert_eq!((written.code, written.stderr.as_str()), (0, ""));
        assert!(written.stdout.contains(&format!("crossfibre run {file}")), "{}", written.stdout);
        let text = fs::read_to_string(folder.path().join(&file)).unwrap();
        assert_eq!(crossfibre(folder.path(), &["new", kind]).stdout, text);
        assert!(text.matches("//").count() > 5, "{text}");
        for command in ["plan", "run"] {
            let ended = crossfibre(folder.path(), &[command, &file]);
            assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{command} {file}");
        }
    }
}

#[test]
fn a_file_that_is_there_is_not_written_over() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.json"), "mine").unwrap();
    let ended = crossfibre(folder.path(), &["new", "-o", "scene.json"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stderr.starts_with("error: scene.json: is there already"), "{}", ended.stderr);
    assert_eq!(fs::read_to_string(folder.path().join("scene.json")).unwrap(), "mine");
}

fn shipped(name: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(scenes().join(name)).unwrap()).unwrap()
}

/// What is changed in the scene of unequal fibres, by a pointer; the schema alone must refuse it.
#[rustfmt::skip] // a case a line
fn bad() -> Vec<(&'static str, Value)> {
    vec![
        ("/format", json!("crossfibre-scene/2")),
        ("/primary/length", json!(0)),
        ("/primary/elements", json!(1)),
        ("/primary/elements", json!(17.3)),
        ("/primary/density", json!("1443 kg/m3")),
        ("/primary/area", json!(-1e-6)),
        ("/primary/material/law", json!("liner")),
        ("/primary/material/modulus", json!(0.0)),
        ("/primary/material/coefficients", json!([1e9])),
        ("/secondary/at", json!(-0.1)),
        ("/secondary/slide_factor", json!(1.1)),
        ("/secondary/slidefactor", json!(0.7)),
        ("/projectile/velocity", json!(0)),
        ("/projectile/mass", json!(null)),
        ("/courant", json!(0)),
        ("/duration", json!(-1e-6)),
        ("/strain", json!("true")),
        ("/corrections", json!("some")),
        ("/corrections", json!(["perpendicular-sing"])),
        ("/$schema", json!(7)),
        ("/comment", json!("mine")),
    ]
}

#[test]
fn an_editor_with_the_schema_takes_shipped_scenes_and_refuses_bad_ones() {
    let schema = crossfibre(&scenes(), &["schema", "scene"]).stdout;
    let (mut compiler, mut schemas) = (boon::Compiler::new(), boon::Schemas::new());
    compiler.add_resource("scene.json", serde_json::from_str(&schema).unwrap()).unwrap();
    let compiled = compiler.compile("scene.json", &mut schemas).unwrap();
    let mut count = 0;
    for entry in fs::read_dir(scenes()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let mut scene = shipped(&name);
        scene["$schema"] = json!("./scene.schema.json");
        if let Err(error) = schemas.validate(&scene, compiled) {
            panic!("{name}: {error:#}");
        }
        count += 1;
    }
    assert!(count >= 15);
    for (pointer, value) in bad() {
        let mut scene = shipped("unequal.json");
        let (parent, name) = pointer.rsplit_once('/').unwrap();
        scene.pointer_mut(parent).unwrap()[name] = value.clone();
        assert!(schemas.validate(&scene, compiled).is_err(), "{pointer} {value}");
        let reader = crossfibre::scene_file::read(&scene.to_string());
        assert!(reader.is_err(), "the reader takes {pointer} {value}");
    }
}

#[test]
fn the_schema_tells_an_editor_what_each_field_is() {
    let schema = crossfibre(&scenes(), &["schema", "scene"]).stdout;
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let primary = &schema["$defs"]["Primary"]["properties"];
    assert_eq!(primary["length"]["exclusiveMinimum"], 0);
    assert_eq!(primary["elements"]["minimum"], 2);
    assert!(primary["density"]["description"].as_str().unwrap().contains("kg/m³"));
    assert_eq!(schema["properties"]["strain"]["default"], "incremental");
    let laws = schema["$defs"]["Material"]["oneOf"].as_array().unwrap();
    let titles: Vec<_> = laws.iter().map(|law| law["title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["linear", "polynomial", "exponential", "viscoelastic", "eyring"]);
}

#[test]
fn completions_and_manual_pages_know_every_command() {
    let folder = tempfile::tempdir().unwrap();
    for (shell, part) in [
        ("bash", "complete -F _crossfibre"),
        ("zsh", "#compdef crossfibre"),
        ("fish", "complete -c crossfibre"),
    ] {
        let ended = crossfibre(folder.path(), &["completions", shell]);
        assert!(ended.code == 0 && ended.stdout.contains(part), "{shell}");
        assert!(ended.stdout.contains("accuracy"), "{shell}: an option of `plan`");
    }
    let page = crossfibre(folder.path(), &["man"]).stdout;
    assert!(page.contains(".TH crossfibre 1"), "{page}");
    assert_eq!(crossfibre(folder.path(), &["man", "--out", "man"]).code, 0);
    for page in ["crossfibre.1", "crossfibre-run.1", "crossfibre-study-work-precision.1"] {
        let text = fs::read_to_string(folder.path().join("man").join(page)).unwrap();
        assert!(
            text.contains(".SH SYNOPSIS") && text.contains(" 1 \" \" \"crossfibre 0."),
            "{page}"
        );
        assert!(!text.contains("help(1)"), "{page}: a page that is not there");
    }
}
