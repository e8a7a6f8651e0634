//! One time step in the paper's order, and the run.
//!
//! The recursion goes "from one element to the next along the fibre length", in place.

use std::ops::Range;

use crate::constitution::{Block, Breach, Constitution};
use crate::number::{Number, Vector};
use crate::outcome::{End, Outcome};
use crate::paper::{
    Cosines, CrossoverPush, Direction, Lengths, Paper, ProjectilePush, StressByLaw, magnitude,
};
use crate::place::{Fibre, Place};
use crate::state::{Crossover, FibreState, State};

/// Runs `steps` more steps, or until the run ends by itself. `watch` is called after each step.
#[inline(always)]
pub fn run<S: Number>(
    paper: &impl Paper<S>,
    state: &mut State<S>,
    steps: u64,
    mut watch: impl FnMut(&State<S>),
) -> Outcome {
    for _ in 0..steps {
        if let Err(outcome) = step(paper, state) {
            return outcome;
        }
        watch(state);
    }
    Outcome::Completed
}

/// One time step: the primary fibre, the projectile, the secondary fibre, the crossover's node.
#[inline(always)]
pub fn step<S: Number>(paper: &impl Paper<S>, state: &mut State<S>) -> Result<(), Outcome> {
    state.step += 1;
    let force_before = state.account_for_impulses();
    let (step, time_step) = (state.step, state.time_step);
    let along = |fibre| Along { step, fibre, time_step };
    let drive = state.projectile.axis * state.projectile.velocity;

    let mut crossover_stays = Ok(());
    match &mut state.crossover {
        None => {
            state.work.count(&state.primary);
            along(Fibre::Primary).march(paper, &mut state.primary, drive, |_, _| ())?;
            state.push_projectile(paper)?;
        }
        // θ is undefined at the origin: the projectile drives both fibres (`theta-at-origin`), and
        // is slowed by both.
        Some(crossover) if crossover.at_origin() => {
            state.work.count(&state.primary);
            state.work.count(&crossover.fibre);
            state.work.secondary += 1;
            along(Fibre::Primary).march(paper, &mut state.primary, drive, |_, _| ())?;
            paper.at(Place { step, fibre: Fibre::Secondary, index: 0 });
            let drive = Vector::<S, 3>::new(drive.x, drive.y, paper.eqn_14_secondary_w());
            along(Fibre::Secondary).march(paper, &mut crossover.fibre, drive, |_, _| ())?;
            state.push_projectile(paper)?;
        }
        Some(crossover) => {
            // A crossover that has slid to the wavefront pulls at a node that is not to be visited yet:
            // its wave enters the element ahead of that in this very step.
            if crossover.fibre.tension[0] != S::zero() {
                let primary = &mut state.primary;
                primary.visited = primary.visited.max((crossover.node + 1).min(primary.elements()));
            }
            state.work.count(&state.primary);
            state.work.count(&crossover.fibre);
            state.work.secondary += 1;
            state.work.drives += 1;
            state.work.pushes += u64::from(crossover.node <= state.primary.visited);
            let at_crossover = &*crossover;
            let ix = crossover.node;
            along(Fibre::Primary).march(paper, &mut state.primary, drive, |primary, nodes| {
                if nodes.contains(&ix) {
                    primary.velocity[ix] =
                        at_crossover.push(paper, step, primary, primary.velocity[ix]);
                }
            })?;
            state.push_projectile(paper)?;
            if let Some(crossover) = &mut state.crossover {
                let drive = crossover.drive(paper, step, &state.primary);
                along(Fibre::Secondary).march(paper, &mut crossover.fibre, drive, |_, _| ())?;
                crossover_stays = crossover.reassign_node(step, &state.primary);
            }
        }
    }
    state.account_for_work(force_before);
    crossover_stays
}

/// What the length loop of one fibre needs to know besides the fibre.
struct Along<S> {
    step: u64,
    fibre: Fibre,
    time_step: S,
}

/// What the equations of a block of elements read of their two ends and of themselves.
struct Elements<'f, S: Number, const D: usize> {
    x_here: &'f [Vector<S, D>],
    x_ahead: &'f [Vector<S, D>],
    v_here: &'f [Vector<S, D>],
    v_ahead: &'f [Vector<S, D>],
    unstrained: &'f [S],
    /// Index of the first.
    first: usize,
    time_step: S,
}

impl<'f, S: Number, const D: usize> Elements<'f, S, D> {
    /// The elements of a range, whose nodes have their new velocities and their old positions.
    #[inline(always)]
    fn of(
        position: &'f [Vector<S, D>],
        velocity: &'f [Vector<S, D>],
        unstrained: &'f [S],
        range: Range<usize>,
        time_step: S,
    ) -> Self {
        let count = range.len();
        let ahead = range.start + 1..;
        Self {
            first: range.start,
            x_here: &position[range.clone()],
            x_ahead: &position[ahead.clone()][..count],
            v_here: &velocity[range.clone()],
            v_ahead: &velocity[ahead][..count],
            unstrained: &unstrained[range],
            time_step,
        }
    }

