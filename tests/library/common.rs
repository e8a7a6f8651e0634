//! What the tests of the equations and of the march share.

use std::fs;
use std::path::Path;

use crossfibre::corrected::Corrected;
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::{Number, Vector};
use crossfibre::outcome::Outcome;
use crossfibre::paper::{Paper, Printed};
use crossfibre::place::Place;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::{Scene, Strain};
use crossfibre::scene_file;
use crossfibre::state::{FibreState, State, Wavefront};
use crossfibre::trace::{Event, Sink, Traced, Value};
use proptest::test_runner::Config as ProptestConfig;

// ---------------------------------------------------------------- numbers

/// A number that `S` holds exactly, so that an expected value owes nothing to the inputs' rounding.
pub fn exact<S: Number>(x: f64) -> S {
    let number = S::from_f64(x);
    assert_eq!(number.to_f64(), x, "{x} is rounded");
    number
}

/// A vector of such numbers.
pub fn exact_vector<S: Number, const D: usize>(v: [f64; D]) -> Vector<S, D> {
    Vector::from(v.map(exact::<S>))
}

/// Spacing of the numbers of `S` around `x`.
pub fn ulp<S: Number>(x: f64) -> f64 {
    let digits = if S::from_f64(1.0 + f64::EPSILON) == S::one() {
        f32::MANTISSA_DIGITS
    } else {
        f64::MANTISSA_DIGITS
    };
    let exponent = (x.abs().to_bits() >> 52) as i32 - 1023;
    2_f64.powi(exponent + 1 - digits as i32)
}

/// Asserts that a number lies within so many units in the last place (of `S`) of what was worked
/// out by hand. Each rounding of an expression costs up to half a unit, and the literal of the
/// expected value another half.
#[track_caller]
pub fn assert_ulps<S: Number>(got: S, expected: f64, units: f64) {
    let apart = (got.to_f64() - expected).abs() / ulp::<S>(expected);
    assert!(
        apart <= units,
        "got {got}, expected {expected}: {apart:.2} ULP apart, allowed {units}"
    );
}

/// Asserts that a number is nowhere near another: apart by a good part of its size.
#[track_caller]
pub fn assert_far<S: Number>(got: S, other: f64) {
    let (got, size) = (got.to_f64(), other.abs());
    assert!((got - other).abs() > 0.05 * size, "{got} is as good as {other}");
}

/// So many random cases; a failing one is printed, and kept by writing a test of it.
pub fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

// ---------------------------------------------------------------- scenes

/// A scene of `verification/scenes` as its file has it.
pub fn shipped(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("verification/scenes");
    let text = fs::read_to_string(folder.join(name).with_extension("json")).unwrap();
    scene_file::read(&text).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

/// The scenes that between them run every equation of a step, cut short: a single fibre, crossed
/// fibres, both at the impact point, a projectile that slows, nothing special, sliding, two with
/// engineering strain, and as printed.
pub fn short_scenes() -> Vec<(String, Scene)> {
    let cut = |name: &str, duration: f64, strain: Strain| {
        let scene = Scene { duration, strain, ..shipped(name) };
        scene.check().unwrap();
        (format!("{name}, {strain:?}"), scene)
    };
    use Strain::{Engineering, Incremental};
    // (8) as printed divides by the time since impact: nothing else sees `t`.
    let (name, printed) = cut("finite-projectile", 23.3e-6, Incremental);
    let printed = (format!("{name}, as printed"), with_corrections(&printed, Corrections::NONE));
    vec![
        cut("single-400", 17.3e-6, Incremental),
        cut("fig3", 19.1e-6, Incremental),
        cut("fig3-printed", 19.1e-6, Incremental),
        cut("both-at-origin", 12.7e-6, Incremental),
        cut("finite-projectile", 61.7e-6, Incremental), // past the reflection from the clamp
        cut("unequal", 31.3e-6, Incremental),
        cut("sliding", 23.9e-6, Incremental), // the node moves at 21.9 µs for the first time
        cut("unequal", 29.3e-6, Engineering),
        cut("single-400", 15.1e-6, Engineering),
        printed,
    ]
}

/// The scene with other corrections.
pub fn with_corrections(scene: &Scene, corrections: Corrections) -> Scene {
    Scene { corrections, ..scene.clone() }
}

/// Steps that a scene asks for.
pub fn steps(scene: &Scene) -> u64 {
    crossfibre::plan::Plan::of(scene).steps
}

// ---------------------------------------------------------------- runs

/// Runs a scene without a tracer, in any number type; `watch` sees every step.
pub fn run<S: Number>(
    scene: &Scene,
    wavefront: Wavefront,
    watch: impl FnMut(&State<S>),
) -> (State<S>, Outcome) {
    struct Run<'a, F>(&'a Scene, Wavefront, F);
    impl<S: Number, F: FnMut(&State<S>)> WithPaper<S> for Run<'_, F> {
        type Out = (State<S>, Outcome);
        fn with(self, paper: &impl Paper<S>) -> Self::Out {
            let mut state = State::at_impact(self.0, self.1);
            let outcome = march::run(paper, &mut state, steps(self.0), self.2);
            (state, outcome)
        }
    }
    with_paper(scene, Run(scene, wavefront, watch))
}

