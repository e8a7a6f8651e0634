use approx::assert_relative_eq;
use pxfm::f_exp;

use super::super::tests::{ARMS, Run};
use super::*;

fn prepared(arms: &[Arm], equilibrium: f64, update: Update, time_step: f64) -> Viscoelastic<f64> {
    Viscoelastic::new(equilibrium, arms, update).unwrap().prepared(time_step)
}

#[test]
fn coefficients_of_a_step_agree_with_quadrature_at_all_sizes() {
    // Δt/τ; exp(−x); ∫exp(−x(1−θ))dθ; and of x∫s²dθ with s = s₀exp(−xθ) + e(1 − exp(−xθ))/x the
    // three parts: quadrature with 60 digits in another language (closed form for the last). Either
    // side of m = ½ is in it. Tolerance: in double some five roundings, and twice as much where
    // x − m − m²/2 cancels to a sixth; in single the same in units of 6e-8, at the rounded x.
    for (x, left, gained, loss) in [
        (
            1.3e-06,
            0.999998700000845,
            0.9999993500002816,
            [1.2999983100014648e-06, 1.2999983100012816e-06, 4.333329108335897e-07],
        ),
        (
            0.0173,
            0.9828487857665612,
            0.9913996666727656,
            [0.017004132158598185, 0.017003708074064462, 0.0056924445203585606],
        ),
        (
            0.6903,
            0.5014256188140019,
            0.722257541918004,
            [0.37428617439849765, 0.36009910701868886, 0.14152238819738036],
        ),
        (
            0.6957,
            0.4987252181162607,
            0.7205329623167159,
            [0.3756365784074441, 0.3611850035253563, 0.14212237447262593],
        ),
        (
            3.17,
            0.04200359790344555,
            0.30220706690743043,
            [0.49911784888158284, 0.28951328278547106, 0.17445939801256594],
        ),
        (1.7e6, 0.0, 5.88235294117647e-07, [0.5, 5.88235294117647e-07, 5.882347750865052e-07]),
    ] {
        let expected = [left, gained, loss[0], loss[1], loss[2]];
        let found = exact(x);
        let found = [found.0, found.1, found.2[0], found.2[1], found.2[2]];
        let single = exact(x as f32);
        let single = [single.0, single.1, single.2[0], single.2[1], single.2[2]];
        for i in 0..5 {
            assert_relative_eq!(found[i], expected[i], epsilon = 0.0, max_relative = 2e-15);
            let single = f64::from(single[i]);
            assert_relative_eq!(single, expected[i], epsilon = 0.0, max_relative = 1e-6);
        }
    }
}

#[test]
fn held_strain_relaxes_exponentially_at_any_length_of_the_step() {
    // A ramp to ε₀ over one step, then 1000 steps of holding: E∞ε₀ + Σ Eε₀(1 − q)/x × qⁿ. Tolerance:
    // a thousand roundings of a product, at random; one step for Δt/τ ≥ 1e3, where only E∞ε₀ is left.
    let strain = 0.0137;
    for arm in ARMS {
        for x in [1e-6, 0.0037, 0.41, 2.9, 1.3e3, 1e6] {
            let law = prepared(&[arm], 31.9e9, Update::Exact, x * arm.relaxation_time);
            let mut run = Run::new(&law);
            run.to(strain);
            let mut stress = 0.0;
            for _ in 0..1000 {
                stress = run.to(strain);
            }
            let ramp = -pxfm::f_expm1(-x) / x;
            let expected = 31.9e9 * strain + arm.modulus * strain * ramp * f_exp(-1000.0 * x);
            assert_relative_eq!(stress, expected, epsilon = 0.0, max_relative = 4e-14);
            // The arm keeps s²/2E of the work: nothing is left of it but what was dissipated.
            let kept = (expected - 31.9e9 * strain) / arm.modulus;
            let stored = 0.5 * (31.9e9 * strain * strain + arm.modulus * kept * kept);
            let found = law.stored(strain, &run.memory);
            assert_relative_eq!(found, stored, epsilon = 0.0, max_relative = 1e-13);
        }
    }
}

#[test]
fn ramp_of_constant_rate_has_no_error_of_the_step() {
    // E∞rt + Σ Eτr(1 − exp(−t/τ)), in 37 steps or 2. Tolerance: 37 roundings.
    let (rate, time) = (5.3e3, 2.9e-6);
    for steps in [2, 37] {
        let law = prepared(&ARMS, 31.9e9, Update::Exact, time / f64::from(steps));
        let mut run = Run::new(&law);
        for k in 1..=steps {
            run.to(rate * time * f64::from(k) / f64::from(steps));
        }
        let arm =
            |a: &Arm| a.modulus * a.relaxation_time * -pxfm::f_expm1(-time / a.relaxation_time);
        let expected = rate * (31.9e9 * time + ARMS.iter().map(arm).sum::<f64>());
        assert_relative_eq!(run.stress, expected, epsilon = 0.0, max_relative = 6e-15);
        // Work ∫σ dε of that stress; all of it is in springs and dashpots, to rounding.
        let arm = |a: &Arm| {
            let (e, t) = (a.modulus, a.relaxation_time);
            e * t * (time - t * -pxfm::f_expm1(-time / t))
        };
        let work = rate * rate * (31.9e9 * time * time / 2.0 + ARMS.iter().map(arm).sum::<f64>());
        assert_relative_eq!(run.energy(), work, epsilon = 0.0, max_relative = 2e-14);
    }
}

