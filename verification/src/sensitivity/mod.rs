//! Which check finds which fault: the kill matrix.
//!
//! A fault of [`crate::planted`] is put in, the checks are run, and those that notice are written
//! down. A check that notices no fault at all checks nothing, and a fault that no check notices could
//! be in the code now.

pub mod judge;
pub mod matrix;
pub mod measure;
pub mod one;
pub mod page;
pub mod stored;
