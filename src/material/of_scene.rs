//! The law of a scene's fibre, for the march.

use std::sync::Arc;

use super::{
    ArtificialViscosity, Coefficients, Exponential, Eyring, Law, Linear, Mesh, ParameterError,
    Polynomial, TensionOnly, Viscoelastic,
};
use crate::number::Number;
use crate::scene::{self, Material};

/// The law of a material for elements of a mesh and steps of Δt (s); none where it is eqn (7) and
/// nothing else, which the march has by itself.
///
/// Each combination of a law and what is added to it is a type of its own, so its loop over a block
/// of elements is compiled with nothing else in it.
pub fn of_scene<S: Number>(
    material: &Material,
    mesh: Mesh,
    time_step: S,
) -> Result<Option<Arc<dyn Law<S>>>, ParameterError> {
    if material.is_of_the_page() {
        return Ok(None);
    }
    let added = Added { material, mesh, time_step };
    match &material.law {
        scene::Law::Linear { modulus } => added.to(Linear::new(*modulus)?),
        scene::Law::Polynomial { coefficients } => added.to(Polynomial::new(coefficients)?),
        scene::Law::Exponential { a, b } => added.to(Exponential::new(*a, *b)?),
        scene::Law::Viscoelastic { equilibrium_modulus, arms, update } => {
            added.to(Viscoelastic::new(*equilibrium_modulus, arms, *update)?)
        }
        scene::Law::Eyring { equilibrium_modulus, modulus, rate, stress, update } => {
            added.to(Eyring::new(*equilibrium_modulus, *modulus, *rate, *stress, *update)?)
        }
    }
    .map(Some)
}

/// What is added to a law.
struct Added<'a, S> {
    material: &'a Material,
    mesh: Mesh,
    time_step: S,
}

impl<S: Number> Added<'_, S> {
    fn to(self, law: impl Law<S> + 'static) -> Result<Arc<dyn Law<S>>, ParameterError> {
        match self.material {
            Material { tension_only: true, artificial_viscosity: Some(coefficients), .. } => {
                self.viscous(TensionOnly::new(law), *coefficients)
            }
            Material { artificial_viscosity: Some(coefficients), .. } => {
                self.viscous(law, *coefficients)
            }
            Material { tension_only: true, .. } => {
                Ok(Arc::new(TensionOnly::new(law).prepared(self.time_step)))
            }
            _ => Ok(Arc::new(law.prepared(self.time_step))),
        }
    }

    fn viscous(
        self,
        law: impl Law<S> + 'static,
        coefficients: Coefficients,
    ) -> Result<Arc<dyn Law<S>>, ParameterError> {
        let law = ArtificialViscosity::new(law, self.mesh, coefficients)?;
        Ok(Arc::new(law.prepared(self.time_step)))
    }
}
