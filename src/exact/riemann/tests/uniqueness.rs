//! One solution, and one way to it.

use super::super::super::samples;
use super::*;

/// |(Uλ − r)t − p|² − (Uλ)² with r and p as in [`end`], and the same for [`interior`], literally.
fn short(m: &Hyperelastic, ahead: &State, velocity: Vector3<f64>, strain: f64) -> f64 {
    let t = ahead.direction;
    let q = kink_momentum(m, strain);
    let v = ahead.velocity - t * m.wave_velocity(ahead.strain, strain);
    q * q - (t * q + (v - velocity)).norm_squared()
}

fn short_between(m: &Hyperelastic, left: &State, right: &State, strain: f64) -> f64 {
    let q = kink_momentum(m, strain);
    let v_left = left.velocity + left.direction * m.wave_velocity(left.strain, strain);
    let v_right = right.velocity - right.direction * m.wave_velocity(right.strain, strain);
    let sum = (left.direction + right.direction) * (q / 2.0) + (v_right - v_left) / 2.0;
    q * q - sum.norm_squared()
}

/// Strains from 1e-12 to 10 (or the law's end), about a third of a decade apart.
fn strains(m: &Hyperelastic) -> impl Iterator<Item = f64> {
    let last = m.greatest_strain().min(10.0);
    (0..).map(|k| 1.3e-12 * 2.1_f64.powi(k)).take_while(move |strain| *strain < last)
}

fn force(m: &Hyperelastic, ahead: State, velocity: Vector3<f64>) -> Option<Vector3<f64>> {
    let fibre = Crossing { material: m, area: m.fibre.area };
    Some(pull(&fibre, &end(m, ahead, velocity).ok()?))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn what_is_short_of_a_unit_direction_changes_sign_once(
        logarithmic in any::<bool>(),
        (left, right) in (taut(), taut()),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let (left, right) = (times(left, c), times(right, c));
        let scale = (left.velocity.norm() + right.velocity.norm() + c * left.strain).powi(2);
        let sides = |f: &dyn Fn(f64) -> f64, root: Option<f64>| {
            for strain in strains(&m) {
                let value = f(strain);
                // Below what rounding leaves of the squares, signs say nothing.
                if value.abs() > 1e-13 * (scale + c * c * strain) {
                    let beyond = root.is_some_and(|root| strain > root);
                    assert!((value > 0.0) == beyond, "{strain:e}: {value:e}, {root:?}");
                }
            }
        };
        let velocity = right.velocity;
        let root = end(&m, left, velocity).ok().map(|arm| arm.between.strain);
        sides(&|strain| short(&m, &left, velocity, strain), root);
        let root = interior(&m, left, right).ok().map(|[arm, _]| arm.between.strain);
        sides(&|strain| short_between(&m, &left, &right, strain), root);
    }

    #[test]
    fn force_of_an_arm_opposes_its_joint(
        logarithmic in any::<bool>(),
        ahead in taut(),
        at_rest in any::<bool>(),
        (one, change) in (speed(), speed()),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let ahead = if at_rest { rest(ahead.direction) } else { times(ahead, c) };
        let (one, other) = (one * c, (one + change) * c);
        let (Some(f), Some(g)) = (force(&m, ahead, one), force(&m, ahead, other)) else {
            return Ok(());
        };
        let work = (g - f).dot(&(other - one));
        // Rounding of the velocities, through the impedance ρcA.
        let impedance = m.fibre.density * c * m.fibre.area;
        let known = 1e-14 * impedance * c * (ahead.velocity / c).norm().max(ahead.strain).max(1e-7);
        prop_assert!(work <= known * (other - one).norm(), "{work:e}");
        // Not only weakly: at least a part √ε of the impedance, ε the lesser of the two strains.
        let least = |v| end(&m, ahead, v).unwrap().between.strain;
        let soft = least(one).min(least(other)).sqrt();
        if soft * (change.norm()) > 1e-9 {
            let part = -work / (impedance * soft * (other - one).norm_squared());
            prop_assert!(part > 0.01, "{part:e}");
        }
    }

    #[test]
    fn change_of_the_force_with_velocity_is_its_difference_and_is_negative_definite(
        logarithmic in any::<bool>(),
        ahead in taut(),
        velocity in speed(),
        (along, axis) in (unit(), unit()),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let (ahead, velocity) = (times(ahead, c), velocity * c);
        let Ok(arm) = end(&m, ahead, velocity) else { return Ok(()) };
        let fibre = Crossing { material: &m, area: m.fibre.area };
        let slope = softening(&fibre, &arm);
        let impedance = m.fibre.density * c * m.fibre.area;
        let strain = arm.between.strain;
        // n·J n < 0 for every n: in the plane of the kink by the proof, across it −ρAU.
        let resisted = |n: Vector3<f64>| -n.dot(&(slope * n)) / (impedance * strain.sqrt());
        for n in [along, axis, arm.behind.direction, arm.between.direction] {
            prop_assert!(resisted(n) > 0.1, "{:e}", resisted(n));
        }
        // Central difference over a part h of what V may change by before ε does by itself; the
        // error is of the order of h², and of rounding over h.
        let h = 1e-4 * strain.min(arm.behind.direction.dot(&ahead.direction) + 1.0 + strain);
        let speed = velocity.norm() + ahead.velocity.norm() + c * strain;
        let rounding = 1e-15 * speed / (h * c);
        prop_assume!(rounding < 1e-3);
        // The wave turns from a fan to a shock at ε = ε₀, where the third derivative jumps.
        let step = along * (h * c);
        let sides = (force(&m, ahead, velocity + step), force(&m, ahead, velocity - step));
        let (Some(f), Some(g)) = sides else { return Ok(()) };
        let difference = (f - g) / (2.0 * h * c);
        let error = (difference - slope * along).norm() / impedance;
        prop_assert!(error < 1e-5 + 30.0 * rounding, "{error:e} {rounding:e}");
    }
}

