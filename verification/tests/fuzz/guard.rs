//! What watches over an input: panics are caught and told in words, memory is counted, and a thread
//! ends the process, naming the input, if one takes longer than any should.

use std::cell::{Cell, RefCell};
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Arc, Mutex, Once};
use std::thread;
use std::time::{Duration, Instant};

/// How long an input may take: thousands of times what the longest takes, so that nothing but a hang
/// is one, however busy the machine. The only use of time.
const LIMIT: Duration = Duration::from_secs(60);

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
    static PANIC: RefCell<String> = const { RefCell::new(String::new()) };
}

/// What became of an input.
pub enum Ended {
    /// It was read: accepted, or refused in these words.
    Read(Result<(), String>),
    /// The reader panicked.
    Panicked(String),
}

/// The input that is being read, and since when.
type Current = Arc<Mutex<Option<(String, Instant)>>>;

/// Watches over inputs, one at a time.
pub struct Guard {
    current: Current,
}

impl Guard {
    /// Begins to watch.
    pub fn start() -> Self {
        static HOOK: Once = Once::new();
        HOOK.call_once(|| {
            let usual = panic::take_hook();
            panic::set_hook(Box::new(move |panic| match QUIET.get() {
                true => PANIC.set(panic.to_string()),
                false => usual(panic),
            }));
        });
        let current = Current::default();
        let watched = Arc::downgrade(&current);
        thread::spawn(move || {
            while let Some(current) = watched.upgrade() {
                if let Some((input, since)) = &*current.lock().unwrap()
                    && since.elapsed() > LIMIT
                {
                    eprintln!("{input} has taken more than {} s", LIMIT.as_secs());
                    std::process::abort();
                }
                drop(current);
                thread::sleep(Duration::from_secs(1));
            }
        });
        Self { current }
    }

    /// Reads an input, and the most memory that this asked for at a time.
    pub fn watched(
        &self,
        reader: &str,
        number: u64,
        read: impl FnOnce() -> Result<(), String>,
    ) -> (Ended, u64) {
        *self.current.lock().unwrap() = Some((format!("{reader} {number}"), Instant::now()));
        let mut ended = Ended::Panicked(String::new());
        let memory = allocation_counter::measure(|| {
            QUIET.set(true);
            let read = panic::catch_unwind(AssertUnwindSafe(read));
            QUIET.set(false);
            ended = read.map_or_else(|_| Ended::Panicked(PANIC.take()), Ended::Read);
        });
        *self.current.lock().unwrap() = None;
        (ended, memory.bytes_max)
    }
}
