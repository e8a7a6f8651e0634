//! The edition of the paper that the checks march by.

use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::equations::{Equation, Line};
use crossfibre::errata::Corrections;
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush, StressByLaw,
};
use crossfibre::scene::Strain;

use super::{Plant, now};
use crate::faulty::Faulty;
use crate::faulty::catalogue::Wrong;
use crate::faulty::rewritten::{Rewritten, Style};

/// The corrected edition of a measure of strain, or what is planted in its place.
///
/// It is one type whatever is planted, so that what is generic over editions is compiled for it once.
#[derive(Clone, Copy, Debug)]
pub struct Edition {
    strain: Strain,
    corrections: Corrections,
    words: Words,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Words {
    /// Those of [`Corrected`].
    Its,
    /// An equation is wrong.
    Wrong(Wrong),
    /// Every equation in other words.
    Other(Style),
}

/// The edition with these corrections and what is planted.
pub fn edition(strain: Strain, corrections: Corrections) -> Edition {
    Edition { strain, corrections, words: Words::of(now(), corrections) }
}

impl Words {
    fn of(planted: Option<Plant>, corrections: Corrections) -> Self {
        match planted {
            Some(Plant::Equation(wrong)) => Self::Wrong(wrong),
            // As printed there is nothing to rewrite.
            Some(Plant::Rewritten(style)) if corrections == Corrections::ALL => Self::Other(style),
            _ => Self::Its,
        }
    }
}

/// Whether what is planted is in the equations.
pub fn is_another() -> bool {
    matches!(now(), Some(Plant::Equation(_) | Plant::Rewritten(_)))
}

/// Calls a method of the edition that it stands for.
macro_rules! by {
    ($edition:expr, $paper:ident => $work:expr) => {{
        let Edition { strain, corrections, words } = *$edition;
        match strain {
            Strain::Incremental => by!(Incremental, corrections, words, $paper => $work),
            Strain::Engineering => by!(Engineering, corrections, words, $paper => $work),
        }
    }};
    ($measure:ident, $corrections:ident, $words:ident, $paper:ident => $work:expr) => {
        match $words {
            Words::Its => {
                let $paper = &Corrected::<$measure>::new($corrections);
                $work
            }
            Words::Wrong(wrong) => {
                let right = Corrected::<$measure>::new($corrections);
                let $paper = &Faulty::new(&right, wrong);
                $work
            }
            Words::Other(style) => {
                let $paper = &Rewritten::<$measure>::new(style);
                $work
            }
        }
    };
}

impl<S: Number> Paper<S> for Edition {
    fn uses_previous_length(&self) -> bool {
        self.strain == Strain::Incremental
    }

    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        by!(self, paper => Paper::<S>::lines(paper, equation))
    }

    fn eqn_1_impulse_residual<const D: usize>(
        &self,
        ahead: Vector<S, D>,
        here: Vector<S, D>,
        mass_over_time_step: S,
        now: Vector<S, D>,
        before: Vector<S, D>,
    ) -> Vector<S, D> {
        let m = mass_over_time_step;
        by!(self, paper => paper.eqn_1_impulse_residual(ahead, here, m, now, before))
    }

    fn eqn_2_velocity<const D: usize>(
        &self,
        before: Vector<S, D>,
        a: S,
        ahead: Vector<S, D>,
        here: Vector<S, D>,
    ) -> Vector<S, D> {
        by!(self, paper => paper.eqn_2_velocity(before, a, ahead, here))
    }

    fn eqn_3_strain_increment(&self, length: S, before: S) -> S {
        by!(self, paper => paper.eqn_3_strain_increment(length, before))
    }

    fn eqn_4_strain(&self, before: S, length: Lengths<S>) -> S {
        by!(self, paper => paper.eqn_4_strain(before, length))
    }

    fn eqn_5_previous_length<const D: usize>(&self, ahead: Vector<S, D>, here: Vector<S, D>) -> S {
        by!(self, paper => paper.eqn_5_previous_length(ahead, here))
    }

    fn eqn_6_length<const D: usize>(
        &self,
        x_ahead: Vector<S, D>,
        v_ahead: Vector<S, D>,
        x_here: Vector<S, D>,
        v_here: Vector<S, D>,
        dt: S,
    ) -> S {
        by!(self, paper => paper.eqn_6_length(x_ahead, v_ahead, x_here, v_here, dt))
    }

    fn eqn_7_tension(&self, stiffness: S, strain: S) -> S {
        by!(self, paper => paper.eqn_7_tension(stiffness, strain))
    }

    fn eqn_7_tension_by_law(&self, area: S, stress: StressByLaw<'_, S>) -> S {
        by!(self, paper => paper.eqn_7_tension_by_law(area, stress))
    }

    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        by!(self, paper => paper.eqn_8_projectile_velocity(push))
    }

    fn eqn_9_parallel_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        by!(self, paper => paper.eqn_9_parallel_velocity(u, v, theta))
    }

    fn eqn_10_perpendicular_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        by!(self, paper => paper.eqn_10_perpendicular_velocity(u, v, theta))
    }

    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        by!(self, paper => paper.eqn_11_direction(here, behind))
    }

    fn eqn_12_secondary_u(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        by!(self, paper => paper.eqn_12_secondary_u(slide, parallel, across, theta))
    }

    fn eqn_13_secondary_v(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        by!(self, paper => paper.eqn_13_secondary_v(slide, parallel, across, theta))
    }

    fn eqn_14_secondary_w(&self) -> S {
        by!(self, paper => paper.eqn_14_secondary_w())
    }

    fn eqn_15_parallel_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        by!(self, paper => paper.eqn_15_parallel_tension(tension, phi_2, phi_1))
    }

    fn eqn_16_perpendicular_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        by!(self, paper => paper.eqn_16_perpendicular_tension(tension, phi_2, phi_1))
    }

    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        by!(self, paper => paper.eqn_17_u_at_crossover(u, push))
    }

    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        by!(self, paper => paper.eqn_18_v_at_crossover(v, push))
    }

    fn eqn_19_acceleration(&self, wave_speed: S, curvature: S) -> S {
        by!(self, paper => paper.eqn_19_acceleration(wave_speed, curvature))
    }

    fn eqn_20_courant(&self, wave_speed: S, time_step: S, spacing: S) -> S {
        by!(self, paper => paper.eqn_20_courant(wave_speed, time_step, spacing))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_planted_in_equations_changes_their_words_and_a_rewrite_only_all_corrections() {
        let (wrong, style) = (Wrong::ALL[0], Style::ALL[0]);
        let words = |planted| {
            [Corrections::ALL, Corrections::NONE].map(|corrections| Words::of(planted, corrections))
        };
        assert_eq!(words(None), [Words::Its; 2]);
        assert_eq!(words(Some(Plant::Equation(wrong))), [Words::Wrong(wrong); 2]);
        assert_eq!(words(Some(Plant::Rewritten(style))), [Words::Other(style), Words::Its]);
    }
}
