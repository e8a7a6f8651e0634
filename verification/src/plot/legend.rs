//! The legend, in columns below the panels, with samples long enough to tell dashes from dots.

use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

use super::{Panel, RADIUS, Series, Style};

/// Height of a line, pixels.
const LINE: f64 = 22.0;

/// Length of a sample, pixels.
const SAMPLE: f64 = 34.0;

/// From a sample to its name, and from column to column, pixels.
const GAP: f64 = 8.0;

/// Size of the letters, and about what one takes of the line, pixels.
const LETTERS: u32 = 13;
const LETTER: f64 = 7.2;

/// Adds the names of all series below what is drawn, each name once.
pub fn add(scene: &mut Scene, panels: &[Panel]) {
    let mut entries: Vec<(&str, &Series)> = Vec::new();
    for series in panels.iter().flat_map(|panel| &panel.series) {
        let Some(name) = series.name.as_deref() else { continue };
        if !entries.iter().any(|(known, _)| *known == name) {
            entries.push((name, series));
        }
    }
    let longest = entries.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let column = SAMPLE + GAP + LETTER * longest as f64 + 2.0 * GAP;
    let columns = ((scene.width / column) as usize).clamp(1, entries.len().max(1));
    let lines = entries.len().div_ceil(columns);
    let left = (scene.width - column * columns as f64 + 2.0 * GAP) / 2.0;
    for (k, (name, series)) in entries.into_iter().enumerate() {
        let x = left + column * (k / lines) as f64;
        let y = scene.height + LINE * ((k % lines) as f64 + 0.5);
        sample(scene, series, x, y);
        scene.add(Primitive::Text {
            x: x + SAMPLE + GAP,
            y: y + 0.36 * f64::from(LETTERS),
            content: name.into(),
            size: LETTERS,
            anchor: TextAnchor::Start,
            rotate: None,
            bold: false,
            color: None,
        });
    }
    scene.height += LINE * lines as f64 + GAP;
}

/// A piece of a line, or a mark, as the series has it.
fn sample(scene: &mut Scene, series: &Series, x: f64, y: f64) {
    let colour = || Color::from(series.colour.hex());
    let middle = x + SAMPLE / 2.0;
    let mut path = |d: String, width, fill: Option<Color>, dashes| {
        scene.add(Primitive::Path(Box::new(PathData {
            d,
            fill,
            stroke: colour(),
            stroke_width: width,
            opacity: None,
            stroke_dasharray: dashes,
        })));
    };
    let r = RADIUS;
    match series.style {
        Style::Solid(width) | Style::Dashed(width) | Style::Dotted(width) => {
            let line = format!("M{x:.2},{y:.2} L{:.2},{y:.2}", x + SAMPLE);
            path(line, width, None, series.style.dashes());
        }
        Style::Pluses => {
            let (left, right, top, low) = (middle - r, middle + r, y - r, y + r);
            let d = format!(
                "M{left:.2},{y:.2} L{right:.2},{y:.2} M{middle:.2},{top:.2} L{middle:.2},{low:.2}"
            );
            path(d, 1.5, None, None);
        }
        Style::Triangles => {
            let (top, low) = (y - 1.02 * r, y + 0.68 * r);
            let (left, right) = (middle - r, middle + r);
            let d = format!("M{middle:.2},{top:.2} L{left:.2},{low:.2} L{right:.2},{low:.2} Z");
            path(d, 0.5, Some(colour()), None);
        }
        Style::Cells { .. } => {
            let (right, top, low) = (x + SAMPLE, y - 0.35 * LINE, y + 0.35 * LINE);
            let d = format!(
                "M{x:.2},{low:.2} L{x:.2},{top:.2} L{right:.2},{top:.2} L{right:.2},{low:.2} Z"
            );
            path(d, 0.0, Some(colour()), None);
        }
        Style::Circles => scene.add(Primitive::Circle {
            cx: middle,
            cy: y,
            r,
            fill: colour(),
            fill_opacity: Some(0.0),
            stroke: Some(colour()),
            stroke_width: Some(1.5),
        }),
    }
}
