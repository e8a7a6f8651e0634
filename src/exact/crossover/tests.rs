use proptest::prelude::*;
use pxfm::{f_exp, f_exp10, f_log};

use super::super::quadrature::integral;
use super::*;

const LAWS: [Law; 2] = [Law::Engineering, Law::Logarithmic];
const ARAMID: Fibre = Fibre { modulus: 58.6e9, density: 1206.7, area: 1.37e-8 };

#[test]
fn coefficients_of_the_scene_of_figure_3_are_found() {
    // From an independent solution printed to so many decimals: half a unit of the last one.
    let found = crossover(Law::Engineering, &ARAMID, &ARAMID, 1.0, 400.0).unwrap().engineering;
    assert!((found.reflection - 0.0440).abs() < 0.5e-4, "{found:?}");
    assert!((found.transmission - 0.9560).abs() < 0.5e-4, "{found:?}");
    assert!((found.diversion - 0.1467).abs() < 0.5e-4, "{found:?}");
    let found = crossover(Law::Logarithmic, &ARAMID, &ARAMID, 1.0, 400.0).unwrap().engineering;
    assert!((found.transmission - 0.95553).abs() < 0.5e-5, "{found:?}");
    assert!((found.diversion - 0.14628).abs() < 0.5e-5, "{found:?}");
}

#[test]
fn unequal_fibres_that_slide_agree_with_a_solution_to_40_digits() {
    // Nested secant iterations on u, in another language, with the waves by quadrature:
    // u in m/s, then R, T, D in engineering and in logarithmic strain. Tolerance: R magnifies
    // the twenty or so roundings by W/(W − u), 13 here.
    for (law, u, expected) in [
        (
            Law::Engineering,
            96.406_738_539_744_53,
            [
                [0.078_938_411_460_893_19, 0.921_061_588_539_106_8, 0.103_422_621_589_561_61],
                [0.078_307_179_014_480_98, 0.921_601_296_191_569_4, 0.104_116_548_205_358_66],
            ],
        ),
        (
            Law::Logarithmic,
            96.475_343_585_049_8,
            [
                [0.079_831_830_587_699_04, 0.920_215_531_982_983_4, 0.103_049_982_179_811_03],
                [0.079_189_716_502_780_68, 0.920_763_273_986_989_7, 0.103_745_212_698_699_4],
            ],
        ),
    ] {
        let secondary = Fibre { modulus: 91.3e9, density: 1_713.0, area: 2.91e-8 };
        let found = crossover(law, &ARAMID, &secondary, 0.83, 411.3).unwrap();
        assert!((found.junction_speed / u - 1.0).abs() < 2e-15, "{law:?}: {found:?}");
        for (found, expected) in [found.engineering, found.logarithmic].iter().zip(expected) {
            let Coefficients { reflection, transmission, diversion } = *found;
            for (found, expected) in [reflection, transmission, diversion].iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < 5e-15, "{law:?}: {found} {expected}");
            }
        }
    }
}

#[test]
fn equal_fibres_without_sliding_share_the_power_as_the_algebra_says() {
    // ε law, α_s = 1, equal fibres: R = s/(1 + s), T = 1/(1 + s), R² + T² + 2sT² = 1 with
    // s = √(ε₂/(1 + ε₂)). A few roundings.
    for velocity in [0.37, 411.3, 3_907.0] {
        let found = crossover(Law::Engineering, &ARAMID, &ARAMID, 1.0, velocity).unwrap();
        let e2 = found.diverted.strain.engineering;
        let s = (e2 / (1.0 + e2)).sqrt();
        let Coefficients { reflection: r, transmission: t, .. } = found.engineering;
        assert!((r * (1.0 + s) / s - 1.0).abs() < 1e-15, "{velocity}: R {r}");
        assert!((t * (1.0 + s) - 1.0).abs() < 1e-15, "{velocity}: T {t}");
        assert!((r * r + t * t + 2.0 * s * t * t - 1.0).abs() < 1e-15, "{velocity}");
    }
}

#[test]
fn sliding_weakens_the_crossover_by_its_small_strain_powers() {
    // D ~ α_s^{4/3} and R ~ α_s^{8/3}. The corrections are of the order of R and √ε₂, below
    // 1e-3 at α_s = 0.02, where √ε₂ changes by 4e-4 from one α_s to the other; the slope over
    // a factor of 2 sees that over ln 2.
    for law in LAWS {
        let at = |slide| crossover(law, &ARAMID, &ARAMID, slide, 411.3).unwrap().engineering;
        let (weak, strong) = (at(0.013), at(0.026));
        let slope = |a: f64, b: f64| (b / a).log2();
        let d = slope(weak.diversion, strong.diversion);
        let r = slope(weak.reflection, strong.reflection);
        assert!((d - 4.0 / 3.0).abs() < 2e-3, "{law:?}: {d}");
        assert!((r - 8.0 / 3.0).abs() < 2e-3, "{law:?}: {r}");
    }
}

