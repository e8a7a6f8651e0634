//! Where each error comes from: rounding, discretisation, model.
//!
//! ```text
//! value − exact = (value − value in 106 bits)      rounding
//!               + (value in 106 bits − limit)      discretisation
//!               + (limit − exact)                  model
//! ```
//!
//! The values in 106 bits are of the same equations on the same mesh; the limit is that of the errors
//! at h → 0, where they are in the asymptotic range or on the floor. All parts are relative to the exact number, where
//! it is not zero: a ladder on which the time that is reached differs from mesh to mesh has a limit of
//! errors, and none of values.

use crate::convergence::{Rule, Verdict, fitted_limit, of_values, richardson};

use super::orders::{BAND, LEVEL, floor, verdict};
use super::problems::Problem;
use super::reading::Quantity;
use super::record::{Entry, Record};
use crate::tables::markdown;

/// The refinement on which the errors of the table are: 0.5 mm.
pub const AT: f64 = 4.0;

/// The variants that are split, each with itself in 106 bits and in 24.
pub const SPLIT: [(&str, &str, Option<&str>); 3] = [
    ("eqn (4), α = 1", "eqn (4), α = 1, 106 bits", Some("eqn (4), α = 1, f32")),
    ("engineering, α = 1", "engineering, α = 1, 106 bits", Some("engineering, α = 1, f32")),
    ("eqn (4), α = 1, printed", "eqn (4), α = 1, printed, 106 bits", None),
];

/// The part of an error by which the limit of a norm may come out negative.
const NOTHING: f64 = 0.01;

/// Orders between which a limit is looked for.
const ORDERS: (f64, f64) = (0.15, 6.0);

/// An error and what it is made of. All signed and relative to the exact number where that is not zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Split {
    /// value − exact.
    pub total: f64,
    /// Rounding of 53 bits.
    pub rounding: f64,
    /// Rounding of 24 bits; none if the run in single precision did not complete, or there is none.
    pub single: Option<f64>,
    /// The rest of the total.
    pub rest: Rest,
}

/// An error without rounding.
#[derive(Clone, Debug, PartialEq)]
pub enum Rest {
    /// The ladder has a limit.
    Apart {
        /// Of the mesh.
        discretisation: f64,
        /// Of the equations.
        model: f64,
        /// Half the width of the interval of the limit.
        uncertainty: f64,
    },
    /// It has none that could be stated.
    Together {
        /// Of mesh and equations.
        both: f64,
        /// Why.
        why: String,
    },
}

/// The limit of signed errors (Δx, error) and half the width of its interval, or why there is none.
///
/// It is fitted to the asymptotic range; its interval holds that of the three finest meshes as well. Where there is none, as the finest errors differ by little more
/// than they are known to, it is the finest error, known to twice what the three finest differ by and
/// the floor.
pub fn limit(errors: &[(f64, f64)], floor: f64) -> Result<(f64, f64), String> {
    let rule = Rule { band: BAND, floor };
    let seen = of_values(errors, rule).map_err(|fault| fault.to_string())?;
    let run = match seen {
        Verdict::Asymptotic(run) | Verdict::Floor { before: Some(run), .. } => run,
        Verdict::Floor { from, before: None } => {
            let finest = errors[errors.len() - 1].1;
            let last = &errors[from.max(errors.len().saturating_sub(3))..];
            let apart = last.iter().map(|(_, error)| (error - finest).abs());
            // With order 1/3 what is left is 1.7 times what three meshes differ by.
            return Ok((finest, floor + 2.0 * apart.fold(0.0, f64::max)));
        }
        other => return Err(verdict(other)),
    };
    let asymptotic = &errors[run.from..run.from + run.meshes];
    let fitted = fitted_limit(asymptotic, ORDERS, LEVEL).map_err(|fault| fault.to_string())?;
    // A slow bend leaves little scatter, but gives the finest meshes another limit.
    let finest = richardson(asymptotic).ok().and_then(|found| found.extrapolation);
    let bend = finest.map_or(0.0, |finest| (finest.limit - fitted.limit).abs());
    Ok((fitted.limit, fitted.half_width.max(bend)))
}

impl Split {
    /// The error of a quantity of a variant, on a mesh of which there is a run in 106 bits.
    pub fn of(
        record: &Record,
        problem: Problem,
        (variant, in_106_bits, in_24_bits): (&str, &str, Option<&str>),
        quantity: Quantity,
        refinement: f64,
    ) -> Option<Self> {
        let series = record.series(problem, variant);
        let error = |variant: &str| {
            let series = record.series(problem, variant);
            let entry = series.into_iter().find(|entry| entry.refinement == refinement)?;
            entry.error(quantity)
        };
        let (total, exactly) = (error(variant)?, error(in_106_bits)?);
        let errors = super::orders::errors(&series, quantity, 0.0);
        let rest = match limit(&errors, uncertain(problem, &series, quantity)) {
            Ok((limit, uncertainty))
                if is_norm(quantity) && limit + uncertainty < -NOTHING * total =>
            {
                let why = "the fitted one is negative, and a norm is not: orders bend".into();
                Rest::Together { both: exactly, why }
            }
            Ok((limit, uncertainty)) => {
                Rest::Apart { discretisation: exactly - limit, model: limit, uncertainty }
            }
            Err(why) => Rest::Together { both: exactly, why },
        };
        let single = in_24_bits.and_then(error).map(|single| single - exactly);
        Some(Self { total, rounding: total - exactly, single, rest })
    }
}

