//! How R of Fig. 3 moves with the window that the strain behind the crossover is averaged over.

use crossfibre::exact::fronts::Segment;
use crossfibre::exact::motion::Motion;
use crossfibre::scene::Strain;

use super::Snapshots;
use super::fig3::exact;
use super::points::{Edition, PROFILE_MESHES, element, mean_over};
use crate::cases::support::{exact_single, measured_by, shipped};
use crate::closed_form::component;
use crate::fronts::Fronts;
use crate::plot::{Axis, Colour, Panel, Series, Style, svg};
use crate::tables::{Table, cell};

/// Widths of the windows, mm.
pub const WIDTHS: [f64; 3] = [10.0, 20.0, 40.0];

/// The way from the impact point to the crossover, mm.
const WAY: u32 = 100;

/// Where a window of a width may begin, mm: at every millimetre.
fn starts(width: f64) -> Vec<f64> {
    (0..=WAY).map(f64::from).filter(|start| start + width <= f64::from(WAY)).collect()
}

/// The exact incident strain of Fig. 3 in a measure.
fn incident(measure: Strain) -> f64 {
    let scene = measured_by(measure, shipped("fig3"));
    component(&scene, exact_single(&scene).strain)
}

/// R by the exact profile, engineering strain, from a mean over a window, mm.
fn exact_reflection(motion: &Motion, from: f64, to: f64) -> f64 {
    let (from, to) = (1e-3 * from, 1e-3 * to);
    let share = |s: &Segment| (s.to.min(to) - s.from.max(from)).max(0.0) * s.state.strain;
    let mean = motion.primary.iter().map(share).sum::<f64>() / (to - from);
    mean / incident(Strain::Engineering) - 1.0
}

/// R of a run from a mean over a window, mm; none if the run did not complete.
fn reflection(
    snapshots: &Snapshots,
    (edition, factor): (Edition, usize),
    from: f64,
    to: f64,
) -> Option<f64> {
    let length = shipped("fig3").primary.length;
    let strains = snapshots.strains(edition, factor)?;
    let mean = mean_over(length, &strains.primary, (1e-3 * from, 1e-3 * to));
    Some(mean / incident(edition.measure()) - 1.0)
}

/// A family of windows, all widths taken together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// From the wavelet that the reflected wave has shed at the kink, to the crossover: the strain is
    /// uniform there.
    Uniform,
    /// From the kink to the crossover, blind to the wavelet.
    FromKink,
}

impl Family {
    /// Where its windows begin at the earliest, mm.
    pub fn begins(self) -> f64 {
        let scene = shipped("fig3");
        let fronts = Fronts::of(&measured_by(Strain::Engineering, scene.clone()), scene.duration);
        1e3 * match self {
            Self::Uniform => fronts.wavelet.unwrap_or(fronts.reflected),
            Self::FromKink => fronts.kink,
        }
    }
}

/// The smallest and the largest of numbers.
fn range(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// The windows of a family, mm.
fn windows(family: Family) -> impl Iterator<Item = (f64, f64)> {
    let first = family.begins();
    WIDTHS.into_iter().flat_map(move |width| {
        let starts = starts(width).into_iter().filter(move |&start| start >= first);
        starts.map(move |start| (start, start + width))
    })
}

/// The smallest and the largest R of a run over a family of windows; none if it did not complete.
pub fn extremes(
    snapshots: &Snapshots,
    run: (Edition, usize),
    family: Family,
) -> Option<(f64, f64)> {
    let found: Option<Vec<f64>> =
        windows(family).map(|(from, to)| reflection(snapshots, run, from, to)).collect();
    Some(range(found?.into_iter()))
}

/// The same by the exact profile.
pub fn exact_extremes(family: Family) -> (f64, f64) {
    let (_, motion) = exact();
    range(windows(family).map(|(from, to)| exact_reflection(&motion, from, to)))
}

/// How meshes are drawn.
const MESHES: [(usize, Colour, f64); 3] = [
    (PROFILE_MESHES[0], Colour::Orange, 1.8),
    (PROFILE_MESHES[1], Colour::Blue, 1.6),
    (PROFILE_MESHES[2], Colour::Vermillion, 1.4),
];

/// R against where the window begins, a panel for each width.
pub fn picture(snapshots: &Snapshots, edition: Edition) -> String {
    let (_, motion) = exact();
    let panels = WIDTHS.map(|width| {
        let along = |of: &dyn Fn(f64) -> f64| starts(width).iter().map(|&x| (x, of(x))).collect();
        let mut series: Vec<Series> = MESHES
            .iter()
            .map(|&(factor, colour, line)| {
                let run = (edition, factor);
                let found = |from| reflection(snapshots, run, from, from + width);
                let points = along(&|from| found(from).unwrap_or(f64::NAN));
                let name = format!("{}, {} mm", edition.label(), element(factor));
                Series::new(name, colour, Style::Solid(line), points)
            })
            .collect();
        let points = along(&|from| exact_reflection(&motion, from, from + width));
        series.push(Series::new("exact profile", Colour::Black, Style::Dashed(1.6), points));
        Panel {
            title: format!("Window {width} mm wide"),
            x: Axis::new("begins at, mm from the impact point", 0.0, f64::from(WAY), 20.0),
            y: Axis::new("R", -0.03, 0.08, 0.01),
            series,
            width: 370.0,
        }
    });
    svg(&panels)
}

/// R of every window, run and of the exact profile.
pub fn table(snapshots: &Snapshots) -> String {
    let (_, motion) = exact();
    let runs: Vec<(Edition, usize)> = Edition::ALL
        .into_iter()
        .flat_map(|edition| PROFILE_MESHES.map(|factor| (edition, factor)))
        .collect();
    let names: Vec<String> = runs
        .iter()
        .map(|&(edition, factor)| format!("R {} {} mm [1]", edition.name(), element(factor)))
        .collect();
    let mut columns = vec!["width [m]", "begins at [m]", "R exact profile [1]"];
    columns.extend(names.iter().map(String::as_str));
    let mut table = Table::new(&columns);
    for width in WIDTHS {
        for from in starts(width) {
            let to = from + width;
            let mut row = [1e-3 * width, 1e-3 * from, exact_reflection(&motion, from, to)]
                .map(|x| cell(Some(x)))
                .to_vec();
            row.extend(runs.iter().map(|&run| cell(reflection(snapshots, run, from, to))));
            table.row(&row);
        }
    }
    table.text()
}
