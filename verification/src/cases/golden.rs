//! The golden vectors: nothing has changed that nobody gave a reason for.

use super::support::check;
use super::{Bound, Case, Check};
use crate::golden::compare_embedded;

/// The cases of this file.
pub const CASES: &[Case] = &[Case {
    id: "golden.vectors",
    title: "Equations, steps, runs and a trace are those that were stored",
    equations: &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20],
    run: vectors,
}];

fn vectors() -> Vec<Check> {
    vec![check(
        "Every number of the golden vectors is what the code gives",
        "golden/, written by `crossfibre vectors --bless` only, with a reason",
        "numbers that differ in any bit",
        compare_embedded().len() as f64,
        Bound::Exactly(0.0),
        "`crossfibre vectors` names each difference",
    )]
}
