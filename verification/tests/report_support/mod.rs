//! The made-up record of hostile names and checks that fail, with the parts whose room on a page is to be
//! tested as they are: ledger, pictures, motion, the kill matrix, and what was examined.

use crossfibre::errata::LEDGER;
use crossfibre_verification::precision::{self, answer::wanted, stored::stored};
use crossfibre_verification::record::{CaseRecord, LedgerLine, Record, made_up};
use crossfibre_verification::{examined, pictures, sensitivity};

/// The record.
pub fn record() -> Record {
    let made_up = made_up::record();
    // Titles of every length: some fill their last line.
    let titled = |words: usize| CaseRecord {
        id: format!("titled.{words}"),
        title: "word ".repeat(words),
        ..made_up.cases[0].clone()
    };
    Record {
        cases: made_up.cases.iter().cloned().chain((0..30).map(titled)).collect(),
        ledger: LEDGER.iter().map(LedgerLine::from).collect(),
        accuracy: precision::section(stored()),
        cost: wanted::stored(),
        pictures: pictures::all(),
        motion: Some(pictures::motion::fig3()),
        sensitivity: Some(sensitivity::stored::stored().clone()),
        examined: examined::stored(),
        ..made_up
    }
}
