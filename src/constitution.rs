//! A fibre of another law than (7): what its elements remember, and what the law makes of a step.

use std::sync::Arc;

use crate::discretisation::Properties;
use crate::material::{Law, Mesh, ParameterError, of_scene};
use crate::number::Number;
use crate::paper::{Paper, Printed, Remembered};
use crate::scene::Material;

/// The law of a fibre and what its elements remember for it.
#[derive(Clone, Debug)]
pub struct Constitution<S> {
    /// The law, for steps of the scene's Δt.
    pub law: Arc<dyn Law<S>>,
    /// [`Law::memory`] numbers for each element.
    pub memory: Vec<S>,
    /// That many.
    each: usize,
    /// Cross-section, m².
    pub area: S,
    /// Energy along the path that (4) takes.
    pub path: PathEnergy<S>,
    /// What the step bears; none where the law cannot outgrow it.
    bound: Option<Bound<S>>,
    /// Of the block of elements that is being worked on.
    pub block: Block<S>,
}

/// Work on the elements since impact, J.
///
/// The strain of (4) depends on the path, and so no function of it is the energy of a law. The work
/// of a step is T ΔL with ΔL = L^{t−1} Δε, T being the mean of before and after; what the law does
/// not dissipate of it is stored.
#[derive(Clone, Copy, Debug)]
pub struct PathEnergy<S> {
    /// Stored.
    pub stored: S,
    /// Dissipated.
    pub dissipated: S,
}

/// The modulus that a step bears.
#[derive(Clone, Copy, Debug)]
struct Bound<S> {
    /// ρΔx²/Δt², Pa: a local Courant number of 1.
    at_one: S,
    /// The same, or that of the fibre at rest where this is greater: a Courant number above 1 that
    /// a scene asks for is worth showing. A billionth more than that: in 10⁴ steps the highest mode
    /// then grows by exp(10⁴ × 2√1e-9) < 2, and rounding of the strain at rest stays below.
    most: S,
}

/// Numbers of a block of elements that only a step needs, an element each.
#[derive(Clone, Debug)]
pub struct Block<S> {
    /// `ε_i^{t−1}`.
    pub strain_before: Vec<S>,
    /// `L_i^t`, m.
    pub length: Vec<S>,
    /// `L_i^{t−1}`, m.
    pub previous_length: Vec<S>,
    /// σ, Pa.
    pub stress: Vec<S>,
    dissipated: Vec<S>,
    modulus: Vec<S>,
}

impl<S: Number> Block<S> {
    fn of(elements: usize) -> Self {
        let numbers = || vec![S::zero(); elements];
        Self {
            strain_before: numbers(),
            length: numbers(),
            previous_length: numbers(),
            stress: numbers(),
            dissipated: numbers(),
            modulus: numbers(),
        }
    }

    /// Makes room for a block that is longer than the march's own.
    pub fn fit(&mut self, elements: usize) {
        if self.stress.len() < elements {
            *self = Self::of(elements);
        }
    }
}

/// How a law breaks the bounds of the scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Breach {
    /// The local Courant number, above 1.
    Courant(f64),
    /// The strain at which the modulus is negative.
    NoWaves(f64),
}

impl<S: Number> Constitution<S> {
    /// At rest. None for eqn (7).
    pub fn of(
        material: &Material,
        density: f64,
        fibre: &Properties<S>,
        time_step: S,
    ) -> Result<Option<Self>, ParameterError> {
        let mesh = Mesh { density, spacing: fibre.spacing.to_f64() };
        let law = of_scene(material, mesh, time_step)?;
        Ok(law.map(|law| {
            let memory = vec![S::zero(); law.memory() * fibre.elements];
            let nothing = S::zero();
            let bound = law.can_outgrow_the_step().then(|| {
                let spacing_per_step = fibre.spacing / time_step;
                let at_one = S::from_f64(density) * spacing_per_step * spacing_per_step;
                let at_rest = law.step_modulus(nothing, nothing, &memory[..law.memory()]);
                let most = at_one.max(at_rest) * (S::one() + S::from_f64(1e-9));
                Bound { at_one, most }
            });
            Self {
                each: law.memory(),
                memory,
                area: fibre.area,
                path: PathEnergy { stored: nothing, dissipated: nothing },
                bound,
                block: Block::of(fibre.elements.min(<Printed as Paper<S>>::BLOCK_BY_LAW)),
                law,
            }
        }))
    }

