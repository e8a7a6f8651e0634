//! What README.md says is true: its commands run, and its figures are those that are measured.

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use crossfibre::exact::smith::{Law, smith};
use crossfibre_verification::cases::crossover::sideways;
use crossfibre_verification::cases::support::{exact_primary, marched, shipped};
use crossfibre_verification::precision::{answer, stored::stored};

const README: &str = include_str!("../../README.md");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The arguments of each `cargo run --release -- …` of the README.
fn commands() -> Vec<Vec<String>> {
    README
        .lines()
        .filter_map(|line| line.strip_prefix("cargo run --release -- "))
        .map(|line| line.split('#').next().unwrap_or_default())
        .map(|line| line.split_whitespace().map(str::to_owned).collect())
        .collect()
}

#[test]
fn the_commands_run() {
    let folder = tempfile::tempdir().unwrap();
    let mut run = 0;
    for arguments in commands() {
        if matches!(arguments[0].as_str(), "verify" | "conform") {
            continue; // tests/verify.rs runs the one; the other wants programs built beforehand
        }
        let elsewhere = |name: &str| folder.path().join(name).display().to_string();
        let arguments = arguments.iter().map(|argument| match argument.as_str() {
            "my-scene.jsonc" | "result.json" => elsewhere(argument),
            _ => argument.clone(),
        });
        Command::cargo_bin("crossfibre")
            .unwrap()
            .args(arguments)
            .env("TMPDIR", folder.path())
            .current_dir(root())
            .assert()
            .success();
        run += 1;
    }
    assert!(run >= 5, "README.md has lost its tour");
}

#[test]
fn the_figures_are_measured() {
    let says = |text: String| assert!(README.contains(&text), "README.md does not say {text:?}");
    let printed = marched(shipped("fig3-printed"));
    says(format!("sideways at {:.0} m/s", sideways(&printed)));
    let residual = 100.0 * printed.balance.energy.relative_residual();
    says(format!("energy balance is off by\n{residual:.1} %"));
    let wave_speed = exact_primary(&shipped("single-400")).wave_speed();
    says(format!("wave speed of {:.1} m/s", 0.2 / 28.7e-6));
    let strain =
        |wave_speed| 100.0 * smith(Law::Engineering, wave_speed, 400.0).unwrap().strain.engineering;
    says("the paper's 1.45 %".to_owned());
    assert!((strain(wave_speed) - 1.45).abs() < 0.005); // the most that two decimals can mean
    says(format!("gives {:.2} %", strain(exact_primary(&shipped("single-400-1440")).wave_speed())));
}

#[test]
fn the_answer_is_that_of_the_record() {
    let between = README.split("<!-- answer -->\n").nth(1).unwrap();
    let says = between.split("<!-- end of answer -->").next().unwrap();
    let core = answer::core(stored());
    assert!(says.trim() == core.trim(), "between the markers README.md should say:\n\n{core}");
}
