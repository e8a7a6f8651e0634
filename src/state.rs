//! What the march carries from one step to the next, and how a scene starts.

use crate::constitution::Constitution;
use crate::discretisation::{Discretisation, Properties};
use crate::number::{Number, Vector};
use crate::paper::magnitude;
use crate::scene::{Material, Scene};

/// One fibre: nodes `0..=n` from the impact point (the crossover) to the clamp, elements `0..n`.
#[derive(Clone, Debug)]
pub struct FibreState<S: Number, const D: usize> {
    /// `x_i`, m, a node each.
    pub position: Vec<Vector<S, D>>,
    /// `v_i`, m/s, a node each.
    pub velocity: Vec<Vector<S, D>>,
    /// `T_i` as a vector, N, an element each.
    pub pull: Vec<Vector<S, D>>,
    /// `ε_i`, an element each.
    pub strain: Vec<S>,
    /// `T_i` as a magnitude by (7), N, an element each.
    pub tension: Vec<S>,
    /// `L_i^0`: (5) of the unstrained fibre, m, an element each.
    pub unstrained: Vec<S>,
    /// Velocity of the clamped node: zero on the page.
    pub clamp_velocity: Vector<S, D>,
    /// Number of elements from the driven end that are visited; those beyond are at rest.
    pub visited: usize,
    /// Constants.
    pub properties: Properties<S>,
    /// The law, where it is another than (7).
    pub constitution: Option<Constitution<S>>,
}

/// The crossing fibre and where it crosses.
#[derive(Clone, Debug)]
pub struct Crossover<S: Number> {
    /// The secondary fibre.
    pub fibre: FibreState<S, 3>,
    /// `ix`: the nearest node of the primary.
    pub node: usize,
    /// `α_s`.
    pub slide_factor: S,
    /// How often `ix` has changed.
    pub moves: u64,
}

impl<S: Number> Crossover<S> {
    /// Whether both fibres are struck together, the paper's experiment.
    pub fn at_origin(&self) -> bool {
        self.node == 0
    }
}

/// The projectile.
#[derive(Clone, Copy, Debug)]
pub struct Projectile<S: Number> {
    /// Unit vector of its travel: y on the page.
    pub axis: Vector<S, 2>,
    /// `v_p`, m/s along the axis.
    pub velocity: S,
    /// `m_p`, kg; none for a velocity that stays constant.
    pub mass: Option<S>,
}

/// What crossed the boundary of the system since impact: both halves, along the axis of travel.
#[derive(Clone, Copy, Debug)]
pub struct Accounts<S> {
    /// Momentum at impact, kg m/s.
    pub initial_momentum: S,
    /// Energy at impact, J.
    pub initial_energy: S,
    /// Impulse of whatever keeps a massless projectile at constant velocity, N s.
    pub drive_impulse: S,
    /// Impulse of the clamps, N s.
    pub clamp_impulse: S,
    /// Work of the drive, J.
    pub drive_work: S,
    /// Work of the first node on the rest of the fibres, whatever moves it, J.
    pub fibre_work: S,
    /// The most that it has been, J.
    pub most_fibre_work: S,
}

/// Everything that one time step changes.
#[derive(Clone, Debug)]
pub struct State<S: Number> {
    /// Steps made.
    pub step: u64,
    /// Δt, s.
    pub time_step: S,
    /// The struck fibre.
    pub primary: FibreState<S, 2>,
    /// The crossing fibre, if there is one.
    pub crossover: Option<Crossover<S>>,
    /// The projectile.
    pub projectile: Projectile<S>,
    /// Impulse and work of the boundary.
    pub accounts: Accounts<S>,
    /// Work done since impact.
    pub work: Work,
}

/// How often the parts of a step were entered: deterministic, and enough to count every equation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Elements visited, both fibres.
    pub elements: u64,
    /// Of these, elements at a clamp, whose far node needs no (2).
    pub clamped: u64,
    /// Steps in which the primary felt the secondary, (15)–(18).
    pub pushes: u64,
    /// Steps in which the primary drove the secondary, (9)–(13).
    pub drives: u64,
    /// Steps in which the secondary was driven at all, (14).
    pub secondary: u64,
    /// Steps in which the projectile was slowed, (8).
    pub projectile: u64,
}

impl Work {
    /// One fibre is about to be marched.
    pub fn count<S: Number, const D: usize>(&mut self, fibre: &FibreState<S, D>) {
        self.elements += fibre.visited as u64;
        self.clamped += u64::from(fibre.visited == fibre.elements());
    }
}

impl<S: Number, const D: usize> FibreState<S, D> {
    /// The fibre at rest, unstrained, along a coordinate axis from `start`.
    fn at_rest(start: Vector<S, D>, axis: usize, fibre: &Properties<S>, visited: usize) -> Self {
        let position: Vec<_> = (0..=fibre.elements)
            .map(|i| {
                let mut x = start;
                x[axis] += fibre.node(i);
                x
            })
            .collect();
        let nothing = vec![S::zero(); fibre.elements];
        Self {
            unstrained: position.windows(2).map(|ends| magnitude(ends[1] - ends[0])).collect(),
            velocity: vec![Vector::zeros(); fibre.elements + 1],
            pull: vec![Vector::zeros(); fibre.elements],
            strain: nothing.clone(),
            tension: nothing,
            clamp_velocity: Vector::zeros(),
            visited,
            properties: *fibre,
            constitution: None,
            position,
        }
    }

