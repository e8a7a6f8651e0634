//! The page's recursion, one element after the other, in plain words, and what goes wrong when it is
//! programmed.
//!
//! Without a fault it is [`crossfibre::march`] in other words, and gives the same bits.

mod coupling;

use crossfibre::constitution::{Breach, Constitution};
use crossfibre::march;
use crossfibre::number::{Number, Vector};
use crossfibre::outcome::Outcome;
use crossfibre::paper::{Lengths, Paper, StressByLaw, magnitude};
use crossfibre::place::{Fibre, Place};
use crossfibre::state::{FibreState, State};

use super::{Plant, now};
use coupling::{drive_of, push, push_projectile, reassign};

faults! {
    SecondaryFirst "march-secondary-first" "marches the secondary before the primary";
    ProjectileFirst "march-projectile-first" "slows the projectile before the fibres are marched";
    StrainFirst "march-strain-first" "strains an element before its far node has its new velocity";
    TensionNow "march-tension-now" "pushes a node by tensions that are already those of t";
    PositionFirst "march-position-first" "moves a node before its element is measured";
    CosinesNow "march-cosines-now" "takes the direction of the primary when one of its nodes has moved";
    DriveBefore "march-drive-before" "drives the secondary by the velocity of one step ago";
    MeanVelocity "march-mean-velocity" "moves nodes by the mean of the velocities before and after";
    ClampFree "march-clamp-free" "forgets the clamp: the last node is pushed as if nothing were beyond it";
    ClampFollows "march-clamp-follows" "gives the clamp the velocity of the node before it";
    ClampAtRest "march-clamp-at-rest" "takes a clamp to be at rest, whatever its velocity is";
    DrivenPushed "march-driven-pushed" "pushes the driven node by (2) too";
    LastLeftOut "march-last-left-out" "ends the loop before the last element";
    PushBehind "march-push-behind" "pushes the node before the crossover";
    PushAhead "march-push-ahead" "pushes the node beyond the crossover";
    DriveBehind "march-drive-behind" "drives the secondary by the node before the crossover";
    IndexStale "march-ix-stale" "never assigns ix again";
    IndexAhead "march-ix-ahead" "assigns ix to the node beyond the nearest";
    FlagsShort "march-flags-short" "leaves the far node of the last visited element at rest";
    FlagsLate "march-flags-late" "visits an element one step late";
    OriginSwapped "march-origin-swapped" "takes x and y for each other in the secondary where both are struck";
    FlagsNone "march-flags-none" "visits every element in every step";
    OneStepLess "march-one-step-less" "ends a run one step early";
    OneFibreSlows "march-one-fibre-slows" "slows the projectile by the primary alone where both are struck";
    WorkBefore "march-work-before" "books the work of a step by the force before it";
}

/// What is to be marched otherwise, if anything is: in other words, rightly or wrongly.
fn otherwise() -> Option<Option<Wrong>> {
    match now()? {
        Plant::March(wrong) => Some(Some(wrong)),
        Plant::InPlainWords => Some(None),
        _ => None,
    }
}

/// As [`crossfibre::march::step`].
pub fn step<S: Number>(paper: &impl Paper<S>, state: &mut State<S>) -> Result<(), Outcome> {
    match otherwise() {
        None => march::step(paper, state),
        Some(wrong) => step_in_plain_words(paper, state, wrong),
    }
}

/// As [`crossfibre::march::run`].
pub fn run<S: Number>(
    paper: &impl Paper<S>,
    state: &mut State<S>,
    steps: u64,
    mut watch: impl FnMut(&State<S>),
) -> Outcome {
    match otherwise() {
        None => march::run(paper, state, steps, watch),
        Some(wrong) => run_in_plain_words(paper, state, steps, &mut watch, wrong),
    }
}

/// As [`crate::wide::march`].
pub fn wide<S: Number, P: Paper<S>>(
    paper: &P,
    state: &mut State<S>,
    steps: u64,
    mut watch: impl FnMut(&State<S>),
) -> Outcome {
    match otherwise() {
        None => crate::wide::march(paper, state, steps, watch),
        Some(wrong) => run_in_plain_words(paper, state, steps, &mut watch, wrong),
    }
}

/// The run, with a fault or without.
#[inline(never)]
pub fn run_in_plain_words<S: Number>(
    paper: &impl Paper<S>,
    state: &mut State<S>,
    steps: u64,
    watch: &mut dyn FnMut(&State<S>),
    wrong: Option<Wrong>,
) -> Outcome {
    let steps = if wrong == Some(Wrong::OneStepLess) { steps.saturating_sub(1) } else { steps };
    for _ in 0..steps {
        if let Err(outcome) = step_in_plain_words(paper, state, wrong) {
            return outcome;
        }
        watch(state);
    }
    Outcome::Completed
}

