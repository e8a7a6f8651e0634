//! Errors against measured time, and against machine instructions where they were counted.

use crossfibre::scene::Strain;

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::Record;
use super::super::times::{ENGINE, Seconds, TimedRun, Times};
use super::BASES;
use super::errors::ends;
use super::looks::look;
use crate::plot::{Axis, Colour, Mark, Panel, Series, Style, rows};

/// The error that is drawn.
const QUANTITY: Quantity = Quantity::StrainL1;

/// The error of a timed run; none if it did not complete.
pub fn error(record: &Record, run: &TimedRun) -> Option<f64> {
    // The engine's bits are those of the first variant.
    let variant = if run.contestant == ENGINE { BASES[0] } else { &run.contestant };
    let entries = record.series(run.problem, variant);
    entries.iter().find(|entry| entry.elements == run.elements)?.error(QUANTITY)
}

/// The contestants of a problem, in the order in which they were run.
pub fn contestants(times: &Times, problem: Problem) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for run in times.runs.iter().filter(|run| run.problem == problem) {
        if !names.contains(&run.contestant.as_str()) {
            names.push(&run.contestant);
        }
    }
    names
}

/// The picture: the problems against time, then against instructions where these were counted.
pub fn picture(record: &Record, times: &Times) -> String {
    let (timed, counted) = panels(record, times);
    let columns = timed.len().clamp(1, 2);
    rows(&[timed, counted].concat(), columns)
}

fn panels(record: &Record, times: &Times) -> (Vec<Panel>, Vec<Panel>) {
    let of = |problem| times.runs.iter().filter(move |run| run.problem == problem);
    let timed = Problem::ALL.into_iter().filter(|&problem| of(problem).next().is_some());
    let counted = timed.clone().filter(|&p| of(p).any(|run| run.instructions.is_some()));
    (
        timed.map(|problem| against_time(record, times, problem)).collect(),
        counted.map(|problem| against_instructions(record, times, problem)).collect(),
    )
}

/// Points of each contestant by an abscissa.
fn series(
    record: &Record,
    times: &Times,
    problem: Problem,
    x: impl Fn(&TimedRun) -> Option<f64>,
) -> Vec<Series> {
    let of = |name: &str| {
        let is_its = |run: &&TimedRun| run.problem == problem && run.contestant == name;
        let point = |run: &TimedRun| Some((x(run)?, error(record, run)?));
        let (colour, style) = look(name);
        let points = times.runs.iter().filter(is_its).filter_map(point).collect();
        Series::new(name, colour, style, points)
    };
    contestants(times, problem).into_iter().map(of).collect()
}

fn panel(title: String, label: &str, x: (f64, f64), series: Vec<Series>) -> Panel {
    let is_marked = |series: &&Series| !matches!(series.style, Style::Solid(_));
    let marked = series.iter().filter(is_marked);
    let (low, high) = ends(marked.flat_map(|series| series.points.iter().map(|p| p.1)));
    Panel {
        title,
        x: Axis::logarithmic(label, x.0, x.1),
        y: Axis::logarithmic("strain profile, L1: error of the norm", low, high),
        series,
        width: 645.0,
    }
}

fn against_time(record: &Record, times: &Times, problem: Problem) -> Panel {
    let marches = series(record, times, problem, |run| Some(run.seconds.least));
    let (least, _) = ends(marches.iter().flat_map(|series| series.points.iter().map(|p| p.1)));
    let its_exact = || times.exact.iter().filter(move |exact| exact.problem == problem);
    // A bound far below the errors of marches stands a little below everything else.
    let near = its_exact().map(|e| e.error_bound).filter(|bound| *bound > 0.05 * least);
    let lowest = 0.4 * near.fold(least, f64::min);
    let bound = |bound: f64| bound.max(lowest);
    // From the least to the greatest.
    let is_its = |run: &&TimedRun| run.problem == problem;
    let bars = times.runs.iter().filter(is_its).flat_map(|run| {
        let y = error(record, run).unwrap_or(f64::NAN);
        bar(&run.seconds, y, look(&run.contestant).0)
    });
    let mut all: Vec<Series> = bars.collect();
    all.extend(marches);
    for (strain, name, style) in [
        (Strain::Engineering, "exact fronts, engineering", Style::Marked(Mark::Triangle)),
        (Strain::Incremental, "exact fronts, eqn (4)", Style::MarkedDashed(Mark::Triangle)),
    ] {
        let solved = its_exact().filter(|exact| exact.strain == strain);
        let points: Vec<_> =
            solved.clone().map(|e| (e.seconds.least, bound(e.error_bound))).collect();
        if !points.is_empty() {
            all.extend(solved.flat_map(|e| bar(&e.seconds, bound(e.error_bound), Colour::Purple)));
            all.push(Series::new(name, Colour::Purple, style, points));
        }
    }
    let x = ends(all.iter().flat_map(|series| series.points.iter().map(|p| p.0)));
    panel(format!("{}: time", problem.title()), "measured time, s", x, all)
}

