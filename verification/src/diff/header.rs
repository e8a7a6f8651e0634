//! The headers of two traces: whether they are headers, and in what they differ.

use crossfibre::discretisation::Discretisation;
use crossfibre::scene::Scene;
use crossfibre::scene_check::Problem;
use crossfibre::trace_file::FORMAT;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use crate::trace_line::Header;

const HELP: &str =
    "help: a trace has a JSON object on each line; `crossfibre trace SCENE -o FILE` writes one";

/// In what the headers differ. That makes no disagreement, but may explain one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeaderDifference {
    /// Fields of the scene.
    pub scene: Vec<FieldDifference>,
    /// Equations that are worked out by other lines: the editions differ.
    pub equations: Vec<u8>,
}

/// A field that differs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FieldDifference {
    /// Its path, such as `primary.elements`.
    pub path: String,
    /// What the first trace has, null for nothing.
    pub a: Json,
    /// What the second trace has.
    pub b: Json,
}

/// The header of a line, or what is wrong with it.
pub fn read(line: &[u8]) -> Result<Header, String> {
    let text = str::from_utf8(line)
        .map_err(|error| format!("byte {} is not UTF-8: not a trace", error.valid_up_to() + 1))?;
    let json: Json =
        serde_json::from_str(text).map_err(|error| format!("not JSON: {error}\n  {HELP}"))?;
    if json.get("eq").is_some() && json.get("out").is_some() {
        return Err("an event: the header, the first line of a trace, is missing".into());
    }
    match json.get("format").and_then(Json::as_str) {
        None => return Err(format!("no header of a trace: it has no \"format\"\n  {HELP}")),
        Some(FORMAT) => (),
        Some(format) => {
            return Err(format!("the format is {format:?}; this reads {FORMAT:?}\n  {HELP}"));
        }
    }
    serde_json::from_value(json).map_err(|error| format!("not a header of {FORMAT}: {error}"))
}

/// Whether both fibres are at the impact point, which moves (8) in a step.
pub fn both_at_impact(scene: &Scene) -> Result<bool, Problem> {
    scene.check()?;
    let mesh = Discretisation::<f64>::of(scene);
    Ok(mesh.secondary.is_some_and(|crossing| crossing.node == 0))
}

impl HeaderDifference {
    /// In what two headers differ.
    pub fn of(a: &Header, b: &Header) -> Self {
        let mut scene = Vec::new();
        let json = |header: &Header| serde_json::to_value(&header.scene).unwrap_or_default();
        compare("", &json(a), &json(b), &mut scene);
        let lines = |header: &Header, number| {
            let found = header.equations.iter().find(|equation| equation.number == number);
            found.map(|equation| (equation.lines.clone(), equation.lines_by_law.clone()))
        };
        let equations = (1..=20).filter(|&number| lines(a, number) != lines(b, number)).collect();
        Self { scene, equations }
    }
}

/// Collects the fields in which two values differ; lists are one field.
fn compare(path: &str, a: &Json, b: &Json, into: &mut Vec<FieldDifference>) {
    if a == b {
        return;
    }
    let (Some(in_a), Some(in_b)) = (a.as_object(), b.as_object()) else {
        into.push(FieldDifference { path: path.into(), a: a.clone(), b: b.clone() });
        return;
    };
    let only_in_b = in_b.keys().filter(|name| !in_a.contains_key(*name));
    for name in in_a.keys().chain(only_in_b) {
        let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
        let field = |of: &serde_json::Map<String, Json>| of.get(name).cloned().unwrap_or_default();
        compare(&path, &field(in_a), &field(in_b), into);
    }
}
