//! The record of a verification, format `crossfibre-report/1`: everything that a report says.
//!
//! Reports are pure functions of it. Times are in it and in `junit.xml`; `VALIDATION.md` leaves them
//! out, so that the same source gives the same file.

use std::collections::BTreeMap;
use std::time::Instant;

use crossfibre::errata::LEDGER;
use crossfibre::place::Fibre;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::Traced;
use crossfibre::trace_file::Filter;
use crossfibre::{corrected::Corrected, corrected::Incremental, march};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::bits::fnv;
use crate::cases::support::{SCENES, coarse_fig3, shipped};
use crate::cases::{Case, Check, Verdict};
use crate::claims::{self, Claim};
use crate::ledger_effects::{self, Effects};
use crate::precision::{self, stored::stored};
use crate::worked::Worked;

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-report/1";

/// Everything that a report says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// `crossfibre-report/1`.
    pub format: String,
    /// Version of crossfibre.
    pub version: String,
    /// The cases that were run, in order.
    pub cases: Vec<CaseRecord>,
    /// The shipped scenes, by name and a digest of their text.
    pub scenes: Vec<SceneDigest>,
    /// The ledger.
    pub ledger: Vec<LedgerLine>,
    /// What the departures from the page do.
    pub effects: Effects,
    /// The paper's claims.
    pub claims: Vec<Claim>,
    /// One step worked by hand.
    pub worked: String,
    /// How accurate for how much work: what the stored record of the study says, in Markdown.
    pub accuracy: String,
}

/// A case and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseRecord {
    /// Its name on the command line.
    pub id: String,
    /// What it is about.
    pub title: String,
    /// The numbered equations that it exercises.
    pub equations: Vec<u8>,
    /// Its comparisons.
    pub checks: Vec<CheckRecord>,
    /// Time it took, s.
    pub seconds: f64,
}

/// A check and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CheckRecord {
    /// The check.
    #[serde(flatten)]
    pub check: Check,
    /// What came of it.
    pub verdict: Verdict,
}

/// A shipped scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SceneDigest {
    /// Its name.
    pub name: String,
    /// Its title.
    pub title: String,
    /// FNV-1a, 64 bits, of its text, in hexadecimal.
    pub digest: String,
}

/// A line of the ledger.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LedgerLine {
    /// Id in scenes.
    pub id: String,
    /// Erratum, reading or report.
    pub kind: String,
    /// The numbered equations concerned.
    pub equations: Vec<u8>,
    /// What the page has.
    pub printed: String,
    /// Why that cannot stand, or what it leaves open.
    pub trouble: String,
    /// What is used.
    pub used: String,
}

/// Runs cases on all cores; `done` is told of each as it ends.
pub fn run_cases(cases: &[Case], done: impl Fn(&CaseRecord) + Sync) -> Vec<CaseRecord> {
    run_watched(cases, |_| (), |_, record| done(record))
}

/// Runs cases on all cores and begins them in their order. `begins` is told of each, `done` of each as it
/// ends, by its place in the order.
pub fn run_watched(
    cases: &[Case],
    begins: impl Fn(&Case) + Sync,
    done: impl Fn(usize, &CaseRecord) + Sync,
) -> Vec<CaseRecord> {
    let run = |(place, case): (usize, &Case)| {
        begins(case);
        let start = Instant::now();
        let checks = (case.run)()
            .into_iter()
            .map(|check| CheckRecord { verdict: check.verdict(), check })
            .collect();
        let record = CaseRecord {
            id: case.id.into(),
            title: case.title.into(),
            equations: case.equations.to_vec(),
            checks,
            seconds: start.elapsed().as_secs_f64(),
        };
        done(place, &record);
        (place, record)
    };
    // A slice would be divided in halves, and the second begun before the first is done.
    let records: BTreeMap<_, _> = cases.iter().enumerate().par_bridge().map(run).collect();
    records.into_values().collect()
}

impl CaseRecord {
    /// The checks that did not pass.
    pub fn troubles(&self) -> impl Iterator<Item = &CheckRecord> {
        self.checks.iter().filter(|c| c.verdict != Verdict::Passed)
    }
}

impl Record {
    /// Measures what a report says beside the cases.
    pub fn around(cases: Vec<CaseRecord>) -> Self {
        let scenes = SCENES
            .iter()
            .map(|(name, text)| SceneDigest {
                name: (*name).into(),
                title: shipped(name).title,
                digest: format!("{:016x}", fnv(text.bytes())),
            })
            .collect();
        let ledger = LEDGER
            .iter()
            .map(|entry| LedgerLine {
                id: entry.id.into(),
                kind: format!("{:?}", entry.kind).to_lowercase(),
                equations: entry.equations.to_vec(),
                printed: entry.printed.into(),
                trouble: entry.trouble.into(),
                used: entry.used.into(),
            })
            .collect();
        Self {
            format: FORMAT.into(),
            version: env!("CARGO_PKG_VERSION").into(),
            cases,
            scenes,
            ledger,
            effects: ledger_effects::measure(),
            claims: claims::examine(),
            worked: worked_step(),
            accuracy: precision::section(stored()),
        }
    }

    /// A record of nothing, to fill in tests.
    #[cfg(test)]
    pub(crate) fn empty() -> Self {
        Self {
            format: FORMAT.into(),
            version: String::new(),
            cases: vec![],
            scenes: vec![],
            ledger: vec![],
            effects: Effects {
                crossover: vec![],
                exact: Default::default(),
                projectile: vec![],
                remarks: vec![],
            },
            claims: vec![],
            worked: String::new(),
            accuracy: String::new(),
        }
    }

    /// The number of checks, and of those that passed.
    pub fn tally(&self) -> (usize, usize) {
        let checks = self.cases.iter().flat_map(|case| &case.checks);
        checks.fold((0, 0), |(all, passed), c| {
            (all + 1, passed + usize::from(c.verdict == Verdict::Passed))
        })
    }
}

/// The crossover's node of a coarse Fig. 3 in the step after the wave has entered the secondary, and
/// the element behind it.
fn worked_step() -> String {
    let scene = coarse_fig3();
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let step = 4;
    let filter = |indices, equations: &[u8]| Filter {
        steps: Some(step..=step),
        indices: Some(indices),
        fibre: Some(Fibre::Primary),
        equations: equations.to_vec(),
    };
    [filter(2..=2, &[2, 15, 16, 17, 18]), filter(1..=1, &[5, 6, 4, 7])]
        .into_iter()
        .map(|filter| {
            let mut text = Vec::new();
            let traced = Traced::new(&paper, Worked::new(&mut text, &scene, &paper, filter));
            let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
            march::run(&traced, &mut state, step, |_| {});
            traced.into_sink().finish().expect("a vector can be written to");
            String::from_utf8(text).expect("worked lines are text")
        })
        .collect()
}