/// Whether a number cannot be negative.
fn is_norm(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::StrainL1 | Quantity::StrainL2 | Quantity::SecondaryL1 | Quantity::SecondaryL2
    )
}

/// What differences of errors from mesh to mesh are known to: the exact answer is the same on all, but
/// for a profile that is sampled with the mesh.
fn uncertain(problem: Problem, series: &[&Entry], quantity: Quantity) -> f64 {
    match problem {
        Problem::Single | Problem::Crossed => super::orders::ROUNDING,
        Problem::Unequal | Problem::Rod => floor(problem, series, quantity),
    }
}

fn percent(x: f64) -> String {
    match 100.0 * x {
        0.0 => "0".into(),
        x if x.abs() < 1e-3 => format!("{x:.0e}"),
        x => format!("{x:.4}"),
    }
}

/// The splits of a record on the mesh [`AT`], in Markdown, in per cent.
pub fn table(record: &Record) -> String {
    let mut rows = Vec::new();
    for problem in Problem::ALL {
        for variants in SPLIT {
            for quantity in Quantity::ALL {
                let Some(split) = Split::of(record, problem, variants, quantity, AT) else {
                    continue;
                };
                let single = match (split.single, variants.2) {
                    (Some(single), _) => percent(single),
                    (None, Some(_)) => "run ends".into(),
                    (None, None) => "–".into(),
                };
                let (discretisation, model) = match split.rest {
                    Rest::Apart { discretisation, model, uncertainty } => (
                        percent(discretisation),
                        format!("{} ± {}", percent(model), percent(uncertainty)),
                    ),
                    Rest::Together { both, why } => {
                        (format!("{}, with model", percent(both)), format!("no limit: {why}"))
                    }
                };
                rows.push(vec![
                    problem.id().to_owned(),
                    variants.0.to_owned(),
                    quantity.label().to_owned(),
                    percent(split.total),
                    percent(split.rounding),
                    single,
                    discretisation,
                    model,
                ]);
            }
        }
    }
    let head = [
        "problem",
        "variant",
        "quantity",
        "error, %",
        "rounding, %",
        "rounding in f32, %",
        "discretisation, %",
        "model, %",
    ];
    markdown(&head, &rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precision::{Found, Reading};
    use crossfibre::number::Number;
    use crossfibre::outcome::Outcome;

    const ROUNDED: f64 = 3.1e-9;
    const WRONG: f64 = -0.0137;

    /// The error of the mesh alone.
    fn of_the_mesh(refinement: f64) -> f64 {
        0.0231 * Number::exp(-0.71 * Number::ln(refinement))
    }

    /// A ladder with a known error of each kind; `swing` turns the sign of the mesh's at each mesh.
    fn record(swing: f64) -> Record {
        let mut entries = Vec::new();
        for (variant, rounding) in [(SPLIT[0].0, ROUNDED), (SPLIT[0].1, 0.0)] {
            let mut sign = 1.0;
            for refinement in [1.0, 2.0, 4.0, 8.0, 16.0] {
                sign *= swing;
                let error = sign * of_the_mesh(refinement) + WRONG + rounding;
                let exact = Some(0.0519);
                let reading = Reading {
                    quantity: Quantity::Reflection,
                    value: 0.0519 * (1.0 + error),
                    exact,
                };
                entries.push(Entry {
                    problem: Problem::Crossed,
                    variant: variant.into(),
                    refinement,
                    elements: 150,
                    spacing: 2e-3 / refinement,
                    found: Found {
                        outcome: Outcome::Completed,
                        time: 0.0,
                        steps: 0,
                        element_steps: 0,
                        evaluations: 0,
                        readings: vec![reading],
                        floor: None,
                    },
                });
            }
        }
        Record { format: String::new(), version: String::new(), entries }
    }

    fn split(record: &Record) -> Split {
        Split::of(record, Problem::Crossed, SPLIT[0], Quantity::Reflection, 4.0).unwrap()
    }

    #[test]
    fn the_parts_of_a_made_up_error_are_found_again() {
        let split = split(&record(1.0));
        // Rounding of numbers of 1e-2, and of the fit: squares are flat to 1e-8 about their least.
        assert!((split.rounding / ROUNDED - 1.0).abs() < 1e-6, "{split:?}");
        let Rest::Apart { discretisation, model, uncertainty } = split.rest else {
            panic!("{split:?}")
        };
        // All meshes bear the same rounding, which the limit takes for the model's.
        assert!((model - WRONG - ROUNDED).abs() < 1e-8, "{model}");
        assert!((discretisation / of_the_mesh(4.0) - 1.0).abs() < 1e-6, "{discretisation}");
        assert!((split.total - split.rounding - discretisation - model).abs() < 1e-15);
        assert!(uncertainty < 1e-8, "{uncertainty}");
    }

    #[test]
    fn errors_that_swing_are_not_split() {
        let split = split(&record(-1.0));
        assert!(
            matches!(split.rest, Rest::Together { ref why, .. } if why.contains("oscillating"))
        );
    }

    #[test]
    fn a_part_is_written_in_per_cent_to_four_decimals_or_as_a_power_of_ten() {
        let shown = [0.0, 0.3, -0.001_234_56, 5e-6, -5e-6].map(percent);
        assert_eq!(shown, ["0", "30.0000", "-0.1235", "5e-4", "-5e-4"]);
    }

    #[test]
    fn the_splits_of_the_stored_record_are_those_of_the_committed_page() {
        let page = include_str!("../../../VALIDATION.md");
        let table = table(crate::precision::stored::stored());
        assert!(table.starts_with("| problem |") && page.contains(&table), "{table}");
    }
}
