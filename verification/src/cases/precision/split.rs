//! Rounding, discretisation and model, each held against what it ought to be.

use crossfibre::exact::viscoelastic::PulledRod;

use crate::cases::support::{check, order, relative};
use crate::cases::{Bound, Check};
use crate::oracle::rod_at;
use crate::precision::exact::rod;
use crate::precision::orders::ROUNDING;
use crate::precision::split::{Rest, SPLIT, Split};
use crate::precision::stored::stored;
use crate::precision::{Problem, Quantity, Record, Variant, ladders, run_of};
use crate::worse::worse;

const PAGE: usize = 0;
const ENGINEERING: usize = 1;

/// The mesh on which errors are split here: 1 mm.
const AT: f64 = 2.0;

pub fn checks() -> Vec<Check> {
    let problems = [Problem::Single, Problem::Crossed, Problem::Rod];
    let [doubles, long, single] = [
        SPLIT.map(|variants| variants.0).to_vec(),
        SPLIT.map(|variants| variants.1).to_vec(),
        SPLIT.into_iter().filter_map(|variants| variants.2).collect(),
    ];
    let mut tasks = ladders(&problems, &doubles, (1.0, 32.0));
    tasks.extend(ladders(&problems, &long, (AT, AT)));
    tasks.extend(ladders(&problems, &single, (AT, AT)));
    let record = Record::computed(&tasks);
    let mut checks = vec![rounding(&record), stored_rounding()];
    checks.extend(in_single_precision(&record).into_iter().flatten());
    checks.extend(models(&record));
    checks.extend(path(&record));
    checks
}

/// All splits of a record on a mesh.
fn splits(record: &Record, refinement: f64) -> Vec<Split> {
    let mut all = Vec::new();
    for problem in Problem::ALL {
        for variants in SPLIT {
            let of = |quantity| Split::of(record, problem, variants, quantity, refinement);
            all.extend(Quantity::ALL.into_iter().filter_map(of));
        }
    }
    all
}

fn rounding(record: &Record) -> Check {
    let all = splits(record, AT);
    check(
        "Of every headline number the part of rounding is nothing",
        "the same equations on the same mesh in 106 bits",
        "greatest relative difference; one fibre, two, and the rod, corrected and printed, 1 mm",
        all.iter().map(|split| split.rounding.abs()).fold(0.0, worse),
        Bound::AtMost(6e-10),
        "1e-16 in positions is 1e-13 in L/L₀ of an element, whose strain on the rod is 5e-4; ten times less \
         elsewhere",
    )
}

fn stored_rounding() -> Check {
    let finest = [4.0, 8.0, 16.0].map(|refinement| splits(stored(), refinement));
    check(
        "In the stored record it stays so on fine meshes, and below the floor of the fitted orders",
        "the same equations on the same mesh in 106 bits",
        "greatest relative difference, all four problems, 0.5 to 0.125 mm",
        finest.iter().flatten().map(|split| split.rounding.abs()).fold(0.0, worse),
        Bound::AtMost(ROUNDING),
        "4e-9 is what fitted orders take for nothing",
    )
}

/// In single precision rounding is a part like the others, and grows on finer meshes.
fn in_single_precision(record: &Record) -> Option<[Check; 2]> {
    let part = |record, variant: usize, refinement| {
        let mean = Quantity::MeanStrain;
        Split::of(record, Problem::Single, SPLIT[variant], mean, refinement)?.single
    };
    let [coarse, fine] = [part(record, PAGE, AT)?, part(stored(), PAGE, 8.0)?];
    let engineering = part(stored(), ENGINEERING, 8.0)?;
    Some([
        check(
            "In single precision the part of rounding in the mean strain by (4) grows as h⁻³",
            "½Σx² of eqn (4) over steps that rounding makes: (2⁻²⁴X/h)² in each, and 1/h of them",
            "order of it, from 1 mm to 0.25 mm; one fibre",
            order(coarse, fine, 4.0),
            Bound::Within(-3.5, -2.5),
            "-3 ∓ 1/2: the next orders are -2, of errors that add up, and -4",
        ),
        check(
            "With engineering strain, which has no path, it does not",
            "the same run by eqn (4)",
            "part of rounding in the mean strain, over that by (4); one fibre, 0.25 mm",
            (engineering / fine).abs(),
            Bound::AtMost(5e-3),
            "a sum of ΔL/L₀ forgets what each step rounds",
        ),
    ])
}

fn apart(record: &Record, problem: Problem, variant: usize, quantity: Quantity) -> (f64, f64) {
    match Split::of(record, problem, SPLIT[variant], quantity, AT).map(|split| split.rest) {
        Some(Rest::Apart { discretisation, model, .. }) => (discretisation, model),
        _ => (f64::NAN, f64::NAN),
    }
}

/// With engineering strain the model is that of the exact solution.
fn models(record: &Record) -> Vec<Check> {
    [
        (Problem::Single, Quantity::MeanStrain, 1e-3),
        (Problem::Single, Quantity::StrainL2, 4e-4),
        (Problem::Single, Quantity::Energy, 1.5e-2),
        (Problem::Crossed, Quantity::SecondaryMean, 5e-2),
        (Problem::Crossed, Quantity::Kink, 1e-1),
    ]
    .into_iter()
    .map(|(problem, quantity, most)| {
        let (discretisation, model) = apart(record, problem, ENGINEERING, quantity);
        check(
            format!(
                "{}, engineering strain: nothing of the error of {} is of the model",
                problem.id(),
                quantity.label()
            ),
            "exact solution; limit of the asymptotic range",
            "|limit − exact| over the part of discretisation at 1 mm",
            (model / discretisation).abs(),
            Bound::AtMost(most),
            "what a fitted power leaves of other terms",
        )
    })
    .collect()
}

/// By eqn (4) the rod's strain tends to another one than the logarithm.
fn path(record: &Record) -> Option<Check> {
    let (_, model) = apart(record, Problem::Rod, PAGE, Quantity::MeanStrain);
    let run = run_of(Problem::Rod, &Variant::named(SPLIT[PAGE].0), 64.0);
    let solution: PulledRod = rod(&run.scene).ok()?;
    let front = solution.front_speed() * run.scene.duration;
    let (mut deficit, mut strain) = (0.0, 0.0);
    const CELLS: usize = 400;
    for k in 0..CELLS {
        let x = (k as f64 + 0.5) / CELLS as f64 * front;
        let (jump, now) =
            (solution.front(x).strain, rod_at(&solution, x, run.scene.duration).ok()?.strain);
        deficit += 0.5 * (now * now - jump * jump);
        strain += now;
    }
    Some(check(
        "A rod's mean strain by eqn (4) tends to the front's jump and the logarithm of what follows",
        "ε₀ + ln((1 + ε)/(1 + ε₀)) = ε − (ε² − ε₀²)/2 + …, over the exact profile (PulledRod)",
        "relative difference of the part of the model",
        relative(model, -deficit / strain),
        Bound::AtMost(3e-3),
        "third order in a strain of 5e-4; what the finest mesh is from the limit",
    ))
}
