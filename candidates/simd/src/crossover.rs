//! Eqns (8)–(18) with all corrections: what happens at single nodes, in plain numbers.

use crate::state::{difference, magnitude};

/// The corrected (8): `v_p^t = v_p^{t−1} + 2 T_y Δt/(m_p + Δm)`, `T_y` being the first tension along
/// the travel of the projectile, N, and `node_mass` what is lumped on its node, kg.
#[inline(always)]
pub(crate) fn eqn_8_projectile_velocity(
    velocity: f64,
    tension_y: f64,
    time_step: f64,
    mass: f64,
    node_mass: f64,
) -> f64 {
    velocity - 2.0 * -tension_y * time_step / (mass + node_mass)
}

/// A tension along the axis of travel, y.
#[inline(always)]
pub(crate) fn along_axis(pull: &[f64]) -> f64 {
    0.0 * pull[0] + 1.0 * pull[1]
}

/// What (15)–(18) read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Push {
    /// The primary's nodes `ix` and `ix−1`, m.
    pub here: [f64; 2],
    pub behind: [f64; 2],
    /// The secondary's first two nodes, m.
    pub secondary: [[f64; 3]; 2],
    /// `T2_1` at `t−1`, N.
    pub tension: f64,
    /// The primary's tensions at `t−1`, ahead of `ix` and before it, N.
    pub pulls: [[f64; 2]; 2],
    /// A of the primary, s/kg.
    pub a: f64,
    /// `α_s`
    pub slide_factor: f64,
    /// Lumped masses, kg.
    pub mass: f64,
    pub secondary_mass: f64,
}

impl Push {
    /// (2), then (15)–(18): the velocity of the crossover's node.
    #[inline(always)]
    pub fn velocity(&self, before: [f64; 2]) -> [f64; 2] {
        let Self { tension, a, slide_factor, mass, secondary_mass, .. } = *self;
        let change = difference(self.pulls[0], self.pulls[1]).map(|force| force * a);
        let [u, v] = [before[0] + change[0], before[1] + change[1]];
        let [cos_x, cos_y] = direction(self.here, self.behind);
        let [cos_2x, cos_2y, _] = direction(self.secondary[1], self.secondary[0]);

        let parallel = tension * (cos_2x * cos_x + cos_2y * cos_y); // (15)
        let perpendicular = tension * (cos_2y * cos_x - cos_2x * cos_y); // (16)

        let mass_along = slide_factor * slide_factor * secondary_mass;
        let share_along = mass_along / (mass + mass_along);
        let share_across = secondary_mass / (mass + secondary_mass);
        let along = change[0] * cos_x + change[1] * cos_y;
        let across = change[1] * cos_x - change[0] * cos_y;
        let taken_back = share_along * along * cos_x - share_across * across * cos_y;
        let normal_x = -cos_y;
        let u = u + 2.0
            * a
            * (perpendicular * (1.0 - share_across) * normal_x
                + slide_factor * parallel * (1.0 - share_along) * cos_x)
            - taken_back; // (17)
        let taken_back = share_along * along * cos_y + share_across * across * cos_x;
        let v = v + 2.0
            * a
            * (perpendicular * (1.0 - share_across) * cos_x
                + slide_factor * parallel * (1.0 - share_along) * cos_y)
            - taken_back; // (18)
        [u, v]
    }
}

/// Eqns (9)–(14): the velocity that the crossover's node imposes on the secondary's first.
#[inline(always)]
pub(crate) fn drive(
    [u, v]: [f64; 2],
    here: [f64; 2],
    behind: [f64; 2],
    slide_factor: f64,
) -> [f64; 3] {
    let [cos, sin] = direction(here, behind); // (11)
    let parallel = u * cos + v * sin; // (9)
    let perpendicular = v * cos - u * sin; // (10)
    [
        slide_factor * parallel * cos - perpendicular * sin, // (12)
        slide_factor * parallel * sin + perpendicular * cos, // (13)
        0.0,                                                 // (14)
    ]
}

/// Square of the distance of the secondary's first node from a node of the primary, m².
#[inline(always)]
pub(crate) fn square_of_distance(first: [f64; 3], node: [f64; 2]) -> f64 {
    let apart = [node[0] - first[0], node[1] - first[1], -first[2]];
    apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]
}

/// The direction cosines of an element.
#[inline(always)]
fn direction<const D: usize>(here: [f64; D], behind: [f64; D]) -> [f64; D] {
    let element = difference(here, behind);
    let length = magnitude(element);
    element.map(|x| x / length)
}
