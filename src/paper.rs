//! The paper: its twenty numbered equations, one method each, **as printed**.
//!
//! [`Printed`] overrides nothing. Every departure from the page is an override in
//! [`crate::errata`], so the list of overrides there is the list of departures.
//!
//! Conventions of the page, kept throughout:
//!
//! | symbol | meaning | unit, shape |
//! |---|---|---|
//! | `i`, `ix` | node; the crossover's node on the primary fibre (1-based on the page, 0-based here) | |
//! | superscript `t`, `t−1` | now, one time step ago | |
//! | `x_i`, `v_i` | position and velocity of node `i`; `v_i^t` carries `x_i^{t−1}` to `x_i^t` | m, m/s; vector |
//! | `T_i` | tension of the element from node `i` to `i+1`, pointing from `i` to `i+1` | N; vector |
//! | `ε_i`, `L_i` | strain and length of that element | 1, m |
//! | `Δm`, `A = Δt/Δm` | lumped mass of a node, and the page's abbreviation | kg, s/kg |
//! | `φ1`, `φ2` | direction angles of the primary and secondary fibre at the crossover | |
//! | `θ` | angle of the primary fibre to the x-axis at the crossover | |
//! | `α_s`, `α` | slide factor, Courant number | 1 |
//!
//! The page leaves the cross-section out: its `T = Eε` is force per area. Here a tension is a force
//! in newtons, and the `E` of (7) stands for modulus × area (ledger id `cross-section`).

use crate::equations::{Equation, Line};
use crate::number::{Number, Vector};
use crate::place::Place;

/// The three lengths of an element that a strain measure may look at, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lengths<S> {
    /// `L_i^t`, now.
    pub now: S,
    /// `L_i^{t−1}`, one step ago.
    pub previous: S,
    /// `L_i^0`, unstrained.
    pub unstrained: S,
}

/// What a law other than (7) makes of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressByLaw<'a, S> {
    /// σ, Pa.
    pub stress: S,
    /// `ε_i^{t−1}`.
    pub strain_before: S,
    /// `ε_i^t`.
    pub strain: S,
    /// What the element remembers for its law after the step.
    pub memory: Remembered<'a, S>,
}

/// What one element of many remembers; looked up by who wants to see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remembered<'a, S> {
    /// Of all elements, one after the other.
    pub of_all: &'a [S],
    /// How many numbers each remembers.
    pub each: usize,
    /// The element.
    pub element: usize,
}

impl<'a, S> Remembered<'a, S> {
    /// The element's numbers.
    pub fn numbers(&self) -> &'a [S] {
        &self.of_all[self.element * self.each..][..self.each]
    }
}

/// A direction in the x-y plane by its cosine and sine.
///
/// `θ` enters (9), (10), (12) and (13) only through these two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction<S> {
    /// cos θ.
    pub cos: S,
    /// sin θ.
    pub sin: S,
}

/// The direction cosines of a fibre at the crossover, as far as (15)–(18) use them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cosines<S> {
    /// cos φ_x.
    pub x: S,
    /// cos φ_y.
    pub y: S,
}

/// What (8) is evaluated with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectilePush<S> {
    /// `v_p^{t−1}`, m/s.
    pub velocity: S,
    /// `T_y`: the component of the first element's tension along the direction of travel, N.
    /// With `T` pointing away from the projectile's node it is negative while the fibre trails.
    pub tension_y: S,
    /// `m_p`, kg.
    pub mass: S,
    /// Mass lumped on the projectile's own node, both halves, kg.
    pub node_mass: S,
    /// `Δt`, s.
    pub time_step: S,
    /// `t`, the time since impact, s.
    pub time: S,
}

