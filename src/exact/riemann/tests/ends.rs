//! Arms whose end is moved.

use super::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn waves_of_a_moved_end_satisfy_the_equations_of_motion(
        logarithmic in any::<bool>(),
        stiffness in ratios(),
        ahead in taut(),
        velocity in speed(),
        at_rest in any::<bool>(),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], fibre(stiffness));
        let c = sound(&m);
        let ahead = if at_rest { rest(ahead.direction) } else { times(ahead, c) };
        let velocity = velocity * c;
        let Ok(arm) = end(&m, ahead, velocity) else {
            // Only the logarithmic law has an end: every strain within it is too small.
            assert!(logarithmic);
            let most = std::f64::consts::E - 1.0;
            let struck = velocity - ahead.velocity;
            let a = struck.dot(&ahead.direction);
            let p = struck - ahead.direction * a;
            let r = 2.0 * c * ((1.0 + most).sqrt() - (1.0 + ahead.strain).sqrt()) + a;
            let q = c * (1.0 + most).sqrt();
            assert!((ahead.direction * (q - r) - p).norm() > q, "{velocity:?} {ahead:?}");
            return Ok(());
        };
        // A few roundings of the state; none of 10⁵ cases was above 2e-15.
        assert_waves(&m, &arm, velocity, 1e-14);
    }

    #[test]
    fn arm_balances_momentum_and_energy_over_a_control_volume(
        logarithmic in any::<bool>(),
        ahead in taut(),
        velocity in speed(),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let (c, law) = (sound(&m), m.law);
        let (ahead, velocity) = (times(ahead, c), velocity * c);
        let Ok(arm) = end(&m, ahead, velocity) else { return Ok(()) };
        let (from, to) = (ahead.strain, arm.between.strain);
        // In units of ρ = 1: tensions are c²T/E.
        let pull = |s: &State| s.direction * (c * c * tension(law, s.strain));
        let speed = velocity.norm() + ahead.velocity.norm() + c * from.max(to).sqrt();
        for axis in 0..3 {
            let grown = growth(&m, &arm, &|_, v| v[axis]);
            let force = (pull(&ahead) - pull(&arm.behind))[axis];
            // Products of a velocity and a wave speed; quadrature and rounding.
            assert!((grown - force).abs() < 3e-14 * c * speed, "{grown:e} {force:e}");
        }
        let energy = |strain: f64, v: Vector3<f64>| {
            v.norm_squared() / 2.0 + c * c * law.stored_energy(Strain::from_engineering(strain))
        };
        let power = pull(&ahead).dot(&ahead.velocity) - pull(&arm.behind).dot(&velocity);
        let surplus = growth(&m, &arm, &energy) - power;
        let scale = c * speed * speed;
        if law == Law::Logarithmic && to < from {
            // A shock takes energy out: the area between chord and curve, times its speed. ∫T is
            // by quadrature; s is the chord's.
            let lost = (tension(law, from) + tension(law, to)) / 2.0 * (from - to)
                - integral(to, from, |s| tension(law, s));
            let s = ((tension(law, from) - tension(law, to)) / (from - to)).sqrt();
            assert!(lost < 1e-16, "{lost:e}");
            assert!((surplus - lost * s * c * c * c).abs() < 3e-14 * scale, "{surplus:e}");
        } else {
            assert!(surplus.abs() < 3e-14 * scale, "{surplus:e} {scale:e}");
        }
    }

    #[test]
    fn end_moves_with_its_observer(
        logarithmic in any::<bool>(),
        ahead in taut(),
        velocity in speed(),
        boost in speed(),
        (axis, angle) in (unit(), -3.0..3.0_f64),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let (ahead, velocity, boost) = (times(ahead, c), velocity * c, boost * c);
        let Ok(arm) = end(&m, ahead, velocity) else { return Ok(()) };
        let turn = Rotation3::new(axis * angle);
        let seen = |s: State| State {
            strain: s.strain,
            direction: turn * s.direction,
            velocity: turn * s.velocity + boost,
        };
        let Ok(again) = end(&m, seen(ahead), turn * velocity + boost) else { return Ok(()) };
        // What the boost rounds away is a 1e-16 of its velocity; a kink magnifies it by c/(Uλ),
        // here up to 1e3, in the direction and 1 in strain and velocity.
        let scale = boost.norm() + velocity.norm() + ahead.velocity.norm() + c * ahead.strain;
        let expected = seen(arm.behind);
        let strain = (again.behind.strain - expected.strain).abs();
        prop_assert!(strain <= 1e-14 * scale / c, "{strain:e} {scale:e}");
        let q = c * (arm.behind.strain).sqrt();
        let direction = (again.behind.direction - expected.direction).norm();
        prop_assert!(direction * q <= 3e-14 * scale + 1e-15 * q, "{direction:e}");
        let between = again.between.velocity - seen(arm.between).velocity;
        prop_assert!(between.norm() <= 3e-14 * scale);
    }

    #[test]
    fn fibre_at_rest_answers_as_smith_says(
        logarithmic in any::<bool>(),
        decades in -6.8..0.176_f64,
        (t, other) in (unit(), unit()),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let across = t.cross(&other);
        prop_assume!(across.norm() > 0.1);
        let velocity = across.normalize() * (c * f_exp10(decades));
        let known = smith(m.law, c, velocity.norm()).unwrap();
        let arm = end(&m, rest(t), velocity).unwrap();
        // Two roots of one relation, each to a few ulps; V is rounded across t, which is a
        // strain of 1e-16 of V/c and relative to it worst at the slowest impact: (c/V)^(1/3), 180.
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 2e-13;
        prop_assert!(near(arm.between.strain, known.strain.engineering));
        prop_assert!(near(arm.between.velocity.norm(), known.inflow_velocity));
        let cosine = arm.behind.direction.dot(&t);
        prop_assert!((cosine - known.angle_cosine).abs() < 1e-14);
        prop_assert!(!arm.is_folded());
    }

    #[test]
    fn folded_arm_is_one_that_its_end_runs_into_faster_than_it_can_give_way(
        ahead in taut(),
        velocity in speed(),
        along in 0.0..1.5_f64,
    ) {
        // Engineering law: unloading to zero strain gives way at cε.
        let m = elastic(Law::Engineering, ARAMID);
        let c = sound(&m);
        let ahead = times(ahead, c);
        let t = ahead.direction;
        let velocity = ahead.velocity + (velocity + t * along) * c;
        let arm = end(&m, ahead, velocity).unwrap();
        let a = (velocity - ahead.velocity).dot(&t);
        prop_assert!(!arm.is_folded() || a > c * ahead.strain, "{a} {ahead:?}");
        // Folded or not, it is under tension.
        prop_assert!(arm.between.strain > 0.0);
    }
}

