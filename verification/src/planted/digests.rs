//! The faults are those of which the stored kill matrix says what notices them: by a number for each, made of
//! what it gives on a few inputs. Where one is changed on purpose, the matrix has to be measured again.

use std::fmt::Write;
use std::path::Path;

use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::exact::smith::{Fibre, Law};
use crossfibre::exact::viscoelastic::Arm;
use crossfibre::exact::{crossover, smith};
use crossfibre::paper::Paper;
use crossfibre::result;

use super::tests::{InPlainWords, scenes, text};
use super::{exact, march, material, record};
use crate::bits::fnv;
use crate::cases::support::shipped;
use crate::closed_form;
use crate::conform::by_name::evaluate;
use crate::faulty::rewritten::{Rewritten, Style};
use crate::faulty::{Faulty, catalogue};
use crate::golden::equations::{EquationVector, vectors};
use crate::golden::file::Flag;
use crate::precision::stored::stored;

fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/faults");
    settings.set_snapshot_path(golden);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// The bits that an edition gives on golden vectors; one number that is none is as good as another.
fn evaluated(paper: &impl Paper<f64>, vectors: &[&EquationVector]) -> u64 {
    let mut bits = vec![];
    for vector in vectors {
        let out = evaluate(paper, vector.eq.parse().unwrap(), &vector.numbers()).unwrap();
        bits.extend(out.iter().map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() }));
    }
    fnv(bits.into_iter().flat_map(u64::to_le_bytes))
}

#[test]
fn the_faults_of_equations_are_those_that_were_measured() {
    let all = vectors();
    let of = |is_engineering: bool| -> Vec<&EquationVector> {
        let corrected = all.iter().filter(|vector| !vector.flags.contains(&Flag::Printed));
        corrected.filter(|v| v.flags.contains(&Flag::Engineering) == is_engineering).collect()
    };
    let (incremental, engineering) = (of(false), of(true));
    let by_4 = Corrected::<Incremental>::new(Corrections::ALL);
    let by_length = Corrected::<Engineering>::new(Corrections::ALL);
    let mut seen = String::new();
    let mut line = |name: &str, one: u64, other: u64| {
        writeln!(seen, "{name} {one:016x} {other:016x}").unwrap();
    };
    line("none", evaluated(&by_4, &incremental), evaluated(&by_length, &engineering));
    for &wrong in catalogue::Wrong::ALL {
        line(
            wrong.fault().id,
            evaluated(&Faulty::new(&by_4, wrong), &incremental),
            evaluated(&Faulty::new(&by_length, wrong), &engineering),
        );
    }
    for style in Style::ALL {
        line(
            style.name(),
            evaluated(&Rewritten::<Incremental>::new(style), &incremental),
            evaluated(&Rewritten::<Engineering>::new(style), &engineering),
        );
    }
    assert_snapshot("equations", &seen);
}

#[test]
fn the_faults_of_the_march_and_of_the_materials_are_those_that_were_measured() {
    let wanted = [
        "kinked",
        "both slow",
        "exponential",
        "outgrown",
        "eyring, Engineering",
        "fig3, Incremental",
        "slack, Engineering",
        "viscoelastic, Engineering",
    ];
    let scenes: Vec<_> =
        scenes().into_iter().filter(|(name, _)| wanted.contains(&name.as_str())).collect();
    assert_eq!(scenes.len(), wanted.len());
    let run = |marcher: InPlainWords| {
        let texts =
            scenes.iter().map(|(_, scene)| text(&result::run_with(&marcher, scene, |_| ())));
        fnv(texts.collect::<String>().bytes())
    };
    let mut seen = String::new();
    for &wrong in march::Wrong::ALL {
        writeln!(seen, "{} {:016x}", wrong.words().0, run(InPlainWords(Some(wrong), None)))
            .unwrap();
    }
    for &wrong in material::Wrong::ALL {
        writeln!(seen, "{} {:016x}", wrong.words().0, run(InPlainWords(None, Some(wrong))))
            .unwrap();
    }
    assert_snapshot("march", &seen);
}

#[test]
fn the_faults_of_exact_solutions_and_of_the_record_are_those_that_were_measured() {
    let primary = Fibre { modulus: 84e9, density: 1440.0, area: 7e-9 };
    let secondary = Fibre { modulus: 61e9, density: 970.0, area: 5e-9 };
    let problem = closed_form::problem(&shipped("unequal"));
    let mut seen = String::new();
    for &wrong in exact::Wrong::ALL {
        let (law, fibres) = wrong.crossing(Law::Logarithmic, [primary, secondary], 0.3);
        let struck = smith::smith(law, fibres[0].wave_speed(), 400.0).unwrap();
        let crossed = crossover::crossover(law, &fibres[0], &fibres[1], 0.3, 400.0).unwrap();
        let given = format!(
            "{:?} {law:?} {fibres:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?}",
            wrong.law_of_impact(Law::Logarithmic),
            wrong.impact(struck, 400.0),
            wrong.crossed(crossed, fibres),
            wrong.arms(&[Arm { modulus: 3e9, relaxation_time: 1e-5 }]),
            wrong.problem(&problem),
            (wrong.density(970.0), wrong.mass(Some(0.3)), wrong.time_of_motion(3e-5)),
            (wrong.time_of_rod(3e-5), wrong.courant(0.7), wrong.frequency(3.0), wrong.growth(1.3)),
            (
                (wrong.fronts(3), wrong.step(3), wrong.coefficients(&[3.0, 7.0, 11.0])),
                (wrong.exponential([3.0, 7.0]), wrong.dissipation(3.0)),
            ),
        );
        writeln!(seen, "{} {:016x}", wrong.words().0, fnv(given.bytes())).unwrap();
    }
    for &wrong in record::Wrong::ALL {
        let mut other = stored().clone();
        wrong.put_into(&mut other);
        let digest = fnv(serde_json::to_string(&other).unwrap().bytes());
        writeln!(seen, "{} {digest:016x}", wrong.words().0).unwrap();
    }
    assert_snapshot("exact-and-record", &seen);
}
