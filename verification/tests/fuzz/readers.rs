//! Whatever reads, by name: what its files are, and what must hold of each input.
//!
//! A reader is a line of [`READERS`]. What must hold whatever it reads is in `main.rs`; what must hold
//! of what it accepts it asserts itself.

use std::io::{Cursor, Read};

use crossfibre::result_file;
use crossfibre_verification::cases::support::shipped;
use crossfibre_verification::conform::{
    html, junit as conform_junit, record as conform, text::Text,
};
use crossfibre_verification::diff::{
    Comparison, Options, Report, Stream, Tolerance, record as diff,
};
use crossfibre_verification::golden::compare::differences;
use crossfibre_verification::golden::file::{VectorFile, Vectors};
use crossfibre_verification::golden::{Recomputed, embedded};
use crossfibre_verification::precision::record::Record as WorkPrecision;
use crossfibre_verification::precision::times::Times;
use crossfibre_verification::record::Record;
use crossfibre_verification::report::files;
use crossfibre_verification::sweep::Point;
use crossfibre_verification::sweep::folder::Folder;
use crossfibre_verification::timing::program;
use crossfibre_verification::trace_line::{Event, TraceLine};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::corpus;
use super::dialogue;
use super::scenes;

/// Whatever reads.
pub struct Reader {
    /// Its name, and that of its folder in the corpus.
    pub name: &'static str,
    /// Files that the repository has anyway.
    pub seeds: fn() -> Vec<Vec<u8>>,
    /// Reads an input, and is told the file that it was made of. Accepts it or says why not; panics if
    /// something does not hold.
    pub read: fn(&[u8], &[u8]) -> Result<(), String>,
    /// Memory that it may take for the smallest input, bytes.
    pub memory: u64,
    /// Inputs that it is given, in those of a reader that takes some hundred microseconds.
    pub share: f64,
}

/// What little a reader of JSON takes.
const LITTLE: u64 = 1 << 18;

/// All of them.
#[rustfmt::skip] // a reader a line
pub const READERS: &[Reader] = &[
    Reader { name: "scene", seeds: scenes::seeds, read: scenes::scene, memory: 1 << 21, share: 1.0 },
    Reader { name: "exact", seeds: scenes::seeds, read: scenes::exact, memory: 1 << 26, share: 0.02 },
    Reader { name: "trace", seeds: traces, read: trace, memory: 1 << 22, share: 1.0 },
    Reader { name: "trace-line", seeds: trace_lines, read: trace_line, memory: LITTLE, share: 1.0 },
    Reader { name: "question", seeds: dialogue::questions, read: dialogue::question, memory: LITTLE, share: 1.0 },
    Reader { name: "hello", seeds: none, read: dialogue::hello, memory: LITTLE, share: 1.0 },
    Reader { name: "answer", seeds: dialogue::answers, read: dialogue::answer, memory: LITTLE, share: 1.0 },
    Reader { name: "conformance-report", seeds: none, read: conformance_report, memory: 1 << 20, share: 1.0 },
    Reader { name: "vectors", seeds: vectors, read: vector_file, memory: 1 << 21, share: 1.0 },
    Reader { name: "report", seeds: none, read: report, memory: 1 << 20, share: 1.0 },
    Reader { name: "result", seeds: results, read: result, memory: LITTLE, share: 1.0 },
    Reader { name: "work-precision", seeds: none, read: work_precision, memory: LITTLE, share: 1.0 },
    Reader { name: "times", seeds: none, read: times, memory: LITTLE, share: 1.0 },
    Reader { name: "point", seeds: points, read: point, memory: LITTLE, share: 0.1 },
    Reader { name: "timed-program", seeds: none, read: timed_program, memory: LITTLE, share: 1.0 },
];

fn none() -> Vec<Vec<u8>> {
    vec![]
}

/// The text of a file that must be UTF-8.
pub fn text(bytes: &[u8]) -> Result<&str, String> {
    str::from_utf8(bytes).map_err(|error| error.to_string())
}

