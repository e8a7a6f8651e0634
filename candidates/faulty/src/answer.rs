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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may

    use crossfibre_verification::cases::support::shipped;

    use super::*;

    fn asked(question: serde_json::Value, change: Change, number: Precision) -> serde_json::Value {
        serde_json::from_str(&answer(&question.to_string(), change, number)).unwrap()
    }

    #[test]
    fn every_name_leads_back_to_what_it_names() {
        let wrong = Wrong::ALL.iter().copied().map(Change::Wrong);
        let rewritten = Style::ALL.iter().copied().map(Change::Rewritten);
        for change in wrong.chain(rewritten).chain([Change::Nothing]) {
            assert_eq!(Change::from_name(change.name()), Some(change));
        }
        assert_eq!(Change::from_name("slow"), None);
    }

    #[test]
    fn hello_says_what_is_wrong_and_what_can_be_asked() {
        let hello = json!({"id": 3, "ask": "hello", "format": "crossfibre-conformance/1"});
        let wrong = Change::Wrong(Wrong::StrainDenominator);
        let said = asked(hello.clone(), wrong, Precision::F32);
        assert_eq!(said["id"], 3);
        assert_eq!(said["format"], "crossfibre-conformance/1");
        assert_eq!(said["name"], format!("faulty, {}", wrong.name()));
        assert_eq!(said["number"], "f32");
        assert_eq!(said["laws"].as_array().unwrap().len(), 7);
        assert_eq!(said["corrections"], json!(["all", "none"]));
        let said = asked(hello, Change::Rewritten(Style::ALL[0]), Precision::F64);
        assert_eq!((&said["number"], &said["corrections"]), (&json!("f64"), &json!(["all"])));
    }

    /// (7): 0.1 of 3 N, in doubles and in 24 bits; (4) by either measure, with its own denominator.
    #[test]
    fn an_equation_is_worked_out_in_the_numbers_and_the_edition_that_are_asked_for() {
        let of = |eq: &str, strain: &str, inputs, number| {
            let edition = json!({"strain": strain, "corrections": "all"});
            let question =
                json!({"id": 5, "ask": "equation", "eq": eq, "edition": edition, "in": inputs});
            asked(question, Change::Nothing, number)
        };
        let seven = json!({"E": 3.0, "strain": 0.1});
        let out = of("7", "incremental", seven.clone(), Precision::F64);
        assert_eq!(out, json!({"id": 5, "out": 3.0 * 0.1}));
        let out = of("7", "incremental", seven, Precision::F32);
        assert_eq!(out["out"], f64::from(3.0_f32 * 0.1));
        let four = json!({"strain_before": 0.5, "L": 3.0, "L_before": 2.0, "L_0": 1.0});
        assert_eq!(of("4", "incremental", four.clone(), Precision::F64)["out"], 0.5 + 1.5 - 1.0);
        assert_eq!(of("4", "engineering", four, Precision::F64)["out"], 2.0);
        let unknown = of("x", "incremental", json!({}), Precision::F64);
        assert_eq!(unknown, json!({"id": 5, "error": "no equation x"}));
        let lacking = of("7", "incremental", json!({"E": 3.0}), Precision::F64);
        assert!(lacking["error"].as_str().unwrap().contains("strain"), "{lacking}");
    }

    #[test]
    fn what_cannot_be_read_has_an_error_for_an_answer() {
        let said = asked(json!({"id": 5, "ask": "why"}), Change::Nothing, Precision::F64);
        assert_eq!(said["id"], 0);
        assert!(said["error"].is_string(), "{said}");
    }

    /// At 100 times its Courant limit a run ends by itself, and is left at its last whole step.
    #[test]
    fn a_run_ends_at_its_steps_or_where_it_diverges() {
        let mut scene = shipped("single-400");
        let steps = Discretisation::<f64>::of(&scene).steps(scene.duration);
        let run = |scene: &Scene| {
            let question = json!({"id": 5, "ask": "run", "scene": scene});
            asked(question, Change::Nothing, Precision::F64)["result"].clone()
        };
        let result = run(&scene);
        assert_eq!(
            (&result["outcome"]["kind"], &result["steps"]),
            (&json!("completed"), &json!(steps))
        );
        (scene.courant, scene.duration) = (100.0, 1.0);
        let result = run(&scene);
        assert_eq!(result["outcome"]["kind"], "diverged");
        let at = result["outcome"]["step"].as_u64().unwrap();
        assert_eq!(result["steps"], at - 1);
    }
}
