//! The steps of a scene in vectors of one kind.

use crossfibre::outcome::End;

use crate::crossover::{self, Push, along_axis, eqn_8_projectile_velocity};
use crate::fibre::Fibre;
use crate::lanes::{Lanes, Work};
use crate::mesh::Mesh;
use crate::state::{Crossover, State};

/// How many steps a single fibre makes together.
pub(crate) const TOGETHER: u64 = 32;

/// What the march carries from step to step.
pub(crate) struct March<L: Lanes> {
    lanes: L,
    step: u64,
    time_step: f64,
    engineering: bool,
    primary: Fibre<L, 2>,
    crossing: Option<Crossing<L>>,
    /// m/s, and its mass, kg, if its velocity changes.
    projectile: (f64, Option<f64>),
}

/// The crossing fibre.
struct Crossing<L: Lanes> {
    fibre: Fibre<L, 3>,
    at: Crossover,
    slide_factor: f64,
}

/// How a number of steps ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ended {
    /// They were made.
    Made,
    /// A number is not finite, in one of the last steps, at most [`TOGETHER`].
    NotFinite,
    /// The crossover has slid to an end of the primary.
    Left(End),
}

/// What a march needs to know of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Constants {
    pub mesh: Mesh,
    pub engineering: bool,
    pub slide_factor: f64,
    pub projectile_mass: Option<f64>,
}

impl<L: Lanes> March<L> {
    pub fn of(lanes: L, constants: &Constants, state: &State) -> Self {
        let Constants { mesh, engineering, slide_factor, projectile_mass } = *constants;
        let dt = mesh.time_step;
        let crossing = mesh.secondary.zip(state.secondary.as_ref()).zip(state.crossover);
        Self {
            lanes,
            step: state.step,
            time_step: dt,
            engineering,
            primary: Fibre::of(lanes, &state.primary, mesh.primary, dt, 0, engineering),
            crossing: crossing.map(|(((properties, _), fibre), at)| Crossing {
                fibre: Fibre::of(lanes, fibre, properties, dt, 2, engineering),
                at,
                slide_factor,
            }),
            projectile: (state.projectile_velocity, projectile_mass),
        }
    }

    /// Makes so many steps, if nothing happens.
    pub fn run(&mut self, steps: u64) -> Ended {
        let mut ended = Ended::Made;
        self.lanes.compile(Run { march: self, steps, ended: &mut ended });
        ended
    }

    /// Visits the elements ahead of the wavefront, too.
    pub fn visit_all(&mut self) {
        self.primary.visited = self.primary.elements;
        if let Some(crossing) = &mut self.crossing {
            crossing.fibre.visited = crossing.fibre.elements;
        }
    }

    /// The numbers of now. `state` is one of the same scene.
    pub fn write(&self, state: &mut State) {
        let made = self.step > state.step;
        self.primary.write(&mut state.primary, made);
        if let (Some(crossing), Some(fibre)) = (&self.crossing, &mut state.secondary) {
            crossing.fibre.write(fibre, made);
            state.crossover = Some(crossing.at);
        }
        state.projectile_velocity = self.projectile.0;
        state.step = self.step;
    }

    /// Steps made since impact.
    pub fn step(&self) -> u64 {
        self.step
    }

    /// Elements visited, summed over the steps and the fibres.
    pub fn element_steps(&self) -> u64 {
        let secondary = self.crossing.as_ref().map_or(0, |crossing| crossing.fibre.element_steps);
        self.primary.element_steps + secondary
    }
}

/// Steps to be compiled.
struct Run<'a, L: Lanes> {
    march: &'a mut March<L>,
    steps: u64,
    ended: &'a mut Ended,
}

impl<L: Lanes> Work<L> for Run<'_, L> {
    #[inline(always)]
    fn run(self, _: L) {
        *self.ended = if self.march.engineering {
            self.march.steps::<true>(self.steps)
        } else {
            self.march.steps::<false>(self.steps)
        };
    }
}

impl<L: Lanes> March<L> {
    #[inline(always)]
    fn steps<const ENGINEERING: bool>(&mut self, steps: u64) -> Ended {
        let end = self.step + steps;
        while self.step < end {
            let ended = match &self.crossing {
                None => self.steps_alone::<ENGINEERING>(TOGETHER.min(end - self.step)),
                Some(crossing) if crossing.at.node == 0 => self.step_at_origin::<ENGINEERING>(),
                Some(_) => self.step_crossed::<ENGINEERING>(),
            };
            if ended != Ended::Made {
                return ended;
            }
        }
        Ended::Made
    }

