//! From a scene to elements, nodes and a time step: the reference's numbers, worked out here again.

use crossfibre::scene::{Law, Material, Scene};

use crate::state::magnitude;

/// The constants of a fibre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Properties {
    /// n
    pub elements: usize,
    /// Δx, m.
    pub spacing: f64,
    /// Δm = ρ × area × Δx, kg.
    pub mass: f64,
    /// E × area, N.
    pub stiffness: f64,
    /// A = Δt/Δm, s/kg.
    pub a: f64,
    /// Δx/c, s.
    crossing_time: f64,
}

impl Properties {
    fn of(length: f64, elements: usize, density: f64, area: f64, modulus: f64) -> Self {
        let spacing = length / elements as f64;
        let wave_speed = (modulus / density).sqrt();
        Self {
            elements,
            spacing,
            mass: density * area * spacing,
            stiffness: modulus * area,
            a: 0.0,
            crossing_time: spacing / wave_speed,
        }
    }

    /// Distance of a node from the first, unstrained, m.
    pub fn node(&self, i: usize) -> f64 {
        i as f64 * self.spacing
    }

    /// `L⁰` of an element: (5) of the fibre at rest, m.
    pub fn unstrained(&self, element: usize) -> f64 {
        magnitude([self.node(element + 1) - self.node(element)])
    }

    /// The node nearest to a distance, the lower of two equals.
    fn nearest_node(&self, at: f64) -> usize {
        let low = ((at / self.spacing).floor().max(0.0) as usize).min(self.elements);
        let high = (low + 1).min(self.elements);
        let away = |i: usize| (self.node(i) - at).abs();
        if away(high) < away(low) { high } else { low }
    }
}

/// A scene in elements and a time step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mesh {
    /// Δt = courant × the smaller Δx/c, s.
    pub time_step: f64,
    /// The struck fibre.
    pub primary: Properties,
    /// The crossing fibre and the primary's node nearest to it.
    pub secondary: Option<(Properties, usize)>,
    /// duration/Δt, rounded.
    pub steps: u64,
}

impl Mesh {
    pub fn of(scene: &Scene) -> Self {
        let p = &scene.primary;
        let mut primary =
            Properties::of(p.length, p.elements, p.density, p.area, modulus(&p.material));
        let mut secondary = scene.secondary.as_ref().map(|s| {
            let fibre =
                Properties::of(s.length, s.elements, s.density, s.area, modulus(&s.material));
            (fibre, primary.nearest_node(s.at))
        });
        let mut crossing_time = primary.crossing_time;
        if let Some((fibre, _)) = &secondary
            && fibre.crossing_time < crossing_time
        {
            crossing_time = fibre.crossing_time;
        }
        let time_step = scene.courant * crossing_time;
        primary.a = time_step / primary.mass;
        if let Some((fibre, _)) = &mut secondary {
            fibre.a = time_step / fibre.mass;
        }
        let steps = (scene.duration / time_step).round() as u64;
        Self { time_step, primary, secondary, steps }
    }
}

/// E, Pa. What has another law has been refused.
fn modulus(material: &Material) -> f64 {
    match material.law {
        Law::Linear { modulus } => modulus,
        _ => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may

    use crossfibre::scene_file;

    use super::*;

    #[test]
    fn a_crossover_between_two_nodes_is_at_the_nearer_or_the_lower() {
        let text = include_str!("../../../verification/scenes/unequal.json");
        let mut scene = scene_file::read(text).unwrap();
        (scene.primary.length, scene.primary.elements) = (13.0, 13);
        for (at, node) in [(2.5, 2), (2.6, 3), (2.4, 2), (0.5, 0), (12.75, 13)] {
            scene.secondary.as_mut().unwrap().at = at;
            assert_eq!(Mesh::of(&scene).secondary.unwrap().1, node, "{at}");
        }
    }
}
