use approx::assert_relative_eq;

use super::super::tests::Run;
use super::super::{Arm, Linear, Polynomial, TensionOnly, Update, Viscoelastic};
use super::*;

const E: f64 = 58.6e9;
const MESH: Mesh = Mesh { density: 1206.7, spacing: 0.47e-3 };

fn viscous(linear: f64, quadratic: f64) -> ArtificialViscosity<Linear<f64>, f64> {
    let coefficients = Coefficients { linear, quadratic };
    ArtificialViscosity::new(Linear::new(E).unwrap(), MESH, coefficients).unwrap()
}

fn wave_speed() -> f64 {
    (E / MESH.density).sqrt()
}

#[test]
fn viscous_stress_is_its_formula_in_extension_and_in_contraction() {
    // Of ε̇ = 3.1e4 and −2.3e4 per second. Tolerance: rounding of the strain difference, 1e-14.
    let (c, dx, rho, step) = (wave_speed(), MESH.spacing, MESH.density, 0.041e-6);
    let law = viscous(0.13, 1.9).prepared(step);
    let mut run = Run::new(&law);
    let mut dissipated = 0.0;
    for rate in [3.1e4_f64, -2.3e4] {
        let strain = run.strain + rate * step;
        let stress = run.to(strain) - E * strain;
        let expected = rho * dx * (0.13 * c + 1.9 * dx * rate.abs()) * rate;
        assert_relative_eq!(stress, expected, epsilon = 0.0, max_relative = 3e-13);
        // q is constant over the step: its work is q × Δε, never negative.
        dissipated += expected * rate * step;
        assert_relative_eq!(run.dissipated(), dissipated, epsilon = 0.0, max_relative = 3e-13);
    }
    // The stored energy is that of the law.
    assert_relative_eq!(
        law.stored(run.strain, &run.memory),
        0.5 * E * run.strain * run.strain,
        max_relative = 1e-15
    );
}

/// Greatest growth per step of small disturbances of a chain with fixed ends, α = cΔt/Δx, strained
/// at a rate: u_j ← u_j + v_jΔt, v_j ← v_j + (T_{j+1} − T_j)Δt/(ρΔx).
fn growth(law: &ArtificialViscosity<Linear<f64>, f64>, courant: f64, strain_rate: f64) -> f64 {
    const ELEMENTS: usize = 16;
    let step = courant * MESH.spacing / wave_speed();
    let law = law.prepared(step);
    let push = step / (MESH.density * MESH.spacing);
    // A uniform strain rate stretches the chain; the disturbance is far below it.
    let mut u = [0.0; ELEMENTS + 1];
    let mut v: [f64; ELEMENTS + 1] = std::array::from_fn(|j| strain_rate * MESH.spacing * j as f64);
    let uniform = v;
    for (j, v) in v.iter_mut().enumerate().skip(1).take(ELEMENTS - 1) {
        *v += 1e-6 * (if j % 2 == 0 { 1.0 } else { -1.0 } + 0.1 * (j * j % 7) as f64);
    }
    let mut memories = [[0.0; 1]; ELEMENTS];
    let mut strain = [0.0; ELEMENTS];
    let size = |v: &[f64; ELEMENTS + 1]| {
        v.iter().zip(&uniform).map(|(v, w)| (v - w) * (v - w)).sum::<f64>().sqrt()
    };
    let (mut middle, steps) = (0.0, 600);
    for k in 0..steps {
        (0..=ELEMENTS).for_each(|j| u[j] += v[j] * step);
        let stress: [f64; ELEMENTS] = std::array::from_fn(|j| {
            let now = (u[j + 1] - u[j]) / MESH.spacing;
            let stress = law.stress(strain[j], now, &mut memories[j]);
            strain[j] = now;
            stress
        });
        (1..ELEMENTS).for_each(|j| v[j] += push * (stress[j] - stress[j - 1]));
        if k == steps / 2 {
            middle = size(&v);
        }
    }
    pxfm::f_pow(size(&v) / middle, 2.0 / f64::from(steps))
}

