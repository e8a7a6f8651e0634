//! Arms that relax and flow: elements of the march against closed forms, Runge-Kutta and limits.

use crossfibre::material::{Arm, Update};
use crossfibre::number::Number;
use crossfibre::scene::{Law, Material, Scene, Strain};
use crossfibre::state::{State, Wavefront};

use crate::cases::support::{
    Marched, check, marched_from, measured_by, relative, shipped, watched,
};
use crate::cases::{Bound, Check};
use crate::planted::at_impact;
use crate::worse::worse;

/// How far a held fibre is stretched.
const HELD: f64 = 0.0137;

/// Two elements, stretched as the march begins and held: their stresses after each step, Pa.
///
/// The law goes from no strain to that of the stretched fibre in the first step.
fn held(law: Law, steps: f64) -> (Vec<f64>, State<f64>) {
    let mut scene = measured_by(Strain::Engineering, shipped("viscoelastic"));
    (scene.secondary, scene.projectile.mass) = (None, None);
    (scene.primary.elements, scene.primary.length) = (2, 0.00413);
    scene.primary.material = law.into();
    let at_rest = at_impact::<f64>(&scene, Wavefront::Ignored);
    scene.duration = steps * at_rest.time_step;
    let stretch = |state: &mut State<f64>| {
        state.projectile.velocity = 0.0;
        for x in &mut state.primary.position {
            *x *= 1.0 + HELD;
        }
    };
    let mut stresses = Vec::new();
    let run = watched(scene.clone(), Wavefront::Ignored, &stretch, |state| {
        stresses.push(state.primary.tension[0] / scene.primary.area);
    });
    assert!(run.outcome.is_completed(), "{}", run.outcome);
    (stresses, run.state)
}

/// Held fibres that relax, and an Eyring element that is driven by waves.
pub fn held_and_driven() -> Vec<Check> {
    vec![
        check(
            "Held at 1.37 %, two arms and a spring relax over 3000 steps",
            "closed form of a ramp of one step, then Σ exp(-t/τ)",
            "greatest relative error of the stress in any step",
            relaxation(),
            Bound::AtMost(1e-14),
            "rounding of the strain, 1e-16 of 1.37 %",
        ),
        check(
            "Held, an Eyring arm relaxes over 3000 steps",
            "tanh(s/2S) falls as exp(-E rate t/S), from the first step on",
            "greatest relative error of tanh(s/2S)",
            eyring_relaxation(),
            Bound::AtMost(2e-9),
            "the arm's stress is a difference from the spring's, 2e8 Pa rounded by 3e-8, and at the end \
             it is 50 Pa",
        ),
        check(
            "An Eyring element of a struck fibre, through front and kink",
            "Runge-Kutta of order 4 along the element's own strain, 400 steps to each of the march",
            "greatest error of the stress over the greatest stress",
            eyring_driven(),
            Bound::AtMost(2e-14),
            "rounding: the update is exact for a strain that changes linearly over a step, and \
             Runge-Kutta is at 1/400 of it",
        ),
    ]
}

fn relaxation() -> f64 {
    let (spring, arms) = (23.7e9, [(31.9e9, 47.3e-6), (11.3e9, 613.0e-6)]);
    let law = Law::Viscoelastic {
        equilibrium_modulus: spring,
        arms: arms.map(|(modulus, relaxation_time)| Arm { modulus, relaxation_time }).into(),
        update: Update::Exact,
    };
    let (stresses, state) = held(law, 3000.0);
    let expected = |n: usize| {
        arms.iter().fold(spring * HELD, |sum, (modulus, relaxation_time)| {
            let x = state.time_step / relaxation_time;
            let ramp = -Number::exp_m1(-x) / x;
            sum + modulus * HELD * ramp * Number::exp(-x * n as f64)
        })
    };
    let apart = stresses.iter().enumerate().map(|(n, &stress)| relative(stress, expected(n)));
    apart.fold(0.0, worse)
}

