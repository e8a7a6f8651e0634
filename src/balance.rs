//! Energy and momentum of the whole system: both halves of the primary fibre, and every arm of
//! every secondary.
//!
//! With the crossover away from the impact point symmetry puts a second secondary at −`at`, so there
//! are four arms; with both fibres at the impact point there are two.
//!
//! **Momentum** along the axis of travel is summed with the velocities of the march: the sum of (2)
//! over a fibre telescopes to the tensions of its ends, so the balance closes to rounding.
//!
//! **Energy** needs velocities at the time of the positions. `v^t` carries `x^{t−1}` to `x^t` and so
//! belongs to the middle of that step; the mean of `v^t` and `v^{t+1}` belongs to `x^t`.
//! The stored energy is that of the scene's own law: ½ E ε² for engineering strain, and
//! E [(ε − 1) exp ε + 1] for eqns (4) and (7), which are T = E ln λ. Other laws have their own, or
//! under (4) the work along the path ([`crate::constitution::PathEnergy`]).

use serde::{Deserialize, Serialize};

use crate::constitution::PathEnergy;
use crate::number::{Number, Vector};
use crate::paper::Paper;
use crate::scene::Strain;
use crate::state::{FibreState, State};

/// Energy and momentum at one time, with what entered since impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Balance {
    /// Energy, J.
    pub energy: Energy,
    /// Momentum along the axis of travel, kg m/s.
    pub momentum: Momentum,
}

/// Energy by component, J.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Energy {
    /// Moving fibres, both kinds.
    pub kinetic: f64,
    /// Stretched fibres, both kinds.
    pub stored: f64,
    /// What dashpots and artificial viscosity have taken.
    #[serde(default)]
    pub dissipated: f64,
    /// The projectile.
    pub projectile: f64,
    /// At the moment of impact.
    pub initial: f64,
    /// Work of whatever keeps a projectile without mass at its velocity.
    pub work: f64,
    /// (kinetic + stored + dissipated + projectile) − (initial + work): zero if energy is conserved.
    pub residual: f64,
}

impl Balance {
    /// Whether every number is.
    pub fn is_finite(&self) -> bool {
        let (e, m) = (&self.energy, &self.momentum);
        // A residual sums all the others of its kind.
        [e.residual, m.residual, m.projectile, e.projectile].iter().all(|x| x.is_finite())
    }
}

impl Energy {
    /// The residual over the energy that was put in.
    pub fn relative_residual(&self) -> f64 {
        self.residual / (self.initial + self.work.abs())
    }

    /// How far off the balance is, over the energy that was put in: the residual, or by how much more
    /// than all that was put in a single part is. Parts may cancel: forward differences past their
    /// limit store what they take from the dashpots, without end.
    pub fn imbalance(&self) -> f64 {
        let greatest = self.kinetic.max(self.stored.abs()).max(self.dissipated.abs());
        let excess = greatest / (self.initial + self.work.abs()) - 1.0;
        self.relative_residual().abs().max(excess)
    }
}

/// Momentum by component, kg m/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Momentum {
    /// Moving fibres, both kinds.
    pub fibres: f64,
    /// The projectile.
    pub projectile: f64,
    /// At the moment of impact.
    pub initial: f64,
    /// Impulse of whatever keeps a projectile without mass at its velocity.
    pub drive: f64,
    /// Impulse of the clamps.
    pub clamps: f64,
    /// (fibres + projectile) − (initial + drive + clamps): zero if momentum is conserved.
    pub residual: f64,
}

impl<S: Number> State<S> {
    /// How many arms of a secondary the whole system has.
    fn arms(&self) -> S {
        match &self.crossover {
            Some(crossover) if !crossover.at_origin() => S::two() + S::two(),
            _ => S::two(),
        }
    }

    #[inline(always)]
    fn along_axis<const D: usize>(&self, v: &Vector<S, D>) -> S {
        self.projectile.axis.x * v[0] + self.projectile.axis.y * v[1]
    }

