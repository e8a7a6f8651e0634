//! Editions that are wrong in one equation, and editions that are right in other words.
//!
//! A check that catches no [`Faulty`] edition checks nothing; one that fails a [`rewritten`] edition
//! judges taste.

pub mod catalogue;
pub mod rewritten;

use crossfibre::equations::{Equation, Line};
use crossfibre::number::{Number, Vector};
use crossfibre::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush, StressByLaw,
};

use catalogue::Wrong;

/// An edition with one equation transcribed wrongly.
#[derive(Clone, Copy, Debug)]
pub struct Faulty<'p, P> {
    paper: &'p P,
    wrong: Wrong,
}

impl<'p, P> Faulty<'p, P> {
    /// An edition with this fault.
    pub fn new(paper: &'p P, wrong: Wrong) -> Self {
        Self { paper, wrong }
    }
}

/// A vector without its last component.
fn flat<S: Number, const D: usize>(mut v: Vector<S, D>) -> Vector<S, D> {
    v[D - 1] = S::zero();
    v
}

/// As a variable in single precision would keep it.
fn single<S: Number>(x: S) -> S {
    let double = x.to_f64();
    // A difference, so that a number that carries its derivative keeps it.
    x + S::from_f64(f64::from(double as f32) - double)
}

/// The sum of the components, without their signs.
fn sum<S: Number, const D: usize>(v: Vector<S, D>) -> S {
    v.iter().fold(S::zero(), |sum, &x| sum + Number::abs(x))
}

/// An angle in degrees where sine and cosine want it in radians.
fn in_degrees<S: Number>(theta: Direction<S>) -> Direction<S> {
    let degrees = (theta.sin / theta.cos).atan() * S::from_f64(180.0 / std::f64::consts::PI);
    Direction { cos: degrees.cos(), sin: degrees.sin() }
}

fn swapped<S: Copy>(theta: Direction<S>) -> Direction<S> {
    Direction { cos: theta.sin, sin: theta.cos }
}

fn with_cosines_swapped<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    let Cosines { x, y } = push.primary;
    CrossoverPush { primary: Cosines { x: y, y: x }, ..push }
}

/// `α_s T2_para` without `α_s`; the share of the mass keeps it.
fn with_no_slide<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    CrossoverPush { parallel: push.parallel / push.slide_factor, ..push }
}

/// `α_s² T2_para`.
fn with_slide_twice<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    CrossoverPush { parallel: push.parallel * push.slide_factor, ..push }
}

/// The node of the primary moves alone.
fn with_no_inertia<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    CrossoverPush { secondary_mass: S::zero(), ..push }
}

/// One arm pulls, not two.
fn with_one_arm<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    let half = S::half();
    CrossoverPush {
        parallel: push.parallel * half,
        perpendicular: push.perpendicular * half,
        ..push
    }
}

fn with_normal_reversed<S: Number>(push: CrossoverPush<S>) -> CrossoverPush<S> {
    CrossoverPush { perpendicular: -push.perpendicular, ..push }
}

