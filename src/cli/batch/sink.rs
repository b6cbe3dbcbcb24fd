//! The destination of results: standard output, or a file that is created only when complete.

use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile};

use super::super::error::CliError;

const BUFFER: usize = 1 << 18;

/// Files that are not yet in their place.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes what is not yet in its place, before the program ends.
pub fn remove_unfinished() {
    for path in unfinished().drain(..) {
        // it may be in its place by now
        let _ = std::fs::remove_file(path);
    }
}

enum Target {
    Stdout(BufWriter<io::Stdout>),
    /// A pipe or a device: there is nothing to put in its place.
    Special(BufWriter<File>),
    /// Written to a temporary file in the same folder, and renamed at the end.
    File(BufWriter<NamedTempFile>),
}

/// The destination of results.
pub struct Sink {
    target: Target,
    path: PathBuf,
    closed: bool,
}

impl Sink {
    /// Standard output.
    pub fn stdout() -> Self {
        let target = Target::Stdout(BufWriter::with_capacity(BUFFER, io::stdout()));
        Self { target, path: PathBuf::from("-"), closed: false }
    }

    /// A file, which is created by [`Sink::finish`] only.
    pub fn file(path: &Path) -> Result<Self, CliError> {
        Self::buffered(path, BUFFER)
    }

    /// The same for a text that is written as a whole.
    pub fn page(path: &Path) -> Result<Self, CliError> {
        Self::buffered(path, 0)
    }

    fn buffered(path: &Path, buffer: usize) -> Result<Self, CliError> {
        let fail = |error: io::Error| unwritable(path, &error);
        // a link stays one: what it leads to is replaced
        let real = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if real.is_dir() {
            return Err(unwritable(path, &io::Error::from(ErrorKind::IsADirectory)));
        }
        let target = if real.exists() && !real.is_file() {
            let file = File::options().write(true).open(&real).map_err(fail)?;
            Target::Special(BufWriter::with_capacity(buffer, file))
        } else {
            let folder = real.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
            let mut builder = Builder::new();
            builder.prefix(".assur-").suffix(".tmp");
            permissions(&mut builder, &real);
            let mut unfinished = unfinished();
            let file = builder.tempfile_in(folder).map_err(fail)?;
            unfinished.push(file.path().to_owned());
            Target::File(BufWriter::with_capacity(buffer, file))
        };
        Ok(Self { target, path: real, closed: false })
    }

    /// Adds a text, or bytes. A reader of standard output that has gone away has seen enough: see [`Sink::closed`].
    pub fn write(&mut self, text: impl AsRef<[u8]>) -> Result<(), CliError> {
        if self.closed {
            return Ok(());
        }
        let bytes = text.as_ref();
        let written = match &mut self.target {
            Target::Stdout(out) => out.write_all(bytes),
            Target::Special(file) => file.write_all(bytes),
            Target::File(file) => file.write_all(bytes),
        };
        self.told(written)
    }

    /// Whether nobody reads any more.
    pub const fn closed(&self) -> bool {
        self.closed
    }

    fn told(&mut self, done: io::Result<()>) -> Result<(), CliError> {
        match done {
            Err(error)
                if matches!(self.target, Target::Stdout(_)) && error.kind() == ErrorKind::BrokenPipe =>
            {
                self.closed = true;
                Ok(())
            }
            done => done.map_err(|error| unwritable(&self.path, &error)),
        }
    }

    /// Puts what was written in its place; says whether all of it was read.
    pub fn finish(self) -> Result<bool, CliError> {
        self.put(true)
    }

    /// The same of a page that is soon made again: nobody waits until the disk has it.
    pub fn finish_page(self) -> Result<bool, CliError> {
        self.put(false)
    }

    fn put(mut self, lasts: bool) -> Result<bool, CliError> {
        let flushed = match &mut self.target {
            Target::Stdout(out) => out.flush(),
            Target::Special(file) => file.flush(),
            Target::File(file) if lasts => file.flush().and_then(|()| file.get_ref().as_file().sync_all()),
            Target::File(file) => file.flush(),
        };
        self.told(flushed)?;
        let (path, read) = (self.path, !self.closed);
        match self.target {
            Target::File(file) => {
                let file = file.into_inner().map_err(|error| unwritable(&path, error.error()))?;
                let mut unfinished = unfinished();
                unfinished.retain(|path| path != file.path());
                file.persist(&path).map(drop).map_err(|error| unwritable(&path, &error.error))
            }
            _ => Ok(()),
        }
        .map(|()| read)
    }

    /// Keeps the temporary file as `FILE.part`.
    pub fn keep_part(self) -> Result<Option<String>, CliError> {
        let mut part = self.path.clone().into_os_string();
        part.push(".part");
        let part = PathBuf::from(part);
        if !matches!(self.target, Target::File(_)) {
            self.finish()?;
            return Ok(None);
        }
        let name = part.display().to_string();
        Self { path: part, ..self }.finish()?;
        Ok(Some(name))
    }
}

fn unwritable(path: &Path, error: &io::Error) -> CliError {
    let why = error.to_string();
    match path.to_str() {
        Some("-") => CliError::Unprinted { why },
        _ => CliError::Unwritable { name: path.display().to_string(), why },
    }
}

/// Those of the file that is replaced; else those of any new file.
#[cfg(unix)]
fn permissions(builder: &mut Builder<'_, '_>, path: &Path) {
    use std::os::unix::fs::PermissionsExt;
    let old = std::fs::metadata(path).map(|m| m.permissions());
    builder.permissions(old.unwrap_or_else(|_| std::fs::Permissions::from_mode(0o666)));
}

#[cfg(not(unix))]
fn permissions(_: &mut Builder<'_, '_>, _: &Path) {}