#[test]
fn greatest_courant_number_is_where_a_chain_begins_to_diverge() {
    // 2 % either side of it. The highest mode of 16 elements between fixed ends has
    // sin²(kΔx/2) = 0.9904, which shifts the limit by less than 0.5 %.
    for (linear, quadratic, rate) in [(0.13, 0.0, 0.0), (0.61, 0.0, 0.0), (0.061, 1.9, 4.1e5)] {
        let law = viscous(linear, quadratic);
        let limit = law.greatest_courant(rate);
        let (below, above) = (growth(&law, 0.98 * limit, rate), growth(&law, 1.02 * limit, rate));
        assert!(below < 1.0, "{linear} {quadratic}: {below}");
        // Quadratic viscosity that diverges soon overflows.
        assert!(above > 1.01 || above.is_nan(), "{linear} {quadratic}: {above}");
    }
    // √(1 + ζ²) − ζ at ζ = 0.13, to 16 digits; without viscosity the paper's α = 1.
    assert_relative_eq!(
        viscous(0.13, 0.0).greatest_courant(3.1e4),
        0.8784145972763385,
        max_relative = 3e-16
    );
    assert_eq!(viscous(0.0, 0.0).greatest_courant(3.1e4), 1.0);
    // At rest the quadratic part is nothing.
    let at_rest = Coefficients { linear: 0.13, quadratic: 1.9 }.greatest_courant_at_rest();
    assert_eq!(at_rest, viscous(0.13, 0.0).greatest_courant(3.1e4));
}

#[test]
fn slack_fibre_has_no_viscous_stress_and_none_ever_pushes() {
    let coefficients = Coefficients { linear: 0.61, quadratic: 1.9 };
    let inner = TensionOnly::new(Linear::<f64>::new(E).unwrap());
    let law = ArtificialViscosity::new(inner, MESH, coefficients).unwrap().prepared(0.041e-6);
    let mut run = Run::new(&law);
    // Slack and lengthening, slack and shortening: nothing.
    for strain in [-0.0131, -0.0017, -0.0223] {
        assert_eq!((run.to(strain), run.energy()), (0.0, 0.0));
    }
    // Taut and lengthening: more than the law alone. Taut and shortening fast: no less than zero,
    // and what was put in is all dissipated or stored.
    assert!(run.to(0.0137) > E * 0.0137);
    let dissipated = run.dissipated();
    assert_eq!(run.to(0.0011), 0.0);
    assert!(run.dissipated() > dissipated);
}

#[test]
fn wave_speed_stays_that_of_the_material() {
    assert_eq!(viscous(0.61, 1.9).prepared(0.041e-6).instantaneous_modulus(0.0137, &[0.0]), E);
}

#[test]
fn a_step_is_bounded_by_the_viscous_slope_as_well_where_the_fibre_is_taut() {
    // M = E + 2 dq/dε; where the fibre is slack there is neither.
    let (step, coefficients) = (0.041e-6, Coefficients { linear: 0.61, quadratic: 1.9 });
    let inner = TensionOnly::new(Linear::<f64>::new(E).unwrap());
    let law = ArtificialViscosity::new(inner, MESH, coefficients).unwrap().prepared(step);
    let mut run = Run::new(&law);
    run.to(0.0051);
    run.to(0.0137);
    let bears_both = viscous(0.61, 1.9).prepared(step);
    let taut = law.step_modulus(0.0051, 0.0137, &run.memory);
    assert_eq!(taut, bears_both.step_modulus(0.0051, 0.0137, &[0.0]));
    let slope = law.tangent_modulus(0.0051, 0.0137, &run.memory) - E;
    assert_relative_eq!(taut, E + 2.0 * slope, max_relative = 1e-15);
    assert!(slope > 0.1 * E);
    run.to(-0.0017);
    assert_eq!(law.step_modulus(0.0137, -0.0017, &run.memory), 0.0);
    // A law that bears compression is not slack where it has no modulus, as ε − ε² at one half.
    let top = Polynomial::<f64>::new(&[1e9, -1e9]).unwrap();
    let law = ArtificialViscosity::new(top, MESH, coefficients).unwrap().prepared(step);
    assert_eq!(law.instantaneous_modulus(0.5, &[0.0]), 0.0);
    assert!(law.step_modulus(0.25, 0.5, &[0.0]) > 1e9);
}

#[test]
fn without_coefficients_it_is_the_law_within() {
    let none = Coefficients { linear: 0.0, quadratic: 0.0 };
    let arms = [Arm { modulus: 17.3e9, relaxation_time: 0.43e-6 }];
    let within = Viscoelastic::<f64>::new(31.9e9, &arms, Update::Exact).unwrap();
    let around = ArtificialViscosity::new(within.clone(), MESH, none).unwrap().prepared(0.041e-6);
    let within = within.prepared(0.041e-6);
    let (mut alone, mut wrapped) = (Run::new(&within), Run::new(&around));
    for strain in [0.0137, 0.0091, -0.0033] {
        assert_eq!(wrapped.to(strain), alone.to(strain));
        assert_eq!(wrapped.dissipated(), alone.dissipated());
    }
    assert!(alone.dissipated() > 0.0);
}
