//! The Markdown that this program writes itself, as HTML: headings, paragraphs, lists, tables, code,
//! bold words and links. Everything else is text, and escaped.

use maud::{Markup, html};

use super::html::parts::{link, wide};

/// The blocks of a text; its headings begin at level 3.
pub fn prose(text: &str) -> Markup {
    let mut lines = text.lines().peekable();
    let mut blocks = Vec::new();
    while let Some(line) = lines.next() {
        let line = line.trim_end();
        if line.is_empty() {
            continue;
        }
        if let Some(heading) = line.strip_prefix('#') {
            blocks.push(html! { h3 { (inline(heading.trim_start_matches('#').trim())) } });
            continue;
        }
        let kind = kind(line);
        let mut block = vec![line];
        while let Some(next) =
            lines.next_if(|next| !next.trim().is_empty() && kind == self::kind(next))
        {
            block.push(next.trim_end());
        }
        blocks.push(match kind {
            Kind::Table => table(&block),
            Kind::List => html! { ul { @for item in block { li { (inline(&item[2..])) } } } },
            Kind::Numbers => html! {
                ol { @for item in block { li { (inline(item.split_once(' ').map_or("", |(_, x)| x))) } } }
            },
            Kind::Words => html! { p { (inline(&block.join(" "))) } },
        });
    }
    html! { @for block in blocks { (block) } }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Table,
    List,
    Numbers,
    Words,
}

fn kind(line: &str) -> Kind {
    let after_number = line.trim_start_matches(|c: char| c.is_ascii_digit());
    if line.starts_with('|') {
        Kind::Table
    } else if line.starts_with("- ") {
        Kind::List
    } else if after_number.len() < line.len() && after_number.starts_with(". ") {
        Kind::Numbers
    } else {
        Kind::Words
    }
}

/// The cells of a row; an escaped bar is none.
fn cells(row: &str) -> Vec<String> {
    let inside = row.trim().trim_start_matches('|');
    let inside = inside.strip_suffix('|').unwrap_or(inside);
    let parts = inside.replace("\\|", "\u{1}");
    parts.split('|').map(|cell| cell.trim().replace('\u{1}', "|")).collect()
}

fn table(rows: &[&str]) -> Markup {
    let head = cells(rows[0]);
    let label = format!("Table: {}", head.join(", "));
    wide(
        &label,
        html! {
            table {
                thead { tr { @for cell in &head { th.text scope="col" { (inline(cell)) } } } }
                tbody {
                    @for row in rows.iter().skip(2) {
                        tr { @for cell in cells(row) { td.text { (inline(&cell)) } } }
                    }
                }
            }
        },
    )
}

/// A piece of a line.
#[derive(Debug, PartialEq, Eq)]
enum Piece<'a> {
    Text(&'a str),
    Code(&'a str),
    Bold(&'a str),
    Link(&'a str, &'a str),
}

/// What stands between two marks at the beginning of a text, and what follows.
fn enclosed<'a>(text: &'a str, open: &str, close: &str) -> Option<(&'a str, &'a str)> {
    text.strip_prefix(open)?.split_once(close).filter(|(inside, _)| !inside.is_empty())
}

fn pieces(mut text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let mut plain = 0;
    while plain < text.len() {
        let rest = &text[plain..];
        let link = || {
            let (words, after) = enclosed(rest, "[", "](")?;
            let (address, after) = after.split_once(')')?;
            Some((Piece::Link(words, address), after))
        };
        let found = enclosed(rest, "`", "`")
            .map(|(inside, after)| (Piece::Code(inside), after))
            .or_else(|| enclosed(rest, "**", "**").map(|(b, after)| (Piece::Bold(b), after)))
            .or_else(link);
        if let Some((piece, after)) = found {
            pieces.extend((plain > 0).then(|| Piece::Text(&text[..plain])));
            pieces.push(piece);
            (text, plain) = (after, 0);
        } else {
            plain += rest.chars().next().map_or(1, char::len_utf8);
        }
    }
    pieces.extend((!text.is_empty()).then_some(Piece::Text(text)));
    pieces
}

/// A line with its marks; entities that the Markdown is written with are taken back first.
pub fn inline(line: &str) -> Markup {
    let line = super::words::visible(line)
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&amp;", "&")
        .replace("\\\\", "\\");
    html! {
        @for piece in pieces(&line) {
            @match piece {
                Piece::Text(text) => (text),
                Piece::Code(text) => code { (text) },
                Piece::Bold(text) => strong { (text) },
                Piece::Link(text, address) => (link(text, address)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_taken_apart_at_its_marks() {
        use Piece::{Bold, Code, Link, Text};
        assert_eq!(
            pieces("a `b|c` **d** [e](docs/f.md) *g [h] `"),
            [
                Text("a "),
                Code("b|c"),
                Text(" "),
                Bold("d"),
                Text(" "),
                Link("e", "docs/f.md"),
                Text(" *g [h] `")
            ]
        );
        assert_eq!(pieces("αβ"), [Text("αβ")]);
        assert_eq!(pieces("`c`"), [Code("c")]);
    }

    #[test]
    fn blocks_become_elements_and_everything_else_text() {
        let text = "### H\n\nOne\ntwo.\n\n| a | b |\n| --- | --- |\n| 1 \\| 2 | &lt; <b> |\n\n- x\n- y\n\n1. z\n";
        let html = prose(text).into_string();
        for part in [
            "<h3>H</h3>",
            "<p>One two.</p>",
            "<th class=\"text\" scope=\"col\">a</th>",
            "<td class=\"text\">1 | 2</td><td class=\"text\">&lt; &lt;b&gt;</td>",
            "<ul><li>x</li><li>y</li></ul>",
            "<ol><li>z</li></ol>",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
        assert!(!prose("[y](javascript:z)").into_string().contains("href"));
        // A number that begins a sentence, and a point that follows none, number nothing.
        for words in ["1980 fibres", ". x"] {
            assert_eq!(prose(words).into_string(), format!("<p>{words}</p>"));
        }
    }
}
