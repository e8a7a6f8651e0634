//! A candidate as a process: a line in, a line out, whatever it does with them.
//!
//! Threads read its outputs, so that it can neither block this program nor fill its memory: a line is
//! cut at [`LONGEST`], a few lines wait at most, and of standard error only the end is kept.

use std::collections::VecDeque;
use std::ffi::OsString;
use std::fmt::{self, Display, Formatter};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// The longest line that is read, bytes.
pub const LONGEST: u64 = 16 << 20;

/// Lines that a candidate may be ahead.
const AHEAD: usize = 2;

/// What is kept of standard error, bytes.
const LAST_WORDS: usize = 2000;

/// How long a candidate may take to end when there are no more questions, or to say why it ended.
const GRACE: Duration = Duration::from_secs(2);

/// Why there is no answer.
#[derive(Debug)]
pub enum Broken {
    /// The program cannot be started.
    Start(io::Error),
    /// It has ended.
    Ended(ExitStatus),
    /// It has closed its standard output, or failed to write to it, and goes on.
    Closed,
    /// It has not answered in time.
    Silent(Duration),
    /// The line is longer than any answer.
    TooLong,
    /// Bytes that are no text.
    NotText,
    /// There was a line before the question was put.
    Unasked(String),
}

impl Display for Broken {
    fn fmt(&self, to: &mut Formatter) -> fmt::Result {
        match self {
            Self::Start(error) => write!(to, "it cannot be started: {error}"),
            Self::Ended(status) => write!(to, "it ended without an answer: {status}"),
            Self::Closed => write!(to, "it closed its standard output"),
            Self::Silent(time) => write!(to, "no answer in {} s", time.as_secs_f64()),
            Self::TooLong => write!(to, "a line of more than {} MiB", LONGEST >> 20),
            Self::NotText => write!(to, "a line that is not UTF-8"),
            Self::Unasked(line) => write!(to, "a line that nobody asked for: {line}"),
        }
    }
}

/// A program that is asked, and started anew when it breaks.
pub struct Candidate {
    command: Vec<OsString>,
    timeout: Duration,
    running: Option<Running>,
    /// Time spent waiting for it.
    pub waited: Duration,
}

struct Running {
    child: Child,
    questions: SyncSender<String>,
    lines: Receiver<Result<Vec<u8>, Broken>>,
    last_words: Arc<Mutex<VecDeque<u8>>>,
    listener: JoinHandle<()>,
}

impl Candidate {
    /// The program of this command line.
    pub fn new(command: Vec<OsString>, timeout: Duration) -> Self {
        Self { command, timeout, running: None, waited: Duration::ZERO }
    }

    /// Puts a question and waits for the answer. After a failure the program is ended; it is started
    /// again with the next question.
    pub fn ask(&mut self, question: String) -> Result<String, Broken> {
        let start = Instant::now();
        let answer = self.asked(question);
        self.waited += start.elapsed();
        if answer.is_err() {
            self.stop();
        }
        answer
    }

    fn asked(&mut self, question: String) -> Result<String, Broken> {
        let just_started = self.running.is_none();
        if just_started {
            self.running = Some(Running::start(&self.command).map_err(Broken::Start)?);
        }
        let Some(running) = &mut self.running else { return Err(Broken::Closed) };
        // A program may say hello before it is asked to.
        if !just_started && let Ok(line) = running.lines.try_recv() {
            return Err(match line {
                Ok(line) => Broken::Unasked(shortened(&String::from_utf8_lossy(&line))),
                Err(broken) => running.why(broken),
            });
        }
        match running.questions.try_send(question) {
            Ok(()) => {}
            Err(TrySendError::Full(_)) => return Err(Broken::Silent(self.timeout)),
            Err(TrySendError::Disconnected(_)) => return Err(running.why(Broken::Closed)),
        }
        match running.lines.recv_timeout(self.timeout) {
            Ok(Ok(line)) => String::from_utf8(line).map_err(|_| Broken::NotText),
            Ok(Err(broken)) => Err(running.why(broken)),
            Err(RecvTimeoutError::Timeout) => Err(Broken::Silent(self.timeout)),
            Err(RecvTimeoutError::Disconnected) => Err(running.why(Broken::Closed)),
        }
    }