#[test]
fn end_that_moves_with_its_fibre_sends_nothing() {
    for law in LAWS {
        let m = elastic(law, ARAMID);
        let velocity = Vector3::new(31.7, -411.3, 7.9);
        let direction = Vector3::new(0.6, 0.48, -0.64);
        for strain in [0.0, 3.1e-7, 0.0173] {
            let ahead = State { strain, direction, velocity };
            let arm = end(&m, ahead, velocity).unwrap();
            // Two ulps of the root.
            assert!((arm.behind.strain - strain).abs() <= 2.0 * f64::EPSILON * strain + 1e-300);
            assert!((arm.behind.direction - direction).norm() < 1e-14);
        }
    }
}

#[test]
fn pulled_end_stretches_and_pushed_end_folds() {
    // Along the fibre, ε₀ = 0.0173: a straight answer ε* = ε₀ − a/c while that is positive, and
    // beyond it a fold, r = 2Uλ with r = c(ε* − ε₀) + a: then 2√(ε*(1 + ε*)) = ε* + d,
    // d = a/c − ε₀, of which the positive root is ε* = (d − 2 + 2√(1 − d + d²))/3. A few
    // roundings, which the difference at small d magnifies by 1/d² (400).
    let m = elastic(Law::Engineering, ARAMID);
    let (c, t) = (sound(&m), Vector3::new(0.6, 0.48, -0.64));
    let ahead = State { strain: 0.0173, direction: t, velocity: Vector3::new(31.7, -411.3, 7.9) };
    for pulled in [-0.0311, 0.0109, 0.0167] {
        let arm = end(&m, ahead, ahead.velocity + t * (pulled * c)).unwrap();
        assert!((arm.between.strain - (0.0173 - pulled)).abs() < 1e-15, "{pulled}: {arm:?}");
        assert!(!arm.is_folded());
    }
    for pushed in [0.0673, 0.311, 1.37] {
        let arm = end(&m, ahead, ahead.velocity + t * (pushed * c)).unwrap();
        let d = pushed - 0.0173;
        let strain = (d - 2.0 + 2.0 * (1.0 - d + d * d).sqrt()) / 3.0;
        assert!((arm.between.strain / strain - 1.0).abs() < 1e-12, "{pushed}: {arm:?} {strain}");
        assert!((arm.behind.direction + t).norm() < 1e-7 && arm.is_folded());
        assert_waves(&m, &arm, ahead.velocity + t * (pushed * c), 1e-14);
    }
}

#[test]
fn oblique_pull_back_over_the_fibre_is_folded_and_taut() {
    // What "folded" does not mean: nothing here is slack. A straight fibre at rest, its end moved
    // at c/3 by 150° from the way that stretches it.
    let m = elastic(Law::Engineering, ARAMID);
    let c = sound(&m);
    let velocity = Vector3::new(0.75_f64.sqrt(), 0.5, 0.0) * (c / 3.0);
    let arm = end(&m, rest(Vector3::x()), velocity).unwrap();
    assert!(arm.is_folded() && arm.between.strain > 0.01, "{arm:?}");
    assert_waves(&m, &arm, velocity, 1e-14);
}
