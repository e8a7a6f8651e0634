use super::super::elastic::Hyperelastic;
use super::super::quadrature::integral;
use super::super::samples::{
    DENSITY, concave_convex, convex_concave, softening, twice_inflected, with_inflections,
};
use super::super::smith::{Fibre, Law};
use super::*;

#[test]
fn numbers_that_make_no_law_are_refused_with_the_reason() {
    let refused =
        |density, coefficients: &[f64]| Polynomial::new(density, coefficients).unwrap_err();
    assert_eq!(refused(DENSITY, &[]), LawError::NoCoefficient);
    for bad in [0.0, -1371.3, f64::INFINITY] {
        assert_eq!(refused(bad, &[58.6e9]), LawError::Density(bad));
        assert!(refused(bad, &[58.6e9]).to_string().contains("density"));
    }
    for bad in [0.0, -58.6e9] {
        assert_eq!(refused(DENSITY, &[bad, 3.17e11]), LawError::InitialModulus(bad));
    }
    let error = refused(DENSITY, &[58.6e9, f64::NEG_INFINITY]);
    assert_eq!(error, LawError::NotFinite { place: 2, value: f64::NEG_INFINITY });
    assert!(error.to_string().contains("parameter 2"), "{error}");
}

#[test]
fn energy_slope_and_chord_belong_to_the_tension() {
    for law in [softening(), concave_convex(), convex_concave(), twice_inflected()] {
        for strain in [3.7e-9, 0.0173, 0.0619] {
            // Quadrature: exact for these powers but for the rounding of 768 additions; T and T′
            // lose up to a factor of 30 to cancellation of their terms.
            let energy = integral(0.0, strain, |s| law.tension(s));
            let tension = integral(0.0, strain, |s| law.tangent_modulus(s));
            let slope = law.tangent_modulus(0.0) + integral(0.0, strain, |s| law.curvature(s));
            assert!((law.stored_energy(strain) / energy - 1.0).abs() < 1e-13, "{law:?} {strain}");
            assert!((law.tension(strain) / tension - 1.0).abs() < 1e-13, "{law:?} {strain}");
            assert!((law.tangent_modulus(strain) / slope - 1.0).abs() < 1e-13, "{law:?} {strain}");
            let other = 0.0331;
            let chord = (law.tension(other) - law.tension(strain)) / (other - strain);
            assert!((law.chord(strain, other) / chord - 1.0).abs() < 1e-13, "{law:?} {strain}");
            // A chord of no length is a tangent: the same sum in another order.
            let tangent = law.chord(strain, strain);
            assert!((tangent / law.tangent_modulus(strain) - 1.0).abs() < 1e-13, "{strain}");
        }
    }
}

#[test]
fn velocity_through_a_fan_is_the_integral_of_the_wave_speed() {
    // Loading a concave law and unloading a convex part; 768 additions, and T′ as above.
    for (law, from, to) in [
        (softening(), 0.0, 0.0713),
        (softening(), 0.0131, 0.0132),
        (concave_convex(), 0.0, 0.0281),
        (convex_concave(), 0.0377, 0.0013),
        (twice_inflected(), 0.0551, 0.0691),
    ] {
        let expected = integral(from, to, |s| (law.tangent_modulus(s) / DENSITY).sqrt());
        let found = law.wave_velocity(from, to);
        assert!((found / expected - 1.0).abs() < 2e-14, "{law:?}: {found} {expected}");
        assert_eq!(law.pieces(from, to)[0].kind, Kind::Fan, "{law:?}");
    }
}

