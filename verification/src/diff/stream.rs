//! A trace as it is read: its header, then its events in the paper's order, one at a time.

use std::io::Read;
use std::path::Path;

use anyhow::{Error, Result, anyhow, bail};
use crossfibre::trace_file::Filter;

use super::header;
use super::lines::{Lines, Trouble};
use super::rank::{At, Rank};
use super::record::Evaluation;
use super::scan::{Quantities, head};
use crate::input;
use crate::trace_line::{Event, Header};

/// The longest header, bytes.
const HEADER: usize = 64 << 20;

/// The longest event, bytes.
const EVENT: usize = 1 << 20;

/// A trace on its way from file to comparison.
pub struct Stream {
    /// The file, as it is called in messages.
    pub name: String,
    /// Its first line.
    pub header: Header,
    lines: Lines<Box<dyn Read>>,
    filter: Filter,
    both_at_impact: bool,
    /// The event, unless the trace has ended.
    current: Option<Current>,
    /// The rank of the event before, kept or not.
    before: Option<(Rank, At)>,
    /// The event as the library would have written it, if the line is written otherwise.
    rewritten: Option<Vec<u8>>,
}

#[derive(Clone, Copy)]
struct Current {
    at: At,
    rank: Rank,
    /// Where the quantities begin.
    rest: usize,
}

impl Stream {
    /// The trace of a file, or of standard input for `-`, before its first event.
    pub fn open(path: &Path, filter: Filter) -> Result<Self> {
        let (name, from) = input::open(path)?;
        Self::of(name, from, filter)
    }

    /// The trace that a reader gives.
    pub fn of(name: String, from: Box<dyn Read>, filter: Filter) -> Result<Self> {
        let mut lines = Lines::of(from);
        if !advance(&mut lines, &name, HEADER, "header")? {
            bail!(
                "{name}: is empty: a trace begins with a header\n  \
                 help: `crossfibre trace SCENE -o FILE` writes one"
            );
        }
        let header = header::read(lines.line()).map_err(|why| {
            let why = if lines.is_cut() { cut(&why) } else { why };
            anyhow!("{name}:1: {why}")
        })?;
        let both_at_impact = header::both_at_impact(&header.scene)
            .map_err(|problem| anyhow!("{name}:1: scene.{problem}"))?;
        Ok(Self {
            name,
            header,
            lines,
            filter,
            both_at_impact,
            current: None,
            before: None,
            rewritten: None,
        })
    }

    /// Goes on to the next event that the filter keeps.
    pub fn advance(&mut self) -> Result<()> {
        loop {
            self.rewritten = None;
            self.current = None;
            if !advance(&mut self.lines, &self.name, EVENT, "event")? {
                if self.before.is_none() {
                    bail!(
                        "{}: has a header and no event\n  \
                         help: `crossfibre trace SCENE -o FILE` writes both",
                        self.name
                    );
                }
                return Ok(());
            }
            let current = self.head()?;
            if self.lines.is_cut() {
                // A last line without its end may be whole all the same.
                self.quantities(&mut Quantities::default())?;
            }
            if self.filter.keeps(current.at.place, current.at.equation) {
                return Ok(());
            }
        }
    }

    /// What the line is an event of.
    fn head(&mut self) -> Result<Current> {
        let (at, rest) = match head(self.lines.line()) {
            Some(found) => found,
            None => self.rewrite()?,
        };
        let rank = Rank::of(at, self.both_at_impact).ok_or_else(|| {
            self.wrong(&format!("{} has no place in a step", Evaluation::from(at)))
        })?;
        if let Some((before, of)) = self.before
            && before >= rank
        {
            let again = if before == rank { "is there twice" } else { "is out of order" };
            return Err(self.wrong(&format!(
                "{} {again}: it comes after {}\n  \
                 help: events stand in the order in which the paper evaluates them; \
                 docs/formats.md has the order",
                Evaluation::from(at),
                Evaluation::from(of),
            )));
        }
        self.before = Some((rank, at));
        let current = Current { at, rank, rest };
        self.current = Some(current);
        Ok(current)
    }

    /// Reads the line as JSON and writes it as the library does.
    #[cold]
    fn rewrite(&mut self) -> Result<(At, usize)> {
        let event = event_of(self.lines.line())
            .map_err(|why| self.wrong(&if self.lines.is_cut() { cut(&why) } else { why }))?;
        let rewritten = serde_json::to_vec(&event)?;
        let found = head(&rewritten).ok_or_else(|| {
            self.wrong(&format!("unknown equation {:?}: the paper has \"1\" to \"20\"", event.eq))
        })?;
        self.rewritten = Some(rewritten);
        Ok(found)
    }

    /// Reads the quantities of the event.
    pub fn quantities(&mut self, into: &mut Quantities) -> Result<()> {
        let Some(current) = self.current else {
            return Ok(());
        };
        if into.read(self.text(), current.rest).is_some() {
            return self.checked(into);
        }
        if self.rewritten.is_none() {
            let (at, rest) = self.rewrite()?;
            self.current = Some(Current { at, rest, ..current });
            if into.read(self.text(), rest).is_some() {
                return self.checked(into);
            }
        }
        Err(self.wrong("an input whose name is not of plain letters"))
    }

    fn checked(&self, quantities: &Quantities) -> Result<()> {
        if quantities.are_too_many() { Err(self.wrong("too many inputs")) } else { Ok(()) }
    }

    /// The event as text: the line, or the same in the form of the library.
    pub fn text(&self) -> &[u8] {
        self.rewritten.as_deref().unwrap_or(self.lines.line())
    }

    /// The event, for a record.
    pub fn event(&self) -> Result<Event> {
        event_of(self.text()).map_err(|why| self.wrong(&why))
    }

    /// What the event is of; none at the end.
    pub fn at(&self) -> Option<At> {
        self.current.map(|current| current.at)
    }

    /// Where it stands in the order of the paper; none at the end.
    pub fn rank(&self) -> Option<Rank> {
        self.current.map(|current| current.rank)
    }

    /// The number of its line.
    pub fn line_number(&self) -> u64 {
        self.lines.number()
    }

    fn wrong(&self, why: &str) -> Error {
        anyhow!("{}:{}: {why}", self.name, self.lines.number())
    }
}

/// Goes on to the next line, if there is one.
fn advance(lines: &mut Lines<Box<dyn Read>>, name: &str, limit: usize, what: &str) -> Result<bool> {
    lines.advance(limit).map_err(|trouble| match trouble {
        Trouble::Io(error) => Error::new(error).context(name.to_owned()),
        Trouble::TooLong => anyhow!(
            "{name}:{}: the line has more than {} MiB: no {what} of a trace is so long",
            lines.number(),
            limit >> 20,
        ),
    })
}

/// An event written in any way, or what is wrong with it.
fn event_of(line: &[u8]) -> Result<Event, String> {
    let text = str::from_utf8(line)
        .map_err(|error| format!("byte {} is not UTF-8", error.valid_up_to() + 1))?;
    serde_json::from_str(text).map_err(|error| {
        if serde_json::from_str::<Header>(text).is_ok() {
            return "a second header\n  help: two traces in one file: divide it".into();
        }
        let what = if error.is_data() { "not an event of crossfibre-trace/1" } else { "not JSON" };
        // The line that the error means is the only one.
        let why = error.to_string();
        let why = why.split(" at line ").next().unwrap_or_default();
        format!("{what}: {why} (column {})", error.column())
    })
}

fn cut(why: &str) -> String {
    format!(
        "the file ends in the middle of this line: {why}\n  \
         help: whatever wrote it was broken off; write the trace again, or delete the line"
    )
}
