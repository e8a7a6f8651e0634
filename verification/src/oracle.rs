//! The exact solutions that checks compare with: those of [`crossfibre::exact`], unless a fault of
//! [`crate::planted::exact`] is planted.
//!
//! Checks take types from `crossfibre::exact`, but solve through here.

use crossfibre::exact::crossover::{self, Crossover};
use crossfibre::exact::dalembert::Mesh;
use crossfibre::exact::dispersion;
use crossfibre::exact::elastic::{Elastic, Hyperelastic, LawError};
use crossfibre::exact::exponential::Exponential;
use crossfibre::exact::fronts::Problem;
use crossfibre::exact::motion::{self, Motion};
use crossfibre::exact::polynomial::Polynomial;
use crossfibre::exact::smith::{self, Fibre, Law, Smith, SmithError};
use crossfibre::exact::viscoelastic::{Arm, PulledRod, RodError, RodState};
use crossfibre::exact::wave::Wave;

use crate::planted::exact::Wrong;
use crate::planted::{Plant, now};

fn wrong() -> Option<Wrong> {
    match now() {
        Some(Plant::Exact(wrong)) => Some(wrong),
        _ => None,
    }
}

/// What is right, or what the fault makes of it.
fn otherwise<T>(right: T, fault: impl FnOnce(Wrong, T) -> T) -> T {
    match wrong() {
        None => right,
        Some(wrong) => fault(wrong, right),
    }
}

/// A fibre, as it is given to the solutions below.
pub fn fibre(fibre: Fibre) -> Fibre {
    Fibre { density: otherwise(fibre.density, Wrong::density), ..fibre }
}

/// As [`smith::smith`].
pub fn smith(law: Law, wave_speed: f64, velocity: f64) -> Result<Smith, SmithError> {
    let Some(wrong) = wrong() else { return smith::smith(law, wave_speed, velocity) };
    let solved = smith::smith(wrong.law_of_impact(law), wave_speed, velocity);
    solved.map(|right| wrong.impact(right, velocity))
}

/// As [`smith::struck`].
pub fn struck(material: &impl Elastic, velocity: f64) -> Result<Smith, SmithError> {
    let solved = smith::struck(material, velocity);
    solved.map(|right| otherwise(right, |wrong, right| wrong.impact(right, velocity)))
}

/// As [`crossover::crossover`].
pub fn crossover(
    law: Law,
    primary: &Fibre,
    secondary: &Fibre,
    slide_factor: f64,
    velocity: f64,
) -> Result<Crossover, SmithError> {
    let Some(wrong) = wrong() else {
        return crossover::crossover(law, primary, secondary, slide_factor, velocity);
    };
    let (law, [a, b]) = wrong.crossing(law, [*primary, *secondary], slide_factor);
    let solved = crossover::crossover(law, &a, &b, slide_factor, velocity)?;
    Ok(wrong.crossed(solved, [a, b]))
}

/// As [`motion::motion`].
pub fn motion(problem: &Problem<Hyperelastic>, mass: Option<f64>, time: f64) -> Motion {
    let Some(wrong) = wrong() else { return motion::motion(problem, mass, time) };
    motion::motion(&wrong.problem(problem), wrong.mass(mass), wrong.time_of_motion(time))
}

/// As [`dispersion::frequency`].
pub fn frequency(k: f64, dx: f64, dt: f64, alpha: f64) -> Option<f64> {
    let frequency = dispersion::frequency(k, dx, dt, otherwise(alpha, Wrong::courant));
    frequency.map(|omega| otherwise(omega, Wrong::frequency))
}

/// As [`dispersion::amplification`].
pub fn amplification(alpha: f64, k_dx: f64) -> f64 {
    otherwise(dispersion::amplification(alpha, k_dx), Wrong::growth)
}

/// As [`Mesh::strain`].
pub fn mesh_strain(mesh: Mesh, element: usize, step: usize) -> usize {
    otherwise(mesh.strain(element, otherwise(step, Wrong::step)), Wrong::fronts)
}

/// As [`Mesh::velocity`].
pub fn mesh_velocity(mesh: Mesh, node: usize, step: usize) -> usize {
    mesh.velocity(node, otherwise(step, Wrong::step))
}

/// As [`PulledRod::new`].
pub fn pulled_rod(
    density: f64,
    spring: f64,
    arms: &[Arm],
    velocity: f64,
) -> Result<PulledRod, RodError> {
    match wrong() {
        None => PulledRod::new(density, spring, arms, velocity),
        Some(wrong) => PulledRod::new(density, spring, &wrong.arms(arms), velocity),
    }
}

/// As [`PulledRod::at`].
pub fn rod_at(rod: &PulledRod, x: f64, t: f64) -> Result<RodState, RodError> {
    rod.at(x, otherwise(t, Wrong::time_of_rod))
}

/// As [`Polynomial::new`].
pub fn polynomial(density: f64, coefficients: &[f64]) -> Result<Polynomial, LawError> {
    match wrong() {
        None => Polynomial::new(density, coefficients),
        Some(wrong) => Polynomial::new(density, &wrong.coefficients(coefficients)),
    }
}

/// As [`Exponential::new`].
pub fn exponential(density: f64, a: f64, b: f64) -> Result<Exponential, LawError> {
    let [a, b] = otherwise([a, b], Wrong::exponential);
    Exponential::new(density, a, b)
}

/// As [`Wave::dissipation`].
pub fn dissipation<M: Elastic>(wave: &Wave<'_, M>) -> f64 {
    otherwise(wave.dissipation(), Wrong::dissipation)
}
