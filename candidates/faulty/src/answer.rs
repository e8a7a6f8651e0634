//! Answers to the questions of the conformance protocol, by any edition of the paper.

use std::collections::BTreeMap;

use crossfibre::corrected::{Corrected, Engineering, Incremental, StrainMeasure};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::result::RunResult;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};
use crossfibre_verification::conform::by_name;
use crossfibre_verification::conform::protocol::{
    Answer, Ask, Edition, Form, Question, StateRecord, Value,
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
pub trait With {
    /// What comes of it.
    type Out;
    /// Does it.
    fn with(self, paper: &impl Paper<f64>) -> Self::Out;
}

/// Chooses the edition: the scene's, with the change.
pub fn with_edition<W: With>(
    change: Change,
    strain: Strain,
    corrections: Corrections,
    work: W,
) -> W::Out {
    match strain {
        Strain::Incremental => changed::<Incremental, W>(change, corrections, work),
        Strain::Engineering => changed::<Engineering, W>(change, corrections, work),
    }
}

fn changed<M: StrainMeasure, W: With>(change: Change, corrections: Corrections, work: W) -> W::Out {
    let paper = Corrected::<M>::new(corrections);
    match change {
        Change::Nothing => work.with(&paper),
        Change::Wrong(wrong) => work.with(&Faulty::new(&paper, wrong)),
        Change::Rewritten(style) => work.with(&Rewritten::<M>::new(style)),
    }
}

/// The answer to a question, a line of JSON.
pub fn answer(line: &str, change: Change) -> String {
    let question: Question = match serde_json::from_str(line) {
        Ok(question) => question,
        Err(error) => return json!({"id": 0, "error": error.to_string()}).to_string(),
    };
    let id = question.id;
    let answer = match question.ask {
        Ask::Hello { format } => return hello(id, &format, change),
        Ask::Equation { eq, edition, inputs } => equation(change, &eq, edition, &inputs),
        Ask::Step { scene, state } => with_edition(
            change,
            scene.strain,
            scene.corrections,
            Step { scene: &scene, before: &state },
        ),
        Ask::Run { scene } => {
            return with_edition(change, scene.strain, scene.corrections, Run { id, scene: &scene });
        }
    };
    let answer = answer.unwrap_or_else(|error| Answer { error: Some(error), ..Answer::default() });
    json!(Answer { id, ..answer }).to_string()
}

fn hello(id: u64, format: &str, change: Change) -> String {
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
        "laws": ["linear", "polynomial", "exponential", "viscoelastic", "eyring", "tension_only",
                 "artificial_viscosity"],
        "corrections": corrections,
    })
    .to_string()
}

fn equation(
    change: Change,
    eq: &str,
    edition: Edition,
    inputs: &BTreeMap<String, Value>,
) -> Result<Answer, String> {
    struct Evaluate(u8, by_name::Inputs<f64>);
    impl With for Evaluate {
        type Out = Result<Vec<f64>, String>;
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            by_name::evaluate(paper, self.0, &self.1)
        }
    }
    let number = eq.parse().map_err(|_| format!("no equation {eq}"))?;
    let inputs = inputs.iter().map(|(name, v)| (name.clone(), v.numbers())).collect();
    let corrections = match edition.corrections {
        Form::All => Corrections::ALL,
        Form::None => Corrections::NONE,
    };
    let out = with_edition(change, edition.strain, corrections, Evaluate(number, inputs))?;
    Ok(Answer { out: Some(Value::of(&out)), ..Answer::default() })
}

struct Step<'a> {
    scene: &'a Scene,
    before: &'a StateRecord,
}

impl With for Step<'_> {
    type Out = Result<Answer, String>;
    fn with(self, paper: &impl Paper<f64>) -> Self::Out {
        let mut state: State<f64> = self.before.state(self.scene)?;
        march::step(paper, &mut state).map_err(|outcome| outcome.to_string())?;
        Ok(Answer { state: Some(StateRecord::of(&state)), ..Answer::default() })
    }
}

struct Run<'a> {
    id: u64,
    scene: &'a Scene,
}

impl With for Run<'_> {
    type Out = String;
    fn with(self, paper: &impl Paper<f64>) -> String {
        let mut state = State::at_impact(self.scene, Wavefront::Flagged);
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
