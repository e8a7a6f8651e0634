//! A record of a verification that never was, for tests: small, complete, with every verdict, with hostile
//! names, and with a number that is none.

use crate::cases::{Bound, Check, verdicts};
use crate::claims::{Claim, Finding};
use crate::derivations::Derivation;
use crate::examined::Examination;
use crate::ledger_effects::{CrossoverRow, Effects, ProjectileRow, Remark};
use crate::pictures::{Picture, Section};
use crate::record::{Build, CaseRecord, CheckRecord, FORMAT, LedgerLine, Record, SceneDigest};
use crate::sensitivity::matrix::{self, Column, Matrix, Row};

/// Text that would break out of HTML, XML, Markdown or a shell.
pub const HOSTILE: &str = "<script>alert(1)</script> \"&' | `x` ]]> --> $(x)\n# [y](javascript:z) \u{1b}[0m\u{0} \u{202e}abc";

fn check(claim: &str, measured: f64, bound: Bound) -> Check {
    Check {
        claim: claim.into(),
        oracle: "Smith's relation".into(),
        norm: "relative".into(),
        measured,
        bound,
        reason: "oscillations of the front".into(),
    }
}

fn case(id: &str, title: &str, checks: Vec<Check>) -> CaseRecord {
    let judged = verdicts(&checks);
    let checks =
        checks.into_iter().zip(judged).map(|(check, verdict)| CheckRecord { check, verdict });
    CaseRecord {
        id: id.into(),
        title: title.into(),
        quick: true,
        equations: vec![2, 7],
        derivation: vec![Derivation {
            title: "Transverse impact on one long fibre".into(),
            path: "docs/exact/smith.md#derivation".into(),
        }],
        pictures: vec!["fig3".into()],
        checks: checks.collect(),
        seconds: 0.027,
    }
}

/// A record in which everything is there and everything passes.
pub fn passing() -> Record {
    let all_pass = vec![
        check("The plateau is Smith's", 1.37e-4, Bound::AtMost(5.1e-4)),
        check("A fault shows", 0.31, Bound::AtLeast(0.11)),
        check("The order is one", 1.03, Bound::Within(0.8, 1.2)),
        check("Bits are the same", 0.0, Bound::Exactly(0.0)),
    ];
    let cases = vec![case("smith.plateau", "The plateau", all_pass)];
    let column = |check: &CheckRecord| Column {
        case: "smith.plateau".into(),
        claim: check.check.claim.clone(),
        quick: true,
    };
    let row = |id: &str, group: &str, caught_by: Vec<usize>, stopped: &[&str]| Row {
        id: id.into(),
        group: group.into(),
        what: "half of it".into(),
        caught_by,
        stopped: stopped.iter().map(|&id| id.into()).collect(),
    };
    let sensitivity = Matrix {
        format: matrix::FORMAT.into(),
        version: "0.0.7".into(),
        checks: cases[0].checks.iter().map(column).collect(),
        faults: vec![
            row("7-half", "equation 7", vec![0, 2], &[]),
            row("march-late", "march", vec![], &["smith.plateau"]),
            row("record-unseen", "record", vec![], &[]),
        ],
        rewrites: vec![],
    };
    Record {
        format: FORMAT.into(),
        version: "0.0.7".into(),
        build: Build { commit: Some("0123abc".into()), modified: Some(true), ..Build::here() },
        cases,
        left_out: vec![],
        scenes: vec![SceneDigest {
            name: "fig3".into(),
            title: "Fig. 3".into(),
            digest: "00c0ffee00c0ffee".into(),
        }],
        ledger: vec![LedgerLine {
            id: "perpendicular-sign".into(),
            kind: "erratum".into(),
            equations: vec![17],
            printed: "+ T2_perp".into(),
            trouble: "the normal has a negative part".into(),
            used: "− T2_perp".into(),
        }],
        effects: effects(),
        claims: [Finding::Reproduced, Finding::NotReproduced, Finding::Undecidable]
            .map(|finding| Claim {
                claim: "R is near 1 %".into(),
                finding,
                evidence: "4.41 % by the closed form".into(),
            })
            .into(),
        worked: "v = 3\n".into(),
        accuracy: "## How\n\nWords.\n\n| a | b |\n| --- | --- |\n| 1 | 2 |\n".into(),
        cost: Default::default(),
        pictures: vec![Picture {
            id: "fig3".into(),
            section: Section::Figures,
            title: "Fig. 3".into(),
            caption: "Strain along both fibres".into(),
            alt: "Two curves".into(),
            svg: "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"7\" height=\"5\"/>".into(),
        }],
        motion: None,
        sensitivity: Some(sensitivity),
        examined: vec![Examination {
            what: "mutants".into(),
            tool: "cargo-gamma".into(),
            date: "1980-03-07".into(),
            commits: vec!["0123abc".into(), "4567def".into()],
            counts: vec![(37, "mutants".into()), (3, "survived".into())],
            page: "mutants.md".into(),
        }],
    }
}

fn effects() -> Effects {
    Effects {
        crossover: vec![CrossoverRow { corrections: "all".into(), ..Default::default() }],
        exact: CrossoverRow { corrections: "closed form".into(), ..Default::default() },
        projectile: vec![ProjectileRow {
            corrections: "none".into(),
            outcome: "diverged".into(),
            velocity: 399.1,
            energy: f64::INFINITY,
            momentum: f64::NAN,
        }],
        remarks: vec![Remark { id: "density".into(), effect: "1.63 %".into() }],
    }
}

/// A record with a case of every verdict and every kind of bound, and names to break out of any text.
pub fn record() -> Record {
    let mut record = passing();
    let troubled = vec![
        check("It passes", 0.7, Bound::AtMost(1.1)),
        check("It fails", 1.7, Bound::AtMost(1.1)),
        check("It is loose", 0.07, Bound::AtMost(1.1)),
        check("It is no number", f64::NAN, Bound::Within(0.3, 0.9)),
        check("It passes", 0.9, Bound::AtMost(1.1)),
    ];
    record.cases.push(case("a.troubled", "Everything that can go wrong", troubled));
    let hostile = vec![check(HOSTILE, 2.3, Bound::AtMost(1.1))];
    record.cases.push(CaseRecord {
        derivation: vec![Derivation { title: HOSTILE.into(), path: HOSTILE.into() }],
        ..case(HOSTILE, HOSTILE, hostile)
    });
    let words = || HOSTILE.to_owned();
    record.scenes.push(SceneDigest { name: words(), title: words(), digest: words() });
    record.claims[1].claim = words();
    record.claims[1].evidence = words();
    record.ledger[0].id = words();
    record.worked = words();
    record.accuracy += "<b>bold</b> \u{202e}";
    record.effects.remarks[0].effect = words();
    record.pictures[0] = Picture {
        id: words(),
        section: Section::Cost,
        title: words(),
        caption: words(),
        alt: words(),
        svg: format!("<svg xmlns=\"http://www.w3.org/2000/svg\"><!--\"#%'\n{HOSTILE}--></svg>"),
    };
    if let Some(matrix) = &mut record.sensitivity {
        matrix.faults[0].id = words();
        matrix.faults[0].what = words();
    }
    record.examined[0] = Examination {
        what: words(),
        tool: words(),
        date: words(),
        commits: vec![words()],
        counts: vec![(7, words())],
        page: words(),
    };
    record
}

/// All that was measured by the checks of a record.
pub fn measured(record: &Record) -> impl Iterator<Item = f64> {
    record.cases.iter().flat_map(|case| &case.checks).map(|record| record.check.measured)
}
