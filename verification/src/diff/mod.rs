//! Two traces compared: read in lock step, in bounded memory, to the first difference and beyond.
//!
//! Events are aligned by their [rank](rank::Rank), the order of the paper, to which both traces keep.
//! Lines of the same bytes agree; of them only the place and the equation are read. Others are read
//! and compared number by number.

pub mod header;
mod lines;
mod number;
mod origin;
pub mod rank;
pub mod record;
mod scan;
mod stream;
mod tally;
mod text;
mod verdict;

#[cfg(test)]
mod tests;

use std::path::Path;

use anyhow::{Result, bail};
use crossfibre::trace_file::Filter;

use header::HeaderDifference;
use number::Apart;
pub use number::Tolerance;
use rank::At;
use record::{Agreeing, FirstDifference, Kind, Located, QuantityDifference, Record};
use scan::{Named, Quantities};
pub use stream::Stream;
use tally::Tally;
pub use text::Report;

use crate::trace_line;

/// What is to be compared, and how.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Which events.
    pub filter: Filter,
    /// How far apart numbers may be.
    pub tolerance: Tolerance,
    /// Read no further than the first difference.
    pub first_only: bool,
}

/// A comparison on its way.
pub struct Comparison {
    a: Stream,
    b: Stream,
    options: Options,
    quantities: [Quantities; 2],
    header: HeaderDifference,
    /// By the number of the equation.
    tallies: [Tally; 21],
    agree_before: u64,
    last_agreeing: Option<(At, u64, u64)>,
    first: Option<FirstDifference>,
    notes: Vec<String>,
    to_the_end: bool,
}

/// One of the two traces.
#[derive(Clone, Copy)]
enum Side {
    A,
    B,
}

impl Comparison {
    /// Opens both traces and reads their headers.
    pub fn open(a: &Path, b: &Path, options: Options) -> Result<Self> {
        let [a, b] = [a, b].map(|path| Stream::open(path, options.filter.clone()));
        Ok(Self::of(a?, b?, options))
    }

    /// Of two traces whose headers have been read.
    pub fn of(a: Stream, b: Stream, options: Options) -> Self {
        let header = HeaderDifference::of(&a.header, &b.header);
        Self {
            a,
            b,
            options,
            quantities: Default::default(),
            header,
            tallies: Default::default(),
            agree_before: 0,
            last_agreeing: None,
            first: None,
            notes: vec![],
            to_the_end: false,
        }
    }

    /// Reads on to the end of both, or to the first difference if no more is wanted.
    ///
    /// After a failure the record holds what had come of it until then.
    pub fn run(&mut self) -> Result<()> {
        self.a.advance()?;
        self.b.advance()?;
        loop {
            match (self.a.rank(), self.b.rank()) {
                (None, None) => break,
                (Some(a), Some(b)) if a == b => {
                    self.pair()?;
                    self.a.advance()?;
                    self.b.advance()?;
                }
                (Some(a), b) if b.is_none_or(|b| a < b) => {
                    self.alone(Side::A)?;
                    self.a.advance()?;
                }
                _ => {
                    self.alone(Side::B)?;
                    self.b.advance()?;
                }
            }
            if self.options.first_only && self.first.is_some() {
                return Ok(());
            }
        }
        self.to_the_end = true;
        if self.tallies.iter().all(Tally::is_empty) {
            bail!("neither trace has an event of this choice");
        }
        Ok(())
    }

    /// Both traces have the evaluation.
    fn pair(&mut self) -> Result<()> {
        let Some(at) = self.a.at() else { return Ok(()) };
        let tally = &mut self.tallies[usize::from(at.equation)];
        let line = self.a.text();
        if line == self.b.text() && line.ends_with(b"}") && line.is_ascii() {
            tally.events += 1;
            self.agreed(at);
            return Ok(());
        }
        let [in_a, in_b] = &mut self.quantities;
        self.a.quantities(in_a)?;
        self.b.quantities(in_b)?;
        let (line_a, line_b) = (self.a.text(), self.b.text());
        let (mut is_same, mut agrees) = (true, true);
        let (count_a, count_b) = (in_a.all(line_a).len(), in_b.all(line_b).len());
        for (i, a) in in_a.all(line_a).enumerate() {
            match in_b.find(line_b, a.name, i).filter(|b| is_comparable(&a, b)) {
                Some(b) => {
                    let apart = Apart::of(a.numbers, b.numbers, self.options.tolerance);
                    tally.note(&apart, at, a.name);
                    is_same &= apart.is_same;
                    agrees &= apart.agrees;
                }
                None => agrees = false,
            }
        }
        agrees &= count_a == count_b;
        if agrees {
            tally.events += 1;
            tally.within_tolerance += u64::from(!is_same);
            self.agreed(at);
        } else {
            if self.first.is_none() {
                let (kind, quantities) = self.apart();
                self.differs(kind, at, quantities)?;
            }
            let tally = &mut self.tallies[usize::from(at.equation)];
            tally.events += 1;
            tally.differing += 1;
        }
        Ok(())
    }

