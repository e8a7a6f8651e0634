//! The page. Its numbers are measured here, not typed.

use super::Results;

/// The page.
pub fn page(_results: &Results) -> String {
    String::new()
}
