//! The edition of the paper that makes the ledger's corrections.
//!
//! [`Corrected`] overrides exactly the equations that [`crate::errata`] changes. With an empty set
//! of corrections it is [`crate::paper::Printed`] to the bit.

use std::marker::PhantomData;

use crate::equations::{Equation, Line, line};
use crate::errata::{Corrections, Erratum};
use crate::number::{Number, Vector};
use crate::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, Printed, ProjectilePush, magnitude,
};

/// How strain is measured.
pub trait StrainMeasure: Clone + Copy + Send + Sync + 'static {
    /// The lines by which it is worked out, where they are not those of (4).
    const LINE: Option<Line>;
    /// Whether it looks at the length of one step ago.
    const USES_PREVIOUS_LENGTH: bool;
    /// The strain now.
    fn strain<S: Number>(previous_strain: S, length: Lengths<S>) -> S;
}

/// The paper's measure, eqn (4).
#[derive(Clone, Copy, Debug)]
pub struct Incremental;

impl StrainMeasure for Incremental {
    const LINE: Option<Line> = None;
    const USES_PREVIOUS_LENGTH: bool = true;
    #[inline(always)]
    fn strain<S: Number>(previous_strain: S, length: Lengths<S>) -> S {
        Printed.eqn_4_strain(previous_strain, length)
    }
}

/// The engineering measure in place of (4): `ε = L^t/L⁰ − 1`. Not the paper's.
#[derive(Clone, Copy, Debug)]
pub struct Engineering;

impl StrainMeasure for Engineering {
    const LINE: Option<Line> = Some(line("strain", "{L} / {L_0} - 1"));
    const USES_PREVIOUS_LENGTH: bool = false;
    #[inline(always)]
    fn strain<S: Number>(_previous_strain: S, length: Lengths<S>) -> S {
        length.now / length.unstrained - S::one()
    }
}

/// The paper with any subset of the ledger's corrections.
#[derive(Clone, Copy, Debug)]
pub struct Corrected<M = Incremental> {
    corrections: Corrections,
    measure: PhantomData<M>,
}

impl<M: StrainMeasure> Corrected<M> {
    /// The edition with these corrections.
    pub fn new(corrections: Corrections) -> Self {
        Self { corrections, measure: PhantomData }
    }

    fn has(&self, erratum: Erratum) -> bool {
        self.corrections.has(erratum)
    }
}

/// Of the velocity change that (2) gave the crossover's node, the part that belongs to the
/// secondary's first node: along the primary fibre and across it.
struct SecondaryShare<S> {
    along: S,
    across: S,
}

impl<M: StrainMeasure> Corrected<M> {
    /// Δm2's share of the moving mass: α_s² Δm2/(Δm1 + α_s² Δm2) along the fibre and
    /// Δm2/(Δm1 + Δm2) across; zero where the secondary's inertia is left out, as printed.
    fn secondary_share<S: Number>(&self, push: &CrossoverPush<S>) -> SecondaryShare<S> {
        if !self.has(Erratum::CrossoverInertia) {
            return SecondaryShare { along: S::zero(), across: S::zero() };
        }
        let along = push.slide_factor * push.slide_factor * push.secondary_mass;
        SecondaryShare {
            along: along / (push.mass + along),
            across: push.secondary_mass / (push.mass + push.secondary_mass),
        }
    }
}

