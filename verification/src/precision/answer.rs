//! The answer in one page: how accurate for how much work. Every number in it is of the record.

mod avoid;
pub mod wanted;

use super::problems::Problem;
use super::reading::Quantity;
use super::record::{Entry, Record};
use super::{VARIANTS, Variant, variants::Precision};
use crate::tables::markdown;
use crossfibre::errata::Corrections;

/// The page's own variant.
const PAGE: &str = "eqn (4), α = 1";

/// What is wanted of a run.
#[derive(Clone, Copy, Debug)]
struct Aim {
    problem: Problem,
    quantity: Quantity,
    /// The greatest error, relative.
    within: f64,
}

const AIMS: [Aim; 12] = [
    aim(Problem::Single, Quantity::Plateau, 1e-2),
    aim(Problem::Single, Quantity::Plateau, 1e-3),
    aim(Problem::Single, Quantity::StrainL1, 1e-2),
    aim(Problem::Single, Quantity::StrainL1, 3e-3),
    aim(Problem::Crossed, Quantity::Reflection, 1e-1),
    aim(Problem::Crossed, Quantity::Reflection, 1e-2),
    aim(Problem::Crossed, Quantity::Reflection, 1e-3),
    aim(Problem::Crossed, Quantity::Transmission, 1e-3),
    aim(Problem::Crossed, Quantity::Diversion, 1e-2),
    aim(Problem::Crossed, Quantity::Diversion, 1e-3),
    aim(Problem::Crossed, Quantity::MeanStrain, 1e-3),
    aim(Problem::Crossed, Quantity::Kink, 1e-2),
];

const fn aim(problem: Problem, quantity: Quantity, within: f64) -> Aim {
    Aim { problem, quantity, within }
}

/// The variants that may be recommended.
fn sound() -> impl Iterator<Item = &'static Variant> {
    VARIANTS.iter().filter(|variant| {
        variant.corrections == Corrections::ALL
            && variant.precision == Precision::Double
            && variant.flagged
    })
}

impl Aim {
    fn text(&self) -> String {
        let Self { problem, quantity, within } = self;
        let of = match problem {
            Problem::Single => "one fibre",
            Problem::Crossed => "Fig. 3",
            Problem::Unequal => "unequal fibres",
            Problem::Rod => "rod",
        };
        format!("{of}: {} to {} %", quantity.label(), percent(*within))
    }

    /// The coarsest mesh from which on it and all finer ones keep the aim.
    fn reached<'a>(&self, record: &'a Record, variant: &str) -> Option<&'a Entry> {
        let series = record.series(self.problem, variant);
        let keeps = |entry: &&&Entry| {
            entry.error(self.quantity).is_some_and(|error| error.abs() <= self.within)
        };
        series.iter().rev().take_while(keeps).last().copied()
    }

    /// The variant that reaches it with the fewest evaluations.
    fn cheapest<'a>(&self, record: &'a Record) -> Option<&'a Entry> {
        let reached = sound().filter_map(|variant| self.reached(record, variant.name));
        reached.min_by_key(|entry| entry.found.evaluations)
    }

    /// The variants that never keep it.
    fn missed_by(&self, record: &Record) -> Vec<&'static str> {
        let ran = |variant: &&Variant| {
            let series = record.series(self.problem, variant.name);
            series.iter().any(|entry| entry.reading(self.quantity).is_some())
        };
        let missed = sound().filter(ran).filter(|v| self.reached(record, v.name).is_none());
        missed.map(|variant| variant.name).collect()
    }
}

/// A number of two or three figures, in per cent.
fn percent(x: f64) -> String {
    let x = 100.0 * x.abs();
    match x {
        10.0.. => format!("{x:.0}"),
        1.0.. => plain(format!("{x:.1}")),
        0.1.. => plain(format!("{x:.2}")),
        _ => plain(format!("{x:.3}")),
    }
}

