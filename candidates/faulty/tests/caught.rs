//! The conformance runner catches every fault of the catalogue and passes every rewrite.

#![allow(clippy::unwrap_used)] // a test may

use std::ffi::OsString;
use std::time::Duration;

use crossfibre::discretisation::Discretisation;
use crossfibre_faulty::answer::Change;
use crossfibre_verification::cases::support::shipped;
use crossfibre_verification::conform::interview::conform;
use crossfibre_verification::conform::protocol::Depth;
use crossfibre_verification::conform::record::{Report, Verdict};
use crossfibre_verification::conform::session::Options;
use crossfibre_verification::conform::shrink::shrink;
use crossfibre_verification::faulty::catalogue::Wrong;
use crossfibre_verification::faulty::rewritten::Style;

/// Any wait is long enough here.
const PATIENCE: Duration = Duration::from_secs(600);

fn options(depths: &[Depth]) -> Options {
    Options {
        depths: depths.into(),
        filter: None,
        seed: 3,
        exact: false,
        single: false,
        timeout: PATIENCE,
    }
}

fn command(change: Change, more: &[&str]) -> Vec<OsString> {
    let mut command: Vec<OsString> = vec![env!("CARGO_BIN_EXE_crossfibre-faulty").into()];
    command.extend(["--fault", change.name()].map(OsString::from));
    command.extend(more.iter().map(OsString::from));
    command
}

fn judged(change: Change, options: &Options) -> Report {
    conform(&command(change, &[]), options, |_, _| ()).unwrap().0
}

/// Quantities that are beyond what is allowed.
fn wrong(report: &Report) -> Vec<&str> {
    let wrong = report.quantities.iter().filter(|row| row.is_wrong(report.exact));
    wrong.map(|row| row.quantity.as_str()).collect()
}

#[test]
fn every_fault_is_caught_in_its_equation_and_in_no_other() {
    for &fault in Wrong::ALL {
        let report = judged(Change::Wrong(fault), &options(&[Depth::Equation]));
        let id = fault.fault().id;
        assert!(!report.conforms, "{id}");
        assert_eq!(wrong(&report), [format!("eqn ({})", fault.fault().equation)], "{id}");
    }
}

/// (1), (3), (19) and (20) are not evaluated in a step, and an element is never folded in ordinary
/// scenes.
#[test]
fn every_fault_in_what_a_step_evaluates_is_caught_in_a_step_too() {
    for &fault in Wrong::ALL {
        let is_in_no_step =
            matches!(fault.fault().equation, 1 | 3 | 19 | 20) || fault == Wrong::AngleQuadrant;
        let report = judged(Change::Wrong(fault), &options(&[Depth::Step]));
        assert_eq!(report.conforms, is_in_no_step, "{}", fault.fault().id);
    }
}

#[test]
fn rewrites_pass_as_rounding_and_not_as_equal_bits() {
    for style in Style::ALL {
        let report = judged(Change::Rewritten(style), &options(&[]));
        assert!(report.conforms, "{}: {:?}", style.name(), wrong(&report));
        assert!(report.count(Verdict::Rounding) > 100);
        let exact = judged(Change::Rewritten(style), &Options { exact: true, ..options(&[]) });
        assert!(!exact.conforms);
    }
}

#[test]
fn the_reference_itself_is_equal_to_the_bit_in_both_precisions() {
    let report = judged(Change::Nothing, &Options { exact: true, ..options(&[]) });
    assert!(report.conforms);
    assert_eq!(report.count(Verdict::Bits), report.items.len());
    let single = Options { single: true, ..options(&[]) };
    let report = conform(&command(Change::Nothing, &["--single"]), &single, |_, _| ()).unwrap().0;
    assert!(report.conforms);
    // What ends otherwise in 24 bits than in 106 is not judged.
    assert_eq!(report.count(Verdict::Bits) + report.count(Verdict::NotJudged), report.items.len());
    assert!(report.count(Verdict::NotJudged) < 10);
}

#[test]
fn a_single_precision_candidate_is_judged_by_the_rounding_of_single_precision() {
    let single = Options { single: true, ..options(&[Depth::Equation, Depth::Step]) };
    let judged =
        |change| conform(&command(change, &["--single"]), &single, |_, _| ()).unwrap().0.conforms;
    for style in Style::ALL {
        assert!(judged(Change::Rewritten(style)), "{}", style.name());
    }
    for fault in [Wrong::StrainDenominator, Wrong::NormalTensionPrinted, Wrong::ProjectileAlone] {
        assert!(!judged(Change::Wrong(fault)), "{}", fault.fault().id);
    }
}

/// A fault in (17) shows when the crossing fibre pulls: the runner says from which step the run is
/// wrong, and a smaller scene still shows it.
#[test]
fn a_wrong_run_is_dated_and_made_smaller() {
    let fault = Change::Wrong(Wrong::PushUOneArm);
    let options = Options { filter: Some("run/unequal".into()), ..options(&[]) };
    let (report, mut session) = conform(&command(fault, &[]), &options, |_, _| ()).unwrap();
    let departs = report.items[0].departs_at_step.unwrap();
    let scene = shipped("unequal");
    let mesh = Discretisation::<f64>::of(&scene);
    let crossing = mesh.secondary.unwrap();
    // A wave enters one element a step, however small; the wave itself is slower. The crossing fibre is
    // stretched in the step after it has come, and pulls in the one after that.
    let soonest = crossing.node as u64 + 2;
    let arrival = crossing.at / mesh.primary.wave_speed / mesh.time_step;
    assert!(soonest <= departs && departs as f64 <= arrival + 3.0, "{soonest} {departs} {arrival}");
    let small = shrink(&scene, 200, |scene| session.is_wrong(scene) == Some(true));
    assert_eq!(session.is_wrong(&small), Some(true));
    let elements = small.primary.elements + small.secondary.unwrap().elements;
    assert!(elements * 2 < scene.primary.elements, "{elements}");
}

/// Whatever a candidate answers, it gets a verdict: a few pieces of its answers are lost, doubled, or
/// exchanged for something strange. After five answers that cannot be read no more are asked for, so
/// there are many seeds.
#[test]
fn scrambled_answers_get_a_verdict() {
    let mut verdicts = std::collections::BTreeMap::new();
    for seed in 0..50 {
        let seed = seed.to_string();
        for (depth, filter) in
            [(Depth::Equation, "/2/"), (Depth::Step, "step/"), (Depth::Run, "run/drawn")]
        {
            let options = Options { filter: Some(filter.into()), ..options(&[depth]) };
            let command = command(Change::Nothing, &["--scramble", &seed]);
            let report = conform(&command, &options, |_, _| ()).unwrap().0;
            for item in &report.items {
                *verdicts.entry(item.verdict.name()).or_insert(0) += 1;
            }
            assert!(!report.conforms || report.items.len() < 10);
        }
    }
    for verdict in ["bits", "wrong", "broken"] {
        assert!(verdicts.contains_key(verdict), "{verdicts:?}");
    }
}
