//! The stress of artificial viscosity, of a fibre that is stretched at a steady rate.

use crossfibre::material::Coefficients;
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{State, Wavefront};

use crate::cases::support::{check, measured_by, relative, shipped, watched};
use crate::cases::{Bound, Check};
use crate::planted::at_impact;
use crate::worse::worse;

const COEFFICIENTS: Coefficients = Coefficients { linear: 0.37, quadratic: 1.9 };

/// Strain rates, 1/s: a step of them is 1 % to 3 % of strain.
const RATES: [f64; 5] = [1.3e5, 1.7e5, 1.9e5, 2.3e5, 2.9e5];

/// Two elements of a linear law and its viscosity.
fn scene() -> Scene {
    let mut scene = measured_by(Strain::Engineering, shipped("artificial-viscosity"));
    (scene.primary.elements, scene.primary.length) = (2, 0.00413);
    scene.primary.material.artificial_viscosity = Some(COEFFICIENTS);
    // Room for what viscosity takes of the stable step.
    scene.courant = 0.31;
    scene
}

/// What the viscosity adds to the stress in a step of this strain rate, Pa; what the fibre has lost by it,
/// J; and the step, s.
fn of_rate(rate: f64) -> (f64, f64, f64) {
    let mut scene = scene();
    let (length, area) = (scene.primary.length, scene.primary.area);
    let modulus = scene.primary.material.instantaneous_modulus();
    let time_step = at_impact::<f64>(&scene, Wavefront::Ignored).time_step;
    scene.duration = time_step;
    // Every node goes at the rate times its distance from the first: the strain is uniform, and no node
    // is pushed.
    let stretching = |state: &mut State<f64>| {
        state.projectile.velocity = 0.0;
        for (v, x) in state.primary.velocity.iter_mut().zip(&state.primary.position) {
            v.x = rate * x.x;
        }
        state.primary.clamp_velocity.x = rate * length;
    };
    let run = watched(scene, Wavefront::Ignored, &stretching, |_| ());
    assert!(run.outcome.is_completed(), "{}", run.outcome);
    let elastic = modulus * rate * time_step;
    let stress = run.state.primary.tension[0] / area;
    (stress - elastic, run.balance.energy.dissipated, time_step)
}

/// To be stretched, and to be let shorten.
fn either_way(rate: f64) -> [f64; 2] {
    [rate, -rate]
}

/// A fibre stretched, and one let shorten.
pub fn stretched() -> Vec<Check> {
    let fibre = &scene().primary;
    let (modulus, density) = (fibre.material.instantaneous_modulus(), fibre.density);
    let element = fibre.length / 2.0;
    // ρΔx² × quadratic and ρΔx × linear × c, c = √(E/ρ).
    let quadratic = density * element * element * COEFFICIENTS.quadratic;
    let linear = (density * modulus).sqrt() * element * COEFFICIENTS.linear;
    let viscous = |rate: f64| (linear + quadratic * rate.abs()) * rate;
    let volume = 2.0 * fibre.length * fibre.area;
    let (mut stress, mut square, mut loss) = (0.0_f64, 0.0_f64, 0.0_f64);
    for rate in RATES {
        for rate in either_way(rate) {
            let (added, lost, time_step) = of_rate(rate);
            stress = worse(stress, relative(added, viscous(rate)));
            loss = worse(loss, relative(lost, viscous(rate) * rate * time_step * volume));
        }
        let beyond_twice = of_rate(2.0 * rate).0 - 2.0 * of_rate(rate).0;
        square = worse(square, relative(beyond_twice, 2.0 * quadratic * rate * rate));
    }
    let reason = "rounding of a strain of 1 % to 3 %, the difference of two lengths";
    vec![
        check(
            "A fibre that lengthens or shortens steadily has the viscous stress of its rate",
            "ρΔx (linear × c + quadratic × Δx|ε̇|) ε̇",
            "greatest relative error of the stress beyond Eε after a step, five rates either way",
            stress,
            Bound::AtMost(5e-14),
            reason,
        ),
        check(
            "At twice the rate, what is more than twice the stress grows with the square of the rate",
            "2 ρΔx² × quadratic × ε̇²",
            "greatest relative error, five rates and their doubles",
            square,
            Bound::AtMost(3e-13),
            "the same, and the quadratic part is a fifth of the linear one at the least",
        ),
        check(
            "The work of the viscous stress is lost",
            "that stress times the strain of the step times the volume of both halves",
            "greatest relative error of the energy dissipated, five rates either way",
            loss,
            Bound::AtMost(6e-14),
            reason,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fibre_is_stretched_at_a_rate_and_let_shorten_at_the_same() {
        let [stretched, shortened] = either_way(RATES[0]);
        assert!(stretched > 0.0);
        assert_eq!(shortened, -stretched);
    }
}
