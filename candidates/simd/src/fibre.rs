//! A fibre in blocks of vectors, and a step of it.

use std::ops::Range;

use crate::block::{Block, Constants, Rooted, Strained, each_component};
use crate::division::{MOST_STRAIN, STIFFNESS};
use crate::lanes::Lanes;
use crate::mesh::Properties;
use crate::state::{FibreState, difference, magnitude};

/// One fibre.
pub(crate) struct Fibre<L: Lanes, const D: usize> {
    pub lanes: L,
    /// Node 0 in all lanes; all elements; a block that stays at rest.
    pub blocks: Vec<Block<L, D>>,
    /// n
    pub elements: usize,
    /// Elements from the driven end that are visited; those beyond are at rest.
    pub visited: usize,
    /// The same, summed over the steps made.
    pub element_steps: u64,
    /// Position of node 0, m.
    pub first_position: [f64; D],
    /// Velocity of node 0, m/s.
    pub first_velocity: [f64; D],
    /// Constants.
    pub properties: Properties,
    time_step: f64,
    /// A; zero in the lanes of the last block that are not an inner node's.
    a: [L::V; 2],
    /// Strains below are ordinary.
    most_strain: f64,
    /// Of a state that a run is taken up from, N.
    tension_at_start: f64,
}

impl<L: Lanes, const D: usize> Fibre<L, D> {
    /// The fibre in a state. `along` is the axis of the fibre at rest.
    pub fn of(
        lanes: L,
        state: &FibreState<D>,
        properties: Properties,
        time_step: f64,
        along: usize,
        engineering: bool,
    ) -> Self {
        let (n, count) = (properties.elements, L::COUNT);
        let full = n.div_ceil(count);
        // Beyond the clamp a continuation at rest, whose numbers are harmless.
        let position = |i: usize| {
            let mut x = state.position[i.min(n)];
            x[along] += i.saturating_sub(n) as f64 * properties.spacing;
            x
        };
        let length = |e: usize| magnitude(difference(position(e + 1), position(e)));
        let base = |e: usize| {
            if engineering && e < n { properties.unstrained(e) } else { length(e) }
        };
        let pull_per_length = |e: usize| state.tension[e] / length(e);
        let vector = |f: &dyn Fn(usize) -> f64, first: usize| {
            let mut x = lanes.array(lanes.splat(0.0));
            x.as_mut().iter_mut().enumerate().for_each(|(i, x)| *x = f(first + i));
            lanes.vector(x)
        };
        let inner = |node: usize, x: f64| if node < n { x } else { 0.0 };
        let node_0 = Block {
            position: state.position[0].map(|x| lanes.splat(x)),
            velocity: [lanes.splat(0.0); D],
            pull: [lanes.splat(0.0); D],
            strain: lanes.splat(0.0),
            base: lanes.splat(1.0),
            base_reciprocal: lanes.splat(1.0),
        };
        let blocks = (0..=full).map(|b| {
            let vector = |f: &dyn Fn(usize) -> f64| vector(f, b * count);
            let components =
                |f: &dyn Fn(usize, usize) -> f64| std::array::from_fn(|c| vector(&|e| f(e, c)));
            Block {
                position: components(&|e, c| position(e + 1)[c]),
                velocity: components(&|e, c| inner(e + 1, state.velocity[(e + 1).min(n)][c])),
                pull: components(&|e, c| {
                    if e < n {
                        difference(position(e + 1), position(e))[c] * pull_per_length(e)
                    } else {
                        0.0
                    }
                }),
                strain: vector(&|e| if e < n { state.strain[e] } else { 0.0 }),
                base: vector(&base),
                base_reciprocal: lanes.reciprocal(vector(&base)),
            }
        });
        let last = (full - 1) * count;
        let ordinary = STIFFNESS.contains(&properties.stiffness)
            && state.strain.iter().all(|s| s.abs() < MOST_STRAIN);
        Self {
            lanes,
            blocks: std::iter::once(node_0).chain(blocks).collect(),
            elements: n,
            visited: state.visited(),
            element_steps: 0,
            first_position: state.position[0],
            first_velocity: state.velocity[0],
            properties,
            time_step,
            most_strain: if ordinary { MOST_STRAIN } else { f64::NEG_INFINITY },
            tension_at_start: state.tension[0],
            a: [lanes.splat(properties.a), vector(&|e| inner(e + 1, properties.a), last)],
        }
    }

