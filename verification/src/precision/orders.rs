//! Which orders are expected, and why, and those that a record shows.
//!
//! The derivations are in `docs/convergence.md`. Everything follows from how wide a front is: some
//! elements, or a power of the element's length times one of the way that it has gone.

mod expected;

use crate::convergence::range::LEAST;
use crate::convergence::{Fault, PowerLaw, Reason, Rule, Verdict, of_errors, power_law};

use super::problems::Problem;
use super::reading::Quantity;
use super::record::{Entry, Record};
use super::{VARIANTS, variants::Precision};
use crate::report::markdown::cell;
use crate::tables::markdown;

pub use expected::{Expected, expected};

/// Probability that the intervals are for.
pub const LEVEL: f64 = 0.95;

/// The greatest difference of the order between two meshes from that of all, in the asymptotic range.
pub const BAND: f64 = 0.1;

/// How far a fitted order may lie off the expected one. The nearest two that are expected anywhere, 1/4
/// and 1/3, are a twelfth apart.
pub const TOLERANCE: f64 = 1.0 / 12.0;

/// Rounding: more than the greatest relative difference of a run in 53 bits from one in 106 (case
/// `precision.split`). It is that of L/L₀ − 1 on a rod strained by 5e-4.
pub const ROUNDING: f64 = 4e-9;

/// An order to be fitted.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The problem.
    pub problem: Problem,
    /// The variant.
    pub variant: &'static str,
    /// The quantity.
    pub quantity: Quantity,
    /// What is expected of it.
    pub expected: Expected,
    /// The least refinement at which it is.
    pub from: f64,
    /// Why.
    pub why: &'static str,
}

/// What a ladder shows.
#[derive(Clone, Copy, Debug)]
pub struct Observed {
    /// The power law through the errors on all meshes above the floor; none of fewer than three.
    pub law: Option<PowerLaw>,
    /// Whether the errors are in the asymptotic range.
    pub verdict: Verdict,
}

/// Every order that something is expected of.
pub fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for problem in Problem::ALL {
        let run = VARIANTS.iter().filter(|variant| variant.applies_to(problem));
        for variant in run.filter(|v| v.precision == Precision::Double && v.flagged) {
            for quantity in Quantity::ALL {
                if let Some((expected, from, why)) = expected(problem, variant, quantity) {
                    let variant = variant.name;
                    rows.push(Row { problem, variant, quantity, expected, from, why });
                }
            }
        }
    }
    rows
}

/// Signed errors of a quantity from a refinement on: (Δx, error), the coarsest mesh first.
pub fn errors(series: &[&Entry], quantity: Quantity, from: f64) -> Vec<(f64, f64)> {
    let fine = series.iter().filter(|entry| entry.refinement >= from);
    fine.filter_map(|entry| Some((entry.spacing, entry.error(quantity)?))).collect()
}

/// What the error of a quantity is known to: what the exact solution leaves open, or rounding.
pub fn floor(problem: Problem, series: &[&Entry], quantity: Quantity) -> f64 {
    let of_the_profile = match quantity {
        Quantity::StrainL1
        | Quantity::StrainL2
        | Quantity::SecondaryL1
        | Quantity::SecondaryL2
        | Quantity::MeanStrain
        | Quantity::SecondaryMean => true,
        // Where no closed form lasts, it is read off the profile.
        Quantity::Plateau => problem == Problem::Unequal,
        _ => false,
    };
    let floors = series.iter().filter_map(|entry| entry.found.floor);
    if of_the_profile { floors.fold(ROUNDING, f64::max) } else { ROUNDING }
}

/// The order of errors (Δx, error) that are known to a floor.
pub fn observed(errors: &[(f64, f64)], floor: f64) -> Result<Observed, Fault> {
    let verdict = of_errors(errors, Rule { band: BAND, floor })?;
    let above = match verdict {
        Verdict::Floor { from, .. } => &errors[..from],
        _ => errors,
    };
    let sizes: Vec<_> = above.iter().map(|&(spacing, error)| (spacing, error.abs())).collect();
    Ok(Observed { law: power_law(&sizes, LEVEL).ok(), verdict })
}

impl Row {
    /// What the runs of its problem in its variant show; none of fewer than three meshes.
    pub fn observed(&self, series: &[&Entry]) -> Option<Observed> {
        let errors = errors(series, self.quantity, self.from);
        let enough = errors.len() >= LEAST;
        observed(&errors, floor(self.problem, series, self.quantity)).ok().filter(|_| enough)
    }

    /// Whether a verdict is the expected one.
    pub fn agrees(&self, verdict: Verdict) -> bool {
        match self.expected {
            // Of two meshes above the floor there is no order.
            Expected::Order(_) => matches!(
                verdict,
                Verdict::Asymptotic(_)
                    | Verdict::Floor { before: Some(_), .. }
                    | Verdict::Floor { from: 0..LEAST, .. }
            ),
            Expected::Between(..) => true,
            Expected::Stays => verdict == Verdict::NotYet(Reason::NotFalling),
            Expected::Exact => matches!(verdict, Verdict::Floor { from: 0, .. }),
            Expected::Swings => !matches!(verdict, Verdict::Asymptotic(_)),
        }
    }
}