/// An event, kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    pub place: Place,
    pub equation: u8,
    pub inputs: Vec<(&'static str, Vec<f64>)>,
    pub output: Vec<f64>,
}

fn kept(value: &Value<'_, f64>) -> Vec<f64> {
    match *value {
        Value::Scalar(x) => vec![x],
        Value::Vector(v) => v.to_vec(),
    }
}

/// Keeps every event.
#[derive(Default)]
pub struct Recorder(pub Vec<Seen>);

impl Sink<f64> for Recorder {
    fn event(&mut self, event: &Event<'_, f64>) {
        self.0.push(Seen {
            place: event.place,
            equation: event.equation,
            inputs: event.inputs.iter().map(|(n, v)| (*n, kept(v))).collect(),
            output: kept(&event.output),
        });
    }
}

/// Runs a scene with a tracer.
pub fn trace(scene: &Scene) -> (State<f64>, Outcome, Vec<Seen>) {
    struct Run<'a>(&'a Scene);
    impl WithPaper<f64> for Run<'_> {
        type Out = (State<f64>, Outcome, Vec<Seen>);
        fn with(self, paper: &impl Paper<f64>) -> Self::Out {
            let traced = Traced::new(paper, Recorder::default());
            let mut state = State::at_impact(self.0, Wavefront::Flagged);
            let outcome = march::run(&traced, &mut state, steps(self.0), |_| ());
            (state, outcome, traced.into_sink().0)
        }
    }
    with_paper(scene, Run(scene))
}

/// Of each element, m.
pub fn lengths<const D: usize>(fibre: &FibreState<f64, D>) -> Vec<f64> {
    fibre.position.windows(2).map(|ends| (ends[1] - ends[0]).norm()).collect()
}

/// Every number of a state that the physics shows, to the bit: not how much work it took.
pub fn bits(state: &State<f64>) -> Vec<u64> {
    fn fibre<const D: usize>(fibre: &FibreState<f64, D>) -> impl Iterator<Item = f64> + '_ {
        let vectors = [&fibre.position, &fibre.velocity, &fibre.pull];
        let scalars = [&fibre.strain, &fibre.tension, &fibre.unstrained];
        vectors
            .into_iter()
            .flat_map(|all| all.iter().flat_map(|v| v.iter().copied()))
            .chain(scalars.into_iter().flatten().copied())
    }
    let accounts = &state.accounts;
    let mut numbers: Vec<f64> = fibre(&state.primary).collect();
    numbers.extend([
        state.time_step,
        state.projectile.velocity,
        accounts.drive_impulse,
        accounts.clamp_impulse,
        accounts.drive_work,
    ]);
    let mut bits = vec![state.step];
    if let Some(crossover) = &state.crossover {
        numbers.extend(fibre(&crossover.fibre));
        bits.extend([crossover.node as u64, crossover.moves]);
    }
    bits.extend(numbers.into_iter().map(f64::to_bits));
    bits
}

// ---------------------------------------------------------------- every equation of an edition

/// The random numbers that all twenty equations are fed with: `[0]` to `[15]`.
pub type Inputs = [f64; 16];

