//! The legend, in columns below the panels, with samples long enough to tell dashes from dots.

use kuva::render::render::{Scene, TextAnchor};

use super::{Panel, Series, page};

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
        for part in series.sample((x, x + SAMPLE), y, 0.7 * LINE) {
            scene.add(part);
        }
        scene.add(page::text(name, (x + SAMPLE + GAP, y), LETTERS, TextAnchor::Start));
    }
    scene.height += LINE * lines as f64 + GAP;
}
