//! The paper's claims, and what it got wrong.

use maud::{Markup, html};

use super::parts::{link, table, text};
use crate::claims::{Claim, Finding};
use crate::ledger_effects::{CrossoverRow, ProjectileRow};
use crate::record::{LedgerLine, Record};
use crate::report::words::{anchor, equations, number, visible};

fn finding(finding: Finding) -> Markup {
    let (tone, words) = match finding {
        Finding::Reproduced => ("good", "✓ reproduced"),
        Finding::NotReproduced => ("bad", "✗ not reproduced"),
        Finding::Undecidable => ("warn", "? undecidable"),
        Finding::NotExamined => ("warn", "not examined"),
    };
    html! { strong class={ "tag " (tone) } { (words) } }
}

/// Every claim; those that were not found as claimed come first.
pub fn claims(record: &Record) -> Markup {
    let rank = |claim: &&Claim| match claim.finding {
        Finding::NotReproduced => 0,
        Finding::Undecidable => 1,
        Finding::NotExamined => 2,
        Finding::Reproduced => 3,
    };
    let mut claims: Vec<&Claim> = record.claims.iter().collect();
    claims.sort_by_key(rank);
    html! {
        p { "What the paper says, in our words, and what is found. Proven is what a check holds against an oracle "
            "that shares no code with the scheme: see " a href="#cases" { "every case" } "." }
        div.rows {
            @for claim in claims {
                article.row {
                    h3 { (visible(&claim.claim)) }
                    p.by { (finding(claim.finding)) }
                    p { (text(&claim.evidence)) }
                }
            }
        }
    }
}

/// The ledger, and what its departures do.
pub fn ledger(record: &Record) -> Markup {
    html! {
        p { "An " em { "erratum" } " changes an equation and can be chosen by its id in a scene's "
            code { "corrections" } ". A " em { "reading" } " settles what the page leaves open. A "
            em { "report" } " changes nothing: the trouble is measured." }
        div.rows { @for line in &record.ledger { (departure(record, line)) } }
        h3 { "What they do, measured" }
        p { "Fig. 3 at 0.25 mm, 28.7 µs. Energy is the residual of the balance over the energy put in; the velocity "
            "across the straight fibre should be none. The last column is of a crossover 12 mm from the impact, when "
            "the kink has passed it." }
        (crossover(record))
        p { "A projectile of 0.7 g against a fibre of 0.72 g, 400 m/s, 80 µs." }
        (projectile(record))
        p { "Where these are derived: " (link("departures from the page", "VALIDATION.md#departures-from-the-page"))
            "." }
    }
}

fn departure(record: &Record, line: &LedgerLine) -> Markup {
    let effect = record.effects.remarks.iter().find(|remark| remark.id == line.id);
    html! {
        article.row id={ "ledger-" (anchor(&line.id)) } {
            h3 { code { (visible(&line.id)) } }
            p.by { span.tag { (visible(&line.kind)) } " " (equations(&line.equations)) }
            div {
                dl.pairs {
                    dt { "printed" } dd { (visible(&line.printed)) }
                    dt { "used" } dd { (visible(&line.used)) }
                    dt { "why" } dd { (text(&line.trouble)) }
                    @if let Some(effect) = effect { dt { "effect" } dd { (text(&effect.effect)) } }
                }
            }
        }
    }
}

fn crossover(record: &Record) -> Markup {
    let columns = [
        ("corrections", true),
        ("strain behind, %", false),
        ("R", false),
        ("T", false),
        ("D of one arm", false),
        ("energy", false),
        ("sideways, m/s", false),
        ("energy after the kink", false),
    ];
    let row = |row: &CrossoverRow| {
        let after = row.energy_after_kink.map_or("runs away".into(), number);
        let mut cells = vec![text(&row.corrections)];
        let of = [row.reflection, row.transmission, row.diversion].map(|x| format!("{x:.5}"));
        cells.push(html! { (format!("{:.4}", 100.0 * row.strain_behind)) });
        cells.extend(of.map(|x| html! { (x) }));
        cells.extend([number(row.energy), number(row.sideways), after].map(|x| html! { (x) }));
        cells
    };
    let rows = record.effects.crossover.iter().chain([&record.effects.exact]);
    table("Corrections of the crossover, one by one", &columns, rows.map(row).collect())
}

fn projectile(record: &Record) -> Markup {
    let columns = [
        ("corrections", true),
        ("velocity, m/s", false),
        ("energy residual", false),
        ("momentum residual", false),
        ("outcome", true),
    ];
    let row = |row: &ProjectileRow| {
        let numbers = [row.velocity, row.energy, row.momentum].map(number);
        let mut cells = vec![text(&row.corrections)];
        cells.extend(numbers.map(|x| html! { (x) }));
        cells.push(text(&row.outcome));
        cells
    };
    table(
        "Corrections of the projectile",
        &columns,
        record.effects.projectile.iter().map(row).collect(),
    )
}