/// Reads JSON, and writes and reads it again: it must stay the same. A refusal has its place in the
/// text.
pub fn json<T: Serialize + DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let text = text(bytes)?;
    let read: T = serde_json::from_str(text).map_err(|error| refused(text, &error))?;
    let written = serde_json::to_string(&read).unwrap();
    let again: T =
        serde_json::from_str(&written).unwrap_or_else(|error| panic!("{error}: {written}"));
    assert_eq!(serde_json::to_string(&again).unwrap(), written);
    Ok(read)
}

/// The message of a refusal, whose place must be in the text.
fn refused(text: &str, error: &serde_json::Error) -> String {
    let (line, column) = (error.line(), error.column());
    // After the last line end there may be an empty line, and a place at the end of a line is one
    // beyond its last byte.
    let length = text.split('\n').nth(line.saturating_sub(1)).map(str::len);
    assert!(
        length.is_some_and(|length| column <= length + 1),
        "line {line}, column {column}: {error}"
    );
    error.to_string()
}

/// The header and the first, some middle and the last events of the golden trace.
fn traces() -> Vec<Vec<u8>> {
    let [.., Some(golden)] = embedded() else { panic!("there is a golden trace") };
    let lines: Vec<_> = golden.lines().collect();
    let of = |events: &[&str]| ([&lines[..1], events].concat().join("\n") + "\n").into_bytes();
    vec![of(&lines[1..6]), of(&lines[40..70]), of(&lines[lines.len() - 12..])]
}

/// A trace as a pipe gives it.
fn stream(name: &str, bytes: &[u8]) -> Result<Stream, String> {
    let (first, rest) = bytes.split_at(bytes.len() / 3);
    let pieces = Cursor::new(first.to_vec()).chain(Cursor::new(rest.to_vec()));
    Stream::of(name.into(), Box::new(pieces), Default::default())
        .map_err(|error| format!("{error:#}"))
}

/// Compared with the trace that it was made of.
fn trace(bytes: &[u8], origin: &[u8]) -> Result<(), String> {
    let options = match bytes.len() % 3 {
        0 => Options::default(),
        1 => Options {
            tolerance: Tolerance { relative: Some(1e-9), ulp: Some(3) },
            ..Options::default()
        },
        _ => Options { first_only: true, ..Options::default() },
    };
    let read = || {
        let mut comparison = Comparison::of(stream("A", bytes)?, stream("B", origin)?, options);
        let read = comparison.run();
        let record = comparison.record();
        assert!(!Report(&record).to_string().is_empty());
        let written = serde_json::to_string(&record).unwrap();
        assert_eq!(serde_json::from_str::<diff::Record>(&written).unwrap(), record, "{written}");
        read.map_err(|error| format!("{error:#}"))
    };
    let read = read();
    if let Err(message) = &read {
        // `A:7: why`, or of the file as a whole `A: why`.
        let place = message.split(": ").next().unwrap();
        if let Some((_, line)) = place.split_once(':') {
            let line: usize = line.parse().unwrap_or_else(|_| panic!("{message}"));
            let lines = [bytes, origin].map(|of| of.split(|byte| *byte == b'\n').count());
            assert!((1..=lines[usize::from(place.starts_with('B'))]).contains(&line), "{message}");
        } else {
            assert!(place.len() == 1 || message.starts_with("neither"), "{message}");
        }
    }
    if bytes == origin {
        assert_eq!(read, Ok(()));
    }
    read
}

fn trace_lines() -> Vec<Vec<u8>> {
    let [.., Some(golden)] = embedded() else { panic!("there is a golden trace") };
    golden.lines().step_by(9).map(|line| line.as_bytes().to_vec()).collect()
}

fn trace_line(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    match serde_json::from_str(text(bytes)?).map_err(|error| error.to_string())? {
        TraceLine::Event(_) => json::<Event>(bytes).map(drop),
        TraceLine::Header(_) => Ok(()),
    }
}

fn conformance_report(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let report = json::<conform::Report>(bytes)?;
    assert!(!Text(&report).to_string().is_empty() && !html::render(&report).is_empty());
    conform_junit::render(&report).map(drop).map_err(|error| error.to_string())
}

