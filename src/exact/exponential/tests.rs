use super::super::elastic::Hyperelastic;
use super::super::quadrature::integral;
use super::super::samples::{DENSITY, exponential_hardening, exponential_softening};
use super::super::smith::{Fibre, Law};
use super::*;

#[test]
fn numbers_that_make_no_law_are_refused_with_the_reason() {
    assert_eq!(Exponential::new(-3.1, 1.7e9, 19.3), Err(LawError::Density(-3.1)));
    for (a, b) in [(1.7e9, -19.3), (-1.7e9, 19.3), (0.0, 19.3), (1.7e9, 0.0)] {
        let error = Exponential::new(DENSITY, a, b).unwrap_err();
        assert_eq!(error, LawError::InitialModulus(a * b));
        assert!(error.to_string().contains("a*b"), "{error}");
    }
    let error = Exponential::new(DENSITY, 1.7e9, f64::INFINITY).unwrap_err();
    assert_eq!(error, LawError::NotFinite { place: 2, value: f64::INFINITY });
}

#[test]
fn waves_energy_and_limit_agree_with_40_digits() {
    // Quadrature of √(T′/ρ) and of T, [T][ε] and T = λT′, to 40 digits in another language.
    // Tolerance: some ten roundings; exp(bε) amplifies those of bε by at most 3.
    let (hard, soft) = (exponential_hardening(), exponential_softening());
    let (near, far) = (0.0131, 0.0372);
    for (what, found, expected) in [
        ("fan, loading", soft.wave_velocity(near, far), 117.179_159_877_753_74),
        ("shock, unloading", soft.wave_velocity(far, near), -117.442_701_118_883_65),
        ("shock, loading", hard.wave_velocity(near, far), 187.956_733_630_367_27),
        ("fan, unloading", hard.wave_velocity(far, near), -187.322_098_800_937_2),
        ("energy, hardening", hard.stored_energy(far), 43_039_822.275_164_716),
        ("energy, softening", soft.stored_energy(far), 28_958_749.491_179_667),
        ("greatest strain", soft.greatest_strain(), 0.163_476_032_065_390_13),
    ] {
        assert!((found / expected - 1.0).abs() < 3e-15, "{what}: {found} {expected}");
    }
}

#[test]
fn greatest_strain_of_a_hardening_law_overflows_nothing() {
    for b in [3.1e-7, 23.7, 1.3e4] {
        let law = Exponential::new(DENSITY, 58.6e9 / b, b).unwrap();
        let last = law.greatest_strain();
        let (front, tail) = law.wave_speeds(0.0, last);
        // The exponential of a number near 300: 300 roundings.
        assert!((law.tension(last) / 1e150 - 1.0).abs() < 1e-13, "{b} {last}");
        assert!(front.is_finite() && tail.is_finite(), "{b} {last}");
        assert!(law.kink_speed(last) <= tail);
    }
}

#[test]
fn greatest_strain_of_a_softening_law_is_where_the_kink_catches_the_tail() {
    // From almost linear to a law that yields at once; a few roundings, times y ≤ 15 for exp.
    for b in [-3.1e-6, -0.73, -19.3, -4.1e5] {
        let law = Exponential::new(DENSITY, 58.6e9 / b, b).unwrap();
        let last = law.greatest_strain();
        let tail = law.wave_speeds(0.0, last).1;
        assert!((law.kink_speed(last) / tail - 1.0).abs() < 2e-14, "{b} {last}");
    }
}

#[test]
fn energy_keeps_its_digits_on_both_sides_of_the_change_of_form() {
    // Quadrature of T: rounding of 768 additions, and of y amplified by |y|.
    let law = exponential_softening();
    for y in [1.3e-9, 0.031, 0.999, 1.001, 4.7, -0.031, -0.999, -1.001, -4.7] {
        let strain = y / -19.3;
        let expected = integral(0.0, strain, |s| law.tension(s));
        let found = law.stored_energy(strain);
        assert!((found / expected - 1.0).abs() < 1e-14, "{y}: {found} {expected}");
    }
}

#[test]
fn law_tends_to_the_engineering_law_as_the_exponent_vanishes() {
    let fibre = Fibre { modulus: 58.6e9, density: DENSITY, area: 1.37e-8 };
    let engineering = Hyperelastic { law: Law::Engineering, fibre };
    for b in [1.3e-11, -1.3e-11] {
        let law = Exponential::new(DENSITY, 58.6e9 / b, b).unwrap();
        for (from, to) in [(0.0, 3.7e-10), (0.0, 0.0173), (0.0619, 0.0173)] {
            // bε is below 1e-12, and everything is 1 + O(bε).
            for (found, expected) in [
                (law.tension(to), engineering.tension(to)),
                (law.tangent_modulus(to), engineering.tangent_modulus(to)),
                (law.stored_energy(to), engineering.stored_energy(to)),
                (law.wave_velocity(from, to), engineering.wave_velocity(from, to)),
                (law.wave_speeds(from, to).1, engineering.wave_speeds(from, to).1),
            ] {
                assert!((found / expected - 1.0).abs() < 2e-12, "{b} {from} {to}");
            }
        }
    }
    // Of no width: a small disturbance.
    let law = exponential_hardening();
    let (front, tail) = law.wave_speeds(0.0371, 0.0371);
    assert_eq!((front, law.wave_velocity(0.0371, 0.0371)), (tail, 0.0));
    let expected = (law.tangent_modulus(0.0371) / DENSITY).sqrt();
    assert!((front / expected - 1.0).abs() < 1e-15);
}
