//! JSON, but not a scene: what serde found, at its place and in words for people.

use crate::json_locate::{members, value};
use crate::nearest::did_you_mean;
use crate::scene_check::Problem;
use crate::scene_file::{Fault, bare};

/// The fault behind an error of serde at a path.
pub(crate) fn misfit(text: &str, path: &str, error: &serde_json::Error) -> Fault {
    let message = bare(error);
    let names: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    match names.split_first() {
        Some((name, known)) if message.starts_with("unknown ") => {
            unknown(text, path, &message, name, known)
        }
        Some((name, _)) if message.starts_with("duplicate field") => {
            let problem = Problem { path: join(path, name), message: message.clone(), help: None };
            Fault::new(text, key(text, path, name, 1).unwrap_or(text), problem)
        }
        _ => {
            let (path, message) = (path.into(), in_plain_words(message));
            let help = advice(&message).map(Into::into);
            Fault::at_path(text, Problem { path, message, help })
        }
    }
}

/// What to do about a value of another type than is expected.
fn advice(message: &str) -> Option<&'static str> {
    if message.contains("type: null") {
        return Some("leave out what is not given; some programs write a NaN as null");
    }
    let (text, _) =
        message.strip_prefix("invalid type: string \"")?.split_once("\", expected a ")?;
    Some(match text.trim().parse::<f64>() {
        _ if message.ends_with("boolean") => "write true or false, without quotation marks",
        Ok(_) => "write the number without quotation marks",
        Err(_) => "write the number alone, in SI units (m, kg, s, Pa) and without quotation marks",
    })
}

/// A name that is none of the known ones: of a field, a law, a measure of strain, a correction.
fn unknown(text: &str, path: &str, message: &str, name: &str, known: &[&str]) -> Fault {
    let what = message.split(", expected").next().unwrap_or(message);
    let what = what.replace("unknown variant", "unknown name");
    let message = what + &did_you_mean(name, known);
    let help = Some(format!("known here: {}", known.join(", ")));
    if !message.starts_with("unknown field") {
        return Fault::at_path(text, Problem { path: path.into(), message, help });
    }
    // Inside a material the path ends at the object, elsewhere at the unknown name.
    let outer = path.strip_suffix(name).unwrap_or(path).trim_end_matches('.');
    let inside = path.ends_with(".material") && key(text, path, name, 0).is_some();
    let object = if inside { path } else { outer };
    let problem = Problem { path: join(object, name), message, help };
    Fault::new(text, key(text, object, name, 0).unwrap_or(text), problem)
}

/// The n-th (from 0) of the keys of this name in the object at a path.
fn key<'a>(text: &'a str, path: &str, name: &str, nth: usize) -> Option<&'a str> {
    let object = members(value(text, path)?);
    object.iter().filter(|member| member.name == name).nth(nth).map(|member| member.key)
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.into() } else { format!("{path}.{name}") }
}

fn in_plain_words(message: String) -> String {
    let message = [
        ("type: map", "type: an object"),
        ("type: sequence", "type: an array"),
        ("expected f64", "expected a number"),
        ("expected usize", "expected a whole number"),
        ("expected variant identifier", "expected a name"),
    ]
    .iter()
    .fold(message, |message, (from, to)| message.replace(from, to));
    match message.split_once("expected struct").or(message.split_once("expected internally")) {
        Some((head, _)) => format!("{head}expected an object"),
        None => message,
    }
}
