//! Faults of the stored record of error against work.

use crate::precision::record::{Entry, Record};

faults! {
    Exchanged "record-exchanged" "exchanges the readings of two variants";
    Stagnant "record-stagnant" "gives the finest mesh the readings of the one before";
    OneMore "record-one-more" "counts an evaluation more in every run";
    ElementsTwice "record-elements-twice" "counts element-steps twice";
    StepLate "record-step-late" "says that a run reached the time of a step more";
    Lost "record-lost" "has lost its last run";
    Rounded "record-rounded" "keeps its readings in single precision";
}

/// Variants whose readings are exchanged.
const EXCHANGED: [&str; 2] = ["eqn (4), α = 1", "engineering, α = 1"];

impl Wrong {
    /// Makes the record wrong.
    pub fn put_into(self, record: &mut Record) {
        let entries = &mut record.entries;
        match self {
            Self::Exchanged => {
                for entry in entries {
                    let here = EXCHANGED.iter().position(|name| *name == entry.variant);
                    if let Some(here) = here {
                        entry.variant = EXCHANGED[1 - here].into();
                    }
                }
            }
            Self::Stagnant => {
                let belongs_together =
                    |a: &Entry, b: &Entry| a.problem == b.problem && a.variant == b.variant;
                for i in 1..entries.len() {
                    let is_last =
                        entries.get(i + 1).is_none_or(|e| !belongs_together(e, &entries[i]));
                    if is_last && belongs_together(&entries[i - 1], &entries[i]) {
                        entries[i].found.readings = entries[i - 1].found.readings.clone();
                    }
                }
            }
            Self::OneMore => entries.iter_mut().for_each(|e| e.found.evaluations += 1),
            Self::ElementsTwice => entries.iter_mut().for_each(|e| e.found.element_steps *= 2),
            Self::StepLate => {
                for found in entries.iter_mut().map(|entry| &mut entry.found) {
                    found.time += found.time / found.steps as f64;
                }
            }
            Self::Lost => {
                entries.pop();
            }
            Self::Rounded => {
                let readings = entries.iter_mut().flat_map(|entry| &mut entry.found.readings);
                for reading in readings {
                    reading.value = f64::from(reading.value as f32);
                }
            }
        }
    }
}
