//! Limits worked out by hand, for fibres without end: `docs/exact/stability.md`.
//!
//! Nothing here calls an equation of the scheme. A node that moves as (−1)ⁿ has 4/Δt² times its mass
//! for a dynamic stiffness; it is stable as long as that is more than what holds it.

use crossfibre::errata::Erratum;
use crossfibre::number::Number;
use crossfibre::scene::{Law, Material, Strain};

use super::base::Base;

/// Equal masses between equal springs, without end on one side.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    /// Of a node, kg.
    pub mass: f64,
    /// Of a spring, N/m.
    pub stiffness: f64,
}

impl Chain {
    /// The largest Δt at which the chain itself is stable, s.
    pub fn limit(self) -> f64 {
        (self.mass / self.stiffness).sqrt()
    }

    /// Force per displacement at its end while all moves as (−1)ⁿ, N/m.
    ///
    /// Neighbours then stand in a ratio of −r with r + 1/r = 4m/(kΔt²) − 2, and the first spring
    /// resists with k(1 + r).
    fn resistance(self, time_step: f64) -> f64 {
        let q = 4.0 * self.mass / (self.stiffness * time_step * time_step);
        let r = 2.0 / (q - 2.0 + (q * (q - 4.0)).max(0.0).sqrt());
        self.stiffness * (1.0 + r)
    }
}

/// The largest Δt, s, at which a node of a mass, kg, at the end of chains is stable; each counts as
/// often as its weight says.
pub fn node_limit(mass: f64, chains: &[(f64, Chain)]) -> f64 {
    let held = chains.iter().filter(|(_, chain)| chain.stiffness > 0.0);
    let most = held.clone().map(|(_, chain)| chain.limit()).fold(f64::INFINITY, f64::min);
    let stable = |dt: f64| {
        let resistance: f64 = held.clone().map(|(n, chain)| n * chain.resistance(dt)).sum();
        4.0 * mass / (dt * dt) >= resistance
    };
    if stable(most) {
        return most;
    }
    greatest(stable, 0.0, most)
}

/// The greatest number that passes, between one that does and one that does not.
pub fn greatest(passes: impl Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    // Until nothing lies between the two.
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return low;
        }
        if passes(middle) { low = middle } else { high = middle }
    }
}

/// A stretched fibre as two chains: along it and across.
struct Stretched {
    along: Chain,
    across: Chain,
}

/// One fibre of a scene.
struct Fibre<'a> {
    spacing: f64,
    mass: f64,
    area: f64,
    material: &'a Material,
}

impl Fibre<'_> {
    fn crossing_time(&self) -> f64 {
        let inertia = self.mass / (self.area * self.spacing);
        self.spacing * (inertia / self.material.instantaneous_modulus()).sqrt()
    }

    /// # Panics
    /// If the law is not eqn (7): a fault of this program.
    fn modulus(&self) -> f64 {
        match self.material.law {
            Law::Linear { modulus } => modulus,
            ref other => panic!("{} is not eqn (7)", other.name()),
        }
    }

    fn tension(&self, strain: f64) -> f64 {
        self.modulus() * self.area * strain
    }

    /// dT/dL and T/L: a strain e of (4) is a length of exp(e), and de = dL/L.
    fn stretched(&self, strain: f64, measure: Strain) -> Stretched {
        let (stretch, by_stretch) = match measure {
            Strain::Incremental => (Number::exp(strain), Number::exp(-strain)),
            Strain::Engineering => (1.0 + strain, 1.0),
        };
        let along = self.modulus() * self.area * by_stretch / self.spacing;
        let across = self.tension(strain) / (stretch * self.spacing);
        let chain = |stiffness| Chain { mass: self.mass, stiffness };
        Stretched { along: chain(along), across: chain(across) }
    }
}

