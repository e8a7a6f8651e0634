//! Other laws in the march: what must be equal, exactly or to rounding.

use crate::common::{bits, run, shipped};
use crossfibre::constitution::Constitution;
use crossfibre::errata::{Corrections, Erratum};
use crossfibre::march;
use crossfibre::material::{Arm, Coefficients, Mesh, Update, of_scene};
use crossfibre::outcome::Outcome;
use crossfibre::paper::{Paper, Printed};
use crossfibre::scene::{Law, Material, Scene, Strain};
use crossfibre::state::{State, Wavefront};

const MODULUS: f64 = 58.6e9;

fn arms(modulus: f64, relaxation_time: f64) -> Vec<Arm> {
    vec![Arm { modulus, relaxation_time }]
}

/// A scene with one material, scaled so that its areas are powers of two: then area × (E ε) and
/// (area × E) ε, which is what (7) has, are the same number.
fn made_of(name: &str, strain: Strain, material: &Material) -> Scene {
    let mut scene = Scene { strain, ..shipped(name) };
    let area = 2.0_f64.powi(-20);
    scene.primary.area = area;
    scene.primary.material = material.clone();
    if let Some(secondary) = &mut scene.secondary {
        secondary.area = area;
        secondary.material = material.clone();
    }
    scene.check().unwrap();
    scene
}

/// The laws that are eqn (7) to the bit, and why.
fn disguised() -> Vec<(&'static str, Material)> {
    let linear = Law::Linear { modulus: MODULUS };
    vec![
        // Horner's rule of one coefficient is one product.
        ("polynomial", Law::Polynomial { coefficients: vec![MODULUS] }.into()),
        // An arm below half a unit in the last place of E changes neither the stress nor the modulus.
        (
            "viscoelastic, an arm of nothing",
            Law::Viscoelastic {
                equilibrium_modulus: MODULUS,
                arms: arms(1.3e-9, 3.1e-6),
                update: Update::Exact,
            }
            .into(),
        ),
        // While the strain is not negative it is the strain of the material, and the stress not cut.
        ("tension only", Material { tension_only: true, ..linear.clone().into() }),
        // q is 0 × Δε, and σ + 0 is σ.
        (
            "viscosity without coefficients",
            Material { artificial_viscosity: Some(Coefficients::default()), ..linear.into() },
        ),
    ]
}

#[test]
fn a_law_that_amounts_to_the_pages_gives_the_bits_of_the_page() {
    for name in ["single-400", "fig3"] {
        for strain in [Strain::Engineering, Strain::Incremental] {
            let watch = |material: &Material| {
                let scene = made_of(name, strain, material);
                let (mut seen, mut least) = (Vec::new(), 0.0_f64);
                let (state, outcome) = run(&scene, Wavefront::Flagged, |state: &State<f64>| {
                    least = state.primary.strain.iter().fold(least, |a, &b| a.min(b));
                    if let Some(crossover) = &state.crossover {
                        least = crossover.fibre.strain.iter().fold(least, |a, &b| a.min(b));
                    }
                    seen.push(bits(state));
                });
                assert_eq!(outcome, Outcome::Completed, "{name}");
                (seen, least, state.primary.constitution.is_some())
            };
            let (page, least, by_law) = watch(&Material::linear(MODULUS));
            assert!(!by_law);
            // Else a law without compression would be another one.
            assert!(least >= 0.0, "{name}: {least:e}");
            for (law, material) in disguised() {
                let (seen, _, by_law) = watch(&material);
                assert!(by_law, "{law}");
                assert!(seen == page, "{name}, {strain:?}, {law}");
            }
        }
    }
}