/// The first vectors of each file.
fn vectors() -> Vec<Vec<u8>> {
    let files = embedded().into_iter().take(3).flatten();
    let few = |text: String| {
        let lines: Vec<_> = text.lines().collect();
        let end = lines.len() - 2;
        let chosen = [&lines[..6], &lines[end - 1..]].concat().join("\n");
        // The line of a vector ends in a comma, the last one's does not.
        serde_json::from_str::<Value>(&chosen).unwrap();
        chosen.into_bytes()
    };
    files.map(few).collect()
}

fn vector_file(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let text = text(bytes)?;
    let nothing = [Vectors::Equations(vec![]), Vectors::Steps(vec![]), Vectors::Runs(vec![])];
    let nothing = Recomputed { vectors: nothing, trace: String::new() };
    let stored = [0, 1, 2, 3].map(|_| Some(text.to_owned()));
    for difference in differences(&stored, &nothing) {
        assert!(!difference.to_string().is_empty());
    }
    let read = |text| serde_json::from_str::<VectorFile>(text).map(VectorFile::into_parts);
    let (provenance, vectors) = read(text).map_err(|error| refused(text, &error))?;
    let written = vectors.text(&provenance);
    let (provenance, vectors) = read(&written).unwrap_or_else(|error| panic!("{error}: {written}"));
    assert_eq!(vectors.text(&provenance), written);
    Ok(())
}

fn report(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let record = Record::read(text(bytes)?).map_err(|fault| fault.to_string())?;
    // As text: a number may be none, and such a one is not equal to itself.
    let again = Record::read(&record.json()).unwrap_or_else(|fault| panic!("{fault}"));
    assert_eq!(again.json(), record.json());
    assert!(files(&record).iter().all(|(_, text)| !text.is_empty()));
    Ok(())
}

/// A run of a scene whose result is short.
fn results() -> Vec<Vec<u8>> {
    let of = |elements| {
        let mut scene = shipped("unequal");
        scene.primary.elements = elements;
        let result = crossfibre::result::run(&scene, |_| ());
        serde_json::to_vec(&result).expect("a result can be written")
    };
    vec![of(6), of(9)]
}

fn result(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let result = result_file::read(text(bytes)?).map_err(|problem| problem.to_string())?;
    let written = serde_json::to_string(&result).expect("a result that was read can be written");
    assert_eq!(result_file::read(&written).as_ref(), Ok(&result));
    Ok(())
}

fn work_precision(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let record = json::<WorkPrecision>(bytes)?;
    assert!(!record.table().is_empty());
    let written = record.json();
    assert_eq!(serde_json::from_str::<WorkPrecision>(&written).expect(&written), record);
    Ok(())
}

fn times(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let times = Times::parse(text(bytes)?).map_err(|error| error.to_string())?;
    assert_eq!(Times::parse(&times.json()).unwrap(), times);
    Ok(())
}

const STUDY: &str = "fuzz";

fn points_of_study() -> [Point<f64>; 1] {
    [Point { id: "first".into(), parameters: 0.37 }]
}

/// A point as this program stores it.
fn points() -> Vec<Vec<u8>> {
    let (folder, points) = (tempfile::tempdir().unwrap(), points_of_study());
    let stored = Folder::open(folder.path(), STUDY, &points).unwrap();
    stored.store(&points[0], &(0.71, "a word", [Some(3), None])).unwrap();
    vec![std::fs::read(folder.path().join("first.json")).unwrap()]
}

fn point(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    let (folder, points) = (tempfile::tempdir().unwrap(), points_of_study());
    std::fs::write(folder.path().join("first.json"), bytes).unwrap();
    let stored = Folder::existing(folder.path(), STUDY, &points).unwrap();
    let value = stored.value::<_, (f64, String, [Option<i32>; 2])>(&points[0]);
    value.map(|value| assert!(value.is_some())).map_err(|error| format!("{error:#}"))
}

fn timed_program(bytes: &[u8], _: &[u8]) -> Result<(), String> {
    program::read(text(bytes)?).map(drop).map_err(|error| format!("{error:#}"))
}

/// Every file of the corpus belongs to a reader.
#[test]
fn every_folder_of_the_corpus_has_a_reader() {
    for entry in std::fs::read_dir(corpus::folder("")).unwrap() {
        let name = entry.unwrap().file_name();
        assert!(READERS.iter().any(|reader| name == reader.name), "{name:?}");
    }
}