/// Evaluates all twenty equations of an edition, in both dimensions where they are vectors: their
/// outputs in the order of the page, to the bit.
pub fn evaluate(paper: &impl Paper<f64>, r: &Inputs) -> Vec<(u8, Vec<u64>)> {
    use crossfibre::paper::{
        Cosines, CrossoverPush, Direction, Lengths, ProjectilePush, Remembered, StressByLaw,
    };
    let two = |i: usize| Vector::<f64, 2>::new(r[i], r[i + 1]);
    let three = |i: usize| Vector::<f64, 3>::new(r[i], r[i + 1], r[i + 2]);
    let (theta, secondary, primary) = (
        Direction { cos: r[2], sin: r[3] },
        Cosines { x: r[4], y: r[5] },
        Cosines { x: r[6], y: r[7] },
    );
    let lengths = Lengths { now: r[1], previous: r[2], unstrained: r[3] };
    let projectile = ProjectilePush {
        velocity: r[0],
        tension_y: r[1],
        mass: r[2],
        node_mass: r[3],
        time_step: r[4],
        time: r[5],
    };
    let push = CrossoverPush {
        a: r[1],
        slide_factor: r[2],
        perpendicular: r[3],
        parallel: r[4],
        primary,
        change: two(8),
        mass: r[10],
        secondary_mass: r[11],
    };
    let memory = Remembered { of_all: &r[4..10], each: 2, element: 1 };
    let by_law = StressByLaw { stress: r[3], strain_before: r[4], strain: r[5], memory };
    let direction = paper.eqn_11_direction(two(0), two(2));
    let outputs = [
        [
            paper.eqn_1_impulse_residual(two(0), two(2), r[4], two(5), two(7)).as_slice(),
            paper.eqn_1_impulse_residual(three(0), three(3), r[6], three(7), three(10)).as_slice(),
        ]
        .concat(),
        [
            paper.eqn_2_velocity(two(0), r[2], two(3), two(5)).as_slice(),
            paper.eqn_2_velocity(three(0), r[3], three(4), three(7)).as_slice(),
        ]
        .concat(),
        vec![paper.eqn_3_strain_increment(r[0], r[1])],
        vec![paper.eqn_4_strain(r[0], lengths)],
        vec![
            paper.eqn_5_previous_length(two(0), two(2)),
            paper.eqn_5_previous_length(three(0), three(3)),
        ],
        vec![
            paper.eqn_6_length(two(0), two(2), two(4), two(6), r[8]),
            paper.eqn_6_length(three(0), three(3), three(6), three(9), r[12]),
        ],
        vec![paper.eqn_7_tension(r[0], r[1]), paper.eqn_7_tension_by_law(r[2], by_law)],
        vec![paper.eqn_8_projectile_velocity(projectile)],
        vec![paper.eqn_9_parallel_velocity(r[0], r[1], theta)],
        vec![paper.eqn_10_perpendicular_velocity(r[0], r[1], theta)],
        vec![direction.cos, direction.sin],
        vec![paper.eqn_12_secondary_u(r[0], r[1], r[4], theta)],
        vec![paper.eqn_13_secondary_v(r[0], r[1], r[4], theta)],
        vec![paper.eqn_14_secondary_w()],
        vec![paper.eqn_15_parallel_tension(r[0], secondary, primary)],
        vec![paper.eqn_16_perpendicular_tension(r[0], secondary, primary)],
        vec![paper.eqn_17_u_at_crossover(r[0], push)],
        vec![paper.eqn_18_v_at_crossover(r[0], push)],
        vec![paper.eqn_19_acceleration(r[0], r[1])],
        vec![paper.eqn_20_courant(r[0], r[1], r[2])],
    ];
    (1..)
        .zip(outputs)
        .map(|(number, output)| (number, output.into_iter().map(f64::to_bits).collect()))
        .collect()
}

/// The printed page and the edition of a scene's corrections, as `evaluate` takes them.
pub fn evaluate_printed(r: &Inputs) -> Vec<(u8, Vec<u64>)> {
    evaluate(&Printed, r)
}

/// The same for an edition of the paper.
pub fn evaluate_corrected(corrections: Corrections, r: &Inputs) -> Vec<(u8, Vec<u64>)> {
    evaluate(&Corrected::<crossfibre::corrected::Incremental>::new(corrections), r)
}
