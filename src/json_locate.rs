//! Where a value stands in a JSON text.
//!
//! `serde_json` lends the text of any value. Borrowing level by level along a path ends at a piece
//! of the original text, whose address less that of the whole is its place.

use std::fmt;

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

/// One member of an object, as pieces of the original text.
pub(crate) struct Member<'a> {
    /// The name, its escapes resolved.
    pub name: String,
    /// The name as it is written, with its quotes.
    pub key: &'a str,
    /// The value as it is written.
    pub value: &'a str,
}

/// The members of an object in the order of the text, repeated ones included; none if the text is
/// not an object.
pub(crate) fn members(object: &str) -> Vec<Member<'_>> {
    serde_json::from_str(object).map_or_else(|_| Vec::new(), |Members(members)| members)
}

/// The value at a path like `corrections[2]` or `secondary.slide_factor`, or the innermost one on
/// the way to it that is there. `None` if the text is not JSON.
pub(crate) fn value<'a>(text: &'a str, path: &str) -> Option<&'a str> {
    let mut here = serde_json::from_str::<&RawValue>(text).ok()?.get();
    for step in path.split(['.', '[']).filter(|step| !step.is_empty()) {
        let next = match step.strip_suffix(']').and_then(|index| index.parse::<usize>().ok()) {
            Some(index) => serde_json::from_str::<Vec<&RawValue>>(here)
                .ok()
                .and_then(|elements| elements.get(index).map(|element| element.get())),
            None => members(here).iter().rfind(|m| m.name == step).map(|m| m.value),
        };
        match next {
            Some(value) => here = value,
            None => break,
        }
    }
    Some(here)
}

/// Line and column, both from 1 and in characters, at which a piece of the text begins.
pub(crate) fn line_and_column(text: &str, piece: &str) -> (usize, usize) {
    let before = &text[..piece.as_ptr().addr() - text.as_ptr().addr()];
    let line_start = before.rfind('\n').map_or(0, |end| end + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

struct Members<'a>(Vec<Member<'a>>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_map(MembersVisitor)
    }
}

struct MembersVisitor;

impl<'de> Visitor<'de> for MembersVisitor {
    type Value = Members<'de>;

    fn expecting(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members<'de>, A::Error> {
        let mut members = Vec::new();
        while let Some((key, value)) = map.next_entry::<&RawValue, &RawValue>()? {
            let name = serde_json::from_str(key.get()).map_err(serde::de::Error::custom)?;
            members.push(Member { name, key: key.get(), value: value.get() });
        }
        Ok(Members(members))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "{\"µ\": [7,\n  {\"a\\u0062\": 2, \"ab\" : 31}],\n \"c\": null }";

    fn place(path: &str) -> (&str, (usize, usize)) {
        let piece = value(TEXT, path).unwrap();
        (piece, line_and_column(TEXT, piece))
    }

    #[test]
    fn a_value_is_found_by_its_path_in_lines_and_characters() {
        assert_eq!(place("µ[0]"), ("7", (1, 8)));
        assert_eq!(place("c"), ("null", (3, 7)));
    }

    #[test]
    fn of_repeated_members_the_last_is_found_and_all_are_listed() {
        assert_eq!(place("µ[1].ab"), ("31", (2, 25)));
        let inner = members(place("µ[1]").0);
        assert_eq!(inner.iter().map(|m| m.key).collect::<Vec<_>>(), ["\"a\\u0062\"", "\"ab\""]);
        assert!(inner.iter().all(|m| m.name == "ab"));
    }

    #[test]
    fn a_path_that_leads_nowhere_ends_at_the_innermost_value_on_the_way() {
        assert_eq!(place("µ[5].x").0, place("µ").0);
        assert_eq!(place("").1, (1, 1));
        assert_eq!(value("{\"a\": ", "a"), None);
    }
}
