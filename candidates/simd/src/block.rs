//! A block of a fibre, and the stages of its step: nodes move, squares of lengths, roots, strains,
//! tensions; eqns (2), (6), (4) and (7).

use crate::lanes::Lanes;
use crate::state::magnitude;

/// Does the same for each component of vectors of two or three.
///
/// A loop would do; but until the compiler has unrolled it, arrays that it indexes are kept in memory,
/// and later stay there.
macro_rules! each_component {
    ($dimension:expr, $c:ident => $do:block) => {{
        #[allow(non_upper_case_globals)]
        const $c: usize = 0;
        $do
    }
    {
        #[allow(non_upper_case_globals)]
        const $c: usize = 1;
        $do
    }
    if $dimension == 3 {
        #[allow(non_upper_case_globals)]
        const $c: usize = 2;
        $do
    }};
}
pub(crate) use each_component;

/// As many elements as a vector has lanes. The nodes of a block are those *ahead* of its elements: a
/// lane holds element `e` and node `e + 1`.
#[derive(Clone, Copy)]
pub(crate) struct Block<L: Lanes, const D: usize> {
    /// `x`, m.
    pub position: [L::V; D],
    /// `v`, m/s.
    pub velocity: [L::V; D],
    /// `T` as a vector along the element, N.
    pub pull: [L::V; D],
    /// `ε`
    pub strain: L::V,
    /// What the length is divided by: of (4) `L^{t−1}`, of engineering strain `L⁰`, m.
    pub base: L::V,
    /// Its reciprocal, as [`Lanes::divide`] wants it.
    pub base_reciprocal: L::V,
}

/// Numbers that all blocks of a step need.
#[derive(Clone, Copy)]
pub(crate) struct Constants<L: Lanes> {
    pub time_step: L::V,
    pub stiffness: L::V,
    pub one: L::V,
    /// Strains below are ordinary.
    pub most_strain: L::V,
}

/// A block whose nodes have moved, with its lengths.
#[derive(Clone, Copy)]
pub(crate) struct Rooted<L: Lanes, const D: usize> {
    /// From one end to the other, m.
    pub element: [L::V; D],
    /// m
    pub length: L::V,
}

/// A block with its new strains.
#[derive(Clone, Copy)]
pub(crate) struct Strained<L: Lanes, const D: usize> {
    pub rooted: Rooted<L, D>,
    /// Of the lengths.
    pub reciprocal: L::V,
    /// N
    pub tension: L::V,
}

impl<L: Lanes, const D: usize> Block<L, D> {
    /// (2) and the motion of the nodes. `pulls` are the tensions of the block and of the one ahead, at
    /// `t−1`; `adjust` may change what (2) gave.
    #[inline(always)]
    pub fn move_nodes(
        &mut self,
        lanes: L,
        constants: &Constants<L>,
        a: L::V,
        pulls: &[[L::V; D]; 2],
        adjust: impl FnOnce(&mut [L::V; D]),
    ) {
        // v_{i+1}^t = v_{i+1}^{t−1} + A (T_{i+1}^{t−1} − T_i^{t−1})
        let mut velocity = self.velocity;
        each_component!(D, c => {
            let tension_ahead = lanes.one_ahead(pulls[0][c], pulls[1][c]);
            let change = lanes.mul(lanes.sub(tension_ahead, pulls[0][c]), a);
            velocity[c] = lanes.add(velocity[c], change);
        });
        adjust(&mut velocity);
        self.velocity = velocity;
        each_component!(D, c => {
            let way = lanes.mul(velocity[c], constants.time_step);
            self.position[c] = lanes.add(self.position[c], way);
        });
    }