/// One time step, with a fault or without.
#[inline(never)]
pub fn step_in_plain_words<S: Number>(
    paper: &impl Paper<S>,
    state: &mut State<S>,
    wrong: Option<Wrong>,
) -> Result<(), Outcome> {
    let is = |fault| wrong == Some(fault);
    state.step += 1;
    let force_before = state.account_for_impulses();
    let (step, time_step) = (state.step, state.time_step);
    let along = |fibre| Loop { step, fibre, time_step, wrong };
    let drive = state.projectile.axis * state.projectile.velocity;
    if is(Wrong::ProjectileFirst) {
        push_projectile(paper, state, wrong)?;
    }
    if is(Wrong::FlagsNone) {
        state.primary.visited = state.primary.elements();
    }
    let mut stays = Ok(());

    if let Some(crossover) = &mut state.crossover
        && !crossover.at_origin()
    {
        let primary = &mut state.primary;
        // The secondary may pull at a node that the primary's own wave has not reached.
        if crossover.fibre.tension[0] != S::zero() {
            primary.visited = primary.visited.max((crossover.node + 1).min(primary.elements()));
        }
        state.work.count(primary);
        state.work.count(&crossover.fibre);
        state.work.secondary += 1;
        state.work.drives += 1;
        state.work.pushes += u64::from(crossover.node <= primary.visited);
        let drive_before = drive_of(crossover, primary, wrong);
        if is(Wrong::SecondaryFirst) {
            let drive = drive_before.imposed(paper, step, crossover);
            along(Fibre::Secondary).march(paper, &mut crossover.fibre, drive, &|_, _, _| None)?;
        }
        {
            let crossover = &*crossover;
            let node = match wrong {
                Some(Wrong::PushBehind) => crossover.node - 1,
                Some(Wrong::PushAhead) => crossover.node + 1,
                _ => crossover.node,
            };
            along(Fibre::Primary).march(paper, primary, drive, &|primary, i, v| {
                (i == node).then(|| push(paper, step, crossover, primary, v))
            })?;
        }
        if !is(Wrong::ProjectileFirst) {
            push_projectile(paper, state, wrong)?;
        }
        if let Some(crossover) = &mut state.crossover {
            if !is(Wrong::SecondaryFirst) {
                let now = drive_of(crossover, &state.primary, wrong);
                let from = if is(Wrong::DriveBefore) { drive_before } else { now };
                let drive = from.imposed(paper, step, crossover);
                along(Fibre::Secondary)
                    .march(paper, &mut crossover.fibre, drive, &|_, _, _| None)?;
            }
            stays = reassign(crossover, step, &state.primary, wrong);
        }
    } else {
        state.work.count(&state.primary);
        if let Some(crossover) = &state.crossover {
            state.work.count(&crossover.fibre);
            state.work.secondary += 1;
        }
        along(Fibre::Primary).march(paper, &mut state.primary, drive, &|_, _, _| None)?;
        if let Some(crossover) = &mut state.crossover {
            paper.at(Place { step, fibre: Fibre::Secondary, index: 0 });
            let (x, y) =
                if is(Wrong::OriginSwapped) { (drive.y, drive.x) } else { (drive.x, drive.y) };
            let drive = Vector::<S, 3>::new(x, y, paper.eqn_14_secondary_w());
            along(Fibre::Secondary).march(paper, &mut crossover.fibre, drive, &|_, _, _| None)?;
        }
        if !is(Wrong::ProjectileFirst) {
            push_projectile(paper, state, wrong)?;
        }
    }
    if is(Wrong::WorkBefore) {
        // What the books add to the force before is the force after.
        let twice = force_before + force_before - state.first_tension_along_axis();
        state.account_for_work(twice);
    } else {
        state.account_for_work(force_before);
    }
    stays
}

/// The length loop of one fibre.
struct Loop<S> {
    step: u64,
    fibre: Fibre,
    time_step: S,
    wrong: Option<Wrong>,
}

/// What a crossover makes of the velocity of a node, if it is its node.
type Push<'a, S, const D: usize> =
    &'a dyn Fn(&FibreState<S, D>, usize, Vector<S, D>) -> Option<Vector<S, D>>;

/// Work on the elements of a block, and what their law took of it: the energies along the path of
/// (4) are summed up by blocks, and so are their roundings.
struct Booked<S> {
    worked: S,
    lost: S,
}

impl<S: Number> Loop<S> {
    fn is(&self, wrong: Wrong) -> bool {
        self.wrong == Some(wrong)
    }

