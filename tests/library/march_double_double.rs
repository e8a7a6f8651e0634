//! The march with 32 digits: it runs, it has the digits of its numbers, and what separates it from
//! the march in `f64` is the rounding of `f64`.

use std::cmp::max_by;

use crate::common::{exact, run, shipped, short_scenes, steps};
use crossfibre::corrected::{Corrected, Engineering, Incremental};
use crossfibre::double_double::DoubleDouble;
use crossfibre::errata::Corrections;
use crossfibre::exact::dalembert::Mesh;
use crossfibre::march;
use crossfibre::number::{Number, Vector};
use crossfibre::outcome::Outcome;
use crossfibre::scene::{Material, Scene, Strain};
use crossfibre::state::{FibreState, State, Wavefront};

type Long = State<DoubleDouble>;

/// Greatest size of a difference.
fn apart<'a>(
    long: impl IntoIterator<Item = &'a DoubleDouble>,
    double: impl IntoIterator<Item = &'a f64>,
) -> f64 {
    let difference = |(l, d): (&DoubleDouble, &f64)| (*l - DoubleDouble::from_f64(*d)).to_f64();
    long.into_iter().zip(double).map(|pair| difference(pair).abs()).max_by(f64::total_cmp).unwrap()
}

/// Greatest differences of strain, of velocity over c and of position over Δx, in units of what
/// rounding is expected to make of a strain: a position, up to `length`, is rounded by half a unit of
/// its last place, over Δx; that adds up as the square root of the steps.
fn in_units_of_rounding<const D: usize>(
    long: &FibreState<DoubleDouble, D>,
    double: &FibreState<f64, D>,
    length: f64,
    steps: u64,
) -> [f64; 3] {
    let fibre = &double.properties;
    let unit = crate::common::ulp::<f64>(length) / 2.0 / fibre.spacing * (steps as f64).sqrt();
    let [velocity, position] = [
        apart(long.velocity.iter().flatten(), double.velocity.iter().flatten()),
        apart(long.position.iter().flatten(), double.position.iter().flatten()),
    ];
    let strain = apart(&long.strain, &double.strain);
    [strain, velocity / fibre.wave_speed, position / fibre.spacing].map(|x| x / unit)
}

#[test]
fn the_march_of_doubles_is_off_by_their_rounding() {
    let whole = ("fig3, whole".to_owned(), shipped("fig3"));
    for (name, scene) in short_scenes().into_iter().chain([whole]) {
        let (double, in_double) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let (long, in_long) = run(&scene, Wavefront::Flagged, |_: &Long| ());
        assert_eq!((in_long, in_double), (Outcome::Completed, Outcome::Completed), "{name}");
        assert_eq!((long.step, double.step), (steps(&scene), steps(&scene)), "{name}");
        let length = scene.primary.length;
        let mut fibres =
            vec![in_units_of_rounding(&long.primary, &double.primary, length, long.step)];
        if let (Some(l), Some(d)) = (&long.crossover, &double.crossover) {
            assert_eq!((l.node, l.moves), (d.node, d.moves), "{name}");
            fibres.push(in_units_of_rounding(&l.fibre, &d.fibre, length, long.step));
        }
        for number in fibres.into_iter().flatten() {
            // Measured 0.04 to 4.6; the less, the later a fibre was struck, and the most where a node
            // slides or a projectile runs away. That there is a difference at all shows that the
            // digits differ.
            assert!((0.01..10.0).contains(&number), "{name}: {number}");
        }
    }
}

/// A fibre that is pulled along its length: the scheme at α = 1 is d'Alembert's solution.
fn pulled<S: Number>(scene: &Scene, speed: f64) -> State<S> {
    let mut state = State::at_impact(scene, Wavefront::Flagged);
    state.projectile.axis = Vector::<S, 2>::new(-S::one(), S::zero());
    state.projectile.velocity = exact(speed);
    state
}

