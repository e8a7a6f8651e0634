use approx::assert_relative_eq;
use pxfm::f_exp;

use super::super::tests::{ARMS, Run};
use super::super::{Exponential, Eyring, Linear, Update, Viscoelastic};
use super::*;

#[test]
fn elastic_fibre_carries_tension_as_ever_and_nothing_when_slack() {
    let law = TensionOnly::new(Exponential::<f64>::new(1.7e9, 23.7).unwrap());
    let taut = Exponential::<f64>::new(1.7e9, 23.7).unwrap();
    let mut run = Run::new(&law);
    for strain in [0.0131, 0.0217, -0.0091, -0.0173, 0.0037, -0.0011, 0.0293] {
        let stress = run.to(strain);
        if strain > 0.0 {
            assert_eq!(stress, taut.stress(0.0, strain, &mut []));
            assert_eq!(
                law.instantaneous_modulus(strain, &run.memory),
                taut.instantaneous_modulus(strain, &[])
            );
            assert_eq!(run.energy(), taut.stored(strain, &[]));
        } else {
            assert_eq!((stress, run.energy()), (0.0, 0.0));
            assert_eq!(law.instantaneous_modulus(strain, &run.memory), 0.0);
        }
    }
}

#[test]
fn polynomial_with_another_root_neither_pulls_in_compression_nor_pushes_in_tension() {
    // T = E₁ε + E₂ε² has a root at ε = −E₁/E₂: −0.0802, with E₂ < 0 +0.0803.
    let inner = super::super::Polynomial::<f64>::new(&[58.6e9, 7.3e11]).unwrap();
    assert!(inner.stress(0.0, -0.11, &mut []) > 0.0);
    assert_eq!(Run::new(&TensionOnly::new(inner)).to(-0.11), 0.0);
    let inner = super::super::Polynomial::<f64>::new(&[58.6e9, -7.3e11]).unwrap();
    assert!(inner.stress(0.0, 0.11, &mut []) < 0.0);
    assert_eq!(Run::new(&TensionOnly::new(inner)).to(0.11), 0.0);
}

#[test]
fn slack_fibre_recovers_at_zero_stress_and_is_taut_at_the_strain_of_its_material() {
    // Ramp to ε₁, hold (a memory of stress s in the arm), let go. From then on the material creeps at
    // zero stress: at once by the springs, ε = −s/(E∞ + E) less, then E∞ε = −s decays with
    // τc = τ(E∞ + E)/E∞. Strain is taken as linear over a step: order 2.
    let (e0, arm) = (31.9e9, ARMS[0]);
    let law = |step: f64| {
        TensionOnly::new(Viscoelastic::<f64>::new(e0, &[arm], Update::Exact).unwrap())
            .prepared(step)
    };
    let (sudden, hold) = (law(0.0), law(0.61e-6));
    let creep = arm.relaxation_time * (e0 + arm.modulus) / e0;
    let time = 0.37e-6;
    let error = |steps: u32| {
        let slack = law(time / f64::from(steps));
        let mut run = Run::new(&sudden);
        run.to(0.0137);
        run.law = &hold;
        let arm_stress = run.to(0.0137) - e0 * 0.0137;
        run.law = &sudden;
        assert_eq!(run.to(-0.0291), 0.0);
        let strain = arm.modulus * 0.0137 - arm_stress; // of the dashpot, times E
        let at_once = strain / (e0 + arm.modulus);
        assert_relative_eq!(run.memory[0], at_once, epsilon = 0.0, max_relative = 1e-13);
        let energy = run.energy();
        run.law = &slack;
        for _ in 0..steps {
            assert_eq!(run.to(-0.0291), 0.0);
        }
        // The dashpot takes what the springs give; none is done on a slack fibre. Of the energy
        // that is there, as far as the stress is zero within a step and not only at its ends.
        assert!((run.energy() / energy - 1.0).abs() < 2e-5, "{} {energy}", run.energy());
        let material = at_once * f_exp(-time / creep);
        let error = run.memory[0] / material - 1.0;
        // Just below the strain of the material it is slack, just above it pulls with all springs.
        run.law = &sudden;
        assert_eq!(run.to(material - 1e-5), 0.0);
        let pull = run.to(material + 1e-4) / (e0 + arm.modulus);
        assert!((pull - 1e-4).abs() < 1e-6, "{pull:e}");
        error
    };
    let (coarse, fine) = (error(20), error(40));
    assert!(fine.abs() < 1e-4, "{fine:e}");
    assert!((coarse / fine - 4.0).abs() < 0.1, "{coarse:e} {fine:e}");
}

