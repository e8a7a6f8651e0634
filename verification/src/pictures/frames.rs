//! The same impact in other frames: turned, mirrored, carried along.

use super::{Picture, Section};
use crate::cases::in_other_frames;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};

/// The picture.
pub fn picture() -> Picture {
    let looks = [
        (Colour::Black, Style::Solid(2.4)),
        (Colour::Blue, Style::Solid(1.8)),
        (Colour::Orange, Style::Dashed(1.8)),
        (Colour::Green, Style::Solid(1.8)),
    ];
    let lines = in_other_frames().into_iter().zip(looks).map(|((name, nodes), (colour, style))| {
        let nodes = nodes.into_iter().map(|(x, y)| (1e3 * x, 1e3 * y));
        Series::new(name, colour, style, nodes.collect())
    });
    Picture {
        id: "frames".into(),
        section: Section::Figures,
        title: "The same impact, turned, mirrored and carried along".into(),
        caption: "The first 60 mm of the primary fibre at the end of Fig. 3, its crossover moved to 12 mm, where the kink \
                  has passed it. Each fibre is the first one moved: to within rounding where it is turned or \
                  carried along, to the bit where it is mirrored."
            .into(),
        alt: "Four lines from the impact point: each goes down along the kink and on along the fibre, one as the \
              scene has it, one turned by 35 degrees, one mirrored to the left, one shifted."
            .into(),
        svg: svg(&[Panel {
            title: "the primary fibre where the experiment is moved".into(),
            x: Axis::new("x, mm", -60.0, 60.0, 20.0),
            y: Axis::new("y, mm", -10.0, 50.0, 10.0),
            series: lines.collect(),
            width: 760.0,
        }]),
    }
}
