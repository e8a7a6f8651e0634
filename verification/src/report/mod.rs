//! Reports: pure functions of a [`Record`], and how they are written.

pub mod html;
pub mod junit;
pub mod markdown;
mod prose;
pub mod summary;
pub mod words;

use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};

use crate::output::{Destination, make_folder};
use crate::record::Record;
use crate::sensitivity::page::page;

/// Where `verify` writes the reports of all cases, from the root of a clone.
pub const FOLDER: &str = "target/verification";

/// Every report, by the name of its file.
pub fn files(record: &Record) -> Vec<(&'static str, String)> {
    let mut files = vec![
        ("report.html", html::render(record)),
        ("junit.xml", junit::render(record)),
        ("VALIDATION.md", markdown::render(record)),
        ("summary.md", summary::render(record)),
    ];
    files.extend(record.sensitivity.as_ref().map(|matrix| ("sensitivity.md", page(matrix))));
    files
}

/// Writes files into a folder, which is made if there is none: everything is on the disk under other
/// names before the first file takes its own.
pub fn write(folder: &Path, files: &[(&str, String)]) -> Result<()> {
    make_folder(folder)?;
    let mut whole = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        let mut out = Destination::of(Some(&path))?.open()?;
        out.write_all(text.as_bytes()).with_context(|| path.display().to_string())?;
        out.flush().with_context(|| path.display().to_string())?;
        whole.push(out);
    }
    whole.into_iter().try_for_each(|out| out.finish())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn no_file_is_written_if_one_cannot_be() {
        let folder = tempfile::tempdir().unwrap();
        // A folder is in the way of the second.
        fs::create_dir(folder.path().join("b")).unwrap();
        let files = [("a", "1".to_owned()), ("b", "2".to_owned())];
        let error = write(folder.path(), &files).unwrap_err().to_string();
        assert!(error.ends_with("b: is a directory"), "{error}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        write(&folder.path().join("new"), &files).unwrap();
        assert_eq!(fs::read_to_string(folder.path().join("new/b")).unwrap(), "2");
    }
}
