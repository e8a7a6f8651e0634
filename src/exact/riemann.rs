//! Riemann problems of strings: what leaves a point at which two uniform states meet.
//!
//! A piece of fibre has a strain ε, a unit direction t and a velocity v. From a joint (a point of
//! the fibre, an end, a crossover) each arm carries away two waves: a longitudinal one, which
//! changes the strain to ε* and the velocity along t, and behind it a kink, which turns the fibre
//! to t* at the same strain. With t pointing away from the joint, V the velocity of the joint,
//! W the velocity of a longitudinal wave and U that of a kink ([`Elastic`]), λ = 1 + ε:
//!
//! ```text
//! v* = v − W(ε → ε*) t                   longitudinal wave
//! V + Uλ* t* = v* + Uλ* t                kink: the fibre stays in one piece
//! |t*| = 1                               hence ε*, one unknown
//! ```
//!
//! The force of the arm on the joint is A T(ε*) t*. An end has a given V; at an interior point and
//! at a crossover the forces must cancel, which gives V. Derivation, uniqueness and tests:
//! `docs/exact/riemann.md`.

use std::fmt;

use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use super::elastic::Elastic;
use super::root::crossing;

/// A uniform piece of fibre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Engineering strain ε = λ − 1.
    pub strain: f64,
    /// Unit vector along the fibre.
    pub direction: Vector3<f64>,
    /// Velocity, m/s.
    pub velocity: Vector3<f64>,
}

impl State {
    /// The same piece with its Lagrangian coordinate counted the other way.
    pub fn reversed(self) -> Self {
        Self { direction: -self.direction, ..self }
    }
}

/// One arm after its joint has been set in motion; all directions point away from the joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm {
    /// Ahead of the longitudinal wave.
    pub ahead: State,
    /// Between the longitudinal wave and the kink.
    pub between: State,
    /// Behind the kink, at the joint.
    pub behind: State,
}

impl Arm {
    /// Whether the kink turns the fibre by more than a right angle; here taken for going slack.
    ///
    /// It needs a joint that runs into its arm faster than the arm gives way when it unloads to
    /// zero strain: moved like that along the fibre alone, the arm would be compressed. The
    /// converse does not hold, and a folded arm still is under tension: the solution stands for a
    /// perfectly flexible line, which the fibre then no longer is (`docs/exact/riemann.md`).
    pub fn is_folded(&self) -> bool {
        self.behind.direction.dot(&self.between.direction) < 0.0
    }
}

/// Why a Riemann problem has no solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RiemannError {
    /// The fibre would be strained beyond [`Elastic::greatest_strain`].
    BeyondTheLaw,
}

impl fmt::Display for RiemannError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BeyondTheLaw => {
                write!(
                    f,
                    "the fibre would be strained beyond the range in which its waves are known"
                )
            }
        }
    }
}

impl std::error::Error for RiemannError {}

/// The waves in an arm whose joint moves at velocity V from now on: an end moved by hand, or a
/// clamp (V = 0). The direction of `ahead` points away from the joint.
///
/// With V − v = a t + p, p ⟂ t, and r = W(ε → ε*) + a, the three equations above are
/// Uλ* t* = (Uλ* − r) t − p, and |t*| = 1 is **p² = r(2Uλ* − r)**: Smith's relation for a fibre
/// that is already strained and moving. r(2Uλ* − r) − p² is not positive while r ≤ 0 and increases
/// from there on, so there is one root.
pub fn end(
    material: &impl Elastic,
    ahead: State,
    velocity: Vector3<f64>,
) -> Result<Arm, RiemannError> {
    let t = ahead.direction;
    let struck = velocity - ahead.velocity;
    let a = struck.dot(&t);
    let p = struck - t * a;
    let p_squared = p.norm_squared();
    let excess = |strain| {
        let r = material.wave_velocity(ahead.strain, strain) + a;
        (r, kink_momentum(material, strain))
    };
    let guess = ahead.strain + struck.norm() / front_speed(material);
    let strain = crossing(guess, greatest(material), |strain| {
        let (r, q) = excess(strain);
        r * (2.0 * q - r) - p_squared
    })
    .ok_or(RiemannError::BeyondTheLaw)?;
    let (r, q) = excess(strain);
    let between = State {
        strain,
        direction: t,
        velocity: ahead.velocity - t * material.wave_velocity(ahead.strain, strain),
    };
    let direction = if q > 0.0 { (t * (q - r) - p).normalize() } else { t };
    Ok(Arm { ahead, between, behind: State { strain, direction, velocity } })
}

/// Speed of a weak longitudinal wave on the unstrained fibre, m/s.
fn front_speed(material: &impl Elastic) -> f64 {
    material.wave_speeds(0.0, 0.0).0
}

/// Where the search for a strain ends: no product below overflows there.
fn greatest(material: &impl Elastic) -> f64 {
    material.greatest_strain().min(1e60)
}

/// Uλ = √(Tλ/ρ), m/s.
fn kink_momentum(material: &impl Elastic, strain: f64) -> f64 {
    material.kink_speed(strain) * (1.0 + strain)
}