/// The largest stable Courant number of a base state on fibres without end; of linear laws.
pub fn largest_courant(base: &Base) -> f64 {
    let scene = &base.scene;
    let p = &scene.primary;
    let spacing = p.length / p.elements as f64;
    let mass = p.density * p.area * spacing;
    let primary = Fibre { spacing, mass, area: p.area, material: &p.material };
    let ahead = primary.stretched(base.strain, scene.strain);
    let mut limit = ahead.along.limit().min(ahead.across.limit());
    let mut unit = primary.crossing_time();
    let has = |erratum| scene.corrections.has(erratum);

    if let Some(projectile) = scene.projectile.mass {
        let lump = if has(Erratum::ProjectileInertia) { primary.mass } else { 0.0 };
        let chain = if base.axial { ahead.along } else { ahead.across };
        // Half of the projectile belongs to either half of the fibre.
        limit = limit.min(node_limit(0.5 * (projectile + lump), &[(1.0, chain)]));
    }
    if let Some(s) = &scene.secondary {
        let spacing = s.length / s.elements as f64;
        let mass = s.density * s.area * spacing;
        let secondary = Fibre { spacing, mass, area: s.area, material: &s.material };
        unit = unit.min(secondary.crossing_time());
        let arm = secondary.stretched(base.secondary_strain, scene.strain);
        // What the arms pull along the primary adds to the strain behind the crossover.
        let (slide, tilt) = (s.slide_factor, base.tilt);
        let pull = 2.0 * slide * tilt * secondary.tension(base.secondary_strain);
        let behind_strain = base.strain + pull / primary.tension(1.0);
        let behind = primary.stretched(behind_strain, scene.strain);
        let with_arms = if has(Erratum::CrossoverInertia) { mass } else { 0.0 };
        let squared = slide * slide;
        let along = [
            (1.0, ahead.along),
            (1.0, behind.along),
            (2.0 * squared * tilt * tilt, arm.along),
            (2.0 * squared * (1.0 - tilt * tilt), arm.across),
        ];
        // (16) as printed gives no force against a motion across a straight fibre.
        let arms = if has(Erratum::PerpendicularResolution) { 2.0 } else { 0.0 };
        let across = [(1.0, ahead.across), (1.0, behind.across), (arms, arm.across)];
        limit = limit
            .min(arm.along.limit())
            .min(arm.across.limit())
            .min(node_limit(primary.mass + squared * with_arms, &along))
            .min(node_limit(primary.mass + with_arms, &across));
    }
    limit / unit
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A light end mass μ, in node masses, has Δt = 2√(μ(1 − μ) m/k) by hand. Rounding alone.
    #[test]
    fn a_light_end_mass_has_the_limit_found_by_hand() {
        let chain = Chain { mass: 2.91e-6, stiffness: 2.93e7 };
        for mu in [1.3e-5, 0.017, 0.31, 0.499] {
            let expected = 2.0 * (mu * (1.0 - mu) * chain.mass / chain.stiffness).sqrt();
            let found = node_limit(mu * chain.mass, &[(1.0, chain)]);
            assert!((found / expected - 1.0).abs() < 1e-14, "{mu}: {found} {expected}");
        }
        // From half a node's mass on, that of a free end, the chain itself is the limit.
        assert_eq!(node_limit(0.5013 * chain.mass, &[(1.0, chain)]), chain.limit());
    }

    #[test]
    fn a_node_that_nothing_holds_is_stable_at_every_step() {
        let slack = Chain { mass: 2.91e-6, stiffness: 0.0 };
        assert!(node_limit(slack.mass, &[(1.0, slack)]).is_infinite());
        // A chain that holds nothing beside one that does makes no difference.
        let chain = Chain { stiffness: 2.93e7, ..slack };
        let alone = node_limit(0.1 * chain.mass, &[(1.0, chain)]);
        assert_eq!(node_limit(0.1 * chain.mass, &[(1.0, chain), (1.0, slack)]), alone);
    }

    /// With x = sin²β and equal fibres, without the inertia of the arms and with rigid transverse
    /// motion left out, (1 + r)/r = 2(1 + x) gives α² = 1 − (x/(1 + x))². Rounding alone.
    #[test]
    fn a_tilted_crossover_without_inertia_has_the_limit_found_by_hand() {
        let chain = Chain { mass: 2.91e-6, stiffness: 2.93e7 };
        for x in [0.011, 0.36] {
            let expected = chain.limit() * (1.0 - x * x / ((1.0 + x) * (1.0 + x))).sqrt();
            let found = node_limit(chain.mass, &[(2.0, chain), (2.0 * x, chain)]);
            assert!((found / expected - 1.0).abs() < 1e-14, "{x}: {found} {expected}");
            // The arms' mass makes up for it.
            assert_eq!(
                node_limit(2.0 * chain.mass, &[(2.0, chain), (2.0 * x, chain)]),
                chain.limit()
            );
        }
    }

    /// With EA/Δx = 12 N/m and λ = 1.25, or exp(0.25) by (4): dT/dL along, T/L across.
    #[test]
    fn a_stretched_fibre_is_as_stiff_as_its_measure_of_strain_makes_it() {
        let material = Material::linear(3.0);
        let fibre = Fibre { spacing: 0.5, mass: 0.7, area: 2.0, material: &material };
        let by_4 = 12.0 / 1.284_025_416_687_741_4;
        for (measure, along, across) in
            [(Strain::Engineering, 12.0, 2.4), (Strain::Incremental, by_4, 0.25 * by_4)]
        {
            let found = fibre.stretched(0.25, measure);
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14;
            assert!(near(found.along.stiffness, along), "{measure:?}: {:?}", found.along);
            assert!(near(found.across.stiffness, across), "{measure:?}: {:?}", found.across);
        }
    }
}
