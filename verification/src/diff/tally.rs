//! What is counted while two traces are read.

use super::number::{Apart, Number};
use super::rank::At;
use super::record::{EquationTally, Worst};

/// The count of one equation.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Events that both traces have.
    pub events: u64,
    /// Those that agree, though not to the last bit.
    pub within_tolerance: u64,
    /// Those that differ.
    pub differing: u64,
    /// Events that one trace lacks: those of the first alone, and of the second.
    pub alone: [u64; 2],
    ulp: Option<u64>,
    /// Relative distance, place and quantity.
    farthest: Option<(f64, At, String)>,
}

impl Tally {
    /// A quantity is so far apart.
    pub fn note(&mut self, apart: &Apart, at: At, name: &[u8]) {
        if apart.is_same {
            return;
        }
        self.ulp = self.ulp.max(apart.ulp);
        if self.farthest.as_ref().is_none_or(|(most, ..)| apart.relative > *most) {
            let name = String::from_utf8_lossy(name).into_owned();
            self.farthest = Some((apart.relative, at, name));
        }
    }

    /// Whether there is nothing to tell.
    pub fn is_empty(&self) -> bool {
        self.events == 0 && self.alone == [0, 0]
    }

    /// For the record.
    pub fn record(&self, equation: usize) -> EquationTally {
        let &Self { events, within_tolerance, differing, alone: [only_in_a, only_in_b], .. } = self;
        let worst = self.farthest.as_ref().map(|(relative, at, name)| Worst {
            ulp: self.ulp,
            relative: Number::of(*relative).into(),
            evaluation: (*at).into(),
            name: name.clone(),
        });
        EquationTally {
            eq: equation.to_string(),
            events,
            within_tolerance,
            differing,
            only_in_a,
            only_in_b,
            worst,
        }
    }
}