/// The two arms of an interior point of one fibre at which `left` and `right` meet, both with
/// directions along increasing Lagrangian coordinate. Returns the arms with directions away from
/// the point.
///
/// Both arms get one strain ε* and, between their kinks, one direction t*:
/// **Uλ* t* = Uλ*(t_L + t_R)/2 + (v_R* − v_L*)/2**, |t*| = 1.
pub fn interior(
    material: &impl Elastic,
    left: State,
    right: State,
) -> Result<[Arm; 2], RiemannError> {
    let middle = Middle::of(&left, &right);
    let guess = (left.strain + right.strain) / 2.0;
    let strain = crossing(guess, greatest(material), |strain| {
        middle.excess(
            kink_momentum(material, strain),
            material.wave_velocity(left.strain, strain),
            material.wave_velocity(right.strain, strain),
        )
    })
    .ok_or(RiemannError::BeyondTheLaw)?;
    let q = kink_momentum(material, strain);
    let v_left = left.velocity + left.direction * material.wave_velocity(left.strain, strain);
    let v_right = right.velocity - right.direction * material.wave_velocity(right.strain, strain);
    let sum = (left.direction + right.direction) * q + (v_right - v_left);
    let direction = if q > 0.0 { sum.normalize() } else { left.direction };
    let velocity = ((v_left + v_right) + (right.direction - left.direction) * q) / 2.0;
    let arm = |ahead: State, sign: f64, v: Vector3<f64>| Arm {
        ahead: State { direction: ahead.direction * sign, ..ahead },
        between: State { strain, direction: ahead.direction * sign, velocity: v },
        behind: State { strain, direction: direction * sign, velocity },
    };
    Ok([arm(left, -1.0, v_left), arm(right, 1.0, v_right)])
}

/// The data of an interior point, arranged so that |t*| = 1 loses no digits where t_L ≈ t_R.
struct Middle {
    /// Unit vector along t_L + t_R.
    n: Vector3<f64>,
    /// 1 − |t_L + t_R|/2.
    bend: f64,
    /// (t_R − t_L)/2.
    turn: Vector3<f64>,
    /// (v_R − v_L)/2.
    parting: Vector3<f64>,
}

impl Middle {
    fn of(left: &State, right: &State) -> Self {
        let turn = (right.direction - left.direction) / 2.0;
        let mean = (left.direction + right.direction) / 2.0;
        let length = mean.norm();
        let n = if length > 0.0 { mean / length } else { right.direction };
        // |mean|² = 1 − |turn|².
        let bend = turn.norm_squared() / (1.0 + length);
        Self { n, bend, turn, parting: (right.velocity - left.velocity) / 2.0 }
    }

    /// (Uλ)² − |Uλ(t_L + t_R)/2 + (v_R* − v_L*)/2|², negative below its only root, with
    /// v_R* − v_L* = v_R − v_L − W_R t_R − W_L t_L.
    fn excess(&self, q: f64, w_left: f64, w_right: f64) -> f64 {
        let w = (w_left + w_right) / 2.0;
        let parted = self.parting.dot(&self.n);
        // Along n: q − q(1 − bend) − parted + w(1 − bend).
        let short = q * self.bend + (w * (1.0 - self.bend) - parted);
        let across = self.parting - self.n * parted - self.turn * ((w_right - w_left) / 2.0);
        short * (2.0 * q - short) - across.norm_squared()
    }
}

/// A fibre at a crossover.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<'m, M> {
    /// Its material.
    pub material: &'m M,
    /// Its reference area, m².
    pub area: f64,
}

/// The arms around a crossover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Junction {
    /// Velocity of the primary's node, m/s.
    pub velocity: Vector3<f64>,
    /// The arm of the primary towards the impact point.
    pub left: Arm,
    /// The arm of the primary away from it.
    pub right: Arm,
    /// One of the two arms of the secondary; the other is its mirror image.
    pub secondary: Arm,
}