    /// What the projectile gives its node, along y.
    #[inline(always)]
    fn projectile_drive(velocity: f64) -> [f64; 2] {
        [0.0 * velocity, 1.0 * velocity]
    }

    /// Some steps of a single fibre.
    #[inline(always)]
    fn steps_alone<const ENGINEERING: bool>(&mut self, steps: u64) -> Ended {
        let (time_step, (mut velocity, mass)) = (self.time_step, self.projectile);
        let node_mass = self.primary.properties.mass;
        let pushed = |fibre: &Fibre<L, 2>, velocity: f64| match mass {
            Some(mass) => {
                let pull = along_axis(&fibre.pull(0));
                eqn_8_projectile_velocity(velocity, pull, time_step, mass, node_mass)
            }
            None => velocity,
        };
        let mut made = 0;
        let whole = self.primary.steps::<ENGINEERING>(steps as usize, |fibre| {
            if made > 0 {
                velocity = pushed(fibre, velocity);
            }
            made += 1;
            Self::projectile_drive(velocity)
        });
        self.projectile.0 = pushed(&self.primary, velocity);
        self.step += steps;
        self.made(whole)
    }

    /// Both fibres are struck: the projectile drives both, and is slowed by both.
    #[inline(always)]
    fn step_at_origin<const ENGINEERING: bool>(&mut self) -> Ended {
        let Some(crossing) = &mut self.crossing else { return Ended::Made };
        self.step += 1;
        let drive = Self::projectile_drive(self.projectile.0);
        let mut whole = self.primary.step::<ENGINEERING>(
            drive,
            #[inline(always)]
            |_, _| (),
        );
        whole &= crossing.fibre.step::<ENGINEERING>(
            [drive[0], drive[1], 0.0],
            #[inline(always)]
            |_, _| (),
        );
        let pull = along_axis(&self.primary.pull(0)) + along_axis(&crossing.fibre.pull(0));
        let node_mass = crossing.fibre.properties.mass;
        self.push_projectile(pull, node_mass);
        self.made(whole)
    }

    #[inline(always)]
    fn step_crossed<const ENGINEERING: bool>(&mut self) -> Ended {
        let (lanes, primary) = (self.lanes, &mut self.primary);
        let Some(crossing) = &mut self.crossing else { return Ended::Made };
        self.step += 1;
        let ix = crossing.at.node;
        // A crossover that has slid to the wavefront pulls at a node that is not to be visited yet.
        if crossing.fibre.first_tension() != 0.0 {
            primary.visited = primary.visited.max((ix + 1).min(primary.elements));
        }
        let pushed = (ix <= primary.visited).then(|| crossing.push(primary));
        let (block, lane) = (Fibre::<L, 2>::block_of(ix - 1), (ix - 1) % L::COUNT);
        let drive = Self::projectile_drive(self.projectile.0);
        let mut whole = primary.step::<ENGINEERING>(
            drive,
            #[inline(always)]
            |b, velocity| {
                if b == block
                    && let Some(pushed) = pushed
                {
                    for (v, pushed) in velocity.iter_mut().zip(pushed) {
                        let mut lanes_of_v = lanes.array(*v);
                        lanes_of_v.as_mut()[lane] = pushed;
                        *v = lanes.vector(lanes_of_v);
                    }
                }
            },
        );
        let [here, behind] = [primary.position(ix), primary.position(ix - 1)];
        let drive = crossover::drive(primary.velocity(ix), here, behind, crossing.slide_factor);
        whole &= crossing.fibre.step::<ENGINEERING>(
            drive,
            #[inline(always)]
            |_, _| (),
        );
        let left = crossing.reassign_node(primary);
        self.push_projectile(along_axis(&self.primary.pull(0)), 0.0);
        match (self.made(whole), left) {
            (Ended::Made, Some(end)) => Ended::Left(end),
            (ended, _) => ended,
        }
    }

    /// (8), with what a secondary adds to the mass of the projectile's node.
    #[inline(always)]
    fn push_projectile(&mut self, pull: f64, secondary_mass: f64) {
        if let (velocity, Some(mass)) = self.projectile {
            let node_mass = self.primary.properties.mass + secondary_mass;
            self.projectile.0 =
                eqn_8_projectile_velocity(velocity, pull, self.time_step, mass, node_mass);
        }
    }

