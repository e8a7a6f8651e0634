//! The record of a comparison of two traces, format `crossfibre-diff/1`.

use std::fmt::{self, Display, Formatter};

use crossfibre::place::Fibre;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::header::HeaderDifference;
use super::rank::At;
use crate::trace_line::{Event, Number, Value};

/// The format that this version writes.
pub const FORMAT: &str = "crossfibre-diff/1";

/// What came of a comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// `crossfibre-diff/1`.
    pub format: String,
    /// The first trace, as it was named.
    pub a: String,
    /// The second trace.
    pub b: String,
    /// How far numbers may be apart and still agree, relative to the larger one, of a vector to its
    /// largest component; null for not at all.
    pub tolerance: Option<f64>,
    /// The same in steps from double to double. Either suffices.
    pub ulp: Option<u64>,
    /// Whether all events agree.
    pub agree: bool,
    /// What came of it, in a sentence.
    pub verdict: String,
    /// Where the inputs that differ in the first difference come from.
    pub notes: Vec<String>,
    /// In what the headers differ.
    pub header: HeaderDifference,
    /// The events that agree before the first difference.
    pub agree_before: u64,
    /// The last of them.
    pub last_agreeing: Option<Agreeing>,
    /// The first difference.
    pub first_difference: Option<FirstDifference>,
    /// Whether the traces were read to their ends, and the equations are counted to there.
    pub to_the_end: bool,
    /// The equations that have events.
    pub equations: Vec<EquationTally>,
}

/// An evaluation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Evaluation {
    /// The time step.
    pub step: u64,
    /// The fibre.
    pub fibre: Fibre,
    /// Node or element.
    pub index: usize,
    /// The number of the equation on the page, as a name.
    pub eq: String,
}

/// An event that agrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Agreeing {
    /// Which it is.
    pub evaluation: Evaluation,
    /// Its line in the first trace.
    pub line_a: u64,
    /// Its line in the second trace.
    pub line_b: u64,
}

/// The first difference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FirstDifference {
    /// Of what kind it is.
    pub kind: Kind,
    /// The evaluation that differs, or that one trace lacks.
    pub evaluation: Evaluation,
    /// The event of the first trace; if it lacks the evaluation the one that it has next, null at its
    /// end.
    pub a: Option<Located>,
    /// The event of the second trace, likewise.
    pub b: Option<Located>,
    /// What differs, within the tolerance or not; `out` is the output.
    pub quantities: Vec<QuantityDifference>,
}

/// Kinds of differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The inputs agree and the output does not.
    Output,
    /// Inputs differ.
    Inputs,
    /// The evaluations have other quantities, or vectors of other dimensions.
    Quantities,
    /// The second trace lacks the evaluation.
    OnlyInA,
    /// The first trace lacks the evaluation.
    OnlyInB,
    /// The first trace has ended.
    AEnds,
    /// The second trace has ended.
    BEnds,
}

/// An event and its line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Located {
    /// The line, from 1, the header.
    pub line: u64,
    /// The event.
    pub event: Event,
}

/// A quantity that differs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuantityDifference {
    /// Its symbol.
    pub name: String,
    /// In the first trace, null if it is not there.
    pub a: Option<Value>,
    /// In the second trace.
    pub b: Option<Value>,
    /// Steps from double to double; of a vector, of its worst component. Null if there is no such
    /// number.
    pub ulp: Option<u64>,
    /// The distance, relative as `tolerance` is.
    pub relative: Option<Number>,
    /// Whether it is within the tolerance.
    pub agrees: bool,
}

/// The events of an equation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EquationTally {
    /// The number of the equation on the page, as a name.
    pub eq: String,
    /// Events that both traces have.
    pub events: u64,
    /// Those that agree, though not to the last bit.
    pub within_tolerance: u64,
    /// Those that differ.
    pub differing: u64,
    /// Events that the second trace lacks.
    pub only_in_a: u64,
    /// Events that the first trace lacks.
    pub only_in_b: u64,
    /// What is farthest apart, relatively, of all inputs and outputs; null if nothing is.
    pub worst: Option<Worst>,
}

/// What is farthest apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Worst {
    /// The most steps from double to double of any quantity; null if there is only NaN.
    pub ulp: Option<u64>,
    /// The greatest relative distance.
    pub relative: Number,
    /// Where that is.
    pub evaluation: Evaluation,
    /// The quantity that it is of.
    pub name: String,
}

impl From<At> for Evaluation {
    fn from(at: At) -> Self {
        let At { place, equation } = at;
        Self { step: place.step, fibre: place.fibre, index: place.index, eq: equation.to_string() }
    }
}

impl From<&Event> for Evaluation {
    fn from(event: &Event) -> Self {
        let Event { step, fibre, index, ref eq, .. } = *event;
        Self { step, fibre, index, eq: eq.clone() }
    }
}

impl Evaluation {
    /// Step, fibre, node or element in words.
    pub fn place(&self) -> String {
        let Self { step, fibre, index, eq } = self;
        let of = if matches!(eq.as_str(), "4" | "5" | "6" | "7") { "element" } else { "node" };
        format!("step {step}, {} {of} {index}", fibre.name())
    }
}

impl Display for Evaluation {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        write!(to, "eqn ({}), {}", self.eq, self.place())
    }
}
