//! A candidate's answer held against what is expected: the verdict.

use crossfibre::scene::Scene;
use crossfibre::state::State;

use super::candidate::shortened;
use super::expected::{self, Expected, ExpectedQuantity, kind};
use super::judge::{Judged, judge};
use super::protocol::{CrossoverRecord, Precision, ResultRecord, StateRecord, Value};
use super::quantity::Quantity;
use super::record::Verdict;

/// How answers are judged.
#[derive(Clone, Copy, Debug)]
pub struct Judge {
    /// What the candidate computes in.
    pub precision: Precision,
    /// Whether equal bits are demanded.
    pub exact: bool,
}

/// What became of one question.
#[derive(Debug)]
pub struct Outcome {
    /// In a word.
    pub verdict: Verdict,
    /// Why, where it is not that the answer agrees.
    pub reason: Option<String>,
    /// The quantities that were judged.
    pub judged: Vec<Judged>,
}

impl Outcome {
    /// There is nothing to be judged.
    pub fn unjudged(verdict: Verdict, reason: String) -> Self {
        Self { verdict, reason: Some(reason), judged: vec![] }
    }

    /// There is no answer that could be judged.
    pub fn broken(reason: String) -> Self {
        Self::unjudged(Verdict::Broken, reason)
    }
}

/// Each method gives what became of an answer, or in what it is none.
impl Judge {
    /// Of an equation.
    pub fn equation(&self, expected: &Expected, out: &Value) -> Result<Outcome, String> {
        let judged = vec![judge(&expected.quantities[0], &out.numbers(), self.precision)?];
        Ok(self.verdict(expected, &[], judged))
    }

    /// Of a step.
    pub fn step(
        &self,
        scene: &Scene,
        expected: &Expected,
        state: &StateRecord,
    ) -> Result<Outcome, String> {
        state.state::<f64>(scene)?;
        let judged = self.judged(&expected.quantities, &state.numbers())?;
        let counts = differing(&expected.counts, state);
        Ok(self.verdict(expected, &counts, judged))
    }

    /// Of a run.
    pub fn run(
        &self,
        scene: &Scene,
        expected: &Expected,
        result: &ResultRecord,
    ) -> Result<Outcome, String> {
        let ended = match result.outcome.kind.as_str() {
            "energy_unbalanced" => "completed",
            other => other,
        };
        let wanted = kind(&expected.outcome);
        if ended != wanted {
            let reason = format!("it ends as `{}`, not `{wanted}`", shortened(ended));
            return Ok(self.verdict(expected, &[reason], vec![]));
        }
        let mut differences = Vec::new();
        if wanted != "completed" {
            return Ok(self.verdict(expected, &differences, vec![]));
        }
        let record = result.state_record();
        let state: State<f64> = record.state(scene)?;
        let mut numbers = record.numbers();
        numbers.push((Quantity::ProjectilePosition, vec![result.projectile.position.0]));
        if !scene.has_other_laws() {
            numbers.push((Quantity::Energy, vec![expected::energy_of(scene, &state)]));
        }
        differences.extend(differing(&expected.counts, &record));
        let judged = self.judged(&expected.quantities, &numbers)?;
        Ok(self.verdict(expected, &differences, judged))
    }

    fn judged(
        &self,
        expected: &[ExpectedQuantity],
        found: &[(Quantity, Vec<f64>)],
    ) -> Result<Vec<Judged>, String> {
        let of = |expected: &ExpectedQuantity| {
            let (_, numbers) = found
                .iter()
                .find(|(quantity, _)| *quantity == expected.quantity)
                .ok_or_else(|| format!("the answer has no {}", expected.quantity))?;
            judge(expected, numbers, self.precision)
        };
        expected.iter().map(of).collect()
    }

    fn verdict(&self, expected: &Expected, differences: &[String], judged: Vec<Judged>) -> Outcome {
        let same = judged.iter().all(Judged::is_same) && differences.is_empty();
        // The first that is wrong, in the order in which a state lists them.
        let wrong =
            judged.iter().find(|j| if self.exact { !j.is_same() } else { !j.is_rounding() });
        let reason = differences.first().cloned().or_else(|| wrong.map(describe));
        let (verdict, reason) = match (&expected.beyond, reason) {
            _ if same => (Verdict::Bits, None),
            (Some(beyond), _) if !self.exact => (Verdict::NotJudged, Some(beyond.clone())),
            (_, Some(reason)) => (Verdict::Wrong, Some(reason)),
            (_, None) => (Verdict::Rounding, None),
        };
        let judged = if verdict == Verdict::NotJudged { vec![] } else { judged };
        Outcome { verdict, reason, judged }
    }
}

/// Counts that are not equal.
fn differing(expected: &[(&'static str, u64)], found: &StateRecord) -> Vec<String> {
    let CrossoverRecord { node, moves } =
        found.crossover.unwrap_or(CrossoverRecord { node: 0, moves: 0 });
    expected
        .iter()
        .map(|&(name, count)| {
            let found = match name {
                "steps" => found.step,
                "crossover node" => node,
                _ => moves,
            };
            (name, count, found)
        })
        .filter(|(_, count, found)| count != found)
        .map(|(name, count, found)| format!("{name}: {found}, not {count}"))
        .collect()
}

fn describe(judged: &Judged) -> String {
    let Judged { quantity, place, expected, found, envelopes, allowed, .. } = judged;
    let at = if place.is_empty() { String::new() } else { format!(" at {place}") };
    let apart = match envelopes {
        e if e.is_infinite() => "not finite".to_owned(),
        e => format!("{e:.1e} envelopes of rounding, {allowed} allowed"),
    };
    format!("{quantity}{at}: {found:e}, not {expected:e}: {apart}")
}
