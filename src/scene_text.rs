//! What the text of a scene may hold beside the scene: comments, from `//` to the end of the line, and
//! the `$schema` that editors look for. Both are blanked byte by byte, so that all else stays in its
//! place.

use std::borrow::Cow;
use std::ops::Range;

use crate::json_locate::{members, value};

/// The member of a scene that names its schema.
pub(crate) const SCHEMA: &str = "$schema";

/// The text with spaces in the place of comments.
pub(crate) fn without_comments(text: &str) -> Cow<'_, str> {
    let mut comments = Vec::new();
    let (mut in_string, mut i) = (false, 0);
    let bytes = text.as_bytes();
    while i < bytes.len() {
        match bytes[i] {
            b'"' => in_string = !in_string,
            // Outside of a string it is a fault, and the first one.
            b'\\' => i += 1,
            // No string goes on in the next line: one that is not closed spoils its own line only.
            b'\n' => in_string = false,
            b'/' if !in_string && bytes.get(i + 1) == Some(&b'/') => {
                let end = text[i..].find(['\n', '\r']).map_or(text.len(), |length| i + length);
                comments.push(i..end);
                i = end;
                continue;
            }
            _ => (),
        }
        i += 1;
    }
    blanked(text, &comments)
}

/// The text of an object with spaces in the place of each member `$schema` and of its comma.
pub(crate) fn without_schema(text: &str) -> Cow<'_, str> {
    let offset = |piece: &str| piece.as_ptr().addr() - text.as_ptr().addr();
    let Some(object) = value(text, "") else { return text.into() };
    let members = members(object);
    let mut blanks = Vec::new();
    for (i, member) in members.iter().enumerate().filter(|(_, member)| member.name == SCHEMA) {
        let (start, end) = (offset(member.key), offset(member.value) + member.value.len());
        // With the comma after it; of the last member, with the one before it.
        let before = i.checked_sub(1).map(|i| offset(members[i].value) + members[i].value.len());
        blanks.push(match (members.get(i + 1), before) {
            (Some(next), _) => start..offset(next.key),
            (None, Some(before)) => before..end,
            (None, None) => start..end,
        });
    }
    blanked(text, &blanks)
}

/// The text with all but the ends of lines in these places turned to spaces, a byte for a byte.
fn blanked<'a>(text: &'a str, places: &[Range<usize>]) -> Cow<'a, str> {
    if places.is_empty() {
        return text.into();
    }
    let mut out = String::with_capacity(text.len());
    let mut kept = 0;
    for place in places {
        out.push_str(text.get(kept..place.start).unwrap_or_default());
        for byte in text[place.clone()].bytes() {
            out.push(if matches!(byte, b'\n' | b'\r') { byte.into() } else { ' ' });
        }
        kept = place.end;
    }
    out.push_str(&text[kept..]);
    out.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_blanked_in_their_place_and_strings_are_not() {
        let text = "// µ\r\n{ \"a//b\": 1, // \"c\n \"\\\"//\": \"//\" }// end";
        let plain = without_comments(text);
        assert_eq!(plain, "     \r\n{ \"a//b\": 1,      \n \"\\\"//\": \"//\" }      ");
        assert_eq!(plain.len(), text.len());
        assert!(matches!(without_comments("{\"a\": \"http://b\"}"), Cow::Borrowed(_)));
        // A string that is not closed is told as that, and the next line is read as it stands.
        assert_eq!(without_comments("\"a // b\n// c"), "\"a // b\n    ");
        assert_eq!(without_comments("1 / 2"), "1 / 2");
        assert_eq!(without_comments("\"\\"), "\"\\");
    }

    #[test]
    fn a_schema_is_blanked_with_one_comma_wherever_it_stands() {
        let schema = "\"$schema\": \"s,}\"";
        for (text, plain) in [
            (format!("{{{schema}, \"a\": 1}}"), "{\"a\":1}"),
            (format!("{{\"a\": 1,\n {schema}, \"b\": 2}}"), "{\"a\":1,\"b\":2}"),
            (format!("{{\"a\": 1, {schema}}}"), "{\"a\":1}"),
            (format!("{{{schema}}}"), "{}"),
            ("{\"a\": {\"$schema\": 1}}".into(), "{\"a\":{\"$schema\":1}}"),
        ] {
            let without = without_schema(&text);
            assert_eq!(without.len(), text.len());
            assert_eq!(without.split_whitespace().collect::<String>(), plain, "{text}");
        }
    }
}
