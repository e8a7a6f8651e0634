//! Files spoilt: in their bytes, in their lines, in the structure of their JSON.

use std::ops::Range;

use crossfibre_verification::random::SplitMix;

use super::corpus::Corpus;
use super::json::Structure;

/// The longest input. What must be refused for its length has tests of its own.
const LONGEST: usize = 1 << 17;

/// Numbers at the edges of what a reader or a run can do with them.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "-0.0",
    "1",
    "2",
    "3",
    "-1",
    "0.5",
    "1e308",
    "-1e308",
    "1.7976931348623157e308",
    "1e309",
    "1e999",
    "-1e999",
    "1e-320",
    "5e-324",
    "2.2250738585072014e-308",
    "1e-999",
    "1e-200",
    "1e200",
    "1e100",
    "1e-100",
    "1e15",
    "1e-15",
    "0.1",
    "0.30000000000000004",
    "4294967296",
    "9007199254740993",
    "9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "100000000",
    "99999999",
    "100000001",
    "123456789012345678901234567890123456789012345678901234567890",
    "1e2",
    "2.0",
    "0x10",
    "01",
    "1.",
    ".5",
    "+1",
    "1e",
    "--1",
    "NaN",
    "Infinity",
    "-inf",
    "1_000",
    "1e+5",
    "1E5",
];

/// Values of other kinds.
const SCRAPS: &[&str] = &[
    "null",
    "true",
    "false",
    "{}",
    "[]",
    "\"\"",
    "0",
    "[[]]",
    "{\"\":0}",
    "[null]",
    "[1,2]",
    "[1,2,3]",
    "{\"hi\":0.1,\"lo\":1e-18}",
    "\"all\"",
    "\"none\"",
    "[0.3,\"inf\"]",
];

/// Bytes that are no text, or a strange one.
const BYTES: &[&[u8]] = &[
    b"\0",
    b"\xFF",
    b"\xC0\x80",
    b"\xED\xA0\x80",
    b"\xEF\xBB\xBF",
    b"\xFF\xFE",
    b"\xF4\x90\x80\x80",
    b"\n",
    b"\r\n",
    b"\r",
    b"\\",
    b"\"",
    b"{",
    b"}",
    b"[",
    b"]",
    b",",
    b":",
    b"\xE2\x80\xA8",
    b"\xC2",
    b" ",
    b"\t",
    b"\\u0000",
    b"//",
    b"/*",
    b"'",
];

/// A file of the corpus, and it after one or more changes.
pub fn mutated(corpus: &Corpus, random: &mut SplitMix) -> (usize, Vec<u8>) {
    let origin = random.whole(0..corpus.files.len());
    let mut text = corpus.files[origin].clone();
    let in_structure = random.chance(0.75);
    loop {
        let changed = in_structure && structure(&mut text, corpus, random);
        if !changed {
            bytes(&mut text, corpus, random);
        }
        text.truncate(LONGEST);
        if random.chance(0.6) {
            return (origin, text);
        }
    }
}

fn one<'a, T: ?Sized>(list: &[&'a T], random: &mut SplitMix) -> &'a T {
    list[random.whole(0..list.len())]
}

fn any(corpus: &[Vec<u8>], random: &mut SplitMix) -> Vec<u8> {
    corpus[random.whole(0..corpus.len())].clone()
}

/// Part of a text: mostly small, at times large.
fn part(length: usize, random: &mut SplitMix) -> Range<usize> {
    let from = random.whole(0..length + 1);
    let most = if random.chance(0.7) { 16 } else { length };
    from..(from + random.whole(0..most + 1)).min(length)
}

/// Where lines begin, and the end.
fn lines(text: &[u8]) -> Vec<usize> {
    let ends = text.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(i, _)| i + 1);
    [0].into_iter().chain(ends).chain([text.len()]).collect()
}