fn eyring_relaxation() -> f64 {
    let (spring, modulus, rate, flow) = (13.7e9, 57.6e9, 17.3, 57e6);
    let law = Law::Eyring {
        equilibrium_modulus: spring,
        modulus,
        rate,
        stress: flow,
        update: Update::Exact,
    };
    let (stresses, state) = held(law, 3000.0);
    let strain = state.primary.strain[0];
    // tanh(y/2) = (exp y - 1)/(exp y + 1).
    let tanh = |stress: f64| {
        let y = (stress - spring * strain) / flow;
        Number::exp_m1(y) / (Number::exp(y) + 1.0)
    };
    let first = tanh(stresses[0]);
    let decay = modulus * rate / flow * state.time_step;
    let apart = stresses
        .iter()
        .enumerate()
        .map(|(n, &stress)| relative(tanh(stress), first * Number::exp(-decay * n as f64)));
    apart.fold(0.0, worse)
}

/// The greatest error of an element's stress in the shipped scene.
fn eyring_driven() -> f64 {
    let scene = shipped("eyring");
    let Law::Eyring { equilibrium_modulus, modulus, rate, stress: flow, .. } =
        scene.primary.material.law
    else {
        panic!("the scene is of an Eyring law")
    };
    let area = scene.primary.area;
    let (mut before, mut arm) = (0.0, 0.0);
    let (mut worst, mut greatest) = (0.0_f64, 0.0_f64);
    watched(scene, Wavefront::Flagged, &|_| {}, |state| {
        let now = state.primary.strain[ELEMENT];
        let strain_rate = (now - before) / state.time_step;
        let slope = |s: f64| {
            let y = s / flow;
            let sinh = 0.5 * (Number::exp_m1(y) - Number::exp_m1(-y));
            modulus * (strain_rate - rate * sinh)
        };
        let h = state.time_step / 400.0;
        for _ in 0..400 {
            arm += runge_kutta(slope, arm, h);
        }
        let stress = state.primary.tension[ELEMENT] / area;
        worst = worse(worst, (stress - (equilibrium_modulus * now + arm)).abs());
        greatest = greatest.max(stress);
        before = now;
    });
    worst / greatest
}

/// An element that front and kink have both passed at the end.
const ELEMENT: usize = 5;

/// What y gains in a step h of y′ = f(y), by the classical method of order 4.
fn runge_kutta(f: impl Fn(f64) -> f64, y: f64, h: f64) -> f64 {
    let k1 = f(y);
    let k2 = f(y + 0.5 * h * k1);
    let k3 = f(y + 0.5 * h * k2);
    let k4 = f(y + h * k3);
    h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
}

/// The shipped scene without its crossing fibre and the projectile's mass, its arms with relaxation
/// times of so many time steps.
fn relaxing_in(time_steps: f64, update: Update, courant: f64) -> Scene {
    let mut scene = shipped("viscoelastic");
    (scene.secondary, scene.projectile.mass, scene.courant) = (None, None, courant);
    let time_step = at_impact::<f64>(&scene, Wavefront::Flagged).time_step;
    if let Law::Viscoelastic { arms, update: chosen, .. } = &mut scene.primary.material.law {
        arms.iter_mut().for_each(|arm| arm.relaxation_time = time_steps * time_step);
        *chosen = update;
    }
    scene
}

/// The same fibre of eqn (7) with another modulus, and the same time step.
fn linear(modulus: f64) -> Scene {
    let mut scene = relaxing_in(1.0, Update::Exact, 0.937);
    let glassy = scene.primary.material.instantaneous_modulus();
    scene.primary.material = Material::linear(modulus);
    scene.courant *= (modulus / glassy).sqrt();
    scene
}

