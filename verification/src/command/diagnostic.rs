//! A fault in a scene, shown in its file: the line, and the place in it underlined.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use crossfibre::scene_file::Fault;

/// A scene that cannot be read.
#[derive(Debug)]
pub struct BadScene {
    /// The name of its file.
    pub file: String,
    /// What is in it; what is not UTF-8 replaced.
    pub text: String,
    /// What is wrong with it.
    pub fault: Fault,
}

/// Characters of a line up to which it is shown: a scene that a program has written on one line is not.
const LONGEST_LINE: usize = 400;

impl BadScene {
    /// In the manner of compilers: what is wrong, where, the line, and what to do.
    pub fn rendered(&self, renderer: &Renderer) -> String {
        let Fault { path, message, help, line, column, .. } = &self.fault;
        let title = if path.is_empty() { message.clone() } else { format!("{path}: {message}") };
        let place = self.place();
        let origin = format!("{}:{line}:{column}", self.file);
        let title = Level::ERROR.primary_title(title.as_str());
        let group = if self.can_be_shown(&place) {
            let underlined = AnnotationKind::Primary.span(place);
            title.element(Snippet::source(&self.text).path(&self.file).annotation(underlined))
        } else {
            title.element(Origin::path(&origin))
        };
        let group = match help {
            Some(help) => group.element(Level::HELP.message(help.as_str())),
            None => group,
        };
        renderer.render(&[group])
    }

    /// What is underlined: of an object its opening bracket, of a place the character there.
    fn place(&self) -> Range<usize> {
        let Range { start, end } = self.fault.span;
        let rest = &self.text[start..];
        let line = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let one = rest[..line].chars().next().map_or(0, char::len_utf8);
        let length = match self.text.get(start..end) {
            Some(piece) if piece.len() > line || piece.starts_with(['{', '[']) => one,
            Some("") | None => one,
            Some(piece) => piece.len(),
        };
        start..start + length
    }

    fn can_be_shown(&self, place: &Range<usize>) -> bool {
        let start = self.text[..place.start].rfind('\n').map_or(0, |end| end + 1);
        let line = self.text[start..].lines().next().unwrap_or_default();
        line.chars().count() <= LONGEST_LINE && !self.text.contains('\0') && !self.text.is_empty()
    }
}

impl std::fmt::Display for BadScene {
    fn fmt(&self, to: &mut std::fmt::Formatter) -> std::fmt::Result {
        to.write_str(&self.rendered(&Renderer::plain()))
    }
}

impl std::error::Error for BadScene {}

#[cfg(test)]
mod tests {
    use crossfibre::scene_file::read_bytes;

    use super::*;

    fn shown(bytes: &[u8]) -> String {
        let (file, text) = ("a.json".into(), String::from_utf8_lossy(bytes).into_owned());
        BadScene { file, text, fault: read_bytes(bytes).unwrap_err() }.to_string()
    }

    #[test]
    fn whatever_the_bytes_are_there_is_a_file_a_line_and_a_column() {
        let scene = include_bytes!("../../scenes/unequal.json");
        for end in 0..scene.len() - 2 {
            let cut = shown(&scene[..end]);
            assert!(cut.contains("--> a.json:"), "{cut}");
        }
        for bytes in
            [&b"\xff\xfe{\0"[..], b"\xef\xbb\xbf{}", b"{\"\xb5\": 1}", b"\n\n{}\r\n", b"{\r\n}"]
        {
            let bad = shown(bytes);
            assert!(bad.starts_with("error: ") && bad.contains("--> a.json:"), "{bad}");
        }
        let in_one_line = format!("{{\"title\": \"{}\", \"courrant\": 1}}", "µ".repeat(500));
        let bad = shown(in_one_line.as_bytes());
        assert!(
            bad.contains("--> a.json:1:515") && bad.lines().all(|line| line.len() < 200),
            "{bad}"
        );
    }

    #[test]
    fn a_line_is_shown_up_to_a_length_wherever_it_stands() {
        let bad = |before: &str, length: usize| {
            let around = ["{\"title\": \"", "\", \"courrant\": 1}"];
            let title = "µ".repeat(length - around.map(str::len).iter().sum::<usize>());
            let line = around.join(title.as_str());
            assert_eq!(line.chars().count(), length);
            shown(format!("{before}{line}").as_bytes())
        };
        for (before, number) in [("", 1), ("\n\n", 3), ("// µ\n", 2)] {
            let longest = bad(before, LONGEST_LINE);
            assert!(longest.contains("^^^") && longest.contains("µµµ"), "{longest}");
            let longer = bad(before, LONGEST_LINE + 1);
            // The field that is misspelt begins 14 characters before the end.
            assert!(longer.contains(&format!("--> a.json:{number}:388\n")), "{longer}");
            assert!(!longer.contains('^') && !longer.contains("µµµ"), "{longer}");
        }
    }

    #[test]
    fn of_what_goes_on_in_the_next_line_its_first_character_is_underlined() {
        let text = "{\n  \"title\": µ\nµ}".to_owned();
        let start = text.find('µ').unwrap();
        let span = start..text.len() - 1;
        let fault = Fault {
            path: "title".into(),
            line: 2,
            column: 12,
            message: "no word".into(),
            help: None,
            span,
        };
        let bad = BadScene { file: "a.json".into(), text, fault };
        assert_eq!(bad.place(), start..start + 'µ'.len_utf8());
    }

    #[test]
    fn the_value_is_underlined_and_an_object_by_its_bracket() {
        let scene = include_str!("../../scenes/unequal.json");
        let bad = shown(scene.replace("0.2871", "-0.2871").as_bytes());
        assert!(bad.contains("\"length\": -0.2871,\n  |               ^^^^^^^"), "{bad}");
        let bad = shown(scene.replace("\"density\": 973.0,", "").as_bytes());
        assert!(bad.contains("\"secondary\": {\n   |                ^"), "{bad}");
    }
}
