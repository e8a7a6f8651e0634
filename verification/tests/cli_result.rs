//! Results for other programs, and as a picture.
#![allow(clippy::unwrap_used)] // a test may

mod cli_support;

use std::fs;
use std::path::Path;

use cli_support::{crossfibre, scenes};

/// A run of a shipped scene into a file of a folder.
fn run(folder: &Path, arguments: &[&str]) -> cli_support::Ended {
    let scene = scenes().join("unequal.json");
    crossfibre(folder, &[&["run", scene.to_str().unwrap()], arguments].concat())
}

#[test]
fn the_ending_of_the_file_or_the_option_chooses_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(run(folder.path(), &["-o", "result.CSV"]).code, 0);
    let table = read("result.CSV");
    assert!(table.starts_with("fibre,index,node place [m],x [m],"), "{table}");
    assert_eq!(run(folder.path(), &["--format", "csv"]).stdout, table);
    assert_eq!(run(folder.path(), &["--format", "csv", "-o", "result.txt"]).code, 0);
    assert_eq!(read("result.txt"), table);
    assert_eq!(run(folder.path(), &["-o", "result.dat"]).code, 0);
    assert_eq!(read("result.dat"), run(folder.path(), &["--format", "json"]).stdout);
}

#[cfg(not(feature = "npz"))]
#[test]
fn a_format_that_was_not_built_is_told_before_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let ended = run(folder.path(), &["-o", "result.npz"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, ""));
    assert!(ended.stderr.contains("--features npz"), "{}", ended.stderr);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Prints what NumPy has loaded: shapes, and some numbers by their bits.
#[cfg(feature = "npz")]
const LOAD: &str = "
import numpy, sys
with numpy.load(sys.argv[1]) as result:
    for name in sorted(result.files):
        print(name, result[name].dtype.str, result[name].shape)
    print(float(result['secondary_position'][5, 2]).hex())
    print(float(result['primary_tension'][-1]).hex(), float(result['time']).hex())
";

#[cfg(feature = "npz")]
#[test]
fn numpy_loads_every_array() {
    use std::process::Command;

    let folder = tempfile::tempdir().unwrap();
    assert_eq!(run(folder.path(), &["-o", "result.npz"]).code, 0);
    run(folder.path(), &["-o", "result.json"]);
    let python = Command::new("python3")
        .args(["-c", LOAD, "result.npz"])
        .current_dir(folder.path())
        .output();
    let python = match python {
        Ok(output) if !String::from_utf8_lossy(&output.stderr).contains("No module named") => {
            output
        }
        _ => return eprintln!("skipped: there is no python3 with NumPy"),
    };
    let (seen, trouble) =
        (String::from_utf8(python.stdout).unwrap(), String::from_utf8(python.stderr).unwrap());
    assert!(python.status.success(), "{trouble}");
    let text = fs::read_to_string(folder.path().join("result.json")).unwrap();
    let result = crossfibre::result_file::read(&text).unwrap();
    let secondary = result.secondary.as_ref().unwrap();
    for line in [
        "primary_position <f8 (140, 2)".to_owned(),
        "primary_strain <f8 (139,)".to_owned(),
        "secondary_node_place <f8 (98,)".to_owned(),
        "secondary_velocity <f8 (98, 3)".to_owned(),
        "steps <f8 ()".to_owned(),
    ] {
        assert!(seen.contains(&line), "{line} is not in:\n{seen}");
    }
    // Python's hexadecimal digits are those of the double, no rounding between.
    let numbers: Vec<f64> = seen.split_whitespace().filter_map(from_hex).collect();
    let expected = [secondary.position[5][2], *result.primary.tension.last().unwrap(), result.time];
    assert_eq!(numbers.len(), expected.len(), "{seen}");
    assert_eq!(numbers, expected);
}

/// A double as Python writes it, `-0x1.8p+3`.
#[cfg(feature = "npz")]
fn from_hex(text: &str) -> Option<f64> {
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (mantissa, power) = digits.strip_prefix("0x")?.split_once('p')?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let integer = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()? as f64;
    let power: i32 = power.parse().ok()?;
    Some(sign * integer * 2.0_f64.powi(power - 4 * fraction.len() as i32))
}

#[test]
fn a_result_is_drawn_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path(), &["-o", "result.json"]);
    let plot = |arguments: &[&str]| crossfibre(folder.path(), &[&["plot"], arguments].concat());
    let ended = plot(&["result.json"]);
    assert_eq!((ended.code, ended.stdout.as_str(), ended.stderr.as_str()), (0, "result.svg\n", ""));
    let picture = fs::read_to_string(folder.path().join("result.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.contains("tension of the secondary"));
    assert_eq!(plot(&["result.json", "-o", "-"]).stdout, picture);
}

#[test]
fn what_is_no_result_is_told_and_nothing_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).unwrap();
    run(folder.path(), &["-o", "result.json"]);
    run(folder.path(), &["-o", "table.csv"]);
    let result = fs::read(folder.path().join("result.json")).unwrap();
    write("cut.json", &result[..result.len() / 2]);
    write("no-text.json", b"\x93NUMPY\xff");
    fs::copy(scenes().join("fig3.json"), folder.path().join("scene.json")).unwrap();
    fs::create_dir(folder.path().join("folder")).unwrap();
    for (name, message) in [
        ("cut.json", "error: cut.json: the file is cut short\n  help: run the scene again\n"),
        ("table.csv", "error: table.csv: not JSON from line 1, column 2 on"),
        ("scene.json", "this is a scene: `crossfibre run SCENE -o FILE.json` makes a result of it"),
        ("no-text.json", "error: no-text.json: not UTF-8: the byte at offset 0\n  help: "),
        ("nowhere.json", "error: nowhere.json: there is no such file"),
        ("folder", "error: folder: is a directory, not a file"),
    ] {
        let ended = crossfibre(folder.path(), &["plot", name, "-o", "picture.svg"]);
        assert_eq!((ended.code, ended.stdout.as_str()), (1, ""), "{name}");
        assert!(ended.stderr.contains(message), "{name}: {}", ended.stderr);
        assert!(!folder.path().join("picture.svg").exists());
    }
}
