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

#[cfg(test)]
#[cfg(unix)] // the program is one of any Unix
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::conform::protocol::Depth;

    /// A program that says this of itself, and then ends every run in a way that there is not.
    fn interviewed(fields: &str, depth: Depth, filter: &str) -> Report {
        let script = format!(
            r#"read q
            echo '{{"id":0,"format":"crossfibre-conformance/1","name":"a"{fields}}}'
            fibre='{{"position":[],"velocity":[],"strain":[],"tension":[]}}'
            rest="\"steps\":0,\"time_step\":0,\"primary\":$fibre"
            rest="$rest,\"projectile\":{{\"velocity\":0,\"position\":0}}"
            while read q
            do
                id=${{q#*:}}
                echo "{{\"id\":${{id%%,*}},\"result\":{{\"outcome\":{{\"kind\":\"lost\"}},$rest}}}}"
            done"#
        );
        let options = Options {
            depths: vec![depth],
            filter: Some(filter.into()),
            seed: 1,
            exact: true,
            single: false,
            timeout: Duration::from_secs(600),
        };
        let command = ["sh", "-c", script.as_str()].map(OsString::from);
        let mut told = Vec::new();
        let start = Instant::now();
        let (report, _session) =
            conform(&command, &options, |done, of| told.push((done, of))).unwrap();
        let elapsed = start.elapsed().as_secs_f64();
        let count = report.items.len();
        assert_eq!(told, (0..=count).map(|done| (done, count)).collect::<Vec<_>>());
        let Seconds { candidate, reference, rest } = report.seconds;
        assert!(candidate > 0.0 && rest > 0.0, "{candidate} {rest}");
        // No time is counted twice.
        assert!(candidate + reference + rest <= elapsed + 1e-9, "{elapsed}: {:?}", report.seconds);
        report
    }

    #[test]
    fn only_what_is_chosen_is_asked_and_who_was_asked_nothing_does_not_conform() {
        let report = interviewed(r#","depths":[]"#, Depth::Step, "drawn-1");
        let ids: Vec<_> = report.items.iter().map(|item| item.id.as_str()).collect();
        let expected = (10..20).map(|k| format!("step/drawn-{k}"));
        assert_eq!(
            ids,
            ["step/drawn-1".to_owned()].into_iter().chain(expected).collect::<Vec<_>>()
        );
        assert_eq!(report.count(Verdict::Skipped), ids.len());
        assert!(!report.conforms);
    }

    /// 1 and 10 to 19 are eleven. What is wrong at its end is wrong after one step, as every end is.
    #[test]
    fn the_first_three_wrong_runs_are_searched_for_the_step_at_which_they_depart() {
        let report = interviewed(r#","corrections":["all","none"]"#, Depth::Run, "run/drawn-1");
        assert_eq!(report.count(Verdict::Wrong), 11);
        let departs: Vec<_> = report.items.iter().map(|item| item.departs_at_step).collect();
        assert_eq!(departs[..3], [Some(1); 3]);
        assert_eq!(departs[3..], [None; 8]);
        assert!(!report.conforms);
    }

    #[test]
    fn a_run_that_is_not_wrong_is_not_searched() {
        let report = interviewed(r#","corrections":["all","none"]"#, Depth::Run, "-8");
        let found: Vec<_> =
            report.items.iter().map(|i| (i.id.as_str(), i.verdict, i.departs_at_step)).collect();
        let expected = [
            ("run/drawn-8", Verdict::Wrong, Some(1)),
            ("run/drawn-of-another-law-8", Verdict::Skipped, None),
        ];
        assert_eq!(found, expected);
    }
}
