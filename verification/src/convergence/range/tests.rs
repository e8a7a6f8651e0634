//! Ladders that are made to be of one kind, and what is said of them.

use super::super::synthetic::{SPACINGS, ladder, normal, power};
use super::*;
use crate::random::SplitMix;

const RULE: Rule = Rule { band: 0.1, floor: 0.0 };

fn asymptotic(verdict: Verdict) -> Run {
    let Verdict::Asymptotic(run) = verdict else { panic!("{verdict:?}") };
    run
}

#[test]
fn an_error_of_one_power_is_asymptotic_from_the_first_mesh() {
    for (p, c) in [(0.29, 0.0371), (2.0 / 3.0, -0.0371), (1.87, 4.1)] {
        let run = asymptotic(of_errors(&ladder(&SPACINGS, |h| c * power(h, p)), RULE).unwrap());
        assert_eq!((run.from, run.meshes), (0, 7));
        // Roundings of logarithms.
        assert!((run.order - p).abs() < 1e-13 && run.within < 1e-13, "{run:?}");
        let values = ladder(&SPACINGS, |h| 1.4430 + c * power(h, p));
        let run = asymptotic(of_values(&values, RULE).unwrap());
        assert_eq!((run.from, run.meshes), (0, 7));
        // Rounding of 1.4 over differences of 1e-3.
        assert!((run.order - p).abs() < 1e-9 && run.within < 1e-9, "{run:?}");
    }
}

/// e = h + 0.4 h³ with ratio 2: pairwise orders ln(2 (1 + 0.4 h²)/(1 + 0.1 h²))/ln 2 between h and
/// h/2, by hand 2.44, 1.91, 1.35, 1.10, 1.03, 1.007 from h = 4 on. With a band of 0.1 the four finest
/// meshes agree (fit between 1.03 and 1.06), and not with the fifth (1.35).
#[test]
fn the_range_begins_where_the_second_term_has_died_out() {
    let spacings: Vec<_> = (0..7).map(|k| 4.0 / f64::from(1 << k)).collect();
    let errors = ladder(&spacings, |h| h + 0.4 * h * h * h);
    let run = asymptotic(of_errors(&errors, RULE).unwrap());
    assert_eq!((run.from, run.meshes), (3, 4));
    assert!((1.03..1.06).contains(&run.order) && run.within < 0.1, "{run:?}");
    // A narrow band leaves no range: the two last orders differ by 0.02.
    let narrow = of_errors(&errors, Rule { band: 0.005, floor: 0.0 }).unwrap();
    assert_eq!(narrow, Verdict::NotYet(Reason::Scattered));
}

/// Orders 1, 1, 1 and 0.85 with ratio 2. The fit weighs orders as 4, 6, 6, 4, then as 3, 4, 3: the last
/// is 0.12 below the fit of all, 0.105 below that of four meshes and 0.075 below that of three.
#[test]
fn an_order_too_low_ends_a_run_as_one_too_high_does() {
    for (last, order) in [(0.85, 0.925), (1.15, 1.075)] {
        let mut errors = vec![(1.7, 0.31), (0.85, 0.155), (0.425, 0.0775), (0.2125, 0.03875)];
        errors.push((0.10625, 0.03875 * power(0.5, last)));
        let run = asymptotic(of_errors(&errors, RULE).unwrap());
        assert_eq!((run.from, run.meshes), (2, 3));
        // Roundings of logarithms.
        assert!((run.order - order).abs() < 1e-13 && (run.within - 0.075).abs() < 1e-13, "{run:?}");
    }
}

