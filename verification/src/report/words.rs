//! Words that all reports have in common, and text made fit to stand in them. Titles, claims and ids
//! come from records, which anybody can have written.

use std::fmt::Write;

use crate::cases::{Bound, Check, Verdict};

/// A bound in words.
pub fn bound(bound: Bound) -> String {
    match bound {
        Bound::Exactly(x) => format!("exactly {x}"),
        Bound::AtMost(x) => format!("at most {}", number(x)),
        Bound::AtLeast(x) => format!("at least {}", number(x)),
        Bound::Within(low, high) => format!("{low} to {high}"),
    }
}

/// A number of three or four figures: plain where that is short, else with an exponent.
pub fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        "0".into()
    } else if (0.01..1000.0).contains(&size) {
        format!("{:.*}", if size < 1.0 { 4 } else { 3 }, x)
    } else {
        format!("{x:.2e}")
    }
}

/// The head-room of a check: a factor, or a dash.
pub fn head_room(check: &Check) -> String {
    check.head_room().map_or("–".into(), |factor| format!("{factor:.1}"))
}

/// Numbers of equations as the page has them.
pub fn equations(numbers: &[u8]) -> String {
    numbers.iter().map(|n| format!("({n})")).collect::<Vec<_>>().join(" ")
}

/// A number of things: "1 check", "17 checks".
pub fn count(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// What to do about a check that did not pass.
pub fn advice(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Passed => "nothing",
        Verdict::Failed => {
            "run the case again; if the code is right and the oracle is, find what else has changed; a \
             tolerance is not widened without a written cause"
        }
        Verdict::Loose => {
            "set the tolerance by the error that is measured now, and say why it is smaller"
        }
        Verdict::Redundant => "take one of the two out, or say in its claim what it is of",
    }
}

/// Text in which nothing is hidden: control characters as their pictures, and marks that turn or join
/// what is written as their code points. Line ends stay.
pub fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\t' => out.push(c),
            '\0'..='\u{1f}' => {
                out.push(char::from_u32(0x2400 + c as u32).unwrap_or(char::REPLACEMENT_CHARACTER));
            }
            '\u{7f}' => out.push('␡'),
            '\u{80}'..='\u{9f}'
            | '\u{61c}'
            | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}'
            | '\u{feff}'
            | '\u{fffe}'
            | '\u{ffff}' => {
                let _ = write!(out, "[U+{:04X}]", c as u32);
            }
            c => out.push(c),
        }
    }
    out
}

/// Text on one line.
pub fn line(text: &str) -> String {
    visible(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Text that may stand in a table of Markdown: bars and line ends would break it, angle brackets are
/// HTML, and brackets before parentheses a link.
pub fn cell(text: &str) -> String {
    visible(text)
        .replace('\\', "\\\\")
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('|', "\\|")
        .replace("](", "]\\(")
        .replace(['\n', '\r', '\t'], " ")
}

/// An id as an argument on a command line: quoted where a shell would read it otherwise.
pub fn argument(id: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._-+/=".contains(c);
    let id = line(id);
    if !id.is_empty() && id.chars().all(plain) {
        id
    } else {
        format!("'{}'", id.replace('\'', "'\\''"))
    }
}

/// An id as the name of a place in a page: other characters than letters, figures, `.` and `-` by their
/// code points, so that two ids have two names.
pub fn anchor(id: &str) -> String {
    let mut out = String::new();
    for c in id.chars() {
        if c.is_ascii_alphanumeric() || matches!(c, '.' | '-') {
            out.push(c);
        } else {
            let _ = write!(out, "_{:x}_", c as u32);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up::HOSTILE;

    #[test]
    fn text_from_a_scene_cannot_break_a_table_or_become_html() {
        assert_eq!(cell("a|b\n<script>&"), "a\\|b &lt;script&gt;&amp;");
        // A backslash before a bar would escape the escape.
        assert_eq!(cell("\\|"), "\\\\\\|");
        assert_eq!(cell("[y](z)"), "[y]\\(z)");
        assert!(!cell(HOSTILE).contains(['\n', '<', '\0', '\u{202e}']));
    }

    #[test]
    fn nothing_is_hidden() {
        assert_eq!(visible("a\u{0}\u{1b}[0m\u{202e}b\u{7f}\u{feff}"), "a␀␛[0m[U+202E]b␡[U+FEFF]");
        assert_eq!(visible("α_s ≤ 1, ½·10⁻³ µs\n"), "α_s ≤ 1, ½·10⁻³ µs\n");
        assert_eq!(line(" a\r\n\tb "), "a␍ b");
    }

    #[test]
    fn a_command_can_be_copied_to_a_shell() {
        assert_eq!(argument("smith.plateau"), "smith.plateau");
        assert_eq!(argument("a; rm x"), "'a; rm x'");
        assert_eq!(argument(""), "''");
        assert_eq!(argument("it's $(x)"), "'it'\\''s $(x)'");
    }

    #[test]
    fn two_ids_have_two_names() {
        assert_eq!(anchor("identity.both-at-origin"), "identity.both-at-origin");
        assert_eq!(anchor("a b\"<_"), "a_20_b_22__3c__5f_");
        assert_ne!(anchor("_20_"), anchor(" "));
    }

    #[test]
    fn numbers_are_short() {
        let cases = [(0.0, "0"), (0.044_148, "0.0441"), (49.021, "49.021"), (-3.2e-7, "-3.20e-7")];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
        assert_eq!((count(1, "check"), count(17, "check")), ("1 check".into(), "17 checks".into()));
    }
}