#[test]
fn free_sliding_leaves_the_incident_wave_alone() {
    for law in LAWS {
        let free = crossover(law, &ARAMID, &ARAMID, 0.0, 411.3).unwrap();
        let nothing = Coefficients { reflection: 0.0, transmission: 1.0, diversion: 0.0 };
        for found in [free.engineering, free.logarithmic] {
            assert_eq!((found.reflection, found.diversion), (0.0, 0.0));
            // ε from W from ε: four roundings.
            assert!((found.transmission - nothing.transmission).abs() < 1e-15, "{found:?}");
        }
    }
}

#[test]
fn heavy_secondary_holds_the_junction_and_doubles_the_strain() {
    // As α_s²ρ₂A₂ grows, u → 0: the junction becomes a clamp, where W(λ_b) = 2W_i.
    let heavy = Fibre { area: 1.37e12, ..ARAMID };
    for law in LAWS {
        let held = crossover(law, &ARAMID, &heavy, 1.0, 411.3).unwrap();
        let w = held.incident.inflow_velocity / ARAMID.wave_speed();
        // The clamp's strain by hand: 2w, or (1 + w)² − 1 = w(2 + w); u is a 1e-12 of W here.
        let clamp = if law == Law::Engineering { 2.0 * w } else { w * (2.0 + w) };
        assert!(held.engineering.transmission < 1e-11, "{law:?}: {held:?}");
        assert!((held.reflected.engineering / clamp - 1.0).abs() < 1e-11, "{law:?}");
    }
}

#[test]
fn what_has_no_solution_is_refused_with_its_reason() {
    for bad in [-0.1, 1.000_1, f64::NAN] {
        let error = crossover(Law::Engineering, &ARAMID, &ARAMID, bad, 411.3).unwrap_err();
        assert!(matches!(error, SmithError::Input { name: "slide factor", .. }), "{error}");
    }
    let bad = Fibre { area: 0.0, ..ARAMID };
    let error = crossover(Law::Engineering, &ARAMID, &bad, 0.7, 411.3).unwrap_err();
    assert_eq!(error, SmithError::Input { name: "area", value: 0.0 });
    // A slow, light secondary dragged along at 77 m/s, 2.4 times its wave speed.
    let slow = Fibre { modulus: 1.2e6, area: 1e-13, ..ARAMID };
    assert!(crossover(Law::Engineering, &ARAMID, &slow, 1.0, 411.3).is_ok());
    let error = crossover(Law::Logarithmic, &ARAMID, &slow, 1.0, 411.3).unwrap_err();
    let limit = velocity_limit(Law::Logarithmic, slow.wave_speed());
    assert_eq!(error, SmithError::KinkOvertakes { limit });
}

/// (T(λ_b) − T(λ_a))/E₁ from R alone, without cancellation: ε_b and ε_a lie symmetrically about
/// ε_i for the engineering law, √λ_b and √λ_a about √λ_i for the logarithmic.
fn tension_step(law: Law, found: &Crossover) -> f64 {
    let added = found.engineering.reflection * found.incident.strain.engineering;
    match law {
        Law::Engineering => 2.0 * added,
        Law::Logarithmic => {
            let root = found.incident.strain.stretch().sqrt();
            let delta = added / (root + found.reflected.stretch().sqrt());
            2.0 * f_log1p(2.0 * delta / (root - delta))
        }
    }
}

