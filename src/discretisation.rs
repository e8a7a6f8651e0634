//! From a scene to elements, nodes and a time step.

use crate::number::Number;
use crate::paper::{Paper, Printed};
use crate::scene::{Material, Scene};

/// The constants of one discretised fibre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties<S> {
    /// n, number of elements.
    pub elements: usize,
    /// Δx, unstrained length of an element, m.
    pub spacing: S,
    /// c = √(E/ρ), speed of a small longitudinal wave, m/s.
    pub wave_speed: S,
    /// Δm = ρ × area × Δx, mass lumped at an inner node, kg.
    pub mass: S,
    /// Cross-section, m².
    pub area: S,
    /// E × area, N; E is the instantaneous modulus at rest.
    pub stiffness: S,
    /// A = Δt/Δm, s/kg.
    pub a: S,
}

/// A discretised secondary fibre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<S> {
    /// Its constants.
    pub fibre: Properties<S>,
    /// Distance of the crossover from the impact point, m.
    pub at: S,
    /// `ix`: the node of the primary nearest to the crossover, the lower of two equals.
    pub node: usize,
    /// α_s.
    pub slide_factor: S,
}

/// A discretised scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Discretisation<S> {
    /// Δt = courant × the smaller Δx/c of the fibres, s.
    pub time_step: S,
    /// The struck fibre.
    pub primary: Properties<S>,
    /// The crossing fibre, if there is one.
    pub secondary: Option<Crossing<S>>,
}

impl<S: Number> Properties<S> {
    /// All but `a`, which waits for the time step.
    fn of(length: f64, elements: usize, density: f64, area: f64, material: &Material) -> Self {
        let [length, density, area] = [length, density, area].map(S::from_f64);
        let modulus = S::from_f64(material.instantaneous_modulus());
        let spacing = length / S::count(elements);
        Self {
            elements,
            spacing,
            wave_speed: (modulus / density).sqrt(),
            mass: density * area * spacing,
            area,
            stiffness: modulus * area,
            a: S::zero(),
        }
    }

    fn with_time_step(self, time_step: S) -> Self {
        Self { a: time_step / self.mass, ..self }
    }

    /// The time a small longitudinal wave takes to cross one element, s.
    fn crossing_time(&self) -> S {
        self.spacing / self.wave_speed
    }

    /// Unstrained distance of node `i` from the first node, m.
    pub fn node(&self, i: usize) -> S {
        S::count(i) * self.spacing
    }

    /// α by (20).
    pub fn courant(&self, time_step: S) -> S {
        Printed.eqn_20_courant(self.wave_speed, time_step, self.spacing)
    }

    /// The node nearest to a distance along the unstrained fibre, the lower of two equals.
    fn nearest_node(&self, at: S) -> usize {
        let away = |i: usize| {
            let d = self.node(i) - at;
            if d < S::zero() { -d } else { d }
        };
        let guess = (at / self.spacing).to_f64().floor();
        let low = if guess >= 0.0 { (guess as usize).min(self.elements) } else { 0 };
        let high = (low + 1).min(self.elements);
        if away(high) < away(low) { high } else { low }
    }
}

impl<S: Number> Discretisation<S> {
    /// The scene in elements and a time step.
    pub fn of(scene: &Scene) -> Self {
        let p = &scene.primary;
        let primary = Properties::of(p.length, p.elements, p.density, p.area, &p.material);
        let secondary = scene.secondary.as_ref().map(|s| {
            let at = S::from_f64(s.at);
            Crossing {
                fibre: Properties::of(s.length, s.elements, s.density, s.area, &s.material),
                at,
                node: primary.nearest_node(at),
                slide_factor: S::from_f64(s.slide_factor),
            }
        });
        let mut crossing_time = primary.crossing_time();
        if let Some(s) = &secondary
            && s.fibre.crossing_time() < crossing_time
        {
            crossing_time = s.fibre.crossing_time();
        }
        let time_step = S::from_f64(scene.courant) * crossing_time;
        Self {
            time_step,
            primary: primary.with_time_step(time_step),
            secondary: secondary
                .map(|s| Crossing { fibre: s.fibre.with_time_step(time_step), ..s }),
        }
    }

    /// duration/Δt, rounded to the nearest whole number.
    pub fn steps(&self, duration: f64) -> u64 {
        (duration / self.time_step.to_f64()).round() as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_node_is_the_lower_of_two_equals() {
        let fibre = Properties::<f64>::of(0.5, 4, 1206.7, 1e-6, &Material::linear(1e9));
        assert_eq!(fibre.spacing, 0.125);
        assert_eq!(fibre.nearest_node(0.1875), 1); // midway between nodes 1 and 2
        assert_eq!(fibre.nearest_node(0.1876), 2);
        assert_eq!(fibre.nearest_node(0.06), 0);
        assert_eq!(fibre.nearest_node(0.5), 4);
    }
}
