//! Whether the runner of conformance can tell rounding from faults: every equation in other words
//! stays within what it allows, and every fault of the catalogue does not.

use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::discretisation::Discretisation;
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::paper::Paper;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

use super::{Bound, Case, Check};
use crate::conform::by_name::{self, Inputs};
use crate::conform::expected::{self, Expected, kind};
use crate::conform::judge::{Judged, allowed, judge};
use crate::conform::protocol::{Ask, Edition, Form, Precision, StateRecord};
use crate::conform::quantity::{Quantity, numbers};
use crate::conform::questions::{self, Item};
use crate::faulty::Faulty;
use crate::faulty::catalogue::Wrong;
use crate::faulty::rewritten::{Rewritten, Style};
use crate::worse::worse;

pub const CASES: &[Case] = &[
    Case {
        id: "conformance.rewrites",
        title: "Equations in other words pass as rounding",
        equations: &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20],
        run: rewrites,
    },
    Case {
        id: "conformance.faults",
        title: "Every fault of the catalogue is beyond rounding",
        equations: &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20],
        run: faults,
    },
];

/// The seed of the questions: not that which `conform` has by default.
const SEED: u64 = 2;

fn rewrites() -> Vec<Check> {
    let mut worst = [0.0_f64; 3];
    for item in questions::all(SEED) {
        for style in Style::ALL {
            let judged = match &item.ask {
                Ask::Equation { eq, edition, inputs } if edition.corrections == Form::All => {
                    let inputs = by_name::inputs(inputs);
                    rewritten_equation(style, *edition, eq.parse().unwrap_or(0), &inputs)
                }
                Ask::Step { scene, state } if scene.corrections == Corrections::ALL => {
                    rewritten_step(style, scene, state)
                }
                Ask::Run { scene } if scene.corrections == Corrections::ALL => {
                    rewritten_run(style, scene)
                }
                _ => continue,
            };
            let most = judged.iter().map(|j| j.envelopes).fold(0.0, worse);
            let worst = &mut worst[item.depth as usize];
            *worst = worse(*worst, most);
        }
    }
    let check = |(depth, measured): (&str, f64), quantity| {
        Check {
        claim: format!("at the depth of {depth}, other words differ by less than is allowed"),
        oracle: "the reference in doubles; the envelope from the same with 106 bits".into(),
        norm: "greatest difference of any quantity over its rounding envelope".into(),
        measured,
        bound: Bound::AtMost(allowed(quantity)),
        reason: "the multiple of the envelope that `conform` allows: of an equation every operation is \
                 within a few halves of a unit of its inputs; over a run two sequences of roundings are \
                 as far apart as two draws of the same chance, and the envelope is one draw"
            .into(),
    }
    };
    let [equation, step, run] = worst;
    let position = Quantity::Position(crossfibre::place::Fibre::Primary);
    vec![
        check(("equations", equation), Quantity::Equation(4)),
        check(("steps", step), position),
        check(("runs", run), position),
    ]
}

fn rewritten_equation(
    style: Style,
    edition: Edition,
    number: u8,
    inputs: &Inputs<f64>,
) -> Vec<Judged> {
    let expected = expected::of_equation(edition, number, inputs, Precision::F64);
    let found = match edition.strain {
        Strain::Incremental => {
            by_name::evaluate(&Rewritten::<Incremental>::new(style), number, inputs)
        }
        Strain::Engineering => {
            by_name::evaluate(&Rewritten::<Engineering>::new(style), number, inputs)
        }
    };
    let found = found.unwrap_or_default();
    held_against(&expected, |_| Some(found.clone()))
}

fn rewritten_step(style: Style, scene: &Scene, before: &StateRecord) -> Vec<Judged> {
    let (Ok(expected), Ok(state)) =
        (expected::of_step(scene, before, Precision::F64), before.state(scene))
    else {
        return vec![];
    };
    marched(style, scene, state, 1, &expected)
}

fn rewritten_run(style: Style, scene: &Scene) -> Vec<Judged> {
    let expected = expected::of_run(scene, Precision::F64);
    if kind(&expected.outcome) != "completed" {
        return vec![];
    }
    let state = State::at_impact(scene, Wavefront::Flagged);
    let steps = Discretisation::<f64>::of(scene).steps(scene.duration);
    marched(style, scene, state, steps, &expected)
}