    /// (5) and (6).
    #[inline(always)]
    fn lengths(&self, paper: &impl Paper<S>, i: usize) -> Lengths<S> {
        let Self { x_here, x_ahead, v_here, v_ahead, unstrained, time_step, .. } = self;
        Lengths {
            previous: if paper.uses_previous_length() {
                paper.eqn_5_previous_length(x_ahead[i], x_here[i])
            } else {
                S::zero()
            },
            now: paper.eqn_6_length(x_ahead[i], v_ahead[i], x_here[i], v_here[i], *time_step),
            unstrained: unstrained[i],
        }
    }

    /// From one end to the other, now.
    #[inline(always)]
    fn element(&self, i: usize) -> Vector<S, D> {
        let dt = self.time_step;
        (self.x_ahead[i] + self.v_ahead[i] * dt) - (self.x_here[i] + self.v_here[i] * dt)
    }
}

impl<S: Number> Along<S> {
    /// The length loop: eqns (2), (5), (6), (4) and (7) from the driven end to the wavefront.
    ///
    /// It goes in blocks of elements. Elements ahead of a block still hold `t−1` and those behind
    /// it already hold `t`, so a block of one is the page's recursion to the letter, and a longer one
    /// gives the same bits while the processor works on several elements at once.
    ///
    /// `adjust` may change what (2) gave the nodes of a block: it is where (17) and (18) come in,
    /// and nothing at all for a fibre without a crossover.
    #[inline(always)]
    fn march<P: Paper<S>, const D: usize>(
        &self,
        paper: &P,
        fibre: &mut FibreState<S, D>,
        driven: Vector<S, D>,
        adjust: impl Fn(&mut FibreState<S, D>, Range<usize>),
    ) -> Result<(), Outcome> {
        let (front, clamp) = (fibre.visited, fibre.elements());
        let dt = self.time_step;
        fibre.velocity[0] = driven;
        fibre.velocity[clamp] = fibre.clamp_velocity;
        let block = if fibre.constitution.is_none() { P::BLOCK } else { P::BLOCK_BY_LAW };
        let mut start = 0;
        while start < front {
            let end = (start + block).min(front);
            let nodes = start + 1..(end + 1).min(clamp);
            self.velocities(
                paper,
                nodes.start,
                fibre.properties.a,
                &mut fibre.velocity[nodes.clone()],
                &fibre.pull[start..],
            );
            adjust(fibre, nodes);
            let elements =
                Elements::of(&fibre.position, &fibre.velocity, &fibre.unstrained, start..end, dt);
            let (strain, tension) = (&mut fibre.strain[start..end], &mut fibre.tension[start..end]);
            let pull = &mut fibre.pull[start..end];
            let finite = match &mut fibre.constitution {
                None => {
                    let stiffness = fibre.properties.stiffness;
                    self.elements(paper, elements, stiffness, strain, tension, pull)
                }
                Some(constitution) => {
                    self.elements_by_law(paper, elements, constitution, strain, tension, pull)?
                }
            };
            if !finite {
                return Err(self.diverged(fibre, start..end));
            }
            for (x, v) in fibre.position[start..end].iter_mut().zip(&fibre.velocity[start..end]) {
                *x += *v * dt;
            }
            start = end;
        }
        fibre.position[front] += fibre.velocity[front] * dt;
        if front < clamp && fibre.tension[front - 1] != S::zero() {
            fibre.visited += 1;
        }
        Ok(())
    }