    fn agreed(&mut self, at: At) {
        if self.first.is_none() {
            self.agree_before += 1;
            self.last_agreeing = Some((at, self.a.line_number(), self.b.line_number()));
        }
    }

    /// One trace has an evaluation that the other lacks.
    fn alone(&mut self, side: Side) -> Result<()> {
        let (of, other, kind, at_end) = match side {
            Side::A => (&self.a, &self.b, Kind::OnlyInA, Kind::BEnds),
            Side::B => (&self.b, &self.a, Kind::OnlyInB, Kind::AEnds),
        };
        let Some(at) = of.at() else { return Ok(()) };
        let kind = if other.at().is_none() { at_end } else { kind };
        self.tallies[usize::from(at.equation)].alone[side as usize] += 1;
        if self.first.is_none() {
            self.differs(kind, at, vec![])?;
        }
        Ok(())
    }

    /// In what the quantities of the two events differ, and what kind of difference that makes.
    #[cold]
    fn apart(&self) -> (Kind, Vec<QuantityDifference>) {
        let [in_a, in_b] = &self.quantities;
        let (line_a, line_b) = (self.a.text(), self.b.text());
        let names: Vec<_> = in_a.all(line_a).chain(in_b.all(line_b)).map(|q| q.name).collect();
        let mut found: Vec<QuantityDifference> = Vec::new();
        let (mut kind, mut inputs_agree) = (Kind::Output, true);
        for (i, name) in names.into_iter().enumerate() {
            let name_of = String::from_utf8_lossy(name).into_owned();
            let (a, b) = (in_a.find(line_a, name, i), in_b.find(line_b, name, i));
            let both = a.zip(b).filter(|(a, b)| is_comparable(a, b));
            let apart = both.map(|(a, b)| Apart::of(a.numbers, b.numbers, self.options.tolerance));
            if apart.is_some_and(|apart| apart.is_same) || found.iter().any(|f| f.name == name_of) {
                continue;
            }
            match apart {
                None => kind = Kind::Quantities,
                Some(apart) => inputs_agree &= apart.agrees || name == b"out",
            }
            found.push(QuantityDifference {
                name: name_of,
                a: a.map(value),
                b: b.map(value),
                ulp: apart.and_then(|apart| apart.ulp),
                relative: apart.map(|apart| number::Number::of(apart.relative).into()),
                agrees: apart.is_some_and(|apart| apart.agrees),
            });
        }
        if kind == Kind::Output && !inputs_agree {
            kind = Kind::Inputs;
        }
        (kind, found)
    }

    #[cold]
    fn differs(&mut self, kind: Kind, at: At, quantities: Vec<QuantityDifference>) -> Result<()> {
        let traced = |equation: u8| self.tallies[usize::from(equation)].events > 0;
        self.notes = verdict::notes(kind, &quantities, traced, !self.header.scene.is_empty());
        let [a, b] = [&self.a, &self.b].map(located);
        self.first =
            Some(FirstDifference { kind, evaluation: at.into(), a: a?, b: b?, quantities });
        Ok(())
    }

    /// What has come of it.
    pub fn record(&self) -> Record {
        let first = self.first.clone();
        let sum = |of: fn(&Tally) -> u64| self.tallies.iter().map(of).sum::<u64>();
        let verdict = match &first {
            Some(first) => verdict::first(first, &self.header),
            None => verdict::agreement(sum(|t| t.events), sum(|t| t.within_tolerance)),
        };
        Record {
            format: record::FORMAT.into(),
            a: self.a.name.clone(),
            b: self.b.name.clone(),
            tolerance: self.options.tolerance.relative,
            ulp: self.options.tolerance.ulp,
            agree: first.is_none(),
            verdict,
            notes: self.notes.clone(),
            header: self.header.clone(),
            agree_before: self.agree_before,
            last_agreeing: self.last_agreeing.map(|(at, line_a, line_b)| Agreeing {
                evaluation: at.into(),
                line_a,
                line_b,
            }),
            first_difference: first,
            to_the_end: self.to_the_end,
            equations: self
                .tallies
                .iter()
                .enumerate()
                .filter(|(_, tally)| !tally.is_empty())
                .map(|(equation, tally)| tally.record(equation))
                .collect(),
        }
    }
}

fn is_comparable(a: &Named<'_>, b: &Named<'_>) -> bool {
    a.is_vector == b.is_vector && a.numbers.len() == b.numbers.len()
}

fn value(of: Named<'_>) -> trace_line::Value {
    match of.numbers {
        [number] if !of.is_vector => trace_line::Value::Scalar((*number).into()),
        numbers => trace_line::Value::Vector(numbers.iter().map(|&n| n.into()).collect()),
    }
}

/// The event that a trace is at, for the record.
fn located(of: &Stream) -> Result<Option<Located>> {
    if of.at().is_none() {
        return Ok(None);
    }
    Ok(Some(Located { line: of.line_number(), event: of.event()? }))
}
