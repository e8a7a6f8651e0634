//! From panels to the text of an SVG: kuva lays the axes out, and what they enclose is put between.

use std::collections::BTreeMap;

use kuva::backend::svg::SvgBackend;
use kuva::plot::LinePlot;
use kuva::render::color::Color;
use kuva::render::figure::Figure;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor};
use kuva::render::theme::Theme;

use super::frame::Frame;
use super::series::{number, path};
use super::{Axis, Colour, Panel, colour};

/// Height of a panel, pixels.
const HEIGHT: f64 = 400.0;

/// Length of a minor tick, pixels.
const MINOR: f64 = 3.0;

/// What is drawn of a panel beside its axes.
pub struct Content {
    /// Cut off at the axes.
    pub inside: Vec<Primitive>,
    /// Not cut off.
    pub beside: Vec<Primitive>,
}

/// The panels in rows of so many columns, as wide as the first row has them.
pub fn scene(panels: &[Panel], columns: usize, content: impl Fn(&Frame) -> Content) -> Scene {
    // Axes are drawn around something only.
    let nothing = panels.iter().map(|_| vec![Plot::Line(LinePlot::new())]).collect();
    let mut figure = Figure::new(panels.len().div_ceil(columns), columns)
        .with_plots(nothing)
        .with_layouts(panels.iter().map(layout).collect())
        .with_cell_size(0.0, HEIGHT);
    for (k, panel) in panels.iter().take(columns).enumerate() {
        figure = figure.with_col_width(k, panel.width);
    }
    let mut scene = figure.render();
    let mut panels = panels.iter();
    for element in std::mem::take(&mut scene.elements) {
        if let &Primitive::ClipStart { x: left, y: top, width, height, .. } = &element
            && let Some(panel) = panels.next()
        {
            let frame = Frame { left, top, width, height, panel };
            let Content { inside, beside } = content(&frame);
            scene.elements.extend(minor_ticks(&frame));
            scene.elements.extend(beside);
            scene.elements.push(element);
            scene.elements.extend(inside);
        } else {
            scene.elements.push(element);
        }
    }
    scene
}

fn layout(panel: &Panel) -> Layout {
    let Panel { title, x, y, .. } = panel;
    let (x_ends, y_ends) = (x.ends(), y.ends());
    let theme = Theme {
        background: colour::GROUND.0.into(),
        grid_color: colour::GRID.0.into(),
        text_color: Colour::Black.hex().into(),
        ..Theme::light()
    };
    Layout::new(x_ends, y_ends)
        .with_x_axis_min(x_ends.0)
        .with_x_axis_max(x_ends.1)
        .with_y_axis_min(y_ends.0)
        .with_y_axis_max(y_ends.1)
        .with_x_tick_step(x.step())
        .with_y_tick_step(y.step())
        .with_x_tick_format(x.format())
        .with_y_tick_format(y.format())
        .with_title(title.clone())
        .with_x_label(x.label.clone())
        .with_y_label(y.label.clone())
        .with_title_size(15)
        .with_label_size(13)
        .with_tick_size(12)
        .with_theme(theme)
}

/// The minor ticks of both axes; kuva's divide linear axes evenly.
fn minor_ticks(frame: &Frame) -> Option<Primitive> {
    let (left, _, _, low) = frame.ends();
    let along = |axis: &Axis, tick: &dyn Fn(f64) -> String| {
        axis.minor_ticks().into_iter().map(tick).collect::<String>()
    };
    let (start, low_end) = (number(left - MINOR), number(low));
    let d = along(&frame.panel.x, &|share| {
        format!("M{} {low_end}v{MINOR}", number(left + share * frame.width))
    }) + &along(&frame.panel.y, &|share| {
        format!("M{start} {}h{MINOR}", number(low - share * frame.height))
    });
    let stroke = Colour::Black.hex().into();
    (!d.is_empty()).then(|| path(d, Color::None, (stroke, 1.0), None))
}

/// A line of text, its middle on a level.
pub fn text(content: &str, (x, y): (f64, f64), size: u32, anchor: TextAnchor) -> Primitive {
    let y = y + 0.36 * f64::from(size);
    let content = content.to_owned();
    Primitive::Text { x, y, content, size, anchor, rotate: None, bold: false, color: None }
}

/// A drawing as the text of an SVG, with its name for those who hear it, and its dark colours.
pub fn written(scene: &Scene, title: &str) -> String {
    let drawing = renumbered(&SvgBackend::new().with_pretty(true).render_scene(scene));
    let escaped = title.replace('&', "&amp;").replace('<', "&lt;");
    let style = colour::style(&drawing);
    let head = format!(" role=\"img\">\n  <title>{escaped}</title>\n  {style}\n");
    drawing.replacen(">\n", &head, 1)
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