    #[inline(always)]
    fn made(&self, whole: bool) -> Ended {
        if whole && self.projectile.0.is_finite() { Ended::Made } else { Ended::NotFinite }
    }
}

impl<L: Lanes> Crossing<L> {
    #[inline(always)]
    fn push(&self, primary: &Fibre<L, 2>) -> [f64; 2] {
        let ix = self.at.node;
        let push = Push {
            here: primary.position(ix),
            behind: primary.position(ix - 1),
            secondary: [self.fibre.position(0), self.fibre.position(1)],
            tension: self.fibre.first_tension(),
            pulls: [primary.pull(ix), primary.pull(ix - 1)],
            a: primary.properties.a,
            slide_factor: self.slide_factor,
            mass: primary.properties.mass,
            secondary_mass: self.fibre.properties.mass,
        };
        push.velocity(primary.velocity(ix))
    }

    /// "ix is assigned to the nearest node on the primary fibre", unless that is an end.
    #[inline(always)]
    fn reassign_node(&mut self, primary: &Fibre<L, 2>) -> Option<End> {
        if self.slide_factor == 1.0 || primary.visited < self.at.node {
            return None;
        }
        let nearest = primary.nearest_node(self.fibre.first_position, self.at.node);
        if nearest == 0 {
            return Some(End::ImpactPoint);
        }
        if nearest == primary.elements {
            return Some(End::Clamp);
        }
        if nearest != self.at.node {
            self.at = Crossover { node: nearest, moves: self.at.moves + 1 };
        }
        None
    }
}

impl<L: Lanes> Fibre<L, 2> {
    /// The node nearest to a place, the lowest of equals. Blocks that have nothing nearer than `guess`
    /// are passed by.
    #[inline(always)]
    fn nearest_node(&self, place: [f64; 3], guess: usize) -> usize {
        let lanes = self.lanes;
        let square = |node| crossover::square_of_distance(place, self.position(node));
        let last = self.elements;
        let mut best = (square(guess), guess);
        let consider = |node: usize, best: &mut (f64, usize)| {
            let square = square(node);
            if square < best.0 || (square == best.0 && node < best.1) {
                *best = (square, node);
            }
        };
        consider(0, &mut best);
        let [x, y, z] = [lanes.splat(place[0]), lanes.splat(place[1]), lanes.splat(place[2])];
        let away = lanes.sub(lanes.splat(0.0), z);
        let square_away = lanes.mul(away, away);
        for b in 0..last.div_ceil(L::COUNT) {
            let [px, py] = self.blocks[b + 1].position;
            let (dx, dy) = (lanes.sub(px, x), lanes.sub(py, y));
            let squares = lanes.add(lanes.add(lanes.mul(dx, dx), lanes.mul(dy, dy)), square_away);
            if lanes.any_at_most(squares, lanes.splat(best.0)) {
                let first = b * L::COUNT + 1;
                (first..(first + L::COUNT).min(last + 1))
                    .for_each(|node| consider(node, &mut best));
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may

    use crossfibre::scene::Scene;
    use crossfibre::scene_file;

    use super::*;
    use crate::lanes::Portable;

    /// Of a fibre with nodes at 0, 1, … 13: 4 and 5 are in different blocks of four.
    #[test]
    fn of_nodes_that_are_as_near_the_lowest_is_the_nearest() {
        let text = include_str!("../../../verification/scenes/single-400.json");
        let mut scene: Scene = scene_file::read(text).unwrap();
        (scene.primary.length, scene.primary.elements) = (13.0, 13);
        let mesh = Mesh::of(&scene);
        let state = State::at_impact(&scene, &mesh).primary;
        let fibre = Fibre::of(Portable, &state, mesh.primary, mesh.time_step, 0, false);
        for (place, nearest) in
            [(4.5, 4), (0.5, 0), (-3.0, 0), (5.2, 5), (12.5, 12), (12.6, 13), (17.0, 13), (7.0, 7)]
        {
            for guess in 0..=13 {
                let found = fibre.nearest_node([place, 0.3, 0.0], guess);
                assert_eq!(found, nearest, "{place} from {guess}");
            }
        }
    }
}
