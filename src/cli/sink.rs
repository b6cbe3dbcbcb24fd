//! The destination of results: standard output, or a file that is created only when complete.

use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, TempPath};

use super::error::CliError;
use super::files::is_input;
use super::stop::listen;

const BUFFER: usize = 1 << 18;

/// Files that are not yet in their place.
type Unfinished = MutexGuard<'static, Vec<PathBuf>>;

static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// While it is held no signal ends the program; from the first time on a signal leaves no temporary file.
pub fn unfinished() -> Unfinished {
    listen();
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes what is not yet in its place, before the program ends. While it is held nothing new is begun.
pub fn remove_unfinished() -> Unfinished {
    let mut unfinished = unfinished();
    for path in unfinished.drain(..) {
        // it may be in its place by now
        let _ = std::fs::remove_file(path);
    }
    unfinished
}

enum Target {
    Stdout(BufWriter<io::Stdout>),
    /// A pipe or a device: there is nothing to put in its place.
    Special(BufWriter<File>),
    /// Written to a temporary file in the same folder, and renamed at the end.
    File(BufWriter<File>, TempPath),
}

/// The destination of results.
pub struct Sink {
    target: Target,
    name: PathBuf,
    /// Where it is in the end.
    path: PathBuf,
    closed: bool,
}

impl Sink {
    pub fn stdout() -> Self {
        let target = Target::Stdout(BufWriter::with_capacity(BUFFER, io::stdout()));
        Self { target, name: PathBuf::from("-"), path: PathBuf::new(), closed: false }
    }

    /// A file, which is created by [`Sink::finish`] only.
    ///
    /// # Errors
    /// It is an input, or cannot be written.
    pub fn file(path: &Path) -> Result<Self, CliError> {
        Self::unread(path, place(path), BUFFER)
    }

    /// The same for a text that is written as a whole.
    ///
    /// # Errors
    /// It is an input, or cannot be written.
    pub fn page(path: &Path) -> Result<Self, CliError> {
        Self::unread(path, place(path), 0)
    }

    /// The same under a name that the program makes up: a link or a device of that name is replaced.
    ///
    /// # Errors
    /// It is an input, or cannot be written.
    pub fn made_up(path: &Path) -> Result<Self, CliError> {
        let is_file = std::fs::symlink_metadata(path).is_ok_and(|found| found.is_file());
        let path = path.to_owned();
        if is_file { Self::unread(&path.clone(), path, 0) } else { Self::replacing(&path.clone(), path, 0) }
    }

    /// A file that is read and written again.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn edited(path: &Path) -> Result<Self, CliError> {
        Self::buffered(path, place(path), BUFFER)
    }

    fn unread(name: &Path, path: PathBuf, buffer: usize) -> Result<Self, CliError> {
        if is_input(&path) {
            return Err(CliError::Overwrites { name: name.display().to_string() });
        }
        Self::buffered(name, path, buffer)
    }

    fn buffered(name: &Path, path: PathBuf, buffer: usize) -> Result<Self, CliError> {
        if path.exists() && !path.is_file() && !path.is_dir() {
            let file = File::options().write(true).open(&path).map_err(|error| unwritable(name, &error))?;
            let target = Target::Special(BufWriter::with_capacity(buffer, file));
            return Ok(Self { target, name: name.to_owned(), path, closed: false });
        }
        Self::replacing(name, path, buffer)
    }

    fn replacing(name: &Path, path: PathBuf, buffer: usize) -> Result<Self, CliError> {
        let fail = |error: io::Error| unwritable(name, &error);
        if path.is_dir() {
            return Err(fail(io::Error::from(ErrorKind::IsADirectory)));
        }
        let folder = folder(&path);
        if !folder.is_dir() {
            return Err(CliError::NoFolder { name: folder.display().to_string() });
        }
        let mut builder = Builder::new();
        builder.prefix(".assur-").suffix(".tmp");
        as_new(&mut builder);
        let mut unfinished = unfinished();
        let (file, temporary) = builder.tempfile_in(folder).map_err(fail)?.into_parts();
        if let Some(old) = std::fs::symlink_metadata(&path).ok().filter(std::fs::Metadata::is_file) {
            as_before(&file, &old).map_err(fail)?;
        }
        unfinished.push(temporary.to_path_buf());
        let target = Target::File(BufWriter::with_capacity(buffer, file), temporary);
        Ok(Self { target, name: name.to_owned(), path, closed: false })
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
            Target::File(file, _) => file.write_all(bytes),
        };
        self.checked(written)
    }

    /// Whether nobody reads any more.
    pub const fn closed(&self) -> bool {
        self.closed
    }

    fn checked(&mut self, done: io::Result<()>) -> Result<(), CliError> {
        match done {
            Err(error)
                if matches!(self.target, Target::Stdout(_)) && error.kind() == ErrorKind::BrokenPipe =>
            {
                self.closed = true;
                Ok(())
            }
            done => done.map_err(|error| unwritable(&self.name, &error)),
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
            Target::File(file, _) if lasts => file.flush().and_then(|()| file.get_ref().sync_all()),
            Target::File(file, _) => file.flush(),
        };
        self.checked(flushed)?;
        let read = !self.closed;
        if let Target::File(file, temporary) = self.target {
            drop(file);
            let mut unfinished = unfinished();
            unfinished.retain(|path| *path != *temporary);
            temporary.persist(&self.path).map_err(|error| unwritable(&self.name, &error.error))?;
        }
        Ok(read)
    }

    /// Puts what was written in its place if all inputs could be read. Else what is there stays, and this is kept as `FILE.part`.
    pub fn finish_of(self, all: bool) -> Result<bool, CliError> {
        if all {
            return self.finish();
        }
        self.keep_part()?.map_or(Ok(true), |kept| Err(CliError::NotAll { kept }))
    }

    /// Keeps the temporary file as `FILE.part`.
    pub fn keep_part(self) -> Result<Option<String>, CliError> {
        let part = |path: &Path| {
            let mut part = path.as_os_str().to_owned();
            part.push(".part");
            PathBuf::from(part)
        };
        if !matches!(self.target, Target::File(..)) {
            self.finish()?;
            return Ok(None);
        }
        let (name, path) = (part(&self.name), part(&self.path));
        Self { path, ..self }.finish()?;
        Ok(Some(name.display().to_string()))
    }
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The file that a name means: what a link leads to.
pub fn place(path: &Path) -> PathBuf {
    let inside = |folder: &Path| Some(std::fs::canonicalize(folder).ok()?.join(path.file_name()?));
    let real = std::fs::canonicalize(path).ok();
    real.or_else(|| inside(folder(path))).unwrap_or_else(|| path.to_owned())
}

fn unwritable(path: &Path, error: &io::Error) -> CliError {
    let why = error.to_string();
    let name = path.display().to_string();
    match path.to_str() {
        Some("-") => CliError::Unprinted { why },
        _ if path.exists() => CliError::Unwritable { name, why },
        _ => CliError::NotCreated { name, why },
    }
}

/// The permissions of any new file.
#[cfg(unix)]
fn as_new(builder: &mut Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(std::fs::Permissions::from_mode(0o666));
}

/// The permissions of the file that is replaced, and its owner where the system lets it be given away.
#[cfg(unix)]
fn as_before(file: &File, old: &std::fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let new = file.metadata()?;
    if (new.uid(), new.gid()) != (old.uid(), old.gid()) {
        // a file of somebody else becomes one of who writes it
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

#[cfg(not(unix))]
fn as_new(_: &mut Builder<'_, '_>) {}

#[cfg(not(unix))]
fn as_before(file: &File, old: &std::fs::Metadata) -> io::Result<()> {
    file.set_permissions(old.permissions())
}
