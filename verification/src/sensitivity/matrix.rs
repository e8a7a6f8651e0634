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
    /// Whether a case comes to no end with the fault.
    pub fn stops(&self, case: &str) -> bool {
        self.stopped.iter().any(|stopped| stopped == case)
    }
}

impl Matrix {
    fn notices(&self, check: usize, row: &Row) -> bool {
        row.caught_by.contains(&check) || row.stops(&self.checks[check].case)
    }

    /// The checks that notice a fault, by their indices: they fail, or their case comes to no end.
    pub fn noticing(&self, row: &Row) -> impl Iterator<Item = usize> {
        (0..self.checks.len()).filter(|&check| self.notices(check, row))
    }

    /// The cases that notice a fault, each once, in their order.
    pub fn cases_noticing(&self, row: &Row) -> Vec<&str> {
        each_once(self.noticing(row).map(|check| self.checks[check].case.as_str()))
    }

    /// All cases, each once, in their order.
    pub fn cases(&self) -> Vec<&str> {
        each_once(self.checks.iter().map(|check| check.case.as_str()))
    }

    /// The faults that some check notices.
    pub fn noticed(&self) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(|row| self.noticing(row).next().is_some())
    }

    /// Faults that no check notices.
    pub fn missed(&self) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(|row| self.noticing(row).next().is_none())
    }

    /// Faults that no check of the quick set notices.
    pub fn missed_by_quick(&self) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(|row| !self.noticing(row).any(|check| self.checks[check].quick))
    }

    /// The faults that a check notices.
    pub fn noticed_by(&self, check: usize) -> impl Iterator<Item = &Row> {
        self.faults.iter().filter(move |row| self.notices(check, row))
    }

    /// The faults that a case notices.
    pub fn noticed_by_case(&self, case: &str) -> impl Iterator<Item = &Row> {
        let of_case: Vec<_> =
            (0..self.checks.len()).filter(|&check| self.checks[check].case == case).collect();
        self.faults.iter().filter(move |row| of_case.iter().any(|&check| self.notices(check, row)))
    }

    /// Checks that notice no fault.
    pub fn idle(&self) -> impl Iterator<Item = &Column> {
        (0..self.checks.len())
            .filter(|&check| self.noticed_by(check).next().is_none())
            .map(|check| &self.checks[check])
    }
}

/// Names of which the same stand together, each once.
fn each_once<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut each: Vec<_> = names.collect();
    each.dedup();
    each
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A check notices by failing or by its case coming to no end, and a case by any of its checks.
    #[test]
    fn a_check_that_fails_and_one_that_was_stopped_both_notice() {
        let column = |case: &str| Column { case: case.into(), claim: String::new(), quick: false };
        let row = |caught_by: &[usize], stopped: &[&str]| Row {
            id: String::new(),
            group: String::new(),
            what: String::new(),
            caught_by: caught_by.to_vec(),
            stopped: stopped.iter().map(|&case| case.into()).collect(),
        };
        let matrix = Matrix {
            format: FORMAT.into(),
            version: String::new(),
            checks: ["a", "a", "b", "b", "c"].map(column).into(),
            faults: vec![row(&[1], &["b"]), row(&[], &[]), row(&[0], &[])],
            rewrites: vec![],
        };
        let [both, none, one] = &matrix.faults[..] else { unreachable!() };
        let noticing = |row| matrix.noticing(row).collect::<Vec<_>>();
        assert_eq!(
            (noticing(both), noticing(none), noticing(one)),
            (vec![1, 2, 3], vec![], vec![0])
        );
        assert_eq!(matrix.cases(), ["a", "b", "c"]);
        assert_eq!(matrix.cases_noticing(both), ["a", "b"]);
        assert_eq!(matrix.noticed().collect::<Vec<_>>(), [both, one]);
        assert_eq!(matrix.missed().collect::<Vec<_>>(), [none]);
        assert_eq!(matrix.noticed_by(3).collect::<Vec<_>>(), [both]);
        assert_eq!(matrix.noticed_by_case("a").collect::<Vec<_>>(), [both, one]);
        assert_eq!(matrix.missed_by_quick().count(), 3);
        assert_eq!(matrix.idle().map(|check| check.case.as_str()).collect::<Vec<_>>(), ["c"]);
    }
}
