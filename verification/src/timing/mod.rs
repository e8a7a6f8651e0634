//! How long things take: the one place where the project measures speed.
//!
//! Contestants take turns, round after round, so that whatever else the machine does falls on all of
//! them. What is reported is the least time, the median and the greatest, and how many times as long a
//! contestant takes as another. Times are never golden, and nothing fails on time; bits that differ do.
//!
//! 1. [`turns`]: who takes part, and what came of it.
//! 2. [`machine`]: what machine it was, and a loop by which two machines can be set in relation.
//! 3. [`march`], [`program`]: a turn of the reference, and of a program that measures itself.
//! 4. [`table`]: the times for people.

pub mod machine;
pub mod march;
pub mod program;
pub mod table;

#[cfg(test)]
mod tests;

use std::time::Instant;

use anyhow::{Result, bail, ensure};
use serde::{Deserialize, Serialize};

/// What one run did.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    /// How long it took, s.
    pub seconds: f64,
    /// Elements visited, summed over the steps; 0 where there are none to count.
    pub element_steps: u64,
    /// A digest of the result, where there is one that others must have, too.
    pub checksum: Option<u64>,
}

/// One who takes turns.
pub struct Contestant<'a> {
    /// The name.
    pub name: String,
    /// Does one run and says how long that took.
    pub run: Box<dyn FnMut() -> Result<Turn> + 'a>,
}

impl<'a> Contestant<'a> {
    /// One of a name.
    pub fn new(name: impl Into<String>, run: impl FnMut() -> Result<Turn> + 'a) -> Self {
        Self { name: name.into(), run: Box::new(run) }
    }
}

/// The times of a contestant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timed {
    /// The name.
    pub name: String,
    /// The least time of all rounds, s: what the program takes when nothing disturbs it.
    pub least: f64,
    /// The median, s.
    pub median: f64,
    /// The greatest, s.
    pub greatest: f64,
    /// Of one run.
    pub element_steps: u64,
    /// Of one run.
    pub checksum: Option<u64>,
}

impl Timed {
    /// How many times as long it takes as another, by the least times.
    pub fn ratio(&self, to: &Self) -> f64 {
        self.least / to.least
    }

    /// By what part of the least time the greatest exceeds it.
    pub fn spread(&self) -> f64 {
        self.greatest / self.least - 1.0
    }

    /// Of one element in one step, s, by the least time.
    pub fn per_element_step(&self) -> f64 {
        self.least / self.element_steps as f64
    }
}

/// All take turns, in so many rounds; every other round goes backward, so that nobody always comes
/// after the same other.
///
/// # Errors
/// What a contestant fails with. A contestant that does not do the same in every turn. No round.
pub fn turns(rounds: usize, contestants: &mut [Contestant<'_>]) -> Result<Vec<Timed>> {
    ensure!(rounds > 0, "without a round nobody takes a turn");
    let mut taken = vec![Vec::with_capacity(rounds); contestants.len()];
    for round in 0..rounds {
        for place in 0..contestants.len() {
            let who = if round % 2 == 0 { place } else { contestants.len() - 1 - place };
            taken[who].push((contestants[who].run)()?);
        }
    }
    contestants.iter().zip(&taken).map(|(who, turns)| timed(&who.name, turns)).collect()
}

fn timed(name: &str, turns: &[Turn]) -> Result<Timed> {
    let Turn { element_steps, checksum, .. } = turns[0];
    let is_same = |turn: &Turn| (turn.element_steps, turn.checksum) == (element_steps, checksum);
    ensure!(turns.iter().all(is_same), "{name} does not do the same in every turn");
    let mut seconds: Vec<_> = turns.iter().map(|turn| turn.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let last = seconds.len() - 1;
    Ok(Timed {
        name: name.into(),
        least: seconds[0],
        median: 0.5 * (seconds[last / 2] + seconds[seconds.len() / 2]),
        greatest: seconds[last],
        element_steps,
        checksum,
    })
}

/// Whether all that have a checksum have the same.
///
/// # Errors
/// The first two that have not.
pub fn same_bits(all: &[Timed]) -> Result<()> {
    let mut summed = all.iter().filter(|timed| timed.checksum.is_some());
    if let Some(first) = summed.next()
        && let Some(other) = summed.find(|timed| timed.checksum != first.checksum)
    {
        bail!("the bits of `{}` are not those of `{}`", other.name, first.name);
    }
    Ok(())
}

/// How long some work takes, s, and what comes of it.
pub fn clocked<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let out = std::hint::black_box(work());
    (start.elapsed().as_secs_f64(), out)
}
