//! From names on the command line to texts.

use std::collections::{BTreeSet, HashSet};
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use globset::GlobBuilder;
use ignore::WalkBuilder;

use super::error::CliError;
use super::sink::{Sink, unfinished};
use assur_text::source::Source;

const STDIN: &str = "-";
/// A longer text is not read, bytes.
const LONGEST: u64 = 100_000_000;

/// What tells a file from all others, whatever name it has: device and number.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = PathBuf;

/// The files that are read: no output takes their place.
static INPUTS: Mutex<BTreeSet<Identity>> = Mutex::new(BTreeSet::new());

/// Keeps a file from being replaced by an output.
pub fn keep(path: &Path) {
    let mut inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
    inputs.extend(identity(path));
}

/// Whether a file, by this name or any other, is one of those that are read.
pub fn is_input(path: &Path) -> bool {
    let inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
    identity(path).is_some_and(|found| inputs.contains(&found))
}

#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    let found = std::fs::metadata(path).ok().filter(std::fs::Metadata::is_file)?;
    Some((found.dev(), found.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    std::fs::canonicalize(path).ok().filter(|path| path.is_file())
}

/// Makes a folder for outputs, unless it is there.
///
/// # Errors
/// It is a file, or cannot be made.
pub fn made_folder(folder: &Path) -> Result<(), CliError> {
    let name = || folder.display().to_string();
    if folder.is_file() {
        let error = if is_input(folder) {
            CliError::Overwrites { name: name() }
        } else {
            CliError::NotAFolder { name: name() }
        };
        return Err(error);
    }
    std::fs::create_dir_all(folder).map_err(|e| CliError::NotCreated { name: name(), why: e.to_string() })
}

/// A text to be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    Stdin,
    File(PathBuf),
    /// One that a folder or a glob has.
    Within(PathBuf),
}

impl Input {
    /// Its place, unless it is standard input.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Stdin => None,
            Self::File(path) | Self::Within(path) => Some(path),
        }
    }

    /// Reads it.
    ///
    /// # Errors
    /// What cannot be read, is too long, or is no UTF-8.
    pub fn read(self) -> Result<Source, CliError> {
        match self {
            Self::Stdin => text(STDIN.to_owned(), Ok(io::stdin().lock())),
            Self::File(path) => text(path.display().to_string(), File::open(&path)),
            Self::Within(path) => {
                text(path.display().to_string(), opened(&path)).map_err(CliError::in_folder)
            }
        }
    }
}

/// A file that was found; of a pipe nobody knows whether it ends.
fn opened(path: &Path) -> io::Result<File> {
    if std::fs::metadata(path)?.is_file() {
        File::open(path)
    } else {
        Err(io::Error::other("it is not a file"))
    }
}

/// The text of a file.
fn text(name: String, from: io::Result<impl Read>) -> Result<Source, CliError> {
    let bytes = from.and_then(bounded);
    let bytes = bytes.map_err(|e| CliError::Unreadable { name: name.clone(), why: e.to_string() })?;
    let Some(bytes) = bytes else { return Err(CliError::TooLong { name, most: LONGEST / 1_000_000 }) };
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(error) => Err(CliError::NotUtf8 { name, at: error.utf8_error().valid_up_to() + 1 }),
    }
}

/// All bytes, unless there are too many: a device may have no end.
fn bounded(from: impl Read) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    let read = from.take(LONGEST + 1).read_to_end(&mut bytes)?;
    Ok((read as u64 <= LONGEST).then_some(bytes))
}

/// A table of any length: a device or a pipe, which may have no end, is read as far as a text.
pub type TableReader = BufReader<Box<dyn Read + Send>>;

/// Opens a table.
///
/// # Errors
/// It is not there, or cannot be read.
pub fn table(name: &str, buffer: usize) -> Result<TableReader, CliError> {
    let file = File::open(name).and_then(|file| Ok((file.metadata()?.is_file(), file)));
    let (ends, file) = file.map_err(|error| unread_table(name, &error))?;
    let reader: Box<dyn Read + Send> =
        if ends { Box::new(file) } else { Box::new(Endless(file.take(LONGEST))) };
    Ok(BufReader::with_capacity(buffer, reader))
}

/// A table that cannot be read.
pub fn unread_table(name: &str, error: &io::Error) -> CliError {
    match error.kind() {
        io::ErrorKind::NotFound => missing(name),
        io::ErrorKind::FileTooLarge => CliError::TooLong { name: name.to_owned(), most: LONGEST / 1_000_000 },
        _ => CliError::Unreadable { name: name.to_owned(), why: error.to_string() },
    }
}

/// What may have no end: an error where a text would be too long.
struct Endless(io::Take<File>);

impl Read for Endless {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.0.limit() == 0 { Err(io::ErrorKind::FileTooLarge.into()) } else { self.0.read(into) }
    }
}

/// Files, and folders that cannot be read.
type Found = Vec<Result<Input, CliError>>;

/// The texts that names mean, each once: files as they are, `.mech` files below folders, matches of globs. No output takes their place.
#[must_use]
pub fn expand(names: &[String]) -> Vec<Result<Input, CliError>> {
    let mut inputs = Vec::new();
    let mut seen = HashSet::new();
    for name in names {
        match inputs_of(name) {
            Ok(found) => {
                for input in found {
                    if let Some(path) = input.as_ref().ok().and_then(Input::path) {
                        keep(path);
                    }
                    if input.as_ref().ok().is_none_or(|input| seen.insert(input.path().map(Path::to_owned))) {
                        inputs.push(input);
                    }
                }
            }
            Err(error) => inputs.push(Err(error)),
        }
    }
    inputs
}

