//! The checked-in VALIDATION.md is that of today, part by part, and each check fails with the faults that
//! the checked-in kill matrix says it notices: what has changed is named by a test of its own. That
//! VALIDATION.md holds nothing else, and in this order, is a test of `verify`.

#![allow(clippy::unwrap_used)] // a test may

mod planted_support;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crossfibre_verification::cases::{self, Case};
use crossfibre_verification::record::{Record, run_cases};
use crossfibre_verification::report::markdown;
use crossfibre_verification::sensitivity::matrix::{Matrix, Row};
use crossfibre_verification::sensitivity::stored::stored;
use planted_support::agrees_with_the_matrix;

fn checked_in() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../VALIDATION.md");
    fs::read_to_string(path).unwrap()
}

/// What to do about a line that is another.
const STALE: &str = "VALIDATION.md is stale: run `cargo run --release -- verify`, read the difference, and copy \
                     target/verification/VALIDATION.md over it";

/// Runs a case: it passes, and its rows are those in the file.
fn is_as_before(id: &str) {
    let all = cases::all();
    let case: Vec<Case> = all.into_iter().filter(|case| case.id == id).collect();
    let [record] = &run_cases(&case, |_| ())[..] else { panic!("{id} is one case") };
    assert_eq!(record.troubles().next().map(|trouble| &trouble.check), None);
    let rows = markdown::rows(record);
    let of_case = format!("| ✓ | {id} |");
    let text = checked_in();
    let there: Vec<_> = text.lines().filter(|line| line.starts_with(&of_case)).collect();
    assert!(!there.is_empty());
    assert_eq!(rows.lines().collect::<Vec<_>>(), there, "{STALE}");
}

/// The faults of the stored kill matrix that are asked so that each check of a case fails with one of them. One
/// that stops the case, so that all its checks count as failed, only where there is no other.
fn faults_for(matrix: &'static Matrix, id: &str) -> Vec<&'static Row> {
    let of_case = |check: &usize| matrix.checks[*check].case == id;
    let mut left: BTreeSet<usize> = (0..matrix.checks.len()).filter(of_case).collect();
    assert!(!left.is_empty(), "docs/sensitivity has no check of {id}");
    let mut chosen = vec![];
    while !left.is_empty() {
        let noticed = |row: &Row| matrix.noticing(row).filter(|check| left.contains(check)).count();
        let most = |stops: bool| {
            let some =
                matrix.faults.iter().filter(|row| row.stops(id) == stops && noticed(row) > 0);
            some.max_by_key(|row| noticed(row))
        };
        let row = most(false).or_else(|| most(true)).expect("each check notices some fault");
        matrix.noticing(row).for_each(|check| {
            left.remove(&check);
        });
        chosen.push(row);
    }
    chosen
}

/// Each check of a case fails with a fault, as the matrix says.
fn can_fail(id: &str) {
    for row in faults_for(stored(), id) {
        agrees_with_the_matrix(row, id);
    }
}

/// Tests for each case, by parts of its name, and the name. The matrix is of the cases that are quick.
macro_rules! each {
    ($($group:ident { $($name:ident $id:literal $($slow:ident)?,)* })*) => {
        $(mod $group {
            $(mod $name {
                #[test]
                fn is_as_before() {
                    crate::is_as_before($id);
                }

                each!(can_fail $id $($slow)?);
            })*
        })*

        const EACH: &[&str] = &[$($($id),*),*];
    };
    (can_fail $id:literal slow) => {};
    (can_fail $id:literal) => {
        #[test]
        fn can_fail() {
            crate::can_fail($id);
        }
    };
}

each! {
    by_hand {
        fibre "by-hand.fibre",
        crossover "by-hand.crossover",
        step "by-hand.step",
    }
    smith {
        plateau "smith.plateau",
        sweep "smith.sweep",
        kink "smith.kink",
        density "smith.density",
    }
    axial {
        impact "axial.impact",
        dispersion "axial.dispersion",
        wave_equation "axial.wave-equation",
    }
    courant {
        growth "courant.growth",
        impact "courant.impact",
    }
    stability {
        uniform "stability.uniform",
        laws "stability.laws",
        projectile "stability.projectile",
        crossover "stability.crossover",
    }
    crossover {
        coefficients "crossover.coefficients",
        unequal "crossover.unequal",
        inertia "crossover.inertia",
        power "crossover.power",
        printed "crossover.printed",
    }
    projectile {
        momentum "projectile.momentum",
        limits "projectile.limits",
        two_fibres "projectile.two-fibres",
    }
    conservation {
        engineering "energy.engineering",
        incremental "energy.incremental",
        kink "energy.kink",
        printed "energy.printed",
        momentum "momentum.fig3",
    }
    identities {
        both_at_origin "identity.both-at-origin",
        free_sliding "identity.free-sliding",
        wavefront_flags "identity.wavefront-flags",
        causality "identity.causality",
    }
    invariance {
        rotation "invariance.rotation",
        reflection "invariance.reflection",
        galilean "invariance.galilean",
        scaling "invariance.scaling",
    }
    motion {
        engineering "motion.engineering",
        incremental "motion.incremental",
        projectile "motion.projectile",
    }
    material {
        softening "material.softening",
        hardening "material.hardening",
        inflection "material.inflection",
        rod "material.rod",
        arms "material.arms",
        stiff "material.stiff",
        energy "material.energy",
        slack "material.slack",
        viscosity "material.viscosity",
        viscosity_stress "material.viscosity-stress",
    }
    conformance {
        rewrites "conformance.rewrites" slow,
        faults "conformance.faults",
    }
    golden {
        vectors "golden.vectors",
    }
    precision {
        orders "precision.orders" slow,
        cost "precision.cost" slow,
        gci "precision.gci" slow,
        split "precision.split" slow,
        record "precision.record" slow,
    }
    record {
        stored "record.stored",
    }
    extreme {
        velocity "extreme.velocity",
        rounding "extreme.rounding",
        ratios "extreme.ratios",
        crossover "extreme.crossover",
        mesh "extreme.mesh",
        long "extreme.long",
        projectile "extreme.projectile",
        laws "extreme.laws",
        scaling "extreme.scaling",
    }
}

#[test]
fn each_case_has_its_test() {
    let ids: Vec<_> = cases::all().iter().map(|case| case.id).collect();
    assert_eq!(EACH, ids);
}

/// The claims, the effects of the ledger, the step worked by hand and the like: all but the cases.
#[test]
fn what_stands_beside_the_cases_is_as_before() {
    let beside = |text: &str| -> Vec<String> {
        let from_claims = text.lines().skip_while(|line| *line != "## What the paper claims");
        from_claims.filter(|line| !line.starts_with("| ✓ |")).map(str::to_owned).collect()
    };
    let today = beside(&markdown::render(&Record::around(vec![])));
    assert!(today.len() > 100);
    assert_eq!(beside(&checked_in()), today, "{STALE}");
}
