use approx::assert_relative_eq;
use pxfm::{f_asinh, f_exp, f_log1p, f_sinh, f_tanh};

use super::super::tests::Run;
use super::super::{Arm, Viscoelastic};
use super::*;

const E0: f64 = 31.9e9;
const E: f64 = 17.3e9;
const STRESS: f64 = 53.0e6;

fn prepared(e0: f64, rate: f64, update: Update, time_step: f64) -> Eyring<f64> {
    Eyring::new(e0, E, rate, STRESS, update).unwrap().prepared(time_step)
}

#[test]
fn held_strain_relaxes_by_the_hyperbolic_tangent() {
    // A jump, then tanh(s/2S) = tanh(s₀/2S) exp(−E rate t/S). Tolerance: 30 roundings; s₀/S = 9.5, so
    // the tangent of the whole is 1 − 1.5e-4, of which 1e-16 is 1e-12: taken as a difference from 1.
    let (rate, strain, step) = (37.0, 0.0291, 0.71e-6);
    let (sudden, law) =
        (prepared(E0, rate, Update::Exact, 0.0), prepared(E0, rate, Update::Exact, step));
    let mut run = Run::new(&sudden);
    run.to(strain);
    run.law = &law;
    (0..30).for_each(|_| _ = run.to(strain));
    let t = f_tanh(E * strain / STRESS / 2.0) * f_exp(-E * rate * 30.0 * step / STRESS);
    let expected = STRESS * f_log1p(2.0 * t / (1.0 - t));
    assert_relative_eq!(run.stress - E0 * strain, expected, epsilon = 0.0, max_relative = 3e-14);
    // All that left the spring was dissipated.
    let lost = (E * strain * E * strain - expected * expected) / (2.0 * E);
    assert_relative_eq!(run.dissipated(), lost, epsilon = 0.0, max_relative = 3e-14);
}

/// ds/dt and the dissipated power, by Runge–Kutta of order 4 along a strain given over time.
fn runge_kutta(rate: f64, time: f64, strain_rate: impl Fn(f64) -> f64) -> (f64, f64) {
    const STEPS: u32 = 20_000;
    let h = time / f64::from(STEPS);
    let f = |t: f64, s: f64| {
        let flow = rate * f_sinh(s / STRESS);
        (E * (strain_rate(t) - flow), s * flow)
    };
    let (mut s, mut lost) = (0.0, 0.0);
    for k in 0..STEPS {
        let t = h * f64::from(k);
        let k1 = f(t, s);
        let k2 = f(t + h / 2.0, s + h / 2.0 * k1.0);
        let k3 = f(t + h / 2.0, s + h / 2.0 * k2.0);
        let k4 = f(t + h, s + h * k3.0);
        s += h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
        lost += h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
    }
    (s, lost)
}

#[test]
fn ramp_of_constant_rate_has_no_error_of_the_step() {
    // Against Runge–Kutta, whose step of 1.5e-10 s leaves below 1e-12. In 3 steps or 41.
    let (rate, strain_rate, time) = (190.0, 7.9e3, 3.1e-6);
    let (expected, _) = runge_kutta(rate, time, |_| strain_rate);
    for steps in [3, 41] {
        let law = prepared(E0, rate, Update::Exact, time / f64::from(steps));
        let mut run = Run::new(&law);
        for k in 1..=steps {
            run.to(strain_rate * time * f64::from(k) / f64::from(steps));
        }
        let arm = run.stress - E0 * run.strain;
        assert_relative_eq!(arm, expected, epsilon = 0.0, max_relative = 4e-12);
    }
}

#[test]
fn curved_path_is_followed_to_second_order_with_its_dissipation() {
    // ε = 0.0117 sin ωt through three quarters of a turn, into compression and half out of it.
    let (rate, amplitude, omega, time) = (190.0, 0.0117, 1.47e6, 3.3e-6);
    let (stress, lost) = runge_kutta(rate, time, |t| amplitude * omega * pxfm::f_cos(omega * t));
    let error = |steps: u32| {
        let law = prepared(E0, rate, Update::Exact, time / f64::from(steps));
        let mut run = Run::new(&law);
        for k in 1..=steps {
            run.to(amplitude * pxfm::f_sin(omega * time * f64::from(k) / f64::from(steps)));
        }
        [(run.stress - E0 * run.strain) / stress - 1.0, run.dissipated() / lost - 1.0]
    };
    let (coarse, fine) = (error(200), error(400));
    for i in 0..2 {
        assert!(fine[i].abs() < 2e-4, "{:e}", fine[i]);
        // Order 2: a ratio of 4.
        assert!((coarse[i] / fine[i] - 4.0).abs() < 0.2, "{:e} {:e}", coarse[i], fine[i]);
    }
}

