//! The answer in numbers: what is wanted, which run gives it, and what that took.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{AIMS, PAGE};
use crate::precision::record::{Entry, Record};
use crate::precision::times::Times;

/// The times in `docs/work-precision`.
const TIMES: &str = include_str!("../../../../docs/work-precision/times.json");

/// How accurate for how much work and time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cost {
    /// The machine on which times were measured, in words.
    pub machine: String,
    /// What is wanted, and what gives it.
    pub wanted: Vec<Wanted>,
}

/// An accuracy, and what it takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wanted {
    /// What is wanted, in words.
    pub what: String,
    /// The coarsest mesh of the page's own variant that gives it, together with all finer ones.
    pub page: Option<Work>,
    /// The run with the fewest evaluations that gives it.
    pub cheapest: Option<Work>,
}

/// What a run takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Work {
    /// How it is run: strain, Courant number, viscosity.
    pub variant: String,
    /// Elements of the primary.
    pub elements: usize,
    /// Length of an element, m.
    pub spacing: f64,
    /// Evaluations of numbered equations.
    pub evaluations: u64,
    /// The least time that was measured, s; none if it was not.
    pub seconds: Option<f64>,
}

impl Work {
    fn of(entry: &Entry, times: &Times) -> Self {
        let timed = times.runs.iter().find(|run| {
            run.problem == entry.problem
                && run.contestant == entry.variant
                && run.elements == entry.elements
        });
        Self {
            variant: entry.variant.clone(),
            elements: entry.elements,
            spacing: entry.spacing,
            evaluations: entry.found.evaluations,
            seconds: timed.map(|run| run.seconds.least),
        }
    }
}

fn cost(record: &Record, times: &Times) -> Cost {
    let wanted = AIMS.iter().map(|aim| Wanted {
        what: aim.text(),
        page: aim.reached(record, PAGE).map(|entry| Work::of(entry, times)),
        cheapest: aim.cheapest(record).map(|entry| Work::of(entry, times)),
    });
    Cost { machine: times.machine.clone(), wanted: wanted.collect() }
}

/// That of the record and the times in `docs/work-precision`.
///
/// # Panics
/// If they cannot be read: a fault of this program.
pub fn stored() -> Cost {
    let times: Times = serde_json::from_str(TIMES).expect("the stored times can be read");
    cost(crate::precision::stored::stored(), &times)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_recommended_has_been_timed_and_more_work_takes_longer() {
        let works: Vec<Work> = stored()
            .wanted
            .into_iter()
            .flat_map(|row| [row.page, row.cheapest])
            .flatten()
            .collect();
        assert!(works.len() > 20);
        let mut of_page: Vec<_> = works
            .iter()
            .filter(|work| work.variant == PAGE)
            .map(|work| (work.evaluations, work.seconds.expect("timed")))
            .collect();
        of_page.sort_by_key(|(evaluations, _)| *evaluations);
        assert!(of_page.is_sorted_by_key(|(_, seconds)| *seconds), "{of_page:?}");
    }
}
