//! What an accuracy takes, for people.

use std::fmt::{self, Display};

use crossfibre::scene::Scene;

use crate::precision::Quantity;
use crate::precision::advice::{Accuracy, Advice, Against, Needs};

/// Displays as the second half of a plan.
pub struct Table<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What was found out.
    pub accuracy: &'a Accuracy,
}

impl Display for Table<'_> {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let Self { scene, accuracy } = self;
        let trials = &accuracy.trials;
        let all: u64 = trials.iter().map(|trial| trial.element_steps).sum();
        let ends = trials.first().zip(trials.last());
        let (coarsest, finest) =
            ends.map_or((0, 0), |(first, last)| (first.elements, last.elements));
        writeln!(
            to,
            "accuracy     {:e}, by {} trial runs of {coarsest} to {finest} elements, {:.1e} \
             element-steps in all",
            accuracy.wanted,
            trials.len(),
            all as f64
        )?;
        match &accuracy.against {
            Against::Exact => {
                writeln!(to, "             errors are those against the exact answer")?
            }
            Against::Limit { why } => writeln!(
                to,
                "             no exact answer ({why}): errors are those against what the meshes tend to"
            )?,
        }
        if let Some(floor) = accuracy.floor.filter(|floor| *floor > 0.1 * accuracy.wanted) {
            writeln!(
                to,
                "             the exact profile itself is known to {floor:.1e}, as L1 has it"
            )?;
        }
        let failed = trials.iter().filter(|trial| !trial.outcome.is_completed());
        for trial in failed {
            writeln!(to, "beware       {} elements: {}", trial.elements, trial.outcome)?;
        }
        if accuracy.quantities.is_empty() {
            return writeln!(
                to,
                "             no mesh is advised as long as trial runs do not complete"
            );
        }
        writeln!(
            to,
            "\nquantity                         error now   order         elements   Δx, mm    \
             element-steps   error found"
        )?;
        for advice in &accuracy.quantities {
            line(to, scene, advice)?;
        }
        let beyond = accuracy.quantities.iter().any(|a| matches!(a.needs, Needs::TooLong { .. }));
        if beyond {
            writeln!(to, "\n*: not run; the law of the coarser meshes, extrapolated")?;
        }
        Ok(())
    }
}

fn line(to: &mut fmt::Formatter, scene: &Scene, advice: &Advice) -> fmt::Result {
    let Advice { quantity, now, order, needs } = advice;
    let order = order.map_or("–".into(), |(p, w)| format!("{p:.2} ± {w:.2}"));
    write!(to, "{:<31}  {now:>9.1e}   {order:<11}  ", name(*quantity))?;
    let spacing = |elements: f64| 1e3 * scene.primary.length / elements;
    match *needs {
        Needs::Run { elements, element_steps, found, .. } => {
            let dx = spacing(elements as f64);
            writeln!(
                to,
                "{elements:>9}   {dx:>7.4}   {:>13.2e}   {found:>11.1e}",
                element_steps as f64
            )
        }
        Needs::TooLong { elements, element_steps, .. } => {
            let dx = spacing(elements);
            writeln!(to, "{elements:>9.1e}   {dx:>7.0e}   {element_steps:>13.2e}   {:>11}", "*")
        }
        Needs::Unknown { error, elements } => {
            writeln!(
                to,
                "not reached: {error:.1e} on {elements} elements, and no law that leads on"
            )
        }
    }
}

fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Reflection => "R, reflection",
        Quantity::Transmission => "T, transmission",
        Quantity::Diversion => "D, diversion of one arm",
        other => other.label(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn a_floor_is_told_where_it_is_more_than_a_tenth_of_what_is_wanted() {
        let scene = shipped("fig3");
        let told = |floor| {
            let (trials, quantities) = (vec![], vec![]);
            let accuracy =
                Accuracy { wanted: 1e-2, against: Against::Exact, floor, trials, quantities };
            Table { scene: &scene, accuracy: &accuracy }.to_string().contains("is known to 3.7e")
        };
        assert_eq!([None, Some(3.7e-4), Some(3.7e-3)].map(told), [false, false, true]);
    }

    #[test]
    fn what_a_picture_has_a_letter_for_is_named_in_words() {
        for (quantity, words) in [
            (Quantity::Reflection, "R, reflection"),
            (Quantity::Transmission, "T, transmission"),
            (Quantity::Diversion, "D, diversion of one arm"),
            (Quantity::Kink, "position of the kink"),
        ] {
            assert_eq!(name(quantity), words);
        }
    }
}
