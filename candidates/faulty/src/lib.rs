//! A candidate that is wrong on demand.
//!
//! It is the reference with one equation transcribed wrongly, or with every equation in other words.
//! The conformance runner must catch the first and pass the second; `tests/` hold it to that.

pub mod answer;
pub mod scramble;
pub mod traced;