/// What (17) and (18) are evaluated with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossoverPush<S: Number> {
    /// `A = Δt/Δm` of the primary fibre, s/kg.
    pub a: S,
    /// `α_s`.
    pub slide_factor: S,
    /// `T2'_perp` by (16), N.
    pub perpendicular: S,
    /// `T2'_para` by (15), N.
    pub parallel: S,
    /// `cos φ1_x` and `cos φ1_y`: the direction of the primary fibre.
    pub primary: Cosines<S>,
    /// The velocity change that (2) has just given the node, m/s.
    pub change: Vector<S, 2>,
    /// Lumped mass of a node of the primary, kg.
    pub mass: S,
    /// Lumped mass of the secondary's first node, both arms, kg.
    pub secondary_mass: S,
}

/// The paper as a trait: a method for each numbered equation, whose default body is the page.
pub trait Paper<S: Number> {
    /// How many elements the march may take up at once: 96 in doubles, whose vectors on the primary
    /// fibre take 72 bytes an element, 7 KiB in all. The processor's first-level cache then holds a
    /// block and has room for the next ones on their way from memory. A tracer takes one, and sees
    /// the page's recursion.
    const BLOCK: usize = 768 / size_of::<S>();

    /// The same for a fibre with another law than (7). Its energies are summed by blocks, so that their
    /// last bits depend on it.
    const BLOCK_BY_LAW: usize = 384;

    /// Says where the next equations are evaluated. Only a tracer listens.
    #[inline(always)]
    fn at(&self, _place: Place) {}

    /// Whether the strain measure looks at `L_i^{t−1}`; if not, (5) is left out of a step.
    #[inline(always)]
    fn uses_previous_length(&self) -> bool {
        true
    }