    /// (4), or L/L⁰ − 1, and (7). None, and nothing done, where [`Lanes::divide`] does not apply.
    #[inline(always)]
    pub fn strain<const ENGINEERING: bool>(
        &mut self,
        lanes: L,
        constants: &Constants<L>,
        rooted: &Rooted<L, D>,
    ) -> Option<Strained<L, D>> {
        let length = rooted.length;
        let reciprocal = lanes.reciprocal(length);
        let ratio = lanes.divide(length, self.base, self.base_reciprocal);
        let strain = if ENGINEERING {
            lanes.sub(ratio, constants.one)
        } else {
            lanes.sub(lanes.add(self.strain, ratio), constants.one)
        };
        if !lanes.is_ordinary(length, strain, constants.most_strain) {
            return None;
        }
        self.strain = strain;
        if !ENGINEERING {
            (self.base, self.base_reciprocal) = (length, reciprocal);
        }
        let tension = lanes.mul(constants.stiffness, strain);
        Some(Strained { rooted: *rooted, reciprocal, tension })
    }
}

/// From one end of the elements to the other. `behind` are the positions of the block behind.
#[inline(always)]
fn element<L: Lanes, const D: usize>(
    lanes: L,
    position: &[L::V; D],
    behind: &[L::V; D],
) -> [L::V; D] {
    let mut element = *position;
    each_component!(D, c => {
        element[c] = lanes.sub(element[c], lanes.one_before(behind[c], element[c]));
    });
    element
}

impl<L: Lanes, const D: usize> Rooted<L, D> {
    /// (6), which is (5) of the next step: the positions that (6) forms are those that are stored.
    #[inline(always)]
    pub fn of(lanes: L, position: &[L::V; D], behind: &[L::V; D]) -> Self {
        let element = element(lanes, position, behind);
        let mut square =
            lanes.add(lanes.mul(element[0], element[0]), lanes.mul(element[1], element[1]));
        if D == 3 {
            square = lanes.add(square, lanes.mul(element[2], element[2]));
        }
        Self { element, length: lanes.root(square) }
    }
}

impl<L: Lanes, const D: usize> Strained<L, D> {
    /// "The tension has the same direction as the element itself."
    #[inline(always)]
    pub fn pull(&self, lanes: L) -> [L::V; D] {
        let pull_per_length = lanes.divide(self.tension, self.rooted.length, self.reciprocal);
        let mut pull = self.rooted.element;
        each_component!(D, c => {
            pull[c] = lanes.mul(pull[c], pull_per_length);
        });
        pull
    }
}

impl<L: Lanes, const D: usize> Block<L, D> {
    /// As [`Block::strain`], where multiplication will not do.
    #[cold]
    #[inline(never)]
    pub fn strain_by_the_divider<const ENGINEERING: bool>(&mut self, lanes: L, behind: &[L::V; D]) {
        let element = element(lanes, &self.position, behind).map(|x| lanes.array(x));
        let [mut strain, mut base] = [self.strain, self.base].map(|x| lanes.array(x));
        for i in 0..L::COUNT {
            let length = magnitude::<D>(std::array::from_fn(|c| element[c].as_ref()[i]));
            let ratio = length / base.as_ref()[i];
            let strain = &mut strain.as_mut()[i];
            *strain = if ENGINEERING { ratio - 1.0 } else { *strain + ratio - 1.0 };
            if !ENGINEERING {
                base.as_mut()[i] = length;
            }
        }
        self.strain = lanes.vector(strain);
        self.base = lanes.vector(base);
        self.base_reciprocal = lanes.reciprocal(self.base);
    }

    /// As [`Strained::pull`], where multiplication will not do. Whether all is finite.
    #[cold]
    #[inline(never)]
    pub fn pull_by_the_divider(
        &mut self,
        lanes: L,
        constants: &Constants<L>,
        behind: &[L::V; D],
    ) -> bool {
        let stiffness = lanes.array(constants.stiffness).as_ref()[0];
        let element = element(lanes, &self.position, behind).map(|x| lanes.array(x));
        let strain = lanes.array(self.strain);
        let mut pull = element;
        let mut finite = true;
        for i in 0..L::COUNT {
            let length = magnitude::<D>(std::array::from_fn(|c| element[c].as_ref()[i]));
            let pull_per_length = stiffness * strain.as_ref()[i] / length;
            pull.iter_mut().for_each(|x| x.as_mut()[i] *= pull_per_length);
            finite &= pull_per_length.is_finite();
        }
        self.pull = pull.map(|x| lanes.vector(x));
        finite
    }
}
