//! Traces as JSON lines, format `crossfibre-trace/1`.
//!
//! The first line is a header: the format, the scene, the equations as the edition works them out,
//! and the symbols. Then one event a line. Numbers are the shortest decimals that read back to the
//! same bits; a number that is not finite, which JSON cannot hold, is the string `"inf"`, `"-inf"`
//! or `"NaN"`.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};

use crate::equations::{EQUATIONS, Line, SYMBOLS, Symbol, TENSION_BY_LAW};
use crate::number::Number;
use crate::paper::Paper;
use crate::place::{Fibre, Place};
use crate::scene::Scene;
use crate::trace::{Event, Sink, Value};

/// The format that this version writes.
pub const FORMAT: &str = "crossfibre-trace/1";

/// Which events to keep.
#[derive(Clone, Debug, Default)]
pub struct Filter {
    /// Steps, all if none are given.
    pub steps: Option<RangeInclusive<u64>>,
    /// Nodes or elements, all if none are given.
    pub indices: Option<RangeInclusive<usize>>,
    /// One fibre, or both.
    pub fibre: Option<Fibre>,
    /// Equations, all if none are given.
    pub equations: Vec<u8>,
}

impl Filter {
    /// Whether an event of this place and equation is kept.
    pub fn keeps(&self, place: Place, equation: u8) -> bool {
        self.steps.as_ref().is_none_or(|steps| steps.contains(&place.step))
            && self.indices.as_ref().is_none_or(|indices| indices.contains(&place.index))
            && self.fibre.is_none_or(|fibre| fibre == place.fibre)
            && (self.equations.is_empty() || self.equations.contains(&equation))
    }
}

/// The first line of a trace.
#[derive(Serialize)]
struct Header<'a> {
    format: &'a str,
    scene: &'a Scene,
    equations: Vec<Registered>,
    symbols: &'a [Symbol],
}

/// An equation as the traced edition works it out.
#[derive(Serialize)]
struct Registered {
    number: u8,
    name: &'static str,
    printed: &'static str,
    lines: Vec<Line>,
    /// The lines of a fibre with another law than (7), where the scene has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    lines_by_law: Option<[Line; 1]>,
}

/// Writes the kept events as JSON lines and counts them.
pub struct JsonLines<W> {
    out: W,
    filter: Filter,
    /// The line in the making: the output is given whole lines, not every bracket.
    line: Vec<u8>,
    written: u64,
    failure: Option<io::Error>,
}

impl<W: Write> JsonLines<W> {
    /// Writes the header.
    pub fn start<S: Number>(
        mut out: W,
        scene: &Scene,
        paper: &impl Paper<S>,
        filter: Filter,
    ) -> io::Result<Self> {
        let equations = EQUATIONS
            .iter()
            .map(|e| Registered {
                number: e.number,
                name: e.name,
                printed: e.printed,
                lines: paper.lines(e),
                lines_by_law: (e.number == 7 && scene.has_other_laws()).then_some([TENSION_BY_LAW]),
            })
            .collect();
        let header = Header { format: FORMAT, scene, equations, symbols: SYMBOLS };
        let mut line = Vec::new();
        write_line(&mut out, &mut line, &header)?;
        Ok(Self { out, filter, line, written: 0, failure: None })
    }

    /// The number of events written, or the first failure.
    pub fn finish(mut self) -> io::Result<u64> {
        self.failure.map_or(Ok(()), Err)?;
        self.out.flush()?;
        Ok(self.written)
    }
}

impl<S: Number, W: Write> Sink<S> for JsonLines<W> {
    fn event(&mut self, event: &Event<'_, S>) {
        if self.failure.is_some() || !self.filter.keeps(event.place, event.equation) {
            return;
        }
        match write_line(&mut self.out, &mut self.line, event) {
            Ok(()) => self.written += 1,
            Err(failure) => self.failure = Some(failure),
        }
    }
}

fn write_line(out: &mut impl Write, line: &mut Vec<u8>, what: &impl Serialize) -> io::Result<()> {
    line.clear();
    serde_json::to_writer(&mut *line, what)?;
    line.push(b'\n');
    out.write_all(line)
}

impl<S: Number> Serialize for Event<'_, S> {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        let mut map = to.serialize_map(Some(6))?;
        map.serialize_entry("step", &self.place.step)?;
        map.serialize_entry("fibre", &self.place.fibre)?;
        map.serialize_entry("index", &self.place.index)?;
        map.serialize_entry("eq", &Text(self.equation))?;
        map.serialize_entry("in", &Inputs(self.inputs))?;
        map.serialize_entry("out", &self.output)?;
        map.end()
    }
}

/// An equation's number is a name: a string.
struct Text(u8);

impl Serialize for Text {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        to.collect_str(&self.0)
    }
}

struct Inputs<'a, S>(&'a [(&'static str, Value<'a, S>)]);

impl<S: Number> Serialize for Inputs<'_, S> {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        to.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<S: Number> Serialize for Value<'_, S> {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        match self {
            Value::Scalar(x) => Finite(*x).serialize(to),
            Value::Vector(v) => {
                let mut seq = to.serialize_seq(Some(v.len()))?;
                for &x in *v {
                    seq.serialize_element(&Finite(x))?;
                }
                seq.end()
            }
        }
    }
}

/// A number, or its name where JSON has none.
struct Finite<S>(S);

impl<S: Number> Serialize for Finite<S> {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        if self.0.is_finite() { self.0.serialize(to) } else { to.collect_str(&self.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_event_is_one_json_object_that_reads_back_to_the_same_bits() {
        let place = Place { step: 7, fibre: Fibre::Primary, index: 12 };
        let v = [0.1_f64 + 0.2, -1e-310];
        let event = Event {
            place,
            equation: 4,
            inputs: &[("L", Value::Scalar(1.0_f64 / 3.0)), ("v", Value::Vector(&v))],
            output: Value::Scalar(f64::INFINITY),
        };
        let text = serde_json::to_string(&event).unwrap();
        assert_eq!(
            text,
            "{\"step\":7,\"fibre\":\"primary\",\"index\":12,\"eq\":\"4\",\
             \"in\":{\"L\":0.3333333333333333,\"v\":[0.30000000000000004,-1e-310]},\"out\":\"inf\"}"
        );
        let back: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(back["in"]["v"][0].as_f64().unwrap().to_bits(), v[0].to_bits());
        assert_eq!(back["in"]["v"][1].as_f64().unwrap().to_bits(), v[1].to_bits());
    }

    #[test]
    fn a_filter_keeps_what_it_names() {
        let filter = Filter {
            steps: Some(3..=5),
            indices: Some(2..=2),
            fibre: Some(Fibre::Secondary),
            equations: vec![4, 6],
        };
        let place = Place { step: 4, fibre: Fibre::Secondary, index: 2 };
        assert!(filter.keeps(place, 6));
        assert!(!filter.keeps(place, 5));
        assert!(!filter.keeps(Place { step: 6, ..place }, 6));
        assert!(!filter.keeps(Place { index: 1, ..place }, 6));
        assert!(!filter.keeps(Place { fibre: Fibre::Primary, ..place }, 6));
        assert!(Filter::default().keeps(place, 1));
    }
}