fn marched(
    style: Style,
    scene: &Scene,
    mut state: State<f64>,
    steps: u64,
    expected: &Expected,
) -> Vec<Judged> {
    let outcome = match scene.strain {
        Strain::Incremental => {
            march::run(&Rewritten::<Incremental>::new(style), &mut state, steps, |_| ())
        }
        Strain::Engineering => {
            march::run(&Rewritten::<Engineering>::new(style), &mut state, steps, |_| ())
        }
    };
    assert!(outcome.is_completed(), "{outcome}: {scene:?}");
    let numbers = numbers(&state);
    held_against(expected, |quantity| {
        numbers.iter().find(|(q, _)| *q == quantity).map(|(_, v)| v.clone())
    })
}

/// What can be judged of a question, quantity by quantity.
fn held_against(expected: &Expected, found: impl Fn(Quantity) -> Option<Vec<f64>>) -> Vec<Judged> {
    if expected.beyond.is_some() {
        return vec![];
    }
    let of = |e: &expected::ExpectedQuantity| judge(e, &found(e.quantity)?, Precision::F64).ok();
    expected.quantities.iter().filter_map(of).collect()
}

/// The greatest difference from each equation over its rounding envelope, by number, of a paper that is
/// asked all questions about equations.
fn envelopes(paper: &impl Paper<f64>, questions: &[Item]) -> [f64; 21] {
    let mut most = [0.0; 21];
    for item in questions {
        if let Ask::Equation { eq, edition, inputs } = &item.ask
            && edition.corrections == Form::All
            && edition.strain == Strain::Incremental
        {
            let (inputs, number) = (by_name::inputs(inputs), eq.parse().unwrap_or(0));
            let expected = expected::of_equation(*edition, number, &inputs, Precision::F64);
            let found = by_name::evaluate(paper, number, &inputs).unwrap_or_default();
            let judged = held_against(&expected, |_| Some(found.clone()));
            let most = &mut most[usize::from(number)];
            *most = judged.iter().map(|judged| judged.envelopes).fold(*most, worse);
        }
    }
    most
}

/// Of an equation in other words, or with a fault of the catalogue: its number, and the greatest
/// difference over the envelope.
pub fn over_envelopes() -> [Vec<(u8, f64)>; 2] {
    let questions = questions::all(SEED);
    let in_other_words = Style::ALL.into_iter().flat_map(|style| {
        let most = envelopes(&Rewritten::<Incremental>::new(style), &questions);
        (1..=20).map(move |number| (number, most[usize::from(number)]))
    });
    let paper = Corrected::<Incremental>::new(Corrections::ALL);
    let with_a_fault = Wrong::ALL.iter().map(|&wrong| {
        let number = wrong.fault().equation;
        (number, envelopes(&Faulty::new(&paper, wrong), &questions)[usize::from(number)])
    });
    [in_other_words.collect(), with_a_fault.collect()]
}

fn faults() -> Vec<Check> {
    let paper = Corrected::<Incremental>::new(Corrections::ALL);
    let questions = questions::all(SEED);
    let (mut missed, mut blamed) = (0, 0);
    for &wrong in Wrong::ALL {
        let most = envelopes(&Faulty::new(&paper, wrong), &questions);
        let guilty = usize::from(wrong.fault().equation);
        let is_rounding = |number: usize| most[number] <= allowed(Quantity::Equation(number as u8));
        missed += usize::from(is_rounding(guilty));
        blamed += (0..most.len()).filter(|&n| n != guilty && !is_rounding(n)).count();
    }
    let count = Wrong::ALL.len();
    let check = |claim: String, measured: usize| Check {
        claim,
        oracle: "the reference's own equation and its rounding envelope".into(),
        norm: "number of faults".into(),
        measured: measured as f64,
        bound: Bound::Exactly(0.0),
        reason: "a fault that is not caught is one that the runner lets through".into(),
    };
    vec![
        check(format!("of {count} faults, none is within the envelope of its equation"), missed),
        check("no other equation is blamed for one".into(), blamed),
    ]
}
