//! Which case catches which fault, as a picture and as a table.

use maud::{Markup, html};

use super::cases::place;
use super::parts::{table, text, wide};
use crate::record::Record;
use crate::report::words::{count, visible};
use crate::sensitivity::matrix::{Matrix, Row};

/// The picture and the tables, or that there are none.
pub fn matrix(record: &Record) -> Markup {
    let Some(matrix) = &record.sensitivity else {
        return html! {
            p { "This record does not say: the checks were not tried on planted faults when it was made." }
        };
    };
    let (all, noticed) = (matrix.faults.len(), matrix.noticed().count());
    let missed: Vec<_> = matrix.missed().collect();
    let idle: Vec<_> = matrix.idle().collect();
    html! {
        p { "A check that has never been seen to fail is no check. Each row is a fault that was planted, each column a "
            "case that was run with it. " strong { (noticed) " of " (count(all, "fault")) " are noticed" }
            "; the quick set alone leaves " (matrix.missed_by_quick().count()) " unnoticed. Of "
            (count(matrix.checks.len(), "check")) " " (idle.len()) " notice none." }
        @if !missed.is_empty() {
            h3 { "Noticed by none" }
            ul { @for row in missed { li { code { (visible(&row.id)) } " " (visible(&row.what)) } } }
        }
        (picture(matrix))
        (numbers(matrix))
        @if !idle.is_empty() {
            details { summary { (count(idle.len(), "check")) " that no planted fault moves" }
                ul { @for column in idle { li { code { (visible(&column.case)) } " " (visible(&column.claim)) } } } }
        }
        @if !matrix.rewrites.is_empty() {
            details { summary { (count(matrix.rewrites.len(), "rewrite")) " that must pass: the same in algebra" }
                ul { @for row in &matrix.rewrites { li { code { (visible(&row.id)) } " " (visible(&row.what)) ": fails "
                    (count(matrix.noticing(row).count(), "check")) } } } }
        }
    }
}

/// Size of a cell, room for the names of faults and of cases, pixels.
const CELL: usize = 11;
const LEFT: usize = 250;
const TOP: usize = 150;

fn picture(matrix: &Matrix) -> Markup {
    let cases = matrix.cases();
    let (width, height) = (LEFT + CELL * cases.len() + 90, TOP + CELL * matrix.faults.len() + 4);
    let label = format!(
        "Matrix of {} and {}: a filled cell is a fault that the case notices",
        count(matrix.faults.len(), "fault"),
        count(cases.len(), "case")
    );
    wide(
        "Faults by cases",
        html! {
            svg.matrix role="img" aria-label=(label) viewBox={ "0 0 " (width) " " (height) } width=(width) height=(height) {
                @for (k, case) in cases.iter().enumerate() {
                    @let x = LEFT + CELL * k + CELL / 2 + 3;
                    text x=(x) y=(TOP - 6) transform={ "rotate(-60 " (x) " " (TOP - 6) ")" } { (visible(case)) }
                }
                @for (k, row) in matrix.faults.iter().enumerate() {
                    @let y = TOP + CELL * k;
                    @if k == 0 || matrix.faults[k - 1].group != row.group {
                        line.grid x1="0" x2=(width - 90) y1=(y) y2=(y) {}
                        text.group x="0" y=(y + CELL - 2) { (visible(&row.group)) }
                    }
                    text x=(LEFT - 8) y=(y + CELL - 2) text-anchor="end" { (short(&row.id)) }
                    @let noticing = matrix.cases_noticing(row);
                    path.fails d=(cells(&cases, y, |case| noticing.contains(&case) && !row.stops(case))) {}
                    path.stops d=(cells(&cases, y, |case| row.stops(case))) {}
                }
            }
            p.key { span.box.fails {} " a check fails  " span.box.stops {} " the case comes to no end" }
        },
    )
}

/// A name that has room.
fn short(name: &str) -> String {
    let name = visible(name);
    if name.chars().count() <= 34 {
        name
    } else {
        name.chars().take(33).collect::<String>() + "…"
    }
}

/// The cells of a row for some of the cases, as a path.
fn cells(cases: &[&str], y: usize, is_filled: impl Fn(&str) -> bool) -> String {
    let side = CELL - 1;
    let at = cases.iter().enumerate().filter(|(_, case)| is_filled(case));
    at.map(|(k, _)| format!("M{} {y}h{side}v{side}h-{side}z", LEFT + CELL * k)).collect()
}

fn numbers(matrix: &Matrix) -> Markup {
    let columns = [
        ("fault", true),
        ("group", true),
        ("checks", false),
        ("cases", true),
        ("what is done instead", true),
    ];
    let row = |row: &Row| {
        vec![
            html! { code { (visible(&row.id)) } },
            text(&row.group),
            html! { (matrix.noticing(row).count()) },
            html! { @for case in matrix.cases_noticing(row) { a href={ "#" (place(case)) } { (visible(case)) } " " } },
            text(&row.what),
        ]
    };
    html! {
        details { summary { "The same as a table" }
            (table("Faults and what notices them", &columns, matrix.faults.iter().map(row).collect())) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;
    use crate::sensitivity::matrix::Column;

    #[test]
    fn the_picture_has_room_for_every_case() {
        let mut matrix = made_up::passing().sensitivity.unwrap();
        let width = |matrix: &Matrix| {
            let page = picture(matrix).into_string();
            let after = page.split("\" width=\"").nth(1).unwrap().to_owned();
            after.split('"').next().unwrap().parse::<usize>().unwrap()
        };
        let one = width(&matrix);
        matrix.checks.push(Column { case: "smith.kink".into(), ..matrix.checks[0].clone() });
        assert_eq!(width(&matrix), one + CELL);
    }

    #[test]
    fn a_name_of_34_letters_has_room() {
        assert_eq!(short(&"a".repeat(34)), "a".repeat(34));
        assert_eq!(short(&"a".repeat(35)), "a".repeat(33) + "…");
    }
}
