//! What errors cannot fall below: rounding, and what the exact solution admits.

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::{Entry, Record};
use super::BASES;
use super::errors::ends;
use crate::plot::{Axis, Colour, Mark, Panel, Series, Style, rows};

/// A measure of strain: its name, its colour, whether its marks are filled.
struct Measure {
    name: &'static str,
    colours: [Colour; 3],
    style: fn(Mark) -> Style,
    bound: Style,
}

const MEASURES: [Measure; 2] = [
    Measure {
        name: "engineering",
        colours: [Colour::Blue, Colour::Green, Colour::Orange],
        style: Style::Marked,
        bound: Style::Dotted(1.2),
    },
    Measure {
        name: "eqn (4)",
        colours: [Colour::Blue, Colour::Green, Colour::Orange],
        style: Style::MarkedDashed,
        bound: Style::Dotted(2.2),
    },
];

/// The picture: a panel for each problem.
pub fn picture(record: &Record) -> String {
    rows(&Problem::ALL.map(|problem| panel(record, problem)), 2)
}

/// The most that rounding to 53 bits makes of the error of a profile anywhere.
pub fn greatest_rounding(record: &Record) -> f64 {
    let of = |problem: Problem| {
        BASES.into_iter().flat_map(move |base| {
            let fine = record.series(problem, &format!("{base}, 106 bits"));
            rounding(&record.series(problem, base), &fine)
        })
    };
    Problem::ALL.into_iter().flat_map(of).map(|point| point.1).fold(0.0, f64::max)
}

/// Lengths of elements, mm, and what rounding makes of the error on them: the difference from the run in
/// 106 bits.
fn rounding(coarse: &[&Entry], fine: &[&Entry]) -> Vec<(f64, f64)> {
    let differs = |precise: &&Entry| {
        let same = coarse.iter().find(|entry| entry.elements == precise.elements)?;
        Some((x(precise), (error(same)? - error(precise)?).abs()))
    };
    fine.iter().filter_map(differs).collect()
}

fn error(entry: &Entry) -> Option<f64> {
    entry.error(Quantity::StrainL1)
}

fn x(entry: &Entry) -> f64 {
    1e3 * entry.spacing
}

fn panel(record: &Record, problem: Problem) -> Panel {
    let mut series = Vec::new();
    for Measure { name, colours, style, bound } in MEASURES {
        let of = |way: &str| record.series(problem, &format!("{name}, α = 1{way}"));
        let double = of("");
        let own = double.iter().map(|e| (x(e), error(e).unwrap_or(f64::NAN))).collect();
        series.push(Series::new(
            format!("{name}: the error itself"),
            colours[0],
            style(Mark::Circle),
            own,
        ));
        let fine = of(", 106 bits");
        for (way, bits, colour, mark) in [
            ("", "53 bits", colours[1], Mark::Square),
            (", f32", "24 bits", colours[2], Mark::Diamond),
        ] {
            let points = rounding(&of(way), &fine);
            if !points.is_empty() {
                let name = format!("{name}: rounding, {bits} less 106");
                series.push(Series::new(name, colour, style(mark), points));
            }
        }
        let bounds = double.iter().filter_map(|e| Some((x(e), e.found.floor?))).collect();
        let name = format!("{name}: bound of the exact solution");
        series.push(Series::new(name, Colour::Black, bound, bounds));
    }
    let coordinate = |of: fn(&(f64, f64)) -> f64| {
        ends(series.iter().flat_map(|series| series.points.iter().map(of)))
    };
    let ((from, to), (low, high)) = (coordinate(|p| p.0), coordinate(|p| p.1));
    Panel {
        title: problem.title().into(),
        x: Axis::logarithmic("length of an element, mm", from, to),
        y: Axis::logarithmic("part of L1 of the strain profile", low, high),
        series,
        width: 645.0,
    }
}
