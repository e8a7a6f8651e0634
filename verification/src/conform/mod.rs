//! Conformance: is another program right, and if not, where does it first go wrong?

pub mod by_name;
pub mod candidate;
pub mod compare;
pub mod draw;
#[cfg(test)]
mod example;
pub mod expected;
pub mod html;
pub mod interview;
pub mod judge;
pub mod junit;
pub mod protocol;
pub mod quantity;
pub mod questions;
pub mod real;
pub mod record;
pub mod session;
pub mod shrink;
pub mod state_record;
pub mod text;
