//! What the runs of the study take on one machine, format `crossfibre-times/1`. Apart from the record,
//! since it is another on every machine and every time.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, anyhow, ensure};
use crossfibre::scene::Strain;
use serde::{Deserialize, Serialize};

use super::problems::Problem;

/// The format that this version reads and writes.
pub const FORMAT: &str = "crossfibre-times/1";

/// The contestant that is the engine in vectors, by its own program.
pub const ENGINE: &str = "engine in vectors";

/// Measured times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Times {
    /// `crossfibre-times/1`.
    pub format: String,
    /// The machine, in words.
    pub machine: String,
    /// The calibration loop: by it the times of two machines are set in relation.
    pub calibration: Seconds,
    /// How often each was run, in turns with all others of its problem.
    pub rounds: usize,
    /// The marches.
    pub runs: Vec<TimedRun>,
    /// The exact solutions.
    pub exact: Vec<TimedExact>,
}

/// The times of all rounds, s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seconds {
    /// The least: what it takes when nothing disturbs it.
    pub least: f64,
    /// The median.
    pub median: f64,
    /// The greatest.
    pub greatest: f64,
}

/// A march on a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TimedRun {
    /// The problem.
    pub problem: Problem,
    /// The variant's name, or [`ENGINE`], whose bits are those of the first variant.
    pub contestant: String,
    /// Elements of the primary.
    pub elements: usize,
    /// What it takes.
    pub seconds: Seconds,
    /// Machine instructions from the start to the end of the march; none where they were not counted.
    pub instructions: Option<f64>,
}

/// An exact solution at a resolution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TimedExact {
    /// The problem.
    pub problem: Problem,
    /// Whose law.
    pub strain: Strain,
    /// What waves and distances are resolved.
    pub resolution: f64,
    /// Meetings of fronts.
    pub meetings: u64,
    /// The mean error of strain that it admits, over the mean strain of the primary.
    pub error_bound: f64,
    /// What it takes.
    pub seconds: Seconds,
}

impl Times {
    /// The times of an earlier study.
    pub fn read(path: &Path) -> Result<Self> {
        let name = path.display();
        let text = fs::read_to_string(path).with_context(|| format!("{name}: cannot be read"))?;
        let help = "help: name the times.json that `study work-precision` has written";
        Self::parse(&text).map_err(|error| anyhow!("{name}: {error}\n  {help}"))
    }

    /// The times that a text holds.
    pub fn parse(text: &str) -> Result<Self> {
        let times: Self = serde_json::from_str(text)?;
        ensure!(times.format == FORMAT, "is `{}`, not `{FORMAT}`", times.format);
        Ok(times)
    }

    /// The times as JSON.
    pub fn json(&self) -> String {
        let json = serde_json::to_string_pretty(self).expect("its numbers are finite");
        json + "\n"
    }
}
