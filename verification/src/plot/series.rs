//! Points that belong together, and how they are drawn.

use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive};

use super::Colour;
use super::frame::Frame;
use super::marks::{Fill, Mark, RADIUS, outline};

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
    /// A solid line with filled marks on its points.
    Marked(Mark),
    /// A dashed line with open marks on its points.
    MarkedDashed(Mark),
    /// An oblique cross for what did not succeed; one at +∞ stands at the top of the axes.
    Failed,
    /// What the points go round, filled.
    Area,
    /// Filled cells of a map around the points, of a size in the units of the axes.
    Cells {
        /// From left to right.
        width: f64,
        /// From below to above.
        height: f64,
    },
}

/// Width of a line with marks, pixels.
const MARKED: f64 = 1.6;

/// Where a mark for +∞ stands, of the height of the axes.
const TOP: f64 = 0.97;

impl Style {
    /// Its line: the width, and the lengths of strokes and gaps as SVG has them.
    fn line(self) -> Option<(f64, Option<&'static str>)> {
        match self {
            Self::Solid(width) => Some((width, None)),
            Self::Dashed(width) => Some((width, Some("7 4"))),
            Self::Dotted(width) => Some((width, Some("2 3"))),
            Self::Marked(_) => Some((MARKED, None)),
            Self::MarkedDashed(_) => Some((MARKED, Some("7 4"))),
            _ => None,
        }
    }

    /// Its marks: which, how filled, and of which size.
    fn mark(self) -> Option<(Mark, Fill, f64)> {
        match self {
            Self::Circles => Some((Mark::Circle, Fill::None, RADIUS)),
            Self::Pluses => Some((Mark::Plus, Fill::None, RADIUS)),
            Self::Triangles => Some((Mark::Triangle, Fill::Full, RADIUS)),
            Self::Marked(mark) => Some((mark, Fill::Full, RADIUS)),
            Self::MarkedDashed(mark) => Some((mark, Fill::Ground, RADIUS)),
            Self::Failed => Some((Mark::Cross, Fill::None, 1.4 * RADIUS)),
            _ => None,
        }
    }
}

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

    /// The series between the axes.
    pub(super) fn drawn(&self, frame: &Frame) -> Vec<Primitive> {
        if let Style::Cells { width, height } = self.style {
            let corners = |&(x, y): &(f64, f64)| {
                let (right, up) = (0.5 * width, 0.5 * height);
                Some((frame.at((x - right, y + up))?, frame.at((x + right, y - up))?))
            };
            return self.cells(self.points.iter().filter_map(corners));
        }
        let place = |&(x, y): &(f64, f64)| {
            if self.style == Style::Failed && y == f64::INFINITY {
                let (x, _) = frame.at((x, frame.panel.y.to))?;
                return Some((x, frame.top + (1.0 - TOP) * frame.height));
            }
            frame.at((x, y))
        };
        let places: Vec<Option<(f64, f64)>> = self.points.iter().map(place).collect();
        let marked: Vec<(f64, f64)> = places.iter().flatten().copied().collect();
        if self.style == Style::Area {
            return self.area(&marked);
        }
        let strokes: Vec<&[Option<(f64, f64)>]> =
            places.split(Option::is_none).filter(|stroke| stroke.len() > 1).collect();
        self.lines(&strokes).into_iter().chain(self.marks(&marked)).collect()
    }

    /// The sample of a legend, between two points on a level.
    pub(super) fn sample(&self, (left, right): (f64, f64), y: f64, height: f64) -> Vec<Primitive> {
        if let Style::Cells { .. } = self.style {
            let (top, low) = (y - 0.5 * height, y + 0.5 * height);
            return self.cells([((left, top), (right, low))].into_iter());
        }
        if self.style == Style::Area {
            let (top, low) = (y - 0.3 * height, y + 0.3 * height);
            return self.area(&[(left, top), (right, top), (right, low), (left, low)]);
        }
        let line = [Some((left, y)), Some((right, y))];
        let mark = self.marks(&[(0.5 * (left + right), y)]);
        self.lines(&[&line]).into_iter().chain(mark).collect()
    }

    /// The line along strokes, if the style has one.
    fn lines(&self, strokes: &[&[Option<(f64, f64)>]]) -> Option<Primitive> {
        let (width, dashes) = self.style.line().filter(|_| !strokes.is_empty())?;
        let mut d = String::new();
        for stroke in strokes {
            for (k, (x, y)) in stroke.iter().flatten().enumerate() {
                d += &format!("{}{} {}", if k == 0 { 'M' } else { 'L' }, number(*x), number(*y));
            }
        }
        Some(path(d, Color::None, (self.colour.hex().into(), width), dashes))
    }

    /// The marks at places, if the style has any.
    fn marks(&self, places: &[(f64, f64)]) -> Option<Primitive> {
        let (mark, fill, radius) = self.style.mark().filter(|_| !places.is_empty())?;
        let d: String = places.iter().map(|&at| outline(mark, at, radius)).collect();
        let width = if self.style == Style::Failed { 2.2 } else { 1.5 };
        Some(path(d, fill.colour(self.colour), (self.colour.hex().into(), width), None))
    }

    /// The area within corners.
    fn area(&self, corners: &[(f64, f64)]) -> Vec<Primitive> {
        let corner = |(k, (x, y)): (usize, &(f64, f64))| {
            format!("{}{} {}", if k == 0 { 'M' } else { 'L' }, number(*x), number(*y))
        };
        let d: String = corners.iter().enumerate().map(corner).collect();
        let fill = self.colour.hex().into();
        let area = (!d.is_empty()).then(|| path(d + "z", fill, (Color::None, 0.0), None));
        area.into_iter().collect()
    }

    /// Rectangles by their upper left and lower right corners, without seams where they meet.
    fn cells(&self, corners: impl Iterator<Item = ((f64, f64), (f64, f64))>) -> Vec<Primitive> {
        let cell = |((left, top), (right, low))| {
            let [left, top, right, low] = [left, top, right, low].map(number);
            format!("M{left} {top}H{right}V{low}H{left}z")
        };
        let d: String = corners.map(cell).collect();
        let fill = self.colour.hex().into();
        if d.is_empty() {
            vec![]
        } else {
            crisp(None, vec![path(d, fill, (Color::None, 0.0), None)])
        }
    }
}

/// What is filled, without soft edges, so that there are no seams where areas meet.
pub fn crisp(transform: Option<String>, areas: Vec<Primitive>) -> Vec<Primitive> {
    let extra_attrs = Some(r#"shape-rendering="crispEdges""#.into());
    let mut group = vec![Primitive::GroupStart { transform, title: None, extra_attrs }];
    group.extend(areas);
    group.push(Primitive::GroupEnd);
    group
}

/// A path with its fill, and its stroke with the width in pixels.
pub fn path(
    d: String,
    fill: Color,
    (stroke, stroke_width): (Color, f64),
    dashes: Option<&str>,
) -> Primitive {
    Primitive::Path(Box::new(PathData {
        d,
        fill: Some(fill),
        stroke,
        stroke_width,
        opacity: None,
        stroke_dasharray: dashes.map(str::to_owned),
    }))
}

/// A number of pixels, to a hundredth.
pub fn number(pixels: f64) -> String {
    let text = format!("{pixels:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
