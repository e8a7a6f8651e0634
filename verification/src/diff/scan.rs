//! An event read from the text that the library writes: without spaces, keys in their order.
//!
//! It is for speed. What is written in any other way is nothing here, and is read and written anew
//! in this form (see [`super::stream`]).

use std::ops::Range;

use crossfibre::place::{Fibre, Place};

use super::number::Number;
use super::rank::At;

/// Quantities that an event may have: some times what the longest equation has. They are looked for by
/// name, each among all, which takes minutes for as many as fit into a line.
const MOST: usize = 100;

/// The quantities of an event: the inputs as they stand in the line, then the output.
#[derive(Debug, Default)]
pub struct Quantities {
    each: Vec<Quantity>,
    numbers: Vec<Number>,
}

#[derive(Debug)]
struct Quantity {
    /// Where in the line its name is.
    name: Range<usize>,
    is_vector: bool,
    numbers: Range<usize>,
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub struct Named<'a> {
    /// The symbol; `out` for the output.
    pub name: &'a [u8],
    /// Whether it is a vector, of any number of components.
    pub is_vector: bool,
    /// Its components, or the one number.
    pub numbers: &'a [Number],
}

impl Quantities {
    /// Reads them from a line, from what [`head`] left on.
    pub fn read(&mut self, line: &[u8], from: usize) -> Option<()> {
        self.each.clear();
        self.numbers.clear();
        let mut text = Text { line, at: from };
        text.literal(b",\"in\":{")?;
        if text.literal(b"}").is_none() {
            loop {
                text.literal(b"\"")?;
                let name = text.name()?;
                text.literal(b":")?;
                self.quantity(&mut text, name)?;
                if text.literal(b",").is_none() {
                    text.literal(b"}")?;
                    break;
                }
            }
        }
        text.literal(b",\"")?;
        let name = text.name()?;
        (&line[name.clone()] == b"out").then_some(())?;
        text.literal(b":")?;
        self.quantity(&mut text, name)?;
        text.literal(b"}")?;
        (text.at == line.len()).then_some(())
    }

    fn quantity(&mut self, text: &mut Text<'_>, name: Range<usize>) -> Option<()> {
        let first = self.numbers.len();
        let is_vector = text.literal(b"[").is_some();
        if !is_vector {
            self.numbers.push(text.number()?);
        } else if text.literal(b"]").is_none() {
            loop {
                self.numbers.push(text.number()?);
                if text.literal(b",").is_none() {
                    text.literal(b"]")?;
                    break;
                }
            }
        }
        self.each.push(Quantity { name, is_vector, numbers: first..self.numbers.len() });
        Some(())
    }

    /// Whether there are more than any equation has.
    pub fn are_too_many(&self) -> bool {
        self.each.len() > MOST
    }

    /// All of them; `line` is the one that they were read from.
    pub fn all<'a>(&'a self, line: &'a [u8]) -> impl ExactSizeIterator<Item = Named<'a>> {
        self.each.iter().map(|quantity| self.named(quantity, line))
    }

    /// The one of a name, which is looked for first where it should be.
    pub fn find<'a>(&'a self, line: &'a [u8], name: &[u8], guess: usize) -> Option<Named<'a>> {
        let has_name = |quantity: &&Quantity| &line[quantity.name.clone()] == name;
        let found = self.each.get(guess).filter(has_name);
        found.or_else(|| self.each.iter().find(has_name)).map(|found| self.named(found, line))
    }

    fn named<'a>(&'a self, quantity: &Quantity, line: &'a [u8]) -> Named<'a> {
        Named {
            name: &line[quantity.name.clone()],
            is_vector: quantity.is_vector,
            numbers: &self.numbers[quantity.numbers.clone()],
        }
    }
}

