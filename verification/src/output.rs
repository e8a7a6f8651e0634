//! Where output goes. A file is written whole or not at all: into a temporary file beside it, which
//! takes its name when everything is in it.

use std::fs::{self, File};
use std::io::{self, BufWriter, StdoutLock, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use tempfile::NamedTempFile;

use crate::interrupt::{made, unfinished};

/// Where output is to go, found fit to be written.
#[derive(Debug)]
pub enum Destination {
    /// Standard output.
    Stdout,
    /// A file, new or to be replaced.
    File(PathBuf),
    /// Something that is there and not a file, such as a pipe or a terminal: it is written to, never
    /// replaced.
    Device(PathBuf),
}

impl Destination {
    /// The destination of an `-o`; standard output for none, and for `-`.
    pub fn of(path: Option<&Path>) -> Result<Self> {
        let path = match path {
            None => return Ok(Self::Stdout),
            Some(path) if path == Path::new("-") => return Ok(Self::Stdout),
            Some(path) => path,
        };
        match fs::metadata(path) {
            Ok(there) if there.is_dir() => bail!("{}: is a directory", path.display()),
            Ok(there) if !there.is_file() => Ok(Self::Device(path.into())),
            // What a link points to is replaced, not the link.
            Ok(_) => Ok(Self::File(path.canonicalize().unwrap_or_else(|_| path.into()))),
            Err(_) => match folder(path).metadata() {
                Ok(there) if there.is_dir() => Ok(Self::File(path.into())),
                _ => bail!("{}: there is no folder {}", path.display(), folder(path).display()),
            },
        }
    }

    /// Opens it. Nothing is seen under the name of a file before [`Output::finish`].
    pub fn open(self) -> Result<Output> {
        Ok(match self {
            Self::Stdout => Output::Stdout(BufWriter::new(io::stdout().lock())),
            Self::Device(path) => {
                let file = File::options().write(true).open(&path).with_context(|| name(&path))?;
                Output::Device(BufWriter::new(file))
            }
            Self::File(path) => {
                // An interrupt finds either both the file and its name, or neither.
                let mut unfinished = unfinished();
                let file = temporary().tempfile_in(folder(&path)).with_context(|| name(&path))?;
                unfinished.insert(file.path().into());
                Output::File(BufWriter::new(file), path)
            }
        })
    }
}

/// Makes a folder fit to be written to, if there is none: before the work whose outcome it is for.
pub fn make_folder(folder: &Path) -> Result<()> {
    let is_new = |path: &&Path| !path.as_os_str().is_empty() && !path.exists();
    made(folder.ancestors().take_while(is_new).map(Path::to_owned).collect());
    fs::create_dir_all(folder)
        .with_context(|| format!("{}: cannot be made a folder", folder.display()))?;
    tempfile::tempfile_in(folder)
        .with_context(|| format!("{}: cannot be written to", folder.display()))?;
    Ok(())
}

fn name(path: &Path) -> String {
    path.display().to_string()
}

/// The folder of a file; `.` for a bare name.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A temporary file with the permissions of an ordinary one.
fn temporary() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".crossfibre-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

/// Output on its way.
#[derive(Debug)]
pub enum Output {
    /// Standard output.
    Stdout(BufWriter<StdoutLock<'static>>),
    /// Something that cannot be replaced.
    Device(BufWriter<File>),
    /// A temporary file, and the name that it will take.
    File(BufWriter<NamedTempFile>, PathBuf),
}

impl Output {
    /// Everything is written: a file takes its name.
    pub fn finish(self) -> Result<()> {
        match self {
            Self::Stdout(mut out) => Ok(out.flush()?),
            Self::Device(mut out) => Ok(out.flush()?),
            Self::File(out, path) => {
                let file =
                    out.into_inner().map_err(|e| e.into_error()).with_context(|| name(&path))?;
                let mut unfinished = unfinished();
                unfinished.remove(file.path());
                file.persist(&path).map_err(|e| e.error).with_context(|| name(&path))?;
                Ok(())
            }
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Stdout(out) => out.write(bytes),
            Self::Device(out) => out.write(bytes),
            Self::File(out, _) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Stdout(out) => out.flush(),
            Self::Device(out) => out.flush(),
            Self::File(out, _) => out.flush(),
        }
    }
}

/// Whether an error is only that the reader of a pipe has gone, as in `crossfibre … | head`.
pub fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>())
        .any(|error| error.kind() == io::ErrorKind::BrokenPipe)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_only_when_it_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("result.json");
        fs::write(&path, "old").unwrap();
        let count = || fs::read_dir(folder.path()).unwrap().count();

        let mut out = Destination::of(Some(&path)).unwrap().open().unwrap();
        out.write_all(b"half of").unwrap();
        assert_eq!((fs::read_to_string(&path).unwrap().as_str(), count()), ("old", 2));
        drop(out);
        assert_eq!((fs::read_to_string(&path).unwrap().as_str(), count()), ("old", 1));

        let mut out = Destination::of(Some(&path)).unwrap().open().unwrap();
        out.write_all(b"the whole").unwrap();
        out.finish().unwrap();
        assert_eq!((fs::read_to_string(&path).unwrap().as_str(), count()), ("the whole", 1));
    }

    #[test]
    fn what_is_flushed_is_in_the_file_that_has_no_name_yet() {
        let folder = tempfile::tempdir().unwrap();
        let mut out =
            Destination::of(Some(&folder.path().join("result.json"))).unwrap().open().unwrap();
        out.write_all(b"half of").unwrap();
        let written = || {
            let only = fs::read_dir(folder.path()).unwrap().next().unwrap().unwrap().path();
            fs::read_to_string(only).unwrap()
        };
        assert_eq!(written(), "");
        out.flush().unwrap();
        assert_eq!(written(), "half of");
    }

    /// A socket is there, and can neither be opened nor replaced.
    #[cfg(unix)]
    #[test]
    fn what_cannot_be_opened_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let socket = folder.path().join("socket");
        let _bound = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        let refused = Destination::of(Some(&socket)).unwrap().open().unwrap_err();
        assert_eq!(refused.to_string(), socket.display().to_string());
    }

    #[cfg(unix)]
    #[test]
    fn a_device_is_written_to_and_a_link_is_followed_neither_is_replaced() {
        assert!(matches!(
            Destination::of(Some(Path::new("/dev/null"))),
            Ok(Destination::Device(_))
        ));
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        let mut out = Destination::of(Some(&link)).unwrap().open().unwrap();
        out.write_all(b"new").unwrap();
        out.finish().unwrap();
        assert!(link.is_symlink());
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    }

    #[test]
    fn a_folder_and_a_file_in_no_folder_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let refused = |path: &Path| Destination::of(Some(path)).unwrap_err().to_string();
        assert!(refused(folder.path()).ends_with(": is a directory"));
        assert!(refused(&folder.path().join("a/b.json")).contains("there is no folder"));
        fs::write(folder.path().join("file"), "mine").unwrap();
        assert!(refused(&folder.path().join("file/b.json")).contains("there is no folder"));
    }

    #[test]
    fn a_folder_is_made_with_those_it_is_in_but_not_where_a_file_is() {
        let folder = tempfile::tempdir().unwrap();
        let [file, new] = ["file", "a/b"].map(|name| folder.path().join(name));
        fs::write(&file, "mine").unwrap();
        let refused = make_folder(&file).unwrap_err();
        assert!(format!("{refused:#}").contains("file: cannot be made a folder: "), "{refused:#}");
        make_folder(&new).unwrap();
        make_folder(&new).unwrap();
        assert_eq!(fs::read_dir(&new).unwrap().count(), 0);
    }
}
