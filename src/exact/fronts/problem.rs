//! What is solved.

/// A straight fibre at rest, clamped at its end: one half of it.
#[derive(Debug, Clone)]
pub struct Clamped<M> {
    /// Its material.
    pub material: M,
    /// Reference area, m².
    pub area: f64,
    /// Unstrained length from the impact point (the crossover) to the clamp, m.
    pub length: f64,
}

/// The fibre that crosses.
#[derive(Debug, Clone)]
pub struct Across<M> {
    /// The half of it at z > 0.
    pub fibre: Clamped<M>,
    /// Where it crosses the primary, m from the impact point; 0 for both at the origin.
    pub at: f64,
    /// α_s.
    pub slide_factor: f64,
}

/// Two crossed fibres, the primary along x struck at its middle, at time 0, in direction y.
#[derive(Debug, Clone)]
pub struct Problem<M> {
    /// The struck fibre.
    pub primary: Clamped<M>,
    /// The crossing fibre.
    pub secondary: Option<Across<M>>,
    /// Velocity of the projectile, m/s.
    pub velocity: f64,
}

impl<M> Problem<M> {
    /// The same problem with other materials.
    pub fn map<N>(&self, material: impl Fn(&M) -> N) -> Problem<N> {
        let map = |fibre: &Clamped<M>| Clamped {
            material: material(&fibre.material),
            area: fibre.area,
            length: fibre.length,
        };
        Problem {
            primary: map(&self.primary),
            secondary: self.secondary.as_ref().map(|across| Across {
                fibre: map(&across.fibre),
                at: across.at,
                slide_factor: across.slide_factor,
            }),
            velocity: self.velocity,
        }
    }
}
