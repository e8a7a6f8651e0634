//! Golden vectors: what every equation, step, run and trace gave when it was last found right, as
//! numbers that read back to the same bits. Format `crossfibre-vectors/1`.
//!
//! | file | a vector |
//! |---|---|
//! | `equations.json` | named inputs of one equation in one edition, and its output |
//! | `steps.json` | a state, and the state one step later |
//! | `runs.json` | a shipped scene: how it ends, some of its numbers, a digest of all of them |
//! | `trace.jsonl` | every evaluation of a short run, byte for byte as `crossfibre trace` writes it |
//!
//! Only `crossfibre vectors --bless` writes them ([`bless`]). Vectors show that something changed,
//! never that it was right: that is for the checks, and `bless` refuses while one of them is red.

pub mod bless;
pub mod compare;
mod draw;
pub mod effect;
pub mod equations;
pub mod file;
pub mod runs;
pub mod steps;
mod trace;
pub mod value;

use compare::{Difference, differences};
use file::{Provenance, Vectors};

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-vectors/1";

/// The files, in the order in which they are compared: the first difference is the nearest to its
/// cause.
pub const FILES: [&str; 4] = ["equations.json", "steps.json", "runs.json", TRACE];

/// The file that is a trace.
const TRACE: &str = "trace.jsonl";

/// The contents of a file; none where it is not there.
pub type Text = Option<String>;

/// The stored files that this program was built with.
pub fn embedded() -> [Text; 4] {
    [
        include_str!("../../../golden/equations.json"),
        include_str!("../../../golden/steps.json"),
        include_str!("../../../golden/runs.json"),
        include_str!("../../../golden/trace.jsonl"),
    ]
    .map(|text| Some(text.to_owned()))
}

/// What this program computes, in place of what is stored.
pub struct Recomputed {
    /// Equations, steps and runs.
    pub vectors: [Vectors; 3],
    /// The trace.
    pub trace: String,
}

impl Recomputed {
    /// Computes everything.
    pub fn now() -> Self {
        Self {
            vectors: [
                Vectors::Equations(equations::vectors()),
                Vectors::Steps(steps::vectors()),
                Vectors::Runs(runs::vectors()),
            ],
            trace: trace::text(),
        }
    }

    /// The files of [`FILES`], with this provenance.
    pub fn texts(&self, provenance: &Provenance) -> [String; 4] {
        let [equations, steps, runs] = &self.vectors;
        [
            equations.text(provenance),
            steps.text(provenance),
            runs.text(provenance),
            self.trace.clone(),
        ]
    }
}

/// Where the files that this program was built with differ from what it computes.
pub fn compare_embedded() -> Vec<Difference> {
    differences(&embedded(), &Recomputed::now())
}