/// The waves that any law makes of an end at this velocity: definiteness, and the Jacobian against
/// a central difference.
fn check_slope(law: &impl Elastic, ahead: State, velocity: Vector3<f64>, along: Vector3<f64>) {
    let fibre = Crossing { material: law, area: 1.37e-8 };
    let force = |v| end(law, ahead, v).ok().map(|arm| pull(&fibre, &arm));
    let Ok(arm) = end(law, ahead, velocity) else { return };
    let slope = softening(&fibre, &arm);
    let impedance = law.density() * 1.37e-8 * front_speed(law);
    for n in [along, arm.behind.direction, arm.between.direction] {
        assert!(-n.dot(&(slope * n)) > 0.03 * impedance * arm.between.strain.sqrt());
    }
    let step = along * (1e-6 * front_speed(law));
    let (Some(f), Some(g)) = (force(velocity + step), force(velocity - step)) else { return };
    let difference = (f - g) / (2e-6 * front_speed(law));
    // Curvatures up to 1e3 of the slope over 1e-6, where a shock begins to touch a fan; rounding.
    let error = (difference - slope * along).norm() / impedance;
    assert!(error < 2e-3, "{error:e} {ahead:?} {velocity:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]
    #[test]
    fn change_of_the_force_is_as_good_for_laws_with_shocks_in_them(
        strain in 1e-3..0.06_f64,
        direction in unit(),
        velocity in unit(),
        impact in 0.003..0.05_f64,
        along in unit(),
    ) {
        let ahead = State { strain, direction, velocity: Vector3::zeros() };
        let velocity = velocity * (impact * 6.5e3);
        check_slope(&samples::softening(), State { strain: strain.min(0.04), ..ahead }, velocity, along);
        check_slope(&samples::concave_convex(), ahead, velocity, along);
        check_slope(&samples::convex_concave(), ahead, velocity, along);
        check_slope(&samples::twice_inflected(), ahead, velocity, along);
        check_slope(&samples::exponential_hardening(), ahead, velocity, along);
    }
}
