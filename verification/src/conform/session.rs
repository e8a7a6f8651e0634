//! A candidate asked and judged, question by question.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use crossfibre::discretisation::Discretisation;
use crossfibre::scene::Scene;
use crossfibre::state::State;

use super::candidate::{Broken, Candidate, shortened};
use super::expected::{self, Expected, ExpectedQuantity, kind};
use super::judge::{Judged, judge};
use super::protocol::{
    Answer, Ask, CrossoverRecord, Depth, FORMAT, Hello, Precision, Question, ResultRecord,
    StateRecord, Value,
};
use super::quantity::Quantity;
use super::questions::{self, Item};
use super::record::{self, ItemRecord, Report, Rows, Seconds, Verdict};

/// How a candidate is to be judged.
#[derive(Clone, Debug)]
pub struct Options {
    /// Depths; all if none are given.
    pub depths: Vec<Depth>,
    /// Only questions whose name has this in it.
    pub filter: Option<String>,
    /// Of the fresh questions.
    pub seed: u64,
    /// Whether equal bits are demanded.
    pub exact: bool,
    /// Whether the candidate computes in `f32`.
    pub single: bool,
    /// The longest wait for an answer.
    pub timeout: Duration,
}

/// So often a candidate is started again after it broke.
const STARTS: usize = 5;

/// What became of one question.
struct Outcome {
    verdict: Verdict,
    reason: Option<String>,
    judged: Vec<Judged>,
}

/// A candidate in conversation.
pub struct Session {
    candidate: Candidate,
    /// What it says of itself.
    pub hello: Hello,
    precision: Precision,
    exact: bool,
    next_id: u64,
    broken: usize,
    reference: Duration,
}

impl Session {
    /// Starts a candidate and asks what it supports.
    ///
    /// # Errors
    /// If it cannot be started, or says nothing that can be understood: then nothing can be judged.
    pub fn start(command: &[OsString], options: &Options) -> Result<Self> {
        let mut candidate = Candidate::new(command.to_vec(), options.timeout);
        let program = command.first().map(|p| p.to_string_lossy().into_owned()).unwrap_or_default();
        let answer = match candidate.ask(text(&first_question())?) {
            Ok(line) => line,
            Err(broken) => bail!("{program}: to `hello`: {}", with_last_words(&broken, &candidate)),
        };
        let hello: Hello = serde_json::from_str(&answer).map_err(|error| {
            anyhow::anyhow!(
                "{program}: to `hello` it answered {}: {error}\n  help: docs/conformance.md has the \
                 fields",
                shortened(&answer)
            )
        })?;
        if hello.format != FORMAT {
            bail!("{program}: speaks {}, and this version {FORMAT}", shortened(&hello.format));
        }
        let precision = if options.single { Precision::F32 } else { Precision::F64 };
        match (hello.number, precision) {
            (Precision::F32, Precision::F64) => bail!(
                "{program}: computes in f32, and would fail by the rounding of f64\n  help: judge \
                 it with --single"
            ),
            (Precision::F64, Precision::F32) => bail!(
                "{program}: computes in f64, and nothing would fail by the rounding of f32\n  help: \
                 leave --single out"
            ),
            _ => {}
        }
        Ok(Self {
            candidate,
            hello,
            precision,
            exact: options.exact,
            next_id: 1,
            broken: 0,
            reference: Duration::ZERO,
        })
    }

