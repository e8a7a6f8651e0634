//! The pictures of the study. All but those of [`profiles`] and [`space_time`] are drawn from records
//! alone; these make a few short runs of their own, the same to the bit every time.

pub mod convergence;
mod errors;
pub mod floors;
mod looks;
pub mod profiles;
mod space_time;
pub mod time;
pub mod work;

use super::problems::Problem;
use super::record::Record;
use super::times::Times;

/// The page's own variant, and the same with engineering strain.
pub const BASES: [&str; 2] = ["eqn (4), α = 1", "engineering, α = 1"];

/// Every picture, and the tables of what only pictures show.
pub fn files(record: &Record, times: Option<&Times>) -> Vec<(&'static str, String)> {
    let work = |problem| (work::file(problem), work::picture(record, problem));
    let mut files: Vec<_> = Problem::ALL.map(work).into();
    let profiles = profiles::Profiles::made();
    files.extend([
        ("convergence.svg", convergence::picture(record)),
        ("floors.svg", floors::picture(record)),
        ("profiles.svg", profiles.whole()),
        ("close-ups.svg", profiles.close_ups()),
        ("profiles.csv", profiles.table()),
        ("xt.svg", space_time::marched()),
        ("xt-exact.svg", space_time::exact()),
    ]);
    files.extend(times.map(|times| ("time.svg", time::picture(record, times))));
    files
}

#[cfg(test)]
mod made_up {
    //! Records of runs that were never made.

    use crossfibre::outcome::Outcome;
    use crossfibre::place::{Fibre, Place};

    use super::super::problems::Problem;
    use super::super::reading::{Quantity, Reading};
    use super::super::record::{Entry, FORMAT, Record};
    use super::super::run::Found;

    /// A run on elements of a length, m, with an error of L1; none for a run that diverged.
    pub fn entry(variant: &str, spacing: f64, error: Option<f64>) -> Entry {
        let elements = (0.3 / spacing).round() as usize;
        let place = Place { step: 7, fibre: Fibre::Primary, index: 3 };
        let reading = |value| Reading { quantity: Quantity::StrainL1, value, exact: Some(0.0) };
        Entry {
            problem: Problem::Crossed,
            variant: variant.into(),
            refinement: 2e-3 / spacing,
            elements,
            spacing,
            found: Found {
                outcome: error
                    .map_or(Outcome::Diverged { place, equation: 6 }, |_| Outcome::Completed),
                time: 28.7e-6,
                steps: elements as u64,
                element_steps: (elements * elements) as u64,
                evaluations: 0,
                readings: error.map(reading).into_iter().collect(),
                floor: Some(2.3e-5),
            },
        }
    }

    pub fn record(entries: Vec<Entry>) -> Record {
        Record { format: FORMAT.into(), version: String::new(), entries }
    }
}