impl<M: StrainMeasure> Corrected<M> {
    /// The lines of the equations that this edition changes: the same expressions as the overrides
    /// below, in the same order of operations.
    fn corrected_lines(&self, equation: u8) -> Option<Vec<Line>> {
        let choose = |erratum, name, corrected, printed| {
            line(name, if self.has(erratum) { corrected } else { printed })
        };
        match equation {
            3 if self.has(Erratum::StrainDenominator) => {
                Some(vec![line("d_strain", "({L} - {L_before}) / {L_before}")])
            }
            4 => M::LINE.map(|line| vec![line]),
            8 => Some(vec![
                choose(Erratum::ProjectileSign, "pull", "-{T_y}", "{T_y}"),
                choose(Erratum::ProjectileInterval, "interval", "{dt}", "{t}"),
                choose(Erratum::ProjectileInertia, "mass", "{m_p} + {m_node}", "{m_p}"),
                line("v_p", "{v_p_before} - 2 * {pull} * {interval} / {mass}"),
            ]),
            11 if self.has(Erratum::ThetaAtOrigin) => Some(vec![
                line("dx", "{x_here} - {x_behind}"),
                line("dy", "{y_here} - {y_behind}"),
                line("L", "sqrt({dx} * {dx} + {dy} * {dy})"),
                line("cos", "{dx} / {L}"),
                line("sin", "{dy} / {L}"),
            ]),
            16 if self.has(Erratum::PerpendicularResolution) => Some(vec![line(
                "T2_perp",
                "{T2} * ({cos_phi2_y} * {cos_phi1_x} - {cos_phi2_x} * {cos_phi1_y})",
            )]),
            17 | 18 => Some(self.crossover_lines(equation)),
            _ => None,
        }
    }

    fn crossover_lines(&self, equation: u8) -> Vec<Line> {
        let mut lines = Vec::new();
        if equation == 17 {
            let sign = self.has(Erratum::PerpendicularSign);
            lines.push(line("normal_x", if sign { "-{cos_phi1_y}" } else { "{cos_phi1_y}" }));
        }
        if self.has(Erratum::CrossoverInertia) {
            lines.extend(SHARES);
            lines.extend(if equation == 17 { U_WITH_INERTIA } else { V_WITH_INERTIA });
        } else {
            lines.push(if equation == 17 { U_ALONE } else { V_ALONE });
        }
        lines
    }
}

const SHARES: [Line; 5] = [
    line("along", "{du} * {cos_phi1_x} + {dv} * {cos_phi1_y}"),
    line("across", "{dv} * {cos_phi1_x} - {du} * {cos_phi1_y}"),
    line("m2_along", "{alpha_s} * {alpha_s} * {m2}"),
    line("share_along", "{m2_along} / ({m1} + {m2_along})"),
    line("share_across", "{m2} / ({m1} + {m2})"),
];

const U_ALONE: Line = line(
    "u",
    "{u_by_2} + 2 * {A} * ({T2_perp} * {normal_x} + {alpha_s} * {T2_para} * {cos_phi1_x})",
);

const V_ALONE: Line = line(
    "v",
    "{v_by_2} + 2 * {A} * ({T2_perp} * {cos_phi1_x} + {alpha_s} * {T2_para} * {cos_phi1_y})",
);

const U_WITH_INERTIA: [Line; 2] = [
    line(
        "taken_back",
        "{share_along} * {along} * {cos_phi1_x} - {share_across} * {across} * {cos_phi1_y}",
    ),
    line(
        "u",
        "{u_by_2} + 2 * {A} * ({T2_perp} * (1 - {share_across}) * {normal_x} \
         + {alpha_s} * {T2_para} * (1 - {share_along}) * {cos_phi1_x}) - {taken_back}",
    ),
];

const V_WITH_INERTIA: [Line; 2] = [
    line(
        "taken_back",
        "{share_along} * {along} * {cos_phi1_y} + {share_across} * {across} * {cos_phi1_x}",
    ),
    line(
        "v",
        "{v_by_2} + 2 * {A} * ({T2_perp} * (1 - {share_across}) * {cos_phi1_x} \
         + {alpha_s} * {T2_para} * (1 - {share_along}) * {cos_phi1_y}) - {taken_back}",
    ),
];

