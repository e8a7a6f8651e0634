//! The files that inputs are made of, and the words in them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::json;
use super::readers::Reader;

/// Files of a reader.
pub struct Corpus {
    /// Whole files, good and bad.
    pub files: Vec<Vec<u8>>,
    /// Every word in quotes of the files, and some that are in none: the dictionary.
    pub words: Vec<Vec<u8>>,
}

/// The folder of a reader's files.
pub fn folder(reader: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(reader)
}

/// Words that no format has, or that are hard to read.
const HOSTILE: &[&str] = &[
    "\"\"",
    "\" \"",
    "\"a\\\"b\"",
    "\"\\u0000\"",
    "\"\\ud800\"",
    "\"\\uD83D\\uDE00\"",
    "\"µ̈∂🦀\"",
    "\"\u{202E}\u{FEFF}\"",
    "\"../../etc\"",
    "\"<!-- ]]> &amp; |\"",
    "\"a\\nb\\tc\"",
    "\"__proto__\"",
    "\"1.5\"",
    "\"NaN\"",
    "\"inf\"",
    "\"$serde_json::private::Number\"",
    "\"$serde_json::private::RawValue\"",
];

impl Corpus {
    /// Of a reader: its folder, and what the repository has for it elsewhere.
    pub fn of(reader: &Reader) -> Self {
        let mut names: Vec<_> = fs::read_dir(folder(reader.name))
            .map(|entries| entries.map(|entry| entry.unwrap().path()).collect())
            .unwrap_or_default();
        names.sort();
        let mut files = (reader.seeds)();
        files.extend(names.iter().map(|name| fs::read(name).unwrap()));
        let mut words = BTreeSet::new();
        for file in &files {
            let strings = json::tokens(file).into_iter().filter(|token| token.is_string());
            words.extend(strings.map(|token| file[token.range].to_vec()));
        }
        words.extend(HOSTILE.iter().map(|word| word.as_bytes().to_vec()));
        Self { files, words: words.into_iter().collect() }
    }
}
