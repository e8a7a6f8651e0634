//! The page of the study: what its pictures show, and every number in it from the record.

mod definitions;
mod shown;
pub mod times;

use super::times::Times;
use super::{Record, answer};

/// The page. Times are on a page of their own, since they are others every time they are taken.
pub fn page(record: &Record, times: Option<&Times>) -> String {
    let mut sections = vec![head(record), answer(record)];
    sections.extend(shown::work(record));
    sections.extend([shown::convergence(record), shown::floors(record)]);
    sections.extend(times.map(|_| shown::time()));
    sections.extend([
        shown::profiles(),
        shown::space_time(),
        definitions::quantities(),
        definitions::variants(record),
        definitions::failures(record),
        definitions::costs(record),
        definitions::files(times.is_some()),
    ]);
    sections.join("\n")
}

fn answer(record: &Record) -> String {
    format!(
        "\
## The answer

{}
More of it, what not to use and why, the observed orders and where errors come from:
[how accurate for how much work](../../VALIDATION.md#how-accurate-for-how-much-work). For a scene of your own:
`crossfibre plan SCENE --accuracy 1e-3`.
",
        answer::core(record)
    )
}

fn head(record: &Record) -> String {
    let all = record.entries.len();
    let spacings = || record.entries.iter().map(|entry| 1e3 * entry.spacing);
    let (finest, coarsest) =
        (spacings().fold(f64::INFINITY, f64::min), spacings().fold(0.0, f64::max));
    let completed = record.entries.iter().filter(|e| e.found.outcome.is_completed()).count();
    format!(
        "\
# Error against work

Written by

    crossfibre study work-precision --out docs/work-precision

and the same to the byte wherever that runs: every number is of the record, [record.json](record.json).
Four problems with exact solutions, each in many variants on meshes with elements from {coarsest:.1} mm down to
{finest:.3} mm: {all} runs, of which {completed} completed and the others are drawn as failed.

**Work** is counted in element-steps: elements visited, summed over the steps. Halving the elements, and
with them the steps, costs four times as many. An error of order p in the length of an element falls by the
power −p/2 of the element-steps, so that an order of 1 costs a hundred times the work for each decimal.
"
    )
}
