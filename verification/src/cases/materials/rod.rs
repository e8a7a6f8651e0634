//! A viscoelastic fibre pulled along its axis, against the pulled rod.
//!
//! With engineering strain a fibre on its axis is the linear rod at any strain.

use crossfibre::exact::viscoelastic::{self, PulledRod};
use crossfibre::material::{Arm, Update};
use crossfibre::number::{Number, Vector};
use crossfibre::scene::{Law, Scene, Strain};
use crossfibre::state::Wavefront;

use crate::cases::support::{Marched, check, measured_by, order, relative, shipped, watched};
use crate::cases::{Bound, Check};
use crate::oracle;

/// E of the arm, Pa.
const MODULUS: f64 = 67.9e9;
/// v₀, m/s.
const SPEED: f64 = 3.7;

/// A fibre of a spring (Pa) and one arm, at α = 1.
struct Rod {
    scene: Scene,
    spring: f64,
    relaxation_time: f64,
}

impl Rod {
    /// So many time steps to τ; pulled until the front is near the clamp.
    fn new(spring: f64, steps_to_relax: f64, elements: usize) -> Self {
        let mut scene = measured_by(Strain::Engineering, shipped("viscoelastic"));
        (scene.secondary, scene.projectile.mass, scene.courant) = (None, None, 1.0);
        scene.primary.elements = elements;
        let wave_speed = ((spring + MODULUS) / scene.primary.density).sqrt();
        let length = scene.primary.length;
        let relaxation_time = steps_to_relax * length / elements as f64 / wave_speed;
        scene.duration = 0.97 * length / wave_speed;
        let mut rod = Self { scene, spring, relaxation_time };
        rod.set(Update::Exact);
        rod
    }

    fn set(&mut self, update: Update) {
        self.scene.primary.material.law = Law::Viscoelastic {
            equilibrium_modulus: self.spring,
            arms: vec![Arm { modulus: MODULUS, relaxation_time: self.relaxation_time }],
            update,
        };
    }

    fn exact(&self, speed: f64) -> PulledRod {
        let arm = viscoelastic::Arm { modulus: MODULUS, relaxation_time: self.relaxation_time };
        oracle::pulled_rod(self.scene.primary.density, self.spring, &[arm], speed).expect("a rod")
    }

    fn run(&self, strain: Strain, speed: f64) -> Marched {
        let run = watched(
            measured_by(strain, self.scene.clone()),
            Wavefront::Flagged,
            &|state| {
                state.projectile.axis = Vector::<f64, 2>::new(-1.0, 0.0);
                state.projectile.velocity = speed;
            },
            |_| {},
        );
        assert!(run.outcome.is_completed(), "{}", run.outcome);
        run
    }

    /// Stress of an element at the end of a run, in units of ρcv₀.
    fn stress(&self, run: &Marched, element: usize, speed: f64) -> f64 {
        let fibre = &run.state.primary;
        let unit = self.scene.primary.density * fibre.properties.wave_speed * speed;
        fibre.tension[element] / self.scene.primary.area / unit
    }

    /// Mean of |σ − exact| (ρcv₀) and |v − exact| (v₀) from the end to the front.
    fn apart(&self, strain: Strain, speed: f64) -> (f64, f64) {
        let (exact, run) = (self.exact(speed), self.run(strain, speed));
        let fibre = &run.state.primary;
        let (t, dt, dx) = (run.state.time(), run.state.time_step, fibre.properties.spacing);
        let unit = self.scene.primary.density * exact.front_speed() * speed;
        let count = run.state.step as usize;
        let at = |x: f64, t: f64| oracle::rod_at(&exact, x, t).expect("it settles");
        let (mut stress, mut velocity) = (0.0, 0.0);
        for i in 0..count {
            let x = i as f64 * dx;
            let there = at(x + 0.5 * dx, t).stress / unit;
            stress += (self.stress(&run, i, speed) - there).abs();
            // The march's velocity is that of the middle of a step.
            velocity += (-fibre.velocity[i].x - at(x, t - 0.5 * dt).velocity).abs() / speed;
        }
        (stress / count as f64, velocity / count as f64)
    }

    /// The foremost element's stress (ρcv₀), how many steps it took, and x = Δt/τ.
    fn front(&self) -> (f64, u64, f64) {
        let run = self.run(Strain::Engineering, SPEED);
        let steps = run.state.step;
        let stress = self.stress(&run, steps as usize - 1, SPEED);
        (stress, steps, run.state.time_step / self.relaxation_time)
    }
}