/// A name that nothing has: of a file without its ending, the file is offered.
pub fn missing(name: &str) -> CliError {
    let with_ending = format!("{name}.mech");
    let help = Path::new(&with_ending).is_file().then(|| format!("did you mean `{with_ending}`?"));
    CliError::Missing { name: name.to_owned(), help }
}

fn inputs_of(name: &str) -> Result<Found, CliError> {
    let path = Path::new(name);
    if name == STDIN {
        return Ok(vec![Ok(Input::Stdin)]);
    }
    if path.is_dir() {
        let files = walk(path, |file| file.extension().is_some_and(|e| e == "mech"));
        let none = || CliError::NoMechFiles { name: name.to_owned() };
        return if files.is_empty() { Err(none()) } else { Ok(files) };
    }
    if path.exists() {
        return Ok(vec![Ok(Input::File(path.to_owned()))]);
    }
    if name.contains(['*', '?', '[', '{']) { matches_of(name) } else { Err(missing(name)) }
}

/// Files that match a glob; `*` stops at `/`, `**` does not.
fn matches_of(pattern: &str) -> Result<Found, CliError> {
    let plain = pattern.strip_prefix("./").unwrap_or(pattern);
    let glob = GlobBuilder::new(plain).literal_separator(true).build();
    let glob =
        glob.map_err(|e| CliError::BadPattern { pattern: pattern.to_owned(), why: e.kind().to_string() })?;
    let matcher = glob.compile_matcher();
    let files = walk(&literal_part(plain), |file| matcher.is_match(file));
    if files.is_empty() { Err(CliError::NoMatch { pattern: pattern.to_owned() }) } else { Ok(files) }
}

/// The folder in front of the first sign that means something in a glob.
fn literal_part(pattern: &str) -> PathBuf {
    let parts = pattern.split_inclusive('/').take_while(|p| !p.contains(['*', '?', '[', '{', '\\']));
    let folder: String = parts.collect();
    PathBuf::from(if folder.is_empty() { "." } else { folder.as_str() })
}

/// Files below a folder in the order of their names, after the folders that cannot be read.
fn walk(folder: &Path, wanted: impl Fn(&Path) -> bool) -> Found {
    let mut files: Vec<PathBuf> = Vec::new();
    let mut found = Found::new();
    for entry in WalkBuilder::new(folder).build() {
        match entry {
            Ok(entry) => {
                // what is no file, or a link to nothing, is named when it is read
                let path = entry.path().strip_prefix("./").unwrap_or(entry.path());
                if wanted(path) && !entry.path().is_dir() {
                    files.push(path.to_owned());
                }
            }
            Err(error) => found.push(Err(unreadable(folder, &error))),
        }
    }
    files.sort();
    found.extend(files.into_iter().map(Input::Within).map(Ok));
    found
}

fn unreadable(folder: &Path, error: &ignore::Error) -> CliError {
    let mut place = folder;
    let mut inner = error;
    loop {
        inner = match inner {
            ignore::Error::WithPath { path, err } => {
                place = path;
                err
            }
            ignore::Error::WithDepth { err, .. } | ignore::Error::WithLineNumber { err, .. } => err,
            _ => break,
        };
    }
    let error = CliError::Unreadable { name: place.display().to_string(), why: inner.to_string() };
    if place == folder { error } else { error.in_folder() }
}

/// Puts a text in the place of a file, at once and whole; a file with several names keeps them.
///
/// # Errors
/// A file that cannot be written; it is as it was.
pub fn replace(name: &str, text: &str) -> Result<(), CliError> {
    let found = std::fs::metadata(name);
    if found.as_ref().is_ok_and(|file| file.permissions().readonly()) {
        return Err(CliError::Unwritable { name: name.to_owned(), why: "it is read-only".to_owned() });
    }
    if found.is_ok_and(|file| has_other_names(&file)) {
        let written = in_place(Path::new(name), text.as_bytes());
        return written.map_err(|e| CliError::Unwritable { name: name.to_owned(), why: e.to_string() });
    }
    let mut file = Sink::edited(Path::new(name))?;
    file.write(text)?;
    file.finish().map(drop)
}

/// Whether hard links lead to it.
#[cfg(unix)]
fn has_other_names(file: &std::fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(file) > 1
}

#[cfg(not(unix))]
fn has_other_names(_: &std::fs::Metadata) -> bool {
    false
}

/// Writes over a file; what was in it comes back where that fails.
fn in_place(path: &Path, text: &[u8]) -> io::Result<()> {
    let _whole = unfinished();
    let before = std::fs::read(path)?;
    let file = File::options().write(true).open(path)?;
    let write = |bytes: &[u8]| -> io::Result<()> {
        io::Seek::rewind(&mut &file)?;
        io::Write::write_all(&mut &file, bytes)?;
        file.set_len(bytes.len() as u64)?;
        file.sync_all()
    };
    write(text).inspect_err(|_| {
        // the error is reported in any case
        let _ = write(&before);
    })
}
