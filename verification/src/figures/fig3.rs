//! Fig. 3: strain along both fibres 28.7 µs after impact.

use super::Snapshots;
use super::points::{Edition, Strains, element};
use crate::cases::support::{exact_single, measured_by, shipped};
use crate::closed_form::problem;
use crate::exact_file::ExactFile;
use crate::exact_plot;
use crate::oracle::motion;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};
use crate::tables::{Table, cell};
use crossfibre::exact::fronts::Segment;
use crossfibre::exact::motion::Motion;
use crossfibre::scene::{Scene, Strain};

/// Times that the paper's mesh is refined for the pictures and the table: 2 and 0.5 mm.
const MESHES: [usize; 2] = [1, 4];

/// The fibres, and how far from their beginning they are shown, mm: just past the fronts.
const FIBRES: [(&str, f64); 2] = [("primary", 220.0), ("secondary", 110.0)];

/// The scene, and its exact motion with engineering strain.
pub fn exact() -> (Scene, Motion) {
    let scene = shipped("fig3");
    let engineering = measured_by(Strain::Engineering, scene.clone());
    let motion = motion(&problem(&engineering), None, scene.duration);
    (scene, motion)
}

/// A stretch of one strain; kinks may lie within.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// Where it begins, m.
    pub from: f64,
    /// Where it ends, m.
    pub to: f64,
    /// Engineering strain λ − 1.
    pub strain: f64,
}

/// The plateaus of a fibre that are longer than 0.1 mm.
pub fn plateaus_of(segments: &[Segment]) -> Vec<Plateau> {
    let mut plateaus: Vec<Plateau> = Vec::new();
    for &Segment { from, to, state } in segments {
        match plateaus.last_mut() {
            // The strains beside a kink differ by rounding.
            Some(last) if (last.strain - state.strain).abs() <= 1e-12 => last.to = to,
            _ => plateaus.push(Plateau { from, to, strain: state.strain }),
        }
    }
    plateaus.retain(|plateau| plateau.to - plateau.from > 1e-4);
    plateaus
}

/// Length of a fibre, m.
fn length(name: &str, scene: &Scene) -> f64 {
    if name == "primary" {
        scene.primary.length
    } else {
        scene.secondary.as_ref().map_or(0.0, |secondary| secondary.length)
    }
}

fn strains_of<'a>(name: &str, strains: &'a Strains) -> &'a [f64] {
    if name == "primary" { &strains.primary } else { &strains.secondary }
}

fn segments<'a>(name: &str, motion: &'a Motion) -> &'a [Segment] {
    if name == "primary" { &motion.primary } else { &motion.secondary }
}

/// Smith's strain of a single fibre, engineering measure: the dotted line.
fn single() -> f64 {
    exact_single(&measured_by(Strain::Engineering, shipped("fig3"))).strain.engineering
}

fn outline(segments: &[Segment]) -> Vec<(f64, f64)> {
    segments
        .iter()
        .flat_map(|s| {
            [(1e3 * s.from, 100.0 * s.state.strain), (1e3 * s.to, 100.0 * s.state.strain)]
        })
        .collect()
}

/// Each element's strain, %, at its middle, mm.
fn marched(length: f64, strain: &[f64]) -> Vec<(f64, f64)> {
    let dx = 1e3 * length / strain.len() as f64;
    strain.iter().enumerate().map(|(i, e)| ((i as f64 + 0.5) * dx, 100.0 * e)).collect()
}

fn panel(
    snapshots: &Snapshots,
    name: &str,
    y: Axis,
    x: Axis,
    curves: &[(Edition, usize, &str, Colour, Style)],
) -> Panel {
    let (scene, motion) = exact();
    let mut series = Vec::new();
    for &(edition, factor, label, colour, style) in curves {
        if let Some(strains) = snapshots.strains(edition, factor) {
            let curve = marched(length(name, &scene), strains_of(name, strains));
            series.push(Series::new(label, colour, style, curve));
        }
    }
    let exact = outline(segments(name, &motion));
    series.push(Series::new("exact, engineering strain", Colour::Black, Style::Solid(1.6), exact));
    let line = vec![(x.from, 100.0 * single()), (x.to, 100.0 * single())];
    let label = format!("single fibre, Smith: {:.2} %", 100.0 * single());
    series.push(Series::new(label, Colour::Grey, Style::Dotted(1.8), line));
    let title = format!("{}{} fibre", name[..1].to_uppercase(), &name[1..]);
    Panel { title, width: if name == "primary" { 620.0 } else { 420.0 }, x, y, series }
}

