//! What the record is of: the build, the scenes, and one step by hand.

use maud::{Markup, html};

use super::parts::{link, table, text};
use crate::record::{Record, SceneDigest};
use crate::report::FOLDER;
use crate::report::words::{line, visible};

/// All of it.
pub fn about(record: &Record) -> Markup {
    let build = &record.build;
    let rows = [
        ("format of the record", line(&record.format)),
        ("version", line(&record.version)),
        ("source", format!("{}, {}", line(&build.source), line(&build.commit_in_words()))),
        ("compiler", line(&build.compiler)),
        ("target and profile", format!("{}, {}", line(&build.target), line(&build.profile))),
    ];
    let scene = |scene: &SceneDigest| {
        let path = format!("verification/scenes/{}.json", scene.name);
        vec![link(&scene.name, &path), text(&scene.title), html! { code { (line(&scene.digest)) } }]
    };
    html! {
        p { "This page is a function of " code { "report.json" } " alone: "
            code { "crossfibre report --from report.json" } " makes the same bytes again." }
        dl.pairs { @for (name, value) in rows { dt { (name) } dd { (value) } } }
        p { "Paths are from the root of the repository. The links to them lead there from "
            code { (FOLDER) } ", where " code { "verify" } " writes this page; from elsewhere they do not."
            " To read on: " (link("the scheme, step by step", "docs/scheme.md")) "; "
            (link("file formats", "docs/formats.md")) "." }
        details {
            summary { "One step by hand: the crossover's node in the step after the wave has come" }
            div.wide tabindex="0" role="region" aria-label="One step by hand" {
                pre { (visible(record.worked.trim_end())) }
            }
        }
        details {
            summary { "Scenes, with FNV-1a digests of their text" }
            (table(
                "Shipped scenes",
                &[("scene", true), ("title", true), ("digest", true)],
                record.scenes.iter().map(scene).collect(),
            ))
        }
    }
}