/// Without zeros at the end.
fn plain(text: String) -> String {
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A whole number, in groups of three figures.
fn count(n: u64) -> String {
    let figures = n.to_string();
    let mut text = String::new();
    for (k, figure) in figures.chars().enumerate() {
        if k > 0 && (figures.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(figure);
    }
    text
}

fn millimetres(entry: &Entry) -> String {
    plain(format!("{:.5}", 1e3 * entry.spacing)) + " mm"
}

/// A mesh and its work, in three cells.
fn cells(entry: Option<&Entry>) -> [String; 3] {
    entry.map_or(["not reached".into(), "–".into(), "–".into()], |entry| {
        [
            format!("{} ({})", entry.elements, millimetres(entry)),
            count(entry.found.element_steps),
            count(entry.found.evaluations),
        ]
    })
}

/// What is wanted, what the page's own variant takes for it, and what the cheapest does.
fn aims(record: &Record, is_whole: bool) -> String {
    let row = |aim: &Aim| {
        let (page, cheapest) = (aim.reached(record, PAGE), aim.cheapest(record));
        let mut row = vec![aim.text()];
        row.extend(cells(page));
        row.push(cheapest.map_or("none".into(), |entry| entry.variant.clone()));
        row.extend(cells(cheapest));
        if is_whole {
            let missed = aim.missed_by(record);
            row.push(if missed.is_empty() { "–".into() } else { missed.join("; ") });
        }
        row
    };
    let mut head = vec![
        "wanted",
        "elements by eqn (4) at α = 1",
        "element-steps",
        "evaluations",
        "cheapest",
        "elements",
        "element-steps",
        "evaluations",
    ];
    if is_whole {
        head.push("not reached by");
    }
    markdown(&head, &AIMS.iter().map(row).collect::<Vec<_>>())
}

/// The answer in two sentences.
fn sentences(record: &Record) -> String {
    let says = |aim: Aim| {
        let what = aim.quantity.label();
        let within = percent(aim.within);
        let work = |entry: &Entry| {
            let [_, steps, evaluations] = cells(Some(entry));
            format!(
                "{} elements of {}: {steps} element-steps, {evaluations} evaluations of equations",
                entry.elements,
                millimetres(entry)
            )
        };
        match (aim.reached(record, PAGE), aim.cheapest(record)) {
            (Some(page), _) => format!("for {within} % on {what} use {}", work(page)),
            (None, Some(other)) => format!(
                "for {within} % on {what} eqn (4) at α = 1 does not serve; use {} with {}",
                other.variant,
                work(other)
            ),
            (None, None) => format!("{within} % on {what} is beyond every mesh"),
        }
    };
    let [strain, one, tenth] = [
        aim(Problem::Single, Quantity::Plateau, 1e-3),
        aim(Problem::Crossed, Quantity::Reflection, 1e-2),
        aim(Problem::Crossed, Quantity::Reflection, 1e-3),
    ];
    let series = record.series(Problem::Crossed, PAGE);
    let end = |entry: Option<&&Entry>| entry.map_or_else(String::new, |entry| millimetres(entry));
    format!(
        "With the corrected equations, {}; {}; {}. Meshes go from {} to {}; the one named is the coarsest that \
         keeps the error together with all finer ones.\n",
        says(strain),
        says(one),
        says(tenth),
        end(series.first()),
        end(series.last())
    )
}

/// The core of the answer, for README.md.
pub fn core(record: &Record) -> String {
    format!("{}\n{}", sentences(record), aims(record, false))
}

/// The whole answer.
pub fn page(record: &Record) -> String {
    format!(
        "{}\n{}\n### What not to use\n\n{}",
        sentences(record),
        aims(record, true),
        markdown(&["do not use", "because"], &avoid::rows(record))
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::stored::stored;

    #[test]
    fn numbers_are_short_and_plain() {
        assert_eq!(
            ["0.31", "1.5", "0.1", "0.0487", "0.003137", "0.00314", "0.0003137", "0.000314"]
                .map(|x| percent(x.parse().unwrap())),
            ["31", "150", "10", "4.9", "0.31", "0.31", "0.031", "0.031"]
        );
        assert_eq!([7, 1602, 25_608_000].map(count), ["7", "1,602", "25,608,000"]);
    }

    /// A mesh that keeps the aim by chance, with a finer one that does not, is no answer.
    #[test]
    fn a_mesh_is_named_only_if_all_finer_ones_keep_the_aim_as_well() {
        for aim in AIMS {
            let Some(entry) = aim.reached(stored(), PAGE) else { continue };
            for other in stored().series(aim.problem, PAGE) {
                let keeps = other.error(aim.quantity).is_some_and(|e| e.abs() <= aim.within);
                assert!(keeps || other.spacing > entry.spacing, "{aim:?}");
            }
        }
        let by_chance = aim(Problem::Crossed, Quantity::Reflection, 5e-3);
        // 0.3 % off at 1 mm, 0.9 % at 0.25 mm.
        let entry = by_chance.reached(stored(), PAGE).unwrap();
        assert!(entry.refinement > 2.0);
    }

    #[test]
    fn the_answer_of_the_stored_record_is_that_of_the_committed_page() {
        let committed = include_str!("../../../VALIDATION.md");
        assert!(committed.contains(&page(stored())));
    }
}
