//! A scene that is being marched.

use std::fmt;

use crossfibre::errata::Corrections;
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Scene, Strain};

use crate::lanes::Portable;
#[cfg(target_arch = "x86_64")]
use crate::lanes::{Avx2, Avx512};
use crate::literal;
use crate::march::{Constants, Ended, March, TOGETHER};
use crate::mesh::Mesh;
use crate::state::State;

/// Why a scene, or a state of it, is not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

impl fmt::Display for Unsupported {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{}", self.0)
    }
}

impl std::error::Error for Unsupported {}

/// The vectors that a march is made in. All give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vectors {
    /// Eight doubles, AVX-512F.
    Avx512,
    /// Four doubles, AVX2 and FMA.
    Avx2,
    /// What the compiler makes of arrays of four.
    Portable,
}

impl Vectors {
    /// All, the widest first.
    pub const ALL: [Self; 3] = [Self::Avx512, Self::Avx2, Self::Portable];
}

/// A march in vectors of some kind.
enum AnyMarch {
    #[cfg(target_arch = "x86_64")]
    Avx512(March<Avx512>),
    #[cfg(target_arch = "x86_64")]
    Avx2(March<Avx2>),
    Portable(March<Portable>),
}

/// Does the same with a march of any kind.
macro_rules! with_march {
    ($any:expr, $march:ident => $do:expr) => {
        match $any {
            #[cfg(target_arch = "x86_64")]
            AnyMarch::Avx512($march) => $do,
            #[cfg(target_arch = "x86_64")]
            AnyMarch::Avx2($march) => $do,
            AnyMarch::Portable($march) => $do,
        }
    };
}

impl AnyMarch {
    /// If the processor has such vectors.
    fn of(vectors: Vectors, constants: &Constants, state: &State) -> Option<Self> {
        match vectors {
            #[cfg(target_arch = "x86_64")]
            Vectors::Avx512 => {
                Avx512::detect().map(|v| Self::Avx512(March::of(v, constants, state)))
            }
            #[cfg(target_arch = "x86_64")]
            Vectors::Avx2 => Avx2::detect().map(|v| Self::Avx2(March::of(v, constants, state))),
            #[cfg(not(target_arch = "x86_64"))]
            Vectors::Avx512 | Vectors::Avx2 => None,
            Vectors::Portable => Some(Self::Portable(March::of(Portable, constants, state))),
        }
    }
}

/// A scene that is being marched.
pub struct Engine {
    constants: Constants,
    /// Where it began, and what a run that fails is taken up from again.
    start: State,
    march: AnyMarch,
    outcome: Outcome,
}

impl Engine {
    /// The scene, which has passed [`Scene::check`], at impact, in the widest vectors there are.
    pub fn new(scene: &Scene) -> Result<Self, Unsupported> {
        supports(scene)?;
        Self::at_impact(scene, &Vectors::ALL)
    }

    /// The scene after some steps.
    pub fn from_state(scene: &Scene, state: State) -> Result<Self, Unsupported> {
        Self::from_state_in(scene, state, &Vectors::ALL)
    }

    /// The scene at impact, in certain vectors.
    pub fn new_in(scene: &Scene, vectors: Vectors) -> Result<Self, Unsupported> {
        supports(scene)?;
        Self::at_impact(scene, &[vectors])
    }

    fn at_impact(scene: &Scene, vectors: &[Vectors]) -> Result<Self, Unsupported> {
        let constants = constants(scene);
        Self::begin(constants, State::at_impact(scene, &constants.mesh), vectors)
    }

    /// The scene after some steps, in the first of these vectors that there are.
    pub fn from_state_in(
        scene: &Scene,
        state: State,
        vectors: &[Vectors],
    ) -> Result<Self, Unsupported> {
        supports(scene)?;
        let constants = constants(scene);
        let mesh = &constants.mesh;
        let fits = state.primary.has(mesh.primary.elements)
            && match (&mesh.secondary, &state.secondary, state.crossover) {
                (Some((fibre, _)), Some(secondary), Some(crossover)) => {
                    secondary.has(fibre.elements) && crossover.node < mesh.primary.elements
                }
                (None, None, None) => true,
                _ => false,
            };
        if !fits {
            return Err(Unsupported("the state is not one of the scene's discretisation".into()));
        }
        Self::begin(constants, state, vectors)
    }