fn bar(seconds: &Seconds, y: f64, colour: Colour) -> Option<Series> {
    let points = vec![(seconds.least, y), (seconds.greatest, y)];
    let style = Style::Solid(1.2);
    y.is_finite().then_some(Series { name: None, colour, style, points })
}

fn against_instructions(record: &Record, times: &Times, problem: Problem) -> Panel {
    let all = series(record, times, problem, |run| run.instructions);
    let x = ends(all.iter().flat_map(|series| series.points.iter().map(|p| p.0)));
    panel(format!("{}: instructions", problem.title()), "machine instructions", x, all)
}

#[cfg(test)]
mod tests {
    use super::super::super::times::{FORMAT, TimedExact};
    use super::super::made_up::{entry, record};
    use super::*;

    fn seconds(least: f64) -> Seconds {
        Seconds { least, median: 1.1 * least, greatest: 1.7 * least }
    }

    fn run(problem: Problem, contestant: &str, elements: usize) -> TimedRun {
        TimedRun {
            problem,
            contestant: contestant.into(),
            elements,
            seconds: seconds(1e-8 * (elements * elements) as f64),
            instructions: None,
        }
    }

    fn times(runs: Vec<TimedRun>, exact: Vec<TimedExact>) -> Times {
        Times {
            format: FORMAT.into(),
            machine: "none".into(),
            calibration: seconds(0.1),
            rounds: 3,
            runs,
            exact,
        }
    }

    fn drawn(bound: f64) -> Panel {
        let run = |contestant, elements| run(Problem::Crossed, contestant, elements);
        let exact = TimedExact {
            problem: Problem::Crossed,
            strain: Strain::Engineering,
            resolution: 1e-9,
            meetings: 31,
            error_bound: bound,
            seconds: seconds(3e-5),
        };
        let runs = vec![run(BASES[0], 100), run(ENGINE, 100), run(BASES[0], 300)];
        let times = times(runs, vec![exact]);
        let record =
            record(vec![entry(BASES[0], 3e-3, Some(0.043)), entry(BASES[0], 1e-3, Some(0.017))]);
        against_time(&record, &times, Problem::Crossed)
    }

    fn points<'p>(panel: &'p Panel, name: &str) -> &'p [(f64, f64)] {
        let named = panel.series.iter().find(|series| series.name.as_deref() == Some(name));
        &named.unwrap().points
    }

    #[test]
    fn a_problem_whose_instructions_were_not_counted_has_no_panel_of_them() {
        let counted = TimedRun { instructions: Some(7.0e5), ..run(Problem::Single, BASES[0], 100) };
        let times = times(vec![counted, run(Problem::Crossed, BASES[0], 100)], vec![]);
        let (timed, counted) = panels(&record(vec![]), &times);
        assert_eq!((timed.len(), counted.len()), (2, 1));
    }

    #[test]
    fn the_engine_has_the_errors_of_the_first_variant() {
        let panel = drawn(0.0);
        assert_eq!(points(&panel, BASES[0]), [(1e-8 * 1e4, 0.043), (1e-8 * 9e4, 0.017)]);
        assert_eq!(points(&panel, ENGINE), [(1e-8 * 1e4, 0.043)]);
    }

    #[test]
    fn exact_fronts_stand_at_their_bound_or_below_everything() {
        let height = |panel: &Panel| points(panel, "exact fronts, engineering")[0].1;
        assert_eq!(height(&drawn(0.0041)), 0.0041);
        for nothing in [0.0, 1e-16] {
            let panel = drawn(nothing);
            let height = height(&panel);
            assert!(panel.y.from < height && height < 0.5 * 0.017, "{height}");
        }
    }
}