impl<S: Number, M: StrainMeasure> Paper<S> for Corrected<M> {
    #[inline(always)]
    fn uses_previous_length(&self) -> bool {
        M::USES_PREVIOUS_LENGTH
    }

    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        self.corrected_lines(equation.number).unwrap_or_else(|| equation.lines.to_vec())
    }

    /// (3) with `L_i^{t−1}` below the line (`strain-denominator`).
    fn eqn_3_strain_increment(&self, length: S, previous_length: S) -> S {
        if self.has(Erratum::StrainDenominator) {
            (length - previous_length) / previous_length
        } else {
            Paper::<S>::eqn_3_strain_increment(&Printed, length, previous_length)
        }
    }

    /// (4), or the scene's other measure of strain.
    #[inline(always)]
    fn eqn_4_strain(&self, previous_strain: S, length: Lengths<S>) -> S {
        M::strain(previous_strain, length)
    }

    /// `v_p^t = v_p^{t−1} + 2 T_y Δt/(m_p + Δm)` (`projectile-sign`, `projectile-interval`,
    /// `projectile-inertia`).
    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        let pull = if self.has(Erratum::ProjectileSign) { -push.tension_y } else { push.tension_y };
        let interval =
            if self.has(Erratum::ProjectileInterval) { push.time_step } else { push.time };
        let mass = if self.has(Erratum::ProjectileInertia) {
            push.mass + push.node_mass
        } else {
            push.mass
        };
        push.velocity - S::two() * pull * interval / mass
    }

    /// `cos θ = Δx/L`, `sin θ = Δy/L` (`theta-at-origin`).
    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        if self.has(Erratum::ThetaAtOrigin) {
            let element = here - behind;
            let length = magnitude(element);
            Direction { cos: element.x / length, sin: element.y / length }
        } else {
            Printed.eqn_11_direction(here, behind)
        }
    }

    /// `T2_perp = T2_1 [cos φ2_y cos φ1_x − cos φ2_x cos φ1_y]` (`perpendicular-resolution`).
    fn eqn_16_perpendicular_tension(
        &self,
        tension: S,
        secondary: Cosines<S>,
        primary: Cosines<S>,
    ) -> S {
        if self.has(Erratum::PerpendicularResolution) {
            tension * (secondary.y * primary.x - secondary.x * primary.y)
        } else {
            Printed.eqn_16_perpendicular_tension(tension, secondary, primary)
        }
    }

    /// (17) with the normal's x-part negative (`perpendicular-sign`) and the secondary's first node
    /// carried along (`crossover-inertia`): `A` becomes `A (1 − share)`, and the share of the
    /// impulse that (2) gave to the primary's node alone is taken back.
    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        let share = self.secondary_share(&push);
        let Cosines { x: cos_x, y: cos_y } = push.primary;
        let normal_x = if self.has(Erratum::PerpendicularSign) { -cos_y } else { cos_y };
        let taken_back = share.along * along(&push) * cos_x - share.across * across(&push) * cos_y;
        u + S::two()
            * push.a
            * (push.perpendicular * (S::one() - share.across) * normal_x
                + push.slide_factor * push.parallel * (S::one() - share.along) * cos_x)
            - taken_back
    }

    /// (18) with the secondary's first node carried along (`crossover-inertia`).
    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        let share = self.secondary_share(&push);
        let Cosines { x: cos_x, y: cos_y } = push.primary;
        let taken_back = share.along * along(&push) * cos_y + share.across * across(&push) * cos_x;
        v + S::two()
            * push.a
            * (push.perpendicular * (S::one() - share.across) * cos_x
                + push.slide_factor * push.parallel * (S::one() - share.along) * cos_y)
            - taken_back
    }
}

/// The velocity change by (2), along the primary fibre.
fn along<S: Number>(push: &CrossoverPush<S>) -> S {
    push.change.x * push.primary.x + push.change.y * push.primary.y
}

/// The velocity change by (2), along the normal (−cos φ1_y, cos φ1_x).
fn across<S: Number>(push: &CrossoverPush<S>) -> S {
    push.change.y * push.primary.x - push.change.x * push.primary.y
}