    /// The fibre with its law.
    ///
    /// # Panics
    /// If the number type cannot hold a parameter of the law; a double can hold all of a scene that
    /// has been checked.
    fn made_of(self, material: &Material, density: f64, time_step: S) -> Self {
        let constitution = Constitution::of(material, density, &self.properties, time_step)
            .unwrap_or_else(|fault| panic!("{fault}"));
        Self { constitution, ..self }
    }

    /// Memory of the vectors above, bytes an element: position, velocity and pull; strain, tension
    /// and unstrained length.
    pub const BYTES_PER_ELEMENT: f64 = ((3 * D + 3) * size_of::<S>()) as f64;

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.strain.len()
    }
}

/// Whether the march visits the elements ahead of the wavefront.
///
/// The paper's flags end the length loop there. Both give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wavefront {
    /// Stop at the front, as the paper does.
    Flagged,
    /// Visit every element in every step.
    Ignored,
}

impl<S: Number> State<S> {
    /// The scene at the moment of impact: "initially, all velocities, tensions, and strains are set
    /// to zero".
    pub fn at_impact(scene: &Scene, wavefront: Wavefront) -> Self {
        let mesh = Discretisation::<S>::of(scene);
        let visited = |fibre: &Properties<S>| match wavefront {
            Wavefront::Flagged => 1,
            Wavefront::Ignored => fibre.elements,
        };
        let primary =
            FibreState::at_rest(Vector::zeros(), 0, &mesh.primary, visited(&mesh.primary)).made_of(
                &scene.primary.material,
                scene.primary.density,
                mesh.time_step,
            );
        let crossover =
            mesh.secondary.zip(scene.secondary.as_ref()).map(|(crossing, secondary)| {
                let start = Vector::<S, 3>::new(crossing.at, S::zero(), S::zero());
                let fibre = &crossing.fibre;
                Crossover {
                    fibre: FibreState::at_rest(start, 2, fibre, visited(fibre)).made_of(
                        &secondary.material,
                        secondary.density,
                        mesh.time_step,
                    ),
                    node: crossing.node,
                    slide_factor: crossing.slide_factor,
                    moves: 0,
                }
            });
        let projectile = Projectile {
            axis: Vector::<S, 2>::new(S::zero(), S::one()),
            velocity: S::from_f64(scene.projectile.velocity),
            mass: scene.projectile.mass.map(S::from_f64),
        };
        let nothing = S::zero();
        let mut state = Self {
            step: 0,
            time_step: mesh.time_step,
            primary,
            crossover,
            projectile,
            accounts: Accounts {
                initial_momentum: nothing,
                initial_energy: nothing,
                drive_impulse: nothing,
                clamp_impulse: nothing,
                drive_work: nothing,
                fibre_work: nothing,
                most_fibre_work: nothing,
            },
            work: Work::default(),
        };
        let moving = state.projectile_mass() + state.projectile_node_mass();
        let velocity = state.projectile.velocity;
        state.accounts.initial_momentum = moving * velocity;
        state.accounts.initial_energy = S::half() * moving * velocity * velocity;
        state
    }

    /// Time since impact, s.
    pub fn time(&self) -> S {
        S::from_f64(self.step as f64) * self.time_step
    }

    /// m_p, zero where the velocity is kept constant from outside.
    pub fn projectile_mass(&self) -> S {
        self.projectile.mass.unwrap_or_else(S::zero)
    }

    /// Mass lumped on the projectile's node: two half elements of each fibre that is struck.
    pub fn projectile_node_mass(&self) -> S {
        let secondary = match &self.crossover {
            Some(crossover) if crossover.at_origin() => crossover.fibre.properties.mass,
            _ => S::zero(),
        };
        self.primary.properties.mass + secondary
    }
}

impl<S: Number> Crossover<S> {
    /// The node of the primary nearest to the secondary's first node; the lowest of equals.
    ///
    /// Before the front reaches `ix` neither fibre has moved there. At α_s = 1 there is no slip, "no
    /// sliding when set to 1", and so no search.
    pub fn nearest_node(&self, primary: &FibreState<S, 2>) -> usize {
        if primary.visited < self.node || self.slide_factor == S::one() {
            return self.node;
        }
        let candidates = 1..=primary.elements();
        let first = (0, self.square_of_distance(primary, 0));
        let nearer = |nearest: (usize, S), node| {
            let square = self.square_of_distance(primary, node);
            if square < nearest.1 { (node, square) } else { nearest }
        };
        candidates.fold(first, nearer).0
    }

    /// Distance of the secondary's first node from `ix`, m (ledger `slip-drift`).
    pub fn distance(&self, primary: &FibreState<S, 2>) -> S {
        self.square_of_distance(primary, self.node).sqrt()
    }

    fn square_of_distance(&self, primary: &FibreState<S, 2>, node: usize) -> S {
        let (first, p) = (self.fibre.position[0], primary.position[node]);
        let apart = Vector::<S, 3>::new(p.x - first.x, p.y - first.y, -first.z);
        apart.dot(&apart)
    }
}