#[test]
fn slack_fibre_of_an_eyring_law_holds_its_springs_in_balance() {
    // E∞ε + s = 0 at every step, to rounding of the two, while the strain recovers. From a material that has flowed much, a little, and with E∞ = 0.
    for (e0, rate, hold) in [(31.9e9, 1.9e4, 0.61e-6), (31.9e9, 190.0, 0.41e-6), (0.0, 1.9e4, 1e-6)]
    {
        let law = |step: f64| {
            let inner = Eyring::<f64>::new(e0, 17.3e9, rate, 53.0e6, Update::Exact).unwrap();
            TensionOnly::new(inner).prepared(step)
        };
        let (hold, slack) = (law(hold), law(0.043e-6));
        let mut run = Run::new(&hold);
        run.to(0.0137);
        run.to(0.0137);
        run.law = &slack;
        let mut material = 0.0137;
        for k in 1..40 {
            let stress = run.to(-0.0093 * f64::from(k));
            assert_eq!(stress, 0.0);
            let [strain, _, s] = run.memory[..] else { panic!() };
            assert!((e0 * strain + s).abs() < 1e-4, "{strain} {s}");
            assert!(strain <= material && strain > 0.0, "{strain}");
            material = strain;
        }
        // Taut again at the material's strain: a sudden strain meets both springs.
        let sudden = law(0.0);
        run.law = &sudden;
        let pull = run.to(material + 1e-5) / 1e-5;
        assert_relative_eq!(pull, e0 + 17.3e9, max_relative = 1e-8);
    }
}

#[test]
fn what_is_not_a_number_ends_the_search_for_the_slack_strain() {
    let inner = Eyring::<f64>::new(31.9e9, 17.3e9, 190.0, 53.0e6, Update::Exact).unwrap();
    let law = TensionOnly::new(inner).prepared(0.31e-6);
    for memory in [[f64::NAN, 0.0, 1e8], [0.01, 0.0, f64::NAN], [0.01, f64::NAN, 1e8]] {
        for strain in [f64::NAN, f64::NEG_INFINITY, -0.01] {
            let stress = law.stress(0.0, strain, &mut memory.clone());
            assert!(stress.is_nan() || stress >= 0.0);
        }
    }
}

#[test]
fn tension_only_is_the_law_itself_while_in_tension() {
    let inner =
        || Viscoelastic::<f64>::new(31.9e9, &ARMS, Update::Exact).unwrap().prepared(0.07e-6);
    let (inner, law) = (inner(), TensionOnly::new(inner()));
    let (mut free, mut cut) = (Run::new(&inner), Run::new(&law));
    for k in 1..40 {
        let strain = 0.0091 + 0.0037 * pxfm::f_sin(0.41 * f64::from(k));
        assert_eq!(free.to(strain).to_bits(), cut.to(strain).to_bits());
        assert_eq!(free.energy().to_bits(), cut.energy().to_bits());
    }
    // And of a law without memory, whatever came before.
    let linear = TensionOnly::new(Linear::<f64>::new(58.6e9).unwrap());
    let mut run = Run::new(&linear);
    run.to(-0.31);
    assert_eq!(run.to(0.0173), 58.6e9 * 0.0173);
}
