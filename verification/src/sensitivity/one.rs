//! What the checks say while one fault is planted: a process of its own, since a fault may make it
//! panic or go on for ever.
//!
//! The process is this program with `verify --plant FAULT`. It prints a line of JSON for each case
//! that comes to its end; the others have been stopped by the fault.

use std::io::{BufRead, BufReader};
use std::panic::{self, AssertUnwindSafe};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, ensure};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::cases::{Bound, Case, Check, HEAD_ROOM, Verdict};
use crate::planted::{self, Group};

/// A case that has said nothing for so long goes on for ever. Without a fault the slowest takes 3 s.
const PATIENCE: Duration = Duration::from_secs(300);

/// What the checks of a case say.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Said {
    /// The case.
    pub case: String,
    /// The claims of its checks, and whether each stands.
    pub checks: Vec<(String, bool)>,
}

impl Said {
    fn by(case: &Case) -> Self {
        let stands = |check: &Check| match (check.verdict(), check.bound) {
            (Verdict::Passed, _) => true,
            // Errors of rounding are others where the words are. A bound is at most so many times the
            // reference's own.
            (Verdict::Loose, _) => is_rewritten(),
            (_, Bound::AtMost(most)) => is_rewritten() && check.measured <= HEAD_ROOM * most,
            _ => false,
        };
        let said = |check: Check| {
            let stands = stands(&check);
            (check.claim, stands)
        };
        let checks = (case.run)().into_iter().map(said).collect();
        Self { case: case.id.into(), checks }
    }

    /// Whether a check is there and stands.
    pub fn stands(&self, claim: &str) -> bool {
        self.checks.iter().any(|(said, stands)| said == claim && *stands)
    }
}

/// Whether what is planted is no fault but the same in other words.
fn is_rewritten() -> bool {
    planted::now().is_some_and(|plant| plant.entry().group == Group::Rewrite)
}

/// Runs cases on all cores and tells of each that comes to its end.
pub fn tell(cases: &[Case], told: impl Fn(&Said) + Sync) {
    // What a panic says is of no use here: that there was one is seen by the silence.
    panic::set_hook(Box::new(|_| {}));
    cases.par_iter().for_each(|case| {
        if let Ok(said) = panic::catch_unwind(AssertUnwindSafe(|| Said::by(case))) {
            told(&said);
        }
    });
}

/// Asks a process with this fault; the cases that have told something.
///
/// # Errors
/// It cannot be started, does not know the fault, or prints something else.
pub fn ask(command: &mut Command, cases: usize) -> Result<Vec<Said>> {
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .with_context(|| format!("{command:?} cannot be started"))?;
    let listened = listen(&mut child, cases);
    // It may have ended by itself.
    let _ = child.kill();
    let status = child.wait()?;
    let said = listened?;
    ensure!(!said.is_empty() || status.code() != Some(1), "{command:?} ends as with bad input");
    Ok(said)
}

fn listen(child: &mut Child, cases: usize) -> Result<Vec<Said>> {
    let lines = lines(child);
    let mut said = Vec::new();
    while said.len() < cases {
        match lines.recv_timeout(PATIENCE) {
            Ok(line) => {
                let line = line?;
                said.push(
                    serde_json::from_str(&line).with_context(|| format!("it prints {line}"))?,
                );
            }
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => break,
        }
    }
    Ok(said)
}

/// The lines that a process prints, as they come.
fn lines(child: &mut Child) -> Receiver<std::io::Result<String>> {
    let (sender, receiver) = channel();
    if let Some(out) = child.stdout.take() {
        thread::spawn(move || {
            for line in BufReader::new(out).lines() {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
    }
    receiver
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(script: &str) -> Command {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        command
    }

    const LINE: &str = r#"{"case":"a.case","checks":[["it stands",true],["it falls",false]]}"#;

    #[test]
    #[cfg(unix)]
    fn what_a_process_has_told_before_it_dies_counts() {
        let said = ask(&mut shell(&format!("echo '{LINE}'; exit 70")), 3).unwrap();
        assert_eq!(said.len(), 1);
        assert!(said[0].stands("it stands") && !said[0].stands("it falls"));
        assert!(!said[0].stands("it is not there"));
    }

    #[test]
    #[cfg(unix)]
    fn a_process_that_goes_on_after_its_last_case_is_ended_and_one_that_refuses_is_an_error() {
        let said = ask(&mut shell(&format!("echo '{LINE}'; exec sleep 1000")), 1).unwrap();
        assert_eq!(said.len(), 1);
        assert!(ask(&mut shell("exit 1"), 1).is_err());
        assert!(ask(&mut shell("echo what"), 1).is_err());
    }

    #[test]
    fn a_case_that_panics_tells_nothing() {
        let case = |id, run| Case { id, title: "", equations: &[], run };
        let cases = [case("dies", || panic!("a fault")), case("lives", Vec::new)];
        let told = std::sync::Mutex::new(Vec::new());
        tell(&cases, |said| told.lock().unwrap().push(said.case.clone()));
        drop(panic::take_hook());
        assert_eq!(told.into_inner().unwrap(), ["lives"]);
    }
}
