//! The record of a verification, format `crossfibre-report/1`: everything that a report says.
//!
//! Reports are pure functions of it. Times and the build are in it, in `report.html` and in part in
//! `junit.xml`; `VALIDATION.md` leaves them out, so that the same source gives the same file.

mod build;
mod made;
pub mod made_up;
mod read;

use crossfibre::errata::Entry;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cases::{Check, Verdict};
use crate::claims::Claim;
use crate::derivations::Derivation;
use crate::examined::Examination;
use crate::ledger_effects::Effects;
use crate::pictures::{Picture, motion::Motion};
use crate::precision::answer::wanted::Cost;
use crate::sensitivity::matrix::Matrix;

pub use build::Build;
pub use made::{run_cases, run_watched};
pub use read::{Fault, RIGHT_FILE};

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-report/1";

/// Everything that a report says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// `crossfibre-report/1`.
    pub format: String,
    /// Version of crossfibre.
    pub version: String,
    /// How the program was built.
    pub build: Build,
    /// The cases that were run, in order.
    pub cases: Vec<CaseRecord>,
    /// The names of those that an ordinary verification runs and this did not.
    #[serde(default)]
    pub left_out: Vec<String>,
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
    /// The same in short, with the times that were measured.
    pub cost: Cost,
    /// Pictures, drawn when the record was made.
    pub pictures: Vec<Picture>,
    /// Both fibres in motion.
    pub motion: Option<Motion>,
    /// Which check notices which fault; none if that was not examined.
    pub sensitivity: Option<Matrix>,
    /// What was examined apart from this.
    #[serde(default)]
    pub examined: Vec<Examination>,
}

/// A case and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseRecord {
    /// Its name on the command line.
    pub id: String,
    /// What it is about.
    pub title: String,
    /// Whether `verify --quick` runs it.
    pub quick: bool,
    /// The numbered equations that it exercises.
    pub equations: Vec<u8>,
    /// Where its oracles are derived.
    pub derivation: Vec<Derivation>,
    /// The ids of pictures that show what it is about.
    pub pictures: Vec<String>,
    /// Its comparisons.
    pub checks: Vec<CheckRecord>,
    /// Time it took, s.
    pub seconds: f64,
}

/// A check and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckRecord {
    /// The check.
    #[serde(flatten)]
    pub check: Check,
    /// What came of it.
    pub verdict: Verdict,
}

/// A shipped scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneDigest {
    /// Its name.
    pub name: String,
    /// Its title.
    pub title: String,
    /// FNV-1a, 64 bits, of its text, in hexadecimal.
    pub digest: String,
}

/// A line of the ledger.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
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

impl From<&Entry> for LedgerLine {
    fn from(entry: &Entry) -> Self {
        Self {
            id: entry.id.into(),
            kind: format!("{:?}", entry.kind).to_lowercase(),
            equations: entry.equations.to_vec(),
            printed: entry.printed.into(),
            trouble: entry.trouble.into(),
            used: entry.used.into(),
        }
    }
}

impl CaseRecord {
    /// The checks that did not pass.
    pub fn troubles(&self) -> impl Iterator<Item = &CheckRecord> {
        self.checks.iter().filter(|c| c.verdict != Verdict::Passed)
    }
}

impl Record {
    /// The number of checks, and of those that passed.
    pub fn tally(&self) -> (usize, usize) {
        let checks = self.cases.iter().flat_map(|case| &case.checks);
        checks.fold((0, 0), |(all, passed), c| {
            (all + 1, passed + usize::from(c.verdict == Verdict::Passed))
        })
    }

    /// The record as JSON.
    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).expect("numbers that are not finite are words") + "\n"
    }
}
