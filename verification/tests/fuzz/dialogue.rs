//! The lines of a conformance dialogue: questions as a candidate reads them, and what a candidate may
//! answer, judged.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use crossfibre_verification::conform::compare::Judge;
use crossfibre_verification::conform::expected::{self, Expected};
use crossfibre_verification::conform::protocol::{
    Answer, Ask, Depth, Hello, Precision, Question, ResultRecord, Value,
};
use crossfibre_verification::conform::questions::{self, Item};
use crossfibre_verification::conform::record::Verdict;

use super::readers::json;

/// Some small questions of each depth, each with what is expected.
fn asked() -> &'static [(Item, Expected)] {
    static ASKED: OnceLock<Vec<(Item, Expected)>> = OnceLock::new();
    ASKED.get_or_init(|| {
        let all = questions::all(1);
        let short = |item: &&Item| serde_json::to_string(&item.ask).unwrap().len() < 4000;
        let of = |depth, skipped| {
            let matching = all.iter().filter(move |item| item.depth == depth);
            matching.filter(short).step_by(skipped).take(4).cloned()
        };
        let items = of(Depth::Equation, 29).chain(of(Depth::Step, 2)).chain(of(Depth::Run, 7));
        items.map(|item| (item.clone(), expected(&item.ask))).collect()
    })
}

fn expected(ask: &Ask) -> Expected {
    match ask {
        Ask::Hello { .. } => panic!("not a question of these"),
        Ask::Equation { eq, edition, inputs } => {
            let numbers: BTreeMap<_, _> =
                inputs.iter().map(|(name, v)| (name.clone(), v.numbers())).collect();
            expected::of_equation(*edition, eq.parse().unwrap(), &numbers, Precision::F64)
        }
        Ask::Step { scene, state } => expected::of_step(scene, state, Precision::F64).unwrap(),
        Ask::Run { scene } => expected::of_run(scene, Precision::F64),
    }
}

pub fn questions() -> Vec<Vec<u8>> {
    let question = |(id, (item, _)): (u64, &(Item, Expected))| {
        serde_json::to_vec(&Question { id, ask: item.ask.clone() }).unwrap()
    };
    (1..).zip(asked()).map(question).collect()
}

pub fn question(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let Question { ask, .. } = json(bytes)?;
    // What a reference answers to a state that does not fit its scene.
    if let Ask::Step { scene, state } = ask
        && scene.check().is_ok()
        && scene.primary.elements + scene.secondary.as_ref().map_or(0, |s| s.elements) < 300
    {
        state.state::<f64>(&scene)?;
    }
    Ok(())
}

pub fn hello(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let hello: Hello = json(bytes)?;
    for (item, _) in asked() {
        assert_ne!(questions::unsupported(item, &hello), Some(String::new()));
    }
    Ok(())
}

/// What the reference itself would answer.
pub fn answers() -> Vec<Vec<u8>> {
    let answer = |(id, (item, expected)): (u64, &(Item, Expected))| {
        let answer = Answer { id, ..Answer::default() };
        let answer = match &item.ask {
            Ask::Equation { .. } => {
                Answer { out: Some(Value::of(&expected.quantities[0].values)), ..answer }
            }
            Ask::Step { state, .. } => Answer { state: Some((**state).clone()), ..answer },
            _ => Answer { result: Some(result(&item.ask)), ..answer },
        };
        serde_json::to_vec(&answer).unwrap()
    };
    (1..).zip(asked()).map(answer).collect()
}

fn result(ask: &Ask) -> ResultRecord {
    let Ask::Run { scene } = ask else { panic!("not a run") };
    let result = crossfibre::result::run(scene, |_| {});
    serde_json::from_value(serde_json::to_value(&result).unwrap()).unwrap()
}

/// Judged as an answer to each of the questions that it could be one to.
pub fn answer(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let answer: Answer = json(bytes)?;
    for (item, expected) in asked() {
        let judge = Judge { precision: Precision::F64, exact: bytes.len().is_multiple_of(2) };
        let outcome = match (&item.ask, &answer) {
            (Ask::Equation { .. }, Answer { out: Some(out), .. }) => judge.equation(expected, out),
            (Ask::Step { scene, .. }, Answer { state: Some(state), .. }) => {
                judge.step(scene, expected, state)
            }
            (Ask::Run { scene }, Answer { result: Some(result), .. }) => {
                judge.run(scene, expected, result)
            }
            _ => continue,
        };
        match outcome {
            Ok(outcome) => {
                let agrees = matches!(outcome.verdict, Verdict::Bits | Verdict::Rounding);
                assert!(agrees || outcome.reason.is_some_and(|reason| !reason.is_empty()));
            }
            Err(reason) => assert!(!reason.is_empty()),
        }
    }
    Ok(())
}