#[test]
fn errors_of_a_wrong_limit_do_not_fall_and_their_values_do() {
    // On the finest mesh the term that falls is 0.0005 of the other.
    let fine = SPACINGS.map(|h| 0.1 * h);
    let errors = ladder(&fine, |h| 0.0141 + 0.11 * power(h, 1.87));
    assert_eq!(of_errors(&errors, RULE).unwrap(), Verdict::NotYet(Reason::NotFalling));
    // Without the wrong limit the same numbers converge.
    let run = asymptotic(of_values(&errors, RULE).unwrap());
    assert!((run.order - 1.87).abs() < 1e-9, "{run:?}");
    let growing = ladder(&SPACINGS, |h| 0.0141 * power(h, -0.4));
    assert_eq!(of_errors(&growing, RULE).unwrap(), Verdict::NotYet(Reason::NotFalling));
    assert_eq!(of_values(&growing, RULE).unwrap(), Verdict::NotYet(Reason::NotFalling));
}

/// What a window average does: a term that falls and ringing whose phase is another on every mesh.
#[test]
fn errors_that_alternate_are_no_power_law_though_their_sizes_are() {
    let mut sign = 1.0;
    let alternating = ladder(&SPACINGS, |h| {
        sign = -sign;
        sign * 0.0371 * power(h, 0.61)
    });
    let Ok(Verdict::Oscillating { changes: 6 }) = of_errors(&alternating, RULE) else {
        panic!("{:?}", of_errors(&alternating, RULE))
    };
    // As values they alternate as well: five changes of six differences.
    assert_eq!(of_values(&alternating, RULE).unwrap(), Verdict::Oscillating { changes: 5 });
    // About an error that keeps its sign: no change of the error, five of its differences.
    let swinging: Vec<_> = alternating.iter().map(|&(h, e)| (h, 0.2 + e)).collect();
    assert_eq!(of_errors(&swinging, RULE).unwrap(), Verdict::Oscillating { changes: 5 });
    // The envelope is the power law that the sizes are.
    let bound = super::super::envelope(&alternating).unwrap();
    let law = super::super::power_law(&bound, 0.95).unwrap();
    assert!((law.order - 0.61).abs() < 1e-13, "{law:?}");
}

#[test]
fn one_change_of_sign_is_a_crossing_until_enough_meshes_follow_it() {
    // 0.3 h − 0.2: zero at h = 2/3. A coarse mesh more or less is of no account.
    let crossing = |finest: usize| {
        let spacings = &[3.1, 2.03, 1.37, 0.81, 0.59][..finest];
        of_errors(&ladder(spacings, |h| 0.3 * h - 0.2), RULE).unwrap()
    };
    assert_eq!(crossing(5), Verdict::NotYet(Reason::Crossing));
    assert_eq!(crossing(4), Verdict::NotYet(Reason::Scattered));
    // Signs that settle: the first mesh is left out.
    let mut settled = ladder(&SPACINGS, |h| -0.0371 * power(h, 0.61));
    settled[1].1 = 0.0012;
    let run = asymptotic(of_errors(&settled, RULE).unwrap());
    assert_eq!((run.from, run.meshes), (2, 5));
}

fn said_of(errors: [f64; 5], floor: f64) -> Verdict {
    let errors: Vec<_> = SPACINGS.into_iter().zip(errors).collect();
    of_errors(&errors, Rule { band: 0.1, floor }).unwrap()
}

#[test]
fn only_changes_that_are_known_and_go_on_to_the_finest_meshes_are_an_oscillation() {
    // Two changes among the coarse meshes, and then orders of 0.7 and 2.7.
    let early = said_of([0.2, -0.15, 0.1, 0.07, 0.03], 0.0);
    assert_eq!(early, Verdict::NotYet(Reason::Scattered));
    // One error of unknown sign: no crossing, but the last order is negative.
    let unknown = [0.3, 0.2, 0.1, -1e-6, 0.05];
    assert_eq!(said_of(unknown, 1e-5), Verdict::NotYet(Reason::NotFalling));
    assert_eq!(said_of(unknown, 0.0), Verdict::Oscillating { changes: 2 });
    // Errors that stay where they are, but for what they are known to.
    let still = [0.2, 0.1, 0.100001, 0.1, 0.100001];
    assert_eq!(said_of(still, 1e-6), Verdict::NotYet(Reason::NotFalling));
    assert_eq!(said_of(still, 0.0), Verdict::Oscillating { changes: 3 });
}

