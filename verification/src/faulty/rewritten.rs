//! Editions with every equation in other words: equal in algebra, other in their last digits.
//!
//! They are the corrected edition; as printed there is nothing to rewrite.

use std::marker::PhantomData;

use crossfibre::corrected::{Corrected, StrainMeasure};
use crossfibre::equations::{Equation, Line};
use crossfibre::errata::Corrections;
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush, StressByLaw,
};

/// How the equations are put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Products multiplied out, differences taken first, the crossover's node in the directions of
    /// the fibre.
    Expanded,
    /// Roots scaled against overflow, angles by their tangent, reciprocals, sums of products as means.
    Factored,
}

impl Style {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Expanded, Self::Factored];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Expanded => "expanded",
            Self::Factored => "factored",
        }
    }
}

/// The corrected edition in other words.
#[derive(Clone, Copy, Debug)]
pub struct Rewritten<M> {
    style: Style,
    measure: PhantomData<M>,
}

impl<M: StrainMeasure> Rewritten<M> {
    /// In this style.
    pub fn new(style: Style) -> Self {
        Self { style, measure: PhantomData }
    }

    fn reference(&self) -> Corrected<M> {
        Corrected::new(Corrections::ALL)
    }

    fn length<S: Number, const D: usize>(&self, v: Vector<S, D>) -> S {
        match self.style {
            // The squares from the last to the first.
            Style::Expanded => {
                v.iter().rev().fold(S::zero(), |sum, &component| sum + component * component).sqrt()
            }
            Style::Factored => {
                let size = v.iter().fold(S::zero(), |size, &x| Number::max(size, Number::abs(x)));
                if size == S::zero() {
                    return size;
                }
                let scaled = v / size;
                size * scaled.dot(&scaled).sqrt()
            }
        }
    }
}

