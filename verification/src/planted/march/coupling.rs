//! What a step does at the crossover and at the projectile, in plain words.

use crossfibre::number::{Number, Vector};
use crossfibre::outcome::{End, Outcome};
use crossfibre::paper::{Cosines, CrossoverPush, Paper, ProjectilePush, magnitude};
use crossfibre::place::{Fibre, Place};
use crossfibre::state::{Crossover, FibreState, State};

use super::Wrong;

/// What the primary imposes on the secondary is made of.
#[derive(Clone, Copy)]
pub struct Drive<S: Number> {
    velocity: Vector<S, 2>,
    here: Vector<S, 2>,
    behind: Vector<S, 2>,
}

/// That of a step.
pub fn drive_of<S: Number>(
    crossover: &Crossover<S>,
    primary: &FibreState<S, 2>,
    wrong: Option<Wrong>,
) -> Drive<S> {
    let ix = match wrong {
        Some(Wrong::DriveBehind) => (crossover.node - 1).max(1),
        _ => crossover.node,
    };
    Drive {
        velocity: primary.velocity[ix],
        here: primary.position[ix],
        behind: primary.position[ix - 1],
    }
}

impl<S: Number> Drive<S> {
    /// (9) to (14).
    pub fn imposed(
        self,
        paper: &impl Paper<S>,
        step: u64,
        crossover: &Crossover<S>,
    ) -> Vector<S, 3> {
        paper.at(Place { step, fibre: Fibre::Secondary, index: 0 });
        let (u, v) = (self.velocity.x, self.velocity.y);
        let slide = crossover.slide_factor;
        let theta = paper.eqn_11_direction(self.here, self.behind);
        let along = paper.eqn_9_parallel_velocity(u, v, theta);
        let across = paper.eqn_10_perpendicular_velocity(u, v, theta);
        let u2 = paper.eqn_12_secondary_u(slide, along, across, theta);
        let v2 = paper.eqn_13_secondary_v(slide, along, across, theta);
        Vector::<S, 3>::new(u2, v2, paper.eqn_14_secondary_w())
    }
}

/// (15) to (18).
pub fn push<S: Number>(
    paper: &impl Paper<S>,
    step: u64,
    crossover: &Crossover<S>,
    primary: &FibreState<S, 2>,
    v: Vector<S, 2>,
) -> Vector<S, 2> {
    fn cosines<S: Number, const D: usize>(element: Vector<S, D>) -> Cosines<S> {
        let length = magnitude(element);
        Cosines { x: element[0] / length, y: element[1] / length }
    }
    let ix = crossover.node;
    paper.at(Place { step, fibre: Fibre::Primary, index: ix });
    let secondary = &crossover.fibre;
    let phi_1 = cosines(primary.position[ix] - primary.position[ix - 1]);
    let phi_2 = cosines(secondary.position[1] - secondary.position[0]);
    let tension = secondary.tension[0];
    let push = CrossoverPush {
        a: primary.properties.a,
        slide_factor: crossover.slide_factor,
        parallel: paper.eqn_15_parallel_tension(tension, phi_2, phi_1),
        perpendicular: paper.eqn_16_perpendicular_tension(tension, phi_2, phi_1),
        primary: phi_1,
        change: (primary.pull[ix] - primary.pull[ix - 1]) * primary.properties.a,
        mass: primary.properties.mass,
        secondary_mass: secondary.properties.mass,
    };
    let u = paper.eqn_17_u_at_crossover(v.x, push);
    Vector::<S, 2>::new(u, paper.eqn_18_v_at_crossover(v.y, push))
}

/// `ix` is assigned to the nearest node.
pub fn reassign<S: Number>(
    crossover: &mut Crossover<S>,
    step: u64,
    primary: &FibreState<S, 2>,
    wrong: Option<Wrong>,
) -> Result<(), Outcome> {
    let slides = crossover.slide_factor != S::one() && primary.visited >= crossover.node;
    let nearest = match wrong {
        Some(Wrong::IndexStale) => return Ok(()),
        Some(Wrong::IndexAhead) if slides => crossover.nearest_node(primary) + 1,
        _ => crossover.nearest_node(primary),
    };
    if nearest == 0 {
        return Err(Outcome::CrossoverLeft { step, end: End::ImpactPoint });
    }
    if nearest >= primary.elements() {
        return Err(Outcome::CrossoverLeft { step, end: End::Clamp });
    }
    crossover.moves += u64::from(nearest != crossover.node);
    crossover.node = nearest;
    Ok(())
}

/// (8), where the projectile has a mass.
pub fn push_projectile<S: Number>(
    paper: &impl Paper<S>,
    state: &mut State<S>,
    wrong: Option<Wrong>,
) -> Result<(), Outcome> {
    let Some(mass) = state.projectile.mass else { return Ok(()) };
    let place = Place { step: state.step, fibre: Fibre::Primary, index: 0 };
    paper.at(place);
    state.work.projectile += 1;
    let tension_y = match wrong {
        Some(Wrong::OneFibreSlows) => state.projectile.axis.dot(&state.primary.pull[0]),
        _ => state.first_tension_along_axis(),
    };
    let velocity = paper.eqn_8_projectile_velocity(ProjectilePush {
        velocity: state.projectile.velocity,
        tension_y,
        mass,
        node_mass: state.projectile_node_mass(),
        time_step: state.time_step,
        time: state.time(),
    });
    state.projectile.velocity = velocity;
    if velocity.is_finite() { Ok(()) } else { Err(Outcome::Diverged { place, equation: 8 }) }
}
