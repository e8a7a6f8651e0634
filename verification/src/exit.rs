//! Exit codes, and what becomes of a panic.

use std::io::Write;
use std::panic::{self, UnwindSafe};
use std::process::ExitCode;

use anstyle::{AnsiColor, Style};

/// How the command ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// All well.
    Well = 0,
    /// Bad input or usage, or an output that cannot be written.
    BadInput = 1,
    /// A check failed.
    CheckFailed = 2,
    /// A run diverged or otherwise ended before its time.
    RunEnded = 3,
    /// A candidate disagrees with the reference, or a trace with another.
    CandidateDisagrees = 4,
    /// A fault of this program.
    Fault = 70,
    /// Interrupted from the keyboard, or terminated.
    Interrupted = 130,
}

/// The exit codes for the end of `--help`.
pub const HELP: &str = "\
Exit codes:
   0  all well
   1  bad input or usage, or an output that cannot be written
   2  a check failed
   3  the run diverged or otherwise ended early (its result is still written)
   4  a candidate disagrees with the reference, or a trace with another
  70  a fault of this program
 130  interrupted; no file is left half written";

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}

/// How what is wrong is marked, where there are colours.
pub const BAD: Style = AnsiColor::BrightRed.on_default().bold();

/// How what is right is marked.
pub const GOOD: Style = AnsiColor::BrightGreen.on_default().bold();

/// Writes a line to standard error, and does without if that is closed. Colours are for terminals only,
/// and not for those who set `NO_COLOR`.
pub fn say(line: &str) {
    let _ = writeln!(anstream::stderr(), "{line}");
}

/// Does the work; a panic on the way is a fault of this program, and said to be one.
pub fn guarded(work: impl FnOnce() -> Exit + UnwindSafe) -> Exit {
    panic::set_hook(Box::new(|panic| {
        say(&format!("fault: {panic}\n  this is a mistake in crossfibre: please report it"));
    }));
    panic::catch_unwind(work).unwrap_or(Exit::Fault)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_fault_of_this_program() {
        assert_eq!(guarded(|| panic!("an index out of range")), Exit::Fault);
        assert_eq!(guarded(|| Exit::RunEnded), Exit::RunEnded);
        // The hook is the process's: the other tests keep theirs.
        drop(panic::take_hook());
        assert_eq!(Exit::Fault as u8, 70);
    }

    #[test]
    fn the_help_names_every_code() {
        let codes = [
            Exit::Well,
            Exit::BadInput,
            Exit::CheckFailed,
            Exit::RunEnded,
            Exit::CandidateDisagrees,
            Exit::Fault,
            Exit::Interrupted,
        ];
        let listed: Vec<u8> = HELP
            .lines()
            .skip(1)
            .filter_map(|line| line.split_whitespace().next()?.parse().ok())
            .collect();
        assert_eq!(listed, codes.map(|code| code as u8));
    }
}