impl<S: Number, M: StrainMeasure> Paper<S> for Rewritten<M> {
    #[inline(always)]
    fn uses_previous_length(&self) -> bool {
        M::USES_PREVIOUS_LENGTH
    }

    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        Paper::<S>::lines(&self.reference(), equation)
    }

    fn eqn_1_impulse_residual<const D: usize>(
        &self,
        ahead: Vector<S, D>,
        here: Vector<S, D>,
        m: S,
        now: Vector<S, D>,
        before: Vector<S, D>,
    ) -> Vector<S, D> {
        match self.style {
            Style::Expanded => (ahead + before * m) - (here + now * m),
            Style::Factored => ((ahead - here) / m - (now - before)) * m,
        }
    }

    fn eqn_2_velocity<const D: usize>(
        &self,
        before: Vector<S, D>,
        a: S,
        ahead: Vector<S, D>,
        here: Vector<S, D>,
    ) -> Vector<S, D> {
        match self.style {
            Style::Expanded => (before + ahead * a) - here * a,
            Style::Factored => (before - here * a) + ahead * a,
        }
    }

    fn eqn_3_strain_increment(&self, length: S, before: S) -> S {
        match self.style {
            Style::Expanded => length / before - S::one(),
            Style::Factored => (length - before) * (S::one() / before),
        }
    }

    fn eqn_4_strain(&self, before: S, length: Lengths<S>) -> S {
        if !M::USES_PREVIOUS_LENGTH {
            let Lengths { now, unstrained, .. } = length;
            return match self.style {
                Style::Expanded => (now - unstrained) / unstrained,
                Style::Factored => now * (S::one() / unstrained) - S::one(),
            };
        }
        let Lengths { now, previous, .. } = length;
        match self.style {
            Style::Expanded => before + (now - previous) / previous,
            Style::Factored => (before - S::one()) + now * (S::one() / previous),
        }
    }

    fn eqn_5_previous_length<const D: usize>(&self, ahead: Vector<S, D>, here: Vector<S, D>) -> S {
        self.length(ahead - here)
    }

    fn eqn_6_length<const D: usize>(
        &self,
        x_ahead: Vector<S, D>,
        v_ahead: Vector<S, D>,
        x_here: Vector<S, D>,
        v_here: Vector<S, D>,
        dt: S,
    ) -> S {
        self.length((x_ahead - x_here) + (v_ahead - v_here) * dt)
    }

    fn eqn_7_tension(&self, stiffness: S, strain: S) -> S {
        match self.style {
            Style::Expanded => strain / (S::one() / stiffness),
            Style::Factored => stiffness * strain,
        }
    }

    fn eqn_7_tension_by_law(&self, area: S, by: StressByLaw<'_, S>) -> S {
        by.stress / (S::one() / area)
    }

    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        let mass = push.mass + push.node_mass;
        match self.style {
            Style::Expanded => push.velocity + push.tension_y * (S::two() * push.time_step / mass),
            Style::Factored => {
                (push.velocity * mass + S::two() * push.tension_y * push.time_step) / mass
            }
        }
    }

    fn eqn_9_parallel_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        match self.style {
            Style::Expanded => u / (S::one() / theta.cos) + v * theta.sin,
            Style::Factored => sum_of_products(u, theta.cos, v, theta.sin),
        }
    }

    fn eqn_10_perpendicular_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        match self.style {
            Style::Expanded => v / (S::one() / theta.cos) - u * theta.sin,
            Style::Factored => sum_of_products(v, theta.cos, -u, theta.sin),
        }
    }

    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        let element = here - behind;
        match self.style {
            Style::Expanded => {
                let length = self.length(element);
                let reciprocal = S::one() / length;
                Direction { cos: element.x * reciprocal, sin: element.y * reciprocal }
            }
            Style::Factored => {
                let of = |near: S, far: S| {
                    let slope = far / near;
                    let root = (S::one() + slope * slope).sqrt();
                    let of_near = if near < S::zero() { -S::one() } else { S::one() } / root;
                    (of_near, slope * of_near)
                };
                // By the tangent of the smaller angle, that to x or that to y.
                if Number::abs(element.x) < Number::abs(element.y) {
                    let (sin, cos) = of(element.y, element.x);
                    Direction { cos, sin }
                } else {
                    let (cos, sin) = of(element.x, element.y);
                    Direction { cos, sin }
                }
            }
        }
    }

    fn eqn_12_secondary_u(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        match self.style {
            Style::Expanded => slide * (parallel * theta.cos) - across * theta.sin,
            Style::Factored => sum_of_products(slide * parallel, theta.cos, -across, theta.sin),
        }
    }

    fn eqn_13_secondary_v(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        match self.style {
            Style::Expanded => slide * (parallel * theta.sin) + across * theta.cos,
            Style::Factored => sum_of_products(slide * parallel, theta.sin, across, theta.cos),
        }
    }

    fn eqn_15_parallel_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        match self.style {
            Style::Expanded => tension * phi_2.x * phi_1.x + tension * phi_2.y * phi_1.y,
            Style::Factored => tension * sum_of_products(phi_2.x, phi_1.x, phi_2.y, phi_1.y),
        }
    }

    fn eqn_16_perpendicular_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        match self.style {
            Style::Expanded => tension * phi_2.y * phi_1.x - tension * phi_2.x * phi_1.y,
            Style::Factored => tension * sum_of_products(phi_2.y, phi_1.x, -phi_2.x, phi_1.y),
        }
    }

    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        let Moved { along, across } = self.moved(&push);
        (u - push.change.x) + (along * push.primary.x - across * push.primary.y)
    }

    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        let Moved { along, across } = self.moved(&push);
        (v - push.change.y) + (along * push.primary.y + across * push.primary.x)
    }

    fn eqn_19_acceleration(&self, wave_speed: S, curvature: S) -> S {
        wave_speed * (wave_speed * curvature)
    }

    fn eqn_20_courant(&self, wave_speed: S, time_step: S, spacing: S) -> S {
        match self.style {
            Style::Expanded => (wave_speed * time_step) / spacing,
            Style::Factored => wave_speed / (spacing / time_step),
        }
    }
}

/// `a b + c d` as the mean of (a + c)(b + d) and (a − c)(b − d).
fn sum_of_products<S: Number>(a: S, b: S, c: S, d: S) -> S {
    S::half() * ((a + c) * (b + d) + (a - c) * (b - d))
}

/// The change of the crossover node's velocity in a step, along the primary fibre and across it.
struct Moved<S> {
    along: S,
    across: S,
}

impl<M> Rewritten<M> {
    /// All impulses of a step on all the mass that moves with the node, in the fibre's own
    /// directions.
    fn moved<S: Number>(&self, push: &CrossoverPush<S>) -> Moved<S> {
        let Cosines { x, y } = push.primary;
        let by_2 = (push.change.x * x + push.change.y * y, push.change.y * x - push.change.x * y);
        let pulled = S::two() * push.a;
        let along = by_2.0 + pulled * (push.slide_factor * push.parallel);
        let across = by_2.1 + pulled * push.perpendicular;
        let mass_along = push.mass + push.slide_factor * push.slide_factor * push.secondary_mass;
        let mass_across = push.mass + push.secondary_mass;
        match self.style {
            Style::Expanded => Moved {
                along: along * push.mass / mass_along,
                across: across * push.mass / mass_across,
            },
            Style::Factored => Moved {
                along: along / (mass_along / push.mass),
                across: across / (mass_across / push.mass),
            },
        }
    }
}