/// Every method: the fault if it is in this equation, or else the edition that is wrapped.
impl<S: Number, P: Paper<S>> Paper<S> for Faulty<'_, P> {
    #[inline(always)]
    fn uses_previous_length(&self) -> bool {
        self.paper.uses_previous_length()
    }

    fn lines(&self, equation: &'static Equation) -> Vec<Line> {
        self.paper.lines(equation)
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
        match self.wrong {
            Wrong::BalanceSign => self.paper.eqn_1_impulse_residual(ahead, here, -m, now, before),
            Wrong::BalanceOneTension => {
                self.paper.eqn_1_impulse_residual(ahead, Vector::zeros(), m, now, before)
            }
            Wrong::BalanceNoHistory => {
                self.paper.eqn_1_impulse_residual(ahead, here, m, now, Vector::zeros())
            }
            Wrong::BalanceHalf => {
                self.paper.eqn_1_impulse_residual(ahead, here, S::half() * m, now, before)
            }
            Wrong::BalanceEnds => self.paper.eqn_1_impulse_residual(here, ahead, m, now, before),
            _ => self.paper.eqn_1_impulse_residual(ahead, here, m, now, before),
        }
    }

    #[inline(always)]
    fn eqn_2_velocity<const D: usize>(
        &self,
        before: Vector<S, D>,
        a: S,
        ahead: Vector<S, D>,
        here: Vector<S, D>,
    ) -> Vector<S, D> {
        let nothing = Vector::zeros();
        match self.wrong {
            Wrong::VelocitySign => self.paper.eqn_2_velocity(before, a, here, ahead),
            Wrong::VelocityTwice => self.paper.eqn_2_velocity(before, S::two() * a, ahead, here),
            Wrong::VelocityHalf => self.paper.eqn_2_velocity(before, S::half() * a, ahead, here),
            Wrong::VelocityBehind => self.paper.eqn_2_velocity(before, a, here, nothing),
            Wrong::VelocityFlat => self.paper.eqn_2_velocity(before, a, flat(ahead), flat(here)),
            Wrong::VelocitySingle => self.paper.eqn_2_velocity(before, single(a), ahead, here),
            Wrong::VelocityForgotten => self.paper.eqn_2_velocity(nothing, a, ahead, here),
            _ => self.paper.eqn_2_velocity(before, a, ahead, here),
        }
    }

    fn eqn_3_strain_increment(&self, length: S, before: S) -> S {
        match self.wrong {
            Wrong::IncrementDenominator => (length - before) / length,
            Wrong::IncrementMean => S::two() * (length - before) / (length + before),
            Wrong::IncrementLogarithm => (length / before).ln(),
            Wrong::IncrementStretch => length / before,
            Wrong::IncrementSign => self.paper.eqn_3_strain_increment(before, length),
            _ => self.paper.eqn_3_strain_increment(length, before),
        }
    }

    #[inline(always)]
    fn eqn_4_strain(&self, before: S, length: Lengths<S>) -> S {
        let right = self.paper.eqn_4_strain(before, length);
        // Of engineering strain, the strain itself.
        let increment = if self.paper.uses_previous_length() { right - before } else { right };
        match self.wrong {
            Wrong::StrainDenominator => right - increment * increment / (S::one() + increment),
            Wrong::StrainSign => right - S::two() * increment,
            Wrong::StrainForgotten if self.paper.uses_previous_length() => increment,
            Wrong::StrainTwice => right + increment,
            Wrong::StrainLogarithm => right - increment + increment.ln_1p(),
            Wrong::StrainSingle => {
                let now = single(length.now);
                self.paper.eqn_4_strain(before, Lengths { now, ..length })
            }
            _ => right,
        }
    }

    #[inline(always)]
    fn eqn_5_previous_length<const D: usize>(&self, ahead: Vector<S, D>, here: Vector<S, D>) -> S {
        match self.wrong {
            Wrong::LengthBeforeSign => self.paper.eqn_5_previous_length(ahead, -here),
            Wrong::LengthBeforeSum => sum(ahead - here),
            Wrong::LengthBeforeGreatest => {
                let components = ahead - here;
                components.iter().fold(S::zero(), |most, &x| Number::max(most, Number::abs(x)))
            }
            Wrong::LengthBeforeSquare => {
                let right = self.paper.eqn_5_previous_length(ahead, here);
                right * right
            }
            Wrong::LengthBeforeFlat => self.paper.eqn_5_previous_length(flat(ahead), flat(here)),
            _ => self.paper.eqn_5_previous_length(ahead, here),
        }
    }

    #[inline(always)]
    fn eqn_6_length<const D: usize>(
        &self,
        x_ahead: Vector<S, D>,
        v_ahead: Vector<S, D>,
        x_here: Vector<S, D>,
        v_here: Vector<S, D>,
        dt: S,
    ) -> S {
        let paper = self.paper;
        match self.wrong {
            Wrong::LengthOldNode => {
                paper.eqn_6_length(x_ahead, v_ahead, x_here, Vector::zeros(), dt)
            }
            Wrong::LengthHalf => {
                paper.eqn_6_length(x_ahead, v_ahead, x_here, v_here, S::half() * dt)
            }
            Wrong::LengthSum => ((x_ahead + v_ahead * dt) - (x_here + v_here * dt)).sum(),
            Wrong::LengthSingle => paper.eqn_6_length(x_ahead, v_ahead, x_here, v_here, single(dt)),
            Wrong::LengthSign => paper.eqn_6_length(x_ahead, v_ahead, x_here, -v_here, dt),
            Wrong::LengthFlat => {
                paper.eqn_6_length(flat(x_ahead), flat(v_ahead), flat(x_here), flat(v_here), dt)
            }
            _ => paper.eqn_6_length(x_ahead, v_ahead, x_here, v_here, dt),
        }
    }

    #[inline(always)]
    fn eqn_7_tension(&self, stiffness: S, strain: S) -> S {
        let right = self.paper.eqn_7_tension(stiffness, strain);
        self.of_tension(right, strain)
    }

    fn eqn_7_tension_by_law(&self, area: S, by: StressByLaw<'_, S>) -> S {
        let right = self.paper.eqn_7_tension_by_law(area, by);
        self.of_tension(right, by.strain)
    }

    fn eqn_8_projectile_velocity(&self, push: ProjectilePush<S>) -> S {
        let push = match self.wrong {
            Wrong::ProjectileTime => ProjectilePush { time_step: push.time, ..push },
            Wrong::ProjectileSign => ProjectilePush { tension_y: -push.tension_y, ..push },
            Wrong::ProjectileHalf => {
                ProjectilePush { tension_y: S::half() * push.tension_y, ..push }
            }
            Wrong::ProjectileHalfNode => {
                ProjectilePush { node_mass: S::half() * push.node_mass, ..push }
            }
            Wrong::ProjectileAlone => ProjectilePush { node_mass: S::zero(), ..push },
            _ => push,
        };
        self.paper.eqn_8_projectile_velocity(push)
    }

    fn eqn_9_parallel_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        match self.wrong {
            Wrong::ParallelSwapped => self.paper.eqn_9_parallel_velocity(u, v, swapped(theta)),
            Wrong::ParallelOne => self.paper.eqn_9_parallel_velocity(u, S::zero(), theta),
            Wrong::ParallelTwice => {
                let theta = Direction { sin: theta.cos, ..theta };
                self.paper.eqn_9_parallel_velocity(u, v, theta)
            }
            Wrong::ParallelFlat => {
                let theta = Direction { cos: S::one(), ..theta };
                self.paper.eqn_9_parallel_velocity(u, v, theta)
            }
            Wrong::ParallelSign => self.paper.eqn_9_parallel_velocity(u, -v, theta),
            _ => self.paper.eqn_9_parallel_velocity(u, v, theta),
        }
    }

    fn eqn_10_perpendicular_velocity(&self, u: S, v: S, theta: Direction<S>) -> S {
        match self.wrong {
            Wrong::PerpendicularSwapped => {
                self.paper.eqn_10_perpendicular_velocity(u, v, swapped(theta))
            }
            Wrong::PerpendicularOne => {
                self.paper.eqn_10_perpendicular_velocity(S::zero(), v, theta)
            }
            Wrong::PerpendicularTwice => {
                let theta = Direction { cos: theta.sin, ..theta };
                self.paper.eqn_10_perpendicular_velocity(u, v, theta)
            }
            Wrong::PerpendicularFlat => {
                let theta = Direction { cos: S::one(), ..theta };
                self.paper.eqn_10_perpendicular_velocity(u, v, theta)
            }
            Wrong::PerpendicularSign => self.paper.eqn_10_perpendicular_velocity(-u, v, theta),
            _ => self.paper.eqn_10_perpendicular_velocity(u, v, theta),
        }
    }

    fn eqn_11_direction(&self, here: Vector<S, 2>, behind: Vector<S, 2>) -> Direction<S> {
        let theta = self.paper.eqn_11_direction(here, behind);
        match self.wrong {
            Wrong::AngleSwapped => swapped(theta),
            Wrong::AngleSign => Direction { cos: theta.cos, sin: -theta.sin },
            Wrong::AngleSlope => Direction { cos: S::one(), sin: theta.sin / theta.cos },
            Wrong::AngleDegrees => in_degrees(theta),
            Wrong::AngleQuadrant if theta.cos < S::zero() => {
                Direction { cos: -theta.cos, sin: -theta.sin }
            }
            _ => theta,
        }
    }

    fn eqn_12_secondary_u(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        let paper = self.paper;
        match self.wrong {
            Wrong::DriveUNoSlide => paper.eqn_12_secondary_u(S::one(), parallel, across, theta),
            Wrong::DriveUOne => paper.eqn_12_secondary_u(slide, parallel, S::zero(), theta),
            Wrong::DriveUBoth => paper.eqn_12_secondary_u(slide, parallel, slide * across, theta),
            Wrong::DriveUSign => paper.eqn_12_secondary_u(slide, parallel, -across, theta),
            Wrong::DriveUSwapped => {
                paper.eqn_12_secondary_u(slide, parallel, across, swapped(theta))
            }
            _ => paper.eqn_12_secondary_u(slide, parallel, across, theta),
        }
    }

    fn eqn_13_secondary_v(&self, slide: S, parallel: S, across: S, theta: Direction<S>) -> S {
        let paper = self.paper;
        match self.wrong {
            Wrong::DriveVNoSlide => paper.eqn_13_secondary_v(S::one(), parallel, across, theta),
            Wrong::DriveVOne => paper.eqn_13_secondary_v(slide, parallel, S::zero(), theta),
            Wrong::DriveVSwapped => {
                paper.eqn_13_secondary_v(slide, parallel, across, swapped(theta))
            }
            Wrong::DriveVSign => paper.eqn_13_secondary_v(slide, parallel, -across, theta),
            Wrong::DriveVBoth => paper.eqn_13_secondary_v(slide, parallel, slide * across, theta),
            _ => paper.eqn_13_secondary_v(slide, parallel, across, theta),
        }
    }

    fn eqn_14_secondary_w(&self) -> S {
        match self.wrong {
            Wrong::DriveWFree => S::half(),
            Wrong::DriveWNearly => S::from_f64(1e-9),
            Wrong::DriveWCode => -S::one(),
            Wrong::DriveWImpact => S::from_f64(400.0),
            Wrong::DriveWSpeed => S::from_f64(6968.6),
            _ => self.paper.eqn_14_secondary_w(),
        }
    }

    fn eqn_15_parallel_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        let phi_2 = match self.wrong {
            Wrong::ParallelTensionSign => Cosines { y: -phi_2.y, ..phi_2 },
            Wrong::ParallelTensionSwapped => Cosines { x: phi_2.y, y: phi_2.x },
            Wrong::ParallelTensionPrimary => phi_1,
            Wrong::ParallelTensionOne => Cosines { y: S::zero(), ..phi_2 },
            _ => phi_2,
        };
        let half = self.wrong == Wrong::ParallelTensionHalf;
        let tension = if half { S::half() * tension } else { tension };
        self.paper.eqn_15_parallel_tension(tension, phi_2, phi_1)
    }

    fn eqn_16_perpendicular_tension(&self, tension: S, phi_2: Cosines<S>, phi_1: Cosines<S>) -> S {
        let phi_2 = match self.wrong {
            Wrong::NormalTensionPrinted => Cosines { x: phi_2.y, y: phi_2.x },
            Wrong::NormalTensionOne => Cosines { x: S::zero(), ..phi_2 },
            Wrong::NormalTensionPrimary => Cosines { y: phi_1.y, ..phi_2 },
            Wrong::NormalTensionSign => Cosines { x: -phi_2.x, ..phi_2 },
            _ => phi_2,
        };
        let half = self.wrong == Wrong::NormalTensionHalf;
        let tension = if half { S::half() * tension } else { tension };
        self.paper.eqn_16_perpendicular_tension(tension, phi_2, phi_1)
    }

    fn eqn_17_u_at_crossover(&self, u: S, push: CrossoverPush<S>) -> S {
        let push = match self.wrong {
            Wrong::PushUSign => with_normal_reversed(push),
            Wrong::PushUNoSlide => with_no_slide(push),
            Wrong::PushUOneArm => with_one_arm(push),
            Wrong::PushUSwapped => with_cosines_swapped(push),
            Wrong::PushUSlideTwice => with_slide_twice(push),
            Wrong::PushUNoInertia => with_no_inertia(push),
            _ => push,
        };
        self.paper.eqn_17_u_at_crossover(u, push)
    }

    fn eqn_18_v_at_crossover(&self, v: S, push: CrossoverPush<S>) -> S {
        let push = match self.wrong {
            Wrong::PushVSign => with_normal_reversed(push),
            Wrong::PushVNoSlide => with_no_slide(push),
            Wrong::PushVOneArm => with_one_arm(push),
            Wrong::PushVSwapped => with_cosines_swapped(push),
            Wrong::PushVSlideTwice => with_slide_twice(push),
            Wrong::PushVNoInertia => with_no_inertia(push),
            _ => push,
        };
        self.paper.eqn_18_v_at_crossover(v, push)
    }

    fn eqn_19_acceleration(&self, wave_speed: S, curvature: S) -> S {
        match self.wrong {
            Wrong::WaveSpeedOnce => wave_speed * curvature,
            Wrong::WaveHalf => S::half() * self.paper.eqn_19_acceleration(wave_speed, curvature),
            Wrong::WaveCube => wave_speed * self.paper.eqn_19_acceleration(wave_speed, curvature),
            Wrong::WaveSingle => self.paper.eqn_19_acceleration(single(wave_speed), curvature),
            Wrong::WaveSign => -self.paper.eqn_19_acceleration(wave_speed, curvature),
            _ => self.paper.eqn_19_acceleration(wave_speed, curvature),
        }
    }

    fn eqn_20_courant(&self, wave_speed: S, time_step: S, spacing: S) -> S {
        match self.wrong {
            Wrong::CourantInverse => self.paper.eqn_20_courant(wave_speed, spacing, time_step),
            Wrong::CourantHalf => {
                self.paper.eqn_20_courant(wave_speed, S::half() * time_step, spacing)
            }
            Wrong::CourantSign => self.paper.eqn_20_courant(-wave_speed, time_step, spacing),
            Wrong::CourantSingle => {
                self.paper.eqn_20_courant(wave_speed, single(time_step), spacing)
            }
            Wrong::CourantTwice => {
                wave_speed * self.paper.eqn_20_courant(wave_speed, time_step, spacing)
            }
            _ => self.paper.eqn_20_courant(wave_speed, time_step, spacing),
        }
    }
}

impl<P> Faulty<'_, P> {
    #[inline(always)]
    fn of_tension<S: Number>(&self, right: S, strain: S) -> S {
        match self.wrong {
            Wrong::TensionSquare => right * strain,
            Wrong::TensionSingle => single(right),
            Wrong::TensionDigits => right * S::from_f64(56.8 / 58.6),
            Wrong::TensionTwice => S::two() * right,
            Wrong::TensionSign => -right,
            _ => right,
        }
    }
}
