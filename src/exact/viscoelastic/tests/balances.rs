//! What any solution must conserve, by quadrature of the states.

use super::*;

/// ∫ f dx over the moving part of the rod at time t, in parts that end at these shares of the way of
/// the front. An arm that relaxes at once has a thin layer where the front of the others is, which
/// may be a thousandth of a part: the substitution u³(10 − 15u + 6u²) looks closer at both ends.
fn along(rod: &PulledRod, t: f64, layers: &[f64], f: impl Fn(RodState) -> f64) -> f64 {
    let ends = layers.iter().copied().chain([1.0]);
    let part = |from: &mut f64, to: f64| {
        let from = std::mem::replace(from, to);
        let reach = rod.front_speed() * t;
        Some(integral(0.0, 1.0, &|u| {
            let share = from + (to - from) * u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u);
            let slope = (to - from) * 30.0 * (u * (1.0 - u)).powi(2);
            reach * slope * f(rod.at(share * reach, t).unwrap())
        }))
    };
    ends.scan(0.0, part).sum()
}

/// ∫ f dt at the end, from 0 to t. The substitution t u⁶ finds the first relaxation of a fast arm,
/// which may be over within a millionth of t.
fn at_end(rod: &PulledRod, t: f64, f: impl Fn(RodState) -> f64) -> f64 {
    6.0 * t * integral(0.0, 1.0, &|u| u.powi(5) * f(rod.at(0.0, t * u.powi(6)).unwrap()))
}

/// The parts by which strain misses the pulled length, and momentum the impulse of the end.
pub(super) fn unbalanced(rod: &PulledRod, density: f64, t: f64, layers: &[f64]) -> (f64, f64) {
    let length = along(rod, t, layers, |state| state.strain) / (VELOCITY * t) - 1.0;
    let momentum = density * along(rod, t, layers, |state| state.velocity);
    (length.abs(), (momentum / at_end(rod, t, |state| state.stress) - 1.0).abs())
}

#[test]
fn strain_makes_the_length_and_the_end_makes_the_momentum() {
    // Tolerance: rounding; the quadrature stops at an error of 1e-15 once two halves agree in 1e-12.
    for (rod, density, times) in [
        (solid(), 1390.0, [1.9e-6, 2.7e-5, 3.1e-4]),
        (three_arms(), 970.0, [1.1e-6, 5.3e-5, 1.7e-3]),
        (fluid(), 970.0, [1.1e-6, 5.3e-5, 1.7e-3]),
    ] {
        for t in times {
            let (length, momentum) = unbalanced(&rod, density, t, &[]);
            assert!(length < 1e-14 && momentum < 1e-14, "{t}: {length:e} {momentum:e}");
        }
    }
}

#[test]
fn work_of_the_end_is_kinetic_stored_or_dissipated() {
    // The arm's stress is σ − E∞ε; its dashpot takes σ₁²/(E₁τ), here 4 to 28 % of the work.
    // Tolerance: as above.
    let (density, spring, modulus, relaxation_time) = (1390.0, 3.1e9, 5.7e9, 1.3e-5);
    let rod = solid();
    let in_arm = |state: RodState| state.stress - spring * state.strain;
    for t in [1.9e-6, 2.7e-5, 1.1e-4] {
        let work = at_end(&rod, t, |state| state.stress * VELOCITY);
        let energy = along(&rod, t, &[], |state| {
            let RodState { strain, velocity, .. } = state;
            let arm = in_arm(state);
            0.5 * (density * velocity * velocity + spring * strain * strain + arm * arm / modulus)
        });
        let dissipated = integral(0.0, t, &|t| {
            along(&rod, t, &[], |state| in_arm(state) * in_arm(state)) / (modulus * relaxation_time)
        });
        let error = (energy + dissipated) / work - 1.0;
        assert!(error.abs() < 1e-14, "{t}: {error:e}");
    }
}
