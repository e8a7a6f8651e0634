//! A double in a message: a JSON number, or the name of what JSON has no number for.

use std::fmt::{self, Formatter};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A double; `"inf"`, `"-inf"` and `"NaN"` are the names of what is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Real(pub f64);

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        if self.0.is_finite() { to.serialize_f64(self.0) } else { to.collect_str(&self.0) }
    }
}

impl<'de> Deserialize<'de> for Real {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = Real;

            fn expecting(&self, to: &mut Formatter) -> fmt::Result {
                write!(to, "a number, \"inf\", \"-inf\" or \"NaN\"")
            }

            fn visit_f64<E: Error>(self, x: f64) -> Result<Real, E> {
                Ok(Real(x))
            }

            fn visit_u64<E: Error>(self, x: u64) -> Result<Real, E> {
                Ok(Real(x as f64))
            }

            fn visit_i64<E: Error>(self, x: i64) -> Result<Real, E> {
                Ok(Real(x as f64))
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Real, E> {
                match name {
                    "inf" => Ok(Real(f64::INFINITY)),
                    "-inf" => Ok(Real(f64::NEG_INFINITY)),
                    "NaN" => Ok(Real(f64::NAN)),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(name), &self)),
                }
            }
        }
        from.deserialize_any(Number)
    }
}

impl JsonSchema for Real {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Real".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A double, or the name of what JSON has no number for.",
            "anyOf": [{ "type": "number" }, { "enum": ["inf", "-inf", "NaN"] }],
        })
    }
}

/// A field that is a plain `f64` in the program, as `#[serde(with)]` takes it.
pub mod plain {
    use super::*;

    /// Writes it as a [`Real`].
    pub fn serialize<S: Serializer>(x: &f64, to: S) -> Result<S::Ok, S::Error> {
        Real(*x).serialize(to)
    }

    /// Reads it as a [`Real`].
    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        Real::deserialize(from).map(|Real(x)| x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_double_comes_back_and_other_names_do_not() {
        for x in [0.1 + 0.2, -0.0, 5e-324, f64::MAX, f64::INFINITY, f64::NEG_INFINITY] {
            let text = serde_json::to_string(&Real(x)).unwrap();
            let Real(back) = serde_json::from_str(&text).unwrap();
            assert_eq!(back.to_bits(), x.to_bits(), "{text}");
        }
        let Real(nan) = serde_json::from_str("\"NaN\"").unwrap();
        assert!(nan.is_nan());
        assert_eq!(serde_json::from_str::<Real>("17").unwrap(), Real(17.0));
        for bad in ["\"nan\"", "null", "[1]", "1e400", "true"] {
            assert!(serde_json::from_str::<Real>(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn what_is_expected_of_a_number_is_said_and_a_plain_one_is_read_like_it() {
        let error = serde_json::from_str::<Real>("null").unwrap_err().to_string();
        assert!(error.contains("expected a number, \"inf\", \"-inf\" or \"NaN\""), "{error}");
        for (text, x) in [("0.7", 0.7), ("\"-inf\"", f64::NEG_INFINITY)] {
            let from = &mut serde_json::Deserializer::from_str(text);
            assert_eq!(plain::deserialize(from).unwrap(), x);
        }
    }
}
