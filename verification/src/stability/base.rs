//! States at rest in equilibrium, around which the scheme is linearised and marched.

use crossfibre::constitution::Constitution;
use crossfibre::number::{Number, Vector};
use crossfibre::scene::{Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront};
use serde::{Deserialize, Serialize};

use super::spectrum::Step;
use crate::planted::{self, with_paper};

/// A scene whose fibres are held at rest under strain, all in equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Base {
    /// Fibres, projectile mass, equations, measure of strain. Its Courant number is replaced and its
    /// projectile velocity is zero.
    pub scene: Scene,
    /// Strain of the primary beyond the crossover, in the scene's measure.
    pub strain: f64,
    /// Strain of the secondary.
    pub secondary_strain: f64,
    /// Sine of the angle by which the secondary is pulled along the primary.
    pub tilt: f64,
    /// Whether the projectile travels along the fibre instead of across.
    pub axial: bool,
}

impl Base {
    /// The state before the first step, at a Courant number. A law may outgrow the step.
    pub fn state<S: Number>(&self, courant: f64) -> State<S> {
        let scene = Scene { courant, ..self.scene.clone() };
        let mut state = self.bounded(&scene);
        unbound(&mut state.primary);
        if let Some(crossover) = &mut state.crossover {
            unbound(&mut crossover.fibre);
        }
        state
    }

    /// Whether the march refuses the first step at a Courant number, as a law outgrows it.
    pub fn is_refused(&self, courant: f64) -> bool {
        let scene = Scene { courant, ..self.scene.clone() };
        let mut state = self.bounded::<f64>(&scene);
        with_paper(&self.scene, Step(&mut state)).is_err()
    }

    fn bounded<S: Number>(&self, scene: &Scene) -> State<S> {
        let mut state = planted::at_impact(scene, Wavefront::Ignored);
        state.projectile.velocity = S::zero();
        if self.axial {
            state.projectile.axis = Vector::<S, 2>::new(S::one(), S::zero());
        }
        let [strain, secondary_strain, tilt] =
            [self.strain, self.secondary_strain, self.tilt].map(S::from_f64);
        let along_x = Vector::<S, 2>::new(S::one(), S::zero());
        let primary = &mut state.primary;
        let Some(crossover) = &mut state.crossover else {
            self.lay(primary, along_x, |_| strain);
            return state;
        };
        // The part of the secondary's pull that the primary feels is balanced by more tension behind;
        // by eqn (7) alone.
        let pull = secondary_strain * crossover.fibre.properties.stiffness * tilt;
        let added = S::two() * crossover.slide_factor * pull / primary.properties.stiffness;
        let node = crossover.node;
        self.lay(primary, along_x, |i| if i < node { strain + added } else { strain });
        let (secondary, at) = (&mut crossover.fibre, primary.position[node]);
        secondary.position[0] = Vector::<S, 3>::new(at.x, at.y, S::zero());
        let upright = (S::one() - tilt * tilt).sqrt();
        let direction = Vector::<S, 3>::new(tilt, S::zero(), upright);
        self.lay(secondary, direction, |_| secondary_strain);
        state
    }

    /// Lays a fibre straight from its first node with the strains of its elements.
    fn lay<S: Number, const D: usize>(
        &self,
        fibre: &mut FibreState<S, D>,
        direction: Vector<S, D>,
        strain: impl Fn(usize) -> S,
    ) {
        for i in 0..fibre.elements() {
            let e = strain(i);
            let stretch = match self.scene.strain {
                Strain::Incremental => e.exp(),
                Strain::Engineering => S::one() + e,
            };
            fibre.position[i + 1] = fibre.position[i] + direction * (stretch * fibre.unstrained[i]);
            fibre.strain[i] = e;
            fibre.tension[i] = match &mut fibre.constitution {
                None => fibre.properties.stiffness * e,
                // Arms are at rest where the strain does not change.
                Some(Constitution { law, memory, area, .. }) => {
                    let n = law.memory();
                    *area * law.stress(e, e, &mut memory[i * n..][..n])
                }
            };
            fibre.pull[i] = direction * fibre.tension[i];
        }
    }
}

fn unbound<S: Number, const D: usize>(fibre: &mut FibreState<S, D>) {
    fibre.constitution = fibre.constitution.take().map(Constitution::unbounded);
}

#[cfg(test)]
mod tests {
    use crossfibre::scene::Law;

    use super::super::rows::{at_rest, fibre};
    use super::*;

    /// Ee + Ce² by hand. Some roundings.
    #[test]
    fn a_base_state_has_the_tension_that_its_law_gives_its_strain() {
        let mut scene = fibre(5, Strain::Engineering);
        let law = Law::Polynomial { coefficients: vec![58.6e9, 2e12] };
        scene.primary.material = law.into();
        let expected = scene.primary.area * (58.6e9 * 0.05 + 2e12 * 0.0025);
        let state = at_rest(scene, 0.05).state::<f64>(0.3);
        for (tension, pull) in state.primary.tension.iter().zip(&state.primary.pull) {
            assert!((tension / expected - 1.0).abs() < 1e-14, "{tension} {expected}");
            assert!((pull.x / expected - 1.0).abs() < 1e-14, "{pull:?} {expected}");
        }
        assert_eq!(state.primary.tension.len(), 5);
    }
}
