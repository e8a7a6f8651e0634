//! What a command is given to read: a file, or standard input for `-`.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};

/// The name of an input in messages, and a reader of it.
pub fn open(path: &Path) -> Result<(String, Box<dyn Read>)> {
    if path == Path::new("-") {
        return Ok(("<stdin>".into(), Box::new(io::stdin())));
    }
    let name = path.display().to_string();
    match fs::metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => bail!("{name}: there is no such file"),
        Ok(there) if there.is_dir() => bail!("{name}: is a directory, not a file"),
        _ => (),
    }
    let file = File::open(path).with_context(|| name.clone())?;
    Ok((name, Box::new(file)))
}

/// Its name, and all that is in it.
pub fn bytes(path: &Path) -> Result<(String, Vec<u8>)> {
    let (name, mut from) = open(path)?;
    let mut bytes = Vec::new();
    from.read_to_end(&mut bytes).with_context(|| name.clone())?;
    Ok((name, bytes))
}

/// Its name, and its text; of what is none, `help` says what to give instead.
pub fn text(path: &Path, help: &str) -> Result<(String, String)> {
    let (name, bytes) = bytes(path)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        anyhow!("{name}: not UTF-8: the byte at offset {at}\n  help: {help}")
    })?;
    Ok((name, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_of_what_is_not_there_is_it_said_that_there_is_no_such_file() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "mine").unwrap();
        let refused = |path: &Path| open(path).map(drop).unwrap_err().to_string();
        assert!(refused(&folder.path().join("none")).ends_with("none: there is no such file"));
        assert!(refused(folder.path()).ends_with(": is a directory, not a file"));
        // Some systems say of a file in a file that it is not there, others that the first is no folder.
        #[cfg(unix)]
        assert!(refused(&file.join("x")).ends_with("x"));
    }
}
