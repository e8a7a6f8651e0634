//! Errors against the length of an element, and the orders with which they fall.

use super::super::problems::Problem;
use super::super::reading::Quantity;
use super::super::record::Record;
use super::errors::{Abscissa, Errors};
use crate::convergence::{PowerLaw, Reason, Rule, Verdict, of_errors, power_law};
use crate::plot::rows;

/// The problem that is drawn.
pub const PROBLEM: Problem = Problem::Crossed;

/// The variants that are drawn.
pub const VARIANTS: [&str; 4] =
    ["engineering, α = 1", "engineering, α = 0.95", "engineering, α = 0.5", "eqn (4), α = 1"];

/// The quantities that are drawn.
pub const QUANTITIES: [Quantity; 6] = [
    Quantity::StrainL1,
    Quantity::StrainL2,
    Quantity::MeanStrain,
    Quantity::Kink,
    Quantity::Arrival,
    Quantity::SecondaryL1,
];

/// Level of the interval of an order.
pub const LEVEL: f64 = 0.95;

/// How near the order between two meshes is to that of all in the asymptotic range.
pub const BAND: f64 = 0.1;

/// The picture.
pub fn picture(record: &Record) -> String {
    let abscissa = Abscissa::ElementLength;
    let errors = Errors { record, problem: PROBLEM, abscissa, variants: &VARIANTS, width: 430.0 };
    rows(&QUANTITIES.map(|quantity| errors.panel(quantity)), 3)
}

/// The order of a quantity in a variant, in words: fitted in the asymptotic range, or why there is none.
pub fn order(record: &Record, variant: &str, quantity: Quantity) -> String {
    let entries = record.series(PROBLEM, variant);
    let errors: Vec<_> =
        entries.iter().filter_map(|e| Some((e.spacing, e.error(quantity)?))).collect();
    // The bound is one of the mean strain, and of L1.
    let is_bounded = matches!(quantity, Quantity::StrainL1 | Quantity::MeanStrain);
    let floors = entries.iter().filter(|_| is_bounded).filter_map(|entry| entry.found.floor);
    let rule = Rule { band: BAND, floor: floors.fold(0.0, f64::max) };
    let law = |from: usize, meshes: usize| {
        let sizes: Vec<_> = errors[from..from + meshes].iter().map(|p| (p.0, p.1.abs())).collect();
        power_law(&sizes, LEVEL).map_or_else(|fault| fault.to_string(), |law| words(&law))
    };
    match of_errors(&errors, rule) {
        Err(fault) => fault.to_string(),
        Ok(Verdict::Asymptotic(run)) => law(run.from, run.meshes),
        Ok(Verdict::Floor { before: Some(run), .. }) => {
            format!("{}, then the bound", law(run.from, run.meshes))
        }
        Ok(Verdict::Floor { before: None, .. }) => "within the bound".into(),
        Ok(Verdict::Oscillating { .. }) => "swings".into(),
        Ok(Verdict::NotYet(reason)) => match reason {
            Reason::TooFew => "too few meshes",
            Reason::Crossing => "passes through zero",
            Reason::Dip { .. } => "dips",
            Reason::NotFalling => "does not fall",
            Reason::Scattered => "orders do not agree",
        }
        .into(),
    }
}

fn words(law: &PowerLaw) -> String {
    let PowerLaw { order, half_width, coarsest, .. } = law;
    format!("{order:.2} ± {half_width:.2} from {} mm", (1e6 * coarsest).round() / 1e3)
}

#[cfg(test)]
mod tests {
    use super::super::made_up::{entry, record};
    use super::*;

    #[test]
    fn the_order_that_errors_were_made_of_is_found() {
        let variant = VARIANTS[1];
        let ladder = |error: fn(f64) -> f64| {
            let spacings = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4];
            record(spacings.map(|h| entry(variant, h, Some(error(h)))).into())
        };
        let said = |error| order(&ladder(error), variant, Quantity::StrainL1);
        assert_eq!(said(|h| 71.0 * pxfm::f_pow(h, 0.83)), "0.83 ± 0.00 from 4 mm");
        // Below the bound, 2.3e-5, from 0.5 mm on.
        assert_eq!(said(|h| 11.0 * h * h), "within the bound");
        assert_eq!(said(|h| h * (3e3 * h - 1.3) * (3e3 * h - 5.0)), "swings");
    }
}