    /// The end of what the program wrote to standard error.
    pub fn last_words(&self) -> String {
        let words = self.running.as_ref().and_then(|r| r.last_words.lock().ok().map(|w| w.clone()));
        String::from_utf8_lossy(&words.map(Vec::from).unwrap_or_default()).trim().to_owned()
    }

    /// Whether it has been started and not ended since.
    pub fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Ends the program and all that it has started.
    fn stop(&mut self) {
        if let Some(running) = &mut self.running {
            running.kill();
        }
    }

    /// Ends the program and forgets its last words: the next question starts it again.
    pub fn forget(&mut self) {
        self.stop();
        self.running = None;
    }

    /// There are no more questions: lets the program end by itself, or ends it.
    pub fn finish(mut self) {
        if let Some(Running { mut child, questions, .. }) = self.running.take() {
            drop(questions);
            if wait(&mut child).is_none() {
                kill(&mut child);
            }
        }
    }
}

impl Drop for Candidate {
    fn drop(&mut self) {
        self.stop();
    }
}

impl Running {
    fn start(command: &[OsString]) -> io::Result<Self> {
        let (program, arguments) =
            command.split_first().ok_or_else(|| io::Error::other("no command is given"))?;
        let mut command = Command::new(program);
        command.args(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let missing = || io::Error::other("a pipe is missing");
        let stdin = child.stdin.take().ok_or_else(missing)?;
        let stdout = child.stdout.take().ok_or_else(missing)?;
        let stderr = child.stderr.take().ok_or_else(missing)?;
        let (questions, to_write) = sync_channel(AHEAD);
        thread::spawn(move || write_lines(stdin, &to_write));
        let (read, lines) = sync_channel(AHEAD);
        thread::spawn(move || read_lines(BufReader::new(stdout), &read));
        let last_words = Arc::new(Mutex::new(VecDeque::new()));
        let words = Arc::clone(&last_words);
        let listener = thread::spawn(move || keep_the_end(stderr, &words));
        Ok(Self { child, questions, lines, last_words, listener })
    }

    /// A program whose output has ended may have ended itself.
    fn why(&mut self, broken: Broken) -> Broken {
        match broken {
            Broken::Closed => match wait(&mut self.child) {
                Some(status) => {
                    // Its last words may be on their way.
                    until(|| self.listener.is_finished().then_some(()));
                    Broken::Ended(status)
                }
                None => Broken::Closed,
            },
            other => other,
        }
    }

    fn kill(&mut self) {
        kill(&mut self.child);
    }
}

/// Waits for the end of a process, but not long.
fn wait(child: &mut Child) -> Option<ExitStatus> {
    until(|| child.try_wait().ok().flatten())
}

/// Tries until there is something, but not long.
fn until<T>(mut there: impl FnMut() -> Option<T>) -> Option<T> {
    let start = Instant::now();
    loop {
        match there() {
            None if start.elapsed() < GRACE => thread::sleep(Duration::from_millis(2)),
            found => return found,
        }
    }
}

/// Ends a process and its group: a candidate may be a script that has started another program.
fn kill(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw) {
        // An empty group is as good as a killed one.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    // It may have ended by itself.
    let _ = child.kill();
    let _ = child.wait();
}

fn write_lines(mut stdin: ChildStdin, questions: &Receiver<String>) {
    for mut question in questions {
        question.push('\n');
        if stdin.write_all(question.as_bytes()).and_then(|()| stdin.flush()).is_err() {
            return;
        }
    }
}

fn read_lines(mut stdout: impl BufRead, lines: &SyncSender<Result<Vec<u8>, Broken>>) {
    loop {
        let mut line = Vec::new();
        let read = stdout.by_ref().take(LONGEST).read_until(b'\n', &mut line);
        let line = match read {
            Ok(n) if n > 0 && line.ends_with(b"\n") => {
                line.pop();
                Ok(line)
            }
            Ok(n) if n as u64 == LONGEST => Err(Broken::TooLong),
            _ => Err(Broken::Closed),
        };
        let last = line.is_err();
        if lines.send(line).is_err() || last {
            return;
        }
    }
}

fn keep_the_end(mut stderr: impl Read, words: &Mutex<VecDeque<u8>>) {
    let mut piece = [0; 1024];
    while let Ok(n @ 1..) = stderr.read(&mut piece) {
        let Ok(mut words) = words.lock() else { return };
        words.extend(&piece[..n]);
        let excess = words.len().saturating_sub(LAST_WORDS);
        words.drain(..excess);
    }
}

/// The beginning of a line that may be of any length.
pub fn shortened(line: &str) -> String {
    const SHOWN: usize = 120;
    match line.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}

#[cfg(test)]
#[cfg(unix)] // the programs are those of any Unix
mod tests {
    use std::path::Path;

