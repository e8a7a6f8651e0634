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

#[cfg(test)]
mod tests {
    use crossfibre::outcome::Outcome as End;
    use crossfibre::place::{Fibre, Place};
    use crossfibre::result;

    use super::*;
    use crate::cases::support::coarse_fig3;
    use crate::conform::real::Real;

    const HANGS: &str = "how it ends hangs on rounding";

    fn judging(exact: bool) -> Judge {
        Judge { precision: Precision::F64, exact }
    }

    /// Two numbers of (11) with an envelope of 2⁻¹⁰; 4 envelopes are allowed.
    fn of_equation(beyond: Option<&str>) -> Expected {
        let envelope = 2.0_f64.powi(-10);
        let quantity = Quantity::Equation(11);
        Expected {
            quantities: vec![ExpectedQuantity { quantity, values: vec![0.5, 0.25], envelope }],
            counts: vec![],
            outcome: End::Completed,
            beyond: beyond.map(Into::into),
        }
    }

    #[test]
    fn an_answer_is_equal_rounded_or_wrong_and_beyond_rounding_only_equal_bits_count() {
        let wrong = "eqn (11) at component 1: 2.548828125e-1, not 2.5e-1: 5.0e0 envelopes of rounding, \
                     4 allowed";
        let rounded = "eqn (11) at component 1: 2.51953125e-1, not 2.5e-1: 2.0e0 envelopes of rounding, \
                       4 allowed";
        let not_finite = "eqn (11) at component 1: NaN, not 2.5e-1: not finite";
        let envelope = 2.0_f64.powi(-10);
        // The second number; what it is where rounding is judged, where it cannot be, where equal bits
        // are demanded.
        for (found, verdict, reason, beyond, exact, exact_reason) in [
            (0.25, Verdict::Bits, None, Verdict::Bits, Verdict::Bits, None),
            (
                0.25 + 2.0 * envelope,
                Verdict::Rounding,
                None,
                Verdict::NotJudged,
                Verdict::Wrong,
                Some(rounded),
            ),
            (
                0.25 + 5.0 * envelope,
                Verdict::Wrong,
                Some(wrong),
                Verdict::NotJudged,
                Verdict::Wrong,
                Some(wrong),
            ),
            (
                f64::NAN,
                Verdict::Wrong,
                Some(not_finite),
                Verdict::NotJudged,
                Verdict::Wrong,
                Some(not_finite),
            ),
        ] {
            let judged = |exact, expected: &Expected| {
                judging(exact).equation(expected, &Value::of(&[0.5, found])).unwrap()
            };
            let plain = judged(false, &of_equation(None));
            assert_eq!((plain.verdict, plain.reason.as_deref()), (verdict, reason), "{found}");
            assert_eq!(plain.judged.len(), 1);
            let unsure = judged(false, &of_equation(Some(HANGS)));
            assert_eq!(unsure.verdict, beyond, "{found}");
            let is_equal = beyond == Verdict::Bits;
            assert_eq!(unsure.reason.as_deref(), (!is_equal).then_some(HANGS), "{found}");
            // What is not judged is in no table.
            assert_eq!(unsure.judged.len(), usize::from(is_equal), "{found}");
            for by_bits in [of_equation(None), of_equation(Some(HANGS))] {
                let by_bits = judged(true, &by_bits);
                assert_eq!(by_bits.verdict, exact, "{found}");
                assert_eq!(by_bits.reason.as_deref(), exact_reason, "{found}");
                assert_eq!(by_bits.judged.len(), 1);
            }
        }
        let error = judging(false).equation(&of_equation(None), &Value::of(&[0.5])).unwrap_err();
        assert_eq!(error, "eqn (11) has 1 numbers, not 2");
    }

    /// The result of the library's own march, by the text that a candidate would write.
    fn right_result(scene: &Scene) -> ResultRecord {
        let result = result::run(scene, |_| ());
        serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap()
    }

