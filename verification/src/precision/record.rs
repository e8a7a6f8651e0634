//! The record of the study, format `crossfibre-work-precision/1`: everything that is drawn from it,
//! and deterministic. Measured times are a record of their own.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::problems::Problem;
use super::reading::{Quantity, Reading};
use super::run::Found;
use super::{Task, found, run_of, tasks};
use crate::tables::{Table, cell};

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-work-precision/1";

/// Every run of the study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// `crossfibre-work-precision/1`.
    pub format: String,
    /// Version of crossfibre.
    pub version: String,
    /// The runs: problem by problem, variant by variant, the coarsest mesh first.
    pub entries: Vec<Entry>,
}

/// A run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// The problem.
    pub problem: Problem,
    /// The variant's name.
    pub variant: String,
    /// How often the paper's mesh is refined.
    pub refinement: f64,
    /// Elements of the primary.
    pub elements: usize,
    /// Their length, m.
    pub spacing: f64,
    /// What was found.
    pub found: Found,
}

impl Record {
    /// The record of all runs up to a refinement.
    pub fn of(finest: f64, found: Vec<Found>) -> Self {
        Self::around(tasks(finest).into_iter().zip(found).map(Entry::of).collect())
    }

    /// The record of some runs, made now.
    pub fn computed(tasks: &[Task]) -> Self {
        let entry = |&task: &Task| {
            let Task { problem, variant, refinement } = task;
            Entry::of((task, found(&run_of(problem, &variant, refinement))))
        };
        // The finest first, so that no core waits for it in the end.
        let mut entries: Vec<_> = tasks.par_iter().rev().with_max_len(1).map(entry).collect();
        entries.reverse();
        Self::around(entries)
    }

    fn around(entries: Vec<Entry>) -> Self {
        Self { format: FORMAT.into(), version: env!("CARGO_PKG_VERSION").into(), entries }
    }

    /// The runs of a problem in a variant, the coarsest mesh first.
    pub fn series(&self, problem: Problem, variant: &str) -> Vec<&Entry> {
        let belongs = |entry: &&Entry| entry.problem == problem && entry.variant == variant;
        self.entries.iter().filter(belongs).collect()
    }

    /// The record as JSON, a run a line.
    pub fn json(&self) -> String {
        fn json(of: &impl Serialize) -> String {
            serde_json::to_string(of).expect("its numbers are finite")
        }
        let Self { format, version, entries } = self;
        let lines: Vec<_> = entries.iter().map(json).collect();
        let [format, version] = [format, version].map(json);
        let head = format!("{{\"format\":{format},\"version\":{version},\"entries\":[\n");
        head + &lines.join(",\n") + "\n]}\n"
    }

    /// A row for each reading of each run; one without a reading for a run that did not complete.
    pub fn table(&self) -> String {
        let mut table = Table::new(&[
            "problem",
            "variant",
            "elements [1]",
            "element [mm]",
            "steps [1]",
            "element-steps [1]",
            "evaluations [1]",
            "outcome",
            "quantity",
            "value [SI]",
            "exact [SI]",
            "error [1]",
        ]);
        for entry in &self.entries {
            let Entry { problem, variant, elements, spacing, found, .. } = entry;
            // Words of an outcome may hold a comma; its first does not.
            let outcome = found.outcome.to_string();
            let outcome = outcome.split([':', ',']).next().unwrap_or_default();
            let mut row = |quantity: &str, numbers: [Option<f64>; 3]| {
                let run = [
                    problem.id().to_owned(),
                    variant.replace(',', ""),
                    elements.to_string(),
                    cell(Some(1e3 * spacing)),
                    found.steps.to_string(),
                    found.element_steps.to_string(),
                    found.evaluations.to_string(),
                    outcome.to_owned(),
                    quantity.replace(',', ""),
                ];
                table.row(&[&run[..], &numbers.map(cell)].concat());
            };
            if found.readings.is_empty() {
                row("", [None; 3]);
            }
            for reading in &found.readings {
                let Reading { quantity, value, exact } = *reading;
                row(quantity.label(), [Some(value), exact, reading.error()]);
            }
        }
        table.text()
    }
}

impl Entry {
    fn of((task, found): (Task, Found)) -> Self {
        let fibre = task.problem.scene(task.refinement).primary;
        Self {
            problem: task.problem,
            variant: task.variant.name.into(),
            refinement: task.refinement,
            elements: fibre.elements,
            spacing: fibre.length / fibre.elements as f64,
            found,
        }
    }

    /// A reading of the run, if it has one.
    pub fn reading(&self, quantity: Quantity) -> Option<&Reading> {
        self.found.readings.iter().find(|reading| reading.quantity == quantity)
    }

    /// Its error: relative where the exact number is not zero; with its sign.
    pub fn error(&self, quantity: Quantity) -> Option<f64> {
        self.reading(quantity)?.error()
    }
}
