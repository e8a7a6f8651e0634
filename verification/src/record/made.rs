//! Makes a record: runs cases, and measures what a report says beside them.

use std::collections::BTreeMap;
use std::time::Instant;

use crossfibre::errata::LEDGER;
use crossfibre::place::Fibre;
use crossfibre::state::{State, Wavefront};
use crossfibre::trace::Traced;
use crossfibre::trace_file::Filter;
use crossfibre::{corrected::Corrected, corrected::Incremental, march};
use rayon::prelude::*;

use super::{Build, CaseRecord, CheckRecord, FORMAT, LedgerLine, Record, SceneDigest};
use crate::bits::fnv;
use crate::cases::support::{SCENES, coarse_fig3, shipped};
use crate::cases::{Case, all, verdicts};
use crate::derivations;
use crate::precision::{self, answer::wanted, stored::stored};
use crate::worked::Worked;
use crate::{claims, examined, ledger_effects, pictures, sensitivity};

/// Runs cases on all cores; `done` is told of each as it ends.
pub fn run_cases(cases: &[Case], done: impl Fn(&CaseRecord) + Sync) -> Vec<CaseRecord> {
    run_watched(cases, |_| (), |_, record| done(record))
}

/// Runs cases on all cores and begins them in their order. `begins` is told of each, `done` of each as it
/// ends, by its place in the order.
pub fn run_watched(
    cases: &[Case],
    begins: impl Fn(&Case) + Sync,
    done: impl Fn(usize, &CaseRecord) + Sync,
) -> Vec<CaseRecord> {
    let run = |(place, case): (usize, &Case)| {
        begins(case);
        let record = run_case(case);
        done(place, &record);
        (place, record)
    };
    // A slice would be divided in halves, and the second begun before the first is done.
    let records: BTreeMap<_, _> = cases.iter().enumerate().par_bridge().map(run).collect();
    records.into_values().collect()
}

fn run_case(case: &Case) -> CaseRecord {
    let start = Instant::now();
    let checks = (case.run)();
    let seconds = start.elapsed().as_secs_f64();
    let judged = verdicts(&checks);
    let judged = checks.into_iter().zip(judged);
    CaseRecord {
        id: case.id.into(),
        title: case.title.into(),
        quick: case.is_quick(),
        equations: case.equations.to_vec(),
        derivation: derivations::of(case.id),
        pictures: pictures::of_case(case.id),
        checks: judged.map(|(check, verdict)| CheckRecord { check, verdict }).collect(),
        seconds,
    }
}

/// The ids of the cases that were not run.
fn left_out(run: &[CaseRecord]) -> Vec<String> {
    let was_run = |id: &str| run.iter().any(|case| case.id == id);
    all().iter().map(|case| case.id).filter(|id| !was_run(id)).map(str::to_owned).collect()
}

impl Record {
    /// Measures what a report says beside the cases.
    pub fn around(cases: Vec<CaseRecord>) -> Self {
        let scenes = SCENES
            .iter()
            .map(|(name, text)| SceneDigest {
                name: (*name).into(),
                title: shipped(name).title,
                digest: format!("{:016x}", fnv(text.bytes())),
            })
            .collect();
        Self {
            left_out: left_out(&cases),
            format: FORMAT.into(),
            version: env!("CARGO_PKG_VERSION").into(),
            build: Build::here(),
            cases,
            scenes,
            ledger: LEDGER.iter().map(LedgerLine::from).collect(),
            effects: ledger_effects::measure(),
            claims: claims::examine(),
            worked: worked_step(),
            accuracy: precision::section(stored()),
            cost: wanted::stored(),
            pictures: pictures::all(),
            motion: Some(pictures::motion::fig3()),
            sensitivity: Some(sensitivity::stored::stored().clone()),
            examined: examined::stored(),
        }
    }
}

/// The crossover's node of a coarse Fig. 3 in the step after the wave has entered the secondary, and
/// the element behind it.
fn worked_step() -> String {
    let scene = coarse_fig3();
    let paper = Corrected::<Incremental>::new(scene.corrections);
    let step = 4;
    let filter = |indices, equations: &[u8]| Filter {
        steps: Some(step..=step),
        indices: Some(indices),
        fibre: Some(Fibre::Primary),
        equations: equations.to_vec(),
    };
    [filter(2..=2, &[2, 15, 16, 17, 18]), filter(1..=1, &[5, 6, 4, 7])]
        .into_iter()
        .map(|filter| {
            let mut text = Vec::new();
            let traced = Traced::new(&paper, Worked::new(&mut text, &scene, &paper, filter));
            let mut state = State::<f64>::at_impact(&scene, Wavefront::Flagged);
            march::run(&traced, &mut state, step, |_| {});
            traced.into_sink().finish().expect("a vector can be written to");
            String::from_utf8(text).expect("worked lines are text")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::made_up;

    #[test]
    fn what_was_not_run_is_left_out() {
        let ids: Vec<&str> = all().iter().map(|case| case.id).collect();
        let mut run = made_up::record().cases;
        run.truncate(2);
        (run[0].id, run[1].id) = (ids[3].into(), ids[0].into());
        let left = left_out(&run);
        assert_eq!(left.len(), ids.len() - 2);
        assert_eq!(left[..3], [ids[1], ids[2], ids[4]]);
        assert_eq!(left_out(&[]), ids);
    }
}
