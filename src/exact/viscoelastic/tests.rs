use proptest::prelude::*;

use super::super::dalembert::Pull;
use super::super::gauss::integral;
use super::*;

mod balances;
mod characteristics;

const VELOCITY: f64 = 17.3;

fn arm(modulus: f64, relaxation_time: f64) -> Arm {
    Arm { modulus, relaxation_time }
}

/// A standard linear solid.
fn solid() -> PulledRod {
    PulledRod::new(1390.0, 3.1e9, &[arm(5.7e9, 1.3e-5)], VELOCITY).unwrap()
}

/// Three arms, their times three decades apart.
fn three_arms() -> PulledRod {
    let arms = [arm(23e9, 2.3e-6), arm(11.3e9, 0.71e-4), arm(4.7e9, 3.7e-3)];
    PulledRod::new(970.0, 1.9e9, &arms, VELOCITY).unwrap()
}

/// Two arms without a spring.
fn fluid() -> PulledRod {
    PulledRod::new(970.0, 0.0, &[arm(23e9, 2.3e-6), arm(11.3e9, 0.71e-4)], VELOCITY).unwrap()
}

/// The greatest relative difference of stress, strain and velocity.
fn difference(found: RodState, expected: RodState) -> f64 {
    let part = |a: f64, b: f64| (a / b - 1.0).abs();
    let parts = [
        part(found.stress, expected.stress),
        part(found.strain, expected.strain),
        part(found.velocity, expected.velocity),
    ];
    // In the order of `total_cmp` what is no number is the greatest.
    parts.into_iter().max_by(f64::total_cmp).unwrap()
}

#[test]
fn states_inverted_with_a_hundred_digits_are_found() {
    // Talbot's contour, 150 points, 100 decimals, in another language; 90 points with 60 decimals
    // gave the same 40 digits. Tolerance: a term e^φ is rounded by |φ| ulp, here up to 100, and
    // t − x/c by an ulp of t; 1.2e-15 as seen.
    let states: [(PulledRod, f64, f64, [f64; 3]); 17] = [
        (solid(), 0.0, 3.7e-6, [55541914.87859509, 0.007465400778893824, 17.3]),
        (solid(), 0.0173, 7.1e-6, [50774591.83929533, 0.005834278409331385, 14.598651075607968]),
        (solid(), 0.0173, 4.3e-4, [35911565.6543487, 0.011584330450671155, 17.299987228470343]),
        (solid(), 0.237, 1.1e-4, [11650494.115331043, 0.00197846964772819, 4.095073653724387]),
        (solid(), 0.237, 1.55e-4, [23861900.21783063, 0.00577658176892916, 10.038131807987842]),
        (solid(), 0.237, 1.9e-4, [29322762.409415845, 0.008008180076385856, 13.083196968103705]),
        (solid(), 1.31, 6.1e-4, [428550.03960991325, 8.354723841554547e-5, 0.16082561167665219]),
        (solid(), 1.31, 8.7e-4, [19988015.94829782, 0.005674135008604458, 9.049513248431587]),
        (three_arms(), 0.0, 5.3e-5, [59639984.46441651, 0.00475467175421128, 17.3]),
        (
            three_arms(),
            0.0131,
            2.9e-6,
            [80744847.10422806, 0.0023838937396690307, 14.115009982879688],
        ),
        (
            three_arms(),
            0.0131,
            7.7e-3,
            [28109448.20743645, 0.009735494422115847, 17.296573823689695],
        ),
        (
            three_arms(),
            0.391,
            9.1e-5,
            [30128053.33973692, 0.0016075327135117825, 7.094934509952874],
        ),
        (
            three_arms(),
            0.391,
            1.63e-3,
            [38226770.58409306, 0.007286075748816031, 17.090448918761982],
        ),
        (fluid(), 0.0, 5.3e-5, [41611578.70662795, 0.0065266088228053045, 17.3]),
        (fluid(), 0.0131, 7.7e-3, [3210650.983208433, 0.05755824162276111, 17.251033154887576]),
        (fluid(), 0.391, 9.1e-5, [6081582.32087253, 0.0004144251810061938, 1.6206733847702994]),
        (fluid(), 0.391, 1.63e-3, [6861007.14564442, 0.019825855616283205, 14.175245691176423]),
    ];
    for (rod, x, t, [stress, strain, velocity]) in states {
        let error = difference(rod.at(x, t).unwrap(), RodState { stress, strain, velocity });
        assert!(error < 5e-15, "x = {x}, t = {t}: {error:e}");
    }
}

