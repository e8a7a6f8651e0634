//! A fault planted again, and what the stored kill matrix says of it.

#![allow(clippy::unwrap_used)] // a test may

use std::process::Command;

use assert_cmd::cargo::cargo_bin;
use crossfibre_verification::cases;
use crossfibre_verification::sensitivity::matrix::Row;
use crossfibre_verification::sensitivity::one::ask;
use crossfibre_verification::sensitivity::stored::stored;

/// Runs a case with the fault planted, in a process of its own: its checks fail and stand as the matrix says.
pub fn agrees_with_the_matrix(row: &Row, case: &str) {
    let matrix = stored();
    let mut process = Command::new(cargo_bin!("crossfibre"));
    process.args(["verify", "--plant", &row.id, "--filter", case]);
    let of_name = cases::all().iter().filter(|of| of.id.contains(case)).count();
    let said = ask(&mut process, of_name).unwrap();
    let said = said.iter().find(|said| said.case == case);
    assert_eq!(said.is_none(), row.stops(case), "whether `{}` stops {case}", row.id);
    let Some(said) = said else { return };
    let noticing: Vec<usize> = matrix.noticing(row).collect();
    for (k, check) in matrix.checks.iter().enumerate().filter(|(_, check)| check.case == case) {
        assert_eq!(
            said.stands(&check.claim),
            !noticing.contains(&k),
            "with `{}` planted: {case}: {}\nif that is meant, measure the matrix again by `crossfibre verify \
             --sensitivity --quick --out docs/sensitivity`, read what has changed, and commit it",
            row.id,
            check.claim
        );
    }
}
