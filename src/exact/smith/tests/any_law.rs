use proptest::prelude::*;
use pxfm::{f_exp, f_log};

use super::super::super::exponential::Exponential;
use super::super::super::polynomial::Polynomial;
use super::super::super::samples::{
    DENSITY, any_polynomial, concave_convex, convex_concave, exponential_hardening,
    exponential_softening, softening, twice_inflected,
};
use super::super::super::wave::Kind;
use super::*;

#[test]
fn states_of_six_laws_agree_with_40_digits() {
    // V² = (λU)² − (λU − W)² with W by quadrature through fans and [T][ε] across shocks, touching
    // points and strain by root finding, to 40 digits in another language: ε, W, T, U.
    // Tolerance: the relation is rounded some ten times; worst seen 4.4e-16.
    fn check(material: &impl Elastic, velocity: f64, expected: [f64; 4], kinds: &[Kind]) {
        let s = struck(material, velocity).unwrap();
        let found = [s.strain.engineering, s.inflow_velocity, s.tension, s.kink_speed_lagrangian];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 2e-15, "{velocity}: {found} {expected}");
        }
        let wave = s.wave(material);
        let found: Vec<Kind> = wave.pieces().iter().map(|piece| piece.kind).collect();
        assert_eq!(found, kinds, "{velocity}");
        assert_eq!(wave.strain_at(s.tail_speed * 0.999), s.strain.engineering);
    }
    use Kind::{Fan, Shock};
    check(
        &exponential_hardening(),
        411.3,
        [
            0.016_935_784_181_869_91,
            108.020_327_836_367_7,
            944_796_220.606_866_6,
            823.106_574_947_628_4,
        ],
        &[Shock],
    );
    check(
        &exponential_softening(),
        411.3,
        [
            0.020_078_725_946_670_82,
            112.875_100_501_622_13,
            872_867_606.117_448_1,
            789.934_542_057_876_2,
        ],
        &[Fan],
    );
    check(
        &softening(),
        411.3,
        [
            0.017_530_311_510_914_496,
            108.977_769_976_997_04,
            929_858_407.070_294_2,
            816.335_146_987_487_2,
        ],
        &[Fan],
    );
    check(
        &concave_convex(),
        411.3,
        [
            0.019_814_371_978_464_403,
            112.299_751_995_476_7,
            880_807_127.883_990_6,
            793.621_835_183_141_2,
        ],
        &[Fan],
    );
    check(
        &concave_convex(),
        1113.7,
        [
            0.072_345_812_343_119_65,
            430.195_853_469_433_3,
            3_509_751_391.144_797,
            1_544.914_713_520_281,
        ],
        &[Fan, Shock],
    );
    check(
        &convex_concave(),
        411.3,
        [
            0.016_850_257_625_716_8,
            107.876_710_657_139_9,
            947_068_347.357_322_3,
            824.130_375_477_320_8,
        ],
        &[Shock],
    );
    check(
        &convex_concave(),
        1381.3,
        [
            0.074_055_460_702_483_56,
            536.643_627_183_891_7,
            5_344_770_133.963_366,
            1_904.955_891_591_413_8,
        ],
        &[Shock, Fan],
    );
    check(
        &twice_inflected(),
        881.3,
        [
            0.068_214_121_621_552_86,
            334.590_703_598_816,
            2_263_803_672.993_485_3,
            1_243.151_289_000_793_4,
        ],
        &[Fan, Shock, Fan],
    );
    check(
        &exponential_hardening(),
        1e-3,
        [
            6.115_467_849_631_326e-10,
            3.516_374_394_230_739e-6,
            27.726_369_492_265_268,
            0.142_193_670_548_567_15,
        ],
        &[Shock],
    );
    check(
        &concave_convex(),
        1e-3,
        [
            4.979_832_982_507_994e-10,
            3.340_343_423_85e-6,
            30.725_569_221_848_602,
            0.149_686_878_040_164_42,
        ],
        &[Fan],
    );
}

#[test]
fn impact_faster_than_the_kink_allows_is_refused_at_the_right_velocity() {
    // V at T = λT′, to 40 digits in another language; V is nearly stationary nowhere, so a few
    // roundings, and those of the greatest strain.
    for (law, expected) in
        [(softening(), 1_005.182_194_217_913), (convex_concave(), 1_485.332_138_513_142_4)]
    {
        assert!((limit(&law) / expected - 1.0).abs() < 1e-14, "{}", limit(&law));
        assert!(struck(&law, 0.999_99 * expected).is_ok());
        let error = struck(&law, 1.000_01 * expected).unwrap_err();
        assert_eq!(error, SmithError::KinkOvertakes { limit: limit(&law) });
    }
    for bad in [-3.1, f64::NAN, f64::INFINITY] {
        let error = struck(&softening(), bad).unwrap_err();
        assert!(matches!(error, SmithError::Input { name: "velocity", .. }), "{error:?}");
    }
    let rest = struck(&concave_convex(), 0.0).unwrap();
    assert_eq!((rest.strain.engineering, rest.tension, rest.kink_speed), (0.0, 0.0, 0.0));
}

