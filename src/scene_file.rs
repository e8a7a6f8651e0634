//! Reads a scene from text, and says where in the text a fault lies.
//!
//! Three passes: is it JSON; is it a scene; can the scene be run ([`Scene::check`]). A fault of the
//! later passes has a path, and `json_locate` finds its place in the text.

use std::fmt;
use std::ops::Range;

use serde_json::Value;

use crate::json_locate::{line_and_column, value};
use crate::scene::Scene;
use crate::scene_check::{Problem, check_format};
use crate::scene_misfit::misfit;
use crate::scene_syntax::parse;
use crate::scene_text::{SCHEMA, without_comments, without_schema};

/// What is wrong with a text, and where. Lines and columns count from 1, columns in characters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The value concerned, such as `secondary.slide_factor`; empty for the scene as a whole.
    pub path: String,
    /// The line it stands in.
    pub line: usize,
    /// Where in the line it begins.
    pub column: usize,
    /// What is wrong with it.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
    /// The piece of the text concerned, in bytes; a single place where something is missing.
    pub span: Range<usize>,
}

impl Fault {
    /// A problem at a piece of the text.
    pub(crate) fn new(text: &str, piece: &str, problem: Problem) -> Self {
        let (line, column) = line_and_column(text, piece);
        let start = piece.as_ptr().addr() - text.as_ptr().addr();
        let Problem { path, message, help } = problem;
        Self { path, line, column, message, help, span: start..start + piece.len() }
    }

    /// A problem at the value of its path.
    pub(crate) fn at_path(text: &str, problem: Problem) -> Self {
        let piece = value(text, &problem.path).unwrap_or(text);
        Self::new(text, piece, problem)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        write!(to, "line {}, column {}: ", self.line, self.column)?;
        if !self.path.is_empty() {
            write!(to, "{}: ", self.path)?;
        }
        write!(to, "{}", self.message)?;
        self.help.iter().try_for_each(|help| write!(to, "\n  help: {help}"))
    }
}

impl std::error::Error for Fault {}

/// Reads a scene from the bytes of a file.
pub fn read_bytes(bytes: &[u8]) -> Result<Scene, Fault> {
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return read(text),
        Err(error) => error,
    };
    let offset = error.valid_up_to();
    let good = String::from_utf8_lossy(&bytes[..offset]);
    let utf_16 = bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]);
    Err(Fault::new(
        &good,
        &good[offset..],
        Problem {
            path: String::new(),
            message: format!("not UTF-8: the byte at offset {offset} is 0x{:02X}", bytes[offset]),
            help: utf_16.then(|| "this looks like UTF-16: save it as UTF-8".into()),
        },
    ))
}

/// Reads a scene from text, in which there may be comments from `//` to the end of a line.
pub fn read(text: &str) -> Result<Scene, Fault> {
    let text = &without_comments(text);
    let json = parse(text)?;
    if json.get(SCHEMA).is_some_and(|schema| !schema.is_string()) {
        let (path, message) = (SCHEMA.into(), "must be a string, the place of a schema".into());
        return Err(Fault::at_path(text, Problem { path, message, help: None }));
    }
    let text = &without_schema(text);
    if let Some(format) = json.get("format").and_then(Value::as_str) {
        check_format(format).map_err(|problem| Fault::at_path(text, problem))?;
    }
    refuse_unnamed_fields(text, &json)?;
    let json = &mut serde_json::Deserializer::from_str(text);
    let scene: Scene = serde_path_to_error::deserialize(json)
        .map_err(|error| misfit(text, &path_of(&error), error.inner()))?;
    scene.check().map_err(|problem| Fault::at_path(text, problem))?;
    Ok(scene)
}

/// serde takes an array as the fields of a struct in order: a scene names its fields.
fn refuse_unnamed_fields(text: &str, scene: &Value) -> Result<(), Fault> {
    let refuse_array = |path: String, value: Option<&Value>| {
        if value.is_none_or(|value| !value.is_array()) {
            return Ok(());
        }
        let message = "invalid type: an array, expected an object".into();
        Err(Fault::at_path(text, Problem { path, message, help: None }))
    };
    refuse_array(String::new(), Some(scene))?;
    refuse_array("projectile".into(), scene.get("projectile"))?;
    for fibre in ["primary", "secondary"] {
        refuse_array(fibre.into(), scene.get(fibre))?;
        let material = scene.get(fibre).and_then(|fibre| fibre.get("material"));
        let path = format!("{fibre}.material");
        refuse_array(path.clone(), material)?;
        let inner = |name: &str| material.and_then(|material| material.get(name));
        let viscosity = "artificial_viscosity";
        refuse_array(format!("{path}.{viscosity}"), inner(viscosity))?;
        let arms = inner("arms").and_then(Value::as_array);
        for (i, arm) in arms.into_iter().flatten().enumerate() {
            refuse_array(format!("{path}.arms[{i}]"), Some(arm))?;
        }
    }
    Ok(())
}

/// The message of an error without the position that serde_json appends.
pub(crate) fn bare(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let suffix = format!(" at line {} column {}", error.line(), error.column());
    message.strip_suffix(&suffix).map_or(message.clone(), String::from)
}

/// Where serde was when it failed; empty for the whole.
pub(crate) fn path_of<E>(error: &serde_path_to_error::Error<E>) -> String {
    let path = error.path().to_string();
    match path.as_str() {
        "." | "?" => String::new(),
        _ => path.strip_suffix(".?").unwrap_or(&path).into(),
    }
}
