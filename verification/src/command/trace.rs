//! `crossfibre trace`: every number of every equation, or of those that are chosen.

use std::cell::Cell;
use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Result, bail};
use crossfibre::march;
use crossfibre::outcome::Outcome;
use crossfibre::paper::Paper;
use crossfibre::plan::Plan;
use crossfibre::result::{WithPaper, with_paper};
use crossfibre::scene::Scene;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::{Event, Sink, Traced};
use crossfibre::trace_file::{Filter, JsonLines};

use super::select::{self, Seen};
use super::{ended, scene};
use crate::exit::{Exit, say};
use crate::output::{Destination, Output};
use crate::worked::Worked;

/// Arguments.
#[derive(clap::Args)]
pub struct Args {
    /// The scene, `-` for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    choice: select::Choice,
    /// Work each evaluation out as by hand, line by line, instead of JSON lines
    #[arg(long)]
    worked: bool,
    /// Write to FILE, `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(args: Args) -> Result<Exit> {
    let destination = Destination::of(args.output.as_deref())?;
    let scene = scene::read(&args.scene)?;
    let filter = Filter::from(args.choice);
    let plan = Plan::of(&scene);
    select::check(&filter, &plan)?;
    let last = filter.steps.as_ref().map_or(plan.steps, |steps| plan.steps.min(*steps.end()));
    let up_to_last = Scene { duration: last as f64 * plan.time_step, ..scene.clone() };
    scene::refuse_if_long(&Plan::of(&up_to_last), "choose an earlier --step")?;

    let work = Work { scene: &scene, filter, last, worked: args.worked, destination };
    let Done { outcome, wrong } = with_paper(&scene, work)?;
    let exit = ended::told(&scene, &outcome);
    if wrong > 0 {
        say(&format!("{wrong} evaluations are not what their lines give"));
        return Ok(Exit::CheckFailed);
    }
    Ok(exit)
}

/// A march to a step, traced.
struct Work<'a> {
    scene: &'a Scene,
    filter: Filter,
    last: u64,
    worked: bool,
    destination: Destination,
}

struct Done {
    outcome: Outcome,
    wrong: u64,
}

impl WithPaper<f64> for Work<'_> {
    type Out = Result<Done>;

    fn with(self, paper: &impl Paper<f64>) -> Result<Done> {
        let mut out = self.destination.open()?;
        let failed = Cell::new(false);
        let to = Watched { out: &mut out, failed: &failed, first_line: Some(Vec::new()) };
        let march =
            March { scene: self.scene, filter: &self.filter, last: self.last, failed: &failed };
        let (ran, events, wrong) = if self.worked {
            let mut sink = Worked::new(to, self.scene, paper, self.filter.clone());
            let ran = march.run(paper, &mut sink);
            let tally = sink.finish()?;
            (ran, tally.events, tally.wrong)
        } else {
            let mut sink = JsonLines::start(to, self.scene, paper, self.filter.clone())?;
            (march.run(paper, &mut sink), sink.finish()?, 0)
        };
        if events > 0 {
            out.finish()?;
        } else if ran.outcome.is_completed() {
            bail!("{}", ran.seen.nothing_matches(self.last));
        }
        Ok(Done { outcome: ran.outcome, wrong })
    }
}

/// The march of a trace: as far as it is wanted, or until what it writes to fails.
struct March<'a> {
    scene: &'a Scene,
    filter: &'a Filter,
    last: u64,
    failed: &'a Cell<bool>,
}

struct Ran {
    outcome: Outcome,
    seen: Seen,
}

impl March<'_> {
    fn run(&self, paper: &impl Paper<f64>, sink: &mut impl Sink<f64>) -> Ran {
        let mut seen = Seen::default();
        // Where something matches, nobody asks why nothing does.
        let mut matches = false;
        let traced = Traced::new(paper, |event: &Event<'_, f64>| {
            if !matches {
                matches = self.filter.keeps(event.place, event.equation);
                seen.note(self.filter, event.place, event.equation);
            }
            sink.event(event);
        });
        let mut state = State::at_impact(self.scene, Wavefront::Flagged);
        let mut outcome = Outcome::Completed;
        while state.step < self.last && !self.failed.get() {
            if let Err(early) = march::step(&traced, &mut state) {
                outcome = early;
                break;
            }
        }
        Ran { outcome, seen }
    }
}

/// An output that withholds the first line until there is a second, since a trace without events is
/// not written; and that remembers a failure, such as a pipe whose reader has gone: no use to march
/// on.
struct Watched<'a> {
    out: &'a mut Output,
    failed: &'a Cell<bool>,
    first_line: Option<Vec<u8>>,
}

impl Write for Watched<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(line) = &mut self.first_line
            && !line.ends_with(b"\n")
        {
            line.extend_from_slice(bytes);
            return Ok(bytes.len());
        }
        let withheld = self.first_line.take().unwrap_or_default();
        self.out
            .write_all(&withheld)
            .and_then(|()| self.out.write(bytes))
            .inspect_err(|_| self.failed.set(true))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