#[test]
fn an_axial_wave_has_the_digits_of_the_number() {
    fn worst<S: Number>() -> f64 {
        let mut scene = shipped("single-400");
        (scene.primary.elements, scene.strain) = (61, Strain::Engineering);
        let mut state = pulled::<S>(&scene, 37.3);
        let speed = state.projectile.velocity;
        let unit = speed / state.primary.properties.wave_speed;
        let mesh = Mesh { elements: 61 };
        let edition = Corrected::<Engineering>::new(Corrections::ALL);
        let mut worst = 0.0_f64;
        // Five passages of the fibre.
        let outcome = march::run(&edition, &mut state, 5 * 61, |state| {
            let step = state.step as usize;
            let off = |x: S, whole: usize| (x - S::count(whole)).to_f64().abs();
            for (e, &strain) in state.primary.strain.iter().enumerate() {
                worst = max_by(worst, off(strain / unit, mesh.strain(e, step)), f64::total_cmp);
            }
            for (i, velocity) in state.primary.velocity.iter().enumerate() {
                let off = (velocity.x / speed + S::count(mesh.velocity(i, step))).to_f64().abs();
                worst = max_by(worst, off, f64::total_cmp);
            }
        });
        assert_eq!(outcome, Outcome::Completed);
        worst
    }
    // Half a unit of 0.3 m in the last place, 2.8e-17 m, is 1.1e-12 of the stretch of an element of
    // 4.9 mm by V/c = 0.5 %; over 305 steps 1.8e-11 by chance, 3.3e-10 at the worst.
    let double = worst::<f64>();
    assert!((1e-12..1e-10).contains(&double), "{double:e}"); // measured 3.8e-11
    // The same with 53 bits more: 2⁻⁵³ of it.
    let long = worst::<DoubleDouble>();
    assert!(long > 0.0 && long < 2e-26, "{long:e}"); // measured 5.1e-27
}

#[test]
fn momentum_is_kept_to_the_digits_of_the_number() {
    let scenes = short_scenes();
    let corrected = scenes.iter().filter(|(_, scene)| scene.corrections == Corrections::ALL);
    let mut seen = 0;
    for (name, scene) in corrected {
        let long = run(scene, Wavefront::Flagged, |_: &Long| ()).0;
        let edition = Corrected::<Incremental>::new(scene.corrections);
        let momentum = long.balance(&edition, scene.strain).momentum;
        // (2), (17) and (18) telescope: what is left is the rounding, 1.2e-32, of sums over hundreds of
        // steps and nodes. Measured up to 8.6e-32; one operation of doubles would leave some 1e-17.
        let residual = momentum.residual / (momentum.initial.abs() + momentum.drive.abs());
        assert!(residual.abs() < 5e-31, "{name}: {residual:e}");
        seen += 1;
    }
    assert_eq!(seen, 8);
}

#[test]
fn where_doubles_are_exact_both_marches_give_the_same_numbers() {
    // All constants are powers of two: Δx = 2⁻¹¹ m, c = 2¹³ m/s, Δm = 2⁻²¹ kg, A = 2⁻³ s/kg. Pulled at
    // three times c, an element is stretched to four times its length in one step, so that no
    // operation is rounded until the front is back from the clamp.
    let mut scene = shipped("single-400");
    let fibre = &mut scene.primary;
    (fibre.elements, fibre.length) = (48, 48.0 / 2048.0);
    (fibre.density, fibre.area) = (1024.0, 0.5_f64.powi(20));
    fibre.material = Material::linear(2_f64.powi(36));
    let speed = 3.0 * 8192.0;
    let (mut double, mut long) =
        (pulled::<f64>(&scene, speed), pulled::<DoubleDouble>(&scene, speed));
    let edition = Corrected::<Incremental>::new(Corrections::ALL);
    for step in 1..=48 {
        march::step(&edition, &mut double).unwrap();
        march::step(&edition, &mut long).unwrap();
        let (d, l) = (&double.primary, &long.primary);
        for (long, double) in
            [(&l.position, &d.position), (&l.velocity, &d.velocity), (&l.pull, &d.pull)]
        {
            assert_eq!(apart(long.iter().flatten(), double.iter().flatten()), 0.0, "{step}");
        }
        for (long, double) in [(&l.strain, &d.strain), (&l.tension, &d.tension)] {
            assert_eq!(apart(long, double), 0.0, "{step}");
        }
        assert_eq!((l.visited, long.work), (d.visited, double.work));
        assert_eq!(long.accounts.drive_impulse.to_f64(), double.accounts.drive_impulse);
        assert_eq!(long.accounts.drive_work.to_f64(), double.accounts.drive_work);
        let strains = (0..48).map(|e| 3.0 * Mesh { elements: 48 }.strain(e, step) as f64);
        assert!(d.strain.iter().copied().eq(strains), "{step}: {:?}", d.strain);
    }
}

#[test]
fn a_march_into_infinity_ends_where_that_of_doubles_ends() {
    // Engineering strain follows the length, so that growth goes on to the end of the numbers.
    for name in ["single-400", "unequal", "both-at-origin"] {
        let mut scene = Scene { strain: Strain::Engineering, duration: 9.7e-3, ..shipped(name) };
        scene.primary.elements = 23;
        if let Some(secondary) = &mut scene.secondary {
            secondary.elements = 17;
        }
        scene.courant = 2.9;
        let (_, in_double) = run(&scene, Wavefront::Flagged, |_: &State<f64>| ());
        let (_, in_long) = run(&scene, Wavefront::Flagged, |_: &Long| ());
        assert!(matches!(in_double, Outcome::Diverged { .. }), "{name}: {in_double}");
        assert_eq!(in_long, in_double, "{name}");
    }
}
