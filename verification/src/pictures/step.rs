//! The step of four elements that is worked by hand, drawn.

use crossfibre::number::Vector;
use crossfibre::state::State;

use super::{Picture, Section};
use crate::cases::four_elements;
use crate::plot::{Axis, Colour, Mark, Panel, Series, Style, svg};

/// Units of length that a tension of 1 is drawn with.
const OF_TENSION: f64 = 0.006;

/// The picture.
pub fn picture() -> Picture {
    let (before, after) = four_elements();
    Picture {
        id: "step".into(),
        section: Section::Figures,
        title: "The step that is worked by hand".into(),
        caption: "A fibre of four elements before and after one step. Left, (2) and (5): tensions pull the nodes, \
                  whose velocities carry them on; the first goes with the projectile, the last is clamped. Right, \
                  (4), (6) and (7): the new lengths strain the elements and turn their tensions. The fourth, \
                  which the wave has not reached, keeps its own."
            .into(),
        alt: "Two panels of five nodes joined by four elements in a zigzag. Left, from each node a stroke to \
              where it is one step later, and on the middle of each element its tension before. Right, the \
              nodes after the step with the tensions then."
            .into(),
        svg: svg(&[moved(&before, &after), pulled(&after)]),
    }
}

fn moved(before: &State<f64>, after: &State<f64>) -> Panel {
    let (from, to) = (&before.primary.position, &after.primary.position);
    let way = from.iter().zip(to).flat_map(|(from, to)| stroke(from, to));
    panel(
        "before the step, and the way of each node in it",
        vec![
            fibre("before the step", Style::MarkedDashed(Mark::Circle), before),
            Series::new("v Δt", Colour::Orange, Style::Solid(2.4), way.collect()),
            tensions("tension of an element, before", before),
        ],
    )
}

fn pulled(after: &State<f64>) -> Panel {
    panel(
        "after the step",
        vec![
            fibre("after the step", Style::Marked(Mark::Circle), after),
            tensions("tension of an element, after", after),
        ],
    )
}

fn panel(title: &str, series: Vec<Series>) -> Panel {
    Panel {
        title: title.into(),
        x: Axis::new("x", 0.0, 3.6, 0.5),
        y: Axis::new("y", 0.0, 2.4, 0.5),
        series,
        width: 560.0,
    }
}

fn fibre(name: &str, style: Style, state: &State<f64>) -> Series {
    let nodes = state.primary.position.iter().map(|node| (node.x, node.y));
    Series::new(name, Colour::Black, style, nodes.collect())
}

/// On the middle of each element, the way of its tension.
fn tensions(name: &str, state: &State<f64>) -> Series {
    let fibre = &state.primary;
    let strokes = fibre.position.windows(2).zip(&fibre.pull).flat_map(|(ends, pull)| {
        let middle = (ends[0] + ends[1]) * 0.5;
        let half = *pull * (OF_TENSION / 2.0);
        stroke(&(middle - half), &(middle + half))
    });
    Series::new(name, Colour::Blue, Style::Solid(2.4), strokes.collect())
}

/// A stroke, and a gap after it.
fn stroke(from: &Vector<f64, 2>, to: &Vector<f64, 2>) -> [(f64, f64); 3] {
    [(from.x, from.y), (to.x, to.y), (f64::NAN, f64::NAN)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_node_has_its_way_and_every_element_its_tension() {
        let (before, after) = four_elements();
        let Panel { series, .. } = moved(&before, &after);
        assert_eq!([series[0].points.len(), series[1].points.len() / 3], [5, 5]);
        assert_eq!(series[2].points.len() / 3, 4);
        // The clamped node stays, the projectile's goes on.
        assert_eq!(series[1].points[12], series[1].points[13]);
        assert_ne!(series[1].points[0], series[1].points[1]);
    }
}