/// A Maxwell rod by both routes; x in units of cτ, t in units of τ after the front.
fn both_routes(x: f64, since: f64) -> (RodState, RodState) {
    let (density, modulus, relaxation_time, velocity) = (1271.0, 7.9e9, 3.7e-4, -VELOCITY);
    let closed = Maxwell { density, modulus, relaxation_time, velocity };
    let rod = PulledRod::new(density, 0.0, &[arm(modulus, relaxation_time)], velocity).unwrap();
    let x = x * relaxation_time * rod.front_speed();
    let t = x / rod.front_speed() + since * relaxation_time;
    (rod.at(x, t).unwrap(), closed.at(x, t).unwrap())
}

#[test]
fn inversion_agrees_with_the_closed_form_of_a_maxwell_rod() {
    // Nothing is shared but the units. Relative to the state itself, down to e⁻⁴⁵⁵ of ρcv₀; the
    // tolerance is the rounding of t, which counts most just behind a far front, where
    // ∂ ln σ/∂t = ⅛X/τ², so ⅛(X/τ)² ulp; elsewhere 9e-15 as seen.
    for x in [0.0, 1.3e-7, 0.0131, 0.71, 3.7, 23.9, 91.0, 910.0] {
        for since in [1.7e-9, 0.0137, 0.53, 2.9, 17.3, 211.0, 7.3e3] {
            let (found, expected) = both_routes(x, since);
            let error = difference(found, expected);
            let tolerance = 2e-14 + 0.125 * x * x * f64::EPSILON;
            assert!(error < tolerance, "{x} {since}: {error:e}");
        }
    }
}

#[test]
fn front_is_the_limit_of_the_states_behind_it_and_rest_is_ahead() {
    for rod in [solid(), three_arms(), fluid()] {
        for x in [0.0, 0.0173, 0.131] {
            let front = rod.front(x);
            // ρc[v] = [σ] = E₀[ε]: products of the same factors.
            let ratio = rod.density * rod.front_speed();
            assert!((front.stress / (ratio * front.velocity) - 1.0).abs() < 1e-15);
            assert!((front.stress / (rod.glassy_modulus * front.strain) - 1.0).abs() < 1e-15);

            let arrival = x / rod.front_speed();
            assert_eq!(rod.at(x, arrival).unwrap(), front);
            if x > 0.0 {
                assert_eq!(rod.at(x, arrival.next_down()).unwrap(), RodState::REST);
            }
            // The first-order change after the front is below T(1 + aX)a with a = 1/τ of the
            // fastest arm, 4.4e5/s: at most 2e-13 for T = 2.7e-20 s, which X + T rounds to 0 or a
            // few ulp of X, 7e-21 s.
            for since in [2.7e-20, 1.3e-21] {
                let error = difference(rod.at(x, arrival + since).unwrap(), front);
                assert!(error < 3e-13, "{x}: {error:e}");
            }
        }
    }
}

#[test]
fn closed_form_starts_at_the_front() {
    // e^(−bX), I₀(0) = 1 and integrals over nothing, but for the rounding of exponents.
    let (density, modulus, relaxation_time) = (1271.0_f64, 7.9e9_f64, 3.7e-4);
    let closed = Maxwell { density, modulus, relaxation_time, velocity: VELOCITY };
    let rod = PulledRod::new(density, 0.0, &[arm(modulus, relaxation_time)], VELOCITY).unwrap();
    let x = 1.37;
    let arrival = x / rod.front_speed();
    assert!(difference(closed.at(x, arrival).unwrap(), rod.front(x)) < 1e-15);
    assert_eq!(closed.at(x, arrival.next_down()).unwrap(), RodState::REST);
}

#[test]
fn closed_form_starts_at_the_end_of_the_rod() {
    // At x = 0 and t = 0 the front has just been made: σ = ρcv₀, ε = v₀/c.
    let rod = Maxwell { density: 1271.0, modulus: 7.9e9, relaxation_time: 3.7e-4, velocity: 1.7 };
    let found = rod.at(0.0, 0.0).unwrap();
    let wave_speed = (7.9e9 / 1271.0_f64).sqrt();
    let (stress, strain) = (1271.0 * wave_speed * 1.7, 1.7 / wave_speed);
    assert_eq!(found, RodState { stress, strain, velocity: 1.7 });
}

