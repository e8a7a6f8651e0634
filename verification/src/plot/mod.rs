//! Plots as SVG, the same bytes for the same data.
//!
//! A plot is a row of [`Panel`]s; a panel has two axes, linear or logarithmic, and [`Series`]. What
//! leaves the axes is cut off. A point that an axis has no place for breaks a line: a coordinate that
//! is not finite, or that is not positive on a logarithmic axis. Gaps and separate strokes of one
//! series are made so. A [`Map`] has a value in every cell of a grid.
//!
//! A plot has a ground of its own, white, and dark on a screen whose reader prefers dark pages. The
//! colours stand out from both, and people of any colour vision tell them apart.

mod axis;
mod colour;
mod frame;
mod legend;
mod map;
mod marks;
mod page;
mod series;

pub use axis::{Axis, Scale};
pub use colour::Colour;
#[cfg(test)]
pub(crate) use colour::contrast;
pub use map::{Map, map};
pub use marks::Mark;
pub use series::{Series, Style};

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

/// The panels side by side, over one legend.
pub fn svg(panels: &[Panel]) -> String {
    rows(panels, panels.len())
}

/// The panels in rows of so many columns, as wide as the first row has them, over one legend. The
/// titles of the panels together name the picture for those who hear it.
pub fn rows(panels: &[Panel], columns: usize) -> String {
    let mut scene = page::scene(panels, columns, |frame| page::Content {
        inside: frame.panel.series.iter().flat_map(|series| series.drawn(frame)).collect(),
        beside: vec![],
    });
    legend::add(&mut scene, panels);
    let titles: Vec<&str> = panels.iter().map(|panel| panel.title.as_str()).collect();
    page::written(&scene, &titles.join("; "))
}

#[cfg(test)]
mod tests;