#[test]
fn whole_junction_balances_momentum_and_energy() {
    // Over a window that both waves of the primary stay in, per unit time: momentum towards the
    // impact point grows by the pull at the inner end less the drag of the secondary, energy by
    // the power at the inner end less what the secondary takes. The waves are integrated over
    // the ray coordinate ξ = X/t, inside a fan with λ = (c/ξ)². Units of c₁ and E₁A₁; the
    // tolerance is the rounding of the integrals.
    let secondary = Fibre { modulus: 91.3e9, density: 1_713.0, area: 2.91e-8 };
    for (law, slide, velocity) in [
        (Law::Engineering, 0.83, 411.3),
        (Law::Logarithmic, 0.83, 411.3),
        (Law::Logarithmic, 1.0, 9_371.0),
    ] {
        let found = crossover(law, &ARAMID, &secondary, slide, velocity).unwrap();
        let c = ARAMID.wave_speed();
        let (w, u) = (found.incident.inflow_velocity / c, found.junction_speed / c);
        // ∫ over the rays of one wave of f(strain), from `slow` (behind it) to `fast` (ahead).
        let wave = |behind: Strain, ahead: Strain, f: &dyn Fn(Strain) -> f64| {
            let (slow, fast) = (law.longitudinal_speed(behind), law.longitudinal_speed(ahead));
            let fan = if slow < fast {
                integral(slow, fast, |xi| f(Strain::from_engineering(1.0 / (xi * xi) - 1.0)))
            } else {
                0.0
            };
            f(behind) * slow + fan - f(ahead) * fast
        };
        let forward = |strain| law.particle_velocity(strain);
        let backward = |strain| 2.0 * w - law.particle_velocity(strain);
        let rest = Strain::from_engineering(0.0);
        let grown = |f: &dyn Fn(Strain, f64) -> f64| {
            wave(found.transmitted, rest, &|strain| f(strain, forward(strain)))
                + wave(found.reflected, found.incident.strain, &|strain| {
                    f(strain, backward(strain))
                })
        };
        let arms = 2.0 * secondary.modulus * secondary.area / (ARAMID.modulus * ARAMID.area);
        let force = arms * found.diverted.tension * found.diverted.angle_sine * slide;

        let scale = found.incident.tension + force;
        let momentum = grown(&|_, v| v);
        let pull = found.incident.tension - force;
        assert!((momentum - pull).abs() < 3e-15 * scale, "{law:?}: {momentum:e} {pull:e}");
        let energy = grown(&|strain, v| law.stored_energy(strain) + v * v / 2.0);
        let power = found.incident.tension * w - force * u;
        assert!((energy - power).abs() < 3e-15 * scale * w, "{law:?}: {energy:e} {power:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn junction_is_in_balance_everywhere(
        logarithmic in any::<bool>(),
        impact in 0.0..1.0_f64,
        (modulus, density, area) in (-4.0..4.0_f64, -3.0..3.0_f64, -2.0..2.0_f64),
        slide in -3.0..0.0_f64,
    ) {
        let law = LAWS[usize::from(logarithmic)];
        let primary = Fibre { modulus: 43.1e9, density: 1_317.0, area: 0.91e-8 };
        let secondary = Fibre {
            modulus: primary.modulus * f_exp10(modulus),
            density: primary.density * f_exp10(density),
            area: primary.area * f_exp10(area),
        };
        let (c1, c2) = (primary.wave_speed(), secondary.wave_speed());
        let slide = f_exp10(slide);
        // Velocities from 1e-3 m/s to 1.5 c, evenly in the logarithm.
        let velocity = 1e-3 * f_exp(impact * f_log(1.5e3 * c1));
        let found = match crossover(law, &primary, &secondary, slide, velocity) {
            Ok(found) => found,
            Err(error) => {
                // The only reason left, and then the free primary already is too fast for
                // this secondary: u ≤ W_i.
                let SmithError::KinkOvertakes { limit } = error else { panic!("{error}") };
                let inflow = smith(law, c1, velocity).unwrap().inflow_velocity;
                assert!(slide * inflow > limit, "{slide} {inflow} {limit}");
                return Ok(());
            }
        };
        let u = found.junction_speed;
        let w = found.incident.inflow_velocity;
        let close = |name: &str, a: f64, b: f64, ulps: f64, scale: f64| {
            assert!((a - b).abs() <= ulps * f64::EPSILON * scale, "{name}: {a:e} {b:e}");
        };
        // Tolerances: about four times the worst of 10⁵ cases, some ten roundings each; the
        // quadratures add 768 terms.

        // The secondary, struck anew at α_s·u.
        let struck = smith(law, c2, slide * u).unwrap();
        let (e2, again) = (found.diverted.strain.engineering, struck.strain.engineering);
        close("secondary", e2, again, 20.0, again);
        // Balance of force, F from the tension of two arms and their angle.
        let force = 2.0 * slide * secondary.modulus * secondary.area
            * struck.tension * struck.angle_sine / (primary.modulus * primary.area);
        close("force", tension_step(law, &found), force, 30.0, force);
        let step = law.tension(found.reflected) - law.tension(found.transmitted);
        close("force by levels", step, force, 20.0, force + found.incident.tension);
        // Jump conditions of the two longitudinal waves, W by quadrature of the wave speed.
        let speed = |s| law.longitudinal_speed(Strain::from_engineering(s));
        let ahead = c1 * integral(0.0, found.transmitted.engineering, speed);
        close("transmitted wave", ahead, u, 130.0, u);
        let incident = found.incident.strain.engineering;
        let behind = c1 * integral(incident, found.reflected.engineering, speed);
        close("reflected wave", behind, w - u, 130.0, w);
        // What the primary loses, the secondary gains.
        assert!(found.power_residual.abs() < 5e-15, "{}", found.power_residual);
        // Coefficients against the levels.
        for (of, e) in [
            (found.engineering, (|s: Strain| s.engineering) as fn(Strain) -> f64),
            (found.logarithmic, |s: Strain| s.logarithmic),
        ] {
            let e_i = e(found.incident.strain);
            close("R", of.reflection, (e(found.reflected) - e_i) / e_i, 8.0, 1.0);
            close("T", of.transmission, e(found.transmitted) / e_i, 8.0, 1.0);
            let d = e(found.diverted.strain) / e_i;
            close("D", of.diversion, d, 2.0, d);
        }
    }
}
