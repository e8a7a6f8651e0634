use nalgebra::Vector3;

use super::super::fronts::{Across, Clamped, solved};
use super::super::riemann::State;
use super::super::smith::Fibre as Material;
use super::*;

/// Two unlike fibres; the crossover at 73.1 mm.
fn problem(law: Law) -> Problem<Hyperelastic> {
    let half = |modulus, density, area, length| Clamped {
        material: Hyperelastic { law, fibre: Material { modulus, density, area } },
        area,
        length,
    };
    Problem {
        primary: half(58.6e9, 1206.7, 1.13e-6, 0.307),
        secondary: Some(Across {
            fibre: half(41.3e9, 987.0, 0.71e-6, 0.193),
            at: 0.0731,
            slide_factor: 1.0,
        }),
        velocity: 387.0,
    }
}

fn single(law: Law) -> Problem<Hyperelastic> {
    Problem { secondary: None, ..problem(law) }
}

#[test]
fn a_straight_law_and_a_constant_velocity_are_followed_exactly() {
    let problem = problem(Law::Engineering);
    let exact = motion(&problem, None, 41.3e-6);
    assert_eq!((exact.approximation, exact.ended), (Approximation::default(), None));
    let fronts = solved(&problem.map(Line::of), 41.3e-6);
    // To the bit: writing down the ways of the fronts must not change them.
    assert_eq!(exact.primary, fronts.segments(Fibre::Primary));
    assert_eq!(exact.secondary, fronts.segments(Fibre::Secondary));
    assert_eq!(exact.error_bound.to_bits(), fronts.error_bound().to_bits());
    assert_eq!(exact.projectile_velocity, 387.0);
    assert!(exact.tracks.len() >= 20, "{}", exact.tracks.len());
}

/// Smith's fan has in X/t between c/√λ and c the strain λ = (ct/X)², which the polygon only steps
/// along.
#[test]
fn the_bound_covers_the_steps_that_stand_in_for_a_fan() {
    let (problem, time) = (single(Law::Logarithmic), 31.7e-6);
    let solved = motion(&problem, None, time);
    assert_eq!(solved.approximation.chords, Some(CHORDS));
    let c = problem.primary.material.fibre.wave_speed();
    let struck = smith(Law::Logarithmic, c, 387.0).unwrap();
    let exact = |x: f64| {
        if x < struck.tail_speed * time {
            struck.strain.engineering
        } else {
            ((c * time / x) * (c * time / x) - 1.0).max(0.0)
        }
    };
    let points = 200_000;
    let length = problem.primary.length;
    let mut segments = solved.primary.iter().peekable();
    let sum: f64 = (0..points)
        .map(|k| {
            let x = (f64::from(k) + 0.5) / f64::from(points) * length;
            while segments.next_if(|segment| segment.to <= x).is_some() {}
            (segments.peek().unwrap().state.strain - exact(x)).abs()
        })
        .sum();
    let error = sum / f64::from(points);
    // Along a straight flank n steps are off by s/4n in the mean, and from 2n steps by s/2n, which is
    // the bound: twice the error of 2n. The sampling of 1.5 µm misses a tenth of a step.
    let bound = solved.error_bound;
    assert!((error / bound - 0.5).abs() < 0.05, "{error:e} {bound:e}");
}

/// At first the projectile loses what Smith's tension takes: m dv/dt = −2 A T sin γ.
#[test]
fn a_projectile_is_slowed_by_both_halves_of_the_fibre() {
    let (problem, mass, time) = (single(Law::Engineering), 0.41e-3, 1.3e-9);
    let fibre = problem.primary.material.fibre;
    let struck = smith(Law::Engineering, fibre.wave_speed(), 387.0).unwrap();
    let force = 2.0 * fibre.area * fibre.modulus * struck.tension * struck.angle_sine;
    let lost = 387.0 - motion(&problem, Some(mass), time).projectile_velocity;
    // What is lost, 3e-3 m/s, changes the force by a share of some 1e-5, half of it on the mean; and
    // 387 − v keeps eleven of its digits.
    let error = lost / (force * time / mass) - 1.0;
    assert!(error.abs() < 1e-5, "{error:e}");
}