    /// The same without a bound: what comes of a wave speed that outgrows the step is then seen.
    #[must_use]
    pub fn unbounded(self) -> Self {
        Self { bound: None, ..self }
    }

    /// Stresses of a block of elements from their strains; the elements' memory moves on.
    pub(crate) fn stresses(&mut self, first: usize, strain: &[S]) {
        let (count, n) = (strain.len(), self.each);
        let memory = &mut self.memory[first * n..][..count * n];
        let (before, stress) =
            (&self.block.strain_before[..count], &mut self.block.stress[..count]);
        self.law.stresses(before, strain, memory, stress);
    }

    /// As [`Self::stresses`], and books the energies along the path of (4). `tension` is that of
    /// before.
    pub(crate) fn stresses_along_path(&mut self, first: usize, strain: &[S], tension: &[S]) {
        let (count, n) = (strain.len(), self.each);
        if n > 0 {
            let memory = &self.memory[first * n..][..count * n];
            self.law.dissipations(memory, &mut self.block.dissipated[..count]);
        }
        self.stresses(first, strain);
        let block = &mut self.block;
        let before = &block.strain_before[..count];
        let (length, stress) = (&block.previous_length[..count], &block.stress[..count]);
        let mut worked = S::zero();
        for i in 0..count {
            let longer = length[i] * (strain[i] - before[i]);
            worked += (tension[i] + self.area * stress[i]) * longer;
        }
        let mut lost = S::zero();
        if n > 0 {
            let memory = &self.memory[first * n..][..count * n];
            let (dissipated, now) = (&block.dissipated[..count], &mut block.modulus[..count]);
            self.law.dissipations(memory, now);
            for i in 0..count {
                lost += length[i] * (now[i] - dissipated[i]);
            }
            lost *= self.area;
        }
        self.path.stored += S::half() * worked - lost;
        self.path.dissipated += lost;
    }

    /// What an element remembers.
    #[inline(always)]
    pub fn remembered(&self, element: usize) -> Remembered<'_, S> {
        Remembered { of_all: &self.memory, each: self.each, element }
    }

    /// The first element of a block where the law breaks the bounds of the scheme, counted from the
    /// block's first. `per_stretch` is d(strain)/d(stretch) of an element.
    pub fn breach(
        &mut self,
        first: usize,
        strain: &[S],
        per_stretch: impl Fn(&Block<S>, usize) -> S,
    ) -> Option<(usize, Breach)> {
        let bound = self.bound?;
        let (count, n) = (strain.len(), self.each);
        let memory = &self.memory[first * n..][..count * n];
        let before = &self.block.strain_before[..count];
        self.law.step_moduli(before, strain, memory, &mut self.block.modulus[..count]);
        (0..count).find_map(|i| {
            let modulus = self.block.modulus[i] * per_stretch(&self.block, i);
            if modulus < S::zero() {
                Some((i, Breach::NoWaves(strain[i].to_f64())))
            } else if modulus > bound.most {
                Some((i, Breach::Courant((modulus / bound.at_one).sqrt().to_f64())))
            } else {
                None
            }
        })
    }

    /// Stored and dissipated energy, J, where no path of (4) has to be followed.
    pub(crate) fn energies(&self, strain: &[S], unstrained: &[S]) -> PathEnergy<S> {
        let mut sum = PathEnergy { stored: S::zero(), dissipated: S::zero() };
        for (i, (&strain, &length)) in strain.iter().zip(unstrained).enumerate() {
            let memory = self.remembered(i).numbers();
            sum.stored += self.law.stored(strain, memory) * length;
            sum.dissipated += self.law.dissipated(memory) * length;
        }
        PathEnergy { stored: self.area * sum.stored, dissipated: self.area * sum.dissipated }
    }
}