#[test]
fn slow_relaxation_leaves_the_elastic_rod_of_the_glassy_modulus() {
    // To first order in t/τ the wave loses at most half of that, and the strain gains as much.
    let (density, modulus) = (1390.0, 8.8e9);
    for slow in [1.7e3, 1.7e9, 1.7e59] {
        let rod = PulledRod::new(density, 3.1e9, &[arm(5.7e9, slow)], VELOCITY).unwrap();
        let wave_speed = rod.front_speed();
        let elastic = Pull { length: 7.0, wave_speed, velocity: VELOCITY };
        for (x, t) in [(0.0, 1.3e-4), (0.0173, 7.1e-6), (0.237, 9.51e-5), (0.237, 7.3e-4)] {
            let (strain, velocity) = (elastic.strain(x, t), elastic.velocity(x, t));
            let expected = RodState { stress: modulus * strain, strain, velocity };
            let error = difference(rod.at(x, t).unwrap(), expected);
            assert!(error < 0.5 * t / slow + 1e-15, "{slow:e} {x} {t}: {error:e}");
        }
    }
    let rod = PulledRod::new(density, modulus, &[], VELOCITY).unwrap();
    let velocity = |x| rod.at(x, 1.3e-4).unwrap().velocity;
    assert_eq!((velocity(0.0), velocity(0.327), velocity(0.3272)), (VELOCITY, VELOCITY, 0.0));
}

#[test]
fn fast_relaxation_leaves_the_elastic_rod_of_the_equilibrium_modulus() {
    // Away from x = c∞t by many widths √(κx/c∞), κ = E₁τ/E∞, what differs is below e⁻²⁰⁰; even in
    // the widest wave here, 1.9 μs, 47 μs ahead of it and 40 μs ahead are 25 and 20 widths. Left is
    // rounding by |φ| ulp a term, up to 2e4 at t/τ = 6e7, averaged: 1.2e-14 as seen.
    let (density, spring) = (1390.0_f64, 3.1e9_f64);
    for fast in [1.3e-8, 1.3e-10, 1.3e-11] {
        let rod = PulledRod::new(density, spring, &[arm(5.7e9, fast)], VELOCITY).unwrap();
        let wave_speed = (spring / density).sqrt();
        let elastic = Pull { length: 7.0, wave_speed, velocity: VELOCITY };
        for (x, t) in [(0.0173, 1.7e-5), (0.237, 1.99e-4), (0.237, 7.3e-4)] {
            let (strain, velocity) = (elastic.strain(x, t), elastic.velocity(x, t));
            let expected = RodState { stress: spring * strain, strain, velocity };
            let error = difference(rod.at(x, t).unwrap(), expected);
            assert!(error < 5e-14, "{fast:e} {x} {t}: {error:e}");
        }
        let ahead = rod.at(0.237, 1.13e-4).unwrap().velocity;
        assert_eq!(elastic.velocity(0.237, 1.13e-4), 0.0);
        assert!(ahead.abs() < 1e-80 * VELOCITY, "{fast:e}: {ahead:e}");
    }
}

#[test]
fn late_wave_of_the_standard_linear_solid_spreads_like_an_error_function() {
    // The times at which the velocity arrives at x have the cumulants that s → 0 gives: with
    // κ = E₁τ/E∞, k = s/c∞ (1 − κs/2 + (κτ/2 + 3κ²/8)s² − …), so the mean x/c∞, the variance
    // κx/c∞ and the third cumulant (3κτ + 9κ²/4)x/c∞. To that order (Edgeworth), at
    // z = (t − x/c∞)/√(κx/c∞),
    //     v/v₀ = ½ erfc(−z/√2) − γ(z² − 1)e^(−z²/2)/(6√(2π)),    γ = third/variance^(3/2).
    // Without the last term the error falls like 1/√x, with it like 1/x: at most
    // 0.23 κc∞/x as seen.
    let (tau, slow) = (1.3e-5, (3.1e9 / 1390.0_f64).sqrt());
    let spread = 5.7e9 * tau / 3.1e9;
    for x in [3.7, 370.0, 37e3] {
        let (path, rod) = (x / slow, solid());
        let width = (spread * path).sqrt();
        let skewness = (3.0 * spread * tau + 2.25 * spread * spread) * path / width.powi(3);
        for z in [-1.7, -0.3, 0.0, 0.9, 2.1_f64] {
            let found = rod.at(x, path + z * width).unwrap().velocity / VELOCITY;
            let bell = pxfm::f_exp(-0.5 * z * z) / (2.0 * std::f64::consts::PI).sqrt();
            let expected =
                0.5 * pxfm::f_erfc(-z / 2.0_f64.sqrt()) - skewness / 6.0 * (z * z - 1.0) * bell;
            let error = (found - expected).abs();
            assert!(error < 0.3 * spread / path, "{x} {z}: {error:e}");
        }
    }
}

