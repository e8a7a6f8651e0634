//! Interior points and crossovers.

use super::super::super::crossover::crossover;
use super::super::super::smith::SmithError;
use super::*;

fn through(m: &Hyperelastic) -> Crossing<'_, Hyperelastic> {
    Crossing { material: m, area: m.fibre.area }
}

/// The greatest force and the greatest force that a velocity at hand could make, N.
fn force_scale(m: &Hyperelastic, states: &[State], velocity: Vector3<f64>) -> f64 {
    let strain = states.iter().fold(0.0_f64, |most, s| most.max(s.strain));
    let speed = states.iter().fold(velocity.norm(), |most, s| most.max(s.velocity.norm()));
    m.fibre.modulus * m.fibre.area * (strain + speed / sound(m))
}

/// Checks every wave of a crossover and its balance; what is out of balance over the forces.
#[track_caller]
fn assert_joint(
    (m1, m2): (&Hyperelastic, &Hyperelastic),
    (left, right, arm): (State, State, State),
    (slide, along): (f64, Vector3<f64>),
    found: &Junction,
) {
    let v = found.velocity;
    let slid = v - along * ((1.0 - slide) * along.dot(&v));
    assert_eq!(v.z, 0.0);
    assert_eq!(found.left.ahead, left.reversed());
    assert_eq!((found.right.ahead, found.secondary.ahead), (right, arm));
    // S V written as here cancels to α_s: 1e-16/1e-3. Worst of 2·10⁵ cases: 3.5e-14.
    assert_waves(m1, &found.left, v, 1e-12);
    assert_waves(m1, &found.right, v, 1e-12);
    assert_waves(m2, &found.secondary, slid, 1e-12);
    let pull = |m: &Hyperelastic, arm: &Arm| {
        let s = arm.behind;
        s.direction * (m.fibre.modulus * m.fibre.area * tension(m.law, s.strain))
    };
    let drag = pull(m2, &found.secondary) * 2.0;
    let drag = drag - along * ((1.0 - slide) * along.dot(&drag));
    let sum = pull(m1, &found.left) + pull(m1, &found.right) + drag;
    let forces = pull(m1, &found.left).norm() + pull(m1, &found.right).norm() + drag.norm();
    // The forces are as good as the velocities they come from.
    let known = force_scale(m1, &[left, right], v) + force_scale(m2, &[arm], slid);
    assert!(sum.xy().norm() <= 1e-12 * (forces + known), "{:e} {found:?}", sum.xy().norm());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn waves_of_an_interior_point_satisfy_the_equations_of_motion(
        logarithmic in any::<bool>(),
        stiffness in ratios(),
        (left, right) in (taut(), taut()),
        weak in -12.0..0.0_f64,
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], fibre(stiffness));
        let (c, weak) = (sound(&m), f_exp10(weak));
        let left = times(left, c);
        // From two states that have nothing in common to two that hardly differ.
        let far = times(right, c);
        let right = State {
            strain: left.strain + weak * (far.strain - left.strain),
            direction: (left.direction + (far.direction - left.direction) * weak).normalize(),
            velocity: left.velocity + (far.velocity - left.velocity) * weak,
        };
        let Ok([l, r]) = interior(&m, left, right) else {
            assert!(logarithmic && (far.velocity - left.velocity).norm() > 0.1 * c);
            return Ok(());
        };
        assert_eq!((l.ahead, r.ahead), (left.reversed(), right));
        assert_eq!(l.behind.reversed(), r.behind);
        let joint = r.behind.velocity;
        assert_waves(&m, &l, joint, 3e-14);
        assert_waves(&m, &r, joint, 3e-14);
        // The same two arms, each as an end that moves with the point.
        for arm in [l, r] {
            let again = end(&m, arm.ahead, joint).unwrap();
            let strain = (again.behind.strain - arm.behind.strain).abs() * c;
            let speed = (joint - arm.ahead.velocity).norm() + arm.ahead.velocity.norm();
            assert!(strain < 1e-13 * (speed + c * (arm.ahead.strain + arm.behind.strain)));
        }
    }

    #[test]
    fn interior_point_is_the_same_from_the_other_side_and_for_another_observer(
        logarithmic in any::<bool>(),
        (left, right) in (taut(), taut()),
        boost in speed(),
        (axis, angle) in (unit(), -3.0..3.0_f64),
    ) {
        let m = elastic(LAWS[usize::from(logarithmic)], ARAMID);
        let c = sound(&m);
        let (left, right, boost) = (times(left, c), times(right, c), boost * c);
        let Ok([l, r]) = interior(&m, left, right) else { return Ok(()) };
        let Ok([r2, l2]) = interior(&m, right.reversed(), left.reversed()) else {
            panic!("a solution from one side only: {left:?} {right:?}")
        };
        let speed = left.velocity.norm() + right.velocity.norm();
        let scale = speed + boost.norm() + c * (left.strain + right.strain);
        for (a, b) in [(l, l2), (r, r2)] {
            prop_assert!((a.behind.strain - b.behind.strain).abs() * c <= 1e-14 * scale);
            prop_assert!((a.behind.velocity - b.behind.velocity).norm() <= 1e-13 * scale);
        }
        let turn = Rotation3::new(axis * angle);
        let seen = |s: State| State {
            strain: s.strain,
            direction: turn * s.direction,
            velocity: turn * s.velocity + boost,
        };
        let Ok([l3, _]) = interior(&m, seen(left), seen(right)) else { return Ok(()) };
        prop_assert!((l3.behind.strain - l.behind.strain).abs() * c <= 3e-14 * scale);
        let moved = l3.behind.velocity - seen(l.behind).velocity;
        prop_assert!(moved.norm() <= 1e-13 * scale);
    }

    #[test]
    fn crossover_at_rest_is_the_closed_form(
        logarithmic in any::<bool>(),
        impact in -6.8..0.176_f64,
        stiffness in ratios(),
        slide in -3.0..0.0_f64,
    ) {
        let law = LAWS[usize::from(logarithmic)];
        let (m1, m2) = (elastic(law, ARAMID), elastic(law, fibre(stiffness)));
        let (c, slide) = (sound(&m1), f_exp10(slide));
        let velocity = c * f_exp10(impact);
        let incident = smith(law, c, velocity).unwrap();
        let left = State {
            strain: incident.strain.engineering,
            direction: Vector3::x(),
            velocity: -Vector3::x() * incident.inflow_velocity,
        };
        let (right, arm) = (rest(Vector3::x()), rest(Vector3::z()));
        let slip = (slide, Vector3::x());
        let found = junction(through(&m1), left, right, through(&m2), arm, slip);
        let known = crossover(law, &m1.fibre, &m2.fibre, slide, velocity);
        let known = match known {
            Err(SmithError::KinkOvertakes { .. }) => {
                assert_eq!(found, Err(RiemannError::BeyondTheLaw));
                return Ok(());
            }
            known => known.unwrap(),
        };
        if logarithmic && known.reflected.engineering > std::f64::consts::E - 1.0 {
            assert_eq!(found, Err(RiemannError::BeyondTheLaw));
            return Ok(());
        }
        let found = found.unwrap();
        assert_joint((&m1, &m2), (left, right, arm), slip, &found);
        let near = |name: &str, a: f64, b: f64, scale: f64| {
            assert!((a - b).abs() <= 1e-13 * scale, "{name}: {a:e} {b:e}");
        };
        // Both roots stop at rounding: of W for the strains of the primary, and where a heavy
        // secondary hardly moves, of the balance, that is of u and ε₂ themselves.
        let w = incident.inflow_velocity;
        let strain = |of: Strain| of.engineering;
        near("u", -found.velocity.x, known.junction_speed, known.junction_speed);
        near("across", found.velocity.y, 0.0, known.junction_speed);
        near("ahead", found.right.behind.strain, strain(known.transmitted), w / c);
        near("behind", found.left.behind.strain, strain(known.reflected), w / c);
        let diverted = strain(known.diverted.strain);
        near("diverted", found.secondary.behind.strain, diverted, diverted);
    }

    #[test]
    fn crossover_of_a_later_time_is_in_balance(
        logarithmic in any::<bool>(),
        stiffness in ratios(),
        (left, right, arm) in (taut(), taut(), taut()),
        straight in any::<bool>(),
        slide in -3.0..0.0_f64,
        slow in -6.0..0.0_f64,
    ) {
        let law = LAWS[usize::from(logarithmic)];
        let (m1, m2) = (elastic(law, ARAMID), elastic(law, fibre(stiffness)));
        let (c1, c2) = (sound(&m1), sound(&m2));
        let (left, mut right) = (flat(times(left, c1)), flat(times(right, c1)));
        let slow = f_exp10(slow);
        let arm = State { velocity: arm.velocity * (slow * c1.min(c2)), ..arm };
        // On a kink nothing slides.
        let slide = if straight { f_exp10(slide) } else { 1.0 };
        if straight {
            right.direction = left.direction;
        }
        let slip = (slide, right.direction);
        let states = (left, right, arm);
        let Ok(found) = junction(through(&m1), left, right, through(&m2), arm, slip) else {
            assert!(logarithmic, "{states:?}");
            return Ok(());
        };
        assert_joint((&m1, &m2), states, slip, &found);
        // From the other side; and mirrored, with x and y changing places.
        let mirror = |v: Vector3<f64>| Vector3::new(v.y, v.x, v.z);
        let seen = |s: State| State {
            strain: s.strain,
            direction: mirror(s.direction),
            velocity: mirror(s.velocity),
        };
        let (from, to) = (seen(right).reversed(), seen(left).reversed());
        let slip = (slide, mirror(slip.1));
        let again = junction(through(&m1), from, to, through(&m2), seen(arm), slip).unwrap();
        let scale = force_scale(&m1, &[left, right], found.velocity)
            + force_scale(&m2, &[arm], found.velocity);
        // Monotone forces: V is known as well as the forces over the impedance of the primary's
        // kinks, the softest part.
        let soft = found.left.behind.strain.min(found.right.behind.strain).sqrt();
        let impedance = m1.fibre.density * m1.fibre.area * c1 * soft;
        let error = (mirror(again.velocity) - found.velocity).norm();
        prop_assert!(error * impedance < 1e-12 * scale, "{error:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]
    #[test]
    fn crossover_without_sliding_is_the_same_for_every_observer(
        stiffness in (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64),
        (left, right, arm) in (taut(), taut(), taut()),
        boost in speed(),
        angle in -3.0..3.0_f64,
    ) {
        let law = Law::Engineering;
        let (m1, m2) = (elastic(law, ARAMID), elastic(law, fibre(stiffness)));
        let (left, right) = (flat(times(left, sound(&m1))), flat(times(right, sound(&m1))));
        let arm = times(arm, sound(&m2));
        let boost = Vector3::new(boost.x, boost.y, 0.0) * sound(&m1);
        let turn = Rotation3::new(Vector3::z() * angle);
        let seen = |s: State| State {
            strain: s.strain,
            direction: turn * s.direction,
            velocity: turn * s.velocity + boost,
        };
        let at = |l: State, r: State, a: State| {
            junction(through(&m1), l, r, through(&m2), a, (1.0, r.direction)).unwrap()
        };
        let found = at(left, right, arm);
        let again = at(seen(left), seen(right), seen(arm));
        let moved = again.velocity - (turn * found.velocity + boost);
        let scale = force_scale(&m1, &[left, right], boost)
            + force_scale(&m2, &[arm], boost);
        let soft = found.left.behind.strain.min(found.right.behind.strain).sqrt();
        let impedance = m1.fibre.density * m1.fibre.area * sound(&m1) * soft;
        prop_assert!(moved.norm() * impedance < 1e-12 * scale, "{moved:?}");
    }
}

#[test]
fn fibre_bent_back_over_itself_and_pulled_apart_sideways_opens_across() {
    // t_R = −t_L, so |t*| = 1 is Uλ* = |v_R − v_L|/2 along that difference, whatever W takes away:
    // by the engineering law c√(ε(1 + ε)). Tolerance: some roundings of a root.
    let m = elastic(Law::Engineering, ARAMID);
    let (c, t) = (sound(&m), Vector3::new(0.6, -0.8, 0.0));
    let apart = Vector3::new(0.8, 0.6, 0.0);
    let state = |sign: f64| State {
        strain: 0.0173,
        direction: t * sign,
        velocity: Vector3::new(3.1, -7.9, 1.3) - apart * (sign * 0.21 * c),
    };
    let [left, right] = interior(&m, state(1.0), state(-1.0)).unwrap();
    let strain = (0.25 + 0.21 * 0.21_f64).sqrt() - 0.5;
    assert!((right.behind.strain / strain - 1.0).abs() < 1e-14, "{right:?}");
    assert!((right.behind.direction - apart).norm() < 1e-14, "{right:?}");
    let joint = right.behind.velocity;
    assert_waves(&m, &left, joint, 1e-14);
    assert_waves(&m, &right, joint, 1e-14);
}

/// The scene of Fig. 3 at the crossover, with this secondary.
fn figure_3(law: Law, secondary: Fibre, slide: f64) -> Junction {
    let (m1, m2) = (elastic(law, ARAMID), elastic(law, secondary));
    let incident = smith(law, sound(&m1), 400.0).unwrap();
    let left = State {
        strain: incident.strain.engineering,
        direction: Vector3::x(),
        velocity: -Vector3::x() * incident.inflow_velocity,
    };
    let (right, arm) = (rest(Vector3::x()), rest(Vector3::z()));
    junction(through(&m1), left, right, through(&m2), arm, (slide, Vector3::x())).unwrap()
}

#[test]
fn published_coefficients_of_the_crossover_are_found() {
    // Half a unit of the last decimal.
    let ratios = |law| {
        let found = figure_3(law, ARAMID, 1.0);
        let e = found.left.ahead.strain;
        let (r, t) = (found.left.behind.strain / e - 1.0, found.right.behind.strain / e);
        (r, t, found.secondary.behind.strain / e)
    };
    let (r, t, d) = ratios(Law::Engineering);
    assert!((r - 0.0440).abs() < 0.5e-4 && (t - 0.9560).abs() < 0.5e-4, "{r} {t}");
    assert!((d - 0.1467).abs() < 0.5e-4, "{d}");
    let (_, t, d) = ratios(Law::Logarithmic);
    assert!((t - 0.95553).abs() < 0.5e-5 && (d - 0.14628).abs() < 0.5e-5, "{t} {d}");
}

#[test]
fn secondary_that_slides_freely_or_weighs_nothing_leaves_the_wave_alone() {
    for law in LAWS {
        for (secondary, slide) in
            [(ARAMID, 1.3e-8), (ARAMID, 0.0), (Fibre { area: 1.37e-24, ..ARAMID }, 1.0)]
        {
            let found = figure_3(law, secondary, slide);
            let w = -found.left.ahead.velocity.x;
            // R ~ α_s^(8/3) and ~ A₂/A₁: below rounding.
            assert!((found.velocity.x / -w - 1.0).abs() < 1e-14, "{found:?}");
            assert!((found.left.behind.strain / found.left.ahead.strain - 1.0).abs() < 1e-14);
            // The secondary is dragged along at α_s W: Smith again.
            let c = (ARAMID.modulus / ARAMID.density).sqrt();
            let dragged = smith(law, c, slide * w).unwrap().strain.engineering;
            let error = (found.secondary.behind.strain - dragged).abs();
            assert!(error <= 1e-14 * dragged + 1e-300, "{error:e} {dragged:e}");
        }
    }
}

#[test]
fn secondary_that_is_very_heavy_holds_the_primary_as_a_clamp() {
    for law in LAWS {
        let found = figure_3(law, Fibre { area: 1.37e12, ..ARAMID }, 1.0);
        let clamp = end(&elastic(law, ARAMID), found.left.ahead, Vector3::zeros()).unwrap();
        // u is about 1e-12 of W here.
        assert!((found.left.behind.strain / clamp.behind.strain - 1.0).abs() < 1e-11);
        assert!(found.right.behind.strain < 1e-11 * clamp.behind.strain);
    }
}

#[test]
fn solution_is_found_though_the_mean_velocity_is_beyond_the_law_of_the_secondary() {
    // The wave alone would drag the soft, heavy secondary beyond ln λ = 1; held by it, it does not.
    let soft = Fibre { modulus: 7.3e4, density: 9.1e5, area: 3.7e-3 };
    let (m1, m2) = (elastic(Law::Logarithmic, ARAMID), elastic(Law::Logarithmic, soft));
    let found = figure_3(Law::Logarithmic, soft, 1.0);
    let dragged = found.left.ahead.velocity / 2.0;
    assert_eq!(end(&m2, rest(Vector3::z()), dragged), Err(RiemannError::BeyondTheLaw));
    assert!(RiemannError::BeyondTheLaw.to_string().contains("beyond the range"));
    let states = (found.left.ahead.reversed(), rest(Vector3::x()), rest(Vector3::z()));
    assert_joint((&m1, &m2), states, (1.0, Vector3::x()), &found);
}

#[test]
fn slack_primary_bent_back_over_itself_finds_its_balance() {
    // Two of the hardest: strains of 1e-6, arms of the primary on one side, so that the way to the
    // balance is a bent valley along which a step that must lower the force gets nowhere.
    let state = |strain: f64, direction: [f64; 3], velocity: [f64; 3]| State {
        strain,
        direction: Vector3::from(direction).normalize(),
        velocity: Vector3::from(velocity),
    };
    let m1 = elastic(Law::Engineering, ARAMID);
    for (ratios, left, right, arm) in [
        (
            (0.0, 1.900502557889563, -1.9820159737768295),
            state(1.1171734563452396e-5, [0.9385354185183724, -0.34518294886414, 0.0], [0.0; 3]),
            state(1.6763826036725847e-6, [-0.8337272733723049, -0.5521764515398877, 0.0], [0.0; 3]),
            state(
                9.213262662535277e-5,
                [-0.8930180383288909, 0.45001929876775854, 0.0011890987320044373],
                [0.0, 0.0, 0.0005175051074690811],
            ),
        ),
        (
            (-0.6663427920271517, -0.9155876613260719, 0.0),
            state(8.580083870121952e-6, [0.5632653594038955, -0.8262733405040256, 0.0], [0.0; 3]),
            state(1.599415674738529e-6, [-1.0, 0.0, 0.0], [0.0, 0.0138, 0.0]),
            state(1.038082740804321e-6, [-0.99998, 0.0, 0.006542], [0.0, 0.0, 0.0081]),
        ),
    ] {
        let m2 = elastic(Law::Engineering, fibre(ratios));
        let slip = (1.0, right.direction);
        let found = junction(through(&m1), left, right, through(&m2), arm, slip).unwrap();
        assert_joint((&m1, &m2), (left, right, arm), slip, &found);
    }
}

#[test]
fn an_unstrained_fibre_at_rest_stays_as_it_is() {
    // The least strain that is sought is the least normal number; of a kink so slow the direction is
    // that of the fibre.
    let m = elastic(Law::Engineering, ARAMID);
    let along = Vector3::new(0.6, -0.8, 0.0);
    let still = |direction| State { strain: f64::MIN_POSITIVE, ..rest(direction) };
    let [left, right] = interior(&m, rest(along), rest(along)).unwrap();
    assert_eq!((left.behind, right.behind), (still(-along), still(along)));
}
