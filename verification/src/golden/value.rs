//! A number or a vector of an equation, as traces write it.

use crossfibre::trace;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

use crate::trace_line::{self, NotFinite, Number};

/// A number or the components of a vector. What JSON has no number for is a string, as in traces.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(from = "trace_line::Value")]
#[schemars(with = "trace_line::Value")]
pub enum Value {
    /// One number.
    Scalar(f64),
    /// Components in the order x, y, z.
    Vector(Vec<f64>),
}

impl Value {
    /// The components; of a number, itself.
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Scalar(x) => vec![*x],
            Self::Vector(v) => v.clone(),
        }
    }
}

impl From<&trace::Value<'_, f64>> for Value {
    fn from(value: &trace::Value<'_, f64>) -> Self {
        match *value {
            trace::Value::Scalar(x) => Self::Scalar(x),
            trace::Value::Vector(v) => Self::Vector(v.into()),
        }
    }
}

impl Serialize for Value {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        match self {
            Self::Scalar(x) => trace::Value::Scalar(*x).serialize(to),
            Self::Vector(v) => trace::Value::Vector(v).serialize(to),
        }
    }
}

impl From<trace_line::Value> for Value {
    fn from(value: trace_line::Value) -> Self {
        let number = |number| match number {
            Number::Finite(x) => x,
            Number::Sum(sum) => sum.hi + sum.lo,
            Number::Other(NotFinite::Infinity) => f64::INFINITY,
            Number::Other(NotFinite::NegativeInfinity) => f64::NEG_INFINITY,
            Number::Other(NotFinite::NotANumber) => f64::NAN,
        };
        match value {
            trace_line::Value::Scalar(x) => Self::Scalar(number(x)),
            trace_line::Value::Vector(v) => Self::Vector(v.into_iter().map(number).collect()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scalar_has_one_number_and_a_sum_of_two_doubles_is_their_sum() {
        let value = |text| serde_json::from_str::<Value>(text).unwrap();
        assert_eq!(value("0.3").numbers(), [0.3]);
        assert_eq!(value("[0.3,\"-inf\"]").numbers(), [0.3, f64::NEG_INFINITY]);
        // Short binary fractions add up exactly.
        assert_eq!(value("{\"hi\":1.5,\"lo\":0.25}").numbers(), [1.75]);
    }
}
