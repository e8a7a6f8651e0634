//! What rounding leaves of a small strain.

use super::{Picture, Section};
use crate::extremes::rounding;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};

/// The picture.
pub fn picture() -> Picture {
    let colours = [Colour::Grey, Colour::Vermillion, Colour::Orange, Colour::Purple, Colour::Blue];
    let line = |((name, errors), colour): ((&str, Vec<f64>), Colour)| {
        let points = errors.iter().enumerate().map(|(i, error)| ((i + 1) as f64, error.abs()));
        Series::new(name, colour, Style::Solid(1.5), points.collect())
    };
    Picture {
        id: "rounding".into(),
        section: Section::Cost,
        title: "What rounding leaves of a small strain".into(),
        caption: "One fibre struck slowly, 100 steps at α = 1, where the strain of each element is known. (4) takes \
                  the quotient of two lengths that are almost the same, engineering strain does so as well; the \
                  increment written as a difference of squares keeps its digits."
            .into(),
        alt: "Relative error over the number of the element, on a logarithmic axis. Equation (4) and engineering \
              strain at 1 mm/s are off by some hundredths, (4) at 1 cm/s by less than a thousandth, (4) at 10 \
              micrometres per second by more than the strain itself; the rewritten form is far below."
            .into(),
        svg: svg(&[Panel {
            title: "relative error of the strain of each element".into(),
            x: Axis::new("element, from the impact point", 0.0, 96.0, 10.0),
            y: Axis::logarithmic("|error| / strain", 1e-10, 1e4),
            series: rounding::drawn().into_iter().zip(colours).map(line).collect(),
            width: 760.0,
        }]),
    }
}