#[test]
fn end_stress_of_the_maxwell_rod_decays_like_the_root_of_time() {
    // e^(−z)I₀(z) = (1 + 1/(8z) + 9/(128z²) + …)/√(2πz) at z = t/2τ: with θ = t/τ,
    // σ = ρcv₀/√(πθ) (1 + 1/(4θ) + 9/(32θ²) + …). The terms left out are below 0.32/θ².
    for since in [31.0, 731.0, 7.3e4] {
        let (found, closed) = both_routes(0.0, since);
        let glassy = -(1271.0_f64 * 7.9e9).sqrt() * VELOCITY;
        let expected = glassy / (std::f64::consts::PI * since).sqrt() * (1.0 + 0.25 / since);
        for stress in [found.stress, closed.stress] {
            let error = stress / expected - 1.0;
            assert!(error.abs() < 0.32 / (since * since) + 1e-14, "{since}: {error:e}");
        }
    }
}

#[test]
fn late_maxwell_rod_diffuses_and_its_closed_form_does_not_overflow() {
    // k = √(s/τ)/c (1 + τs/2 − τ²s²/8 …); with p = X/√(4τt),
    //     v/v₀ = erfc p − (τ/t) p(2p² − 1) e^(−p²)/(2√π) + O(τ²/t²);
    // the term left out is at most 11 (τ/t)² of v as seen.
    let rod = Maxwell { density: 1271.0, modulus: 7.9e9, relaxation_time: 3.7e-4, velocity: 1.7 };
    let wave_speed = (7.9e9 / 1271.0_f64).sqrt();
    for since in [7.3e2, 7.3e5, 7.3e12_f64] {
        for place in [0.0131, 0.31, 1.7] {
            let x = place * 3.7e-4 * (4.0 * since).sqrt() * wave_speed;
            let found = rod.at(x, 3.7e-4 * since).unwrap().velocity;
            let gauss = pxfm::f_exp(-place * place) / (4.0 * std::f64::consts::PI).sqrt();
            let term = place * (2.0 * place * place - 1.0) * gauss;
            let error = found / (1.7 * (pxfm::f_erfc(place) - term / since)) - 1.0;
            assert!(error.abs() < 20.0 / (since * since) + 1e-14, "{since} {place}: {error:e}");
        }
    }
}

#[test]
fn ten_million_relaxation_times_are_within_reach_and_ten_milliards_are_an_error() {
    // σ → ρc∞v₀ and v → v₀ far behind both fronts; tolerance: |φ| ulp a term, averaged over 10⁵.
    let rod = solid();
    let state = rod.at(0.237, 130.0).unwrap();
    assert!((state.velocity / VELOCITY - 1.0).abs() < 5e-14, "{state:?}");
    let expected = (3.1e9_f64 * 1390.0).sqrt() * VELOCITY;
    assert!((state.stress / expected - 1.0).abs() < 5e-14, "{state:?}");
    let late = rod.at(0.237, 1.3e5);
    assert!(matches!(late, Err(RodError::Unsettled { .. })), "{late:?}");
    assert!(late.unwrap_err().to_string().contains("too late a time"));
}

#[test]
fn inputs_out_of_range_are_refused_by_name() {
    let refused = |result: Result<PulledRod, RodError>, expected: &str| match result {
        Err(RodError::Input { name, .. }) => assert_eq!(name, expected),
        other => panic!("{other:?}"),
    };
    let arms = [arm(5.7e9, 1.3e-5)];
    refused(PulledRod::new(-1390.0, 3.1e9, &arms, 1.7), "density");
    refused(PulledRod::new(1390.0, -3.1e9, &arms, 1.7), "equilibrium modulus");
    refused(PulledRod::new(1390.0, 0.0, &[], 1.7), "equilibrium modulus");
    refused(PulledRod::new(1390.0, 3.1e9, &[arm(0.0, 1.3e-5)], 1.7), "modulus");
    refused(PulledRod::new(1390.0, 3.1e9, &[arm(5.7e9, f64::INFINITY)], 1.7), "relaxation time");
    refused(PulledRod::new(1390.0, 3.1e9, &arms, f64::NAN), "velocity");
    let rod = solid();
    for (x, t, expected) in [(-0.1, 1.3e-4, "x"), (0.1, f64::NAN, "t")] {
        let error = rod.at(x, t).unwrap_err();
        assert!(matches!(error, RodError::Input { name, .. } if name == expected), "{error}");
    }
    let still = PulledRod::new(1390.0, 3.1e9, &arms, 0.0).unwrap();
    assert_eq!(still.at(0.1, 1.3e-4).unwrap(), RodState::REST);
}