    /// The fibre's numbers, in the order of a result.
    pub fn write(&self, state: &mut FibreState<D>, steps_made: bool) {
        state.position[0] = self.first_position;
        state.velocity[0] = self.first_velocity;
        for (b, block) in self.blocks[1..].iter().enumerate() {
            let position = block.position.map(|v| self.lanes.array(v));
            let velocity = block.velocity.map(|v| self.lanes.array(v));
            let strain = self.lanes.array(block.strain);
            for i in 0..L::COUNT {
                let e = b * L::COUNT + i;
                if e < self.elements {
                    state.position[e + 1] = std::array::from_fn(|c| position[c].as_ref()[i]);
                    state.velocity[e + 1] = std::array::from_fn(|c| velocity[c].as_ref()[i]);
                    state.strain[e] = strain.as_ref()[i];
                    if steps_made {
                        state.tension[e] = self.properties.stiffness * state.strain[e];
                    }
                }
            }
        }
    }

    /// The block of an element and of the node ahead of it.
    #[inline(always)]
    pub fn block_of(element: usize) -> usize {
        element / L::COUNT + 1
    }

    /// Position of a node.
    #[inline(always)]
    pub fn position(&self, node: usize) -> [f64; D] {
        self.of_node(node, self.first_position, |block| block.position)
    }

    /// Velocity of a node.
    #[inline(always)]
    pub fn velocity(&self, node: usize) -> [f64; D] {
        self.of_node(node, self.first_velocity, |block| block.velocity)
    }

    /// Tension of an element, as a vector.
    #[inline(always)]
    pub fn pull(&self, element: usize) -> [f64; D] {
        self.of_lane(element, |block| block.pull)
    }

    /// Tension of element 0.
    #[inline(always)]
    pub fn first_tension(&self) -> f64 {
        if self.element_steps == 0 {
            self.tension_at_start
        } else {
            self.properties.stiffness * self.lane(self.blocks[1].strain, 0)
        }
    }

    #[inline(always)]
    fn of_node(
        &self,
        node: usize,
        first: [f64; D],
        vectors: impl Fn(&Block<L, D>) -> [L::V; D],
    ) -> [f64; D] {
        if node == 0 { first } else { self.of_lane(node - 1, vectors) }
    }

    #[inline(always)]
    fn of_lane(&self, i: usize, vectors: impl Fn(&Block<L, D>) -> [L::V; D]) -> [f64; D] {
        self.lane_of_each(&vectors(&self.blocks[Self::block_of(i)]), i % L::COUNT)
    }

    /// One step, from the driven end to the wavefront. `adjust` may change what (2) gave a block's
    /// nodes. Whether all is finite.
    #[inline(always)]
    pub fn step<const ENGINEERING: bool>(
        &mut self,
        drive: [f64; D],
        adjust: impl Fn(usize, &mut [L::V; D]),
    ) -> bool {
        let blocks = 0..self.visited.div_ceil(L::COUNT);
        self.drive(drive);
        let whole = self.sweep::<ENGINEERING>(blocks, adjust);
        self.note_front();
        whole
    }

    /// Several steps, in pieces of the fibre that stay in the first-level cache: a piece makes all
    /// steps before the next one makes the first, each step a block further inward than the one
    /// before, so that it finds its neighbours at the times that it needs. `drive` gives the velocity
    /// of node 0 in a step.
    #[inline(always)]
    pub fn steps<const ENGINEERING: bool>(
        &mut self,
        steps: usize,
        mut drive: impl FnMut(&Self) -> [f64; D],
    ) -> bool {
        // The wavefront moves by an element a step at most.
        let (visited, elements) = (self.visited, self.elements);
        let blocks = |step: usize| (visited + step).min(elements).div_ceil(L::COUNT);
        let pieces = blocks(steps - 1).div_ceil(L::PIECE);
        let (mut whole, mut noted) = (true, 0);
        for piece in 0..pieces {
            for step in 0..steps {
                let start = (piece * L::PIECE).saturating_sub(step);
                let end = if piece + 1 == pieces {
                    blocks(step).max(start)
                } else {
                    (piece + 1) * L::PIECE - step
                };
                if start == 0 {
                    let velocity = drive(self);
                    self.drive(velocity);
                }
                whole &= self.sweep::<ENGINEERING>(
                    start..end,
                    #[inline(always)]
                    |_, _| (),
                );
                if noted == step && (start..end).contains(&((self.visited - 1) / L::COUNT)) {
                    self.note_front();
                    noted += 1;
                }
            }
        }
        whole
    }