/// A verdict in words.
pub fn verdict(of: Verdict) -> String {
    let range = |run: crate::convergence::Run| format!("{} finest: {:.2}", run.meshes, run.order);
    match of {
        Verdict::Asymptotic(run) => format!("asymptotic ({})", range(run)),
        Verdict::Floor { from: 0, .. } => "on the floor".into(),
        Verdict::Floor { before: Some(run), .. } => {
            format!("asymptotic above the floor ({})", range(run))
        }
        Verdict::Floor { before: None, .. } => "comes to the floor".into(),
        Verdict::Oscillating { changes } => format!("oscillating, {changes} changes of sign"),
        Verdict::NotYet(reason) => match reason {
            Reason::TooFew => "too few meshes".into(),
            Reason::Crossing => "not yet: crosses zero".into(),
            Reason::Dip { .. } => "not yet: passes through zero".into(),
            Reason::NotFalling => "not falling".into(),
            Reason::Scattered => "not yet: scattered".into(),
        },
    }
}

/// A fitted order with its interval.
pub fn fitted(law: Option<PowerLaw>) -> String {
    law.map_or("–".into(), |law| format!("{:.2} ± {:.2}", law.order, law.half_width))
}

/// All orders of a record, in Markdown.
pub fn table(record: &Record) -> String {
    let mut reasons: Vec<&str> = Vec::new();
    let mut lines = Vec::new();
    for row in rows() {
        let Some(seen) = row.observed(&record.series(row.problem, row.variant)) else { continue };
        let reason = reasons.iter().position(|why| *why == row.why).unwrap_or_else(|| {
            reasons.push(row.why);
            reasons.len() - 1
        });
        let has_order = !matches!(row.expected, Expected::Swings | Expected::Exact);
        lines.push(vec![
            row.problem.id().to_owned(),
            row.variant.to_owned(),
            row.quantity.label().to_owned(),
            row.expected.to_string(),
            fitted(seen.law.filter(|_| has_order)),
            verdict(seen.verdict),
            format!("{}", reason + 1),
        ]);
    }
    let head = ["problem", "variant", "error of", "expected", "fitted", "verdict", "why"];
    let mut text = markdown(&head, &lines) + "\n";
    for (k, why) in reasons.iter().enumerate() {
        text += &format!("{}. {}\n", k + 1, cell(why));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::convergence::Reason;
    use crate::precision::VARIANTS;
    use crate::precision::stored::stored;
    use crossfibre::number::Number;

    fn row(expected: Expected) -> Row {
        let (problem, variant, quantity) = (Problem::Single, "", Quantity::Kink);
        Row { problem, variant, quantity, expected, from: 1.0, why: "" }
    }

    fn errors_of(of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        [2.0, 1.1, 0.5, 0.23, 0.125].map(|h| (h, of(h))).to_vec()
    }

    /// Of the unequal fibres no closed form gives a plateau: it is read off the profile.
    #[test]
    fn what_is_read_off_the_profile_is_known_to_what_the_profile_leaves_open() {
        let floor_of = |problem, quantity| {
            let series = stored().series(problem, VARIANTS[4].name);
            floor(problem, &series, quantity)
        };
        let open = floor_of(Problem::Unequal, Quantity::StrainL1);
        assert!(open > ROUNDING, "{open}");
        assert_eq!(floor_of(Problem::Unequal, Quantity::Plateau), open);
        assert_eq!(floor_of(Problem::Unequal, Quantity::Kink), ROUNDING);
        assert_eq!(floor_of(Problem::Single, Quantity::Plateau), ROUNDING);
    }

    #[test]
    fn an_order_is_fitted_above_the_floor_only() {
        let law = |h: f64| -0.031 * Number::exp(0.67 * Number::ln(h));
        let whole = observed(&errors_of(law), 0.0).unwrap();
        // Roundings of logarithms.
        assert!((whole.law.unwrap().order - 0.67).abs() < 1e-13);
        assert!(row(Expected::Order(2.0 / 3.0)).agrees(whole.verdict));
        // The two finest are lost in a floor of 2e-3.
        let drowned = errors_of(|h| if h < 0.3 { -1.4e-3 } else { law(h) });
        let above = observed(&drowned, 2e-3).unwrap();
        assert!(matches!(above.verdict, Verdict::Floor { .. }), "{above:?}");
        assert!(above.law.is_none_or(|law| (law.order - 0.67).abs() < 1e-13), "{above:?}");
    }

    #[test]
    fn a_verdict_that_was_not_expected_is_told() {
        let stays = Verdict::NotYet(Reason::NotFalling);
        let swings = Verdict::Oscillating { changes: 3 };
        for (expected, agreeable) in [
            (Expected::Order(1.0), None),
            (Expected::Stays, Some(stays)),
            (Expected::Swings, Some(swings)),
            (Expected::Exact, None),
        ] {
            for seen in [stays, swings] {
                let agrees =
                    agreeable == Some(seen) || (expected, seen) == (Expected::Swings, stays);
                assert_eq!(row(expected).agrees(seen), agrees, "{expected:?} {seen:?}");
            }
        }
    }

    #[test]
    fn every_problem_has_expectations_and_each_its_reason() {
        for problem in Problem::ALL {
            assert!(rows().iter().filter(|row| row.problem == problem).count() > 5);
        }
        assert!(rows().iter().all(|row| row.why.ends_with('.')));
    }
}
