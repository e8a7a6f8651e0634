//! Writing the vectors: never while a check is red, and never without a reason.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::compare::{Difference, vectors_that_differ};
use super::file::{Provenance, VectorFile, Vectors};
use super::runs::RunVector;
use super::{FILES, Recomputed, Text};
use crate::cases::Case;
use crate::output::Destination;
use crate::record::{CaseRecord, run_cases};

/// The file that says when the vectors changed and why.
pub const HISTORY: &str = "HISTORY.md";

/// The files of a folder.
pub fn stored(folder: &Path) -> Result<[Text; 4]> {
    if !folder.is_dir() {
        bail!(
            "{}: there is no such folder\n  help: run this in the root of the repository, \
             or name the folder of the vectors with --dir",
            folder.display()
        );
    }
    let mut texts = [const { None }; 4];
    for (text, name) in texts.iter_mut().zip(FILES) {
        *text = read(&folder.join(name))?;
    }
    Ok(texts)
}

/// A file's text; none if it is not there.
fn read(path: &Path) -> Result<Text> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error).with_context(|| path.display().to_string()),
    }
}

/// The stored runs; none if they cannot be read.
pub fn stored_runs(stored: &[Text; 4]) -> Vec<RunVector> {
    let files = stored.iter().flatten().filter_map(|text| serde_json::from_str(text).ok());
    files
        .filter_map(|file: VectorFile| match file.into_parts().1 {
            Vectors::Runs(runs) => Some(runs),
            _ => None,
        })
        .flatten()
        .collect()
}

/// The claims of checks that do not pass, each with its case. The cases about the stored vectors
/// themselves, `golden.…`, are left out: they are red whenever there is something to bless.
pub fn red(cases: &[Case]) -> Vec<String> {
    let judging: Vec<_> =
        cases.iter().copied().filter(|case| !case.id.starts_with("golden.")).collect();
    let claim = |case: &CaseRecord| {
        case.troubles().map(|c| format!("{}: {}", case.id, c.check.claim)).collect::<Vec<_>>()
    };
    run_cases(&judging, |_| ()).iter().flat_map(claim).collect()
}

/// Writes the files in which vectors changed, and a line of the history. Returns what was written.
///
/// Everything is on the disk under other names before the first file takes its own.
pub fn write(
    folder: &Path,
    differences: &[Difference],
    recomputed: &Recomputed,
    reason: &str,
) -> Result<Vec<&'static str>> {
    let provenance = Provenance::now(reason);
    let texts = recomputed.texts(&provenance);
    let changed = |file| differences.iter().any(|difference| difference.file == file);
    let mut files: Vec<_> =
        FILES.into_iter().zip(texts).filter(|(file, _)| changed(*file)).collect();
    let count = vectors_that_differ(differences);
    let history = read(&folder.join(HISTORY))?.unwrap_or_else(|| HEADING.into());
    let line = format!("- {}: {reason} ({count} vectors changed)\n", provenance.crossfibre);
    files.push((HISTORY, history + &line));

    let mut whole = Vec::new();
    for (file, text) in &files {
        let mut out = Destination::of(Some(&folder.join(file)))?.open()?;
        out.write_all(text.as_bytes()).with_context(|| (*file).to_owned())?;
        out.flush().with_context(|| (*file).to_owned())?;
        whole.push(out);
    }
    for out in whole {
        out.finish()?;
    }
    Ok(files.into_iter().map(|(file, _)| file).collect())
}

const HEADING: &str = "# Why the vectors changed\n\n\
    Written by `crossfibre vectors --bless --reason \"…\"`: version, reason, number of vectors.\n\n";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::{Bound, Check};
    use crate::golden::compare::differences;

    fn check(claim: &str, measured: f64, bound: Bound) -> Vec<Check> {
        let [oracle, norm, reason] = [(); 3].map(|()| String::new());
        vec![Check { claim: claim.into(), oracle, norm, measured, bound, reason }]
    }

    fn case(id: &'static str, run: fn() -> Vec<Check>) -> Case {
        Case { id, title: "", equations: &[], run }
    }

    #[test]
    fn a_failed_check_and_a_loose_one_are_red_but_not_those_on_the_vectors_themselves() {
        let cases = [
            case("sound", || check("holds", 0.7, Bound::AtMost(1.3))),
            case("broken", || check("does not hold", 1.7, Bound::AtMost(1.3))),
            case("vague", || check("would always hold", 0.01, Bound::AtMost(1.3))),
            case("golden.vectors", || check("is what is blessed", 3.0, Bound::Exactly(0.0))),
        ];
        assert_eq!(red(&cases), ["broken: does not hold", "vague: would always hold"]);
        assert!(red(&cases[..1]).is_empty());
    }

    #[test]
    fn a_file_that_is_not_there_is_none_and_one_that_cannot_be_read_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        assert!(stored(folder.path()).unwrap().iter().all(Option::is_none));
        fs::create_dir(folder.path().join(FILES[1])).unwrap();
        let error = stored(folder.path()).unwrap_err().to_string();
        assert!(error.contains(FILES[1]), "{error}");
    }

    #[test]
    fn only_files_whose_vectors_changed_are_written_and_the_history_grows_by_a_line() {
        let folder = tempfile::tempdir().unwrap();
        let recomputed = Recomputed::now();
        let texts = recomputed.texts(&Provenance::now("the reason before"));
        for (file, text) in FILES.iter().zip(&texts) {
            fs::write(folder.path().join(file), text).unwrap();
        }
        let runs = folder.path().join("runs.json");
        let flipped = texts[2].replacen("\"steps\":100", "\"steps\":101", 1);
        assert_ne!(flipped, texts[2]);
        fs::write(&runs, flipped).unwrap();

        let found = differences(&stored(folder.path()).unwrap(), &recomputed);
        let written = write(folder.path(), &found, &recomputed, "a new reason").unwrap();
        assert_eq!(written, ["runs.json", HISTORY]);
        let after = stored(folder.path()).unwrap();
        assert!(differences(&after, &recomputed).is_empty());
        assert_eq!(after[0].as_ref(), Some(&texts[0]));
        assert!(after[2].as_ref().unwrap().contains("\"a new reason\""));
        assert_eq!(stored_runs(&after).len(), crate::cases::support::SCENES.len());
        let history = fs::read_to_string(folder.path().join(HISTORY)).unwrap();
        assert!(history.ends_with(": a new reason (1 vectors changed)\n"), "{history}");
    }
}
