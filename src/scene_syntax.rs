//! Whether a text is JSON, and what to do if it is not: what people write who know another notation.

use serde_json::Value;

use crate::json_locate::value;
use crate::scene_check::Problem;
use crate::scene_file::{Fault, bare, path_of};

/// The value of a text without comments.
pub(crate) fn parse(text: &str) -> Result<Value, Fault> {
    let at_start = |message: &str, help: &str| {
        let (message, help) = (message.into(), Some(help.into()));
        Err(Fault::new(text, &text[..0], Problem { path: String::new(), message, help }))
    };
    if text.trim().is_empty() {
        return at_start(
            "the text is empty",
            "`crossfibre new` writes a scene to start from, `crossfibre schema scene` what one \
             consists of",
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
    let found = bare(error);
    let Some(at) = offset(text, error) else {
        // Under a name of its own serde_json reads what stands in quotes, and counts the lines in there.
        return Fault::at_path(text, Problem { path, message: found, help: None });
    };
    let fault = |path: String, piece, message: &str, help: Option<&str>| {
        let (message, help) = (message.into(), help.map(Into::into));
        Fault::new(text, piece, Problem { path, message, help })
    };
    let here = one_character(text, at);
    let first = text.len() - text.trim_start().len();
    if !text[first..].starts_with('{') {
        let help = "`crossfibre new` writes one to start from";
        let begins = "a scene is JSON and begins with `{`";
        return fault(path, one_character(text, first), begins, Some(help));
    }
    if error.is_eof() {
        let help = "a bracket or a quotation mark is not closed";
        return fault(path, here, "the text ends too early", Some(help));
    }
    if found == "number out of range"
        && let Some(number) = value(text, &path)
    {
        return fault(path, number, &format!("{number} is too large for a double"), None);
    }
    if found.starts_with("recursion limit") {
        let help = "a scene has five levels of brackets at most";
        return fault(String::new(), here, "brackets in brackets without end", Some(help));
    }
    if found.starts_with("control character") && text[..at].ends_with('\n') {
        let line = text[..at].trim_end();
        let open = &line[line.rfind('"').unwrap_or(line.len())..];
        let help = "is a quotation mark missing?";
        return fault(path, open, "a text ends in the line in which it begins", Some(help));
    }
    let word = word_at(text, at);
    let name = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if ["nan", "inf", "infinity"].contains(&name.as_str()) {
        let message = format!("{word} is not a number; JSON has neither NaN nor infinity");
        return fault(path, word, &message, None);
    }
    let piece = if word.is_empty() { here } else { word };
    let message = match found.as_str() {
        "expected value" | "expected ident" => "expected a value",
        "key must be a string" => "expected a name in double quotes",
        other => other,
    };
    fault(path, piece, message, advice(&text[..at], &text[at..], message))
}

/// What to do about a text that stops being JSON between these two parts.
fn advice(before: &str, from: &str, message: &str) -> Option<&'static str> {
    let last = before.trim_end().chars().next_back().unwrap_or(' ');
    let next = from.trim_start().chars().next().unwrap_or(' ');
    let wants_comma = message.starts_with("expected `,`");
    let wants_name = message.starts_with("expected a name");
    Some(match next {
        _ if message.starts_with("control character") => {
            "between quotation marks a tab is written \\t"
        }
        '\'' => "names and words stand in double quotes, \"…\"",
        '/' => "a comment goes from // to the end of the line; there are no others",
        '#' => "a comment goes from // to the end of the line",
        ';' => "members are set apart by a comma",
        _ if next == '=' || message == "expected `:`" => {
            "a name and its value are set apart by a colon"
        }
        // After a number nothing but a comma or a bracket may stand.
        c if c.is_alphabetic() && last.is_ascii_digit() => {
            "numbers stand alone, in SI units: m, kg, s, Pa"
        }
        _ if wants_comma => "is a comma missing before this?",
        // After a comma in an object a name must come, and in a list a number is at fault within.
        c if last == ',' && c.is_ascii_digit() => "decimals stand behind a point: 0.3",
        '{' if wants_name => "is this bracket one too many, or a name missing before it?",
        _ if wants_name => "names stand in double quotes, \"…\"",
        _ if message == "trailing comma" => "leave out the comma before this",
        _ if message == "trailing characters" => {
            "the scene ends before this: is a bracket too many?"
        }
        '+' | '.' => "a number begins with a digit or a minus: 0.3, -1e-6",
        _ if message == "invalid number" => "a number is written like 0.3 or 28.7e-6",
        c if c.is_alphabetic() => "words stand in double quotes, \"…\"",
        _ => return None,
    })
}

/// Where in the text an error is: serde_json tells the line, and the column in bytes. None if there
/// is no such line.
fn offset(text: &str, error: &serde_json::Error) -> Option<usize> {
    let mut lines = text.split('\n');
    let before: usize =
        lines.by_ref().take(error.line().saturating_sub(1)).map(|line| line.len() + 1).sum();
    let line = lines.next()?;
    let in_line =
        line.char_indices().map(|(byte, _)| byte).take_while(|byte| byte + 1 < error.column());
    let passed = in_line.last();
    let length = |byte: usize| line[byte..].chars().next().map_or(0, char::len_utf8);
    Some(before + passed.map_or(0, |byte| byte + length(byte)))
}

/// The character at a place; nothing at the end of the text.
fn one_character(text: &str, at: usize) -> &str {
    let rest = &text[at..];
    &rest[..rest.chars().next().map_or(0, char::len_utf8)]
}

/// The word of letters and signs that holds or follows the character at a place.
fn word_at(text: &str, at: usize) -> &str {
    let in_word = |c: char| c.is_ascii_alphabetic() || c == '-' || c == '+';
    let word = &text[text[..at].trim_end_matches(in_word).len()..];
    &word[..word.find(|c| !in_word(c)).unwrap_or(word.len())]
}