    /// `T_y` of (8): the first tension along the axis of travel, of both fibres where both are
    /// struck.
    #[inline(always)]
    pub fn first_tension_along_axis(&self) -> S {
        let primary = self.along_axis(&self.primary.pull[0]);
        match &self.crossover {
            Some(crossover) if crossover.at_origin() => {
                primary + self.along_axis(&crossover.fibre.pull[0])
            }
            _ => primary,
        }
    }

    /// Books the impulses of the coming step, whose tensions are those of now. Returns the first
    /// tension along the axis.
    #[inline(always)]
    pub fn account_for_impulses(&mut self) -> S {
        let first = self.first_tension_along_axis();
        let two_dt = S::two() * self.time_step;
        let mut clamps = two_dt * self.along_axis(self.primary.last_pull());
        if let Some(crossover) = &self.crossover {
            clamps += self.arms() * self.time_step * self.along_axis(crossover.fibre.last_pull());
        }
        self.accounts.clamp_impulse += clamps;
        if self.projectile.mass.is_none() {
            self.accounts.drive_impulse -= two_dt * first;
        }
        first
    }

    /// Books the work of the step just made: mean force times way.
    #[inline(always)]
    pub fn account_for_work(&mut self, first_before: S) {
        let way = self.along_axis(&self.primary.velocity[0]) * self.time_step;
        let force = first_before + self.first_tension_along_axis();
        let accounts = &mut self.accounts;
        accounts.fibre_work -= force * way;
        accounts.most_fibre_work = accounts.most_fibre_work.max(accounts.fibre_work);
        if self.projectile.mass.is_none() {
            accounts.drive_work -= force * way;
        }
    }

    /// How far the energy of the fibres without their first node is from the work done on them, over
    /// the most that they have been given. Beside a heavy projectile the whole balance does not show
    /// it: what the fibres have is a small part of what the projectile keeps.
    pub fn fibre_imbalance(&self, energy: &Energy) -> f64 {
        let node_mass = self.projectile_node_mass();
        let share = node_mass / (node_mass + self.projectile_mass());
        let [node, at_impact] =
            [self.middle_energy_of_first(), self.accounts.initial_energy * share];
        let has = energy.kinetic - node.to_f64() + energy.stored + energy.dissipated;
        let given = at_impact + self.accounts.most_fibre_work;
        (has - self.accounts.fibre_work.to_f64()) / given.to_f64()
    }

    /// Mean of the first node's velocities before and after, which belongs to its position.
    fn middle_velocity(&self) -> S {
        let node = self.along_axis(&self.primary.velocity[0]);
        S::half() * (node + self.projectile.velocity)
    }

    /// Kinetic energy of the first node's own mass.
    fn middle_energy_of_first(&self) -> S {
        let mid = self.middle_velocity();
        S::half() * self.projectile_node_mass() * mid * mid
    }

