//! The made-up record of hostile names and checks that fail, with the parts whose room on a page is to be
//! tested as they are: ledger, pictures, motion, the kill matrix, and what was examined.

use crossfibre::errata::LEDGER;
use crossfibre_verification::precision::{self, answer::wanted, stored::stored};
use crossfibre_verification::record::{LedgerLine, Record, made_up};
use crossfibre_verification::{examined, pictures, sensitivity};

/// The record.
pub fn record() -> Record {
    Record {
        ledger: LEDGER.iter().map(LedgerLine::from).collect(),
        accuracy: precision::section(stored()),
        cost: wanted::stored(),
        pictures: pictures::all(),
        motion: Some(pictures::motion::fig3()),
        sensitivity: Some(sensitivity::stored::stored().clone()),
        examined: examined::stored(),
        ..made_up::record()
    }
}