#[test]
fn dissipation_does_not_depend_on_how_a_ramp_is_divided() {
    // The same corners in 5 steps and in 5 × 64: the integral within a step is exact. Tolerance: 320
    // roundings of a sum.
    let corners = [0.0113, 0.0091, -0.0037, -0.0037, 0.0173];
    for step in [0.37e-6, 41.0e-6] {
        let (whole, part) = (
            prepared(&ARMS, 31.9e9, Update::Exact, step),
            prepared(&ARMS, 31.9e9, Update::Exact, step / 64.0),
        );
        let (mut coarse, mut fine) = (Run::new(&whole), Run::new(&part));
        for corner in corners {
            let from = fine.strain;
            coarse.to(corner);
            for k in 1..=64 {
                fine.to(from + (corner - from) * f64::from(k) / 64.0);
            }
        }
        assert_relative_eq!(coarse.dissipated(), fine.dissipated(), max_relative = 1e-13);
        assert_relative_eq!(coarse.stress, fine.stress, max_relative = 1e-13);
    }
}

#[test]
fn held_stress_creeps_as_the_standard_linear_solid() {
    // ε = σ[1/E∞ − E/(E∞(E∞ + E)) exp(−t/τc)], τc = τ(E∞ + E)/E∞, from a jump. Strain is taken as
    // linear over a step: order 2, and halved steps must show it.
    let (e0, stress, arm) = (31.9e9, 0.73e9, ARMS[0]);
    let time = 1.7e-6;
    let both = e0 + arm.modulus;
    let creep = arm.relaxation_time * both / e0;
    let expected = stress * (1.0 / e0 - arm.modulus / (e0 * both) * f_exp(-time / creep));
    let error = |steps: u32| {
        let sudden = prepared(&[arm], e0, Update::Exact, 0.0);
        let law = prepared(&[arm], e0, Update::Exact, time / f64::from(steps));
        let mut run = Run::new(&sudden);
        run.creep_to(stress);
        run.law = &law;
        for _ in 0..steps {
            run.creep_to(stress);
        }
        run.strain / expected - 1.0
    };
    let (coarse, fine) = (error(50), error(100));
    assert!(fine.abs() < 1e-5, "{fine:e}");
    assert!((coarse / fine - 4.0).abs() < 0.04, "{coarse:e} {fine:e}");
}

#[test]
fn maxwell_liquid_creeps_at_constant_rate() {
    // E∞ = 0: ε = σ(1/E + t/(Eτ)). A constant rate is without error of the step; 90 roundings.
    let (arm, stress) = (ARMS[1], 0.37e9);
    let (sudden, law) =
        (prepared(&[arm], 0.0, Update::Exact, 0.0), prepared(&[arm], 0.0, Update::Exact, 1.9e-6));
    let mut run = Run::new(&sudden);
    run.creep_to(stress);
    run.law = &law;
    (0..90).for_each(|_| _ = run.creep_to(stress));
    let expected = stress / arm.modulus * (1.0 + 90.0 * 1.9e-6 / arm.relaxation_time);
    assert_relative_eq!(run.strain, expected, epsilon = 0.0, max_relative = 2e-14);
}

#[test]
fn literal_update_diverges_from_two_relaxation_times_on_and_the_exact_one_does_not() {
    let arm = ARMS[0];
    for (x, diverges) in [(1.93, false), (2.09, true)] {
        let step = x * arm.relaxation_time;
        let after = |update, steps| {
            let law = prepared(&[arm], 31.9e9, update, step);
            let mut run = Run::new(&law);
            (0..steps).map(|_| run.to(0.0137)).last().unwrap() - 31.9e9 * 0.0137
        };
        // Each step of holding multiplies the arm's stress by 1 − x: in 200 steps by 5e-7 or 3e7.
        let growth = after(Update::Literal, 201) / after(Update::Literal, 1);
        assert_eq!(growth.abs() > 1e7, diverges, "{x}: {growth:e}");
        assert_eq!(growth.abs() < 1e-6, !diverges, "{x}: {growth:e}");
        assert!(after(Update::Exact, 201).abs() < 1e-6 * arm.modulus * 0.0137);
    }
}

#[test]
fn literal_dissipation_and_energy_are_the_work_of_the_mean_stress() {
    // By construction, at any step; 40 roundings of a sum.
    let law = prepared(&ARMS, 31.9e9, Update::Literal, 0.31e-6);
    let mut run = Run::new(&law);
    for k in 0..40 {
        run.to(0.0119 * pxfm::f_sin(0.37 * f64::from(k)));
    }
    assert_relative_eq!(run.energy(), run.work, epsilon = 0.0, max_relative = 1e-13);
}