#[test]
fn two_laws_with_closed_forms_are_the_same_in_units_of_their_fibre() {
    let fibre = Fibre { modulus: 58.6e9, density: 1206.7, area: 1.37e-8 };
    for law in LAWS {
        for velocity in [0.37, 411.3, 9_713.0] {
            let s = struck(&Hyperelastic { law, fibre }, velocity).unwrap();
            let unit = smith(law, fibre.wave_speed(), velocity).unwrap();
            for (found, expected) in [
                (s.strain.engineering, unit.strain.engineering),
                (s.tension, unit.tension * 58.6e9),
                (s.inflow_velocity, unit.inflow_velocity),
                (s.kink_speed, unit.kink_speed),
                (s.angle_sine, unit.angle_sine),
                (s.tail_speed, unit.tail_speed),
            ] {
                // c is rounded in the one and not in the other.
                assert!((found / expected - 1.0).abs() < 3e-15, "{law:?}: {found} {expected}");
            }
        }
    }
    // No limit but the greatest double, where W and U overflow.
    let engineering = Hyperelastic { law: Law::Engineering, fibre };
    assert_eq!(limit(&engineering), f64::INFINITY);
    assert!(struck(&engineering, 37.1 * fibre.wave_speed()).is_ok());
}

/// Residuals of every jump condition at the kink, each over its largest term.
fn residuals(rho: f64, s: &Smith, v: f64) -> [(&'static str, f64); 7] {
    let (w, u, lambda) = (s.inflow_velocity, s.kink_speed_lagrangian, s.strain.stretch());
    let (cosine, sine, tension) = (s.angle_cosine, s.angle_sine, s.tension);
    // 1 − cos γ without cancellation, from the sine.
    let turn = sine * sine / (1.0 + cosine);
    let over = |terms: &[f64]| {
        terms.iter().sum::<f64>() / terms.iter().fold(0.0_f64, |m, t| m.max(t.abs()))
    };
    [
        ("position along", over(&[lambda * u * turn, -w])),
        ("position across", over(&[v, -lambda * u * sine])),
        ("kink in the laboratory", over(&[s.kink_speed, w, -lambda * u])),
        ("momentum along", over(&[tension * turn, -rho * u * w])),
        ("momentum across", over(&[tension * sine, -rho * u * v])),
        ("energy", over(&[tension * sine * v, -tension * w, rho * u * (w * w - v * v) / 2.0])),
        ("direction", over(&[cosine * cosine, sine * sine, -1.0])),
    ]
}

/// V from 1e-3 m/s to 1.5 c or the limit, evenly in the logarithm.
fn velocity(material: &impl Elastic, part: f64) -> f64 {
    let c = (material.tangent_modulus(0.0) / material.density()).sqrt();
    let last = limit(material).min(1.5 * c);
    1e-3 * f_exp(part * f_log(last / 1e-3))
}

fn check(material: &impl Elastic, part: f64, tolerance: f64) -> Result<(), TestCaseError> {
    let v = velocity(material, part * 0.999_999);
    let s = struck(material, v).map_err(|error| TestCaseError::fail(error.to_string()))?;
    for (name, residual) in residuals(material.density(), &s, v) {
        prop_assert!(residual.abs() < tolerance, "{name} at {v}: {residual:e}");
    }
    prop_assert!(s.kink_speed > 0.0);
    prop_assert!(s.kink_speed_lagrangian <= s.tail_speed * (1.0 + 100.0 * tolerance), "{s:?}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn kink_of_any_polynomial_satisfies_every_jump_condition(
        law in any_polynomial(),
        part in 0.0..1.0_f64,
    ) {
        // The terms of T may be a hundred times their sum, those of T′ a thousand times.
        check(&law, part, 1e-13)?;
    }

    #[test]
    fn kink_of_any_exponential_law_satisfies_every_jump_condition(
        rho in 317.0..7.3e3_f64,
        modulus in 1.7e6..2.3e11_f64,
        b in prop_oneof![-63.1..-0.01_f64, 0.01..63.1_f64],
        part in 0.0..1.0_f64,
    ) {
        // Some ten roundings.
        check(&Exponential::new(rho, modulus / b, b).unwrap(), part, 5e-15)?;
    }

    #[test]
    fn impact_velocity_of_any_law_increases_with_strain(
        law in any_polynomial(),
        part in 0.0..1.0_f64,
    ) {
        let strain = part * law.greatest_strain().min(0.0997);
        let (low, high) = (velocity_at(&law, 0.999 * strain), velocity_at(&law, strain));
        // From V² = W(2λU − W): d ln V > ½ d ln W · (1 − W/λU) ≥ 0. A thousandth of strain is 1e-3
        // of V but for the factor T′/T̂′, and far more than rounding.
        prop_assert!(high > low * (1.0 + 1e-9), "{strain}: {low} {high}");
    }
}

#[test]
fn law_that_yields_and_stiffens_ends_where_its_kink_first_catches_the_fan() {
    // Convex from ε = 0.1 on, where T′ is a fiftieth of E₁ and T/λ a thirtieth; far beyond, the kink
    // is slower than the shock again.
    let law = Polynomial::new(DENSITY, &[58.6e9, -5.74e11, 1.9133e12]).unwrap();
    let s = struck(&law, 0.999 * limit(&law)).unwrap();
    assert!(s.strain.engineering < 0.1 && s.wave(&law).pieces().len() == 1, "{s:?}");
    assert!(law.kink_speed(0.1) > law.wave_speeds(0.0, 0.1).1);
    assert!(law.kink_speed(0.37) < law.wave_speeds(0.0, 0.37).1);
    assert!(matches!(struck(&law, 1.001 * limit(&law)), Err(SmithError::KinkOvertakes { .. })));
}