    /// (2) for a block of inner nodes, from the one with index `first`; `pull` begins one element
    /// before it.
    #[inline(always)]
    fn velocities<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        first: usize,
        a: S,
        velocity: &mut [Vector<S, D>],
        pull: &[Vector<S, D>],
    ) {
        let count = velocity.len();
        let (here, ahead) = (&pull[..count], &pull[1..][..count]);
        for i in 0..count {
            paper.at(self.place(first + i));
            velocity[i] = paper.eqn_2_velocity(velocity[i], a, ahead[i], here[i]);
        }
    }

    /// (5), (6), (4) and (7) for a block of elements. Whether all of it is finite.
    ///
    /// What it writes comes as three slices of their own, so that the compiler knows them apart.
    #[inline(always)]
    fn elements<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        elements: Elements<'_, S, D>,
        stiffness: S,
        strain: &mut [S],
        tension: &mut [S],
        pull: &mut [Vector<S, D>],
    ) -> bool {
        let count = strain.len();
        let (tension, pull) = (&mut tension[..count], &mut pull[..count]);
        let mut finite = true;
        for i in 0..count {
            paper.at(self.place(elements.first + i));
            let length = elements.lengths(paper, i);
            strain[i] = paper.eqn_4_strain(strain[i], length);
            tension[i] = paper.eqn_7_tension(stiffness, strain[i]);
            // "The tension T_i has the same direction as the element itself."
            let pull_per_length = tension[i] / length.now;
            pull[i] = elements.element(i) * pull_per_length;
            finite &= pull_per_length.is_finite();
        }
        finite
    }

    /// The same with another law in the place of (7): the strains of the block, its stresses in one
    /// call of the law, its tensions.
    #[inline(always)]
    fn elements_by_law<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        elements: Elements<'_, S, D>,
        by: &mut Constitution<S>,
        strain: &mut [S],
        tension: &mut [S],
        pull: &mut [Vector<S, D>],
    ) -> Result<bool, Outcome> {
        let count = strain.len();
        by.block.fit(count);
        let lengths = &mut by.block.length[..count];
        let previous_lengths = &mut by.block.previous_length[..count];
        let strains_before = &mut by.block.strain_before[..count];
        for (i, strain) in strain.iter_mut().enumerate() {
            paper.at(self.place(elements.first + i));
            let length = elements.lengths(paper, i);
            lengths[i] = length.now;
            previous_lengths[i] = length.previous;
            strains_before[i] = *strain;
            *strain = paper.eqn_4_strain(*strain, length);
        }
        let along_path = paper.uses_previous_length();
        if along_path {
            by.stresses_along_path(elements.first, strain, tension);
        } else {
            by.stresses(elements.first, strain);
        }
        let stresses = &by.block.stress[..count];
        let strains_before = &by.block.strain_before[..count];
        let lengths = &by.block.length[..count];
        let (tension, pull) = (&mut tension[..count], &mut pull[..count]);
        let mut finite = true;
        for (i, &strain) in strain.iter().enumerate() {
            let stress = StressByLaw {
                stress: stresses[i],
                strain_before: strains_before[i],
                strain,
                memory: by.remembered(elements.first + i),
            };
            tension[i] = paper.eqn_7_tension_by_law(by.area, stress);
            let pull_per_length = tension[i] / lengths[i];
            pull[i] = elements.element(i) * pull_per_length;
            // A law whose stress is bounded makes a finite tension of an infinite strain.
            finite &= pull_per_length.is_finite() & strain.is_finite();
        }
        // (4) adds ΔL/L^{t−1}, the engineering strain ΔL/L⁰.
        let per_stretch = |block: &Block<S>, i: usize| {
            if along_path { elements.unstrained[i] / block.previous_length[i] } else { S::one() }
        };
        let breach = by.breach(elements.first, strain, per_stretch);
        // Of both kinds of failure the first is named, as it is in blocks of one.
        let is_whole =
            |i: usize| strain[i].is_finite() && (tension[i] / by.block.length[i]).is_finite();
        match breach {
            Some((i, breach)) if finite || (0..=i).all(is_whole) => {
                Err(breach.at(self.place(elements.first + i)))
            }
            _ => Ok(finite),
        }
    }

    fn place(&self, index: usize) -> Place {
        Place { step: self.step, fibre: self.fibre, index }
    }

    /// Names the first equation of a block whose result is not finite, or the length that vanished.
    #[cold]
    fn diverged<const D: usize>(&self, fibre: &FibreState<S, D>, block: Range<usize>) -> Outcome {
        let moved = |i: usize| fibre.position[i] + fibre.velocity[i] * self.time_step;
        for i in block {
            let length = magnitude(moved(i + 1) - moved(i));
            let (index, equation) = if !fibre.velocity[i + 1].iter().all(|v| v.is_finite()) {
                (i + 1, 2)
            } else if !length.is_finite() || length == S::zero() {
                (i, 6)
            } else if !fibre.strain[i].is_finite() {
                (i, 4)
            } else if !(fibre.tension[i] / length).is_finite() {
                (i, 7)
            } else if !fibre.pull[i].iter().all(|t| t.is_finite()) {
                // An edition may have a (6) of its own.
                (i, 6)
            } else {
                continue;
            };
            return Outcome::Diverged { place: self.place(index), equation };
        }
        unreachable!("an element of the block was found not to be finite")
    }
}

impl Breach {
    /// The outcome of a run that ends by it.
    pub fn at(self, place: Place) -> Outcome {
        match self {
            Self::Courant(courant) => Outcome::CourantExceeded {
                place,
                courant,
                would_serve: None,
                search_given_up: false,
            },
            Self::NoWaves(strain) => Outcome::NoWaves { place, strain },
        }
    }
}

