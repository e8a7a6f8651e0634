//! One step, element by element as on the page: where does a number cease to be finite?

use crossfibre::outcome::Outcome;
use crossfibre::place::{Fibre, Place};

use crate::crossover::{self, Push, along_axis, eqn_8_projectile_velocity};
use crate::march::Constants;
use crate::mesh::Properties;
use crate::state::{FibreState, State, difference, magnitude};

/// The first equation of the next step whose result is not finite; none, if all are.
pub(crate) fn divergence(constants: &Constants, state: &State) -> Option<Outcome> {
    let mut state = state.clone();
    let step = state.step + 1;
    let at = |fibre| {
        move |(index, equation)| Outcome::Diverged { place: Place { step, fibre, index }, equation }
    };
    advance(constants, &mut state, &at(Fibre::Primary), &at(Fibre::Secondary)).err()
}

fn advance(
    constants: &Constants,
    state: &mut State,
    at_primary: &impl Fn((usize, u8)) -> Outcome,
    at_secondary: &impl Fn((usize, u8)) -> Outcome,
) -> Result<(), Outcome> {
    let Constants { mesh, slide_factor, projectile_mass, .. } = *constants;
    let drive = [0.0 * state.projectile_velocity, 1.0 * state.projectile_velocity];
    let crossing = mesh.secondary.zip(state.crossover);
    let mut pushed = None;
    if let (Some(((properties, _), at)), Some(secondary)) = (crossing, &state.secondary)
        && (1..=state.primary.visited()).contains(&at.node)
    {
        let (ix, primary) = (at.node, &state.primary);
        let push = Push {
            here: primary.position[ix],
            behind: primary.position[ix - 1],
            secondary: [secondary.position[0], secondary.position[1]],
            tension: secondary.tension[0],
            pulls: [primary.pull(ix), primary.pull(ix - 1)],
            a: mesh.primary.a,
            slide_factor,
            mass: mesh.primary.mass,
            secondary_mass: properties.mass,
        };
        pushed = Some((ix, push.velocity(primary.velocity[ix])));
    }
    fibre(constants, &mesh.primary, &mut state.primary, drive, pushed).map_err(at_primary)?;
    let (node, properties) = match crossing {
        Some(((properties, _), at)) => (at.node, Some(properties)),
        None => (0, None),
    };
    let mut pull = along_axis(&state.primary.pull(0));
    let mut node_mass = mesh.primary.mass;
    if let (0, Some(properties), Some(secondary)) = (node, properties, &mut state.secondary) {
        let drive = [drive[0], drive[1], 0.0];
        fibre(constants, &properties, secondary, drive, None).map_err(at_secondary)?;
        pull += along_axis(&secondary.pull(0));
        node_mass += properties.mass;
    }
    if let Some(mass) = projectile_mass {
        let velocity = state.projectile_velocity;
        state.projectile_velocity =
            eqn_8_projectile_velocity(velocity, pull, mesh.time_step, mass, node_mass);
        if !state.projectile_velocity.is_finite() {
            return Err(at_primary((0, 8)));
        }
    }
    if let (1.., Some(properties), Some(secondary)) = (node, properties, &mut state.secondary) {
        let primary = &state.primary;
        let [here, behind] = [primary.position[node], primary.position[node - 1]];
        let drive = crossover::drive(primary.velocity[node], here, behind, slide_factor);
        fibre(constants, &properties, secondary, drive, None).map_err(at_secondary)?;
    }
    Ok(())
}

/// The length loop; on failure the index and the equation. `pushed` is a node that (2) does not
/// move alone, and its velocity.
fn fibre<const D: usize>(
    constants: &Constants,
    properties: &Properties,
    fibre: &mut FibreState<D>,
    drive: [f64; D],
    pushed: Option<(usize, [f64; D])>,
) -> Result<(), (usize, u8)> {
    let (front, clamp, dt) = (fibre.visited(), properties.elements, constants.mesh.time_step);
    let old = fibre.clone();
    let moved =
        |x: [f64; D], v: [f64; D]| -> [f64; D] { std::array::from_fn(|c| x[c] + v[c] * dt) };
    fibre.velocity[0] = drive;
    fibre.position[0] = moved(old.position[0], drive);
    for i in 0..front {
        fibre.velocity[i + 1] = match pushed {
            _ if i + 1 == clamp => [0.0; D],
            Some((node, velocity)) if node == i + 1 => velocity,
            _ => {
                let change = difference(old.pull(i + 1), old.pull(i));
                std::array::from_fn(|c| old.velocity[i + 1][c] + change[c] * properties.a)
            }
        };
        fibre.position[i + 1] = moved(old.position[i + 1], fibre.velocity[i + 1]);
        let length = magnitude(difference(fibre.position[i + 1], fibre.position[i]));
        let before = magnitude(difference(old.position[i + 1], old.position[i]));
        fibre.strain[i] = if constants.engineering {
            length / properties.unstrained(i) - 1.0
        } else {
            old.strain[i] + length / before - 1.0
        };
        fibre.tension[i] = properties.stiffness * fibre.strain[i];
        if !fibre.velocity[i + 1].iter().all(|v| v.is_finite()) {
            return Err((i + 1, 2));
        } else if !length.is_finite() || length == 0.0 {
            return Err((i, 6));
        } else if !fibre.strain[i].is_finite() {
            return Err((i, 4));
        } else if !(fibre.tension[i] / length).is_finite() {
            return Err((i, 7));
        }
    }
    Ok(())
}

