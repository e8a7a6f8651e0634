//! A result for programs that plot or calculate elsewhere: JSON, CSV, and what NumPy loads.

mod csv;
#[cfg(feature = "npz")]
mod npz;

use std::io::{self, Write};
use std::path::Path;

use anyhow::Result;
use clap::ValueEnum;
use crossfibre::result::{FibreResult, RunResult};

/// A format of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// All numbers (crossfibre-result/1)
    Json,
    /// A table with a row for each node and the element after it
    Csv,
    /// The arrays, for numpy.load
    Npz,
}

impl Format {
    /// The format that the ending of a file's name asks for: JSON for all but `.csv` and `.npz`.
    pub fn of(file: &Path) -> Self {
        let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("csv") => Self::Csv,
            Some("npz") => Self::Npz,
            _ => Self::Json,
        }
    }

    /// An error if this program was built without the format.
    pub fn check(self) -> Result<()> {
        #[cfg(not(feature = "npz"))]
        if self == Self::Npz {
            anyhow::bail!(
                "this program was built without NumPy's format\n  help: write CSV, which \
                 numpy.genfromtxt reads, or build with it:\n        cargo build --release \
                 --package crossfibre-verification --features npz"
            );
        }
        Ok(())
    }

    /// Writes a result.
    pub fn write(self, result: &RunResult, to: &mut impl Write) -> Result<()> {
        match self {
            Self::Json => {
                serde_json::to_writer(&mut *to, result).map_err(io::Error::from)?;
                writeln!(to)?;
            }
            Self::Csv => csv::write(result, to)?,
            #[cfg(feature = "npz")]
            Self::Npz => npz::write(result, to)?,
            #[cfg(not(feature = "npz"))]
            Self::Npz => self.check()?,
        }
        Ok(())
    }
}

/// The fibres by name.
fn fibres(result: &RunResult) -> impl Iterator<Item = (&'static str, &FibreResult)> {
    let secondary = result.secondary.as_ref().map(|fibre| ("secondary", fibre));
    [Some(("primary", &result.primary)), secondary].into_iter().flatten()
}

/// Where nodes are in the unstrained fibre, m.
fn node_places(fibre: &FibreResult) -> Vec<f64> {
    (0..=fibre.strain.len()).map(|i| i as f64 * fibre.spacing).collect()
}

/// Where the middles of elements are in the unstrained fibre, m.
fn element_places(fibre: &FibreResult) -> Vec<f64> {
    (0..fibre.strain.len()).map(|i| (i as f64 + 0.5) * fibre.spacing).collect()
}
