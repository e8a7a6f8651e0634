//! A sweep: a list of points, each computed once, stored at once, and never lost.
//!
//! A point is an id and parameters; what is computed is a pure function of the parameters. Each
//! finished point is a file of its own in a folder, written whole or not at all, so a sweep that
//! was interrupted goes on where it stopped, parts of it can be computed on many machines
//! ([`Shard`]), and a copy of their files into one folder is the whole. What is drawn from a sweep is
//! drawn from the stored files alone: however they came about, the result is the same to the bit.

pub mod folder;
mod shard;

use std::path::PathBuf;

use anyhow::Result;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use folder::Folder;
pub use shard::Shard;

/// One thing to be computed.
#[derive(Clone, Debug)]
pub struct Point<P> {
    /// Its name, for good, and of its file: letters, digits, `-`, `_` and `.`.
    pub id: String,
    /// All that the computation is told.
    pub parameters: P,
}

/// Where points are stored, and which are to be computed.
#[derive(Clone, Debug)]
pub struct Places {
    /// The folder of the points; made if it is not there.
    pub points: PathBuf,
    /// Folders from which points are taken over.
    pub from: Vec<PathBuf>,
    /// The part to compute; none for all.
    pub shard: Option<Shard>,
}

/// The values of the points, in their order, computing what is not stored yet. `None` for a point
/// that is neither stored nor in the part to compute.
///
/// `study` names the sweep and the format of its values, such as `figures/1`.
pub fn sweep<P, V>(
    study: &str,
    points: &[Point<P>],
    places: &Places,
    compute: impl Fn(&P) -> V + Sync,
) -> Result<Vec<Option<V>>>
where
    P: Serialize + Sync,
    V: Serialize + DeserializeOwned + Send,
{
    let folder = Folder::open(&places.points, study, points)?;
    for from in &places.from {
        folder.take_over(&Folder::existing(from, study, points)?)?;
    }
    let mut values =
        points.iter().map(|point| folder.value(point)).collect::<Result<Vec<Option<V>>>>()?;

    let is_ours = |k: usize| places.shard.is_none_or(|shard| shard.has(k));
    let missing: Vec<usize> =
        (0..points.len()).filter(|&k| values[k].is_none() && is_ours(k)).collect();
    // Drawn on standard error, and only if that is a terminal.
    let style = ProgressStyle::with_template("{wide_bar} {pos} of {len} points, {eta} left")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(missing.len() as u64).with_style(style);
    let computed = missing
        .par_iter()
        .map(|&k| {
            let point = &points[k];
            folder.store(point, &compute(&point.parameters))?;
            bar.inc(1);
            Ok((k, folder.value(point)?))
        })
        .collect::<Result<Vec<_>>>();
    bar.finish_and_clear();
    for (k, value) in computed? {
        values[k] = value;
    }
    Ok(values)
}

#[cfg(test)]
mod tests;
