//! The balance of energy and momentum, part by part, against sums over the nodes, elements and steps that a
//! march has really made.

use crossfibre::balance::Balance;
use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::errata::Corrections;
use crossfibre::march;
use crossfibre::number::Vector;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::scene::{Law, Scene, Strain};
use crossfibre::state::{State, Wavefront};

use crate::common::shipped;

/// Coarse and long enough for waves to come back from every clamp and for kinks to reach them.
const STEPS: u64 = 600;

/// One fibre; unequal fibres; a sliding crossover; both struck, at the impact point; a projectile with a mass
/// and one without.
fn scenes() -> Vec<(&'static str, Scene)> {
    let coarse = |name, mass, slide_factor| {
        let mut scene = shipped(name);
        scene.primary.elements = 23;
        if let Some(secondary) = &mut scene.secondary {
            secondary.elements = 17;
            secondary.slide_factor = slide_factor;
        }
        scene.courant = 0.937;
        scene.corrections = Corrections::ALL;
        scene.projectile.mass = mass;
        scene.check().unwrap();
        (name, scene)
    };
    vec![
        coarse("single-400", None, 1.0),
        coarse("finite-projectile", Some(0.0013), 1.0),
        coarse("unequal", None, 1.0),
        coarse("unequal", Some(0.0017), 0.73),
        coarse("both-at-origin", None, 1.0),
        coarse("both-at-origin", Some(0.0019), 1.0),
        coarse("sliding", None, 0.41),
        beside_the_impact_point(coarse("unequal", Some(0.0017), 0.93)),
    ]
}

