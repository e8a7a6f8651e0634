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

fn line(name: &str, scene: &Scene) -> Row {
    let plain = numbers(&run(scene), [0, 0, 0]);
    let mut spoilt = 0;
    let mut ranges = Vec::new();
    for (unit, [a, b, c]) in UNITS {
        let edge = |sign: i32| {
            let powers = move |n: i32| [a, b, c].map(|k| sign * k * n);
            let accepted = |n: &i32| {
                let [a, b, c] = powers(*n);
                check(&rescaled(scene, a, b, c)).is_ok()
            };
            let last = (1..=1100).take_while(accepted).last().unwrap_or(0);
            // Accepted again farther out there must be none.
            let beyond = (last + 1..=1100).filter(accepted).count();
            (last, beyond, powers)
        };
        let [down, up] = [-1, 1].map(edge);
        for (last, beyond, powers) in [down, up] {
            spoilt += beyond;
            for n in (1..=last).filter(|n| n % 23 == 0 || n + 3 > last) {
                let [a, b, c] = powers(n);
                let result = run(&rescaled(scene, a, b, c));
                spoilt += different(&plain, &numbers(&result, powers(n)));
            }
        }
        ranges.push(format!("{unit} 2^-{} to 2^{}", down.0, up.0));
    }
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

fn rows() -> Vec<Row> {
    let mut slow = shipped("single-400");
    slow.projectile.velocity = 1e-3;
    let mut rows: Vec<Row> = ["single-400", "unequal", "finite-projectile"]
        .into_iter()
        .map(|name| line(name, &shipped(name)))
        .collect();
    rows.push(line("single-400 at 1 mm/s", &slow));
    rows
}
