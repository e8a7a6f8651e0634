//! A record of a few cases, with all that a report can hold: something fails, names are hostile, and
//! faults were planted.

#![allow(clippy::unwrap_used)] // a test may
#![allow(dead_code)] // each test file uses its part

use crossfibre::errata::{Entry, LEDGER};
use crossfibre_verification::cases::{self, Bound, verdicts};
use crossfibre_verification::claims::{Claim, Finding};
use crossfibre_verification::examined;
use crossfibre_verification::ledger_effects::{CrossoverRow, Effects};
use crossfibre_verification::pictures;
use crossfibre_verification::precision::{self, answer::wanted, stored::stored};
use crossfibre_verification::record::{
    self, Build, CheckRecord, LedgerLine, Record, SceneDigest, run_cases,
};
use crossfibre_verification::sensitivity::matrix::{Column, FORMAT, Matrix, Row};

/// Text that would break out of HTML, XML, Markdown or a shell.
pub const HOSTILE: &str = "<script>alert(1)</script> \"&' | `x` ]]> --> $(x)\n# [y](javascript:z) \u{1b}[0m\u{0} \u{202e}abc";

/// The record. Its cases are run and its pictures drawn; what takes long to measure is made up.
pub fn record() -> Record {
    let few: Vec<_> = cases::all()
        .into_iter()
        .filter(|case| {
            ["smith.density", "projectile.momentum", "identity.causality"].contains(&case.id)
        })
        .collect();
    let cases = run_cases(&few, |_| ());
    assert_eq!(cases.len(), 3);
    let mut record = Record {
        format: record::FORMAT.into(),
        version: "0.0.7".into(),
        build: Build::here(),
        cases,
        scenes: vec![SceneDigest {
            name: "fig3".into(),
            title: HOSTILE.into(),
            digest: "00c0ffee00c0ffee".into(),
        }],
        ledger: LEDGER.iter().map(ledger_line).collect(),
        effects: Effects {
            crossover: vec![CrossoverRow { corrections: "all".into(), ..Default::default() }],
            exact: CrossoverRow { corrections: "closed form".into(), ..Default::default() },
            projectile: vec![],
            remarks: vec![],
        },
        claims: [Finding::Reproduced, Finding::NotReproduced, Finding::Undecidable]
            .map(|finding| Claim { claim: HOSTILE.into(), finding, evidence: "4.41 %".into() })
            .into(),
        worked: "step 4, primary, node 2\n".into(),
        accuracy: precision::section(stored()),
        cost: wanted::stored(),
        pictures: pictures::all(),
        motion: Some(pictures::motion::fig3()),
        sensitivity: None,
        examined: examined::stored(),
    };
    let mut troubled = record.cases[0].clone();
    troubled.id = HOSTILE.into();
    troubled.title = HOSTILE.into();
    troubled.checks[0].check.claim = HOSTILE.into();
    troubled.checks[0].check.measured = f64::NAN;
    troubled.checks[1].check.bound = Bound::AtMost(37.0);
    let checks: Vec<_> = troubled.checks.into_iter().map(|record| record.check).collect();
    let judged = verdicts(&checks);
    let judged = checks.into_iter().zip(judged);
    troubled.checks = judged.map(|(check, verdict)| CheckRecord { check, verdict }).collect();
    record.cases.push(troubled);
    record.sensitivity = Some(matrix(&record));
    record
}

fn ledger_line(entry: &Entry) -> LedgerLine {
    LedgerLine {
        id: entry.id.into(),
        kind: format!("{:?}", entry.kind).to_lowercase(),
        equations: entry.equations.to_vec(),
        printed: entry.printed.into(),
        trouble: entry.trouble.into(),
        used: entry.used.into(),
    }
}

fn matrix(record: &Record) -> Matrix {
    let column = |case: &str, check: &CheckRecord| Column {
        case: case.into(),
        claim: check.check.claim.clone(),
        quick: true,
    };
    let checks: Vec<Column> = (record.cases.iter())
        .flat_map(|case| case.checks.iter().map(move |check| column(&case.id, check)))
        .collect();
    let groups = ["equation 2", "equation 8", "march", "material", "exact", "record"];
    let row = |k: usize| Row {
        id: format!("fault-{k}"),
        group: groups[k * groups.len() / 30].into(),
        what: "half of it".into(),
        caught_by: (0..checks.len()).filter(|check| (check * 7 + k * 5) % 11 < 4).collect(),
        stopped: if k % 9 == 4 { vec!["smith.density".into()] } else { vec![] },
    };
    Matrix {
        format: FORMAT.into(),
        version: record.version.clone(),
        faults: (0..30).map(row).collect(),
        rewrites: vec![],
        checks,
    }
}