    /// Asks, and judges the answer.
    fn judge(&mut self, ask: &Ask) -> Outcome {
        if self.broken >= STARTS {
            return broken(format!("not asked, since the program broke {STARTS} times"));
        }
        let answer = match self.answer(ask) {
            Ok(answer) => answer,
            Err(reason) => {
                self.broken += 1;
                return broken(reason);
            }
        };
        if let Some(reason) = answer.skip {
            return Outcome {
                verdict: Verdict::Skipped,
                reason: Some(shortened(&reason)),
                judged: vec![],
            };
        }
        let start = Instant::now();
        let expected = match ask {
            Ask::Hello { .. } => return broken("`hello` was asked before".into()),
            Ask::Equation { eq, edition, inputs } => {
                let numbers: BTreeMap<_, _> =
                    inputs.iter().map(|(name, v)| (name.clone(), v.numbers())).collect();
                let number = eq.parse().unwrap_or(0);
                Ok(expected::of_equation(*edition, number, &numbers, self.precision))
            }
            Ask::Step { scene, state } => expected::of_step(scene, state, self.precision),
            Ask::Run { scene } => Ok(expected::of_run(scene, self.precision)),
        };
        self.reference += start.elapsed();
        let expected = match expected {
            Ok(expected) => expected,
            // The reference cannot answer either.
            Err(reason) => {
                let (verdict, judged) = (Verdict::NotJudged, vec![]);
                return Outcome { verdict, reason: Some(reason), judged };
            }
        };
        if let Some(error) = answer.error {
            return broken(format!("it says: {}", shortened(&error)));
        }
        let missing = |what: &str| Err(format!("the answer has no `{what}`"));
        let outcome = match ask {
            Ask::Hello { .. } => missing("hello"),
            Ask::Equation { .. } => match &answer.out {
                Some(out) => self.compare_equation(&expected, out),
                None => missing("out"),
            },
            Ask::Step { scene, .. } => match &answer.state {
                Some(state) => self.compare_state(scene, &expected, state),
                None => missing("state"),
            },
            Ask::Run { scene } => match &answer.result {
                Some(result) => self.compare_result(scene, &expected, result),
                None => missing("result"),
            },
        };
        outcome.unwrap_or_else(broken)
    }

    /// One question, one answer with its id.
    fn answer(&mut self, ask: &Ask) -> Result<Answer, String> {
        if !self.candidate.is_running() {
            // It broke, and is started again: its first question is always the same.
            let hello = text(&first_question()).map_err(|error| error.to_string())?;
            self.candidate.ask(hello).map_err(|broken| format!("started again: {broken}"))?;
        }
        let id = self.next_id;
        self.next_id += 1;
        let question = Question { id, ask: ask.clone() };
        let line = text(&question).map_err(|error| error.to_string())?;
        let line = self.candidate.ask(line).map_err(|broken| {
            let reason = with_last_words(&broken, &self.candidate);
            self.candidate.forget();
            reason
        })?;
        let answer = serde_json::from_str::<Answer>(&line)
            .map_err(|error| format!("not an answer: {}: {error}", shortened(&line)))
            .and_then(|answer| {
                let expected = answer.id == id;
                let other = || format!("it answers question {} and was asked {id}", answer.id);
                expected.then_some(()).ok_or_else(other).map(|()| answer.clone())
            });
        if answer.is_err() {
            // What else it may have written belongs to no question.
            self.candidate.forget();
        }
        answer
    }

    fn compare_equation(&self, expected: &Expected, out: &Value) -> Result<Outcome, String> {
        let judged = vec![judge(&expected.quantities[0], &out.numbers(), self.precision)?];
        Ok(self.verdict(expected, &[], judged))
    }

