//! With contestants whose times are made up: nothing here depends on a clock.

use std::cell::RefCell;

use super::*;

/// Takes the turns that it is given, one after the other.
fn made_up<'a>(name: &'a str, turns: &'a [Turn], log: &'a RefCell<String>) -> Contestant<'a> {
    let mut turns = turns.iter();
    Contestant::new(name, move || {
        *log.borrow_mut() += name;
        turns.next().copied().ok_or_else(|| anyhow::anyhow!("{name} is tired"))
    })
}

fn taking(seconds: &[f64]) -> Vec<Turn> {
    let turn = |&seconds| Turn { seconds, element_steps: 37, checksum: Some(0xabc) };
    seconds.iter().map(turn).collect()
}

#[test]
fn all_take_turns_and_every_other_round_goes_backward() {
    let log = RefCell::default();
    let turns_of = taking(&[0.3, 0.2, 0.7]);
    let mut all = ["a", "b", "c"].map(|name| made_up(name, &turns_of, &log));
    let timed = turns(3, &mut all).unwrap();
    assert_eq!(*log.borrow(), "abccbaabc");
    assert_eq!(timed.iter().map(|t| t.name.as_str()).collect::<Vec<_>>(), ["a", "b", "c"]);
}

#[test]
fn least_median_and_greatest_are_those_of_the_sorted_times() {
    let log = RefCell::default();
    let (odd, even) = (taking(&[0.31, 0.17, 0.47]), taking(&[0.31, 0.17, 0.47, 0.23]));
    let odd = &turns(3, &mut [made_up("odd", &odd, &log)]).unwrap()[0];
    assert_eq!([odd.least, odd.median, odd.greatest], [0.17, 0.31, 0.47]);
    let even = &turns(4, &mut [made_up("even", &even, &log)]).unwrap()[0];
    // Half the sum of the two in the middle, by hand; equal to the bit, for 0.54 halves exactly.
    assert_eq!([even.least, even.median, even.greatest], [0.17, 0.5 * (0.23 + 0.31), 0.47]);
    assert_eq!((even.element_steps, even.checksum), (37, Some(0xabc)));
}

#[test]
fn ratios_spread_and_the_time_of_an_element_step_are_by_the_least_time() {
    let log = RefCell::default();
    let (first, second) = (taking(&[0.5, 0.8]), taking(&[1.75, 1.25]));
    let mut both = [made_up("first", &first, &log), made_up("second", &second, &log)];
    let timed = turns(2, &mut both).unwrap();
    // Quotients of short binary fractions are exact; the others are the operation itself.
    assert_eq!(timed[1].ratio(&timed[0]), 2.5);
    assert_eq!(timed[0].ratio(&timed[1]), 0.4);
    assert_eq!(timed[1].spread(), 1.75 / 1.25 - 1.0);
    assert_eq!(timed[1].per_element_step(), 1.25 / 37.0);
}

#[test]
fn a_contestant_that_fails_or_does_something_else_ends_the_contest() {
    let log = RefCell::default();
    let one = taking(&[0.3]);
    let fails = turns(2, &mut [made_up("a", &one, &log)]).unwrap_err();
    assert_eq!(fails.to_string(), "a is tired");
    let steady = taking(&[0.3, 0.4]);
    for other in [
        Turn { element_steps: 38, ..steady[1] },
        Turn { checksum: Some(0xabd), ..steady[1] },
        Turn { checksum: None, ..steady[1] },
    ] {
        let unsteady = [steady[0], other];
        let fails = turns(2, &mut [made_up("a", &unsteady, &log)]).unwrap_err();
        assert_eq!(fails.to_string(), "a does not do the same in every turn");
    }
    assert!(turns(0, &mut [made_up("a", &steady, &log)]).is_err());
}

#[test]
fn bits_are_compared_among_those_that_have_a_checksum() {
    let of = |name: &str, checksum| Timed {
        name: name.into(),
        least: 0.3,
        median: 0.4,
        greatest: 0.7,
        element_steps: 37,
        checksum,
    };
    let single = of("single", None);
    let same = [single.clone(), of("a", Some(3)), of("b", Some(3)), single];
    assert!(same_bits(&same).is_ok());
    let fails = same_bits(&[&same[..], &[of("c", Some(4))]].concat()).unwrap_err();
    assert_eq!(fails.to_string(), "the bits of `c` are not those of `a`");
}
