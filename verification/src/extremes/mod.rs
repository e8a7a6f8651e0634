//! Extreme cases: the ends of every parameter, what happens there, whether it is right, and what the
//! program says.
//!
//! Each group is a case of `verify`; all of them are the page `docs/extremes`.

mod crossover;
mod laws;
mod long;
mod mesh;
mod page;
mod projectile;
mod ratios;
pub mod rounding;
pub mod scaling;
mod velocity;

use crossfibre::outcome::Outcome;
use crossfibre::result::RunResult;
use crossfibre::scene::Scene;

use crate::cases::{Bound, Case, Check};
use crate::planted;

pub use page::page;

/// One line of the table.
struct Row {
    /// The scene, in words.
    extreme: String,
    /// What the program says of it: the outcome of the run, or why there was none.
    says: String,
    /// What must happen, and how it is known to.
    check: Check,
}

/// Lines about one parameter.
struct Group {
    case: Case,
    rows: fn() -> Vec<Row>,
    /// What was found, for the page.
    found: &'static str,
}

const GROUPS: &[Group] = &[
    velocity::GROUP,
    rounding::GROUP,
    ratios::GROUP,
    crossover::GROUP,
    mesh::GROUP,
    long::GROUP,
    projectile::GROUP,
    laws::GROUP,
    scaling::GROUP,
];

/// The groups as cases of `verify`.
pub fn cases() -> Vec<Case> {
    GROUPS.iter().map(|group| group.case).collect()
}

/// The checks of lines, each claim with the scene that it is of: beside others it would not say which.
fn checks(rows: Vec<Row>) -> Vec<Check> {
    let of = |Row { extreme, check, .. }: Row| {
        let claim = format!("{extreme}: {}", check.claim);
        Check { claim, ..check }
    };
    rows.into_iter().map(of).collect()
}

/// A line; `norm`, `measured`, `bound` and `reason` as in a [`Check`].
#[allow(clippy::too_many_arguments)] // the columns of the table, in their order
fn row(
    extreme: impl Into<String>,
    claim: &str,
    says: impl Into<String>,
    oracle: &str,
    norm: &str,
    measured: f64,
    bound: Bound,
    reason: &str,
) -> Row {
    let check = crate::cases::support::check(claim, oracle, norm, measured, bound, reason);
    Row { extreme: extreme.into(), says: says.into(), check }
}

/// Runs a scene that passes its check.
///
/// # Panics
/// If it does not: a fault of this program.
fn run(scene: &Scene) -> RunResult {
    if let Err(problem) = planted::check(scene) {
        panic!("{problem}");
    }
    planted::run(scene, |_| {})
}

/// What the check of a scene says.
fn verdict(scene: &Scene) -> String {
    planted::check(scene).map_or_else(
        |problem| format!("refused: {}: {}", problem.path, problem.message),
        |()| "accepted".into(),
    )
}

/// 1 if the check of a scene refuses it.
fn refused(scene: &Scene) -> f64 {
    f64::from(u8::from(planted::check(scene).is_err()))
}

/// What the program says of several runs: the kinds of outcome, and how often each.
fn tally<'a>(outcomes: impl IntoIterator<Item = &'a Outcome>) -> String {
    let mut kinds: Vec<(String, usize)> = Vec::new();
    for outcome in outcomes {
        let text = outcome.to_string();
        let kind = text.split(':').next().unwrap_or(&text);
        match kinds.iter_mut().find(|(known, _)| known == kind) {
            Some((_, times)) => *times += 1,
            None => kinds.push((kind.into(), 1)),
        }
    }
    kinds.iter().map(|(kind, times)| format!("{kind} ({times})")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::support::shipped;

    #[test]
    fn one_is_for_a_scene_that_is_refused() {
        let mut scene = shipped("single-400");
        assert_eq!((refused(&scene), verdict(&scene)), (0.0, "accepted".into()));
        scene.courant = -0.7;
        assert_eq!(refused(&scene), 1.0);
        assert!(verdict(&scene).starts_with("refused: courant: "), "{}", verdict(&scene));
    }

    #[test]
    fn each_group_is_a_case() {
        let ids: Vec<_> = cases().iter().map(|case| case.id).collect();
        assert_eq!(ids.len(), GROUPS.len());
        assert!(ids.iter().all(|id| id.starts_with("extreme.")), "{ids:?}");
    }

    #[test]
    fn a_claim_is_made_with_the_scene_that_it_is_of() {
        let bound = Bound::AtMost(0.9);
        let line = row("2 elements", "They move", "completed", "a person", "m", 0.37, bound, "why");
        let made = checks(vec![line]);
        let [check] = &made[..] else { panic!("{made:?}") };
        assert_eq!(check.claim, "2 elements: They move");
        assert_eq!((check.measured, check.bound), (0.37, bound));
    }
}