    fn compare_state(
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

    fn compare_result(
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
        // Wrong quantities, the worst last: their order is that of the step.
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

    /// Whether the candidate's run of a scene is wrong; none where it cannot be judged.
    pub fn is_wrong(&mut self, scene: &Scene) -> Option<bool> {
        match self.judge(&Ask::Run { scene: Box::new(scene.clone()) }).verdict {
            Verdict::Wrong => Some(true),
            Verdict::Bits | Verdict::Rounding => Some(false),
            Verdict::Broken | Verdict::Skipped | Verdict::NotJudged => None,
        }
    }

    /// The first step at which a run that is wrong at its end is wrong, by halving.
    fn departs(&mut self, scene: &Scene) -> Option<u64> {
        let mesh = Discretisation::<f64>::of(scene);
        let mut wrong = mesh.steps(scene.duration);
        let mut right = 0;
        while wrong - right > 1 {
            let middle = right + (wrong - right) / 2;
            let shorter = up_to(scene, middle, mesh.time_step);
            match self.is_wrong(&shorter)? {
                true => wrong = middle,
                false => right = middle,
            }
        }
        Some(wrong)
    }
}

/// The same scene with so many steps.
pub fn up_to(scene: &Scene, steps: u64, time_step: f64) -> Scene {
    Scene { duration: steps as f64 * time_step, ..scene.clone() }
}

fn broken(reason: String) -> Outcome {
    Outcome { verdict: Verdict::Broken, reason: Some(reason), judged: vec![] }
}

fn first_question() -> Question {
    Question { id: 0, ask: Ask::Hello { format: FORMAT.into() } }
}

fn text(question: &Question) -> Result<String> {
    Ok(serde_json::to_string(question)?)
}

fn with_last_words(broken: &Broken, candidate: &Candidate) -> String {
    let words = candidate.last_words();
    match words.lines().last() {
        Some(last) => format!("{broken}; its last words: {}", shortened(last)),
        None => broken.to_string(),
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

/// So many wrong runs are searched for the step at which they depart.
const SEARCHED: usize = 3;

/// Asks a candidate everything that it supports. `progress` is told of each question.
///
/// # Errors
/// If it cannot be started, or says nothing that can be understood.
pub fn conform(
    command: &[OsString],
    options: &Options,
    mut progress: impl FnMut(usize, usize),
) -> Result<(Report, Session)> {
    let start = Instant::now();
    let mut session = Session::start(command, options)?;
    let chosen = |item: &Item| {
        (options.depths.is_empty() || options.depths.contains(&item.depth))
            && options.filter.as_ref().is_none_or(|text| item.id.contains(text.as_str()))
    };
    let items: Vec<_> = questions::all(options.seed).into_iter().filter(chosen).collect();
    if items.is_empty() {
        bail!(
            "no question has {:?} in its name\n  help: names are such as `equation/4/corrected/awkward-1`, \
             `step/single-fibre`, `run/fig3`",
            options.filter.as_deref().unwrap_or_default()
        );
    }
    let mut rows = Rows::default();
    let mut records = Vec::new();
    let mut searched = 0;
    for (done, item) in items.iter().enumerate() {
        progress(done, items.len());
        let Outcome { verdict, reason, judged } = match questions::unsupported(item, &session.hello)
        {
            Some(reason) => {
                let (verdict, judged) = (Verdict::Skipped, vec![]);
                Outcome { verdict, reason: Some(reason), judged }
            }
            None => session.judge(&item.ask),
        };
        for judged in judged {
            rows.add(item.depth, &item.id, judged);
        }
        let departs_at_step = match &item.ask {
            Ask::Run { scene } if verdict == Verdict::Wrong && searched < SEARCHED => {
                searched += 1;
                session.departs(scene)
            }
            _ => None,
        };
        let (id, depth) = (item.id.clone(), item.depth);
        records.push(ItemRecord { id, depth, verdict, reason, departs_at_step });
    }
    progress(items.len(), items.len());
    let [candidate, reference] =
        [session.candidate.waited, session.reference].map(|time| time.as_secs_f64());
    let rest = start.elapsed().as_secs_f64() - candidate - reference;
    let judged = |record: &ItemRecord| {
        matches!(record.verdict, Verdict::Bits | Verdict::Rounding | Verdict::Wrong)
    };
    let report = Report {
        format: record::FORMAT.into(),
        crossfibre: env!("CARGO_PKG_VERSION").into(),
        command: command.iter().map(|word| word.to_string_lossy().into_owned()).collect(),
        candidate: session.hello.clone(),
        seed: options.seed,
        number: session.precision,
        exact: options.exact,
        // Who was asked nothing has shown nothing.
        conforms: records.iter().any(judged) && !records.iter().any(|r| r.verdict.is_failure()),
        quantities: rows.finish(),
        items: records,
        seconds: Seconds { candidate, reference, rest },
    };
    Ok((report, session))
}