impl<const D: usize> FibreState<D> {
    /// Tension of an element as a vector, "the same direction as the element itself".
    fn pull(&self, i: usize) -> [f64; D] {
        let element = difference(self.position[i + 1], self.position[i]);
        let pull_per_length = self.tension[i] / magnitude(element);
        element.map(|x| x * pull_per_length)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may

    use crossfibre::scene::{Material, Scene, Strain};
    use crossfibre::scene_file;

    use super::*;
    use crate::engine::{Engine, constants};

    const SCENES: [&str; 4] = [
        include_str!("../../../verification/scenes/unequal.json"),
        include_str!("../../../verification/scenes/fig3.json"),
        include_str!("../../../verification/scenes/both-at-origin.json"),
        include_str!("../../../verification/scenes/finite-projectile.json"),
    ];

    fn json(state: &State) -> String {
        serde_json::to_string(state).unwrap()
    }

    /// JSON tells numbers apart by every bit.
    #[test]
    fn a_literal_step_gives_the_bits_of_the_engine() {
        for text in SCENES {
            for strain in [Strain::Incremental, Strain::Engineering] {
                let mut scene = Scene { strain, ..scene_file::read(text).unwrap() };
                scene.projectile.mass = Some(1.3e-4);
                let mut engine = Engine::new(&scene).unwrap();
                for _ in 0..90 {
                    let mut state = engine.state();
                    let end = |(index, equation)| Outcome::Diverged {
                        place: Place { step: 0, fibre: Fibre::Primary, index },
                        equation,
                    };
                    advance(&constants(&scene), &mut state, &end, &end).unwrap();
                    engine.run(1);
                    // `advance` leaves the count of steps, and ix, to its caller.
                    let expected = engine.state();
                    (state.step, state.crossover) = (expected.step, expected.crossover);
                    assert_eq!(json(&state), json(&expected), "{}, {strain:?}", scene.title);
                }
            }
        }
    }

    /// Steps from states at rest of which a few numbers are spoilt. Of powers of two: c = 8192 m/s, elements of
    /// 2⁻⁸ m, and so steps of 2⁻²¹ s.
    #[test]
    fn the_first_equation_that_is_not_finite_is_named() {
        let mut scene = Scene { secondary: None, ..scene_file::read(SCENES[1]).unwrap() };
        (scene.primary.length, scene.primary.elements, scene.courant) = (0.5, 128, 1.0);
        (scene.primary.density, scene.primary.material) =
            (1024.0, Material::linear(2.0_f64.powi(36)));
        let mut engine = Engine::new(&scene).unwrap();
        // All nodes up to the fourth are visited.
        engine.run(4);
        let end = |spoil: &dyn Fn(&mut FibreState<2>)| {
            let mut state = engine.state();
            for i in 0..4 {
                state.primary.velocity[i] = [0.0; 2];
                state.primary.position[i] = [i as f64 / 256.0, 0.0];
                (state.primary.strain[i], state.primary.tension[i]) = (0.0, 0.0);
            }
            spoil(&mut state.primary);
            // What it is visited for.
            state.primary.tension[3] = 1e-200;
            let Some(Outcome::Diverged { place, equation }) =
                divergence(&constants(&scene), &state)
            else {
                return None;
            };
            assert_eq!((place.step, place.fibre), (5, Fibre::Primary));
            Some((place.index, equation))
        };
        assert_eq!(end(&|_| ()), None);
        assert_eq!(end(&|fibre| fibre.velocity[2][0] = f64::INFINITY), Some((2, 2)));
        // So fast that the square of a length is none.
        assert_eq!(end(&|fibre| fibre.velocity[2][0] = 1e200), Some((1, 6)));
        // An element that is left without length.
        let no_length = |fibre: &mut FibreState<2>| {
            fibre.position[2][0] = 1.25 / 256.0;
            fibre.velocity[2][0] = -2048.0;
        };
        assert_eq!(end(&no_length), Some((1, 6)));
        assert_eq!(end(&|fibre| fibre.strain[1] = f64::INFINITY), Some((1, 4)));
        // A tension that is finite, and a quotient by the length of a nanometre that is not.
        let in_no_length = |fibre: &mut FibreState<2>| {
            fibre.position[2][0] = fibre.position[1][0] + 1e-9;
            fibre.strain[1] = 1e296;
        };
        assert_eq!(end(&in_no_length), Some((1, 7)));
    }
}
