//! The checked-in VALIDATION.md is that of today, part by part: what has changed is named by a test of its
//! own. That it holds nothing else, and in this order, is a test of `verify`.

#![allow(clippy::unwrap_used)] // a test may

use std::fs;
use std::path::Path;

use crossfibre_verification::cases::{self, Case};
use crossfibre_verification::record::{Record, run_cases};
use crossfibre_verification::report::markdown;

fn checked_in() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../VALIDATION.md");
    fs::read_to_string(path).unwrap()
}

/// Fails at the first line that is not in the file.
fn holds(lines: &str) {
    let text = checked_in();
    for line in lines.lines() {
        assert!(
            text.lines().any(|there| there == line),
            "VALIDATION.md has no such line: run `cargo run --release -- verify`, read the difference, and copy \
             target/verification/VALIDATION.md over it\n{line}"
        );
    }
}

/// Runs a case: it passes, and its rows are in the file.
fn is_as_before(id: &str) {
    let all = cases::all();
    let case: Vec<Case> = all.into_iter().filter(|case| case.id == id).collect();
    let [record] = &run_cases(&case, |_| ())[..] else { panic!("{id} is one case") };
    let rows = markdown::rows(record);
    assert!(!rows.is_empty());
    assert_eq!(record.troubles().next().map(|trouble| &trouble.check), None);
    holds(&rows);
}

/// A test for each case: parts of its name, and the name.
macro_rules! each {
    ($($group:ident { $($name:ident $id:literal)* })*) => {
        $(mod $group {
            $(#[test]
            fn $name() {
                super::is_as_before($id);
            })*
        })*

        const EACH: &[&str] = &[$($($id),*),*];
    };
}

each! {
    by_hand { fibre "by-hand.fibre" crossover "by-hand.crossover" step "by-hand.step" }
    smith { plateau "smith.plateau" sweep "smith.sweep" kink "smith.kink" density "smith.density" }
    axial {
        impact "axial.impact"
        dispersion "axial.dispersion"
        wave_equation "axial.wave-equation"
    }
    courant { growth "courant.growth" impact "courant.impact" }
    stability {
        uniform "stability.uniform"
        laws "stability.laws"
        projectile "stability.projectile"
        crossover "stability.crossover"
    }
    crossover {
        coefficients "crossover.coefficients"
        unequal "crossover.unequal"
        inertia "crossover.inertia"
        power "crossover.power"
        printed "crossover.printed"
    }
    projectile {
        momentum "projectile.momentum"
        limits "projectile.limits"
        two_fibres "projectile.two-fibres"
    }
    conservation {
        engineering "energy.engineering"
        incremental "energy.incremental"
        kink "energy.kink"
        printed "energy.printed"
        momentum "momentum.fig3"
    }
    identities {
        both_at_origin "identity.both-at-origin"
        free_sliding "identity.free-sliding"
        wavefront_flags "identity.wavefront-flags"
        causality "identity.causality"
    }
    invariance {
        rotation "invariance.rotation"
        reflection "invariance.reflection"
        galilean "invariance.galilean"
        scaling "invariance.scaling"
    }
    motion {
        engineering "motion.engineering"
        incremental "motion.incremental"
        projectile "motion.projectile"
    }
    material {
        softening "material.softening"
        hardening "material.hardening"
        inflection "material.inflection"
        rod "material.rod"
        arms "material.arms"
        stiff "material.stiff"
        energy "material.energy"
        slack "material.slack"
        viscosity "material.viscosity"
        viscosity_stress "material.viscosity-stress"
    }
    conformance { rewrites "conformance.rewrites" faults "conformance.faults" }
    golden { vectors "golden.vectors" }
    precision {
        orders "precision.orders"
        cost "precision.cost"
        gci "precision.gci"
        split "precision.split"
        record "precision.record"
    }
    record { stored "record.stored" }
    extreme {
        velocity "extreme.velocity"
        rounding "extreme.rounding"
        ratios "extreme.ratios"
        crossover "extreme.crossover"
        mesh "extreme.mesh"
        long "extreme.long"
        projectile "extreme.projectile"
        laws "extreme.laws"
        scaling "extreme.scaling"
    }
}

#[test]
fn each_case_has_its_test() {
    let ids: Vec<_> = cases::all().iter().map(|case| case.id).collect();
    assert_eq!(EACH, ids);
}

/// The claims, the effects of the ledger, the step worked by hand and the like.
#[test]
fn what_stands_beside_the_cases_is_as_before() {
    let text = markdown::render(&Record::around(vec![]));
    // But for the number of cases.
    holds(&text.replace("**0 of 0 checks pass**, in 0 cases.\n", ""));
}