/// No order is claimed: what the kinks send back to the projectile does not depend smoothly on the
/// steps.
#[test]
fn the_loss_settles_as_the_steps_get_shorter() {
    let problem = single(Law::Engineering).map(Line::of);
    let limits = Limits { resolution: 1e-10, events: 100_000 };
    let lost = |steps| {
        let fronts = braked(&problem, 0.41e-3, 7.3e-6, steps, limits);
        assert_eq!(fronts.ended(), None);
        fronts.accounts().braking / 0.41e-3
    };
    let finest = lost(16);
    let [two, four, eight] = [2, 4, 8].map(|steps| (lost(steps) / finest - 1.0).abs());
    assert!(two > 2.0 * four && four > eight, "{two:e} {four:e} {eight:e}");
    // Seen: 6.1e-4, 1.4e-4, 1.0e-4.
    assert!(eight < 2e-4, "{eight:e}");
}

#[test]
fn the_projectile_has_the_velocity_that_its_loss_leaves_it() {
    for law in [Law::Engineering, Law::Logarithmic] {
        let found = motion(&single(law), Some(0.41e-3), 7.3e-6);
        // The first node has it in the middle of the last of 32 steps.
        let (node, end) = (found.primary[0].state.velocity.y, found.projectile_velocity);
        let lost = 387.0 - end;
        assert!(lost > 10.0, "{lost}");
        assert!((0.3..1.0).contains(&((node - end) / (lost / 32.0))), "{node} {end}");
    }
}

#[test]
fn the_bound_of_a_braked_motion_is_its_difference_from_half_as_many_steps() {
    let (problem, mass, time) = (single(Law::Engineering), 0.41e-3, 7.3e-6);
    let found = motion(&problem, Some(mass), time);
    assert_eq!(found.approximation, Approximation { chords: None, velocity_steps: Some(32) });
    let line = problem.map(Line::of);
    let [fine, coarse] =
        [32, 16].map(|steps| finest(|limits| braked(&line, mass, time, steps, limits)));
    let [a, b] = [&fine, &coarse].map(|fronts| fronts.segments(Fibre::Primary));
    assert_eq!(found.primary, a);
    // The same sum in the same order.
    let difference = mean_difference(&a, &b);
    assert_eq!(found.error_bound, fine.error_bound() + (coarse.error_bound() + difference));
    assert!(difference > 0.5 * found.error_bound);
}

#[test]
fn waves_that_add_up_between_the_ends_stay_within_the_polygon() {
    let mut problem = single(Law::Logarithmic);
    problem.primary.length = 0.0307;
    let struck =
        smith(Law::Logarithmic, problem.primary.material.fibre.wave_speed(), 387.0).unwrap();
    let found = motion(&problem, None, 37.3e-6);
    assert_eq!(found.ended, None);
    // Eight times there and back.
    let most = found.primary.iter().map(|segment| segment.state.strain).fold(0.0, f64::max);
    assert!(most > 6.0 * struck.strain.engineering, "{most}");
}

#[test]
fn a_mean_difference_counts_pieces_that_end_apart() {
    let piece = |from, to, strain| {
        let (direction, velocity) = (Vector3::x(), Vector3::zeros());
        Segment { from, to, state: State { strain, direction, velocity } }
    };
    let a = [piece(0.0, 0.31, 0.017), piece(0.31, 0.73, 0.005)];
    let b = [piece(0.0, 0.29, 0.017), piece(0.29, 0.43, 0.011), piece(0.43, 0.73, 0.005)];
    // 0.02 · 0.006 + 0.12 · 0.006 over 0.73; a few roundings.
    let expected = 0.14 * 0.006 / 0.73;
    for found in [mean_difference(&a, &b), mean_difference(&b, &a)] {
        assert!((found / expected - 1.0).abs() < 1e-13, "{found}");
    }
    assert_eq!(mean_difference(&a, &a), 0.0);
    assert_eq!(mean_difference(&[], &[]), 0.0);
}

/// Such a scene passes its check; the velocities that its junction asks for are beyond all numbers.
#[test]
fn a_secondary_beyond_all_measure_ends_the_motion_and_not_the_program() {
    for (modulus, density) in [(58.6e9, 1e100), (58.6e9, 1.3e59), (1e-15, 987.0), (1e-100, 987.0)] {
        for law in [Law::Logarithmic, Law::Engineering] {
            let mut problem = problem(law);
            if let Some(across) = &mut problem.secondary {
                across.fibre.material.fibre.modulus = modulus;
                across.fibre.material.fibre.density = density;
            }
            let solved = motion(&problem, None, 28.7e-6);
            let told = solved.ended.is_some() || solved.error_bound.is_finite();
            assert!(told, "{modulus:e}, {density:e}: {:?}", solved.ended);
        }
    }
}
