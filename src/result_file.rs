//! Reads a result that a run has written.

use serde_json::Value;

use crate::result::{FORMAT, FibreResult, RunResult};
use crate::scene_check::Problem;
use crate::scene_file::{bare, path_of};

/// Reads a result from text.
pub fn read(text: &str) -> Result<RunResult, Problem> {
    let json: Value = serde_json::from_str(text).map_err(|error| {
        if error.is_eof() {
            let what =
                if text.trim().is_empty() { "the file is empty" } else { "the file is cut short" };
            return problem("", what, "run the scene again");
        }
        let what = format!(
            "not JSON from line {}, column {} on: {}",
            error.line(),
            error.column(),
            bare(&error)
        );
        problem("", &what, "`crossfibre run SCENE -o FILE.json` writes a result")
    })?;
    check_format(&json)?;
    let result: RunResult = serde_path_to_error::deserialize(&json)
        .map_err(|error| problem(&path_of(&error), &bare(error.inner()), "run the scene again"))?;
    check_fibre("primary", &result.primary, 2)?;
    result.secondary.iter().try_for_each(|fibre| check_fibre("secondary", fibre, 3))?;
    Ok(result)
}

fn problem(path: &str, message: &str, help: &str) -> Problem {
    Problem { path: path.into(), message: message.into(), help: Some(help.into()) }
}

fn check_format(json: &Value) -> Result<(), Problem> {
    let format = json.get("format").and_then(Value::as_str);
    let help = match format {
        Some(FORMAT) => return Ok(()),
        Some(scene) if scene.starts_with("crossfibre-scene/") => {
            "this is a scene: `crossfibre run SCENE -o FILE.json` makes a result of it"
        }
        Some(result) if result.starts_with("crossfibre-result/") => {
            "another version has written it: run the scene again with this one"
        }
        _ => "`crossfibre run SCENE -o FILE.json` writes a result",
    };
    let is = format.map_or("there is none".into(), |format| format!("is \"{format}\""));
    Err(problem("format", &format!("must be \"{FORMAT}\", {is}"), help))
}

/// A node more than elements, and as many components as the fibre moves in.
fn check_fibre(path: &str, fibre: &FibreResult, dimensions: usize) -> Result<(), Problem> {
    let elements = fibre.strain.len();
    for (name, length, expected) in [
        ("tension", fibre.tension.len(), elements),
        ("position", fibre.position.len(), elements + 1),
        ("velocity", fibre.velocity.len(), elements + 1),
    ] {
        if length != expected {
            let message =
                format!("has {length} entries; with {elements} strains it must have {expected}");
            return Err(problem(&format!("{path}.{name}"), &message, "run the scene again"));
        }
    }
    for (name, vectors) in [("position", &fibre.position), ("velocity", &fibre.velocity)] {
        if let Some(i) = vectors.iter().position(|vector| vector.len() != dimensions) {
            let message = format!("has {} components, not {dimensions}", vectors[i].len());
            return Err(problem(&format!("{path}.{name}[{i}]"), &message, "run the scene again"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{result, scene_file};

    fn of_scene(text: &str) -> RunResult {
        result::run(&scene_file::read(text).unwrap(), |_| ())
    }

    #[test]
    fn a_result_is_read_back_to_the_last_bit() {
        for text in [
            include_str!("../verification/scenes/unequal.json"),
            include_str!("../verification/scenes/single-400.json"),
            include_str!("../verification/scenes/eyring.json"),
        ] {
            let result = of_scene(text);
            assert_eq!(read(&serde_json::to_string(&result).unwrap()), Ok(result));
        }
    }

    #[test]
    fn what_is_no_result_of_this_version_is_told() {
        let good =
            serde_json::to_string(&of_scene(include_str!("../verification/scenes/fig3.json")));
        let good = good.unwrap();
        let refused = |text: &str, path: &str, message: &str| {
            let problem = read(text).unwrap_err();
            assert_eq!(problem.path, path, "{problem}");
            assert!(problem.message.contains(message), "{problem}");
            assert!(problem.help.is_some());
        };
        refused("", "", "empty");
        refused(&good[..good.len() / 3], "", "cut short");
        refused("fibre,index", "", "not JSON from line 1, column 2 on");
        refused("[1, 2]", "format", "there is none");
        refused(
            include_str!("../verification/scenes/fig3.json"),
            "format",
            "is \"crossfibre-scene/1\"",
        );
        refused(&good.replace("result/1", "result/2"), "format", "is \"crossfibre-result/2\"");
        for (format, help) in [
            ("crossfibre-scene/1", "this is a scene"),
            ("crossfibre-result/2", "another version has written it"),
            ("crossfibre-trace/1", "writes a result"),
        ] {
            let problem = read(&good.replace("crossfibre-result/1", format)).unwrap_err();
            assert!(problem.help.as_ref().unwrap().contains(help), "{problem}");
        }
        refused(&good.replacen("\"spacing\"", "\"gap\"", 1), "primary", "missing field `spacing`");
        let mut json: Value = serde_json::from_str(&good).unwrap();
        json["secondary"]["strain"][7] = Value::Null;
        refused(&json.to_string(), "secondary.strain[7]", "null");
        let mut json: Value = serde_json::from_str(&good).unwrap();
        json["primary"]["tension"].as_array_mut().unwrap().pop();
        refused(&json.to_string(), "primary.tension", "has 149 entries; with 150 strains");
        let mut json: Value = serde_json::from_str(&good).unwrap();
        json["primary"]["velocity"][3].as_array_mut().unwrap().pop();
        refused(&json.to_string(), "primary.velocity[3]", "has 1 components, not 2");
    }
}
