//! Errors against element-steps, a picture for each problem.

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::Record;
use super::errors::{Abscissa, Errors};
use crate::plot::rows;

/// The variants that are drawn. Those at α = 0.95 and in 106 bits have the errors of α = 1 to the eye.
pub const VARIANTS: [&str; 12] = [
    "engineering, α = 1",
    "engineering, α = 0.5",
    "engineering, α = 0.5, viscous",
    "engineering, α = 0.95, viscous",
    "engineering, α = 1, printed",
    "engineering, α = 1, no inertia",
    "eqn (4), α = 1",
    "eqn (4), α = 0.5",
    "eqn (4), α = 0.5, viscous",
    "eqn (4), α = 1, printed",
    "eqn (4), α = 1, no flags",
    "eqn (4), α = 1, f32",
];

/// The quantities that matter for a problem.
pub fn quantities(problem: Problem) -> &'static [Quantity] {
    use Quantity::*;
    match problem {
        Problem::Single => &[Plateau, StrainL1, StrainL2, Kink, Arrival, Energy],
        Problem::Crossed => &[StrainL1, Reflection, Transmission, Diversion, Kink, Energy],
        Problem::Unequal => &[StrainL1, SecondaryL1, Plateau, Kink, Arrival, Energy],
        Problem::Rod => &[StrainL1, StrainL2, Arrival, Energy],
    }
}

/// The picture's file.
pub fn file(problem: Problem) -> &'static str {
    match problem {
        Problem::Single => "work-single.svg",
        Problem::Crossed => "work-crossed.svg",
        Problem::Unequal => "work-unequal.svg",
        Problem::Rod => "work-rod.svg",
    }
}

/// The picture of a problem.
pub fn picture(record: &Record, problem: Problem) -> String {
    let abscissa = Abscissa::ElementSteps;
    let quantities = quantities(problem);
    let columns = if quantities.len() > 4 { 3 } else { 2 };
    let width = 1290.0 / columns as f64;
    let errors = Errors { record, problem, abscissa, variants: &VARIANTS, width };
    let panels: Vec<_> = quantities.iter().map(|&quantity| errors.panel(quantity)).collect();
    rows(&panels, columns)
}
