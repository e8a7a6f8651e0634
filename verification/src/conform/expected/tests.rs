use crossfibre::outcome::End;
use crossfibre::place::{Fibre, Place};
use crossfibre::scene::{Law, Material, Primary, Secondary};

use super::*;
use crate::cases::support::{coarse_fig3, shipped};
use crate::conform::draw;
use crate::conform::session::up_to;
use crate::random::SplitMix;

const CORRECTED: Edition = Edition { strain: Strain::Incremental, corrections: Form::All };

fn of(equation: u8, inputs: &[(&str, f64)], precision: Precision) -> Expected {
    let inputs = inputs.iter().map(|(name, x)| ((*name).to_owned(), vec![*x])).collect();
    of_equation(CORRECTED, equation, &inputs, precision)
}

#[test]
fn a_unit_roundoff_is_half_of_the_distance_of_one_to_the_next_number() {
    let of = |bits: i32| 2.0_f64.powi(-bits);
    assert_eq!(unit_roundoff(Precision::F64), of(53));
    assert_eq!(unit_roundoff(Precision::F32), of(24));
}

/// (7) is a product of two: half a unit of either, and of itself.
#[test]
fn the_envelope_of_an_equation_is_what_half_a_unit_of_each_input_and_of_the_output_does() {
    let Expected { quantities, beyond, .. } =
        of(7, &[("E", 16.0), ("strain", 0.25)], Precision::F64);
    assert_eq!((quantities[0].values.as_slice(), beyond), (&[4.0][..], None));
    assert_eq!(quantities[0].envelope, 3.0 * 4.0 * 2.0_f64.powi(-53));
}

#[test]
fn only_equal_bits_are_demanded_of_what_may_overflow_and_zero_may_not() {
    let beyond = |equation, inputs: &[_], precision| of(equation, inputs, precision).beyond;
    let overflow = Some("over- or underflow".to_owned());
    assert_eq!(beyond(7, &[("E", 58_600.0), ("strain", 0.0)], Precision::F64), None);
    assert_eq!(beyond(7, &[("E", 1e101), ("strain", 0.3)], Precision::F64), overflow);
    assert_eq!(beyond(7, &[("E", 58_600.0), ("strain", -1e-101)], Precision::F64), overflow);
    // What is no number has an envelope of nothing, and must be told by its value.
    assert_eq!(beyond(3, &[("L", 0.0), ("L_before", 0.0)], Precision::F64), overflow);
    // Too large for 24 bits alone.
    assert_eq!(beyond(7, &[("E", 1e30), ("strain", 1e30)], Precision::F64), None);
    assert_eq!(beyond(7, &[("E", 1e30), ("strain", 1e30)], Precision::F32), overflow);
}

/// Half a unit more of the projectile's mass makes the divisor of (8) zero: the envelope is infinite,
/// and any number would be within it.
#[test]
fn only_equal_bits_are_demanded_where_the_envelope_is_infinite() {
    let unit = 2.0_f64.powi(-24);
    let mass = 1.0 + 2.0 * unit;
    let inputs = [
        ("v_p_before", 0.3),
        ("T_y", 0.7),
        ("m_p", mass),
        ("m_node", -mass * (1.0 + unit)),
        ("dt", 1.0),
        ("t", 1.0),
    ];
    let expected = of(8, &inputs, Precision::F32);
    assert!(expected.quantities[0].values[0].is_finite());
    assert_eq!(expected.quantities[0].envelope, f64::INFINITY);
    assert!(expected.beyond.is_some());
}

/// Two elements of 0.25 m in which everything is a power of two: c = 8192 m/s, an element has
/// 2⁻¹² kg, and E·area is 65536 N. The crossing fibre is the same.
fn of_powers_of_two() -> Scene {
    let mut scene = shipped("single-400");
    scene.strain = Strain::Engineering;
    let material = Material::linear(2.0_f64.powi(36));
    let area = 2.0_f64.powi(-20);
    scene.primary =
        Primary { length: 0.5, elements: 2, density: 1024.0, area, material: material.clone() };
    scene.secondary = Some(Secondary {
        at: 0.25,
        length: 0.5,
        elements: 2,
        density: 1024.0,
        area,
        material,
        slide_factor: 1.0,
    });
    scene.projectile.velocity = 64.0;
    scene.projectile.mass = Some(2.0_f64.powi(-10));
    scene
}