#[test]
fn polynomial_of_one_coefficient_is_the_engineering_law() {
    let fibre = Fibre { modulus: 58.6e9, density: DENSITY, area: 1.37e-8 };
    let engineering = Hyperelastic { law: Law::Engineering, fibre };
    let law = Polynomial::new(DENSITY, &[58.6e9]).unwrap();
    for (from, to) in [(0.0, 3.7e-10), (0.0, 0.0173), (0.0619, 0.0173), (0.41, 2.31)] {
        // A few roundings.
        for (found, expected) in [
            (law.tension(to), engineering.tension(to)),
            (law.tangent_modulus(to), engineering.tangent_modulus(to)),
            (law.stored_energy(to), engineering.stored_energy(to)),
            (law.wave_velocity(from, to), engineering.wave_velocity(from, to)),
            (law.wave_speeds(from, to).0, engineering.wave_speeds(from, to).0),
            (law.wave_speeds(from, to).1, engineering.wave_speeds(from, to).1),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-15, "{from} {to}: {found} {expected}");
        }
        assert_eq!(law.pieces(from, to)[0].kind, engineering.pieces(from, to)[0].kind);
    }
    // Far out a kink is as fast as the step to the last bit, or by rounding an ulp faster.
    for modulus in (1..200).map(|i| 1.37e9 * f64::from(i)) {
        let law = Polynomial::new(DENSITY, &[modulus]).unwrap();
        assert!(law.greatest_strain() > 1e100, "{modulus} {}", law.greatest_strain());
    }
}

#[test]
fn greatest_strain_is_where_the_kink_catches_the_tail() {
    // T = λT′, to 40 digits in another language. Tolerance: T′ loses up to a factor of 30 to the
    // cancellation of its terms.
    for (law, expected) in [
        (softening(), 0.088_511_848_426_115_14),
        (convex_concave(), 0.088_897_624_331_003_73),
        (twice_inflected(), 0.073_949_977_890_006_13),
    ] {
        let found = law.greatest_strain();
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
        assert!(law.tangent_modulus(found) > 0.0);
    }
    // Laws that end convex, without and with a concave part before: no limit.
    for law in [Polynomial::new(DENSITY, &[58.6e9, 3.17e11]).unwrap(), concave_convex()] {
        assert!(law.greatest_strain() > 1e30, "{}", law.greatest_strain());
        let (front, tail) = law.wave_speeds(0.0, law.greatest_strain());
        assert!(front.is_finite() && tail.is_finite(), "{law:?}");
    }
}

#[test]
fn kink_that_catches_a_fan_limits_a_law_that_stiffens_later() {
    // T″ = k(x − 0.31): at its inflection T′ is a hundredth of E₁ and T/λ about a fifth. That T
    // becomes convex there does not lift the limit, which lies before.
    let law = with_inflections(DENSITY, 58.6e9, &[0.31], false, 0.541);
    let found = law.greatest_strain();
    assert!(found < 0.31 && law.tangent_modulus(0.31) > 0.0, "{found} {law:?}");
    let (kink, tail) = (law.kink_speed(found), law.wave_speeds(0.0, found).1);
    // Both are roots of numbers with a few roundings.
    assert!((kink / tail - 1.0).abs() < 1e-14, "{kink} {tail}");
    let before = 0.999 * found;
    assert!(law.kink_speed(before) < law.wave_speeds(0.0, before).1);
}

#[test]
fn sign_changes_of_a_polynomial_are_found_and_touching_roots_are_not() {
    // (x − 0.3)(x − 0.7)(x − 1.9), multiplied out; conditioning of the roots: a few ulps.
    let found = sign_changes(&[-0.399, 2.11, -2.9, 1.0], 5.0);
    assert_eq!(found.len(), 3);
    for (found, expected) in found.iter().zip([0.3, 0.7, 1.9]) {
        assert!((found / expected - 1.0).abs() < 3e-15, "{found}");
    }
    assert_eq!(sign_changes(&[-0.399, 2.11, -2.9, 1.0], 1.3).len(), 2);
    // A root at 0; (x − ½)²; (x − ½)³, whose derivative has its root there; none.
    assert!(sign_changes(&[0.0, 1.3, 0.7], 5.0).is_empty());
    assert!(sign_changes(&[0.25, -1.0, 1.0], 5.0).is_empty());
    let triple = sign_changes(&[-0.125, 0.75, -1.5, 1.0], 5.0);
    // A triple root is known to the cube root of an ulp.
    assert!(triple.len() == 1 && (triple[0] - 0.5).abs() < 1e-5, "{triple:?}");
    assert!(sign_changes(&[0.37, 1.3, 0.7], 5.0).is_empty());
}