#[test]
fn stored_and_dissipated_energy_are_the_work_of_the_mean_stress() {
    // To rounding of the stress, 50 steps, as long as the arm stays in tension.
    let law = prepared(E0, 190.0, Update::Exact, 0.067e-6);
    let mut run = Run::new(&law);
    for k in 1..=50 {
        run.to(0.0117 * pxfm::f_sin(0.031 * f64::from(k)));
    }
    assert!(run.memory[1] > 0.0);
    assert_relative_eq!(run.energy(), run.work, epsilon = 0.0, max_relative = 1e-13);
}

#[test]
fn nothing_is_gained_in_a_long_step_through_zero() {
    // s/S from 5 to −2, at which it soon stays: the mean stress is positive, the dashpot shortens.
    let rate = 190.0;
    let law = prepared(E0, rate, Update::Exact, 8.0 * STRESS / (E * rate));
    let mut memory = [0.31e6, 5.0 * STRESS];
    law.stress(0.0137, 0.0137 - 30.0 * STRESS / E, &mut memory);
    assert!(memory[1] < -1.9 * STRESS && memory[1] > -2.1 * STRESS);
    assert_eq!(memory[0], 0.31e6);
}

#[test]
fn steady_flow_carries_the_inverse_hyperbolic_sine_of_the_rate() {
    // s = S asinh(ε̇/rate), reached exactly however long the steps. Tolerance: three roundings.
    for (rate, strain_rate, step) in [(190.0, 7.9e3, 11.0e-6), (0.0031, 7.9e3, 3.7e-3)] {
        let law = prepared(0.0, rate, Update::Exact, step);
        let mut run = Run::new(&law);
        (1..40).for_each(|k| _ = run.to(strain_rate * step * f64::from(k)));
        let expected = STRESS * f_asinh(strain_rate / rate);
        // Of the strains only the differences count: 40 roundings of them, divided by s/S.
        assert_relative_eq!(run.stress, expected, epsilon = 0.0, max_relative = 2e-14);
    }
}

#[test]
fn held_stress_flows_at_a_constant_rate() {
    // E∞ = 0: ε = s/E + rate sinh(s/S) t. A constant rate is without error of the step; the tangent
    // finds the strain to rounding. 60 roundings.
    let (rate, stress, step) = (190.0, 217.0e6, 0.37e-6);
    let (sudden, law) =
        (prepared(0.0, rate, Update::Exact, 0.0), prepared(0.0, rate, Update::Exact, step));
    let mut run = Run::new(&sudden);
    run.creep_to(stress);
    run.law = &law;
    (0..60).for_each(|_| _ = run.creep_to(stress));
    let flow = rate * f_sinh(stress / STRESS) * 60.0 * step;
    assert_relative_eq!(run.strain, stress / E + flow, epsilon = 0.0, max_relative = 3e-14);
}

#[test]
fn great_stress_at_a_fixed_viscosity_is_a_maxwell_arm() {
    // rate/stress = 1/(Eτ) with stress → ∞: sinh y = y(1 + y²/6), y ~ 3e-5 leaves 1e-10.
    let arm = Arm { modulus: E, relaxation_time: 0.83e-6 };
    let stress = 7.1e12;
    let (step, exact) = (0.31e-6, Update::Exact);
    let rate = stress / (E * arm.relaxation_time);
    let eyring = Eyring::<f64>::new(E0, E, rate, stress, exact).unwrap().prepared(step);
    let maxwell = Viscoelastic::<f64>::new(E0, &[arm], exact).unwrap().prepared(step);
    let (mut eyring, mut maxwell) = (Run::new(&eyring), Run::new(&maxwell));
    for k in 1..=30 {
        let strain = 0.0119 * pxfm::f_sin(0.29 * f64::from(k));
        eyring.to(strain);
        maxwell.to(strain);
        assert_relative_eq!(eyring.stress, maxwell.stress, epsilon = 1.0, max_relative = 1e-9);
    }
    // The one's loss is the mean stress's, the other's the integral: (ωΔt)²/12 apart, and Δt/τ.
    assert_relative_eq!(eyring.dissipated(), maxwell.dissipated(), max_relative = 0.03);
}