/// Density, spring, arms: fractions of a modulus and times, over decades.
fn any_material() -> impl Strategy<Value = (f64, f64, Vec<(f64, f64)>)> {
    let arms = prop::collection::vec((-2.3..0.3_f64, -9.1..-2.7_f64), 1..6);
    (700.0..8000.0_f64, prop_oneof![Just(0.0), 0.001..2.0_f64], arms)
}

/// The speeds of fronts without the arms that relax first, as shares of that of the front.
fn layers(spring: f64, mut arms: Vec<(f64, f64)>) -> Vec<f64> {
    arms.sort_by(|a, b| b.1.total_cmp(&a.1));
    let moduli = arms.iter().map(|(share, _)| pxfm::f_exp10(*share));
    let sums: Vec<f64> = std::iter::once(spring)
        .chain(moduli.scan(spring, |sum, modulus| {
            *sum += modulus;
            Some(*sum)
        }))
        .collect();
    sums[..arms.len()].iter().map(|sum| (sum / sums[arms.len()]).sqrt()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_rod_balances_length_and_momentum_and_its_velocity_falls_outwards(
        (density, spring, arms) in any_material(),
        duration in -9.7..-2.9_f64,
    ) {
        let power = |exponent: f64| pxfm::f_exp10(exponent);
        let of: Vec<Arm> =
            arms.iter().map(|&(share, time)| arm(13.7e9 * power(share), power(time))).collect();
        let rod = PulledRod::new(density, 13.7e9 * spring, &of, VELOCITY).unwrap();
        let t = power(duration);
        // Tolerance: rounding; 2e-13 is the worst of 300, at a million relaxation times.
        let (length, momentum) = balances::unbalanced(&rod, density, t, &layers(spring, arms));
        prop_assert!(length < 1e-12 && momentum < 1e-12, "{length:e} {momentum:e}");

        // v/v₀ is the share of the pull that has arrived: from 1 at the end to what the front has
        // left. Tolerance: rounding, relative to 1.
        let moving = |i: u32| rod.at(f64::from(i) / 17.3 * rod.front_speed() * t, t);
        let velocities: Vec<f64> = (0..=17).map(|i| moving(i).unwrap().velocity).collect();
        prop_assert!((velocities[0] / VELOCITY - 1.0).abs() < 1e-13);
        prop_assert!(velocities.windows(2).all(|pair| pair[1] < pair[0] + 1e-13 * VELOCITY));
    }

    #[test]
    fn arm_may_be_divided_and_arms_may_change_places(
        (density, spring, arms) in any_material(),
        share in 0.01..0.99_f64,
        place in 0.0..1.1_f64,
        duration in -9.7..-2.9_f64,
    ) {
        let power = |exponent: f64| pxfm::f_exp10(exponent);
        let whole: Vec<Arm> = arms
            .iter()
            .map(|&(part, time)| arm(13.7e9 * power(part), power(time)))
            .collect();
        let mut divided = whole.clone();
        divided.reverse();
        divided[0].modulus *= share;
        divided.push(arm(whole[whole.len() - 1].modulus * (1.0 - share), divided[0].relaxation_time));
        let state = |arms: &[Arm]| {
            let rod = PulledRod::new(density, 13.7e9 * spring, arms, VELOCITY).unwrap();
            let t = power(duration);
            rod.at(place * rod.front_speed() * t, t).unwrap()
        };
        let (one, other) = (state(&whole), state(&divided));
        if one != RodState::REST {
            // The order of the sums moves c by an ulp, and X and T with it; 2e-13 is the worst of 300.
            // What has decayed to e^(-p) feels p times the roundings of its exponent: 8e-15 p, seen at
            // p = 160.
            let decay = -pxfm::f_log((one.velocity / VELOCITY).abs());
            prop_assert!(difference(other, one) < 1e-12 + 2e-14 * decay, "{one:?} {other:?}");
        }
    }
}
