//! The exact motion as a picture: strain along the fibres, and the ways of all fronts over time.

use crossfibre::exact::fronts::{Family, Track};
use crossfibre::exact::motion::Motion;
use crossfibre::place::Fibre;
use crossfibre::scene::{Scene, Strain};

use crate::exact_file::{ExactFile, Piece};
use crate::plot::{Axis, Colour, Panel, Series, Style, rows};

/// Fronts are drawn in three widths, down to this fraction of the strongest, and weaker ones not.
const CLASSES: [(f64, f64, &str); 3] =
    [(0.1, 2.2, "over 10 %"), (0.01, 1.1, "over 1 %"), (0.001, 0.5, "over 0.1 %")];

/// Above, strain against place for each fibre; below, time against place, all fronts.
pub fn picture(scene: &Scene, file: &ExactFile, motion: &Motion) -> String {
    let mut fibres = vec![(Fibre::Primary, &file.primary, scene.primary.length)];
    if let Some(secondary) = &scene.secondary {
        fibres.push((Fibre::Secondary, &file.secondary, secondary.length));
    }
    let profiles =
        fibres.iter().map(|(fibre, pieces, length)| profile(file, *fibre, pieces, *length));
    let ways = fibres.iter().map(|(fibre, _, length)| ways(file, motion, *fibre, *length));
    let panels: Vec<Panel> = profiles.chain(ways).collect();
    rows(&panels, fibres.len())
}

fn place(fibre: Fibre, length: f64) -> Axis {
    let origin = match fibre {
        Fibre::Primary => "the impact point",
        Fibre::Secondary => "the crossover",
    };
    Axis::from_zero(format!("unstrained distance from {origin}, mm"), 1e3 * length)
}

fn profile(file: &ExactFile, fibre: Fibre, pieces: &[Piece], length: f64) -> Panel {
    let measure = match file.measure {
        Strain::Incremental => "ln λ",
        Strain::Engineering => "λ − 1",
    };
    let outline: Vec<_> = pieces
        .iter()
        .flat_map(|piece| [piece.from, piece.to].map(|x| (1e3 * x, 100.0 * piece.strain)))
        .collect();
    let greatest = outline.iter().fold(0.0_f64, |most, &(_, strain)| most.max(strain));
    Panel {
        title: format!("{} at {:.4} µs", fibre.name(), 1e6 * file.time),
        x: place(fibre, length),
        y: Axis::from_zero(format!("strain ({measure}), %"), 1.1 * greatest),
        series: vec![Series {
            name: None,
            colour: Colour::Black,
            style: Style::Solid(1.6),
            points: outline,
        }],
        width: 600.0,
    }
}

fn ways(file: &ExactFile, motion: &Motion, fibre: Fibre, length: f64) -> Panel {
    let strongest = motion.tracks.iter().fold(0.0_f64, |most, track| most.max(track.strength));
    let mut series = Vec::new();
    for (family, colour, name) in [
        (Family::Longitudinal, Colour::Blue, "longitudinal"),
        (Family::Kink, Colour::Vermillion, "kink"),
    ] {
        let mut above = f64::INFINITY;
        for (share, width, words) in CLASSES {
            let of_class = |track: &&Track| {
                let strength = track.strength / strongest;
                track.fibre == fibre
                    && track.family == family
                    && share < strength
                    && strength <= above
            };
            let points = motion.tracks.iter().filter(of_class).flat_map(|track| {
                let end = |(x, time): (f64, f64)| (1e3 * x, 1e6 * time);
                // A gap after each way.
                [end(track.from), end(track.to), (f64::NAN, f64::NAN)]
            });
            let label = format!("{name}, {words} of the strongest");
            series.push(Series::new(label, colour, Style::Solid(width), points.collect()));
            above = share;
        }
    }
    Panel {
        title: format!("fronts on the {}", fibre.name()),
        x: place(fibre, length),
        y: Axis::from_zero("time after impact, µs", 1e6 * file.time),
        series,
        width: 600.0,
    }
}
