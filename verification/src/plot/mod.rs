//! Line plots as SVG, the same bytes for the same data.
//!
//! A plot is a row of [`Panel`]s; a panel has two linear axes and [`Series`]. What leaves the axes is
//! cut off. A coordinate that is not finite breaks a line: gaps and separate strokes of one series are
//! made so. The plot has a white ground of its own, and the colours of Okabe and Ito, which people
//! of any colour vision tell apart; cells of a map have paler and darker ones beside them.

mod legend;

use std::collections::BTreeMap;
use std::sync::Arc;

use kuva::backend::svg::SvgBackend;
use kuva::plot::line::LineStyle;
use kuva::plot::scatter::MarkerShape;
use kuva::plot::{ColorMap, Heatmap, LinePlot, ScatterPlot};
use kuva::render::figure::Figure;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::theme::Theme;

/// A colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Colour {
    Black,
    Grey,
    Blue,
    Sky,
    Green,
    Orange,
    Vermillion,
    Purple,
    Brown,
    Sand,
    Mist,
}

impl Colour {
    fn hex(self) -> &'static str {
        match self {
            Self::Black => "#000000",
            Self::Grey => "#808080",
            Self::Blue => "#0072B2",
            Self::Sky => "#56B4E9",
            Self::Green => "#009E73",
            Self::Orange => "#E69F00",
            Self::Vermillion => "#D55E00",
            Self::Purple => "#CC79A7",
            Self::Brown => "#7a2e00",
            Self::Sand => "#f8dfa8",
            Self::Mist => "#e3ecf4",
        }
    }
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// A line of a width in pixels.
    Solid(f64),
    /// A dashed one.
    Dashed(f64),
    /// A dotted one.
    Dotted(f64),
    /// Open circles.
    Circles,
    /// Crosses, upright.
    Pluses,
    /// Filled triangles.
    Triangles,
    /// Filled cells of a map around the points, of a size in the units of the axes.
    Cells {
        /// From left to right.
        width: f64,
        /// From below to above.
        height: f64,
    },
}

impl Style {
    /// Lengths of strokes and gaps, as SVG has them.
    fn dashes(self) -> Option<String> {
        match self {
            Self::Dashed(_) => Some("7 4".into()),
            Self::Dotted(_) => Some("2 3".into()),
            _ => None,
        }
    }
}

/// Radius of a mark, pixels.
const RADIUS: f64 = 3.8;

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What the legend calls it; none for no line in the legend.
    pub name: Option<String>,
    /// Its colour.
    pub colour: Colour,
    /// How it is drawn.
    pub style: Style,
    /// The points, in the units of the axes.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A named series.
    pub fn new(
        name: impl Into<String>,
        colour: Colour,
        style: Style,
        points: Vec<(f64, f64)>,
    ) -> Self {
        Self { name: Some(name.into()), colour, style, points }
    }
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, with the unit.
    pub label: String,
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// From tick to tick; ticks are at its multiples.
    pub step: f64,
}

impl Axis {
    /// An axis.
    pub fn new(label: impl Into<String>, from: f64, to: f64, step: f64) -> Self {
        Self { label: label.into(), from, to, step }
    }

    /// An axis from 0 to a positive number, with some five to ten ticks at 1, 2 or 5 times a power of ten.
    pub fn from_zero(label: impl Into<String>, to: f64) -> Self {
        let mut step = 1.0;
        while step > to / 6.0 {
            step /= 10.0;
        }
        while step * 10.0 <= to / 6.0 {
            step *= 10.0;
        }
        let wider = [5.0, 2.0].into_iter().map(|n| n * step).find(|s| *s <= to / 5.0);
        Self::new(label, 0.0, to, wider.unwrap_or(step))
    }
}

/// One pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What stands over it.
    pub title: String,
    /// The abscissa.
    pub x: Axis,
    /// The ordinate.
    pub y: Axis,
    /// What is drawn, the last on top.
    pub series: Vec<Series>,
    /// Width of the panel, pixels.
    pub width: f64,
}

/// Height of a panel, pixels.
const HEIGHT: f64 = 400.0;

/// The panels side by side, over one legend.
pub fn svg(panels: &[Panel]) -> String {
    rows(panels, panels.len())
}

/// The panels in rows of so many columns, as wide as the first row has them, over one legend.
pub fn rows(panels: &[Panel], columns: usize) -> String {
    let plots = panels.iter().map(|panel| panel.series.iter().flat_map(drawn).collect()).collect();
    let mut figure = Figure::new(panels.len().div_ceil(columns), columns)
        .with_plots(plots)
        .with_layouts(panels.iter().map(layout).collect())
        .with_cell_size(0.0, HEIGHT);
    for (k, panel) in panels.iter().take(columns).enumerate() {
        figure = figure.with_col_width(k, panel.width);
    }
    let mut scene = figure.render();
    scene.background_color = Some("white".into());
    legend::add(&mut scene, panels);
    renumbered(&SvgBackend::new().with_pretty(true).render_scene(&scene))
}

