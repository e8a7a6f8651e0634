//! Reports: pure functions of a [`crate::record::Record`].

pub mod junit;
pub mod markdown;
