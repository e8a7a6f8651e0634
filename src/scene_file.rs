//! Reads a scene from text, and says where in the text a fault lies.
//!
//! Three passes: is it JSON; is it a scene; can the scene be run ([`Scene::check`]). A fault of the
//! later passes has a path, and `json_locate` finds its place in the text.

use std::fmt;

use serde_json::Value;

use crate::json_locate::{line_and_column, value};
use crate::scene::Scene;
use crate::scene_check::{Problem, check_format};
use crate::scene_misfit::misfit;

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
}

impl Fault {
    /// A problem at a piece of the text.
    pub(crate) fn new(text: &str, piece: &str, problem: Problem) -> Self {
        let (line, column) = line_and_column(text, piece);
        let Problem { path, message, help } = problem;
        Self { path, line, column, message, help }
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

/// Reads a scene from text.
pub fn read(text: &str) -> Result<Scene, Fault> {
    let json = parse(text)?;
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

/// Whether the text is JSON.
fn parse(text: &str) -> Result<Value, Fault> {
    let at_start = |message: &str, help: &str| {
        let (message, help) = (message.into(), Some(help.into()));
        Err(Fault::new(text, text, Problem { path: String::new(), message, help }))
    };
    if text.trim().is_empty() {
        return at_start(
            "the text is empty",
            "`crossfibre schema` prints what a scene consists of",
        );
    }
    if text.starts_with('\u{FEFF}') {
        return at_start("the text begins with a byte order mark", "save it as UTF-8 without one");
    }
    let mut json = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut json)
        .map_err(|error| not_json(text, path_of(&error), error.inner()))?;
    json.end().map_err(|error| not_json(text, String::new(), &error))?;
    Ok(value)
}

fn not_json(text: &str, path: String, error: &serde_json::Error) -> Fault {
    let message = bare(error);
    let Some((line, column)) = position(text, error) else {
        // Under a name of its own serde_json reads what stands in quotes, and counts the lines in there.
        return Fault::at_path(text, Problem { path, message, help: None });
    };
    let fault = Fault { path, line, column, message, help: None };
    if error.is_eof() {
        return Fault { message: format!("the text ends too early: {}", fault.message), ..fault };
    }
    if fault.message == "number out of range"
        && let Some(number) = value(text, &fault.path)
    {
        let (line, column) = line_and_column(text, number);
        let message = format!("{number} is too large for a double");
        return Fault { line, column, message, ..fault };
    }
    let word = word_at(text, line, column);
    let name = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if ["nan", "inf", "infinity"].contains(&name.as_str()) {
        let (line, column) = line_and_column(text, word);
        let message = format!("{word} is not a number; JSON has neither NaN nor infinity");
        return Fault { line, column, message, ..fault };
    }
    fault
}

/// Line and column (in characters) of an error whose column counts bytes; none if it is not in the text.
fn position(text: &str, error: &serde_json::Error) -> Option<(usize, usize)> {
    let line = text.split('\n').nth(error.line().saturating_sub(1))?;
    let before = line.char_indices().take_while(|(byte, _)| byte + 1 < error.column()).count();
    Some((error.line().max(1), before + 1))
}

/// The word of letters and signs that holds or follows the character at a line and column.
fn word_at(text: &str, line: usize, column: usize) -> &str {
    let line = text.split('\n').nth(line - 1).unwrap_or("");
    let byte = line.char_indices().nth(column - 1).map_or(line.len(), |(byte, _)| byte);
    let in_word = |c: char| c.is_ascii_alphabetic() || c == '-' || c == '+';
    let start = line[..byte].trim_end_matches(in_word).len();
    let word = &line[start..];
    &word[..word.find(|c| !in_word(c)).unwrap_or(word.len())]
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

fn path_of<E>(error: &serde_path_to_error::Error<E>) -> String {
    let path = error.path().to_string();
    match path.as_str() {
        "." | "?" => String::new(),
        _ => path.strip_suffix(".?").unwrap_or(&path).into(),
    }
}
