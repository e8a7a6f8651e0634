//! Marks, told apart by their outlines.

use kuva::render::color::Color;

use super::Colour;
use super::colour::GROUND;
use super::series::number;

/// A mark on a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Mark {
    Circle,
    Square,
    Triangle,
    Diamond,
    /// A cross, upright.
    Plus,
    /// A cross, oblique.
    Cross,
}

/// Radius of a mark, pixels.
pub const RADIUS: f64 = 3.8;

/// What is inside a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// Its own colour.
    Full,
    /// The ground, so that a line does not show through.
    Ground,
    /// What is behind it.
    None,
}

impl Fill {
    /// The colour inside a mark of a colour.
    pub fn colour(self, mark: Colour) -> Color {
        match self {
            Self::Full => mark.hex().into(),
            Self::Ground => GROUND.0.into(),
            Self::None => Color::None,
        }
    }
}

/// The outline of a mark at a point, as SVG has it. All look about as large as the circle.
pub fn outline(mark: Mark, (x, y): (f64, f64), radius: f64) -> String {
    let [start, across] = [x - radius, 2.0 * radius].map(number);
    let [r, y_text] = [radius, y].map(number);
    let closed = |corners: &[(f64, f64)]| {
        let corner = |(k, (right, down)): (usize, &(f64, f64))| {
            let [x, y] = [x + radius * right, y + radius * down].map(number);
            format!("{}{x} {y}", if k == 0 { 'M' } else { 'L' })
        };
        corners.iter().enumerate().map(corner).collect::<String>() + "z"
    };
    match mark {
        Mark::Circle => {
            format!("M{start} {y_text}a{r} {r} 0 1 0 {across} 0a{r} {r} 0 1 0 -{across} 0z")
        }
        Mark::Square => closed(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
        Mark::Triangle => closed(&[(0.0, -1.2), (-1.1, 0.7), (1.1, 0.7)]),
        Mark::Diamond => closed(&[(0.0, -1.35), (1.35, 0.0), (0.0, 1.35), (-1.35, 0.0)]),
        Mark::Plus => {
            let [left, top] = [x - 1.2 * radius, y - 1.2 * radius].map(number);
            let [x, length] = [x, 2.4 * radius].map(number);
            format!("M{left} {y_text}h{length}M{x} {top}v{length}")
        }
        Mark::Cross => {
            let [left, top, low] =
                [x - 0.9 * radius, y - 0.9 * radius, y + 0.9 * radius].map(number);
            let length = number(1.8 * radius);
            format!("M{left} {top}l{length} {length}M{left} {low}l{length} -{length}")
        }
    }
}