fn layout(panel: &Panel) -> Layout {
    let Panel { title, x, y, .. } = panel;
    // The rounding of a multiple of the step must not cost the last tick.
    let end = |axis: &Axis| axis.to + 1e-9 * (axis.to - axis.from);
    Layout::new((x.from, x.to), (y.from, y.to))
        .with_x_axis_min(x.from)
        .with_x_axis_max(end(x))
        .with_y_axis_min(y.from)
        .with_y_axis_max(end(y))
        .with_x_tick_step(x.step)
        .with_y_tick_step(y.step)
        .with_x_tick_format(TickFormat::Fixed(decimals(x.step)))
        .with_y_tick_format(TickFormat::Fixed(decimals(y.step)))
        .with_title(title.clone())
        .with_x_label(x.label.clone())
        .with_y_label(y.label.clone())
        .with_title_size(15)
        .with_label_size(13)
        .with_tick_size(12)
        .with_theme(Theme { grid_color: "#e4e4e4".into(), ..Theme::light() })
}

/// Decimals that tell the multiples of a step apart.
fn decimals(step: f64) -> usize {
    format!("{step}").split_once('.').map_or(0, |(_, after)| after.len())
}

/// A series as the strokes it is made of.
fn drawn(series: &Series) -> Vec<Plot> {
    let colour = series.colour.hex();
    let finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
    let marked = |marker, opacity| {
        let points = series.points.iter().copied().filter(finite);
        let marks = ScatterPlot::new()
            .with_data(points)
            .with_color(colour)
            .with_size(RADIUS)
            .with_marker(marker)
            .with_marker_opacity(opacity)
            .with_marker_stroke_width(1.5);
        vec![Plot::Scatter(marks)]
    };
    match series.style {
        Style::Solid(width) | Style::Dashed(width) | Style::Dotted(width) => {
            let style = series.style.dashes().map_or(LineStyle::Solid, LineStyle::Custom);
            let stroke = |points: &[(f64, f64)]| {
                let line = LinePlot::new()
                    .with_data(points.iter().copied())
                    .with_color(colour)
                    .with_stroke_width(width)
                    .with_line_style(style.clone());
                Plot::Line(line)
            };
            let strokes = series.points.split(|point| !finite(point));
            strokes.filter(|points| points.len() > 1).map(stroke).collect()
        }
        Style::Circles => marked(MarkerShape::Circle, 0.0),
        Style::Pluses => marked(MarkerShape::Plus, 1.0),
        Style::Triangles => marked(MarkerShape::Triangle, 1.0),
        Style::Cells { width, height } => {
            let colours = ColorMap::Custom(Arc::new(move |_| colour.into()));
            let cell = |&(x, y): &(f64, f64)| {
                let map = Heatmap::new()
                    .with_data([[0.0]])
                    .with_color_map(colours.clone())
                    .with_x_range(x - 0.5 * width, x + 0.5 * width)
                    .with_y_range(y - 0.5 * height, y + 0.5 * height)
                    .with_cell_size(1.0);
                Plot::Heatmap(map)
            };
            series.points.iter().filter(|point| finite(point)).map(cell).collect()
        }
    }
}

/// What kuva calls its clip paths, with a number from a counter of the whole process.
const CLIP: &str = "kuva-clip-";

/// The text with clip paths numbered in their order, so that it does not depend on what was drawn
/// before.
fn renumbered(svg: &str) -> String {
    let mut parts = svg.split(CLIP);
    let mut text = parts.next().unwrap_or_default().to_owned();
    let mut numbers = BTreeMap::new();
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_digit()).unwrap_or(part.len());
        let next = numbers.len();
        let number = *numbers.entry(&part[..end]).or_insert(next);
        text += &format!("clip-{number}{}", &part[end..]);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(points: Vec<(f64, f64)>) -> Panel {
        Panel {
            title: "A & B".into(),
            x: Axis::new("time, µs", 0.0, 30.0, 10.0),
            y: Axis::new("strain, %", 0.0, 2.0, 0.5),
            series: vec![Series::new("run", Colour::Blue, Style::Dashed(2.0), points)],
            width: 400.0,
        }
    }

    #[test]
    fn what_was_drawn_before_does_not_show() {
        let panels =
            || [panel(vec![(1.7, 0.3), (28.3, 1.45)]), panel(vec![(2.9, 0.1), (3.1, 0.7)])];
        let first = svg(&panels());
        assert!(first.contains("clip-0") && first.contains("clip-1"), "{first}");
        assert!(!first.contains(CLIP) && !first.contains("clip-2"), "{first}");
        assert_eq!(first, svg(&panels()));
    }

    #[test]
    fn a_coordinate_that_is_no_number_breaks_the_line() {
        // One more of them is the legend's.
        let lines = |points| svg(&[panel(points)]).matches("stroke-dasharray").count();
        let whole = lines(vec![(1.0, 0.3), (2.0, 0.4), (3.0, 0.5), (4.0, 0.6), (5.0, 0.7)]);
        let broken = lines(vec![(1.0, 0.3), (2.0, 0.4), (3.0, f64::NAN), (4.0, 0.6), (5.0, 0.7)]);
        assert_eq!(broken, whole + 1);
    }
}