    fn place(&self, index: usize) -> Place {
        Place { step: self.step, fibre: self.fibre, index }
    }

    fn march<P: Paper<S>, const D: usize>(
        &self,
        paper: &P,
        fibre: &mut FibreState<S, D>,
        driven: Vector<S, D>,
        push: Push<'_, S, D>,
    ) -> Result<(), Outcome> {
        let (front, clamp, dt) = (fibre.visited, fibre.elements(), self.time_step);
        let end = match self.wrong {
            Some(Wrong::LastLeftOut) => front.min(clamp - 1),
            Some(Wrong::FlagsLate) if front < clamp => (front - 1).max(1),
            _ => front,
        };
        let mut before = fibre.velocity[0];
        fibre.velocity[0] = driven;
        if self.is(Wrong::DrivenPushed) {
            let (a, pull) = (fibre.properties.a, fibre.pull[0]);
            fibre.velocity[0] = paper.eqn_2_velocity(driven, a, pull, Vector::zeros());
        }
        if !self.is(Wrong::ClampFree) {
            let at_rest = self.is(Wrong::ClampAtRest);
            fibre.velocity[clamp] = if at_rest { Vector::zeros() } else { fibre.clamp_velocity };
        }
        if self.is(Wrong::PositionFirst) {
            fibre.position[0] += fibre.velocity[0] * dt;
        }
        if self.is(Wrong::TensionNow) {
            self.elements(paper, fibre, 0..end)?;
        }
        let mut booked = Booked { worked: S::zero(), lost: S::zero() };
        for i in 0..end {
            if self.is(Wrong::StrainFirst) {
                self.element(paper, fibre, i, &mut booked)?;
            }
            let before_ahead = fibre.velocity[i + 1];
            if !(self.is(Wrong::FlagsShort) && i + 1 == end) {
                self.velocity(paper, fibre, i, push);
            }
            if self.is(Wrong::PositionFirst) {
                fibre.position[i + 1] += fibre.velocity[i + 1] * dt;
            }
            if !self.is(Wrong::StrainFirst) && !self.is(Wrong::TensionNow) {
                self.element(paper, fibre, i, &mut booked)?;
            }
            if (i + 1).is_multiple_of(P::BLOCK_BY_LAW) || i + 1 == end {
                self.book(paper, fibre, &mut booked);
            }
            if !self.is(Wrong::PositionFirst) {
                self.move_node(fibre, i, before);
            }
            before = before_ahead;
        }
        if !self.is(Wrong::PositionFirst) {
            self.move_node(fibre, end, before);
        }
        if front < clamp && fibre.tension[end - 1] != S::zero() {
            fibre.visited += 1;
        }
        Ok(())
    }

