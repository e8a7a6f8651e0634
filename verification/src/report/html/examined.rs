//! What was examined apart from a verification.

use maud::{Markup, html};

use super::parts::{link, table, text};
use crate::examined::Examination;
use crate::record::Record;

/// A table, if there is something to say.
pub fn examined(record: &Record) -> Markup {
    let columns = [
        ("what", true),
        ("by", true),
        ("on", true),
        ("at commit", true),
        ("what came of it", true),
    ];
    let row = |examined: &Examination| {
        vec![
            link(&examined.what, &format!("docs/{}", examined.page)),
            text(&examined.tool),
            text(&examined.date),
            text(&examined.commits.join(", ")),
            text(&examined.outcome()),
        ]
    };
    html! {
        @if !record.examined.is_empty() {
            h3 { "Examined apart from this verification" }
            p { "What takes hours, or tools that not everyone has; the commands are in "
                (link("the contributor's guide", "CONTRIBUTING.md")) "." }
            (table("Examined apart", &columns, record.examined.iter().map(row).collect()))
        }
    }
}
