//! A map of many values, of a colour each, with a bar that says which.
//!
//! The colours are 32 of viridis, which rises evenly in lightness: it reads in grey print, by any
//! colour vision, and on a light and a dark page. Cells of one colour that make a rectangle are drawn
//! as one, in whole numbers of cells: text, sharp at any size. 300 × 200 cells take 40 kB with plateaus
//! between fronts and 150 kB with smooth waves all over; an image inside the picture would take 3 kB,
//! but programs blur it as they enlarge it, and its bytes would be up to a compressor's version.

use std::collections::{BTreeMap, BTreeSet};

use kuva::plot::ColorMap;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, TextAnchor};

use super::frame::Frame;
use super::page::{self, Content};
use super::series::{crisp, number, path};
use super::{Axis, Colour, Panel};

/// A value in every cell of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// What stands over it.
    pub title: String,
    /// The abscissa, which the columns divide evenly.
    pub x: Axis,
    /// The ordinate, which the rows divide evenly.
    pub y: Axis,
    /// What the colours say. Values beyond its ends have the colours of the ends.
    pub value: Axis,
    /// The number of columns.
    pub columns: usize,
    /// Row after row from below, each from left to right. A cell that is no number stays empty.
    pub cells: Vec<f64>,
    /// Width of the panel, pixels; the bar comes beside it.
    pub width: f64,
}

/// The number of colours.
const LEVELS: usize = 32;

/// From the map to the bar, width of the bar, and what the bar and its words take, pixels.
const GAP: f64 = 22.0;
const BAR: f64 = 18.0;
const BESIDE: f64 = 110.0;

/// Sizes of letters, as those of the axes, pixels.
const TICK: u32 = 12;
const LABEL: u32 = 13;

/// The map with its bar.
pub fn map(map: &Map) -> String {
    let Map { title, x, y, .. } = map.clone();
    let panel = Panel { title: title.clone(), x, y, series: vec![], width: map.width };
    let mut scene = page::scene(&[panel], 1, |frame| Content {
        inside: map.drawn(frame),
        beside: map.bar(frame),
    });
    scene.width += BESIDE;
    page::written(&scene, &title)
}

/// A colour, from the lowest, 0.
fn level_colour(level: usize) -> Color {
    ColorMap::Viridis.map(level as f64 / (LEVELS - 1) as f64).into()
}

/// Cells of one level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Block {
    level: usize,
    column: usize,
    row: usize,
    width: usize,
    height: usize,
}

impl Map {
    fn level(&self, value: f64) -> Option<usize> {
        let bounded = value.clamp(self.value.from, self.value.to);
        let share = self.value.share(bounded)?;
        Some(((share * LEVELS as f64) as usize).min(LEVELS - 1))
    }

    /// All cells with a value, each in one block: runs of a row, one over the other where they are the
    /// same.
    fn blocks(&self) -> Vec<Block> {
        let mut blocks: Vec<Block> = Vec::new();
        let mut below = BTreeMap::new();
        for (row, cells) in self.cells.chunks(self.columns).enumerate() {
            let levels: Vec<Option<usize>> = cells.iter().map(|&value| self.level(value)).collect();
            let mut here = BTreeMap::new();
            let mut column = 0;
            for run in levels.chunk_by(|a, b| a == b) {
                if let Some(level) = run[0] {
                    let key = (level, column, run.len());
                    let at = below.get(&key).copied().unwrap_or_else(|| {
                        blocks.push(Block { level, column, row, width: run.len(), height: 0 });
                        blocks.len() - 1
                    });
                    blocks[at].height += 1;
                    here.insert(key, at);
                }
                column += run.len();
            }
            below = here;
        }
        blocks
    }

    fn drawn(&self, frame: &Frame) -> Vec<Primitive> {
        let blocks = self.blocks();
        let levels: BTreeSet<usize> = blocks.iter().map(|block| block.level).collect();
        let of_level = |level: usize| {
            let block = |&Block { column, row, width, height, .. }: &Block| {
                format!("M{column} {row}h{width}v{height}h-{width}z")
            };
            let d = blocks.iter().filter(|block| block.level == level).map(block).collect();
            path(d, level_colour(level), (Color::None, 0.0), None)
        };
        let rows = self.cells.len().div_ceil(self.columns);
        let (left, _, _, low) = frame.ends();
        let (right, up) = (frame.width / self.columns as f64, frame.height / rows as f64);
        let (x, y) = (number(left), number(low));
        // From cells to pixels; more digits than a pixel's, for there are hundreds of cells.
        let transform = format!("translate({x},{y}) scale({right:.6},-{up:.6})");
        crisp(Some(transform), levels.into_iter().map(of_level).collect())
    }

