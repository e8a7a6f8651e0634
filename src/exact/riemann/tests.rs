use nalgebra::Rotation3;
use proptest::prelude::*;
use pxfm::f_exp10;

use super::super::elastic::Hyperelastic;
use super::super::quadrature::integral;
use super::super::smith::{Fibre, Law, Strain, smith};
use super::*;

mod ends;
mod joints;
mod uniqueness;

const LAWS: [Law; 2] = [Law::Engineering, Law::Logarithmic];
const ARAMID: Fibre = Fibre { modulus: 58.6e9, density: 1206.7, area: 1.37e-8 };

fn elastic(law: Law, fibre: Fibre) -> Hyperelastic {
    Hyperelastic { law, fibre }
}

/// c of a material.
fn sound(m: &Hyperelastic) -> f64 {
    (m.fibre.modulus / m.fibre.density).sqrt()
}

/// T/E, written out here.
fn tension(law: Law, strain: f64) -> f64 {
    match law {
        Law::Engineering => strain,
        Law::Logarithmic => pxfm::f_log1p(strain),
    }
}

fn rest(direction: Vector3<f64>) -> State {
    State { strain: 0.0, direction, velocity: Vector3::zeros() }
}

/// A fibre, its law by `logarithmic`, from ratios in decades to [`ARAMID`].
fn fibre((modulus, density, area): (f64, f64, f64)) -> Fibre {
    Fibre {
        modulus: ARAMID.modulus * f_exp10(modulus),
        density: ARAMID.density * f_exp10(density),
        area: ARAMID.area * f_exp10(area),
    }
}

prop_compose! {
    /// Modulus ratio 1e-4…1e4, density ratio 1e-3…1e3, area ratio 1e-2…1e2, in decades.
    fn ratios()(m in -4.0..4.0_f64, d in -3.0..3.0_f64, a in -2.0..2.0_f64) -> (f64, f64, f64) {
        (m, d, a)
    }
}

prop_compose! {
    fn unit()(x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in -1.0..1.0_f64) -> Vector3<f64> {
        (Vector3::new(x, y, z) + Vector3::new(0.0, 0.0, 1.3e-3)).normalize()
    }
}

prop_compose! {
    /// A velocity of 1e-7 to 1.5 (in units of c), evenly in the logarithm, in any direction.
    fn speed()(decades in -7.0..0.176_f64, t in unit()) -> Vector3<f64> {
        t * f_exp10(decades)
    }
}

prop_compose! {
    /// A taut, moving piece: strain 1e-6…0.1, velocity in units of c.
    fn taut()(decades in -6.0..-1.0_f64, direction in unit(), velocity in speed()) -> State {
        State { strain: f_exp10(decades), direction, velocity }
    }
}

fn times(state: State, c: f64) -> State {
    State { velocity: state.velocity * c, ..state }
}

/// In the x–y plane.
fn flat(state: State) -> State {
    let flat = |v: Vector3<f64>| Vector3::new(v.x, v.y, 0.0);
    State {
        direction: (flat(state.direction) + Vector3::new(1.1e-3, 0.0, 0.0)).normalize(),
        velocity: flat(state.velocity),
        ..state
    }
}

/// Asserts |a − b| ≤ tolerance·scale.
#[track_caller]
fn close(name: &str, a: Vector3<f64>, b: Vector3<f64>, tolerance: f64, scale: f64) {
    let error = (a - b).norm();
    assert!(error <= tolerance * scale, "{name}: {a:?} {b:?} differ by {:e}", error / scale);
}

/// All that the waves of an arm must satisfy, written out from the equations of motion.
///
/// [v] = −s[λt] and ρs[v] = −[Tt] at every jump, which travels at s along t. Norm: relative to
/// the greatest velocity in the arm, including c√ε (of which a kink's velocities are made).
#[track_caller]
fn assert_waves(m: &Hyperelastic, arm: &Arm, velocity: Vector3<f64>, tolerance: f64) {
    let Arm { ahead, between, behind } = *arm;
    let (c, law) = (sound(m), m.law);
    let scale = c * between.strain.max(ahead.strain).sqrt()
        + (velocity - ahead.velocity).norm()
        + ahead.velocity.norm();
    let close = |name, a, b| close(name, a, b, tolerance, scale);
    assert!(between.strain >= 0.0 && between.strain == behind.strain, "{arm:?}");
    assert_eq!(ahead.direction, between.direction);
    assert!((behind.direction.norm() - 1.0).abs() < 4.0 * f64::EPSILON, "{arm:?}");
    close("joint", behind.velocity, velocity);
    // The longitudinal wave.
    let t = ahead.direction;
    let gained = between.velocity - ahead.velocity;
    let (from, to) = (ahead.strain, between.strain);
    match law {
        Law::Engineering => {
            close("continuity and momentum", -gained, -t * (c * (from - to)));
            // [T]/ρs with T/ρ = c²ε and s = c: the same numbers.
        }
        Law::Logarithmic if to >= from => {
            let w = integral(from, to, |s| c / (1.0 + s).sqrt());
            close("fan", gained, -t * w);
        }
        Law::Logarithmic => {
            // Of [v] = −s[λ] and ρs[v] = −[T], s² and with it the jump of velocity.
            let s = c * ((tension(law, from) - tension(law, to)) / (from - to)).sqrt();
            // The quotient loses the digits of a weak shock, but s then is multiplied by little.
            let s = if s.is_finite() { s } else { c };
            let lost = 4.0 * f64::EPSILON * c;
            assert!((gained - t * (s * (from - to))).norm() <= tolerance * scale + lost);
        }
    }
    // The kink.
    let u = c * (tension(law, to) / (1.0 + to)).sqrt();
    let ahead_of_joint = between.velocity - behind.velocity;
    let turn = between.direction - behind.direction;
    close("kink, continuity", ahead_of_joint, -turn * (u * (1.0 + to)));
    if u > 0.0 {
        let pull = c * c * tension(law, to);
        close("kink, momentum", ahead_of_joint, -turn * (pull / u));
    }
}

/// Growth per unit time of ∫f dX over an arm, less what f would be if nothing happened: f is
/// integrated over the rays X/t of the waves, over fans with λ = (c/ξ)² λ₀-free form.
fn growth(m: &Hyperelastic, arm: &Arm, f: &dyn Fn(f64, Vector3<f64>) -> f64) -> f64 {
    let Arm { ahead, between, behind } = *arm;
    let (c, law) = (sound(m), m.law);
    let (from, to) = (ahead.strain, between.strain);
    let u = c * (tension(law, to) / (1.0 + to)).sqrt();
    let t = ahead.direction;
    let of = |s: &State| f(s.strain, s.velocity);
    let kink = of(&behind) * u;
    match law {
        Law::Engineering => kink + of(&between) * (c - u) - of(&ahead) * c,
        Law::Logarithmic if to < from => {
            let s = c * ((tension(law, from) - tension(law, to)) / (from - to)).sqrt();
            kink + of(&between) * (s - u) - of(&ahead) * s
        }
        Law::Logarithmic => {
            let (fast, slow) = (c / (1.0 + from).sqrt(), c / (1.0 + to).sqrt());
            let fan = integral(slow, fast, |ray| {
                let stretch = (c / ray) * (c / ray);
                let inflow = 2.0 * c * (c / ray - c / fast);
                f(stretch - 1.0, ahead.velocity - t * inflow)
            });
            kink + of(&between) * (slow - u) + fan - of(&ahead) * fast
        }
    }
}
