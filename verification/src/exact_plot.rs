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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::{measured_by, shipped};

    /// Fig. 3 where nothing is but approximate.
    fn fig3() -> (Scene, ExactFile, Motion) {
        let scene = measured_by(Strain::Engineering, shipped("fig3"));
        let (file, motion) = ExactFile::of(&scene, 28.7e-6);
        (scene, file, motion)
    }

    #[test]
    fn each_fibre_has_its_strain_and_its_fronts() {
        let (mut scene, file, motion) = fig3();
        let panels = [
            "primary at 28.7000 µs",
            "fronts on the primary",
            "secondary at 28.7000 µs",
            "fronts on the secondary",
        ];
        let drawn = |scene: &Scene| {
            let text = picture(scene, &file, &motion);
            assert!(text.starts_with("<svg") && text.contains("strain (λ − 1), %"), "{text}");
            panels.map(|title| text.contains(title))
        };
        assert_eq!(drawn(&scene), [true; 4]);
        scene.secondary = None;
        assert_eq!(drawn(&scene), [true, true, false, false]);
    }

    /// Numbers with few binary digits, so that none is rounded.
    #[test]
    fn a_profile_is_of_millimetres_and_per_cent_and_steps_from_piece_to_piece() {
        let (_, file, _) = fig3();
        let piece = |from, to, strain| Piece { from, to, strain, ..file.primary[0].clone() };
        let pieces = [piece(0.0, 0.125, 0.015_625), piece(0.125, 0.25, 0.007_812_5)];
        let Panel { x, y, series, .. } = profile(&file, Fibre::Primary, &pieces, 0.25);
        assert_eq!((x.from, x.to, y.from), (0.0, 250.0, 0.0));
        // A tenth beyond the greatest strain.
        assert!((y.to / 1.5625 - 1.1).abs() < 1e-12, "{y:?}");
        let outline = [(0.0, 1.5625), (125.0, 1.5625), (125.0, 0.781_25), (250.0, 0.781_25)];
        assert_eq!(series[0].points, outline);
    }

    #[test]
    fn a_front_is_drawn_among_those_of_its_fibre_family_and_strength() {
        let (_, mut file, mut motion) = fig3();
        file.time = 0.25;
        // The strongest has 8, on the other fibre. At the end of a class a front is of the weaker one.
        let track = |fibre, family, strength, x| {
            let (from, to) = ((x, 0.125), (0.5, 0.25));
            Track { fibre, family, from, to, strength }
        };
        let [primary, secondary] = [Fibre::Primary, Fibre::Secondary];
        let [longitudinal, kink] = [Family::Longitudinal, Family::Kink];
        motion.tracks = vec![
            track(secondary, longitudinal, 8.0, 0.0),
            track(primary, longitudinal, 4.0, 0.0625),
            track(primary, longitudinal, 0.8, 0.125),
            track(primary, longitudinal, 0.08, 0.25),
            track(primary, longitudinal, 0.0079, 0.375),
            track(primary, kink, 6.0, 0.5),
            track(primary, kink, 0.04, 0.625),
        ];
        let Panel { x, y, series, .. } = ways(&file, &motion, primary, 0.5);
        assert_eq!((x.to, y.to), (500.0, 250e3));
        let starts = |points: &[(f64, f64)]| -> Vec<f64> {
            let ways = points.chunks(3).map(|way| {
                assert_eq!((way[0].1, way[1]), (125e3, (500.0, 250e3)));
                assert!(way[2].0.is_nan() && way[2].1.is_nan());
                way[0].0
            });
            ways.collect()
        };
        let drawn: Vec<_> = series.iter().map(|series| starts(&series.points)).collect();
        // Longitudinal ones over 10 %, 1 % and 0.1 % of the strongest, then kinks.
        let expected = [vec![62.5], vec![125.0], vec![250.0], vec![500.0], vec![], vec![625.0]];
        assert_eq!(drawn, expected);
    }

    #[test]
    fn a_fibre_that_no_wave_has_come_to_is_drawn_too() {
        let (scene, ..) = fig3();
        let (file, motion) = ExactFile::of(&scene, 1e-6);
        assert!(picture(&scene, &file, &motion).contains("secondary at 1.0000 µs"));
    }
}