#[test]
fn an_arm_that_hardly_flows_is_a_spring() {
    // rate → 0, s/S up to 17: what flows is below 1e-15 of it.
    let law = prepared(E0, 1e-20, Update::Exact, 0.31e-6);
    let mut run = Run::new(&law);
    for k in 1..=30 {
        let strain = 0.0519 * pxfm::f_sin(0.29 * f64::from(k));
        let stress = run.to(strain);
        // Rounding of the arm's stress, of up to a GPa, in 30 steps.
        assert_relative_eq!(stress, (E0 + E) * strain, epsilon = 1e-5, max_relative = 1e-14);
    }
}

#[test]
fn literal_update_diverges_where_flow_overtakes_it_and_the_exact_one_does_not() {
    // Steps of EΔt × rate × cosh(s/S)/S = 1.9 or 2.3 at the steady flow of s/S = 2.1, disturbed by
    // 1e-3 of a unit. A step multiplies the disturbance by −0.9 or −1.3; in 40 steps by 1e-2 or 4e4,
    // where it has long left the linear range and stays of the order of 1.
    let (rate, y) = (190.0, 2.1_f64);
    let cosh = (1.0 + f_sinh(y) * f_sinh(y)).sqrt();
    for (growth, diverges) in [(1.9, false), (2.3, true)] {
        let step = growth * STRESS / (E * rate * cosh);
        let after = |update: Update| {
            let law = prepared(0.0, rate, update, step);
            let mut memory = [0.0, STRESS * (y + 1e-3)];
            let strain = |k: u32| rate * f_sinh(y) * step * f64::from(k);
            (0..40).for_each(|k| _ = law.stress(strain(k), strain(k + 1), &mut memory));
            (memory[1] / STRESS - y).abs()
        };
        let literal = after(Update::Literal);
        assert_eq!(literal > 0.1, diverges, "{growth}: {literal:e}");
        assert_eq!(literal < 1e-4, !diverges, "{growth}: {literal:e}");
        assert!(after(Update::Exact) < 1e-12, "{growth}");
    }
    // From a jump to s/S = 17 it does not come back at all.
    let law = prepared(0.0, rate, Update::Literal, 1e-6);
    let mut memory = [0.0, 17.0 * STRESS];
    let stress = (0..5).map(|_| law.stress(0.01, 0.01, &mut memory)).last().unwrap();
    assert!(!stress.is_finite());
    let law = prepared(0.0, rate, Update::Exact, 1e-6);
    let mut memory = [0.0, 17.0 * STRESS];
    assert!(law.stress(0.01, 0.01, &mut memory) < 4.0 * STRESS);
}

#[test]
fn slack_strain_is_found_however_far_the_element_has_shortened() {
    // From far below, Newton's rule leaves the bracket on either side: the arm's stress grows as the
    // logarithm of the strain there. Tolerance: what a strain that is off by its last digit carries, and
    // some roundings of the arm's stress.
    for (e0, rate) in [(31.9e9, 190.0), (0.0, 190.0), (0.37e9, 1.9e4), (0.0, 1.9e6)] {
        for (before, stress) in [(0.0137, 17.0), (0.0137, 3.1), (0.41, 0.23)] {
            for (now, step) in [(-0.0093, 0.31e-6), (-0.57, 0.31e-6), (-0.57, 0.013e-6)] {
                let law = prepared(e0, rate, Update::Exact, step);
                let memory = [0.0, stress * STRESS];
                let slack = law.taut_strain(before, now, &memory);
                let rounding =
                    law.tangent_modulus(before, slack, &memory) * before + stress * STRESS;
                let carried = law.carried(before, slack, &memory);
                assert!(carried.abs() < 1e-14 * rounding, "{e0} {rate} {before} {now}: {carried}");
            }
        }
    }
}
