//! The pictures of the study. All but those of [`profiles`] and [`space_time`] are drawn from records
//! alone; these make a few short runs of their own, the same to the bit every time.

pub mod convergence;
mod errors;
mod floors;
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