    /// A step of some blocks: those ahead are still at `t−1`, those behind already at `t`.
    ///
    /// Four blocks are under way at a time, each at another of the stages of [`crate::block`]. None
    /// waits for another; in an order that follows one block from its velocities to its tensions, a
    /// processor would see little but what waits.
    #[inline(always)]
    fn sweep<const ENGINEERING: bool>(
        &mut self,
        blocks: Range<usize>,
        adjust: impl Fn(usize, &mut [L::V; D]),
    ) -> bool {
        if blocks.is_empty() {
            return true;
        }
        let (lanes, constants, a) = (self.lanes, self.constants(), self.a);
        if blocks.start == 0 {
            self.blocks[0].position = self.first_position_in_all_lanes();
        }
        let (offset, count) = (blocks.start, blocks.len());
        let clamp = Self::block_of(self.elements - 1) - offset;
        // From the block behind the first to the one ahead of the last.
        let all = &mut self.blocks[blocks.start..blocks.end + 2];
        let mut pull = all[1].pull;
        let mut behind = all[0].position;
        let mut moved = behind;
        let nothing = lanes.splat(0.0);
        let mut rooted = Rooted { element: [nothing; D], length: nothing };
        let mut strained = Strained { rooted, reciprocal: nothing, tension: nothing };
        let (mut ordinary, mut whole) = (true, true);
        macro_rules! turn {
            ($b:expr, $wanted:expr) => {{
                let b = $b;
                if $wanted(3) {
                    if ordinary {
                        all[b - 3].pull = strained.pull(lanes);
                    } else {
                        let behind = all[b - 4].position;
                        whole &= all[b - 3].pull_by_the_divider(lanes, &constants, &behind);
                    }
                }
                if $wanted(2) {
                    let block = &mut all[b - 2];
                    if let Some(new) = block.strain::<ENGINEERING>(lanes, &constants, &rooted) {
                        strained = new;
                    } else {
                        let behind = all[b - 3].position;
                        all[b - 2].strain_by_the_divider::<ENGINEERING>(lanes, &behind);
                        ordinary = false;
                    }
                }
                if $wanted(1) {
                    rooted = Rooted::of(lanes, &moved, &behind);
                    behind = moved;
                }
                if $wanted(0) {
                    let ahead = all[b + 1].pull;
                    let a = a[usize::from(b == clamp)];
                    let pulls = [pull, ahead];
                    all[b].move_nodes(
                        lanes,
                        &constants,
                        a,
                        &pulls,
                        #[inline(always)]
                        |v| adjust(offset + b, v),
                    );
                    moved = all[b].position;
                    pull = ahead;
                }
            }};
        }
        for b in 1..4 {
            turn!(b, |stage: usize| (1 + stage..=count + stage).contains(&b));
        }
        for b in 4..=count {
            turn!(b, |_: usize| true);
        }
        for b in count.max(3) + 1..count + 4 {
            turn!(b, |stage: usize| (1 + stage..=count + stage).contains(&b));
        }
        whole
    }

    /// A step has been made. "The wave has entered the last element visited": one more, if its
    /// tension is not zero.
    #[inline(always)]
    fn note_front(&mut self) {
        self.element_steps += self.visited as u64;
        if self.visited < self.elements {
            let last = self.visited - 1;
            let strain = self.lane(self.blocks[Self::block_of(last)].strain, last % L::COUNT);
            self.visited += usize::from(self.properties.stiffness * strain != 0.0);
        }
    }

    /// Node 0 is driven and moves.
    #[inline(always)]
    fn drive(&mut self, velocity: [f64; D]) {
        self.first_velocity = velocity;
        each_component!(D, c => {
            self.first_position[c] += velocity[c] * self.time_step;
        });
    }

    #[inline(always)]
    fn first_position_in_all_lanes(&self) -> [L::V; D] {
        let mut everywhere = [self.lanes.splat(0.0); D];
        each_component!(D, c => {
            everywhere[c] = self.lanes.splat(self.first_position[c]);
        });
        everywhere
    }

    #[inline(always)]
    fn constants(&self) -> Constants<L> {
        Constants {
            time_step: self.lanes.splat(self.time_step),
            stiffness: self.lanes.splat(self.properties.stiffness),
            one: self.lanes.splat(1.0),
            most_strain: self.lanes.splat(self.most_strain),
        }
    }

    #[inline(always)]
    fn lane_of_each(&self, vectors: &[L::V; D], i: usize) -> [f64; D] {
        let mut numbers = [0.0; D];
        each_component!(D, c => { numbers[c] = self.lane(vectors[c], i); });
        numbers
    }

    #[inline(always)]
    fn lane(&self, v: L::V, i: usize) -> f64 {
        self.lanes.array(v).as_ref()[i]
    }
}
