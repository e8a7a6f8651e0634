//! Axial motion with engineering strain, where the scheme is linear: d'Alembert, dispersion, (19).

use crossfibre::errata::Corrections;
use crossfibre::exact::dalembert;
use crossfibre::number::{Number, Vector};
use crossfibre::paper::Paper;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

use super::support::{check, measured_by, shipped};
use super::{Bound, Case, Check};
use crate::oracle::{frequency, mesh_strain, mesh_velocity};
use crate::planted::{self, Edition, at_impact};
use crate::worse::worse;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case {
        id: "axial.impact",
        title: "Axial impact at α = 1: the scheme is d'Alembert's solution",
        equations: &[2, 6, 7],
        run: impact,
    },
    Case {
        id: "axial.dispersion",
        title: "Standing waves at α = 0.5, 0.9 and 1 against the dispersion relation",
        equations: &[2, 6, 7, 20],
        run: standing_waves,
    },
    Case {
        id: "axial.wave-equation",
        title: "Second differences satisfy the wave equation (19)",
        equations: &[2, 6, 7, 19],
        run: wave_equation,
    },
];

const ELEMENTS: usize = 64;

/// A single fibre of the paper's material with few elements and engineering strain.
pub fn linear_scene(courant: f64) -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("single-400"));
    scene.primary.elements = ELEMENTS;
    scene.courant = courant;
    scene
}

/// Corrections do not touch a single fibre without a projectile mass.
pub fn edition() -> Edition {
    planted::edition(Strain::Engineering, Corrections::ALL)
}

/// A fibre whose ends are held and whose nodes start with axial velocities.
pub fn held(scene: &Scene, velocity: impl Fn(usize) -> f64) -> State<f64> {
    let mut state = at_impact(scene, Wavefront::Ignored);
    state.projectile.velocity = 0.0;
    for (i, v) in state.primary.velocity.iter_mut().enumerate() {
        v.x = velocity(i);
    }
    state
}

fn impact() -> Vec<Check> {
    let scene = linear_scene(1.0);
    let mut state = at_impact::<f64>(&scene, Wavefront::Flagged);
    let speed = 37.3;
    state.projectile.axis = Vector::<f64, 2>::new(-1.0, 0.0);
    state.projectile.velocity = speed;
    let mesh = dalembert::Mesh { elements: ELEMENTS };
    let unit = speed / state.primary.properties.wave_speed;
    let (mut strain, mut velocity) = (0.0_f64, 0.0_f64);
    let steps = 5 * ELEMENTS;
    // Five passages: the strain has been raised by two reflections at either end.
    planted::march::run(&edition(), &mut state, steps as u64, |state| {
        let step = state.step as usize;
        for (e, &measured) in state.primary.strain.iter().enumerate() {
            strain = worse(strain, (measured / unit - mesh_strain(mesh, e, step) as f64).abs());
        }
        for (i, measured) in state.primary.velocity.iter().enumerate() {
            velocity =
                worse(velocity, (-measured.x / speed - mesh_velocity(mesh, i, step) as f64).abs());
        }
    });
    let oracle = "d'Alembert's solution by the method of images, reflections included";
    let reason = "rounding: a position of 0.3 m is rounded by 3e-17 m, which is 1e-12 of V/c of an \
                  element; it adds up as the square root of 320 steps";
    vec![
        check(
            "Every strain is a whole multiple of V/c, over five passages of the fibre",
            oracle,
            "greatest difference in units of V/c",
            strain,
            Bound::AtMost(1e-10),
            reason,
        ),
        check(
            "Every velocity is 0 or V",
            oracle,
            "greatest difference in units of V",
            velocity,
            Bound::AtMost(1e-10),
            reason,
        ),
    ]
}

fn standing_waves() -> Vec<Check> {
    [0.5, 0.9, 1.0]
        .into_iter()
        .map(|courant| {
            let scene = linear_scene(courant);
            let worst = [1, 7, 31, 62].map(|mode| standing_wave(&scene, mode)).into_iter();
            check(
                format!("At α = {courant} a standing wave oscillates at the scheme's own frequency"),
                "sin(ωΔt/2) = α sin(kΔx/2)",
                "greatest difference over 1000 steps and modes 1, 7, 31, 62 of 64, in amplitudes",
                worst.fold(0.0, worse),
                Bound::AtMost(1e-10),
                "rounding: a position of 0.3 m is rounded by 6e-13 of the amplitude, a hundredth of \
                 an element; it adds up as the square root of 1000 steps",
            )
        })
        .collect()
}

/// Greatest departure of any node in any step from x = C sin(ωjΔt) sin(kiΔx), in units of C.
fn standing_wave(scene: &Scene, mode: usize) -> f64 {
    let pi = std::f64::consts::PI;
    let phase = pi * mode as f64 / ELEMENTS as f64;
    let shape = |i: usize| Number::sin(phase * i as f64);
    let state = at_impact::<f64>(scene, Wavefront::Ignored);
    let (dx, dt) = (state.primary.properties.spacing, state.time_step);
    let omega = frequency(phase / dx, dx, dt, scene.courant).expect("no mode grows at α ≤ 1");
    let amplitude = 1e-2 * dx;
    let first = amplitude * Number::sin(omega * dt) / dt;
    let mut state = held(scene, |i| first * shape(i));
    let rest = state.primary.position.clone();
    let mut worst = 0.0_f64;
    planted::march::run(&edition(), &mut state, 1000, |state| {
        let wave = amplitude * Number::sin(omega * dt * state.step as f64);
        for (i, (now, rest)) in state.primary.position.iter().zip(&rest).enumerate() {
            let expected = wave * if i == ELEMENTS { 0.0 } else { shape(i) };
            worst = worse(worst, ((now.x - rest.x - expected) / amplitude).abs());
        }
    });
    worst
}

fn wave_equation() -> Vec<Check> {
    let scene = linear_scene(0.83);
    let pi = std::f64::consts::PI;
    let bump = |i: usize| 3.1 * Number::sin(pi * i as f64 / ELEMENTS as f64);
    let mut state = held(&scene, bump);
    let mut history = vec![state.primary.position.clone()];
    planted::march::run(&edition(), &mut state, 60, |state| {
        history.push(state.primary.position.clone())
    });
    let properties = state.primary.properties;
    let (dx, dt) = (properties.spacing, state.time_step);
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for levels in history.windows(3) {
        let [before, now, after] = levels else { continue };
        for i in 1..ELEMENTS {
            let u = |level: &[Vector<f64, 2>], i: usize| level[i].x - history[0][i].x;
            let acceleration = (u(after, i) - 2.0 * u(now, i) + u(before, i)) / (dt * dt);
            let curvature = (u(now, i + 1) - 2.0 * u(now, i) + u(now, i - 1)) / (dx * dx);
            let expected =
                Paper::<f64>::eqn_19_acceleration(&edition(), properties.wave_speed, curvature);
            worst = worse(worst, (acceleration - expected).abs());
            largest = worse(largest, expected.abs());
        }
    }
    vec![check(
        "Central differences in time and space satisfy ∂²u/∂t² = c² ∂²u/∂x²",
        "(19), which the march does not use",
        "greatest difference over the greatest acceleration",
        worst / largest,
        Bound::AtMost(4e-9),
        "rounding: second differences of displacements of 1e-6 m on positions of 0.3 m",
    )]
}
