//! What errors cannot fall below: rounding, and what the exact solution admits.

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::{Entry, Record};
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

fn panel(record: &Record, problem: Problem) -> Panel {
    let mut series = Vec::new();
    for Measure { name, colours, style, bound } in MEASURES {
        let of = |way: &str| record.series(problem, &format!("{name}, α = 1{way}"));
        let double = of("");
        let error = |entry: &Entry| entry.error(Quantity::StrainL1);
        let x = |entry: &Entry| 1e3 * entry.spacing;
        let own = double.iter().map(|e| (x(e), error(e).unwrap_or(f64::NAN))).collect();
        series.push(Series::new(
            format!("{name}: the error itself"),
            colours[0],
            style(Mark::Circle),
            own,
        ));
        let fine = of(", 106 bits");
        let rounding = |coarse: &[&Entry]| -> Vec<(f64, f64)> {
            let differs = |precise: &&Entry| {
                let same = coarse.iter().find(|e| e.elements == precise.elements)?;
                Some((x(precise), (error(same)? - error(precise)?).abs()))
            };
            fine.iter().filter_map(differs).collect()
        };
        for (way, bits, colour, mark) in [
            ("", "53 bits", colours[1], Mark::Square),
            (", f32", "24 bits", colours[2], Mark::Diamond),
        ] {
            let points = rounding(&of(way));
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
        y: Axis::logarithmic("of the strain profile, L1", low, high),
        series,
        width: 645.0,
    }
}
