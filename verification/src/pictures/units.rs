//! Between which powers of two the units of a scene may be.

use super::{Picture, Section};
use crate::extremes::scaling;
use crate::plot::{Axis, Colour, Panel, Series, Style, rows};

const COLOURS: [Colour; 5] =
    [Colour::Blue, Colour::Orange, Colour::Green, Colour::Purple, Colour::Vermillion];

/// The picture.
pub fn picture() -> Picture {
    let panels = scaling::drawn().map(|(name, units)| {
        let strokes =
            units.into_iter().zip(COLOURS).zip(1..).map(|(((unit, ends), colour), at)| {
                let points = ends.map(|power| (f64::from(power), f64::from(at)));
                Series::new(unit, colour, Style::Solid(5.0), points.into())
            });
        Panel {
            title: name,
            x: Axis::new("power of two of the unit", -800.0, 800.0, 200.0),
            y: Axis::new("unit, in the order of the legend", 0.0, 6.0, 1.0),
            series: strokes.collect(),
            width: 460.0,
        }
    });
    Picture {
        id: "units".into(),
        section: Section::Cost,
        title: "How far units can be changed".into(),
        caption: "Where a stroke ends, the scene in another unit is refused; along the stroke it gives the same bits, \
                  since powers of two round nothing as long as no product under- or overflows."
            .into(),
        alt: "Four panels, a scene each, with five strokes around zero: for another unit of length, of time, of \
              mass, of length and time, and of all three. They end some hundreds of powers of two to either \
              side."
            .into(),
        svg: rows(&panels, 2),
    }
}