    fn begin(constants: Constants, start: State, vectors: &[Vectors]) -> Result<Self, Unsupported> {
        let march = vectors.iter().find_map(|&v| AnyMarch::of(v, &constants, &start));
        let march = march.ok_or_else(|| Unsupported(format!("no vectors {vectors:?} here")))?;
        Ok(Self { constants, start, march, outcome: Outcome::Completed })
    }

    /// Makes so many more steps, or until the run ends by itself: it does not go on then. A run that
    /// diverges is left at its last whole step.
    pub fn run(&mut self, steps: u64) -> Outcome {
        if !self.outcome.is_completed() {
            return self.outcome.clone();
        }
        let ended = with_march!(&mut self.march, march => march.run(steps));
        self.outcome = match ended {
            Ended::Made => Outcome::Completed,
            Ended::Left(end) => Outcome::CrossoverLeft { step: self.step(), end },
            Ended::NotFinite => self.find_divergence(),
        };
        self.outcome.clone()
    }

    /// Takes the march up again from where it began, goes to the last whole step and names what was
    /// not finite in the next.
    #[cold]
    fn find_divergence(&mut self) -> Outcome {
        let made = self.step() - self.start.step;
        if let Some(march) = AnyMarch::of(self.vectors(), &self.constants, &self.start) {
            self.march = march;
        }
        // It was one of the last steps.
        with_march!(&mut self.march, march => march.run(made.saturating_sub(TOGETHER)));
        for _ in 0..TOGETHER {
            if let Some(outcome) = literal::divergence(&self.constants, &self.state()) {
                return outcome;
            }
            with_march!(&mut self.march, march => march.run(1));
        }
        unreachable!("a number of the step was found not to be finite")
    }

    /// Visits all elements from now on, also those ahead of the wavefront: the bits are the same, and
    /// the time of a step no longer depends on the motion.
    pub fn visit_all(&mut self) {
        with_march!(&mut self.march, march => march.visit_all());
    }

    /// The kind of vectors that it marches in.
    pub fn vectors(&self) -> Vectors {
        match self.march {
            #[cfg(target_arch = "x86_64")]
            AnyMarch::Avx512(_) => Vectors::Avx512,
            #[cfg(target_arch = "x86_64")]
            AnyMarch::Avx2(_) => Vectors::Avx2,
            AnyMarch::Portable(_) => Vectors::Portable,
        }
    }

    /// How the run has ended; completed, if it can go on.
    pub fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    /// Steps made since impact.
    pub fn step(&self) -> u64 {
        with_march!(&self.march, march => march.step())
    }

    /// The number of steps of the scene: duration/Δt, rounded.
    pub fn planned_steps(&self) -> u64 {
        self.constants.mesh.steps
    }

    /// Δt, s.
    pub fn time_step(&self) -> f64 {
        self.constants.mesh.time_step
    }

    /// Elements visited, summed over the steps and the fibres.
    pub fn element_steps(&self) -> u64 {
        with_march!(&self.march, march => march.element_steps())
    }

    /// All numbers of now, in the order of a result.
    pub fn state(&self) -> State {
        let mut state = self.start.clone();
        with_march!(&self.march, march => march.write(&mut state));
        state
    }
}

impl fmt::Debug for Engine {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Engine {{ {:?}, step {}, {} }}", self.vectors(), self.step(), self.outcome)
    }
}

/// What a march needs to know of the scene.
pub(crate) fn constants(scene: &Scene) -> Constants {
    Constants {
        mesh: Mesh::of(scene),
        engineering: scene.strain == Strain::Engineering,
        slide_factor: scene.secondary.as_ref().map_or(1.0, |s| s.slide_factor),
        projectile_mass: scene.projectile.mass,
    }
}

/// Whether a scene can be run here; if not, why.
pub fn supports(scene: &Scene) -> Result<(), Unsupported> {
    if scene.corrections != Corrections::ALL {
        return Err(Unsupported("the edition with all corrections only".into()));
    }
    match scene.materials().find(|material| !material.is_of_the_page()) {
        Some(material) => Err(Unsupported(format!(
            "eqn (7) only, no material by the law `{}` or with additions to it",
            material.law.name()
        ))),
        None => Ok(()),
    }
}
