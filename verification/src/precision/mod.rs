//! The study `work-precision`: error against work.
//!
//! Each [`Problem`] has an [exact](mod@exact) answer. It is run in every [`Variant`] on a ladder of meshes,
//! and of each [`Run`] is kept what [readings](reading) it gives, what they ought to be, and how much
//! work it was. All of that is deterministic; measured time is kept apart.

pub mod advice;
pub mod answer;
pub mod exact;
pub mod measure;
pub mod orders;
mod page;
mod pictures;
pub mod problems;
pub mod reading;
pub mod record;
pub mod run;
pub mod split;
pub mod stored;
pub mod times;
pub mod variants;

pub use problems::{Problem, REFINEMENTS};
pub use reading::{Quantity, Reading};
pub use record::{Entry, Record};
pub use run::{Found, Run, found};
pub use times::Times;
pub use variants::{VARIANTS, Variant};

use crate::sweep::Point;

/// The name of the study, and of the format of its values.
pub const STUDY: &str = "work-precision/1";

/// The greatest refinement: 0.03 mm.
pub const FINEST: f64 = 64.0;

/// The greatest refinement of a quick study: 0.25 mm.
pub const QUICK: f64 = 8.0;

/// The greatest refinement at which 106 bits are run: they cost some fifty times as much.
const FINEST_IN_106_BITS: f64 = 16.0;

/// The id of a run.
pub fn id(problem: Problem, variant: &Variant, refinement: f64) -> String {
    let elements = problem.scene(refinement).primary.elements;
    format!("{}-{}-{elements}", problem.id(), variant.slug())
}

/// A problem in a variant on a mesh.
pub fn run_of(problem: Problem, variant: &Variant, refinement: f64) -> Run {
    Run {
        scene: variant.of(problem.scene(refinement)),
        pulled_along: problem.is_pulled_along(),
        precision: variant.precision,
        flagged: variant.flagged,
    }
}

/// A problem to be run in a variant on a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// The problem.
    pub problem: Problem,
    /// The variant.
    pub variant: Variant,
    /// How often the paper's mesh is refined.
    pub refinement: f64,
}

/// All that is run up to a refinement: problem by problem, variant by variant, the coarsest mesh first.
pub fn tasks(finest: f64) -> Vec<Task> {
    let mut tasks = Vec::new();
    for problem in Problem::ALL {
        for variant in VARIANTS.into_iter().filter(|variant| variant.applies_to(problem)) {
            let is_long = variant.precision == variants::Precision::DoubleDouble;
            let finest = if is_long { finest.min(FINEST_IN_106_BITS) } else { finest };
            let meshes = REFINEMENTS.into_iter().filter(|&refinement| refinement <= finest);
            tasks.extend(meshes.map(|refinement| Task { problem, variant, refinement }));
        }
    }
    tasks
}

/// The tasks of a variant on some problems, between two refinements.
pub fn ladders(problems: &[Problem], variants: &[&str], (from, to): (f64, f64)) -> Vec<Task> {
    let chosen = |task: &Task| {
        problems.contains(&task.problem)
            && variants.contains(&task.variant.name)
            && task.refinement >= from
    };
    tasks(to).into_iter().filter(chosen).collect()
}

/// The points of the sweep, in the order of [`tasks`].
pub fn points(finest: f64) -> Vec<Point<Run>> {
    let point = |Task { problem, variant, refinement }| Point {
        id: id(problem, &variant, refinement),
        parameters: run_of(problem, &variant, refinement),
    };
    tasks(finest).into_iter().map(point).collect()
}

/// What the study says, as a section in Markdown: the answer, the orders, and where errors come from.
pub fn section(record: &Record) -> String {
    format!(
        "## How accurate for how much work\n\n\
         From [the stored record](docs/work-precision/record.json) of `crossfibre study work-precision`, of \
         which the case `precision.record` runs a part again, to the bit. Errors are relative to exact \
         solutions; an evaluation is one of a numbered equation.\n\n\
         {}\n\
         ### Observed orders\n\n\
         Of errors on meshes halved from 2 mm to 0.03 mm, as powers of the element's length, with intervals of \
         scatter; what they mean, and the rule of the verdicts: [Convergence](docs/convergence.md). Each \
         expectation has its reason below; where there is none there is no row. `precision.orders` holds them on \
         meshes that it runs itself.\n\n\
         {}\n\
         ### Where the errors come from\n\n\
         At 0.5 mm: the error is rounding (a run in 53 bits less one in 106) and discretisation (less the limit \
         of the asymptotic range) and model (the limit less what is exact), in per cent of the exact number. Where \
         the ladder has no limit that could be stated, discretisation and model stand together.\n\n\
         {}",
        answer::page(record),
        orders::table(record),
        split::table(record)
    )
}

/// What is drawn and written from the record, and from measured times if there are any: file names with
/// their contents.
pub fn files(record: &Record, times: Option<&Times>) -> Vec<(&'static str, String)> {
    let mut files = vec![
        ("README.md", page::page(record, times)),
        ("record.json", record.json()),
        ("runs.csv", record.table()),
    ];
    files.extend(pictures::files(record, times));
    if let Some(times) = times {
        files.push(("times.json", times.json()));
        files.push(("times.md", page::times::page(record, times)));
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::stored::stored;

    #[test]
    fn the_section_of_the_stored_record_is_that_of_the_committed_page() {
        let section = section(stored());
        assert!(section.starts_with("## How accurate for how much work\n"));
        assert!(include_str!("../../../VALIDATION.md").contains(&section));
    }

    #[test]
    fn ladders_are_those_of_the_problems_and_variants_between_two_refinements() {
        let (first, second) = (VARIANTS[0].name, VARIANTS[4].name);
        let chosen = ladders(&[Problem::Single, Problem::Unequal], &[first, second], (0.5, 2.0));
        let of: Vec<_> = chosen.iter().map(|t| (t.problem, t.variant.name, t.refinement)).collect();
        let rungs = |problem, name| [0.5, 1.0, 2.0].map(|refinement| (problem, name, refinement));
        let expected = [
            rungs(Problem::Single, first),
            rungs(Problem::Single, second),
            rungs(Problem::Unequal, first),
            rungs(Problem::Unequal, second),
        ];
        assert_eq!(of, expected.concat());
    }
}