#[test]
fn orders_that_are_none_or_too_low_together_make_no_range() {
    // Orders of −0.3 and 0.15 at the end: the last alone would be enough.
    let low = said_of([0.05, 0.07, 0.1, 0.117, 0.1116], 0.0);
    assert_eq!(low, Verdict::NotYet(Reason::NotFalling));
    // Two equal values: neither of the two orders exists, though a curve can be fitted.
    let equal = [(3.1, 1.0), (2.03, 1.5), (1.37, 1.5), (0.81, 1.6)];
    assert_eq!(of_values(&equal, RULE).unwrap(), Verdict::NotYet(Reason::NotFalling));
}

#[test]
fn errors_on_the_floor_end_the_range_above_it() {
    let floored = |h: f64| 0.0371 * power(h, 3.0) + 1.3e-3;
    // On the five finest meshes 0.0371 h³ is 95e-3, 20e-3, 7.6e-3, 1.3e-3 and 0.4e-3. With a floor of
    // 1.3e-3 a band of 0.4 takes errors above 1.3e-3/(1 − r^−0.4), 5, 7, 11, 6 and 8 thousandths.
    let rule = Rule { band: 0.4, floor: 1.3e-3 };
    let verdict = of_errors(&ladder(&SPACINGS, floored), rule).unwrap();
    let Verdict::Floor { from: 4, before: Some(run) } = verdict else { panic!("{verdict:?}") };
    assert_eq!((run.from, run.meshes), (0, 4));
    assert!((2.5..3.0).contains(&run.order), "{run:?}");
    // The same without being told of the floor: the errors stop falling.
    let told_nothing = Rule { band: 0.4, floor: 0.0 };
    let verdict = of_errors(&ladder(&SPACINGS, floored), told_nothing).unwrap();
    assert_eq!(verdict, Verdict::NotYet(Reason::Scattered));
    // Rounding: nothing but the floor, and exact zeros.
    let mut random = SplitMix::new(31);
    let noise = ladder(&SPACINGS, |_| 3e-16 * random.between(-1.0, 1.0));
    let rounding = Rule { band: 0.1, floor: 4e-16 };
    assert_eq!(of_errors(&noise, rounding).unwrap(), Verdict::Floor { from: 0, before: None });
    let zeros = ladder(&SPACINGS, |_| 0.0);
    assert_eq!(of_errors(&zeros, RULE).unwrap(), Verdict::Floor { from: 0, before: None });
    assert_eq!(of_values(&zeros, RULE).unwrap(), Verdict::Floor { from: 1, before: None });
}

#[test]
fn an_error_that_passes_through_zero_is_not_taken_for_the_floor() {
    let mut errors = ladder(&SPACINGS, |h| 0.0371 * power(h, 0.61));
    // 0.0146 by the law; 2e-6 is below the floor, and far too good.
    errors[6].1 = 2e-6;
    let rule = Rule { band: 0.1, floor: 1e-5 };
    assert_eq!(of_errors(&errors, rule).unwrap(), Verdict::NotYet(Reason::Dip { mesh: 6 }));
    // 0.0075 instead of 0.0081 is too small by more than the band, but not if it is known to 0.0005.
    let mut near = ladder(&SPACINGS, |h| 0.0371 * h);
    near[6].1 = 0.0075;
    let verdict = of_errors(&near, Rule { band: 0.1, floor: 5e-4 }).unwrap();
    let Verdict::Floor { from: 6, before: Some(run) } = verdict else { panic!("{verdict:?}") };
    assert_eq!((run.from, run.meshes), (0, 6));
    // Within the ladder it breaks the run.
    errors[6].1 = 0.0371 * power(SPACINGS[6], 0.61);
    errors[2].1 = 0.0;
    let run = asymptotic(of_errors(&errors, rule).unwrap());
    assert_eq!((run.from, run.meshes), (3, 4));
    errors[2].1 = 0.0371 * power(SPACINGS[2], 0.61);
    errors[5].1 = 0.0;
    assert_eq!(of_errors(&errors, rule).unwrap(), Verdict::NotYet(Reason::NotFalling));
}

