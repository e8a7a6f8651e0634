//! Answers to the questions of the conformance protocol, by any edition of the paper.

use std::collections::BTreeMap;

use crossfibre::corrected::{Corrected, Engineering, Incremental, StrainMeasure};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::Number;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};
use crossfibre_verification::conform::by_name;
use crossfibre_verification::conform::protocol::{
    Answer, Ask, Edition, Form, Precision, Question, StateRecord, Value,
};
use crossfibre_verification::faulty::Faulty;
use crossfibre_verification::faulty::catalogue::Wrong;
use crossfibre_verification::faulty::rewritten::{Rewritten, Style};
use serde_json::json;

/// What is other than in the reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Nothing.
    Nothing,
    /// One equation is wrong.
    Wrong(Wrong),
    /// Every equation is right, in other words.
    Rewritten(Style),
}

impl Change {
    /// By its name: `none`, a fault, or a style.
    pub fn from_name(name: &str) -> Option<Self> {
        let style = || Style::ALL.into_iter().find(|style| style.name() == name);
        match name {
            "none" => Some(Self::Nothing),
            _ => Wrong::from_id(name).map(Self::Wrong).or_else(|| style().map(Self::Rewritten)),
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "none",
            Self::Wrong(wrong) => wrong.fault().id,
            Self::Rewritten(style) => style.name(),
        }
    }
}

/// Something to be done with an edition.
pub trait With<S: Number> {
    /// What comes of it.
    type Out;
    /// Does it.
    fn with(self, paper: &impl Paper<S>) -> Self::Out;
}

/// Chooses the edition: the scene's, with the change.
pub fn with_edition<S: Number, W: With<S>>(
    change: Change,
    strain: Strain,
    corrections: Corrections,
    work: W,
) -> W::Out {
    match strain {
        Strain::Incremental => changed::<S, Incremental, W>(change, corrections, work),
        Strain::Engineering => changed::<S, Engineering, W>(change, corrections, work),
    }
}

fn changed<S: Number, M: StrainMeasure, W: With<S>>(
    change: Change,
    corrections: Corrections,
    work: W,
) -> W::Out {
    let paper = Corrected::<M>::new(corrections);
    match change {
        Change::Nothing => work.with(&paper),
        Change::Wrong(wrong) => work.with(&Faulty::new(&paper, wrong)),
        Change::Rewritten(style) => work.with(&Rewritten::<M>::new(style)),
    }
}

/// The answer to a question, a line of JSON, computed in `f64` or `f32`.
pub fn answer(line: &str, change: Change, number: Precision) -> String {
    match number {
        Precision::F64 => answer_in::<f64>(line, change, number),
        Precision::F32 => answer_in::<f32>(line, change, number),
    }
}

fn answer_in<S: Number>(line: &str, change: Change, number: Precision) -> String {
    let question: Question = match serde_json::from_str(line) {
        Ok(question) => question,
        Err(error) => return json!({"id": 0, "error": error.to_string()}).to_string(),
    };
    let id = question.id;
    let answer = match question.ask {
        Ask::Hello { format } => return hello(id, &format, change, number),
        Ask::Equation { eq, edition, inputs } => equation::<S>(change, &eq, edition, &inputs),
        Ask::Step { scene, state } => with_edition::<S, _>(
            change,
            scene.strain,
            scene.corrections,
            Step { scene: &scene, before: &state },
        ),
        Ask::Run { scene } => {
            let run = Run { id, scene: &scene };
            return with_edition::<S, _>(change, scene.strain, scene.corrections, run);
        }
    };
    let answer = answer.unwrap_or_else(|error| Answer { error: Some(error), ..Answer::default() });
    json!(Answer { id, ..answer }).to_string()
}

fn hello(id: u64, format: &str, change: Change, number: Precision) -> String {
    // Rewritten are the corrected equations only.
    let corrections = match change {
        Change::Rewritten(_) => json!(["all"]),
        _ => json!(["all", "none"]),
    };
    json!({
        "id": id,
        "format": format,
        "name": format!("faulty, {}", change.name()),
        "version": env!("CARGO_PKG_VERSION"),
        "number": number,
        "laws": ["linear", "polynomial", "exponential", "viscoelastic", "eyring", "tension_only",
                 "artificial_viscosity"],
        "corrections": corrections,
    })
    .to_string()
}

fn equation<S: Number>(
    change: Change,
    eq: &str,
    edition: Edition,
    inputs: &BTreeMap<String, Value>,
) -> Result<Answer, String> {
    struct Evaluate<S>(u8, by_name::Inputs<S>);
    impl<S: Number> With<S> for Evaluate<S> {
        type Out = Result<Vec<S>, String>;
        fn with(self, paper: &impl Paper<S>) -> Self::Out {
            by_name::evaluate(paper, self.0, &self.1)
        }
    }
    let number = eq.parse().map_err(|_| format!("no equation {eq}"))?;
    let numbers = |v: &Value| v.numbers().into_iter().map(S::from_f64).collect();
    let inputs = inputs.iter().map(|(name, v)| (name.clone(), numbers(v))).collect();
    let corrections = match edition.corrections {
        Form::All => Corrections::ALL,
        Form::None => Corrections::NONE,
    };
    let out = with_edition(change, edition.strain, corrections, Evaluate(number, inputs))?;
    let out: Vec<_> = out.into_iter().map(Number::to_f64).collect();
    Ok(Answer { out: Some(Value::of(&out)), ..Answer::default() })
}

struct Step<'a> {
    scene: &'a Scene,
    before: &'a StateRecord,
}

impl<S: Number> With<S> for Step<'_> {
    type Out = Result<Answer, String>;
    fn with(self, paper: &impl Paper<S>) -> Self::Out {
        let mut state: State<S> = self.before.state(self.scene)?;
        march::step(paper, &mut state).map_err(|outcome| outcome.to_string())?;
        Ok(Answer { state: Some(StateRecord::of(&state)), ..Answer::default() })
    }
}

struct Run<'a> {
    id: u64,
    scene: &'a Scene,
}

impl<S: Number> With<S> for Run<'_> {
    type Out = String;
    fn with(self, paper: &impl Paper<S>) -> String {
        let mut state = State::<S>::at_impact(self.scene, Wavefront::Flagged);
        let steps = Discretisation::<f64>::of(self.scene).steps(self.scene.duration);
        let mut outcome = Outcome::Completed;
        while state.step < steps && outcome.is_completed() {
            let before = state.clone();
            if let Err(early) = march::step(paper, &mut state) {
                outcome = early;
                state = before;
            }
        }
        let result = RunResult::of(self.scene, &state, paper, outcome);
        json!({"id": self.id, "result": result}).to_string()
    }
}