#[test]
fn the_energy_is_that_of_both_halves_and_of_the_projectile() {
    let scene = Scene { secondary: None, ..of_powers_of_two() };
    let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
    state.primary.velocity[0].y = 64.0;
    state.primary.velocity[1].x = 16.0;
    state.primary.velocity[1].y = 32.0;
    // Without tensions the velocities of the next step are the same, and so is their mean.
    state.primary.strain = vec![2.0_f64.powi(-6), 2.0_f64.powi(-5)];
    // ½ 2⁻¹² (64² + 2 (16² + 32²)) and ½ 2⁻¹⁰ 64² of motion; stored 2 · 65536 N · ½ (2⁻¹² + 2⁻¹⁰)
    // 0.25 m.
    let expected = 0.5 + 0.3125 + 2.0 + 20.0;
    assert_eq!(energy_of(&scene, &state), expected);
    assert_eq!(energy_of_record(&scene, &state), expected);
}

#[test]
fn the_size_of_an_energy_is_that_of_tensions_over_lengths_and_of_momenta_at_the_wave_speed() {
    let mut state = State::<f64>::at_impact(&of_powers_of_two(), Wavefront::Flagged);
    state.primary.tension = vec![8.0, -16.0];
    state.primary.velocity[0].y = 64.0;
    state.primary.velocity[1].x = -16.0;
    state.primary.velocity[1].y = 32.0;
    // 24 N over 0.25 m, and 112 m/s with 2⁻¹² kg at 8192 m/s.
    let primary = 6.0 + 224.0;
    let crossing = &mut state.crossover.as_mut().unwrap().fibre;
    crossing.tension[0] = 4.0;
    crossing.velocity[1].x = 1.0;
    crossing.velocity[1].y = -2.0;
    crossing.velocity[1].z = 3.0;
    let secondary = 1.0 + 12.0;
    assert_eq!(energy_moved_by_one(&state), 2.0 * (primary + secondary));
    state.crossover = None;
    assert_eq!(energy_moved_by_one(&state), 2.0 * primary);
}

/// Energies of both number types are formed at every step of a short run, at every second one of 65
/// to 95 steps, and at the end.
#[test]
fn the_envelope_of_the_energy_is_the_greatest_difference_at_its_times_and_half_a_unit() {
    let paper = &Corrected::<Incremental>::new(Corrections::ALL);
    let random = &mut SplitMix::new(5);
    for k in 0..40 {
        let mut scene = draw::scene(random);
        (scene.strain, scene.corrections) = (Strain::Incremental, Corrections::ALL);
        // So slow that it is stretched little while waves go to and fro.
        scene.projectile.velocity *= 0.1;
        scene.primary.elements = 5;
        scene.secondary = scene.secondary.filter(|_| k % 2 == 0);
        if let Some(secondary) = &mut scene.secondary {
            (secondary.at, secondary.elements) = (0.4 * scene.primary.length, 4);
            secondary.slide_factor = 1.0;
        }
        let (steps, every) = if k < 10 { (5 + k, 1) } else { (65 + 2 * (k % 15), 2) };
        let time_step = Discretisation::<f64>::of(&scene).time_step;
        let scene = up_to(&scene, steps, time_step);

        let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
        let mut precise = State::<DoubleDouble>::at_impact(&scene, Wavefront::Flagged);
        let mut worst = 0.0_f64;
        for step in 1..=steps {
            march::step(paper, &mut state).unwrap();
            march::step(paper, &mut precise).unwrap();
            if step % every == 0 || step == steps {
                let apart = energy(paper, &scene, &state) - energy(paper, &scene, &precise);
                worst = worst.max(apart.abs());
            }
        }
        let expected = of_run(&scene, Precision::F64);
        let found = expected.quantities.last().unwrap();
        let value = energy_of_record(&scene, &state);
        assert_eq!((found.quantity, &found.values), (Quantity::Energy, &vec![value]));
        let size = value.abs() + energy_moved_by_one(&state);
        assert_eq!(found.envelope, worst + 2.0_f64.powi(-53) * size, "{k}: {scene:?}");
    }
}

#[test]
fn of_a_run_steps_and_crossover_are_counted_and_other_laws_have_no_energy_to_compare() {
    let expected = of_run(&coarse_fig3(), Precision::F64);
    // 28.7 µs are four steps of 0.05 m at 6969 m/s, and 0.1 m is node 2.
    let counts = [("steps", 4_u64), ("crossover node", 2), ("crossover moves", 0)];
    assert_eq!(expected.counts, counts);
    assert_eq!((kind(&expected.outcome), &expected.beyond), ("completed", &None));
    let quantities =
        |expected: &Expected| expected.quantities.iter().map(|e| e.quantity).collect::<Vec<_>>();
    let last = [Quantity::ProjectilePosition, Quantity::Energy];
    assert!(quantities(&expected).ends_with(&last));
    let mut single = Scene { secondary: None, ..coarse_fig3() };
    assert_eq!(of_run(&single, Precision::F64).counts, [("steps", 4_u64)]);
    let modulus = single.primary.material.instantaneous_modulus();
    single.primary.material = Law::Polynomial { coefficients: vec![modulus, 3.0 * modulus] }.into();
    single.courant = 0.7;
    let other = of_run(&single, Precision::F64);
    assert!(quantities(&other).ends_with(&last[..1]), "{:?}", quantities(&other));
}