/// The crossover at the first node beside the projectile's.
fn beside_the_impact_point((name, mut scene): (&'static str, Scene)) -> (&'static str, Scene) {
    let spacing = scene.primary.length / scene.primary.elements as f64;
    scene.secondary.as_mut().unwrap().at = spacing;
    scene.check().unwrap();
    (name, scene)
}

/// Masses and velocities of the whole system: of two halves of the primary, of two arms or four.
fn moving(scene: &Scene, state: &State<f64>) -> Vec<(f64, Vector<f64, 3>)> {
    let fibre = &scene.primary;
    let lump = fibre.density * fibre.area * fibre.length / fibre.elements as f64;
    let velocities = &state.primary.velocity;
    let mut all: Vec<_> =
        velocities[1..fibre.elements].iter().map(|v| (2.0 * lump, v.push(0.0))).collect();
    let mut first = lump;
    if let (Some(fibre), Some(crossover)) = (&scene.secondary, &state.crossover) {
        let lump = fibre.density * fibre.area * fibre.length / fibre.elements as f64;
        let velocities = &crossover.fibre.velocity;
        let arms = arms(scene);
        all.extend(velocities[1..fibre.elements].iter().map(|v| (arms * lump, *v)));
        if fibre.at == 0.0 {
            first += lump;
        } else {
            all.push((arms * lump / 2.0, velocities[0]));
        }
    }
    all.push((first, velocities[0].push(0.0)));
    all
}

fn arms(scene: &Scene) -> f64 {
    if scene.secondary.as_ref().is_some_and(|secondary| secondary.at == 0.0) { 2.0 } else { 4.0 }
}

/// Energy of a linear law, J: ½Eε² per volume for engineering strain, E[(ε − 1) exp ε + 1] for its logarithm.
fn stored(scene: &Scene, state: &State<f64>) -> f64 {
    let density = |e: f64| match scene.strain {
        Strain::Engineering => e * e / 2.0,
        Strain::Incremental => (e - 1.0) * pxfm::f_exp(e) + 1.0,
    };
    let per_length = |law: &Law, area: f64, strain: &[f64], length: f64| {
        let Law::Linear { modulus } = law else { panic!("{law:?}") };
        let sum: f64 = strain.iter().map(|e| density(*e)).sum();
        modulus * area * sum * length / strain.len() as f64
    };
    let fibre = &scene.primary;
    let primary =
        2.0 * per_length(&fibre.material.law, fibre.area, &state.primary.strain, fibre.length);
    let (Some(fibre), Some(crossover)) = (&scene.secondary, &state.crossover) else {
        return primary;
    };
    let strain = &crossover.fibre.strain;
    primary + arms(scene) * per_length(&fibre.material.law, fibre.area, strain, fibre.length)
}

/// The force of the fibres on the projectile, and that of the clamps on the fibres, along y, N.
fn forces(scene: &Scene, state: &State<f64>) -> (f64, f64) {
    let pull = &state.primary.pull;
    let (mut first, mut last) = (-2.0 * pull[0].y, 2.0 * pull.last().unwrap().y);
    if let Some(crossover) = &state.crossover {
        let pull = &crossover.fibre.pull;
        last += arms(scene) * pull.last().unwrap().y;
        if crossover.at_origin() {
            first -= 2.0 * pull[0].y;
        }
    }
    (first, last)
}

/// What the balance says, and what it should say, with a size to compare by.
fn parts(
    scene: &Scene,
    balance: &Balance,
    (now, next): (&State<f64>, &State<f64>),
    entered: &Entered,
) -> Vec<(&'static str, f64, f64, f64)> {
    let mass = scene.projectile.mass.unwrap_or(0.0);
    let v0 = scene.projectile.velocity;
    let nodes = moving(scene, now);
    let between = nodes.iter().zip(moving(scene, next));
    let means: Vec<_> = between.map(|((mass, a), (_, b))| (*mass, (a + b) / 2.0)).collect();
    let kinetic: f64 = means.iter().map(|(mass, v)| mass * v.norm_squared() / 2.0).sum();
    let momentum: f64 = nodes.iter().map(|(mass, v)| mass * v.y).sum();
    let &(first_mass, first_mean) = means.last().unwrap();
    let first_now = nodes.last().unwrap().1.y;
    let projectile = mass * first_mean.y * first_mean.y / 2.0;
    let stored = stored(scene, now);
    let initial = (mass + first_mass) * v0;
    let (drive, work) = if mass > 0.0 { (0.0, 0.0) } else { (entered.drive, entered.work) };
    let given = first_mass * v0 * v0 / 2.0 + entered.most_work;
    let without_first = kinetic - first_mass * first_mean.y * first_mean.y / 2.0 + stored;
    let (e, m) = (&balance.energy, &balance.momentum);
    let energies = initial * v0 / 2.0 + entered.most_work;
    let momenta = initial + entered.drive.abs();
    vec![
        ("kinetic", e.kinetic, kinetic, energies),
        ("stored", e.stored, stored, energies),
        ("dissipated", e.dissipated, 0.0, energies),
        ("projectile", e.projectile, projectile, energies),
        ("initial energy", e.initial, initial * v0 / 2.0, energies),
        ("work", e.work, work, energies),
        (
            "residual of energy",
            e.residual,
            kinetic + stored + projectile - initial * v0 / 2.0 - work,
            energies,
        ),
        ("fibres alone", now.fibre_imbalance(e), (without_first - entered.work) / given, 1.0),
        ("momentum", m.fibres, momentum, momenta),
        ("of the projectile", m.projectile, mass * first_now, momenta),
        ("initial momentum", m.initial, initial, momenta),
        ("drive", m.drive, drive, momenta),
        ("clamps", m.clamps, entered.clamps, momenta),
        (
            "residual of momentum",
            m.residual,
            momentum + mass * first_now - initial - drive - entered.clamps,
            momenta,
        ),
        // The impulses are those of all forces that act; a crossover that slides passes on forces by
        // virtual work, which keeps energy and not momentum.
        ("momentum kept", if slides(scene) { 0.0 } else { m.residual }, 0.0, momenta),
    ]
}

fn slides(scene: &Scene) -> bool {
    scene
        .secondary
        .as_ref()
        .is_some_and(|secondary| secondary.at > 0.0 && secondary.slide_factor < 1.0)
}

/// Impulse of the drive and of the clamps, N s; work on the fibres, and the most that it was, J.
#[derive(Default)]
struct Entered {
    drive: f64,
    clamps: f64,
    work: f64,
    most_work: f64,
}

impl Entered {
    fn step(&mut self, scene: &Scene, now: &State<f64>, next: &State<f64>) {
        let dt = now.time_step;
        let ((first, last), (first_after, _)) = (forces(scene, now), forces(scene, next));
        self.drive += first * dt;
        self.clamps += last * dt;
        self.work += (first + first_after) / 2.0 * next.primary.velocity[0].y * dt;
        self.most_work = self.most_work.max(self.work);
    }
}

fn check(name: &str, scene: &Scene, paper: &impl Paper<f64>) {
    let mut state = State::<f64>::at_impact(scene, Wavefront::Flagged);
    let mut states = vec![state.clone()];
    let outcome = march::run(paper, &mut state, STEPS, |state| states.push(state.clone()));
    assert_eq!(outcome, Outcome::Completed, "{name}");
    let mut entered = Entered::default();
    let mut checked = 0;
    for two in states.windows(2) {
        let [now, next] = two else { unreachable!() };
        let node = |state: &State<f64>| state.crossover.as_ref().map(|crossover| crossover.node);
        // Where the crossover is about to slide on to another node, the mean velocity is another's.
        // At impact itself the first node has been given its velocity, and does not have it yet.
        if now.step > 0 && node(now) == node(next) {
            let balance = now.balance(paper, scene.strain);
            for (what, found, expected, size) in parts(scene, &balance, (now, next), &entered) {
                // Sums of hundreds of steps and nodes, each to 1e-16; the energy of the logarithm as it
                // stands loses four digits at a strain of a hundredth.
                let apart = (found - expected).abs();
                assert!(apart < 1e-12 * size, "{name}, {}: {what} {found} {expected}", now.step);
            }
            let energy = &balance.energy;
            let relative = energy.residual / (energy.initial + energy.work.abs());
            assert_eq!(energy.relative_residual(), relative);
            checked += 1;
        }
        entered.step(scene, now, next);
    }
    assert!(checked > 500, "{name}: {checked}");
    // Waves and kinks have been everywhere.
    let state = &states[states.len() - 1];
    assert!(state.primary.pull.last().unwrap().y.abs() > 0.01 * state.primary.tension[0], "{name}");
    assert!(entered.clamps != 0.0 && entered.work != 0.0, "{name}");
}

#[test]
fn every_part_of_the_balance_is_the_sum_over_what_moves_is_stretched_and_has_acted() {
    for (name, scene) in scenes() {
        check(name, &scene, &Corrected::<Incremental>::new(scene.corrections));
    }
}

#[test]
fn so_it_is_for_engineering_strain() {
    for (name, scene) in scenes() {
        let scene = Scene { strain: Strain::Engineering, ..scene };
        check(name, &scene, &Corrected::<Engineering>::new(scene.corrections));
    }
}