    /// Draws the balance. `paper` must be the edition of the march, without a tracer.
    pub fn balance(&self, paper: &impl Paper<S>, measure: Strain) -> Balance {
        let two = S::two();
        let arms = self.arms();
        let half = S::half();

        // The first node: half a lump each half, and the projectile.
        let node = self.along_axis(&self.primary.velocity[0]);
        let node_mass = self.projectile_node_mass();
        let mid = self.middle_velocity();

        let mut momentum =
            node_mass * node + two * self.primary.inner_momentum(|v| self.along_axis(v));
        let mut kinetic = self.middle_energy_of_first();
        let of_primary = self.primary.energies(measure);
        let mut stored = two * of_primary.stored;
        let mut dissipated = two * of_primary.dissipated;
        kinetic += two
            * self.primary.inner_kinetic_energy(paper, |i, v| match &self.crossover {
                Some(crossover) if crossover.node == i => {
                    crossover.push(paper, self.step, &self.primary, v)
                }
                _ => v,
            });
        if let Some(crossover) = &self.crossover {
            let fibre = &crossover.fibre;
            momentum += arms * fibre.inner_momentum(|v| self.along_axis(v));
            kinetic += arms * fibre.inner_kinetic_energy(paper, |_, v| v);
            let of_fibre = fibre.energies(measure);
            stored += arms * of_fibre.stored;
            dissipated += arms * of_fibre.dissipated;
            if !crossover.at_origin() {
                let first_mass = half * fibre.properties.mass;
                momentum += arms * first_mass * self.along_axis(&fibre.velocity[0]);
                let mid = self.middle_velocity_of_first(paper);
                kinetic += arms * half * first_mass * mid.dot(&mid);
            }
        }

        let mass = self.projectile_mass();
        let projectile = half * mass * mid * mid;
        let accounts = &self.accounts;
        let energy = Energy {
            kinetic: kinetic.to_f64(),
            stored: stored.to_f64(),
            dissipated: dissipated.to_f64(),
            projectile: projectile.to_f64(),
            initial: accounts.initial_energy.to_f64(),
            work: accounts.drive_work.to_f64(),
            residual: (kinetic + stored + dissipated + projectile
                - accounts.initial_energy
                - accounts.drive_work)
                .to_f64(),
        };
        let entered = accounts.initial_momentum + accounts.drive_impulse + accounts.clamp_impulse;
        let momentum = Momentum {
            fibres: momentum.to_f64(),
            projectile: (mass * node).to_f64(),
            initial: accounts.initial_momentum.to_f64(),
            drive: accounts.drive_impulse.to_f64(),
            clamps: accounts.clamp_impulse.to_f64(),
            residual: (momentum + mass * node - entered).to_f64(),
        };
        Balance { energy, momentum }
    }

    /// The secondary's first node at the time of the positions: the mean of what (9)–(14) made of the
    /// velocity of the crossover's node, and of what they will make of it where the primary will be.
    fn middle_velocity_of_first(&self, paper: &impl Paper<S>) -> Vector<S, 3> {
        let Some(crossover) = &self.crossover else {
            return Vector::zeros();
        };
        let (ix, primary) = (crossover.node, &self.primary);
        let next = crossover.push(paper, self.step, primary, primary.next_velocity(paper, ix));
        let before = match ix - 1 {
            0 => self.projectile.axis * self.projectile.velocity,
            inner => primary.next_velocity(paper, inner),
        };
        let moved = |i: usize, velocity| primary.position[i] + velocity * self.time_step;
        let theta = paper.eqn_11_direction(moved(ix, next), moved(ix - 1, before));
        (crossover.fibre.velocity[0] + crossover.impose(paper, next, theta)) * S::half()
    }
}

impl<S: Number, const D: usize> FibreState<S, D> {
    /// The pull of the clamp.
    fn last_pull(&self) -> &Vector<S, D> {
        &self.pull[self.elements() - 1]
    }

    /// What (2) will make of an inner node's velocity in the next step.
    fn next_velocity(&self, paper: &impl Paper<S>, i: usize) -> Vector<S, D> {
        paper.eqn_2_velocity(self.velocity[i], self.properties.a, self.pull[i], self.pull[i - 1])
    }

    /// Σ Δm v over the inner nodes, in the direction that `component` takes.
    fn inner_momentum(&self, component: impl Fn(&Vector<S, D>) -> S) -> S {
        let sum = self.inner_nodes().fold(S::zero(), |sum, i| sum + component(&self.velocity[i]));
        self.properties.mass * sum
    }

    /// Σ ½ Δm v² over the inner nodes with velocities at the time of the positions.
    fn inner_kinetic_energy(
        &self,
        paper: &impl Paper<S>,
        adjust: impl Fn(usize, Vector<S, D>) -> Vector<S, D>,
    ) -> S {
        let sum = self.inner_nodes().fold(S::zero(), |sum, i| {
            let next = adjust(i, self.next_velocity(paper, i));
            let mid = (self.velocity[i] + next) * S::half();
            sum + mid.dot(&mid)
        });
        S::half() * self.properties.mass * sum
    }

    fn inner_nodes(&self) -> std::ops::Range<usize> {
        1..self.elements()
    }

    /// What the elements have stored and dissipated, J.
    fn energies(&self, measure: Strain) -> PathEnergy<S> {
        match (&self.constitution, measure) {
            (None, _) => {
                PathEnergy { stored: self.energy_stored_by_7(measure), dissipated: S::zero() }
            }
            (Some(constitution), Strain::Incremental) => constitution.path,
            (Some(constitution), Strain::Engineering) => {
                constitution.energies(&self.strain, &self.unstrained)
            }
        }
    }

