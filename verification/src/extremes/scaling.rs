//! Other units, by powers of two, until the program refuses them.

use crossfibre::result::{FibreResult, RunResult};
use crossfibre::scene::Scene;

use super::{Group, Row, checks, row, run};
use crate::cases::invariance::rescaled;
use crate::cases::support::shipped;
use crate::cases::{Bound, Case};
use crate::planted::check;

pub(super) const GROUP: Group = Group {
    case: Case {
        id: "extreme.scaling",
        title: "Units from 2^-1100 to 2^1100 m, s and kg: the same bits or refused",
        equations: &[2, 4, 5, 6, 7, 8, 15, 16, 17, 18, 20],
        run: || checks(rows()),
    },
    rows,
    found: "\
Powers of two round nothing, so another unit must give the same bits for as long as no product under- or
overflows. That the quantities of a scene are normal numbers is not enough: over hundreds of powers of two
tensions and energies would be subnormal and lose digits without a word. So a scene is refused unless the
quantities that a run multiplies lie within 1e-200 to 1e200.",
};

/// A unit that changes: powers of length, time and mass, and how to say it.
const UNITS: [(&str, [i32; 3]); 5] = [
    ("length", [1, 0, 0]),
    ("time", [0, 1, 0]),
    ("mass", [0, 0, 1]),
    ("length and time", [1, 1, 0]),
    ("all three", [1, 1, 1]),
];

/// 2^n times a number, in two steps so that neither factor is out of range.
fn times_power(x: f64, n: i32) -> f64 {
    let half = n / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(n - half)
}

/// Every number of a result by kind, in the first units.
fn numbers(result: &RunResult, [a, b, c]: [i32; 3]) -> Vec<Vec<f64>> {
    let fibre = |f: &FibreResult| {
        let kind = |n: i32, of: &mut dyn Iterator<Item = f64>| {
            of.map(|x| times_power(x, n)).collect::<Vec<_>>()
        };
        [
            kind(-a, &mut f.position.iter().flatten().copied()),
            kind(b - a, &mut f.velocity.iter().flatten().copied()),
            kind(0, &mut f.strain.iter().copied()),
            kind(2 * b - a - c, &mut f.tension.iter().copied()),
        ]
    };
    let mut all: Vec<Vec<f64>> = [Some(&result.primary), result.secondary.as_ref()]
        .into_iter()
        .flatten()
        .flat_map(fibre)
        .collect();
    all.push(vec![times_power(result.projectile.velocity, b - a)]);
    let energy = result.balance.map_or(f64::NAN, |balance| balance.energy.kinetic);
    all.push(vec![times_power(energy, 2 * b - 2 * a - c)]);
    all
}

/// Numbers of 1e-60 of the greatest of their kind and more whose bits differ: the forerunners of a
/// front die away through all the numbers that there are.
fn different(plain: &[Vec<f64>], scaled: &[Vec<f64>]) -> usize {
    plain
        .iter()
        .zip(scaled)
        .map(|(plain, scaled)| {
            let greatest = plain.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let pairs = plain.iter().zip(scaled);
            pairs.filter(|(p, s)| p.abs() > 1e-60 * greatest && p.to_bits() != s.to_bits()).count()
        })
        .sum()
}

/// How far a unit can be changed in one direction, and what is spoilt.
struct Reach {
    /// The last power of two before one is refused.
    last: i32,
    /// Numbers that differ in the scenes that are run, and powers accepted beyond a refused one.
    spoilt: usize,
}

impl Reach {
    fn of(accepted: impl Fn(&i32) -> bool, different: impl Fn(i32) -> usize) -> Self {
        let last = (1..=1100).take_while(&accepted).last().unwrap_or(0);
        let beyond = (last + 1..=1100).filter(accepted).map(|_| 1);
        let run = (1..=last).filter(|n| n % 23 == 0 || n + 3 > last);
        Self { last, spoilt: beyond.chain(run.map(different)).sum() }
    }
}