#[test]
fn arms_that_never_relax_are_a_spring_to_rounding() {
    // Their stress is the sum of E Δε over the steps, not E ε: 100 roundings of 2⁻⁵³ at the most,
    // which the waves carry on.
    let law = |equilibrium_modulus, modulus| Law::Viscoelastic {
        equilibrium_modulus,
        arms: arms(modulus, 1.7e290),
        update: Update::Exact,
    };
    for strain in [Strain::Engineering, Strain::Incremental] {
        let strains = |material: Material| {
            let scene = made_of("fig3", strain, &material);
            run(&scene, Wavefront::Flagged, |_: &State<f64>| ()).0.primary.strain
        };
        let page = strains(Material::linear(MODULUS));
        let glassy = strains(law(0.3 * MODULUS, 0.7 * MODULUS).into());
        let apart =
            glassy.iter().zip(&page).map(|(a, b)| (a - b).abs()).max_by(f64::total_cmp).unwrap();
        // Positions are rounded by 3e-17 m of 2 mm, 1.4e-14 of strain, in every step.
        assert!(apart > 0.0 && apart < 1e-12, "{strain:?}: {apart:e}");
    }
}

/// Every law, plain and with what can be added to it.
fn every_material() -> Vec<Material> {
    let laws = [
        Law::Linear { modulus: MODULUS },
        Law::Polynomial { coefficients: vec![MODULUS, -0.97e12, 3.1e12] },
        Law::Exponential { a: -1.37e9, b: -43.7 },
        Law::Viscoelastic {
            equilibrium_modulus: 41.3e9,
            arms: [arms(9.7e9, 7.3e-6), arms(4.1e9, 61e-6), arms(1.9e9, 3e-4)].concat(),
            update: Update::Exact,
        },
        Law::Eyring {
            equilibrium_modulus: 13.7e9,
            modulus: 57.6e9,
            rate: 0.31,
            stress: 57e6,
            update: Update::Exact,
        },
    ];
    let viscous = Some(Coefficients { linear: 0.13, quadratic: 1.1 });
    laws.into_iter()
        .flat_map(|law| {
            [(false, None), (true, None), (false, viscous), (true, viscous)].map(
                |(tension_only, artificial_viscosity)| Material {
                    law: law.clone(),
                    tension_only,
                    artificial_viscosity,
                },
            )
        })
        .collect()
}

#[test]
fn a_material_knows_how_much_its_law_remembers() {
    let mesh = Mesh { density: 1391.0, spacing: 0.0017 };
    let mut most = 0;
    for material in every_material() {
        let law = of_scene::<f64>(&material, mesh, 2.3e-7).unwrap();
        assert_eq!(law.is_none(), material.is_of_the_page());
        let memory = law.map_or(0, |law| law.memory());
        assert_eq!(memory, material.numbers_remembered(), "{material:?}");
        most = most.max(memory);
    }
    // Energy and strain of the material, energy and three arms.
    assert_eq!(most, 6);
}

#[test]
fn the_modulus_that_sets_the_wave_speed_is_the_slope_of_the_law_at_rest() {
    let mesh = Mesh { density: 1391.0, spacing: 0.0017 };
    let mut materials = every_material();
    materials.push(Law::Exponential { a: 1.9e9, b: 31.7 }.into());
    for material in materials {
        let Some(law) = of_scene::<f64>(&material, mesh, 2.3e-7).unwrap() else { continue };
        let memory = vec![0.0; law.memory()];
        let slope = law.instantaneous_modulus(0.0, &memory);
        // The sum of a spring and its arms, or a product.
        assert!((material.instantaneous_modulus() / slope - 1.0).abs() < 1e-15, "{material:?}");
    }
}

