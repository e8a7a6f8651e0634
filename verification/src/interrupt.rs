//! An interrupt from the keyboard, or a termination: what is half written is removed, and the program
//! ends with the code of shells for that.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{fs, io, process};

use crate::exit::{Exit, say};

/// The temporary files that have not taken their names, and the folders that are in use.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The temporary files and folders, held: as long as they are, no interrupt ends the program.
pub fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The folders that were made for what is to be written, each before those that it is in.
static MADE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Folders that are made now: if nothing is in them at an interrupt, they go as well.
pub fn made(folders: Vec<PathBuf>) {
    MADE.lock().unwrap_or_else(PoisonError::into_inner).extend(folders);
}

/// A temporary folder for what other programs are to read. It is gone when this is, or when the program
/// is interrupted.
#[derive(Debug)]
pub struct Scratch(PathBuf);

impl Scratch {
    /// An empty one.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn new() -> io::Result<Self> {
        let mut unfinished = unfinished();
        let path = tempfile::tempdir()?.keep();
        unfinished.insert(path.clone());
        Ok(Self(path))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        // One that is gone is no trouble.
        let _ = fs::remove_dir_all(&self.0);
        unfinished.remove(&self.0);
    }
}

/// From now on an interrupt removes the temporary files and folders and ends the program.
pub fn prepare() {
    // Where interrupts are ignored, as by nohup, they remain so: there is nothing to prepare for.
    let _ = ctrlc::try_set_handler(|| {
        // Held to the end, so that none is made after these.
        let unfinished = unfinished();
        for path in unfinished.iter() {
            // One that is gone is no trouble.
            let _ = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
        }
        for folder in MADE.lock().unwrap_or_else(PoisonError::into_inner).iter() {
            // One that something is in stays.
            let _ = fs::remove_dir(folder);
        }
        say("\ninterrupted");
        process::exit(Exit::Interrupted as i32);
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scratch_folder_goes_with_what_is_in_it() {
        let scratch = Scratch::new().unwrap();
        let path = scratch.path().to_owned();
        fs::write(path.join("scene.json"), "{}").unwrap();
        assert!(unfinished().contains(&path));
        drop(scratch);
        assert!(!path.exists() && !unfinished().contains(&path));
    }
}
