//! What tells rounding from faults: equations in other words, and faults, over the rounding envelope.

use super::{Picture, Section};
use crate::cases::over_envelopes;
use crate::conform::judge::allowed;
use crate::conform::quantity::Quantity;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};

/// Where what is not finite is drawn.
const MOST: f64 = 1e18;

/// The picture.
pub fn picture() -> Picture {
    let [in_other_words, with_a_fault] = over_envelopes();
    let allowed = allowed(Quantity::Equation(4));
    let points = |found: Vec<(u8, f64)>, aside: f64| {
        found.into_iter().map(move |(number, most)| (f64::from(number) + aside, most.min(MOST)))
    };
    let line = vec![(0.0, allowed), (21.0, allowed)];
    let line = Series::new("allowed", Colour::Black, Style::Dashed(1.4), line);
    let in_other_words = points(in_other_words, -0.15).collect();
    let in_other_words =
        Series::new("in other words", Colour::Blue, Style::Circles, in_other_words);
    let with_a_fault = points(with_a_fault, 0.15).collect();
    let with_a_fault = Series::new("with a fault", Colour::Vermillion, Style::Pluses, with_a_fault);
    Picture {
        id: "conformance".into(),
        section: Section::Cost,
        title: "What tells rounding from faults".into(),
        caption: "Greatest difference from each equation, over what half a unit of each input and of the output can \
                  do. Equations in other words stay below the line; of the catalogue's faults each is above it. \
                  Equal bits have no place on the axis; what is not finite stands at 10¹⁸."
            .into(),
        alt: "Over the number of the equation, on a logarithmic axis: open marks of equations in other words \
              below a dashed line at 4 envelopes, marks of faults above it, most of them ten powers of ten."
            .into(),
        svg: svg(&[Panel {
            title: "differences from the equations, in rounding envelopes".into(),
            x: Axis::new("equation", 0.0, 21.0, 1.0),
            y: Axis::logarithmic("difference / envelope", 1e-3, 1e19),
            series: vec![line, in_other_words, with_a_fault],
            width: 760.0,
        }]),
    }
}
