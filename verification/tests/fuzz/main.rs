//! Everything that reads, fed with spoilt files: no panic, no hang, no memory out of proportion, and
//! whatever is refused is refused in words.
//!
//! The inputs are the same in every run: a number and a seed make one. A short run by default;
//! `CROSSFIBRE_FUZZ=10000000` gives each reader its share of so many. An input that finds a fault is
//! written to a file that the message names: put it into `verification/fuzz/corpus/<reader>/` together
//! with the fix.
#![allow(clippy::unwrap_used)] // a test may

#[path = "../cli_support/mod.rs"]
mod cli_support;
mod command;
mod corpus;
mod dialogue;
mod guard;
mod json;
mod mutate;
mod readers;
mod scenes;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crossfibre_verification::random::SplitMix;

use corpus::Corpus;
use guard::{Ended, Guard};
use readers::{READERS, Reader};

/// Inputs of a short run, over all readers: some seconds.
const SHORT: u64 = 26_000;

/// Faults of a reader after which the rest is not tried.
const ENOUGH: usize = 20;

/// What a reader made of its inputs.
#[derive(Default)]
struct Tally {
    inputs: u64,
    accepted: u64,
    refused: u64,
    /// The greatest memory asked for at a time, over the size of its input, of inputs of a KiB or more.
    memory: f64,
    faults: Vec<String>,
}

fn inputs_wanted() -> u64 {
    match std::env::var("CROSSFIBRE_FUZZ") {
        Ok(number) => number.parse().expect("CROSSFIBRE_FUZZ is the number of inputs"),
        Err(_) => SHORT,
    }
}

/// The sequence of an input of a reader.
fn random(reader: &str, number: u64) -> SplitMix {
    let name = reader.bytes().fold(1980, |hash: u64, byte| hash.wrapping_mul(31) + u64::from(byte));
    let mut of_reader = SplitMix::new(name);
    SplitMix::new(of_reader.bits().wrapping_add(number.wrapping_mul(0x9e37_79b9)))
}

/// An input that is kept for whoever looks into its fault.
fn keep(reader: &str, number: u64, bytes: &[u8]) -> String {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{reader}-{number}"));
    fs::write(&file, bytes).unwrap();
    file.display().to_string()
}

fn fuzz(reader: &Reader, inputs: u64, guard: &Guard) -> Tally {
    let corpus = Corpus::of(reader);
    let mut tally = Tally::default();
    for number in 0..inputs.max(corpus.files.len() as u64) {
        let (origin, bytes) = match corpus.files.get(number as usize) {
            Some(file) => (number as usize, file.clone()),
            None => mutate::mutated(&corpus, &mut random(reader.name, number)),
        };
        let (ended, memory) =
            guard.watched(reader.name, number, || (reader.read)(&bytes, &corpus.files[origin]));
        tally.inputs += 1;
        if bytes.len() >= 1024 {
            tally.memory = tally.memory.max(memory as f64 / bytes.len() as f64);
        }
        let allowed = reader.memory + 150 * bytes.len() as u64;
        let fault = match ended {
            Ended::Panicked(message) => Some(message),
            Ended::Read(_) if memory > allowed => {
                Some(format!("{memory} bytes of memory for {} of input", bytes.len()))
            }
            Ended::Read(Err(reason)) if reason.trim().is_empty() => {
                Some("refused in no words".into())
            }
            Ended::Read(Err(reason)) if reason.len() > 4096 + 2 * bytes.len() => {
                Some(format!("refused in {} bytes", reason.len()))
            }
            Ended::Read(Err(_)) => {
                tally.refused += 1;
                None
            }
            Ended::Read(Ok(())) => {
                tally.accepted += 1;
                None
            }
        };
        if let Some(fault) = fault {
            let file = keep(reader.name, number, &bytes);
            tally.faults.push(format!("{} {number}: {fault}\n    input: {file}", reader.name));
            if tally.faults.len() == ENOUGH {
                break;
            }
        }
    }
    tally
}

#[test]
fn whatever_is_read_is_accepted_or_refused_in_words() {
    let each = inputs_wanted() as f64 / READERS.iter().map(|reader| reader.share).sum::<f64>();
    let guard = Guard::start();
    let mut table = String::from(
        "| reader | inputs | accepted | refused | bytes of memory a byte | faults |\n|---|--:|--:|--:|--:|--:|\n",
    );
    let mut faults = Vec::new();
    let mut all = 0;
    for reader in READERS {
        let tally = fuzz(reader, (each * reader.share).ceil() as u64, &guard);
        let Tally { inputs, accepted, refused, memory, .. } = tally;
        let row = format!(
            "| {} | {inputs} | {accepted} | {refused} | {memory:.0} | {} |",
            reader.name,
            tally.faults.len()
        );
        println!("{row}");
        writeln!(table, "{row}").unwrap();
        // A reader that accepts nothing, or everything, is not tried by this corpus.
        assert!(accepted > 0 && refused > 0, "{row}");
        all += inputs;
        faults.extend(tally.faults);
    }
    println!("{table}{all} inputs");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn an_input_is_the_same_in_every_run_and_another_for_each_number() {
    let corpus = Corpus::of(&READERS[0]);
    let input = |number| mutate::mutated(&corpus, &mut random("scene", number));
    assert_eq!(input(71), input(71));
    let different = (0..300).filter(|&number| input(number) != input(number + 1)).count();
    // Two of them may by chance be spoilt in the same way.
    assert!(different > 290, "{different}");
}

/// The guard does see a panic, and memory.
#[test]
fn what_the_guard_is_for_is_seen() {
    let guard = Guard::start();
    let (ended, _) = guard.watched("none", 0, || panic!("an index out of range"));
    assert!(matches!(ended, Ended::Panicked(message) if message.contains("an index out of range")));
    let (ended, memory) = guard.watched("none", 1, || {
        std::hint::black_box(vec![0_u8; 70_001]);
        Ok(())
    });
    assert!(matches!(ended, Ended::Read(Ok(()))) && (70_001..71_000).contains(&memory), "{memory}");
}