/// The paper's picture.
pub fn whole(snapshots: &Snapshots) -> String {
    let curves = [
        (Edition::Printed, 1, "as printed, 2 mm", Colour::Vermillion, Style::Solid(1.6)),
        (Edition::Corrected, 1, "corrected, 2 mm", Colour::Blue, Style::Solid(1.6)),
    ];
    let y = Axis::new("strain, %", 0.0, 1.8, 0.2);
    svg(&[
        panel(
            snapshots,
            "primary",
            y.clone(),
            Axis::new("distance from the impact point, mm", 0.0, FIBRES[0].1, 20.0),
            &curves,
        ),
        panel(
            snapshots,
            "secondary",
            Axis::new("strain, %", 0.0, 0.3, 0.05),
            Axis::new("distance from the crossover, mm", 0.0, FIBRES[1].1, 20.0),
            &curves,
        ),
    ])
}

/// The plateaus of the primary, on a finer mesh.
pub fn plateaus(snapshots: &Snapshots) -> String {
    let thin = Style::Solid(1.2);
    let curves = [
        (Edition::Printed, 4, "as printed, 0.5 mm", Colour::Vermillion, thin),
        (Edition::Corrected, 4, "corrected, 0.5 mm", Colour::Blue, thin),
        (Edition::Engineering, 4, "corrected, engineering strain, 0.5 mm", Colour::Green, thin),
    ];
    svg(&[Panel {
        title: "Primary fibre, plateaus".into(),
        width: 900.0,
        ..panel(
            snapshots,
            "primary",
            Axis::new("strain, %", 1.3, 1.7, 0.05),
            Axis::new("distance from the impact point, mm", 0.0, 210.0, 10.0),
            &curves,
        )
    }])
}

/// When the picture of the motion ends, s: the wave from the clamp has been back at the impact point.
pub const MOTION_UNTIL: f64 = 90e-6;

/// The exact motion, as `crossfibre exact --plot` draws it.
pub fn motion_picture() -> String {
    let scene = measured_by(Strain::Engineering, shipped("fig3"));
    let (file, motion) = ExactFile::of(&scene, MOTION_UNTIL);
    exact_plot::picture(&scene, &file, &motion)
}

/// The strains of elements.
pub fn table(snapshots: &Snapshots) -> String {
    let (scene, motion) = exact();
    let mut table = Table::new(&[
        "fibre",
        "element size [m]",
        "middle of the element [m]",
        "strain as printed (4) [1]",
        "strain corrected (4) [1]",
        "strain corrected engineering [1]",
        "strain exact engineering [1]",
    ]);
    for factor in MESHES {
        for (name, shown) in FIBRES {
            let of_editions = Edition::ALL.map(|edition| {
                snapshots.strains(edition, factor).map(|strains| strains_of(name, strains))
            });
            let dx = 1e-3 * element(factor);
            let elements = (length(name, &scene) / dx).round() as usize;
            for i in 0..elements {
                let middle = (i as f64 + 0.5) * dx;
                if middle > 1e-3 * shown {
                    break;
                }
                let exact = segments(name, &motion).iter().find(|s| middle <= s.to);
                let mut row = vec![name.to_owned(), cell(Some(dx)), cell(Some(middle))];
                row.extend(of_editions.map(|found| cell(found.map(|strain| strain[i]))));
                row.push(cell(exact.map(|s| s.state.strain)));
                table.row(&row);
            }
        }
    }
    table.text()
}

/// The segments of the exact profile.
pub fn exact_table() -> String {
    let mut table = Table::new(&["fibre", "from [m]", "to [m]", "strain exact engineering [1]"]);
    let (_, motion) = exact();
    for (name, _) in FIBRES {
        for Segment { from, to, state } in segments(name, &motion) {
            table.row(&[name.into(), cell(Some(*from)), cell(Some(*to)), cell(Some(state.strain))]);
        }
    }
    table.text()
}

#[cfg(test)]
mod tests {
    use crossfibre::exact::riemann::State;
    use nalgebra::Vector3;

    use super::*;

    /// Where pieces end, m, and their strains: beside a kink the strain differs by rounding.
    #[test]
    fn a_plateau_goes_on_past_a_kink_and_is_longer_than_a_tenth_of_a_millimetre() {
        let mut from = 0.0;
        let pieces = [(0.3, 0.017), (0.5, 0.017 + 1e-14), (0.50009, 0.013), (0.5002, 0.011)];
        let segments = pieces.map(|(to, strain)| {
            let state = State { strain, direction: Vector3::x(), velocity: Vector3::zeros() };
            Segment { from: std::mem::replace(&mut from, to), to, state }
        });
        let long = [
            Plateau { from: 0.0, to: 0.5, strain: 0.017 },
            Plateau { from: 0.50009, to: 0.5002, strain: 0.011 },
        ];
        assert_eq!(plateaus_of(&segments), long);
    }
}
