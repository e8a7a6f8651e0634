//! Both fibres in motion: a slider over time, and without a script several instants at once.

use maud::{Markup, PreEscaped, html};

use crate::pictures::motion::{Frame, Motion};
use crate::record::Record;
use crate::report::words::visible;

/// What moves the lines.
pub const SCRIPT: &str = include_str!("motion.js");

/// Pixels: the size of a drawing, and for a hundredth of a millimetre along x, up, and along z, which
/// runs to the upper right. Upward it is drawn twice as large.
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 290.0;
const SCALE: f64 = 0.0095;
const UP: f64 = 2.0;
const ALONG_Z: (f64, f64) = (0.35, 0.30);
/// Where the impact point is, pixels.
const ORIGIN: (f64, f64) = (380.0, 205.0);

/// The drawing of strains: its axes, pixels, and how far they go, hundredths of a millimetre.
const AXES: (f64, f64, f64, f64) = (52.0, 744.0, 14.0, 196.0);
const FAR: f64 = 30_000.0;

/// The lines of a frame: the primary, both secondaries, and the strains of each.
type Lines = [String; 5];

fn points(points: impl Iterator<Item = (f64, f64)>) -> String {
    points.map(|(x, y)| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ")
}

fn place(x: f64, y: f64, z: f64) -> (f64, f64) {
    let right = SCALE * (x + ALONG_Z.0 * z);
    (ORIGIN.0 + right, ORIGIN.1 - SCALE * (UP * y + ALONG_Z.1 * z))
}

/// A half and its mirror image, from clamp to clamp.
fn whole<const D: usize>(
    half: &[[i32; D]],
    mirror: impl Fn([f64; D]) -> [f64; D],
) -> Vec<[f64; D]> {
    let half: Vec<[f64; D]> = half.iter().map(|x| x.map(f64::from)).collect();
    half.iter().skip(1).rev().map(|x| mirror(*x)).chain(half.iter().copied()).collect()
}

fn lines(frame: &Frame, spacing: i32, most: f64) -> Lines {
    let primary = whole(&frame.primary, |[x, y]| [-x, y]);
    let secondary = whole(&frame.secondary, |[x, y, z]| [x, y, -z]);
    let strain = |strains: &[i32]| {
        points(strains.iter().enumerate().map(|(k, strain)| {
            let x = (k as f64 + 0.5) * f64::from(spacing);
            on_axes(x, f64::from(*strain), most)
        }))
    };
    [
        points(primary.iter().map(|&[x, y]| place(x, y, 0.0))),
        points(secondary.iter().map(|&[x, y, z]| place(x, y, z))),
        points(secondary.iter().map(|&[x, y, z]| place(-x, y, z))),
        strain(&frame.primary_strain),
        strain(&frame.secondary_strain),
    ]
}

fn on_axes(x: f64, strain: f64, most: f64) -> (f64, f64) {
    let (left, right, top, low) = AXES;
    (left + (right - left) * x / FAR, low - (low - top) * strain / most)
}

/// The greatest strain, rounded up to half a per cent, millionths.
fn most(motion: &Motion) -> f64 {
    let strains =
        motion.frames.iter().flat_map(|f| f.primary_strain.iter().chain(&f.secondary_strain));
    let most = strains.copied().max().unwrap_or(0).max(1);
    (f64::from(most) / 5000.0).ceil() * 5000.0
}

fn time(frame: &Frame) -> String {
    format!("{:.1} µs", 1e-3 * f64::from(frame.time))
}

/// How many instants are drawn without a script.
const INSTANTS: usize = 5;

/// The slider and what it moves.
pub fn motion(record: &Record) -> Markup {
    let Some(motion) = record.motion.as_ref().filter(|motion| !motion.frames.is_empty()) else {
        return html! {};
    };
    let most = most(motion);
    let drawn: Vec<Lines> =
        motion.frames.iter().map(|frame| lines(frame, motion.spacing, most)).collect();
    let frames: Vec<Vec<String>> = motion
        .frames
        .iter()
        .zip(&drawn)
        .map(|(frame, lines)| [&[time(frame)][..], lines].concat())
        .collect();
    // No text in it is of a scene, and no `<` can end the element.
    let data = serde_json::to_string(&frames).unwrap_or_default().replace('<', "\\u003c");
    let last = frames.len() - 1;
    let instants: Vec<usize> = (1..=INSTANTS).map(|k| k * last / INSTANTS).collect();
    let still: Vec<&Lines> = instants.iter().map(|&k| &drawn[k]).collect();
    let first = &drawn[last / 3];
    html! {
        figure.motion id="motion" {
            h3 { "Both fibres in motion" }
            div.slider {
                label for="motion-time" { "Time after impact" }
                input id="motion-time" type="range" min="0" max=(last) value=(last / 3) step="1";
                output id="motion-said" for="motion-time" { (time(&motion.frames[last / 3])) }
            }
            svg role="img" viewBox={ "0 0 " (WIDTH) " " (HEIGHT) }
                aria-label="The struck fibre seen from the side and both fibres that cross it, as lines" {
                (layers(&still, &first[..3], &["primary", "secondary", "secondary"]))
            }
            svg role="img" viewBox={ "0 0 " (WIDTH) " 236" }
                aria-label="Strain along the primary from the impact point and along an arm of the secondary" {
                (axes(most))
                @let strains: Vec<Lines> = still.iter().map(|l| {
                    [l[3].clone(), l[4].clone(), String::new(), String::new(), String::new()] }).collect();
                (layers(&strains.iter().collect::<Vec<_>>(), &first[3..], &["primary", "secondary"]))
            }
            p.key { span.line.primary {} " primary, struck at 400 m/s from below  "
                span.line.secondary {} " secondary, crossing it at 100 mm" }
            figcaption {
                (visible(&motion.title)) ". Corrected equations, 1 mm, carried on to " (time(&motion.frames[last]))
                "; both halves, upward drawn twice as large. "
                span.still { "Without a script: " @for k in instants { (time(&motion.frames[k])) " " }
                    "over one another, the last the darkest. " }
                "Below, strain: the front runs out, the crossover sends a part of it back, the clamp doubles it."
            }
            script id="motion-data" type="application/json" { (PreEscaped(data)) }
        }
    }
}

/// Several instants, and the one that the script moves.
fn layers(still: &[&Lines], live: &[String], classes: &[&str]) -> Markup {
    html! {
        g.still {
            @for (age, lines) in still.iter().enumerate() {
                g opacity=(format!("{:.2}", (age as f64 + 1.0) / still.len() as f64)) {
                    @for (class, line) in classes.iter().zip(lines.iter()) { polyline class=(class) points=(line) {} }
                }
            }
        }
        g.live { @for (class, line) in classes.iter().zip(live) { polyline class=(class) points=(line) {} } }
    }
}

/// Axes of strain over place, with the crossover.
fn axes(most: f64) -> Markup {
    let (left, right, _, low) = AXES;
    let steps = (most / 5000.0) as usize;
    let every = steps.div_ceil(5).max(1);
    let at = |x: f64, strain: f64| on_axes(x, strain, most);
    html! {
        @for k in (0..=steps).step_by(every) {
            @let (_, y) = at(0.0, 5000.0 * k as f64);
            line.grid x1=(left) x2=(right) y1=(format!("{y:.1}")) y2=(format!("{y:.1}")) {}
            text x=(left - 7.0) y=(format!("{:.1}", y + 4.0)) text-anchor="end" { (0.5 * k as f64) }
        }
        @for mm in (0..=300).step_by(50) {
            @let (x, _) = at(100.0 * f64::from(mm), 0.0);
            line.axis x1=(format!("{x:.1}")) x2=(format!("{x:.1}")) y1=(low) y2=(low + 4.0) {}
            text x=(format!("{x:.1}")) y=(low + 18.0) text-anchor="middle" { (mm) }
        }
        line.axis x1=(left) x2=(right) y1=(low) y2=(low) {}
        text x=(0.5 * (left + right)) y="232" text-anchor="middle" {
            "unstrained distance from the impact point, or from the crossover, mm" }
        text x="14" y="105" text-anchor="middle" transform="rotate(-90 14 105)" { "strain, %" }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::motion::fig3;
    use crate::record::made_up;

    #[test]
    fn every_frame_is_drawn_within_the_picture() {
        let motion = fig3();
        let most = most(&motion);
        for frame in &motion.frames {
            for (k, line) in lines(frame, motion.spacing, most).iter().enumerate() {
                let (right, low) = if k < 3 { (WIDTH, HEIGHT) } else { (AXES.1, AXES.3) };
                for point in line.split(' ') {
                    let (x, y) = point.split_once(',').unwrap();
                    let (x, y): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
                    assert!(
                        (0.0..=right).contains(&x) && (0.0..=low + 12.0).contains(&y),
                        "{k}: {point}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_data_cannot_end_their_element() {
        let mut record = made_up::record();
        let hostile = Motion { title: made_up::HOSTILE.into(), ..fig3() };
        record.motion = Some(hostile);
        let page = motion(&record).into_string();
        assert_eq!(page.matches("</script>").count(), 1);
        assert_eq!(page.matches("<script").count(), 1);
    }
}
