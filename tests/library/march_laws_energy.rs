//! What the laws of both fibres dissipate, and what an element remembers where (7) is evaluated.

use crossfibre::balance::Energy;
use crossfibre::constitution::Constitution;
use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::march;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::place::Fibre;
use crossfibre::scene::{Law, Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront};

use crate::common::{lengths, shipped, steps, trace};

/// Two unlike viscoelastic fibres.
fn scene(strain: Strain) -> Scene {
    let mut scene = Scene { strain, duration: 53.7e-6, ..shipped("viscoelastic") };
    scene.primary.elements = 47;
    if let Some(secondary) = &mut scene.secondary {
        secondary.elements = 31;
    }
    scene.check().unwrap();
    scene
}

fn constitution<const D: usize>(fibre: &FibreState<f64, D>) -> &Constitution<f64> {
    fibre.constitution.as_ref().unwrap()
}

/// Dissipated by each element, J/m³: the first number that a viscoelastic law remembers.
fn dissipated<const D: usize>(fibre: &FibreState<f64, D>) -> Vec<f64> {
    (0..fibre.elements()).map(|i| constitution(fibre).remembered(i).numbers()[0]).collect()
}

/// Energy that a fibre has dissipated between two states, J, of one of its halves or arms: the work of a step
/// is counted on the length that the strain of the step is divided by.
fn lost<const D: usize>(
    before: &FibreState<f64, D>,
    now: &FibreState<f64, D>,
    measure: Strain,
) -> f64 {
    let lengths = match measure {
        Strain::Incremental => lengths(before),
        Strain::Engineering => before.unstrained.clone(),
    };
    let gained = dissipated(now).into_iter().zip(dissipated(before)).map(|(now, then)| now - then);
    constitution(now).area
        * gained.zip(lengths).map(|(gained, length)| gained * length).sum::<f64>()
}

fn check(scene: &Scene, paper: &impl Paper<f64>) {
    let mut state = State::<f64>::at_impact(scene, Wavefront::Flagged);
    let mut states = vec![state.clone()];
    let outcome = march::run(paper, &mut state, steps(scene), |state| states.push(state.clone()));
    assert_eq!(outcome, Outcome::Completed);
    let (mut primary, mut secondary) = (0.0, 0.0);
    for two in states.windows(2) {
        let [before, now] = two else { unreachable!() };
        primary += 2.0 * lost(&before.primary, &now.primary, scene.strain);
        let [before, now] = [before, now].map(|state| &state.crossover.as_ref().unwrap().fibre);
        // Two arms on either side of the impact point.
        secondary += 4.0 * lost(before, now, scene.strain);
        // Sums over elements and steps.
        let energy = two[1].balance(paper, scene.strain).energy;
        let found = energy.dissipated;
        let apart = (found - primary - secondary).abs();
        assert!(apart <= 1e-12 * (primary + secondary), "{found} {primary} {secondary}");
        // To the balance of the fibres alone what is lost counts like what is stored.
        let lost = Energy { dissipated: energy.dissipated + energy.stored, ..energy };
        let stored = Energy { stored: 2.0 * energy.stored, ..energy };
        let [lost, stored] = [lost, stored].map(|energy| two[1].fibre_imbalance(&energy));
        assert!((lost - stored).abs() < 1e-14, "{lost} {stored}");
    }
    assert!(primary > 0.0 && secondary > 1e-3 * primary, "{primary} {secondary}");
}

#[test]
fn dissipated_is_what_the_arms_of_all_elements_of_both_fibres_have_lost() {
    let scene = scene(Strain::Engineering);
    check(&scene, &Corrected::<Engineering>::new(scene.corrections));
}

#[test]
fn along_the_path_of_equation_4_it_is_summed_step_by_step() {
    let scene = scene(Strain::Incremental);
    check(&scene, &Corrected::<Incremental>::new(scene.corrections));
}

#[test]
fn traced_memory_of_an_element_is_its_own() {
    let scene = scene(Strain::Incremental);
    let (state, outcome, events) = trace(&scene);
    assert_eq!(outcome, Outcome::Completed);
    let crossing = &state.crossover.as_ref().unwrap().fibre;
    let mut checked = 0;
    for seen in events.iter().filter(|seen| seen.equation == 7 && seen.place.step == state.step) {
        let remembered = match seen.place.fibre {
            Fibre::Primary => constitution(&state.primary).remembered(seen.place.index),
            Fibre::Secondary => constitution(crossing).remembered(seen.place.index),
        };
        let (_, memory) = seen.inputs.iter().find(|(name, _)| *name == "memory").unwrap();
        assert_eq!(memory, remembered.numbers(), "{:?}", seen.place);
        checked += 1;
    }
    assert!(checked > 47, "{checked}");
}

/// T = E₁ε + E₃ε³, whose tension is beyond all numbers where the strain is not.
fn stiffening() -> Scene {
    let mut scene = Scene { strain: Strain::Engineering, ..shipped("hardening") };
    scene.primary.material = Law::Polynomial { coefficients: vec![57.9e9, 0.0, 3.1e12] }.into();
    scene
}

#[test]
fn a_tension_beyond_all_numbers_is_told_before_the_courant_number_that_it_makes() {
    // In one step the first element is 1e120 times as long: ε³ has no number, ε and T′ have.
    let mut scene = stiffening();
    scene.projectile.velocity = 1.7e123;
    let paper = Corrected::<Engineering>::new(scene.corrections);
    let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
    let outcome = march::run(&paper, &mut state, 3, |_| {});
    let Outcome::Diverged { place, equation, .. } = outcome else { panic!("{outcome}") };
    assert_eq!((place.index, equation), (0, 7), "{outcome}");
    assert!(state.primary.strain[0].is_finite());
}