/// A projectile so slow that 24 bits see no strain, (vΔt/Δx)²/2 = 1e-10 in the first step, and a law
/// that with it outgrows a Courant number of 1.
#[test]
fn a_run_ends_when_it_ends_in_either_number_type_and_is_not_judged_if_only_in_one() {
    let mut scene = shipped("single-400");
    let modulus = scene.primary.material.instantaneous_modulus();
    scene.primary.material = Law::Polynomial { coefficients: vec![modulus, 1e6 * modulus] }.into();
    scene.primary.elements = 6;
    let mesh = Discretisation::<f64>::of(&scene);
    scene.projectile.velocity = 1.4e-5 * mesh.primary.wave_speed;
    let scene = up_to(&scene, 5, mesh.time_step);

    let single = of_run(&scene, Precision::F32);
    assert_eq!(kind(&single.outcome), "completed");
    assert!(single.beyond.unwrap().starts_with("how it ends, or where the crossover is"));
    assert_eq!(single.counts, [("steps", 1_u64)]);

    let double = of_run(&scene, Precision::F64);
    let Outcome::CourantExceeded { place, .. } = double.outcome else {
        panic!("{}", double.outcome)
    };
    assert_eq!(place, Place { step: 1, fibre: Fibre::Primary, index: 0 });
    assert_eq!((double.counts, double.beyond), (vec![("steps", 1)], None));
}

/// A step takes the projectile 3e23 m, of which the square is beyond the numbers of 24 bits.
#[test]
fn a_run_that_diverges_in_24_bits_alone_ends_there() {
    let mut scene = Scene { strain: Strain::Engineering, ..shipped("single-400") };
    scene.projectile.velocity = 1e30;
    let scene = up_to(&scene, 5, Discretisation::<f64>::of(&scene).time_step);
    let single = of_run(&scene, Precision::F32);
    let place = Place { step: 1, fibre: Fibre::Primary, index: 0 };
    assert_eq!(single.outcome, Outcome::Diverged { place, equation: 6 });
    assert!(single.beyond.is_some());
    assert_eq!(single.counts, [("steps", 1_u64)]);
    let double = of_run(&scene, Precision::F64);
    assert_eq!((kind(&double.outcome), double.counts), ("completed", vec![("steps", 5)]));
}

/// As near to the middle between two nodes as doubles tell, and 24 bits do not.
#[test]
fn a_run_whose_crossover_hangs_on_rounding_is_not_judged() {
    let mut scene = of_powers_of_two();
    scene.primary.elements = 4;
    let secondary = scene.secondary.as_mut().unwrap();
    // Of equals the lower: node 1 at 0.125 m.
    secondary.at = 0.1875 + 1e-12;
    let time_step = Discretisation::<f64>::of(&scene).time_step;
    let scene = up_to(&scene, 1, time_step);
    let [double, single] = [Precision::F64, Precision::F32].map(|of| of_run(&scene, of));
    assert_eq!((double.counts[1], double.beyond), (("crossover node", 2), None));
    assert_eq!(single.counts[1], ("crossover node", 1));
    assert_eq!(kind(&single.outcome), kind(&double.outcome));
    assert!(single.beyond.is_some());
}

#[test]
fn an_end_has_the_name_that_results_have() {
    let place = Place { step: 7, fibre: Fibre::Primary, index: 3 };
    let exceeded =
        Outcome::CourantExceeded { place, courant: 1.2, would_serve: None, search_given_up: false };
    for outcome in [
        Outcome::Completed,
        Outcome::Diverged { place, equation: 6 },
        Outcome::CrossoverLeft { step: 7, end: End::Clamp },
        exceeded,
        Outcome::NoWaves { place, strain: 0.3 },
    ] {
        let written = serde_json::to_value(&outcome).unwrap();
        assert_eq!(written["kind"], kind(&outcome));
    }
    // Which a candidate need not notice.
    assert_eq!(kind(&Outcome::EnergyUnbalanced { step: 7, residual: None }), "completed");
}
