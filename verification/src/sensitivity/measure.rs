//! The matrix, measured: a process for each fault.

use std::env;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use rayon::prelude::*;

use super::matrix::{Column, FORMAT, Matrix, Row};
use super::one::{Said, ask};
use crate::cases::{Case, Check, Verdict};
use crate::planted::{self, Fault};

/// The cases that are asked, and the arguments by which `verify` chooses them.
pub struct Asked<'a> {
    /// The cases.
    pub cases: &'a [Case],
    /// `--quick`, `--filter PART`.
    pub arguments: &'a [String],
}

/// Measures it for these faults and all rewrites; `done` is told of each.
///
/// # Errors
/// A check fails although nothing is planted, or a process cannot be asked.
pub fn measure(asked: &Asked<'_>, faults: &[Fault], done: impl Fn() + Sync) -> Result<Matrix> {
    let checks = columns(asked.cases)?;
    let program = env::current_exe().context("this program's own file")?;
    let rows = |faults: &[Fault]| {
        faults
            .par_iter()
            .map(|fault| {
                let mut process = Command::new(&program);
                process.args(["verify", "--plant", fault.id]).args(asked.arguments);
                // As many processes as cores.
                process.env("RAYON_NUM_THREADS", "1");
                let said = ask(&mut process, asked.cases.len())
                    .with_context(|| format!("with `{}` planted", fault.id))?;
                done();
                Ok(row(fault, asked.cases, &checks, &said))
            })
            .collect::<Result<Vec<_>>>()
    };
    let (faults, rewrites) = (rows(faults)?, rows(&planted::rewrites())?);
    let (format, version) = (FORMAT.into(), env!("CARGO_PKG_VERSION").into());
    Ok(Matrix { format, version, checks, faults, rewrites })
}

/// The checks as they are without a fault.
///
/// # Errors
/// One does not pass.
pub fn columns(cases: &[Case]) -> Result<Vec<Column>> {
    let of_each: Vec<Vec<Column>> = cases
        .par_iter()
        .map(|case| (case.run)().into_iter().map(|check| column(case, check)).collect())
        .collect::<Result<_>>()?;
    Ok(of_each.concat())
}

fn column(case: &Case, check: Check) -> Result<Column> {
    ensure!(
        check.verdict() == Verdict::Passed,
        "`{}` of {1} fails with nothing planted: `crossfibre verify --filter {1}` says why",
        check.claim,
        case.id
    );
    Ok(Column { case: case.id.into(), claim: check.claim, quick: case.is_quick() })
}

fn row(fault: &Fault, cases: &[Case], checks: &[Column], said: &[Said]) -> Row {
    let of = |case: &str| said.iter().find(|said| said.case == case);
    let falls = |check: &Column| of(&check.case).is_some_and(|said| !said.stands(&check.claim));
    Row {
        id: fault.id.into(),
        group: fault.group.to_string(),
        what: fault.what.into(),
        caught_by: (0..checks.len()).filter(|&i| falls(&checks[i])).collect(),
        stopped: cases.iter().map(|c| c.id).filter(|id| of(id).is_none()).map(Into::into).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planted::Group;

    #[test]
    fn a_check_that_falls_or_is_gone_has_caught_the_fault_and_a_silent_case_was_stopped() {
        let case = |id| Case { id, title: "", equations: &[], run: Vec::new };
        let column = |case: &str, claim: &str| Column {
            case: case.into(),
            claim: claim.into(),
            quick: true,
        };
        let checks = [
            column("tells", "stands"),
            column("tells", "falls"),
            column("tells", "is gone"),
            column("is silent", "anything"),
        ];
        let said = [Said {
            case: "tells".into(),
            checks: vec![("stands".into(), true), ("falls".into(), false)],
        }];
        let fault = Fault { id: "a-fault", group: Group::March, what: "errs" };
        let row = row(&fault, &[case("tells"), case("is silent")], &checks, &said);
        assert_eq!(row.caught_by, [1, 2]);
        assert_eq!(row.stopped, ["is silent"]);
    }
}