    /// (2) for the far node of an element, and what a crossover adds to it.
    fn velocity<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        fibre: &mut FibreState<S, D>,
        i: usize,
        push: Push<'_, S, D>,
    ) {
        let (node, a) = (i + 1, fibre.properties.a);
        let here = fibre.pull[i];
        if node == fibre.elements() {
            if self.is(Wrong::ClampFree) {
                let v = fibre.velocity[node];
                fibre.velocity[node] = paper.eqn_2_velocity(v, a, Vector::zeros(), here);
            } else if self.is(Wrong::ClampFollows) {
                fibre.velocity[node] = fibre.velocity[node - 1];
            }
            return;
        }
        paper.at(self.place(node));
        fibre.velocity[node] =
            paper.eqn_2_velocity(fibre.velocity[node], a, fibre.pull[node], here);
        let unmoved = fibre.position[i];
        if self.is(Wrong::CosinesNow) {
            fibre.position[i] += fibre.velocity[i] * self.time_step;
        }
        if let Some(pushed) = push(fibre, node, fibre.velocity[node]) {
            fibre.velocity[node] = pushed;
        }
        fibre.position[i] = unmoved;
    }

    fn move_node<const D: usize>(
        &self,
        fibre: &mut FibreState<S, D>,
        i: usize,
        before: Vector<S, D>,
    ) {
        let now = fibre.velocity[i];
        let velocity = if self.is(Wrong::MeanVelocity) { (before + now) * S::half() } else { now };
        fibre.position[i] += velocity * self.time_step;
    }

    /// Elements by themselves.
    fn elements<P: Paper<S>, const D: usize>(
        &self,
        paper: &P,
        fibre: &mut FibreState<S, D>,
        range: std::ops::Range<usize>,
    ) -> Result<(), Outcome> {
        let mut booked = Booked { worked: S::zero(), lost: S::zero() };
        for i in range {
            self.element(paper, fibre, i, &mut booked)?;
        }
        self.book(paper, fibre, &mut booked);
        Ok(())
    }

    /// (5), (6), (4) and (7) for an element.
    fn element<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        fibre: &mut FibreState<S, D>,
        i: usize,
        booked: &mut Booked<S>,
    ) -> Result<(), Outcome> {
        paper.at(self.place(i));
        let dt = self.time_step;
        let (x_here, x_ahead) = (fibre.position[i], fibre.position[i + 1]);
        let (v_here, v_ahead) = (fibre.velocity[i], fibre.velocity[i + 1]);
        let along_path = paper.uses_previous_length();
        let length = Lengths {
            previous: if along_path {
                paper.eqn_5_previous_length(x_ahead, x_here)
            } else {
                S::zero()
            },
            now: paper.eqn_6_length(x_ahead, v_ahead, x_here, v_here, dt),
            unstrained: fibre.unstrained[i],
        };
        let before = fibre.strain[i];
        let strain = paper.eqn_4_strain(before, length);
        fibre.strain[i] = strain;
        let mut ended = None;
        fibre.tension[i] = match &mut fibre.constitution {
            None => paper.eqn_7_tension(fibre.properties.stiffness, strain),
            Some(by) => {
                let tension_before = fibre.tension[i];
                let (stress, breach) =
                    stressed(by, i, [before, strain], length, tension_before, along_path, booked);
                ended = breach.map(|breach| breach.at(self.place(i)));
                let memory = by.remembered(i);
                let by_law = StressByLaw { stress, strain_before: before, strain, memory };
                paper.eqn_7_tension_by_law(by.area, by_law)
            }
        };
        let pull_per_length = fibre.tension[i] / length.now;
        fibre.pull[i] = ((x_ahead + v_ahead * dt) - (x_here + v_here * dt)) * pull_per_length;
        let bounded = fibre.constitution.is_none() || strain.is_finite();
        if !(pull_per_length.is_finite() && bounded) {
            return Err(self.diverged(fibre, i));
        }
        ended.map_or(Ok(()), Err)
    }

    /// Books the energies of a block.
    fn book<const D: usize>(
        &self,
        paper: &impl Paper<S>,
        fibre: &mut FibreState<S, D>,
        booked: &mut Booked<S>,
    ) {
        if let Some(by) = &mut fibre.constitution
            && paper.uses_previous_length()
        {
            let lost = booked.lost * by.area;
            by.path.stored += S::half() * booked.worked - lost;
            by.path.dissipated += lost;
        }
        *booked = Booked { worked: S::zero(), lost: S::zero() };
    }

    /// Names the first equation of an element whose result is not finite, or its length.
    fn diverged<const D: usize>(&self, fibre: &FibreState<S, D>, i: usize) -> Outcome {
        let moved = |i: usize| fibre.position[i] + fibre.velocity[i] * self.time_step;
        let length = magnitude(moved(i + 1) - moved(i));
        let (index, equation) = if !fibre.velocity[i + 1].iter().all(|v| v.is_finite()) {
            (i + 1, 2)
        } else if !length.is_finite() || length == S::zero() {
            (i, 6)
        } else if !fibre.strain[i].is_finite() {
            (i, 4)
        } else if !(fibre.tension[i] / length).is_finite() {
            (i, 7)
        } else {
            (i, 6)
        };
        Outcome::Diverged { place: self.place(index), equation }
    }
}

/// The stress of an element of another law than (7), and how it breaks the bounds of the scheme.
fn stressed<S: Number>(
    by: &mut Constitution<S>,
    i: usize,
    [before, strain]: [S; 2],
    length: Lengths<S>,
    tension_before: S,
    along_path: bool,
    booked: &mut Booked<S>,
) -> (S, Option<Breach>) {
    by.block.fit(1);
    by.block.strain_before[0] = before;
    by.block.previous_length[0] = length.previous;
    let n = by.law.memory();
    let memory = &mut by.memory[i * n..][..n];
    let lost_before = by.law.dissipated(memory);
    let mut stress = [S::zero()];
    by.law.stresses(&[before], &[strain], memory, &mut stress);
    let [stress] = stress;
    let longer = length.previous * (strain - before);
    booked.worked += (tension_before + by.area * stress) * longer;
    if n > 0 {
        booked.lost += length.previous * (by.law.dissipated(memory) - lost_before);
    }
    let per_stretch = if along_path { length.unstrained / length.previous } else { S::one() };
    let breach = by.breach(i, &[strain], |_, _| per_stretch);
    (stress, breach.map(|(_, breach)| breach))
}
