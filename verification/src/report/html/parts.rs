//! What all parts of the page are made of.

use maud::{Markup, html};

use crate::report::words::visible;

/// What may be wider than the page: it scrolls within itself, by keyboard as well.
pub fn wide(label: &str, content: Markup) -> Markup {
    html! { div.wide tabindex="0" role="region" aria-label=(visible(label)) { (content) } }
}

/// A column of a table: its head, and whether it holds words.
pub type Column<'a> = (&'a str, bool);

/// A table with a caption, whose first column heads the rows.
pub fn table(caption: &str, columns: &[Column], rows: Vec<Vec<Markup>>) -> Markup {
    wide(
        caption,
        html! {
            table {
                caption { (visible(caption)) }
                thead { tr { @for (head, is_text) in columns { th.text[*is_text] scope="col" { (head) } } } }
                tbody {
                    @for row in rows {
                        tr {
                            @for (k, cell) in row.into_iter().enumerate() {
                                @let is_text = columns.get(k).is_some_and(|(_, is_text)| *is_text);
                                @if k == 0 { th.text[is_text] scope="row" { (cell) } }
                                @else { td.text[is_text] { (cell) } }
                            }
                        }
                    }
                }
            }
        },
    )
}

/// Text of a record, with what stands between backticks as code.
pub fn text(text: &str) -> Markup {
    let text = visible(text);
    let parts: Vec<&str> = text.split('`').collect();
    // A backtick without a partner is one.
    if parts.len().is_multiple_of(2) {
        return html! { (text) };
    }
    html! {
        @for (k, part) in parts.iter().enumerate() {
            @if k % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}

/// The root of the repository from where `verify` writes the page, [`crate::report::FOLDER`].
const ROOT: &str = "../../";

/// A link to a place in this page, or to a file of the repository with its path in plain sight, since the
/// page may stand alone; other addresses are left out.
pub fn link(words: &str, address: &str) -> Markup {
    let (words, address) = (visible(words), visible(address));
    let is_file = ["docs/", "VALIDATION.md", "CONTRIBUTING.md", "verification/scenes/"]
        .iter()
        .any(|start| address.starts_with(start));
    html! {
        @if address.starts_with('#') { a href=(address) { (words) } }
        @else if is_file { a href={ (ROOT) (address) } { (words) } " " code.path { (address) } }
        @else { (words) }
    }
}

/// Seconds in the unit that suits them.
pub fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{:.0} µs", 1e6 * s),
        s if s < 0.1 => format!("{:.1} ms", 1e3 * s),
        s if s < 1.0 => format!("{:.0} ms", 1e3 * s),
        s => format!("{s:.2} s"),
    }
}

/// A whole number in groups of three figures, with thin spaces.
pub fn grouped(n: u64) -> String {
    let figures = n.to_string();
    let mut text = String::new();
    for (k, figure) in figures.chars().enumerate() {
        if k > 0 && (figures.len() - k).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(figure);
    }
    text
}

/// Any text in an address of the scheme `data:`, every byte that could end or change it encoded.
pub fn data_uri(svg: &str) -> String {
    let mut uri = String::with_capacity(svg.len() * 5 / 4);
    uri.push_str("data:image/svg+xml,");
    for byte in svg.bytes() {
        match byte {
            // Between tags as good as a line end, and shorter.
            b'\n' => uri.push(' '),
            b' ' | b'!' | b'$' | b'('..=b';' | b'=' | b'?'..=b'Z' | b'_' | b'a'..=b'z' => {
                uri.push(char::from(byte));
            }
            _ => {
                const HEX: &[u8; 16] = b"0123456789ABCDEF";
                uri.push('%');
                uri.push(char::from(HEX[usize::from(byte >> 4)]));
                uri.push(char::from(HEX[usize::from(byte & 15)]));
            }
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::FOLDER;

    #[test]
    fn a_duration_has_the_unit_that_suits_it() {
        for (seconds, words) in [
            (0.0009, "900 µs"),
            (0.001, "1.0 ms"),
            (0.09, "90.0 ms"),
            (0.1, "100 ms"),
            (0.9, "900 ms"),
            (1.0, "1.00 s"),
        ] {
            assert_eq!(duration(seconds), words);
        }
    }

    #[test]
    fn an_address_holds_nothing_that_ends_it() {
        let uri = data_uri("<a b=\"#%'&\nµ\">\u{0}</a>");
        assert_eq!(uri, "data:image/svg+xml,%3Ca b=%22%23%25%27%26 %C2%B5%22%3E%00%3C/a%3E");
    }

    #[test]
    fn links_lead_from_the_folder_of_reports_to_the_root() {
        assert_eq!("../".repeat(FOLDER.split('/').count()), ROOT);
    }

    #[test]
    fn code_is_between_two_backticks() {
        assert_eq!(text("a `b<` c").into_string(), "a <code>b&lt;</code> c");
        assert_eq!(text("a ` b").into_string(), "a ` b");
    }

    #[test]
    fn only_places_of_this_project_are_linked() {
        let range = "<a href=\"../../docs/exact/smith.md#range\">x</a> <code class=\"path\">docs/exact/smith.md#range</code>";
        assert_eq!(link("x", "docs/exact/smith.md#range").into_string(), range);
        assert_eq!(link("x", "#cases").into_string(), "<a href=\"#cases\">x</a>");
        for other in ["javascript:alert(1)", "https://example.org", "//x", "\u{1}docs/x"] {
            assert_eq!(link("x", other).into_string(), "x");
        }
    }

    #[test]
    fn times_and_counts_are_read_at_a_glance() {
        assert_eq!(
            [3.7e-5, 0.0123, 0.437, 7.3].map(duration),
            ["37 µs", "12.3 ms", "437 ms", "7.30 s"]
        );
        assert_eq!(
            [7, 1602, 25_608_000].map(grouped),
            ["7", "1\u{202f}602", "25\u{202f}608\u{202f}000"]
        );
    }
}
