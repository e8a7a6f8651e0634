//! An interrupt from the keyboard, or a termination: what is half written is removed, and the program
//! ends with the code of shells for that.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{fs, process};

use crate::exit::{Exit, say};

/// The temporary files that have not taken their names.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The temporary files, held: as long as they are, no interrupt ends the program.
pub fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on an interrupt removes the temporary files and ends the program.
pub fn prepare() {
    // Where interrupts are ignored, as by nohup, they remain so: there is nothing to prepare for.
    let _ = ctrlc::try_set_handler(|| {
        // Held to the end, so that none is made after these.
        let unfinished = unfinished();
        for file in unfinished.iter() {
            // One that is gone is no trouble.
            let _ = fs::remove_file(file);
        }
        say("\ninterrupted");
        process::exit(Exit::Interrupted as i32);
    });
}