/// What an event is of, and where in the line its quantities begin.
pub fn head(line: &[u8]) -> Option<(At, usize)> {
    let mut text = Text { line, at: 0 };
    text.literal(b"{\"step\":")?;
    let step = text.count()?;
    text.literal(b",\"fibre\":\"")?;
    let fibre = [Fibre::Primary, Fibre::Secondary]
        .into_iter()
        .find(|fibre| text.literal(fibre.name().as_bytes()).is_some())?;
    text.literal(b"\",\"index\":")?;
    let index = usize::try_from(text.count()?).ok()?;
    text.literal(b",\"eq\":\"")?;
    let equation = u8::try_from(text.count()?).ok().filter(|number| (1..=20).contains(number))?;
    text.literal(b"\"")?;
    Some((At { place: Place { step, fibre, index }, equation }, text.at))
}

/// A line and how far it is read.
struct Text<'a> {
    line: &'a [u8],
    at: usize,
}

impl Text<'_> {
    #[inline(always)]
    fn literal(&mut self, expected: &[u8]) -> Option<()> {
        self.line[self.at..].starts_with(expected).then(|| self.at += expected.len())
    }

    #[inline(always)]
    fn byte(&self) -> u8 {
        // No byte of a number: it ends there.
        self.line.get(self.at).copied().unwrap_or(b' ')
    }

    /// Digits, one at least.
    #[inline(always)]
    fn digits(&mut self) -> Option<()> {
        let from = self.at;
        while self.byte().is_ascii_digit() {
            self.at += 1;
        }
        (self.at > from).then_some(())
    }

    /// Digits as JSON allows them before a point: no zero in front.
    #[inline(always)]
    fn whole(&mut self) -> Option<()> {
        let from = self.at;
        self.digits()?;
        (self.line[from] != b'0' || self.at == from + 1).then_some(())
    }

    fn count(&mut self) -> Option<u64> {
        let from = self.at;
        self.whole()?;
        let digits = &self.line[from..self.at];
        // Nineteen digits are always below 2⁶⁴.
        (digits.len() < 20).then(|| digits.iter().fold(0, |n, d| 10 * n + u64::from(d - b'0')))
    }

    /// A name and the quote after it: ASCII that needs no escape.
    fn name(&mut self) -> Option<Range<usize>> {
        let from = self.at;
        while (b' '..=b'~').contains(&self.byte()) && !matches!(self.byte(), b'"' | b'\\') {
            self.at += 1;
            if self.at >= self.line.len() {
                return None;
            }
        }
        let name = from..self.at;
        self.literal(b"\"")?;
        Some(name)
    }

    fn number(&mut self) -> Option<Number> {
        if self.literal(b"\"").is_some() {
            let name = self.name()?;
            return match &self.line[name] {
                b"inf" => Some(Number::of(f64::INFINITY)),
                b"-inf" => Some(Number::of(f64::NEG_INFINITY)),
                b"NaN" => Some(Number::of(f64::NAN)),
                _ => None,
            };
        }
        if self.literal(b"{\"hi\":").is_some() {
            let hi = self.decimal()?;
            self.literal(b",\"lo\":")?;
            let lo = self.decimal()?;
            self.literal(b"}")?;
            return Some(Number::sum(hi, lo));
        }
        self.decimal().map(Number::of)
    }

    /// A number of JSON, which the standard library rounds correctly.
    #[inline(always)]
    fn decimal(&mut self) -> Option<f64> {
        let from = self.at;
        self.at += usize::from(self.byte() == b'-');
        self.whole()?;
        if self.byte() == b'.' {
            self.at += 1;
            self.digits()?;
        }
        if matches!(self.byte(), b'e' | b'E') {
            self.at += 1;
            self.at += usize::from(matches!(self.byte(), b'-' | b'+'));
            self.digits()?;
        }
        let text = str::from_utf8(&self.line[from..self.at]).ok()?;
        text.parse().ok().filter(|x: &f64| x.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = r#"{"step":7,"fibre":"secondary","index":12,"eq":"7","in":{"E":58600.0,"memory":[],"v":[-1.5e-310,"NaN",{"hi":0.1,"lo":-3e-18}]},"out":"-inf"}"#;

    #[test]
    fn an_event_is_read_to_the_last_bit() {
        let (at, rest) = head(LINE.as_bytes()).unwrap();
        let place = Place { step: 7, fibre: Fibre::Secondary, index: 12 };
        assert_eq!(at, At { place, equation: 7 });
        let mut quantities = Quantities::default();
        quantities.read(LINE.as_bytes(), rest).unwrap();
        let found: Vec<_> = quantities.all(LINE.as_bytes()).collect();
        let names: Vec<_> = found.iter().map(|q| (q.name, q.is_vector)).collect();
        let expected: [(&[u8], bool); 4] =
            [(b"E", false), (b"memory", true), (b"v", true), (b"out", false)];
        assert_eq!(names, expected);
        assert!(found[0].numbers[0].is_same(Number::of(58600.0)));
        assert!(found[1].numbers.is_empty());
        for (found, expected) in found[2].numbers.iter().zip([
            Number::of(-1.5e-310),
            Number::of(f64::NAN),
            Number::sum(0.1, -3e-18),
        ]) {
            assert!(found.is_same(expected), "{found:?}");
        }
        assert!(found[3].numbers[0].is_same(Number::of(f64::NEG_INFINITY)));
        let memory = quantities.find(LINE.as_bytes(), b"memory", 3).unwrap();
        assert!(memory.is_vector && memory.numbers.is_empty());
    }

    /// Other JSON, and what is no JSON, is for the slow reader to judge.
    #[test]
    fn nothing_else_is_read() {
        let read = |line: &str| {
            let (_, rest) = head(line.as_bytes())?;
            Quantities::default().read(line.as_bytes(), rest)
        };
        assert!(read(LINE).is_some());
        for (from, to) in [
            ("7,", "07,"),
            ("7,", "18446744073709551616,"),
            ("\"7\"", "\"21\""),
            ("\"7\"", "\"0\""),
            ("secondary", "third"),
            ("58600.0", "58600."),
            ("58600.0", ".5"),
            ("58600.0", "+5.0"),
            ("58600.0", "05.0"),
            ("58600.0", "1e"),
            ("58600.0", "1e999"),
            ("58600.0", "inf"),
            ("58600.0", "null"),
            ("58600.0", " 58600.0"),
            ("\"E\"", "\"\\u0045\""),
            ("NaN", "nan"),
            (",\"lo\":-3e-18", ""),
            ("\"out\"", "\"in\""),
            ("inf\"}", "inf\"} "),
            ("inf\"}", "inf\"}}"),
        ] {
            assert!(LINE.contains(from));
            let line = LINE.replacen(from, to, 1);
            assert!(read(&line).is_none(), "{line}");
        }
        for end in 0..LINE.len() {
            assert!(read(&LINE[..end]).is_none(), "{}", &LINE[..end]);
        }
    }

    #[test]
    fn infinity_is_read_by_its_name() {
        let line = LINE.replacen("NaN", "inf", 1);
        let (_, rest) = head(line.as_bytes()).unwrap();
        let mut quantities = Quantities::default();
        quantities.read(line.as_bytes(), rest).unwrap();
        let v = quantities.find(line.as_bytes(), b"v", 2).unwrap();
        assert!(v.numbers[1].is_same(Number::of(f64::INFINITY)), "{v:?}");
    }

    #[test]
    fn a_hundred_quantities_are_not_too_many_and_one_more_is() {
        for (inputs, too_many) in [(99, false), (100, true)] {
            let more: String = (1..inputs).map(|k| format!("\"i{k}\":0.3,")).collect();
            let line = format!(
                r#"{{"step":7,"fibre":"primary","index":1,"eq":"7","in":{{{more}"E":1}},"out":1}}"#
            );
            let (_, rest) = head(line.as_bytes()).unwrap();
            let mut quantities = Quantities::default();
            quantities.read(line.as_bytes(), rest).unwrap();
            // The output is one of them.
            assert_eq!(quantities.all(line.as_bytes()).len(), inputs + 1);
            assert_eq!(quantities.are_too_many(), too_many);
        }
    }
}