    /// The bar beside the frame: colours, their outline, ticks and the label.
    fn bar(&self, frame: &Frame) -> Vec<Primitive> {
        let (_, right, top, low) = frame.ends();
        let (left, right) = (right + GAP, right + GAP + BAR);
        let up = |share: f64| low - share * frame.height;
        let band = |level: usize| {
            let [from, to] = [level, level + 1].map(|n| number(up(n as f64 / LEVELS as f64)));
            let d = format!("M{} {from}h{BAR}V{to}h-{BAR}z", number(left));
            path(d, level_colour(level), (Color::None, 0.0), None)
        };
        let mut bar = crisp(None, (0..LEVELS).map(band).collect());
        let height = number(frame.height);
        let mut outline = format!("M{} {}h{BAR}v{height}h-{BAR}z", number(left), number(top));
        let mut widest = 0;
        for (share, name) in self.value.ticks() {
            outline += &format!("M{} {}h5", number(right), number(up(share)));
            bar.push(page::text(&name, (right + 9.0, up(share)), TICK, TextAnchor::Start));
            widest = widest.max(name.chars().count());
        }
        bar.push(path(outline, Color::None, (Colour::Black.hex().into(), 1.0), None));
        bar.push(Primitive::Text {
            // Beyond the longest name, of letters about 7 pixels wide.
            x: right + 9.0 + 7.0 * widest as f64 + f64::from(LABEL) + 4.0,
            y: 0.5 * (top + low),
            content: self.value.label.clone(),
            size: LABEL,
            anchor: TextAnchor::Middle,
            rotate: Some(-90.0),
            bold: false,
            color: None,
        });
        bar
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::colour::luminance;

    fn map_of(columns: usize, cells: Vec<f64>) -> Map {
        Map {
            title: "Strain <primary>".into(),
            x: Axis::new("place, mm", 0.0, 300.0, 50.0),
            y: Axis::new("time, µs", 0.0, 90.0, 10.0),
            value: Axis::new("strain, %", 0.0, 2.0, 0.5),
            columns,
            cells,
            width: 700.0,
        }
    }

    #[test]
    fn every_cell_is_in_one_block_of_its_level() {
        // Levels by (7 c + 5 r²) mod 13, with holes: runs that do and do not go on above.
        let (columns, rows) = (23, 17);
        let value = |c: usize, r: usize| match (7 * (c / 3) + 5 * (r / 2) * (r / 2)) % 13 {
            4 => f64::NAN,
            n => n as f64 / 6.1,
        };
        let cells = (0..columns * rows).map(|k| value(k % columns, k / columns)).collect();
        let map = map_of(columns, cells);
        let mut painted = vec![None; columns * rows];
        let blocks = map.blocks();
        for &Block { level, column, row, width, height } in &blocks {
            for r in row..row + height {
                for cell in &mut painted[r * columns + column..][..width] {
                    assert_eq!(cell.replace(level), None);
                }
            }
        }
        let expected: Vec<_> = map.cells.iter().map(|&value| map.level(value)).collect();
        assert_eq!(painted, expected);
        assert!(expected.contains(&None) && blocks.iter().any(|block| block.height > 1));
    }

    #[test]
    fn beyond_the_ends_are_the_colours_of_the_ends() {
        let map = map_of(1, vec![0.0]);
        let levels =
            [-0.3, 0.0, 0.07, 1.01, 2.0, 7.3, f64::INFINITY].map(|v| map.level(v).unwrap());
        // 0.07 / 2 · 32 = 1.12, 1.01 / 2 · 32 = 16.16.
        assert_eq!(levels, [0, 0, 1, 16, 31, 31, 31]);
        // So short an axis is drawn to its end and no farther: a billionth of it is no digit of the end.
        let value = Axis::new("strain", 1.0, 1.0 + 1e-8, 1e-9);
        let short = Map { value, ..map };
        assert_eq!(short.level(1.0 + 1e-8), Some(31));
    }

    #[test]
    fn the_colours_are_ever_lighter() {
        let luminances: Vec<f64> =
            (0..LEVELS).map(|level| luminance(&level_colour(level).to_svg_string())).collect();
        assert!(luminances.windows(2).all(|two| two[0] < two[1]), "{luminances:?}");
    }

    /// Waves that go smoothly up and down everywhere are worse than plateaus between fronts.
    #[test]
    fn a_large_map_of_waves_is_a_small_file() {
        let (columns, rows) = (300, 200);
        let hump = |x: f64| 1.0 / (1.0 + x * x);
        let value = |k: usize| {
            let (x, t) = ((k % columns) as f64, (k / columns) as f64);
            0.9 * hump((x - 1.3 * t) / 9.0) + 0.7 * hump((x + 0.9 * t - 270.0) / 13.0)
        };
        let svg = map(&map_of(columns, (0..columns * rows).map(value).collect()));
        assert!(svg.len() < 300_000, "{}", svg.len());
        assert!(svg.contains("<title>Strain &lt;primary></title>"));
    }
}