impl<S: Number> Crossover<S> {
    /// Eqns (15)–(18): what the secondary's tension adds to the crossover node's velocity.
    ///
    /// Tension and direction cosines are those of `t−1`, since the secondary is marched after the
    /// primary (ledger `time-level`).
    pub(crate) fn push(
        &self,
        paper: &impl Paper<S>,
        step: u64,
        primary: &FibreState<S, 2>,
        v: Vector<S, 2>,
    ) -> Vector<S, 2> {
        paper.at(Place { step, fibre: Fibre::Primary, index: self.node });
        let phi_1 = {
            let element = primary.position[self.node] - primary.position[self.node - 1];
            let length = magnitude(element);
            Cosines { x: element.x / length, y: element.y / length }
        };
        let phi_2 = {
            let element = self.fibre.position[1] - self.fibre.position[0];
            let length = magnitude(element);
            Cosines { x: element.x / length, y: element.y / length }
        };
        let tension = self.fibre.tension[0];
        let push = CrossoverPush {
            a: primary.properties.a,
            slide_factor: self.slide_factor,
            parallel: paper.eqn_15_parallel_tension(tension, phi_2, phi_1),
            perpendicular: paper.eqn_16_perpendicular_tension(tension, phi_2, phi_1),
            primary: phi_1,
            change: (primary.pull[self.node] - primary.pull[self.node - 1]) * primary.properties.a,
            mass: primary.properties.mass,
            secondary_mass: self.fibre.properties.mass,
        };
        Vector::<S, 2>::new(
            paper.eqn_17_u_at_crossover(v.x, push),
            paper.eqn_18_v_at_crossover(v.y, push),
        )
    }

    /// Eqns (9)–(14): the velocity that the primary imposes on the secondary's first node.
    pub(crate) fn drive(
        &self,
        paper: &impl Paper<S>,
        step: u64,
        primary: &FibreState<S, 2>,
    ) -> Vector<S, 3> {
        paper.at(Place { step, fibre: Fibre::Secondary, index: 0 });
        let ix = self.node;
        let velocity = primary.velocity[ix];
        let theta = paper.eqn_11_direction(primary.position[ix], primary.position[ix - 1]);
        self.impose(paper, velocity, theta)
    }

    /// Eqns (9), (10) and (12)–(14): the part of a velocity of the primary that its crossing fibre
    /// follows.
    pub(crate) fn impose(
        &self,
        paper: &impl Paper<S>,
        velocity: Vector<S, 2>,
        theta: Direction<S>,
    ) -> Vector<S, 3> {
        let parallel = paper.eqn_9_parallel_velocity(velocity.x, velocity.y, theta);
        let perpendicular = paper.eqn_10_perpendicular_velocity(velocity.x, velocity.y, theta);
        Vector::<S, 3>::new(
            paper.eqn_12_secondary_u(self.slide_factor, parallel, perpendicular, theta),
            paper.eqn_13_secondary_v(self.slide_factor, parallel, perpendicular, theta),
            paper.eqn_14_secondary_w(),
        )
    }

    /// "After each time increment, … ix is assigned to the nearest node on the primary fibre." An end
    /// of the fibre is no place for a crossover: the run ends, and `ix` stays where it was.
    fn reassign_node(&mut self, step: u64, primary: &FibreState<S, 2>) -> Result<(), Outcome> {
        let nearest = self.nearest_node(primary);
        let left = |end| Err(Outcome::CrossoverLeft { step, end });
        match nearest {
            0 => return left(End::ImpactPoint),
            n if n == primary.elements() => return left(End::Clamp),
            _ => {}
        }
        if nearest != self.node {
            self.node = nearest;
            self.moves += 1;
        }
        Ok(())
    }
}

impl<S: Number> State<S> {
    /// Eqn (8), "at the completion of the lengthwise recursive calculations"; left out where the
    /// velocity stays constant.
    fn push_projectile(&mut self, paper: &impl Paper<S>) -> Result<(), Outcome> {
        let Some(mass) = self.projectile.mass else {
            return Ok(());
        };
        let place = Place { step: self.step, fibre: Fibre::Primary, index: 0 };
        paper.at(place);
        self.work.projectile += 1;
        self.projectile.velocity = paper.eqn_8_projectile_velocity(ProjectilePush {
            velocity: self.projectile.velocity,
            tension_y: self.first_tension_along_axis(),
            mass,
            node_mass: self.projectile_node_mass(),
            time_step: self.time_step,
            time: self.time(),
        });
        if self.projectile.velocity.is_finite() {
            Ok(())
        } else {
            Err(Outcome::Diverged { place, equation: 8 })
        }
    }
}