    /// Σ of the energy of (7) per reference length, J.
    fn energy_stored_by_7(&self, measure: Strain) -> S {
        let density = |e: S| match measure {
            Strain::Engineering => S::half() * e * e,
            Strain::Incremental => logarithmic_energy(e),
        };
        let sum = (0..self.elements())
            .fold(S::zero(), |sum, i| sum + density(self.strain[i]) * self.unstrained[i]);
        self.properties.stiffness * sum
    }
}

/// `(e − 1) exp e + 1`, the energy of T = ln λ per reference length at e = ln λ.
///
/// As it stands it loses all digits at small strain, so there it is summed as
/// Σ (k − 1) e^k / k! from k = 2, up to the last term that counts.
fn logarithmic_energy<S: Number>(e: S) -> S {
    let half = S::half();
    if e > half || e < -half {
        return (e - S::one()) * e.exp() + S::one();
    }
    let (mut power, mut sum, mut k) = (S::half() * e * e, S::zero(), 2);
    loop {
        let next = sum + S::count(k - 1) * power;
        if next == sum || !next.is_finite() {
            return next;
        }
        sum = next;
        k += 1;
        power = power * e / S::count(k);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_energy_of_the_logarithmic_law_keeps_its_digits_in_a_fibre_pressed_to_nothing() {
        // (e − 1) exp e + 1 is nearly 1; the terms of its series are as great as 10¹².
        let e = -31.7_f64;
        let expected = 1.0 - 32.7 * Number::exp(e);
        assert!((logarithmic_energy(e) - expected).abs() < 1e-15);
        assert!(logarithmic_energy(f64::NAN).is_nan());
    }

    #[test]
    fn a_balance_with_one_number_that_is_none_is_not_finite() {
        let numbers = |n: usize| (0..n).map(|i| 1.7 + i as f64);
        let json = |names: &[&str]| -> serde_json::Value {
            names.iter().map(|name| (*name).to_owned()).zip(numbers(names.len())).collect()
        };
        let energy =
            ["kinetic", "stored", "dissipated", "projectile", "initial", "work", "residual"];
        let momentum = ["fibres", "projectile", "initial", "drive", "clamps", "residual"];
        let balance = serde_json::json!({ "energy": json(&energy), "momentum": json(&momentum) });
        let balance: Balance = serde_json::from_value(balance).unwrap();
        assert!(balance.is_finite());
        for spoil in [
            |b: &mut Balance| b.energy.residual = f64::NAN,
            |b: &mut Balance| b.energy.projectile = f64::INFINITY,
            |b: &mut Balance| b.momentum.residual = f64::NEG_INFINITY,
            |b: &mut Balance| b.momentum.projectile = f64::NAN,
        ] {
            let mut spoilt = balance;
            spoil(&mut spoilt);
            assert!(!spoilt.is_finite(), "{spoilt:?}");
        }
    }

    /// dW/dλ = ln λ: the energy is the integral of the tension, by Simpson's rule (error h⁴, here
    /// under 1e-12 of the value).
    #[test]
    fn the_energy_of_the_logarithmic_law_is_the_integral_of_its_tension() {
        for stretch in [0.71_f64, 1.000_3, 1.014_4, 1.37, 2.9] {
            let n = 4000;
            let h = (stretch - 1.0) / f64::from(n);
            let tension = |k: i32| Number::ln(1.0 + f64::from(k) * h);
            let sum: f64 =
                (0..n).step_by(2).map(|k| tension(k) + 4.0 * tension(k + 1) + tension(k + 2)).sum();
            let expected = sum * h / 3.0;
            let energy = logarithmic_energy(Number::ln(stretch));
            // ln(1 + x) of a rounded 1 + x: 1e-16 of 3e-4 in the smallest case.
            assert!((energy / expected - 1.0).abs() < 1e-11, "{stretch}: {energy} {expected}");
        }
    }
}
