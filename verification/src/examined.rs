//! What takes hours, or tools that not everyone has, and is therefore examined apart from a verification: the
//! scripts that do it store what came of it, with date and commit, and a report says it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Written by `.ci/mutants`, `.ci/coverage` and `.ci/fuzz`.
const STORED: [&str; 5] = [
    include_str!("../../docs/mutants.json"),
    include_str!("../../docs/mutants-command.json"),
    include_str!("../../docs/mutants-candidates.json"),
    include_str!("../../docs/coverage.json"),
    include_str!("../../docs/fuzz.json"),
];

/// What was examined, and what came of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Examination {
    /// What was examined.
    pub what: String,
    /// What did it.
    pub tool: String,
    /// The day it ended: year, month, day.
    pub date: String,
    /// The commits that were examined.
    pub commits: Vec<String>,
    /// What came of it: numbers, and what they are numbers of.
    pub counts: Vec<(u64, String)>,
    /// The page that says more, in `docs`.
    pub page: String,
}

impl Examination {
    /// What came of it, in a line.
    pub fn outcome(&self) -> String {
        let counts: Vec<_> =
            self.counts.iter().map(|(number, what)| format!("{number} {what}")).collect();
        counts.join(", ")
    }
}

/// The examinations in the repository.
///
/// # Panics
/// If one cannot be read: a fault of this program.
pub fn stored() -> Vec<Examination> {
    let read = |text| serde_json::from_str(text).expect("a stored examination can be read");
    STORED.map(read).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number_of(examination: &Examination, what: &str) -> u64 {
        let counts = &examination.counts;
        counts.iter().find(|(_, name)| name == what).unwrap_or_else(|| panic!("{counts:?}")).0
    }

    #[test]
    fn what_goes_unnoticed_or_is_not_reached_has_a_reason_and_no_input_shows_a_fault() {
        let stored = stored();
        let [library, command, candidates, coverage, fuzz] = stored.as_slice() else {
            panic!("{stored:?}")
        };
        for mutants in [library, command, candidates] {
            assert_eq!(number_of(mutants, "unnoticed without a reason"), 0);
            // Each has come to one end.
            let ends =
                ["caught", "out of time", "not compiled", "survived", "not reached", "not tried"];
            let sum: u64 = ends.map(|end| number_of(mutants, end)).iter().sum();
            assert_eq!(sum, number_of(mutants, "mutants"));
        }
        assert_eq!(number_of(coverage, "lines not reached without a reason"), 0);
        assert_eq!(number_of(fuzz, "faults"), 0);
        assert!(number_of(fuzz, "inputs") >= 10_000_000);
    }
}