/// Signs and sizes by chance on seven meshes with no order at all: how often a range is found. Three
/// orders of one sign that agree to 0.1 by chance must be rare.
#[test]
fn chance_is_seldom_taken_for_a_range() {
    let mut random = SplitMix::new(909);
    let taken = (0..2000)
        .filter(|_| {
            let errors = ladder(&SPACINGS, |_| normal(&mut random));
            matches!(of_errors(&errors, RULE), Ok(Verdict::Asymptotic(_)))
        })
        .count();
    // 1/4 for the signs, and a few per cent for two orders about 1.5 wide each: 0.5 to 2 % in all.
    assert!(taken < 40, "{taken}");
}

/// Differences of values alternate with their errors, however far from zero the values are.
#[test]
fn values_that_alternate_oscillate() {
    let mut sign = 1.0;
    let values = ladder(&SPACINGS, |h| {
        sign = -sign;
        1.4430 + 0.0371 * sign * h
    });
    assert_eq!(of_values(&values, RULE).unwrap(), Verdict::Oscillating { changes: 5 });
}

#[test]
fn the_order_of_values_is_fitted_to_all_meshes_of_their_run() {
    let spacings: Vec<_> = (0..8).map(|k| 4.0 / f64::from(1 << k)).collect();
    let values = ladder(&spacings, |h| 1.4430 + h + 0.4 * h * h * h);
    let run = asymptotic(of_values(&values, RULE).unwrap());
    assert!(run.from > 0 && run.meshes >= 4, "{run:?}");
    let all = best_order(&values[run.from..run.from + run.meshes], ORDERS).unwrap();
    assert_eq!(run.order, all);
}

/// Errors 1/2 of each other, then one that a floor of 0.004 hides: with the order 1 and a band of 0.1 the least
/// that it may be is 0.1 × 2^−1.1 = 0.0467, less the floor 0.0427.
#[test]
fn an_error_on_the_floor_is_a_dip_if_the_order_does_not_allow_it() {
    let rule = Rule { band: 0.1, floor: 0.004 };
    let verdict = |last: f64| {
        let errors = [(16.0, 0.8), (8.0, 0.4), (4.0, 0.2), (2.0, 0.1), (1.0, last)];
        of_errors(&errors, rule).unwrap()
    };
    assert!(matches!(verdict(0.045), Verdict::Floor { from: 4, before: Some(_) }));
    assert_eq!(verdict(0.040), Verdict::NotYet(Reason::Dip { mesh: 4 }));
}

#[test]
fn too_little_is_said_to_be_too_little() {
    let errors = ladder(&SPACINGS[..2], |h| h);
    assert_eq!(of_errors(&errors, RULE).unwrap(), Verdict::NotYet(Reason::TooFew));
    assert_eq!(of_errors(&errors[..1], RULE).unwrap(), Verdict::NotYet(Reason::TooFew));
    assert_eq!(of_values(&errors[..1], RULE).unwrap(), Verdict::NotYet(Reason::TooFew));
    assert_eq!(
        of_values(&ladder(&SPACINGS[..3], |h| h), RULE).unwrap(),
        Verdict::NotYet(Reason::TooFew)
    );
    assert_eq!(of_errors(&[], RULE), Err(Fault::TooFew { found: 0, needed: 1 }));
    let wide = Rule { band: 0.0, floor: 0.0 };
    assert!(matches!(of_errors(&errors, wide), Err(Fault::Rule { .. })));
    for (band, floor) in [(0.1, -1e-9), (f64::INFINITY, 0.0), (0.1, f64::INFINITY)] {
        let refused = of_errors(&errors, Rule { band, floor });
        assert_eq!(refused, Err(Fault::Rule { band, floor }));
    }
}