    /// The lines by which this edition works out an equation; those of the page by default.
    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        equation.lines.to_vec()
    }

    // ---------------------------------------------------------------- momentum balance

    /// **(1)** `T_{i+1}^{t−1} − T_i^{t−1} = (Δm/Δt)(v_{i+1}^t − v_{i+1}^{t−1})`
    ///
    /// Impulse and momentum of node `i+1` over one step. Returns the left side less the right, in
    /// newtons: zero when the balance holds. The march uses its solved form (2); this form is what
    /// a finished step is audited with.
    #[inline(always)]
    fn eqn_1_impulse_residual<const D: usize>(
        &self,
        tension_ahead: Vector<S, D>,
        tension_here: Vector<S, D>,
        mass_over_time_step: S,
        velocity: Vector<S, D>,
        previous_velocity: Vector<S, D>,
    ) -> Vector<S, D> {
        tension_ahead - tension_here - (velocity - previous_velocity) * mass_over_time_step
    }

    /// **(2)** `v_{i+1}^t = v_{i+1}^{t−1} + A (T_{i+1}^{t−1} − T_i^{t−1})`
    ///
    /// `v` in m/s, `A` in s/kg, `T` in N.
    #[inline(always)]
    fn eqn_2_velocity<const D: usize>(
        &self,
        previous_velocity: Vector<S, D>,
        a: S,
        tension_ahead: Vector<S, D>,
        tension_here: Vector<S, D>,
    ) -> Vector<S, D> {
        previous_velocity + (tension_ahead - tension_here) * a
    }

    // ---------------------------------------------------------------- strain-displacement

    /// **(3)** `Δε_i = (L_i^t − L_i^{t−1}) / L_i^t`
    ///
    /// The increment of strain. Not the increment of (4), which divides by `L_i^{t−1}`: ledger id
    /// `strain-denominator`. The march advances the strain by (4).
    #[inline(always)]
    fn eqn_3_strain_increment(&self, length: S, previous_length: S) -> S {
        (length - previous_length) / length
    }

    /// **(4)** `ε_i^t = ε_i^{t−1} + (L_i^t / L_i^{t−1}) − 1`
    ///
    /// The accumulated strain. Summed over many small steps it tends to ln(L/L⁰).
    #[inline(always)]
    fn eqn_4_strain(&self, previous_strain: S, length: Lengths<S>) -> S {
        previous_strain + (length.now / length.previous) - S::one()
    }

    /// **(5)** `L_i^{t−1} = |x_{i+1}^{t−1} − x_i^{t−1}|`
    #[inline(always)]
    fn eqn_5_previous_length<const D: usize>(
        &self,
        position_ahead: Vector<S, D>,
        position_here: Vector<S, D>,
    ) -> S {
        magnitude(position_ahead - position_here)
    }

    /// **(6)** `L_i^t = |x_{i+1}^t − x_i^t| = |(x_{i+1}^{t−1} + v_{i+1}^t Δt) − (x_i^{t−1} + v_i^t Δt)|`
    #[inline(always)]
    fn eqn_6_length<const D: usize>(
        &self,
        position_ahead: Vector<S, D>,
        velocity_ahead: Vector<S, D>,
        position_here: Vector<S, D>,
        velocity_here: Vector<S, D>,
        time_step: S,
    ) -> S {
        magnitude(
            (position_ahead + velocity_ahead * time_step)
                - (position_here + velocity_here * time_step),
        )
    }

    // ---------------------------------------------------------------- constitutive relation

    /// **(7)** `T_i^t = E ε_i^t`
    ///
    /// `stiffness` is modulus × area in newtons (ledger id `cross-section`).
    #[inline(always)]
    fn eqn_7_tension(&self, stiffness: S, strain: S) -> S {
        stiffness * strain
    }

    /// **(7)** with another law than the page's in the place of `E ε`: `T_i^t = area × σ_i^t`
    ///
    /// "Other constitutive models could also be used without difficulty": σ is what
    /// [`crate::material`] makes of the strain.
    #[inline(always)]
    fn eqn_7_tension_by_law(&self, area: S, by: StressByLaw<'_, S>) -> S {
        area * by.stress
    }

    // ---------------------------------------------------------------- projectile

    /// **(8)** `−2T_y = m_p Δv_p/Δt = m_p (v_p^t − v_p^{t−1}) / t`
    ///
    /// Solved for `v_p^t` as it stands, with its `t` and its sign. Ledger ids
    /// `projectile-interval`, `projectile-sign`, `projectile-inertia`.
    #[inline]
    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        push.velocity - S::two() * push.tension_y * push.time / push.mass
    }

    // ---------------------------------------------------------------- crossover

    /// **(9)** `v_para^t = u_ix^t cos θ_ix^t + v_ix^t sin θ_ix^t`
    #[inline]
    fn eqn_9_parallel_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        u * theta.cos + v * theta.sin
    }

    /// **(10)** `v_perp^t = v_ix^t cos θ_ix^t − u_ix^t sin θ_ix^t`
    #[inline]
    fn eqn_10_perpendicular_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        v * theta.cos - u * theta.sin
    }

    /// **(11)** `θ_ix^t = tan⁻¹[(y1_ix^t − y1_{ix−1}^t) / (x1_ix^t − x1_{ix−1}^t)]`
    ///
    /// Returned as cos θ and sin θ, the only forms in which it is used. Undefined at `ix = 1`:
    /// ledger id `theta-at-origin`.
    #[inline]
    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        let theta = ((here.y - behind.y) / (here.x - behind.x)).atan();
        Direction { cos: theta.cos(), sin: theta.sin() }
    }

    /// **(12)** `u2_1^t = α_s v_para^t cos θ_ix^t − v_perp^t sin θ_ix^t`
    #[inline]
    fn eqn_12_secondary_u(
        &self,
        slide_factor: S,
        parallel: S,
        perpendicular: S,
        theta: Direction<S>,
    ) -> S {
        slide_factor * parallel * theta.cos - perpendicular * theta.sin
    }

    /// **(13)** `v2_1^t = α_s v_para^t sin θ_ix^t + v_perp^t cos θ_ix^t`
    #[inline]
    fn eqn_13_secondary_v(
        &self,
        slide_factor: S,
        parallel: S,
        perpendicular: S,
        theta: Direction<S>,
    ) -> S {
        slide_factor * parallel * theta.sin + perpendicular * theta.cos
    }

    /// **(14)** `w2_1^t = 0`
    #[inline]
    fn eqn_14_secondary_w(&self) -> S {
        S::zero()
    }

    /// **(15)** `T2_para^t = T2_1^t [cos φ2_x cos φ1_x + cos φ2_y cos φ1_y]`
    ///
    /// `T2_1` is taken at `t−1`: ledger id `time-level`.
    #[inline]
    fn eqn_15_parallel_tension(&self, tension: S, secondary: Cosines<S>, primary: Cosines<S>) -> S {
        tension * (secondary.x * primary.x + secondary.y * primary.y)
    }

    /// **(16)** `T2_perp^t = T2_1^t [cos φ2_x cos φ1_x − cos φ2_y cos φ1_y]`
    ///
    /// Not the component along the normal: ledger id `perpendicular-resolution`.
    #[inline]
    fn eqn_16_perpendicular_tension(
        &self,
        tension: S,
        secondary: Cosines<S>,
        primary: Cosines<S>,
    ) -> S {
        tension * (secondary.x * primary.x - secondary.y * primary.y)
    }

    /// **(17)** `u_{i+1}^t ← u_{i+1}^t + 2A [T2'_perp cos φ1_y + α_s T2'_para cos φ1_x]`
    ///
    /// Ledger ids `perpendicular-sign`, `crossover-inertia`.
    #[inline]
    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        u + S::two()
            * push.a
            * (push.perpendicular * push.primary.y
                + push.slide_factor * push.parallel * push.primary.x)
    }

    /// **(18)** `v_{i+1}^t ← v_{i+1}^t + 2A [T2'_perp cos φ1_x + α_s T2'_para cos φ1_y]`
    ///
    /// Ledger id `crossover-inertia`.
    #[inline]
    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        v + S::two()
            * push.a
            * (push.perpendicular * push.primary.x
                + push.slide_factor * push.parallel * push.primary.y)
    }

    // ---------------------------------------------------------------- stability

    /// **(19)** `∂²u/∂t² = c² (∂²u/∂x²)`
    ///
    /// Returns the left side, the acceleration in m/s², from the curvature ∂²u/∂x² in 1/m. The
    /// march does not use it; the axial scheme is held against it.
    #[inline]
    fn eqn_19_acceleration(&self, wave_speed: S, curvature: S) -> S {
        wave_speed * wave_speed * curvature
    }

    /// **(20)** `α = c (Δt/Δx)`
    #[inline]
    fn eqn_20_courant(&self, wave_speed: S, time_step: S, spacing: S) -> S {
        wave_speed * (time_step / spacing)
    }
}

