//! The engine as a candidate of `crossfibre conform`: reads questions, writes answers
//! (`docs/conformance.md`). With `--time SCENE` it is timed instead.

mod timed;

use std::env;
use std::io::{self, BufRead, Write};
use std::process::ExitCode;

use crossfibre::outcome::Outcome;
use crossfibre::scene::Scene;
use crossfibre_simd::{Engine, engine::supports};
use serde_json::{Value, json};

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1).peekable();
    let done = if arguments.next_if(|argument| argument == "--time").is_some() {
        timed::timed(arguments).map(|line| println!("{line}"))
    } else {
        converse().map_err(Into::into)
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("crossfibre-simd: {error}");
            ExitCode::FAILURE
        }
    }
}

fn converse() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        writeln!(out, "{}", answer(&line?))?;
        out.flush()?;
    }
    Ok(())
}

/// The answer to a line, with the id of its question.
fn answer(line: &str) -> Value {
    let question: Value = serde_json::from_str(line).unwrap_or_default();
    let mut answer =
        work_out(&question).unwrap_or_else(|error| json!({"error": error.to_string()}));
    answer["id"] = question["id"].clone();
    answer
}

fn work_out(question: &Value) -> Result<Value, Box<dyn std::error::Error>> {
    let ask = question["ask"].as_str().unwrap_or_default();
    if ask == "hello" {
        return Ok(json!({
            "format": "crossfibre-conformance/1",
            "name": env!("CARGO_PKG_NAME"),
            "version": env!("CARGO_PKG_VERSION"),
            "number": "f64",
            "depths": ["step", "run"],
            "equations": ["2", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15",
                          "16", "17", "18"],
            "laws": ["linear"],
            "dimensions": [2, 3],
            "strain": ["incremental", "engineering"],
            "corrections": ["all"],
        }));
    }
    if !["step", "run"].contains(&ask) {
        return Ok(json!({"skip": "only steps and runs"}));
    }
    let scene: Scene = serde_json::from_value(question["scene"].clone())?;
    scene.check()?;
    if let Err(reason) = supports(&scene) {
        return Ok(json!({"skip": reason.to_string()}));
    }
    if ask == "run" {
        return Ok(json!({"result": crossfibre_simd::run(&scene)?}));
    }
    let state = serde_json::from_value(question["state"].clone())?;
    let mut engine = Engine::from_state(&scene, state)?;
    match engine.run(1) {
        outcome @ Outcome::Diverged { .. } => Err(outcome.to_string().into()),
        _ => Ok(json!({"state": engine.state()})),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may

    use super::*;

    #[test]
    fn a_step_that_diverges_has_an_error_for_an_answer() {
        let text = include_str!("../../../verification/scenes/single-400.json");
        let scene = crossfibre::scene_file::read(text).unwrap();
        let asked = |zero_length: bool| {
            let mut state = Engine::new(&scene).unwrap().state();
            if zero_length {
                state.primary.position[1] = [0.0, 400.0 * Engine::new(&scene).unwrap().time_step()];
            }
            answer(&json!({"id": 3, "ask": "step", "scene": scene, "state": state}).to_string())
        };
        assert_eq!(asked(false)["state"]["step"], 1);
        let said = asked(true);
        assert_eq!(said["id"], 3);
        assert!(said["error"].as_str().unwrap().contains("diverged"), "{said}");
    }
}
