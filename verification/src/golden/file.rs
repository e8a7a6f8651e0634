//! A file of vectors: its envelope, what a vector may be marked with, and its text.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::FORMAT;
use super::equations::EquationVector;
use super::runs::RunVector;
use super::steps::StepVector;

/// A file of vectors, `crossfibre-vectors/1`.
///
/// Numbers are the shortest decimals that read back to the same bits, and are to be compared by
/// bits. Units are SI; symbols are those of `crossfibre-trace/1`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum VectorFile {
    /// One evaluation of one equation each.
    Equations(Envelope<EquationVector>),
    /// One time step each.
    Steps(Envelope<StepVector>),
    /// One shipped scene each.
    Runs(Envelope<RunVector>),
}

/// What surrounds the vectors.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Envelope<V> {
    /// `crossfibre-vectors/1`.
    pub format: String,
    /// Where the vectors come from.
    pub provenance: Provenance,
    /// The vectors; each has an id of its own.
    pub vectors: Vec<V>,
}

/// Where the vectors of a file come from. Each vector names its edition and scene itself.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Version of crossfibre that wrote the file.
    pub crossfibre: String,
    /// Why it was last written.
    pub reason: String,
}

impl Provenance {
    /// Of this version, for this reason.
    pub fn now(reason: &str) -> Self {
        Self { crossfibre: env!("CARGO_PKG_VERSION").into(), reason: reason.into() }
    }
}

/// What a vector is marked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// The page as printed: corrections `"none"`.
    Printed,
    /// Corrections `"all"`.
    Corrected,
    /// Engineering strain in place of (4).
    Engineering,
    /// Numbers that are nothing special: neither round nor commensurate, from a fixed generator.
    Awkward,
    /// Zeros, right angles, folded elements, underflow, overflow: where a rewrite that is right for
    /// ordinary numbers may go wrong. A number that is not finite is meant.
    SpecialValue,
}

/// The vectors of a file.
#[derive(Debug)]
pub enum Vectors {
    /// Of `equations.json`.
    Equations(Vec<EquationVector>),
    /// Of `steps.json`.
    Steps(Vec<StepVector>),
    /// Of `runs.json`.
    Runs(Vec<RunVector>),
}

impl Vectors {
    /// The text of the file: a vector a line, so that a change shows as the vectors that changed.
    pub fn text(&self, provenance: &Provenance) -> String {
        let (kind, lines) = match self {
            Self::Equations(vectors) => ("equations", lines(vectors)),
            Self::Steps(vectors) => ("steps", lines(vectors)),
            Self::Runs(vectors) => ("runs", lines(vectors)),
        };
        format!(
            "{{\n\"format\": {},\n\"kind\": {},\n\"provenance\": {},\n\"vectors\": [\n{}\n]\n}}\n",
            json(&FORMAT),
            json(&kind),
            json(provenance),
            lines.join(",\n")
        )
    }
}

fn lines<V: Serialize>(vectors: &[V]) -> Vec<String> {
    vectors.iter().map(json).collect()
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("every map of a vector has text for its keys")
}

impl VectorFile {
    /// The provenance and the vectors.
    pub fn into_parts(self) -> (Provenance, Vectors) {
        match self {
            Self::Equations(e) => (e.provenance, Vectors::Equations(e.vectors)),
            Self::Steps(e) => (e.provenance, Vectors::Steps(e.vectors)),
            Self::Runs(e) => (e.provenance, Vectors::Runs(e.vectors)),
        }
    }
}