/// Greatest difference of strain over the greatest strain.
fn apart(a: &Marched, b: &Marched) -> f64 {
    let (a, b) = (&a.state.primary.strain, &b.state.primary.strain);
    let greatest = b.iter().fold(0.0_f64, |most, &e| most.max(e.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, worse) / greatest
}

/// Δt/τ from which on forward differences are unstable in a fibre of a spring and arms of one τ.
///
/// Of the highest mode, u ∝ gⁿ with g = −1: an arm answers with 2z₁/(2 − Δt/τ), z₁ = 4α²E₁/E₀, where a
/// spring answers with 4α²E∞/E₀, and the two have to be 4.
fn literal_limit(scene: &Scene) -> f64 {
    let glassy = scene.primary.material.instantaneous_modulus();
    let Law::Viscoelastic { equilibrium_modulus, .. } = scene.primary.material.law else {
        panic!("the scene is of a viscoelastic law")
    };
    let spring = equilibrium_modulus / glassy;
    2.0 - 2.0 * (1.0 - spring) / (1.0 / (scene.courant * scene.courant) - spring)
}

/// Whether the shipped fibre, at α = 0.5, completes by forward differences.
fn literal_completes(x: impl Fn(&Scene) -> f64) -> f64 {
    let scene = relaxing_in(1.0, Update::Literal, 0.5);
    let scene = relaxing_in(1.0 / x(&scene), Update::Literal, 0.5);
    f64::from(u8::from(crate::planted::run(&scene, |_| ()).outcome.is_completed()))
}

/// Times far from the time step, and the literal update beyond its limit.
pub fn stiff() -> Vec<Check> {
    let run = |scene| marched_from(scene, Wavefront::Ignored, &|_| {});
    let [short, long] = [1e-6, 1e6].map(|times| run(relaxing_in(times, Update::Exact, 0.937)));
    let limit =
        "least Δt/τ at which the highest mode of the linear scheme does not decay, 1.75 here";
    vec![
        check(
            "τ = 1e-6 Δt: the wave of the equilibrium modulus",
            "the march of eqn (7) with E∞ and the same Δt",
            "greatest difference of strain over the greatest strain",
            apart(&short, &run(linear(41.3e9))),
            Bound::AtMost(5e-6),
            "the arms lag by τ, and carry E τ/Δt times what the strain gains in a step",
        ),
        check(
            "τ = 1e6 Δt: the wave of the instantaneous modulus",
            "the march of eqn (7) with E₀ and the same Δt",
            "greatest difference of strain over the greatest strain",
            apart(&long, &run(linear(71.3e9))),
            Bound::AtMost(2e-4),
            "in 100 steps the arms lose 1e-4 of their stress",
        ),
        check(
            "Forward differences complete at 0.9 of their limit, α = 0.5",
            limit,
            "1 if the run completes",
            literal_completes(|scene| 0.9 * literal_limit(scene)),
            Bound::Exactly(1.0),
            "growth by less than one a step",
        ),
        check(
            "and at 1.1 of it they do not",
            limit,
            "1 if the run completes",
            literal_completes(|scene| 1.1 * literal_limit(scene)),
            Bound::Exactly(0.0),
            "213 steps of growth; below the element's own limit, Δt = 2 τ",
        ),
        check(
            "nor at Δt = 2.3 τ, where an element by itself diverges",
            "typed outcome; the exact update completes at Δt = 1e6 τ",
            "1 if the run completes",
            literal_completes(|_| 2.3),
            Bound::Exactly(0.0),
            "what is stored and what is 'dissipated' cancel: the residual alone would not tell",
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The condition as its derivation has it: springs and arms of the highest mode are 4 together, at
    /// any Courant number.
    #[test]
    fn at_the_literal_limit_springs_and_arms_of_the_highest_mode_make_four() {
        let spring = 41.3 / 71.3;
        for courant in [0.5, 0.37, 0.83] {
            let x = literal_limit(&relaxing_in(1.0, Update::Literal, courant));
            let of = |share: f64| 4.0 * courant * courant * share;
            let sum = of(spring) + 2.0 * of(1.0 - spring) / (2.0 - x);
            assert!((sum / 4.0 - 1.0).abs() < 1e-12, "{courant} {x} {sum}");
        }
    }
}
