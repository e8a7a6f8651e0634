//! A line of a trace as a type: what a reader of `crossfibre-trace/1` may rely on, and the source of
//! its JSON Schema.
//!
//! The library writes these lines without this type; that the two agree is tested.

use std::collections::BTreeMap;

use crossfibre::place::Fibre;
use crossfibre::scene::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A line of a trace.
#[derive(Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum TraceLine {
    /// Any line but the first.
    Event(Event),
    /// The first line.
    Header(Box<Header>),
}

/// The first line: what the events are evaluations of.
#[derive(Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// `crossfibre-trace/1`.
    pub format: String,
    /// The scene that is traced.
    pub scene: Scene,
    /// The equations (1)–(20), in order.
    pub equations: Vec<Registered>,
    /// Every symbol that an event or a line of an equation uses.
    pub symbols: Vec<Symbol>,
}

/// An equation as the traced edition works it out.
#[derive(Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Registered {
    /// Its number on the page.
    pub number: u8,
    /// What it is.
    pub name: String,
    /// How it is printed.
    pub printed: String,
    /// How it is worked out; the last lines give the output.
    pub lines: Vec<Line>,
    /// The same for a fibre with another law than (7), where the scene has one.
    #[serde(default)]
    pub lines_by_law: Option<Vec<Line>>,
}

/// One line of an equation: `name = expression`.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// What the line gives.
    pub name: String,
    /// How, with symbols in braces. With vectors it holds for each component; `|{d}|` is the length
    /// of the vector `d`.
    pub expression: String,
}

/// A quantity that enters or leaves an equation.
#[derive(Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Symbol {
    /// Its name in events and lines.
    pub name: String,
    /// What it is.
    pub meaning: String,
    /// Its SI unit; `1` for a pure number.
    pub unit: String,
}

/// One evaluation of one equation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Event {
    /// The time step, from 1.
    pub step: u64,
    /// The fibre.
    pub fibre: Fibre,
    /// Node, or element for (4)–(7); from 0.
    pub index: usize,
    /// The number of the equation on the page, as a name.
    #[schemars(regex(pattern = r"^([1-9]|1\d|20)$"))]
    pub eq: String,
    /// What went in, by symbol.
    #[serde(rename = "in")]
    pub inputs: BTreeMap<String, Value>,
    /// What came out.
    pub out: Value,
}

/// A number, or the components of a vector in the order x, y, z.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// One number.
    Scalar(Number),
    /// A vector.
    Vector(Vec<Number>),
}

/// A number, or the name of what JSON has no number for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Number {
    /// The shortest decimal that reads back to the same bits.
    Finite(f64),
    /// A number of the library's double-double march.
    Sum(Sum),
    /// Not a finite number.
    Other(NotFinite),
}

/// A number of 32 digits: the sum of two doubles.
///
/// It is read from an object alone: a structure could be read from a vector of two numbers, too.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "BTreeMap<String, f64>")]
#[schemars(!try_from, deny_unknown_fields)]
pub struct Sum {
    /// The double nearest to the sum.
    pub hi: f64,
    /// What is left.
    pub lo: f64,
}

impl TryFrom<BTreeMap<String, f64>> for Sum {
    type Error = &'static str;

    fn try_from(parts: BTreeMap<String, f64>) -> Result<Self, Self::Error> {
        match (parts.get("hi"), parts.get("lo"), parts.len()) {
            (Some(&hi), Some(&lo), 2) => Ok(Self { hi, lo }),
            _ => Err("a sum of two doubles has `hi` and `lo`"),
        }
    }
}

/// What is not a finite number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub enum NotFinite {
    /// Infinity.
    #[serde(rename = "inf")]
    Infinity,
    /// Negative infinity.
    #[serde(rename = "-inf")]
    NegativeInfinity,
    /// Not a number.
    #[serde(rename = "NaN")]
    NotANumber,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_of_two_is_a_vector_and_a_sum_of_two_doubles_is_a_number() {
        let value = |text| serde_json::from_str::<Value>(text);
        let vector = [Number::Finite(0.3), Number::Finite(0.7)];
        assert_eq!(value("[0.3,0.7]").unwrap(), Value::Vector(vector.into()));
        let sum = Number::Sum(Sum { hi: 0.3, lo: 1.7e-18 });
        assert_eq!(value(r#"{"hi":0.3,"lo":1.7e-18}"#).unwrap(), Value::Scalar(sum));
        assert_eq!(serde_json::to_string(&sum).unwrap(), r#"{"hi":0.3,"lo":1.7e-18}"#);
        for bad in ["[[0.3,0.7]]", r#"{"hi":0.3}"#, r#"{"hi":0.3,"lo":0.1,"mid":0.2}"#] {
            assert!(value(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn an_event_with_something_more_or_something_less_is_none() {
        let good = r#"{"step":7,"fibre":"primary","index":3,"eq":"4","in":{"v":[0.3,"-inf"]},"out":"NaN"}"#;
        let event: Event = serde_json::from_str(good).unwrap();
        let v = [Number::Finite(0.3), Number::Other(NotFinite::NegativeInfinity)];
        assert_eq!(event.inputs["v"], Value::Vector(v.into()));
        assert_eq!(event.out, Value::Scalar(Number::Other(NotFinite::NotANumber)));
        for bad in [
            good.replace("\"step\":7,", ""),
            good.replace("\"step\"", "\"extra\":1,\"step\""),
            good.replace("NaN", "nan"),
            good.replace("primary", "third"),
        ] {
            assert!(serde_json::from_str::<TraceLine>(&bad).is_err(), "{bad}");
        }
    }
}