/// Of each unit, down and up. `different` is asked about the scenes that are run, and their powers.
fn reaches(scene: &Scene, different: impl Fn(&Scene, [i32; 3]) -> usize) -> [[Reach; 2]; 5] {
    UNITS.map(|(_, powers)| {
        [-1, 1].map(|sign| {
            let powers = |n: i32| powers.map(|power| sign * power * n);
            let scaled = |n: i32| {
                let [a, b, c] = powers(n);
                rescaled(scene, a, b, c)
            };
            Reach::of(|&n| check(&scaled(n)).is_ok(), |n| different(&scaled(n), powers(n)))
        })
    })
}

fn line((name, scene): (String, Scene)) -> Row {
    let plain = numbers(&run(&scene), [0, 0, 0]);
    let reaches =
        reaches(&scene, |scaled, powers| different(&plain, &numbers(&run(scaled), powers)));
    let said = UNITS
        .iter()
        .zip(&reaches)
        .map(|((unit, _), [down, up])| format!("{unit} 2^-{} to 2^{}", down.last, up.last));
    let ranges: Vec<_> = said.collect();
    let spoilt: usize = reaches.iter().flatten().map(|reach| reach.spoilt).sum();
    row(
        name,
        "The same bits, or refused",
        format!("completed for {}, else refused", ranges.join("; ")),
        "dimensional analysis: powers of two round nothing",
        "numbers over 1e-60 of the greatest of their kind whose bits differ; units accepted beyond \
         a refused one",
        spoilt as f64,
        Bound::Exactly(0.0),
        "no operation mixes units, and none under- or overflows",
    )
}

fn scenes() -> [(String, Scene); 4] {
    let mut slow = shipped("single-400");
    slow.projectile.velocity = 1e-3;
    let [single, unequal, finite] =
        ["single-400", "unequal", "finite-projectile"].map(|name| (name.into(), shipped(name)));
    [single, unequal, finite, ("single-400 at 1 mm/s".into(), slow)]
}

fn rows() -> Vec<Row> {
    scenes().map(line).into()
}

/// A unit, and between which powers of two it may be.
pub type Range = (&'static str, [i32; 2]);

/// The scenes, and the ranges of their units.
pub fn drawn() -> [(String, [Range; 5]); 4] {
    scenes().map(|(name, scene)| {
        let reaches = reaches(&scene, |_, _| 0);
        let range = |k: usize| (UNITS[k].0, [-reaches[k][0].last, reaches[k][1].last]);
        (name, std::array::from_fn(range))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_may_be_one_that_no_number_is() {
        // 2^-1100 is not a double, nor is 2^1100.
        assert_eq!(times_power(2.0_f64.powi(1000), -1100), 2.0_f64.powi(-100));
        assert_eq!(times_power(2.0_f64.powi(-1000), 1101), 2.0_f64.powi(101));
    }

    #[test]
    fn numbers_that_differ_are_counted_from_1e_60_of_the_greatest_of_their_kind_on() {
        let plain = [vec![1.0, 0.3], vec![0.7]];
        assert_eq!(different(&plain, &plain), 0);
        assert_eq!(different(&plain, &[vec![-1.0, 0.3], vec![0.1]]), 2);
        let of_one =
            |plain: [f64; 3], scaled: [f64; 3]| different(&[plain.to_vec()], &[scaled.to_vec()]);
        assert_eq!(of_one([1.0, 2e-60, 1e-60], [1.0, 0.0, 0.0]), 1);
        assert_eq!(of_one([-1e10, 1e-55, 2e-50], [-1e10, 0.0, 0.0]), 1);
    }

    #[test]
    fn what_is_spoilt_differs_in_a_scene_that_is_run_or_is_accepted_beyond_a_refused_one() {
        let run = std::cell::RefCell::new(vec![]);
        let accepted = |&n: &i32| n <= 50 || n == 53 || n == 1100;
        let reach = Reach::of(accepted, |n| {
            run.borrow_mut().push(n);
            if n == 46 { 5 } else { 0 }
        });
        assert_eq!((reach.last, reach.spoilt), (50, 2 + 5));
        // Every 23rd, and the last three.
        assert_eq!(run.into_inner(), [23, 46, 48, 49, 50]);
        let none = Reach::of(|_| false, |_| 1);
        assert_eq!((none.last, none.spoilt), (0, 0));
    }
}