/// The pulled rod at the whole range of times.
pub fn pulled() -> Vec<Check> {
    let mut checks = Vec::new();
    for (name, spring) in [("Maxwell", 0.0), ("Standard linear solid", 23.7e9)] {
        let [coarse, fine] = [64, 512].map(|n| Rod::new(spring, n as f64 / 4.3, n));
        let [(stress, velocity), (stress_fine, velocity_fine)] =
            [&coarse, &fine].map(|rod| rod.apart(Strain::Engineering, SPEED));
        let rod = "the pulled rod, by inversion of its transform";
        let why = "the front's factor of a step, (1 - exp(-x))/x for x = Δt/τ, is exp(-x/2) but for \
                   x²/24, which adds up over t/Δt steps: order one";
        checks.extend([
            check(
                format!("{name}: stress from the end to the front, t = 4.2 τ"),
                rod,
                "mean of |σ - exact|/ρcv₀, τ = 119 Δt",
                stress_fine,
                Bound::AtMost(2e-4),
                why,
            ),
            check(
                format!("{name}: velocity likewise"),
                rod,
                "mean of |v - exact|/v₀, τ = 119 Δt",
                velocity_fine,
                Bound::AtMost(2e-4),
                why,
            ),
            check(
                format!("{name}: they converge"),
                rod,
                "observed order of the stress over a factor of 8",
                order(stress, stress_fine, 8.0),
                Bound::Within(0.95, 1.05),
                why,
            ),
            check(
                format!("{name}: and the velocity"),
                rod,
                "observed order of the velocity over a factor of 8",
                order(velocity, velocity_fine, 8.0),
                Bound::Within(0.95, 1.05),
                why,
            ),
            precursor(name, &fine),
        ]);
    }
    let mut literal = Rod::new(0.0, 512.0 / 4.3, 512);
    literal.set(Update::Literal);
    let (stress, steps, x) = literal.front();
    checks.push(check(
        "Maxwell, literal update at α = 1: the front does not decay at all",
        "exp(-x/2cτ)",
        "stress of the foremost element over the exact one, less 1, t = 4.2 τ",
        stress / Number::exp(-0.5 * x * steps as f64) - 1.0,
        Bound::AtLeast(4.0),
        "an element that is loaded in the step has had no stress before it that could relax",
    ));
    checks.extend(late());
    checks.extend(strains());
    checks
}

/// The decay of the front against its own closed form in the scheme and against the rod's.
fn precursor(name: &str, rod: &Rod) -> Check {
    let (stress, steps, x) = rod.front();
    let glassy = rod.spring + MODULUS;
    let exponent = 0.5 * MODULUS / glassy * x * steps as f64;
    check(
        format!("{name}: the front decays by exp(-(E₁/E₀)x/2cτ)"),
        "exponent of the precursor, by the jump conditions",
        "relative error of the exponent, τ = 119 Δt",
        (-Number::ln(stress) / exponent - 1.0).abs(),
        Bound::AtMost(3e-3),
        "x/12 for one arm alone, 7e-4, and more beside a spring",
    )
}

/// Sixty-eight relaxation times.
fn late() -> Vec<Check> {
    let [maxwell, solid] = [0.0, 23.7e9].map(|spring| {
        let rod = Rod::new(spring, 7.3, 512);
        let run = rod.run(Strain::Engineering, SPEED);
        let t = run.state.time() / rod.relaxation_time;
        (rod.stress(&run, 0, SPEED), t)
    });
    let (stress, t) = maxwell;
    let diffusing = (1.0 + 0.25 / t) / (std::f64::consts::PI * t).sqrt();
    vec![
        check(
            "Maxwell, late: the end's stress falls as in diffusion",
            "ρcv₀/√(πt/τ) × (1 + τ/4t)",
            "relative, t = 68 τ, τ = 7.3 Δt",
            relative(stress, diffusing),
            Bound::AtMost(2e-4),
            "the next term is of order (τ/t)², 6e-5",
        ),
        check(
            "Standard linear solid, late: the end's stress is that of the equilibrium modulus",
            "ρc∞v₀",
            "relative, t = 68 τ, τ = 7.3 Δt",
            relative(solid.0, (23.7e9 / (23.7e9 + MODULUS)).sqrt()),
            Bound::AtMost(5e-10),
            "rounding of positions, 3e-17 m of elements that are stretched by 5e-7 m",
        ),
    ]
}

/// What great strains do.
fn strains() -> Vec<Check> {
    let rod = Rod::new(23.7e9, 30.0, 128);
    let engineering = |speed| rod.apart(Strain::Engineering, speed).0;
    vec![
        check(
            "At 370 m/s, 4.6 % of strain, engineering strain is as linear as at 3.7",
            "the pulled rod, which is of small strain",
            "change of the mean of |σ - exact|/ρcv₀",
            (engineering(370.0) - engineering(SPEED)).abs(),
            Bound::AtMost(1e-9),
            "rounding of positions, 1e-14 m of 3.7 m/s × Δt = 1e-6 m",
        ),
        check(
            "With the strain of (4) it is not",
            "the same",
            "mean of |σ - exact|/ρcv₀ at 370 m/s",
            rod.apart(Strain::Incremental, 370.0).0,
            Bound::AtLeast(5e-3),
            "ln λ is ε/2 less than λ - 1 where the fibre is stretched slowly: up to 2.3 %",
        ),
    ]
}