fn bytes(text: &mut Vec<u8>, corpus: &Corpus, random: &mut SplitMix) {
    let here = random.whole(0..text.len() + 1);
    let lines = lines(text);
    let line = random.whole(0..lines.len() - 1);
    let line = lines[line]..lines[line + 1];
    match random.whole(0..14) {
        0 | 1 if here < text.len() => text[here] ^= 1 << random.whole(0..8),
        2 if here < text.len() => text[here] = random.bits() as u8,
        3 => text.insert(here, random.bits() as u8),
        4 | 5 => drop(text.splice(here..here, one(BYTES, random).iter().copied())),
        6 => drop(text.drain(part(text.len(), random))),
        7 => {
            let piece = text[part(text.len(), random)].to_vec();
            text.splice(here..here, piece);
        }
        8 => text.truncate(here),
        9 => drop(text.drain(..here)),
        10 => {
            // The beginning of one file and the end of another.
            let other = any(&corpus.files, random);
            text.truncate(here);
            text.extend(&other[random.whole(0..other.len() + 1)..]);
        }
        11 => drop(text.splice(here..here, any(&corpus.words, random))),
        12 => drop(text.drain(line)),
        _ => {
            let copy = text[line].to_vec();
            let there = lines[random.whole(0..lines.len())];
            text.splice(there..there, copy);
        }
    }
}

/// A number that may pass where this one stood.
fn scaled(number: &str, random: &mut SplitMix) -> String {
    const FACTORS: [f64; 12] =
        [0.1, 0.5, 0.99, 1.0000000000000002, 1.1, 2.0, 3.7, 1e-3, 1e3, 1e-6, 1e6, -1.0];
    let factor = FACTORS[random.whole(0..FACTORS.len())];
    match (number.parse::<u64>(), number.parse::<f64>()) {
        (Ok(count), _) => ((count as f64 * factor) as u64).to_string(),
        (_, Ok(x)) => format!("{:e}", x * factor),
        _ => factor.to_string(),
    }
}

/// Whether there was something to change.
fn structure(text: &mut Vec<u8>, corpus: &Corpus, random: &mut SplitMix) -> bool {
    let found = Structure::of(text);
    if found.values.is_empty() {
        return false;
    }
    let chosen = |list: &[usize], random: &mut SplitMix| list[random.whole(0..list.len())];
    let value = chosen(&found.values, random);
    let at = found.value(value);
    let (range, with): (Range<usize>, Vec<u8>) = match random.whole(0..20) {
        0..=2 | 16.. => {
            let words: Vec<_> =
                found.values.iter().copied().filter(|&i| found.is_word(i)).collect();
            if words.is_empty() {
                return false;
            }
            let word = found.bytes(chosen(&words, random));
            let other = match random.chance(0.3) {
                true => one(NUMBERS, random).to_owned(),
                false => scaled(&String::from_utf8_lossy(&text[word.clone()]), random),
            };
            (word, other.into_bytes())
        }
        3 => (at, any(&corpus.words, random)),
        4 if !found.keys.is_empty() => {
            (found.bytes(chosen(&found.keys, random)), any(&corpus.words, random))
        }
        5 => (at, one(SCRAPS, random).into()),
        6 => (at, text[found.value(chosen(&found.values, random))].to_vec()),
        7 => {
            let other = any(&corpus.files, random);
            let theirs = Structure::of(&other);
            if theirs.values.is_empty() {
                return false;
            }
            (at, other[theirs.value(chosen(&theirs.values, random))].to_vec())
        }
        8 | 9 => (found.member_and_comma(value), vec![]),
        10 => {
            let member = &text[found.member(value)];
            (at.end..at.end, [b",", member].concat())
        }
        11 => {
            let depth = [1, 3, 100, 126, 130, 5000][random.whole(0..6)];
            let (open, close) = if random.chance(0.8) { ("[", "]") } else { ("{\"a\":", "}") };
            let value = &text[at.clone()];
            let nested =
                [open.repeat(depth).as_bytes(), value, close.repeat(depth).as_bytes()].concat();
            (at, nested)
        }
        12 => {
            let times = [2, 17, 300][random.whole(0..3)];
            let value = &text[at.clone()];
            let list = vec![value; times.min(1 + LONGEST / (4 * value.len() + 1))].join(&b","[..]);
            (at, [b"[", &list[..], b"]"].concat())
        }
        13 => {
            let letter = ["a", "µ", "\\u0041", "7"][random.whole(0..4)];
            let long = letter.repeat([40, 400, 5000][random.whole(0..3)]);
            (at, format!("\"{long}\"").into_bytes())
        }
        14 => {
            let word = any(&corpus.words, random);
            let value = &text[found.value(chosen(&found.values, random))];
            (at.end..at.end, [b",", &word[..], b":", value].concat())
        }
        _ => (found.bytes(random.whole(0..found.len())), vec![]),
    };
    text.splice(range, with);
    true
}