    #[test]
    fn the_right_state_is_equal_and_counts_that_differ_make_it_wrong() {
        let scene = coarse_fig3();
        let result = right_result(&scene);
        // The crossover at 0.1 m is at node 2 of elements of 0.05 m, and nothing slides.
        let right = result.state_record();
        assert_eq!(right.crossover, Some(CrossoverRecord { node: 2, moves: 0 }));
        let expected = expected::of_run(&scene, Precision::F64);
        let quantities = expected
            .quantities
            .iter()
            .filter(|e| !matches!(e.quantity, Quantity::ProjectilePosition | Quantity::Energy));
        let expected = Expected { quantities: quantities.cloned().collect(), ..expected };
        let judge = judging(false);
        let judged = |state: &StateRecord| {
            let Outcome { verdict, reason, judged } = judge.step(&scene, &expected, state).unwrap();
            assert_eq!(judged.len(), 9); // four of either fibre, and the projectile
            (verdict, reason.unwrap_or_default())
        };
        assert_eq!(judged(&right), (Verdict::Bits, String::new()));
        let step = right.step + 1;
        let with_crossover = |node, moves| StateRecord {
            crossover: Some(CrossoverRecord { node, moves }),
            ..right.clone()
        };
        for (state, reason) in [
            (StateRecord { step, ..right.clone() }, format!("steps: {step}, not {}", step - 1)),
            (with_crossover(3, 0), "crossover node: 3, not 2".into()),
            (with_crossover(2, 1), "crossover moves: 1, not 0".into()),
            (with_crossover(1, 1), "crossover node: 1, not 2".into()),
        ] {
            assert_eq!(judged(&state), (Verdict::Wrong, reason));
        }
        let mut rounded = right.clone();
        let Real(strain) = &mut rounded.primary.strain[0];
        *strain = strain.next_up();
        assert_eq!(judged(&rounded), (Verdict::Rounding, String::new()));
        let mut wrong = right.clone();
        wrong.projectile_velocity.0 += 1.0;
        let (verdict, reason) = judged(&wrong);
        assert_eq!(verdict, Verdict::Wrong);
        assert!(reason.starts_with("projectile velocity: 4.01e2, not 4e2: "), "{reason}");
        wrong.secondary = None;
        let error = judge.step(&scene, &expected, &wrong).unwrap_err();
        assert_eq!(error, "there is no `secondary`");
    }

    #[test]
    fn a_run_is_held_against_its_end_and_then_against_every_number() {
        let scene = coarse_fig3();
        let right = right_result(&scene);
        let expected = expected::of_run(&scene, Precision::F64);
        let judged = |expected: &Expected, result: &ResultRecord| {
            let outcome = judging(false).run(&scene, expected, result).unwrap();
            (outcome.verdict, outcome.reason.unwrap_or_default(), outcome.judged.len())
        };
        let bits = |quantities| (Verdict::Bits, String::new(), quantities);
        // Those of the state, the way of the projectile and the energy.
        assert_eq!(judged(&expected, &right), bits(11));
        let ends = |kind: &str| {
            let mut other = right.clone();
            other.outcome.kind = kind.into();
            other
        };
        // A candidate need not draw a balance.
        assert_eq!(judged(&expected, &ends("energy_unbalanced")), bits(11));
        let reason = "it ends as `diverged`, not `completed`".to_owned();
        assert_eq!(judged(&expected, &ends("diverged")), (Verdict::Wrong, reason, 0));
        let mut spoilt = ends("no_waves");
        spoilt.projectile.position.0 += 1.0;
        spoilt.primary.strain.clear();
        let place = Place { step: 1, fibre: Fibre::Primary, index: 0 };
        let ended = Expected { outcome: End::NoWaves { place, strain: 0.3 }, ..expected.clone() };
        // Of a run that ends by itself nothing else is compared.
        assert_eq!(judged(&ended, &spoilt), bits(0));

        let mut farther = right.clone();
        farther.projectile.position.0 *= 1.5;
        let (verdict, reason, _) = judged(&expected, &farther);
        assert_eq!(verdict, Verdict::Wrong);
        assert!(reason.starts_with("projectile position: "), "{reason}");
        let mut later = right.clone();
        later.steps += 1;
        let (verdict, reason, quantities) = judged(&expected, &later);
        assert_eq!((verdict, quantities), (Verdict::Wrong, 11));
        assert!(reason.starts_with("steps: "), "{reason}");
        // What is asked for and not there is named.
        let missing = Quantity::Equation(4);
        let of = |e: &ExpectedQuantity| ExpectedQuantity { quantity: missing, ..e.clone() };
        let other = expected.quantities.iter().map(of).collect();
        let other = Expected { quantities: other, ..expected.clone() };
        let error = judging(false).run(&scene, &other, &right).unwrap_err();
        assert_eq!(error, "the answer has no eqn (4)");
    }
}
