//! What not to use, each with its figure.

use super::{Aim, PAGE, aim, count, millimetres, percent};
use crate::precision::{Entry, Problem, Quantity, Record};

/// Rows of two cells: what, and why not.
pub fn rows(record: &Record) -> Vec<Vec<String>> {
    let rows = [
        ("the printed equations", printed(record)),
        ("single precision on fine meshes", single(record)),
        ("α = 0.5", half(record)),
        ("engineering strain at α = 1 without the crossover's inertia", no_inertia(record)),
        ("artificial viscosity at α = 0.95", viscous(record)),
        ("eqn (4) for a plateau strain to some parts in 100,000", path(record)),
        ("very coarse meshes", coarse(record)),
        ("a march without the paper's flags", no_flags(record)),
    ];
    let row = |(what, why): (&str, Option<String>)| Some(vec![what.to_owned(), why?]);
    rows.into_iter().filter_map(row).collect()
}

fn finest<'a>(record: &'a Record, problem: Problem, variant: &str) -> Option<&'a Entry> {
    record.series(problem, variant).last().copied()
}

fn printed(record: &Record) -> Option<String> {
    const VARIANT: &str = "eqn (4), α = 1, printed";
    let finest = finest(record, Problem::Crossed, VARIANT)?;
    let series = record.series(Problem::Crossed, VARIANT);
    let from = series.iter().find(|entry| entry.refinement == 1.0)?;
    let fine = series.iter().filter(|entry| entry.refinement >= 1.0);
    let least = fine
        .filter_map(|entry| Some(entry.error(Quantity::Reflection)?.abs()))
        .fold(f64::INFINITY, f64::min);
    Some(format!(
        "R is off by {} % at {} and by {} % or more on every mesh from {} on, D by {} %, the energy by {} %",
        percent(finest.error(Quantity::Reflection)?),
        millimetres(finest),
        percent(least),
        millimetres(from),
        percent(finest.error(Quantity::Diversion)?),
        percent(finest.error(Quantity::Energy)?),
    ))
}

/// The runs of a variant that did not complete, and all.
fn ended(record: &Record, problems: &[Problem], variant: &str) -> (usize, usize) {
    let runs = problems.iter().flat_map(|&problem| record.series(problem, variant));
    runs.fold((0, 0), |(ended, all), entry| {
        (ended + usize::from(!entry.found.outcome.is_completed()), all + 1)
    })
}

fn single(record: &Record) -> Option<String> {
    const VARIANT: &str = "eqn (4), α = 1, f32";
    let size = |entry: &Entry| Some(entry.error(Quantity::StrainL1)?.abs());
    let series = record.series(Problem::Single, VARIANT);
    let read: Vec<_> = series.iter().filter_map(|entry| Some((*entry, size(entry)?))).collect();
    let &(best, least) = read.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let &(last, greatest) = read.last()?;
    let (ended, all) = ended(record, &Problem::ALL, VARIANT);
    Some(format!(
        "the strain profile of one fibre is off by {} % at {}, and by more on finer meshes: {} % at {}; {ended} \
         of {all} runs end early",
        percent(least),
        millimetres(best),
        percent(greatest),
        millimetres(last)
    ))
}

fn half(record: &Record) -> Option<String> {
    let profile: Aim = aim(Problem::Single, Quantity::StrainL1, 1e-2);
    let one = profile.reached(record, "engineering, α = 1")?;
    let half = profile.reached(record, "engineering, α = 0.5")?;
    Some(format!(
        "a front is dispersed: a strain profile to {} % takes {} where α = 1 takes {}, {:.0} times the \
         evaluations",
        percent(profile.within),
        millimetres(half),
        millimetres(one),
        half.found.evaluations as f64 / one.found.evaluations as f64
    ))
}

fn no_inertia(record: &Record) -> Option<String> {
    let count = |variant| ended(record, &[Problem::Crossed], variant);
    let (without, all) = count("engineering, α = 1, no inertia");
    let (with, _) = count("engineering, α = 1");
    (all > 0).then(|| {
        format!(
            "the crossover's node is unstable: {without} of {all} runs of Fig. 3 end early, with it {with}"
        )
    })
}

fn viscous(record: &Record) -> Option<String> {
    let (ended, all) = ended(record, &Problem::ALL, "engineering, α = 0.95, viscous");
    let (below, runs) = ended_below(record);
    (all > 0).then(|| {
        format!(
            "it lowers the largest stable Courant number: {ended} of {all} runs end in an early step, at \
             α = 0.5 {below} of {runs}"
        )
    })
}

fn ended_below(record: &Record) -> (usize, usize) {
    ended(record, &Problem::ALL, "engineering, α = 0.5, viscous")
}

fn path(record: &Record) -> Option<String> {
    let series = record.series(Problem::Single, PAGE);
    let coarse = series.iter().find(|entry| entry.refinement == 8.0)?;
    let fine = series.last()?;
    let engineering = finest(record, Problem::Single, "engineering, α = 1")?;
    let plateau = |entry: &Entry| Some(percent(entry.error(Quantity::Plateau)?));
    Some(format!(
        "it depends on the path: from {} to {}, {:.0} times the evaluations, its error falls from {} % to {} %; \
         by engineering strain it is {:.0e} % there",
        millimetres(coarse),
        millimetres(fine),
        fine.found.evaluations as f64 / coarse.found.evaluations as f64,
        plateau(coarse)?,
        plateau(fine)?,
        100.0 * engineering.error(Quantity::Plateau)?.abs(),
    ))
}

fn coarse(record: &Record) -> Option<String> {
    let coarsest = *record.series(Problem::Crossed, PAGE).first()?;
    let error = |quantity| Some(percent(coarsest.error(quantity)?));
    Some(format!(
        "at {} ({} elements) R is off by {} %, D by {} %, the mean strain by {} %",
        millimetres(coarsest),
        coarsest.elements,
        error(Quantity::Reflection)?,
        error(Quantity::Diversion)?,
        error(Quantity::MeanStrain)?,
    ))
}

fn no_flags(record: &Record) -> Option<String> {
    let flagged = finest(record, Problem::Crossed, PAGE)?;
    let all = finest(record, Problem::Crossed, "eqn (4), α = 1, no flags")?;
    let is_same = flagged.found.readings == all.found.readings;
    Some(format!(
        "Fig. 3 takes {:.1} times the evaluations ({} for {} at {}), and {}",
        all.found.evaluations as f64 / flagged.found.evaluations as f64,
        count(all.found.evaluations),
        count(flagged.found.evaluations),
        millimetres(flagged),
        if is_same { "gives the same bits" } else { "gives other bits" },
    ))
}
