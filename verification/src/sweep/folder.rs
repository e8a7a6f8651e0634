//! The folder of a sweep's points: one file each, `<id>.json`, format `crossfibre-point/1`.

use std::collections::BTreeSet;
use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail, ensure};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::Point;
use crate::output::Destination;

/// The format that this version reads and writes.
const FORMAT: &str = "crossfibre-point/1";

/// The program: its version and a digest of its source (`build.rs`).
const PROGRAM: &str = concat!(env!("CARGO_PKG_VERSION"), "+", env!("CROSSFIBRE_SOURCE"));

/// What a point's value depends on. Only a value with exactly this is taken.
#[derive(PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Origin {
    format: String,
    study: String,
    program: String,
    id: String,
    parameters: serde_json::Value,
}

/// A file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Stored<V> {
    origin: Origin,
    value: V,
}

/// A folder of points of one study.
pub struct Folder<'a> {
    path: PathBuf,
    study: &'a str,
    ids: BTreeSet<&'a str>,
}

impl<'a> Folder<'a> {
    /// The folder to store points in, made if it is not there, with nothing in it but points of the
    /// study.
    pub fn open<P>(path: &Path, study: &'a str, points: &'a [Point<P>]) -> Result<Self> {
        fs::create_dir_all(path).with_context(|| {
            format!(
                "{}: cannot be made a folder of points; name another by --points",
                path.display()
            )
        })?;
        let folder = Self::existing(path, study, points)?;
        // A sweep of hours should not find out at its first point.
        tempfile::tempfile_in(path).with_context(|| {
            format!("{}: cannot be written to; name another folder by --points", path.display())
        })?;
        Ok(folder)
    }

    /// A folder that is there, with nothing in it but points of the study.
    pub fn existing<P>(path: &Path, study: &'a str, points: &'a [Point<P>]) -> Result<Self> {
        let ids: BTreeSet<_> = points.iter().map(|point| point.id.as_str()).collect();
        assert_eq!(ids.len(), points.len(), "two points of {study} have one id");
        let folder = Self { path: path.into(), study, ids };
        let entries = fs::read_dir(path)
            .with_context(|| format!("{}: cannot be read as a folder of points", path.display()))?;
        for entry in entries {
            let name = entry?.file_name();
            let name = name.to_string_lossy();
            let is_point = || name.strip_suffix(".json").is_some_and(|id| folder.ids.contains(id));
            // What is hidden is a file that a killed program was about to write, or the system's.
            ensure!(
                name.starts_with('.') || is_point(),
                "{}: is not a point of the study `{study}`\n  help: remove it, or name another \
                 folder of points",
                path.join(&*name).display()
            );
        }
        Ok(folder)
    }

    fn file(&self, id: &str) -> PathBuf {
        self.path.join(format!("{id}.json"))
    }

    /// The text of a point's file; none if there is none.
    fn text(&self, id: &str) -> Result<Option<String>> {
        let file = self.file(id);
        match fs::read_to_string(&file) {
            Ok(text) => Ok(Some(text)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error).with_context(|| file.display().to_string()),
        }
    }

    fn write(&self, id: &str, text: &str) -> Result<()> {
        let mut out = Destination::File(self.file(id)).open()?;
        out.write_all(text.as_bytes()).with_context(|| self.file(id).display().to_string())?;
        out.finish()
    }

    /// Copies the points of another folder. What both have must be the same to the bit.
    pub fn take_over(&self, other: &Self) -> Result<()> {
        for id in &self.ids {
            match (other.text(id)?, self.text(id)?) {
                (None, _) => (),
                (Some(theirs), None) => self.write(id, &theirs)?,
                (Some(theirs), Some(ours)) if theirs == ours => (),
                (Some(_), Some(_)) => bail!(
                    "{} and {} differ\n  help: a point is a pure function of its parameters: one of \
                     the two was computed by another program, or wrongly; remove that one",
                    self.file(id).display(),
                    other.file(id).display()
                ),
            }
        }
        Ok(())
    }

    /// What the value of a point depends on.
    fn origin<P: Serialize>(&self, point: &Point<P>) -> Result<Origin> {
        Ok(Origin {
            format: FORMAT.into(),
            study: self.study.into(),
            program: PROGRAM.into(),
            id: point.id.clone(),
            parameters: serde_json::to_value(&point.parameters)?,
        })
    }

    /// Stores the value of a point, whole or not at all.
    pub fn store<P: Serialize, V: Serialize>(&self, point: &Point<P>, value: &V) -> Result<()> {
        let stored = Stored { origin: self.origin(point)?, value };
        self.write(&point.id, &(serde_json::to_string(&stored)? + "\n"))
    }

    /// The stored value of a point; none if it is not stored, an error if it is another's.
    pub fn value<P: Serialize, V: DeserializeOwned>(&self, point: &Point<P>) -> Result<Option<V>> {
        let Some(text) = self.text(&point.id)? else { return Ok(None) };
        let file = self.file(&point.id);
        let help = "help: remove it, or empty the folder, to have it computed anew; or name another by --points";
        let of_another = |what: &str| anyhow!("{}: is of another {what}\n  {help}", file.display());
        // A file of another format need not have a value that can be read.
        let stored: Stored<serde_json::Value> = serde_json::from_str(&text)
            .map_err(|error| anyhow!("{}: {error}\n  {help}", file.display()))?;
        let (found, expected) = (stored.origin, self.origin(point)?);
        for (what, same) in [
            ("format", found.format == expected.format),
            ("study", found.study == expected.study),
            ("version of the program", found.program == expected.program),
            ("point", found.id == expected.id),
            ("point: its parameters differ", found.parameters == expected.parameters),
        ] {
            if !same {
                return Err(of_another(what));
            }
        }
        serde_json::from_value(stored.value)
            .map(Some)
            .map_err(|error| anyhow!("{}: value: {error}\n  {help}", file.display()))
    }
}
