//! Bad input: a message with file, line, column and path, exit code 1, and nothing written.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;

use cli_support::{assert_snapshot, crossfibre, scenes};

/// What is replaced in the scene of unequal fibres, by what.
const BAD: &[(&str, &str)] = &[
    ("\"courant\"", "\"courrant\""),
    ("\"density\": 973.0,", ""),
    ("0.2871", "\"0.2871\""),
    ("0.2871", "-0.2871"),
    ("0.2871", "NaN"),
    ("0.2871", "1e999"),
    ("139", "1"),
    ("139", "13.9"),
    ("0.87e-6", "0.0"),
    ("71.3e9", "-71.3e9"),
    ("0.0773", "0.31"),
    ("0.73", "1.73"),
    ("0.00091", "0"),
    ("0.00091", "null"),
    ("0.937", "0.0"),
    ("31.3e-6", "31.3e-16"),
    ("\"all\"", "[\"crossover-inertia\", \"perpendicular-sing\"]"),
    ("\"linear\"", "\"liner\""),
    ("crossfibre-scene/1", "crossfibre-scene/7"),
    ("\"secondary\": {", "\"secondary\": {{"),
    ("0.2871", "287.1 mm"),
    ("0.2871", "\"287.1 mm\""),
    ("0.2871", "0,2871"),
    ("\"mass\"", "\"velocity\""),
    ("\"all\"", "\"all\","),
    ("\"courant\"", "// Courant's number\n  \"courrant\""),
    ("\"courant\"", "/* Courant's number */ \"courant\""),
    ("\"format\"", "\"$schema\": 7, \"format\""),
];

#[test]
fn bad_input_is_refused_with_its_place_and_nothing_is_written() {
    let good = fs::read_to_string(scenes().join("unequal.json")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let in_folder = |name: &str| folder.path().join(name);
    fs::write(in_folder("old.json"), "old").unwrap();
    let mut seen = String::new();
    for &(from, to) in BAD {
        assert!(good.contains(from), "{from}");
        fs::write(in_folder("scene.json"), good.replacen(from, to, 1)).unwrap();
        for command in [
            &["run", "scene.json", "-o", "new.json"][..],
            &["run", "scene.json", "-o", "old.json"],
            &["trace", "scene.json", "-o", "new.json"],
            &["plan", "scene.json", "-o", "new.json"],
            &["run", "scene.json", "--json"],
        ] {
            let ended = crossfibre(folder.path(), command);
            assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{to}: {command:?}");
            let (told, shown) = ended.stderr.split_once("\n").unwrap();
            assert!(
                told.starts_with("error: ") && shown.contains("--> scene.json:"),
                "{}",
                ended.stderr
            );
            assert!(!ended.stderr.contains('\u{1b}'), "colours where there is no terminal");
            if command[1..] == ["scene.json", "--json"] {
                seen += &format!("{from} -> {to}\n{}\n", ended.stderr);
            }
        }
    }
    assert_snapshot("bad-input", &seen);
    assert_eq!(fs::read_to_string(in_folder("old.json")).unwrap(), "old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn what_is_no_scene_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("latin-1.json"), b"{\n  \"title\": \"28.7 \xB5s\"\n}").unwrap();
    fs::write(folder.path().join("empty.json"), "").unwrap();
    fs::write(folder.path().join("mark.json"), "\u{FEFF}{}").unwrap();
    fs::write(folder.path().join("utf-16.json"), b"\xFF\xFE{\0}\0").unwrap();
    fs::write(folder.path().join("words.json"), "primary:\n  length: 0.2871\n").unwrap();
    fs::write(folder.path().join("list.json"), "[{}]").unwrap();
    fs::write(folder.path().join("deep.json"), "{\"a\":".repeat(200)).unwrap();
    fs::create_dir(folder.path().join("folder")).unwrap();
    fs::copy(scenes().join("fig3.json"), folder.path().join("fig3.json")).unwrap();
    let mut seen = String::new();
    for command in [
        "run nowhere.json",
        "run folder",
        "run latin-1.json",
        "run empty.json",
        "run mark.json",
        "run utf-16.json",
        "run words.json",
        "run list.json",
        "run deep.json",
        "run -",
        "run fig3.json -o folder",
        "run fig3.json -o nowhere/result.json",
        "trace fig3.json -o nowhere/trace.jsonl",
        "schema scene -o folder",
    ] {
        let ended = crossfibre(folder.path(), &command.split(' ').collect::<Vec<_>>());
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{command}");
        seen += &format!("{command}\n{}\n", ended.stderr);
    }
    assert_snapshot("no-scene-file", &seen);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 9);
}