    use super::*;

    fn shell(script: &str) -> Candidate {
        let command = ["sh", "-c", script].map(OsString::from).into();
        Candidate::new(command, Duration::from_secs(60))
    }

    #[test]
    fn a_program_that_is_asked_no_more_may_end_by_itself() {
        let folder = tempfile::tempdir().unwrap();
        let words = folder.path().join("words");
        let script = format!("read q; echo a; cat; echo over > '{}'", words.display());
        let mut candidate = shell(&script);
        assert_eq!(candidate.ask("who".into()).unwrap(), "a");
        candidate.finish();
        assert_eq!(std::fs::read_to_string(words).unwrap(), "over\n");
    }

    #[test]
    fn a_program_that_does_not_end_is_ended_with_the_candidate() {
        let proc = Path::new("/proc");
        for end in [drop as fn(Candidate), Candidate::finish] {
            let mut candidate = shell("read q; echo $$; sleep 60");
            let process = candidate.ask("who".into()).unwrap();
            assert_eq!(proc.join(&process).exists(), proc.exists());
            end(candidate);
            assert!(!proc.join(&process).exists());
        }
    }

    #[test]
    fn what_comes_late_is_waited_for_and_what_never_comes_is_given_up() {
        let mut left = 3;
        let late = until(|| {
            left -= 1;
            (left == 0).then_some(7)
        });
        assert_eq!(late, Some(7));
        let start = Instant::now();
        assert_eq!(until(|| None::<u8>), None);
        assert!(start.elapsed() >= GRACE);
    }

    /// The lines of a reader, each as its length, until it is broken off.
    fn lengths(from: impl BufRead + Send + 'static) -> (Vec<usize>, Broken) {
        let (to, lines) = sync_channel(AHEAD);
        let reader = thread::spawn(move || read_lines(from, &to));
        let mut lengths = Vec::new();
        let broken = loop {
            match lines.recv().unwrap() {
                Ok(line) => lengths.push(line.len()),
                Err(broken) => break broken,
            }
        };
        // After that there is nothing.
        assert!(lines.recv().is_err());
        reader.join().unwrap();
        (lengths, broken)
    }

    #[test]
    fn a_line_has_an_end_and_is_cut_off_where_it_gets_too_long() {
        let (found, broken) = lengths(&b"abc\n\nab\nabcd"[..]);
        assert_eq!(found, [3, 0, 2]);
        assert!(matches!(broken, Broken::Closed), "{broken}");
        let (found, broken) = lengths(&b""[..]);
        assert!(found.is_empty() && matches!(broken, Broken::Closed), "{broken}");
        let longest = usize::try_from(LONGEST).unwrap();
        let line = |length| BufReader::new(io::repeat(b'x').take(length).chain(&b"\n"[..]));
        // The end of the line is one of the bytes.
        let (found, broken) = lengths(line(LONGEST - 1));
        assert_eq!(found, [longest - 1]);
        assert!(matches!(broken, Broken::Closed), "{broken}");
        let (found, broken) = lengths(line(LONGEST));
        assert!(found.is_empty() && matches!(broken, Broken::TooLong), "{broken}");
    }

    #[test]
    fn when_nobody_listens_no_more_is_read() {
        let (to, lines) = sync_channel(AHEAD);
        drop(lines);
        let mut text = &b"a\nb\nc\n"[..];
        read_lines(&mut text, &to);
        assert_eq!(text, b"b\nc\n");
    }

    #[test]
    fn of_what_is_written_to_standard_error_the_end_is_kept() {
        let text = [vec![b'a'; 3000], vec![b'b'; LAST_WORDS - 1]].concat();
        let words = Mutex::new(VecDeque::new());
        keep_the_end(&*text, &words);
        let kept = Vec::from(words.into_inner().unwrap());
        assert_eq!(kept, text[3000 - 1..]);
    }

    #[test]
    fn a_line_is_shortened_to_characters_not_to_bytes() {
        let line = "×".repeat(120);
        assert_eq!(shortened(&line), line);
        assert_eq!(shortened(&format!("{line}×")), format!("{line}…"));
    }
}
