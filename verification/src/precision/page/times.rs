//! The page of measured times.

use super::super::pictures::time::{contestants, error};
use super::super::problems::Problem;
use super::super::record::Record;
use super::super::times::{Seconds, TimedExact, TimedRun, Times};
use super::super::variants::VARIANTS;
use crate::tables::markdown;

/// The page: ratios first.
pub fn page(record: &Record, times: &Times) -> String {
    [head(times), ratios(times), marches(record, times), solutions(times)].join("\n")
}

fn head(times: &Times) -> String {
    let Times { machine, calibration, rounds, .. } = times;
    format!(
        "\
# Measured times

Drawn and written from [times.json](times.json). Machine: {machine}. Each contestant ran {rounds} times, in turns with all
others of its problem. The least time is what a run takes when nothing disturbs it; the spread is the
greatest over the least. A calibration loop, by which the times of two machines are set in relation, took
{}, spread {:.2}.
",
        duration(calibration.least),
        spread(calibration)
    )
}

fn spread(seconds: &Seconds) -> f64 {
    seconds.greatest / seconds.least
}

/// Seconds in the unit that suits them.
fn duration(seconds: f64) -> String {
    let (number, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    format!("{number:.3} {unit}")
}

/// The problems that were timed.
fn timed(times: &Times) -> impl Iterator<Item = Problem> {
    let is_timed = |problem: &Problem| times.runs.iter().any(|run| run.problem == *problem);
    Problem::ALL.into_iter().filter(is_timed)
}

fn run_of<'t>(
    times: &'t Times,
    problem: Problem,
    contestant: &str,
    elements: usize,
) -> Option<&'t TimedRun> {
    times.runs.iter().find(|run| {
        run.problem == problem && run.contestant == contestant && run.elements == elements
    })
}

/// Each contestant over the first variant, on the finest mesh that both ran; instructions on the finest on
/// which those of both were counted.
fn ratios(times: &Times) -> String {
    let reference = VARIANTS[0].name;
    let mut rows = Vec::new();
    for problem in timed(times) {
        for name in contestants(times, problem) {
            let runs = times.runs.iter().filter(|r| r.problem == problem && r.contestant == name);
            let pair = |run: &'_ TimedRun| run_of(times, problem, reference, run.elements);
            let pairs: Vec<_> = runs.filter_map(|run| Some((run, pair(run)?))).collect();
            let Some((run, first)) = pairs.iter().max_by_key(|(run, _)| run.elements) else {
                continue;
            };
            let counts = pairs.iter().filter_map(|(run, first)| {
                Some((run.elements, run.instructions?, first.instructions?))
            });
            let counted = counts.max_by_key(|(elements, ..)| *elements);
            rows.push(vec![
                problem.id().to_owned(),
                name.to_owned(),
                run.elements.to_string(),
                format!("{:.3}", run.seconds.least / first.seconds.least),
                format!("{:.3}", run.seconds.median / first.seconds.median),
                counted.map_or("–".into(), |(_, own, first)| format!("{:.3}", own / first)),
            ]);
        }
    }
    let head = ["problem", "contestant", "elements", "least", "median", "instructions"];
    format!("## Times and instructions over those of {reference}\n\n{}", markdown(&head, &rows))
}

fn marches(record: &Record, times: &Times) -> String {
    let row = |run: &TimedRun| {
        let Seconds { least, median, .. } = run.seconds;
        vec![
            run.problem.id().into(),
            run.contestant.clone(),
            run.elements.to_string(),
            error(record, run).map_or("–".into(), |error| format!("{error:.1e}")),
            duration(least),
            duration(median),
            format!("{:.2}", spread(&run.seconds)),
            run.instructions.map_or("–".into(), |count| format!("{count:.3e}")),
        ]
    };
    let rows: Vec<_> = times.runs.iter().map(row).collect();
    let head =
        ["problem", "contestant", "elements", "L1", "least", "median", "spread", "instructions"];
    format!("## Marches\n\n{}", markdown(&head, &rows))
}

fn solutions(times: &Times) -> String {
    let row = |exact: &TimedExact| {
        vec![
            exact.problem.id().into(),
            format!("{:?}", exact.strain).to_lowercase(),
            format!("{:e}", exact.resolution),
            exact.meetings.to_string(),
            format!("{:.1e}", exact.error_bound),
            duration(exact.seconds.least),
            duration(exact.seconds.median),
            format!("{:.2}", spread(&exact.seconds)),
        ]
    };
    let rows: Vec<_> = times.exact.iter().map(row).collect();
    let head =
        ["problem", "strain", "resolution", "meetings", "bound of L1", "least", "median", "spread"];
    format!(
        "## Exact fronts\n\nThe mean error of strain that a solution admits is a bound of its L1.\n\n{}",
        markdown(&head, &rows)
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::times::FORMAT;
    use super::*;

    #[test]
    fn a_problem_is_timed_of_which_there_is_a_run() {
        let seconds = Seconds { least: 0.3, median: 0.3, greatest: 0.3 };
        let run = TimedRun {
            problem: Problem::Unequal,
            contestant: "one".into(),
            elements: 7,
            seconds,
            instructions: None,
        };
        let times = Times {
            format: FORMAT.into(),
            machine: "none".into(),
            calibration: seconds,
            rounds: 3,
            runs: vec![run],
            exact: vec![],
        };
        assert_eq!(timed(&times).collect::<Vec<_>>(), [Problem::Unequal]);
    }

    #[test]
    fn a_duration_has_the_unit_that_suits_it() {
        let shown = [0.25e-3, 1e-3, 0.25, 1.0, 2.5].map(duration);
        assert_eq!(shown, ["250.000 µs", "1.000 ms", "250.000 ms", "1.000 s", "2.500 s"]);
    }
}
