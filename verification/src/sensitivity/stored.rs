//! The matrix in the repository, measured with every check.

use std::sync::OnceLock;

use super::matrix::Matrix;

const TEXT: &str = include_str!("../../../docs/sensitivity/matrix.json");

/// The matrix in `docs/sensitivity`.
///
/// # Panics
/// If it cannot be read: a fault of this program.
pub fn stored() -> &'static Matrix {
    static MATRIX: OnceLock<Matrix> = OnceLock::new();
    MATRIX.get_or_init(|| serde_json::from_str(TEXT).expect("the stored matrix can be read"))
}