#[test]
fn a_material_is_written_without_what_it_has_not() {
    let text = serde_json::to_string(&Material::linear(1.5e9)).unwrap();
    assert_eq!(text, r#"{"law":"linear","modulus":1500000000.0}"#);
}

#[test]
fn a_law_knows_its_name_in_a_scene_and_whether_its_update_is_literal() {
    let mut literal = 0;
    for material in every_material() {
        let written = serde_json::to_value(&material).unwrap();
        assert_eq!(written["law"], material.law.name());
        assert!(!material.is_literal());
        let mut material = material;
        if let Law::Viscoelastic { update, .. } | Law::Eyring { update, .. } = &mut material.law {
            *update = Update::Literal;
            assert!(material.is_literal());
            literal += 1;
        }
    }
    assert_eq!(literal, 8);
}

#[test]
fn corrections_are_written_as_a_word_where_there_is_one() {
    let written = |corrections| {
        let scene = Scene { corrections, ..shipped("single-400") };
        serde_json::to_value(&scene).unwrap()["corrections"].to_string()
    };
    assert_eq!(written(Corrections::ALL), "\"all\"");
    assert_eq!(written(Corrections::NONE), "\"none\"");
    let one: Corrections = [Erratum::TimeLevel].into_iter().collect();
    assert_eq!(written(one), "[\"time-level\"]");
}

/// The page, in blocks of more elements than it asks for itself.
struct InLongBlocks;

impl Paper<f64> for InLongBlocks {
    const BLOCK_BY_LAW: usize = 1000;
}

#[test]
fn a_block_may_be_longer_than_the_pages() {
    let mut scene = Scene { corrections: Corrections::NONE, ..shipped("viscoelastic") };
    scene.primary.elements = 700;
    let marched = |paper: &dyn Fn(&mut State<f64>) -> Outcome| {
        let mut state = State::at_impact(&scene, Wavefront::Ignored);
        assert_eq!(paper(&mut state), Outcome::Completed);
        let path = state.primary.constitution.as_ref().unwrap().path;
        (bits(&state), [path.stored, path.dissipated])
    };
    let page = marched(&|state| march::run(&Printed, state, 50, |_| ()));
    let long = marched(&|state| march::run(&InLongBlocks, state, 50, |_| ()));
    // The flags are ignored, so that all 700 are one block, and two of the page's.
    assert!(page.0 == long.0);
    // Energies are summed block by block.
    for (page, long) in page.1.into_iter().zip(long.1) {
        assert!(long > 0.0 && (page / long - 1.0).abs() < 1e-13, "{page} {long}");
    }
}

/// What a constitution has gathered, to the bit.
fn memory_bits(constitution: Option<&Constitution<f64>>) -> Vec<u64> {
    let Some(constitution) = constitution else { return Vec::new() };
    let path = [constitution.path.stored, constitution.path.dissipated];
    constitution.memory.iter().chain(&path).map(|x| x.to_bits()).collect()
}

/// A short scene of each material, with both measures.
fn scenes() -> impl Iterator<Item = Scene> {
    every_material().into_iter().flat_map(|material| {
        [Strain::Engineering, Strain::Incremental].map(|strain| {
            let mut scene = made_of("fig3", strain, &material);
            (scene.courant, scene.duration) = (0.71, 21.3e-6);
            scene
        })
    })
}

#[test]
fn the_wavefronts_flags_change_no_bit_of_any_law() {
    for scene in scenes() {
        let material = &scene.primary.material;
        let mut flagged = Vec::new();
        let all = |state: &State<f64>| {
            let crossing = state.crossover.as_ref().unwrap();
            let mut all = bits(state);
            all.extend(memory_bits(state.primary.constitution.as_ref()));
            all.extend(memory_bits(crossing.fibre.constitution.as_ref()));
            all
        };
        let watch = |state: &State<f64>| flagged.push(all(state));
        let (_, outcome) = run(&scene, Wavefront::Flagged, watch);
        assert_eq!(outcome, Outcome::Completed, "{material:?}");
        let mut steps = flagged.iter();
        run(&scene, Wavefront::Ignored, |state: &State<f64>| {
            assert!(Some(&all(state)) == steps.next(), "{material:?}: step {}", state.step);
        });
        assert!(steps.next().is_none());
    }
}

#[test]
fn single_precision_gives_the_strain_of_double_precision_with_any_law() {
    for scene in scenes() {
        let material = &scene.primary.material;
        let (double, in_double) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let (single, in_single) = run(&scene, Wavefront::Flagged, |_: &State<f32>| ());
        assert_eq!((in_single, in_double), (Outcome::Completed, Outcome::Completed));
        let apart = single.primary.strain.iter().zip(&double.primary.strain);
        let error = apart.map(|(s, d)| (f64::from(*s) - d).abs()).max_by(f64::total_cmp).unwrap();
        // Positions near 0.3 m are rounded to 1.5e-8 m on an element of 2 mm, 7.5e-6 of strain in a
        // step, which adds up over a hundred.
        assert!(error > 1e-8 && error < 2e-4, "{error:e} {material:?}");
    }
}
