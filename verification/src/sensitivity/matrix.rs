//! The matrix, format `crossfibre-sensitivity/1`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-sensitivity/1";

/// Faults by checks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Matrix {
    /// `crossfibre-sensitivity/1`.
    pub format: String,
    /// Version of crossfibre.
    pub version: String,
    /// The checks, in the order of the report.
    pub checks: Vec<Column>,
    /// The faults, in the order of their catalogue.
    pub faults: Vec<Row>,
    /// Editions equal in algebra, which no check may fail but those that compare bits.
    pub rewrites: Vec<Row>,
}

/// A check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Column {
    /// Its case.
    pub case: String,
    /// What it claims.
    pub claim: String,
    /// Whether `verify --quick` runs it.
    pub quick: bool,
}

/// A fault, and what notices it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// Its name, as `verify --plant` takes it.
    pub id: String,
    /// The part of the program that it is in: `equation 4`, `march`, `material`, `exact`, `record`.
    pub group: String,
    /// What is done instead.
    pub what: String,
    /// Indices of the checks that fail.
    pub caught_by: Vec<usize>,
    /// Cases that come to no end with it: they panic, or take too long. All their checks count as failed.
    pub stopped: Vec<String>,
}

impl Row {
    /// Whether this check of the matrix notices the fault.
    pub fn is_caught_by(&self, matrix: &Matrix, check: usize) -> bool {
        self.caught_by.contains(&check) || self.stopped.contains(&matrix.checks[check].case)
    }
}

impl Matrix {
    /// The faults that a check notices.
    pub fn caught_by(&self, check: usize) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(move |row| row.is_caught_by(self, check))
    }

    /// The faults that a case notices.
    pub fn caught_by_case<'a>(&'a self, case: &'a str) -> impl Iterator<Item = &'a Row> {
        let checks: Vec<_> =
            (0..self.checks.len()).filter(|&i| self.checks[i].case == case).collect();
        self.faults.iter().filter(move |row| checks.iter().any(|&i| row.is_caught_by(self, i)))
    }

    /// How many checks notice a fault.
    pub fn count(&self, row: &Row) -> usize {
        (0..self.checks.len()).filter(|&i| row.is_caught_by(self, i)).count()
    }

    /// Faults that no check of the quick set notices.
    pub fn missed_by_quick(&self) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(|row| {
            !(0..self.checks.len()).any(|i| self.checks[i].quick && row.is_caught_by(self, i))
        })
    }

    /// Checks that notice no fault.
    pub fn idle(&self) -> impl Iterator<Item = &Column> {
        (0..self.checks.len())
            .filter(|&i| self.caught_by(i).next().is_none())
            .map(|i| &self.checks[i])
    }
}
