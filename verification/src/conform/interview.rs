//! Everything that a candidate is asked, and the report on it.

use std::ffi::OsString;
use std::time::Instant;

use anyhow::{Result, bail};

use super::compare::Outcome;
use super::protocol::Ask;
use super::questions::{self, Item};
use super::record::{self, ItemRecord, Report, Rows, Seconds, Verdict};
use super::session::{Options, Session};

/// So many wrong runs are searched for the step at which they depart.
const SEARCHED: usize = 3;

/// Asks a candidate everything that it supports. `progress` is told of each question.
///
/// # Errors
/// If it cannot be started, or says nothing that can be understood.
pub fn conform(
    command: &[OsString],
    options: &Options,
    mut progress: impl FnMut(usize, usize),
) -> Result<(Report, Session)> {
    let start = Instant::now();
    let mut session = Session::start(command, options)?;
    let chosen = |item: &Item| {
        (options.depths.is_empty() || options.depths.contains(&item.depth))
            && options.filter.as_ref().is_none_or(|text| item.id.contains(text.as_str()))
    };
    let items: Vec<_> = questions::all(options.seed).into_iter().filter(chosen).collect();
    if items.is_empty() {
        bail!(
            "no question has {:?} in its name\n  help: names are such as `equation/4/corrected/awkward-1`, \
             `step/single-fibre`, `run/fig3`",
            options.filter.as_deref().unwrap_or_default()
        );
    }
    let mut rows = Rows::default();
    let mut records = Vec::new();
    let mut searched = 0;
    for (done, item) in items.iter().enumerate() {
        progress(done, items.len());
        let Outcome { verdict, reason, judged } = match questions::unsupported(item, &session.hello)
        {
            Some(reason) => Outcome::unjudged(Verdict::Skipped, reason),
            None => session.asked(&item.ask),
        };
        for judged in judged {
            rows.add(item.depth, &item.id, judged);
        }
        let departs_at_step = match &item.ask {
            Ask::Run { scene } if verdict == Verdict::Wrong && searched < SEARCHED => {
                searched += 1;
                session.departs(scene)
            }
            _ => None,
        };
        let (id, depth) = (item.id.clone(), item.depth);
        records.push(ItemRecord { id, depth, verdict, reason, departs_at_step });
    }
    progress(items.len(), items.len());
    let [candidate, reference] =
        [session.candidate.waited, session.reference].map(|time| time.as_secs_f64());
    let rest = start.elapsed().as_secs_f64() - candidate - reference;
    let judged = |record: &ItemRecord| {
        matches!(record.verdict, Verdict::Bits | Verdict::Rounding | Verdict::Wrong)
    };
    let report = Report {
        format: record::FORMAT.into(),
        crossfibre: env!("CARGO_PKG_VERSION").into(),
        command: command.iter().map(|word| word.to_string_lossy().into_owned()).collect(),
        candidate: session.hello.clone(),
        seed: options.seed,
        number: session.judge.precision,
        exact: options.exact,
        // Who was asked nothing has shown nothing.
        conforms: records.iter().any(judged) && !records.iter().any(|r| r.verdict.is_failure()),
        quantities: rows.finish(),
        items: records,
        seconds: Seconds { candidate, reference, rest },
    };
    Ok((report, session))
}