/// `|v|`, the bars of (5) and (6): square root of the sum of squares, in the order of components.
#[inline(always)]
pub fn magnitude<S: Number, const D: usize>(v: Vector<S, D>) -> S {
    v.dot(&v).sqrt()
}

/// The page as printed: nothing is overridden.
#[derive(Clone, Copy, Debug, Default)]
pub struct Printed;

impl<S: Number> Paper<S> for Printed {}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    use super::*;

    fn vector() -> impl Strategy<Value = Vector<f64, 3>> {
        prop::array::uniform3(-977.0..977.0).prop_map(Into::into)
    }

    proptest! {
        /// (2) is (1) solved: put back into it, nothing is left but the rounding of a velocity of up
        /// to 1e3 + 2e3 A, times Δm/Δt = 1/A, a few units of 2.2e-16.
        #[test]
        fn the_solved_form_satisfies_the_balance(
            before in vector(), ahead in vector(), here in vector(), a in 1e-3..1e3_f64,
        ) {
            let paper = &Printed;
            let v = paper.eqn_2_velocity(before, a, ahead, here);
            let residual = paper.eqn_1_impulse_residual(ahead, here, 1.0 / a, v, before);
            let rounding = 8.0 * f64::EPSILON * (2e3 + 1e3 / a);
            assert_abs_diff_eq!(residual, Vector::zeros(), epsilon = rounding);
        }
    }
}
