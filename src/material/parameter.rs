//! What the parameters of a law must be.

use std::fmt;

use crate::number::Number;

/// A parameter that makes no law.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterError {
    /// Which one, such as `arms[2].relaxation_time`.
    pub parameter: String,
    /// What is wrong with it.
    pub fault: ParameterFault,
}

/// What can be wrong with a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterFault {
    /// Infinite or not a number.
    NotFinite(f64),
    /// Zero or below, where that means nothing.
    NotPositive(f64),
    /// Below zero.
    Negative(f64),
    /// Infinite or zero once it is a number of the type that the law is written over.
    OutOfRange(f64),
    /// A list without entries.
    Empty,
}

impl fmt::Display for ParameterError {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let name = &self.parameter;
        match self.fault {
            ParameterFault::NotFinite(x) => write!(to, "`{name}` must be finite, not {x}"),
            ParameterFault::NotPositive(x) => write!(to, "`{name}` must be positive, not {x}"),
            ParameterFault::Negative(x) => write!(to, "`{name}` must not be negative, but is {x}"),
            ParameterFault::OutOfRange(x) => {
                write!(to, "`{name}` = {x} is beyond the range of the number type of the run")
            }
            ParameterFault::Empty => write!(to, "`{name}` must have at least one entry"),
        }
    }
}

impl std::error::Error for ParameterError {}

pub(super) fn finite<S: Number>(parameter: &str, value: f64) -> Result<S, ParameterError> {
    let number = S::from_f64(value);
    let fault = if !value.is_finite() {
        ParameterFault::NotFinite(value)
    } else if !number.is_finite() || (number == S::zero() && value != 0.0) {
        ParameterFault::OutOfRange(value)
    } else {
        return Ok(number);
    };
    Err(ParameterError { parameter: parameter.into(), fault })
}

pub(super) fn positive<S: Number>(parameter: &str, value: f64) -> Result<S, ParameterError> {
    let number = finite(parameter, value)?;
    if value > 0.0 {
        return Ok(number);
    }
    Err(ParameterError { parameter: parameter.into(), fault: ParameterFault::NotPositive(value) })
}

pub(super) fn not_negative<S: Number>(parameter: &str, value: f64) -> Result<S, ParameterError> {
    let number = finite(parameter, value)?;
    if value >= 0.0 {
        return Ok(number);
    }
    Err(ParameterError { parameter: parameter.into(), fault: ParameterFault::Negative(value) })
}

pub(super) fn not_empty<T>(parameter: &str, list: &[T]) -> Result<(), ParameterError> {
    if list.is_empty() {
        return Err(ParameterError { parameter: parameter.into(), fault: ParameterFault::Empty });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_fault_is_found_and_said() {
        let infinite = f64::NEG_INFINITY;
        for (found, fault, text) in [
            (finite::<f64>("b", infinite), ParameterFault::NotFinite(infinite), "finite, not -inf"),
            (positive("b", 0.0), ParameterFault::NotPositive(0.0), "`b` must be positive, not 0"),
            (not_negative("b", -0.3), ParameterFault::Negative(-0.3), "not be negative, but is -0"),
        ] {
            let error = found.unwrap_err();
            assert_eq!(error.fault, fault);
            assert!(error.to_string().contains(text), "{error}");
        }
        assert!(positive::<f64>("b", f64::NAN).unwrap_err().to_string().contains("not NaN"));
        assert_eq!(not_negative::<f64>("b", 0.0), Ok(0.0));
        let empty = not_empty::<f64>("arms", &[]).unwrap_err();
        assert_eq!(empty.to_string(), "`arms` must have at least one entry");
    }

    #[test]
    fn doubles_that_single_precision_cannot_hold_are_refused() {
        // The greatest single is 3.4e38, the least 1.4e-45.
        for value in [3.7e38, 6.1e-46] {
            let error = positive::<f32>("modulus", value).unwrap_err();
            assert_eq!(error.fault, ParameterFault::OutOfRange(value));
            assert!(error.to_string().contains("range"), "{error}");
            assert_eq!(positive::<f64>("modulus", value), Ok(value));
        }
    }
}