/// The waves that leave a crossover in the x–y plane, symmetric in z.
///
/// `left` and `right` are the states of the primary (directions along increasing coordinate),
/// `arm` that of the secondary at z > 0 (away from the crossover). The slide factor α_s acts along
/// `along`, the direction of the primary: the secondary's end has velocity S V with
/// S = 1 − (1 − α_s) along·alongᵀ, and by virtual work its force F₂ acts on the primary as S F₂:
///
/// ```text
/// A₁T(ε_L*) t_L* + A₁T(ε_R*) t_R* + 2 S A₂T₂(ε₂*) t₂* = 0   in the x–y plane
/// ```
///
/// Two unknowns, V_x and V_y. Each force is a strictly monotone function of V (its Jacobian is
/// negative definite), so there is at most one solution, and a short enough step along Newton's
/// direction always leads towards it.
pub fn junction<M: Elastic>(
    primary: Crossing<'_, M>,
    left: State,
    right: State,
    secondary: Crossing<'_, M>,
    arm: State,
    slide: (f64, Vector3<f64>),
) -> Result<Junction, RiemannError> {
    let along = slide.1 * slide.1.transpose();
    let slip = (Matrix3::identity() - along) + along * slide.0;
    let arms = |v: Vector2<f64>| -> Result<Junction, RiemannError> {
        let velocity = Vector3::new(v.x, v.y, 0.0);
        Ok(Junction {
            velocity,
            left: end(primary.material, left.reversed(), velocity)?,
            right: end(primary.material, right, velocity)?,
            secondary: end(secondary.material, arm, slip * velocity)?,
        })
    };
    let force = |j: &Junction| -> Vector2<f64> {
        let sum = pull(&primary, &j.left)
            + pull(&primary, &j.right)
            + slip * pull(&secondary, &j.secondary) * 2.0;
        sum.xy()
    };
    // Forces are known no better than their sizes and the velocities at hand allow.
    let known = |j: &Junction| {
        let size = |fibre: &Crossing<'_, M>, arm: &Arm| {
            let impedance = fibre.area * fibre.material.density() * front_speed(fibre.material);
            pull(fibre, arm).norm() + impedance * arm.ahead.velocity.norm()
        };
        size(&primary, &j.left) + size(&primary, &j.right) + size(&secondary, &j.secondary)
    };
    let slope = |j: &Junction| -> Matrix2<f64> {
        let sum = softening(&primary, &j.left)
            + softening(&primary, &j.right)
            + slip * softening(&secondary, &j.secondary) * slip * 2.0;
        sum.fixed_view::<2, 2>(0, 0).into()
    };
    let newton = |start: Vector3<f64>| -> Result<Junction, RiemannError> {
        let mut best = arms(start.xy())?;
        for _ in 0..MOST_ITERATIONS {
            let (v, unbalanced) = (best.velocity.xy(), force(&best));
            if unbalanced.norm() <= f64::EPSILON * known(&best) {
                return Ok(best);
            }
            let Some(inverse) = slope(&best).try_inverse() else { return Ok(best) };
            let step = -(inverse * unbalanced);
            if !step.iter().all(|part| part.is_finite()) {
                return Err(RiemannError::BeyondTheLaw);
            }
            let (mut part, mut within) = (step, Ok(()));
            // The step, or the first of its halves after which, within the laws, the same matrix
            // asks for less. The force itself may have to grow on the way: its size changes much
            // faster across the valley of a nearly slack fibre than along it.
            best = loop {
                match arms(v + part) {
                    Ok(found) if (inverse * force(&found)).norm() < step.norm() => break found,
                    Ok(_) => {}
                    Err(error) => within = Err(error),
                }
                part /= 2.0;
                if v + part == v {
                    return within.map(|()| best);
                }
            };
        }
        Err(RiemannError::BeyondTheLaw)
    };
    // Where a law has an end, the way to the balance may begin or lead beyond it from one start and
    // not from another.
    let between = |part: f64| left.velocity + (right.velocity - left.velocity) * part;
    let starts = [0.5, 1.0, 0.0, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875].map(between);
    starts
        .into_iter()
        .chain([arm.velocity])
        .find_map(|start| newton(start).ok())
        .ok_or(RiemannError::BeyondTheLaw)
}

/// Enough for the 16 digits of a root that starts six decades away; only along the end of a law are
/// the steps so short that it is not.
const MOST_ITERATIONS: usize = 100;

/// A T(ε*) t*, the force of an arm on its joint, N.
fn pull<M: Elastic>(fibre: &Crossing<'_, M>, arm: &Arm) -> Vector3<f64> {
    arm.behind.direction * (fibre.area * fibre.material.tension(arm.behind.strain))
}

/// ∂(A T t*)/∂V, the change of that force with the velocity of the joint, N s/m.
///
/// From dV = −W′dε t + q′dε (t − t*) − q dt* with q = Uλ, W′ = dW/dε*, cos γ = t·t*:
///
/// ```text
/// dε = −t*·dV/D        D = q′(1 − cos γ) + W′cos γ
/// d(T t*) = −ρU [dV + ((w² − U²)t*/2 + U(q′ − W′)t) t*·dV/(UD)]
/// ```
///
/// where w² = T′/ρ, 2Uq′ = w² + U², and W′ = (w² + s²)/(2s) for a wave whose last disturbance runs
/// at s: w behind a fan, the speed of a shock behind a shock.
fn softening<M: Elastic>(fibre: &Crossing<'_, M>, arm: &Arm) -> Matrix3<f64> {
    let (material, strain) = (fibre.material, arm.between.strain);
    let u = material.kink_speed(strain);
    let w_squared = material.tangent_modulus(strain) / material.density();
    let s = material.wave_speeds(arm.ahead.strain, strain).1;
    let (t, turned) = (arm.between.direction, arm.behind.direction);
    // 1 − cos γ without its cancellation.
    let bend = (t - turned).norm_squared() / 2.0;
    let uq = (w_squared + u * u) / 2.0;
    let uw = u * (w_squared + s * s) / (2.0 * s);
    let ud = uq * bend + uw * (1.0 - bend);
    let along = turned * ((w_squared - u * u) / 2.0) + t * (uq - uw);
    (Matrix3::identity() + along * turned.transpose() / ud) * (-fibre.area * material.density() * u)
}

#[cfg(test)]
mod tests;
