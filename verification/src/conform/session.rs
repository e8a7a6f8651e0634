//! The conversation with a candidate: a question, an answer, a verdict.

use std::ffi::OsString;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};
use crossfibre::discretisation::Discretisation;
use crossfibre::scene::Scene;

use super::candidate::{Broken, Candidate, shortened};
use super::compare::{Judge, Outcome};
use super::protocol::{Answer, Ask, Depth, FORMAT, Hello, Precision, Question};
use super::record::Verdict;
use super::{by_name, expected};

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

/// A candidate in conversation.
pub struct Session {
    pub(super) candidate: Candidate,
    /// What it says of itself.
    pub hello: Hello,
    /// How it is judged.
    pub judge: Judge,
    next_id: u64,
    broken: usize,
    /// Time spent in the reference.
    pub reference: Duration,
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
            judge: Judge { precision, exact: options.exact },
            next_id: 1,
            broken: 0,
            reference: Duration::ZERO,
        })
    }

    /// Asks, and judges the answer.
    pub fn asked(&mut self, ask: &Ask) -> Outcome {
        if self.broken >= STARTS {
            return Outcome::broken(format!("not asked, since the program broke {STARTS} times"));
        }
        let answer = match self.answer(ask) {
            Ok(answer) => answer,
            Err(reason) => {
                self.broken += 1;
                return Outcome::broken(reason);
            }
        };
        if let Some(reason) = answer.skip {
            return Outcome::unjudged(Verdict::Skipped, shortened(&reason));
        }
        let start = Instant::now();
        let expected = match ask {
            Ask::Hello { .. } => return Outcome::broken("`hello` was asked before".into()),
            Ask::Equation { eq, edition, inputs } => {
                let number = eq.parse().unwrap_or(0);
                let inputs = by_name::inputs(inputs);
                Ok(expected::of_equation(*edition, number, &inputs, self.judge.precision))
            }
            Ask::Step { scene, state } => expected::of_step(scene, state, self.judge.precision),
            Ask::Run { scene } => Ok(expected::of_run(scene, self.judge.precision)),
        };
        self.reference += start.elapsed();
        let expected = match expected {
            Ok(expected) => expected,
            // The reference cannot answer either.
            Err(reason) => return Outcome::unjudged(Verdict::NotJudged, reason),
        };
        if let Some(error) = answer.error {
            return Outcome::broken(format!("it says: {}", shortened(&error)));
        }
        let missing = |what: &str| Err(format!("the answer has no `{what}`"));
        let outcome = match ask {
            Ask::Hello { .. } => missing("hello"),
            Ask::Equation { .. } => match &answer.out {
                Some(out) => self.judge.equation(&expected, out),
                None => missing("out"),
            },
            Ask::Step { scene, .. } => match &answer.state {
                Some(state) => self.judge.step(scene, &expected, state),
                None => missing("state"),
            },
            Ask::Run { scene } => match &answer.result {
                Some(result) => self.judge.run(scene, &expected, result),
                None => missing("result"),
            },
        };
        outcome.unwrap_or_else(Outcome::broken)
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
        let answer = match serde_json::from_str::<Answer>(&line) {
            Ok(answer) if answer.id == id => Ok(answer),
            Ok(Answer { id: other, .. }) => {
                Err(format!("it answers question {other} and was asked {id}"))
            }
            Err(error) => Err(format!("not an answer: {}: {error}", shortened(&line))),
        };
        if answer.is_err() {
            // What else it may have written belongs to no question.
            self.candidate.forget();
        }
        answer
    }

    /// Whether the candidate's run of a scene is wrong; none where it cannot be judged.
    pub fn is_wrong(&mut self, scene: &Scene) -> Option<bool> {
        match self.asked(&Ask::Run { scene: Box::new(scene.clone()) }).verdict {
            Verdict::Wrong => Some(true),
            Verdict::Bits | Verdict::Rounding => Some(false),
            Verdict::Broken | Verdict::Skipped | Verdict::NotJudged => None,
        }
    }

    /// The first step at which a run that is wrong at its end is wrong, by halving.
    pub fn departs(&mut self, scene: &Scene) -> Option<u64> {
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

#[cfg(all(test, unix))] // the programs are those of any Unix
mod tests {
    use crossfibre::scene::{Law, Primary};

    use super::*;
    use crate::cases::support::shipped;

    fn started(single: bool, script: &str) -> Result<Session> {
        let options = Options {
            depths: vec![],
            filter: None,
            seed: 1,
            exact: false,
            single,
            timeout: Duration::from_secs(600),
        };
        Session::start(&["sh", "-c", script].map(OsString::from), &options)
    }

    const HELLO: &str =
        r#"read q; echo '{"id":0,"format":"crossfibre-conformance/1","name":"a"}';"#;

    #[test]
    fn a_candidate_of_doubles_is_not_judged_as_one_of_single_numbers() {
        let error = started(true, HELLO).err().unwrap().to_string();
        assert!(error.starts_with("sh: computes in f64, and nothing would fail"), "{error}");
        assert!(started(false, HELLO).is_ok());
    }

    /// A wave speed of 1 m/s, elements of 2 m, and a law that outgrows the step in the first one: how
    /// long it is to run makes no difference, but to a candidate that says otherwise beyond 23 s.
    #[test]
    fn the_step_at_which_a_run_departs_is_found_by_halving() {
        let mut scene = Scene { duration: 40.0, ..shipped("single-400") };
        scene.primary = Primary {
            length: 12.0,
            elements: 6,
            density: 1.0,
            area: 1.0,
            material: Law::Polynomial { coefficients: vec![1.0, 1e6] }.into(),
        };
        scene.projectile.velocity = 1e-3;
        let script = r#"
            fibre='{"position":[],"velocity":[],"strain":[],"tension":[]}'
            rest="\"steps\":0,\"time_step\":0,\"primary\":$fibre"
            rest="$rest,\"projectile\":{\"velocity\":0,\"position\":0}"
            while read q
            do
                id=${q#*:}
                duration=${q#*duration\":}
                end=courant_exceeded
                if [ "${duration%%.*}" -gt 23 ]; then end=completed; fi
                echo "{\"id\":${id%%,*},\"result\":{\"outcome\":{\"kind\":\"$end\"},$rest}}"
            done"#;
        let mut session = started(false, &format!("{HELLO}{script}")).unwrap();
        assert_eq!(session.is_wrong(&scene), Some(true));
        assert_eq!(session.is_wrong(&up_to(&scene, 11, 2.0)), Some(false));
        // Twelve steps of 2 s are the first that take longer.
        assert_eq!(session.departs(&scene), Some(12));
        assert!(session.reference > Duration::ZERO);
    }
}
