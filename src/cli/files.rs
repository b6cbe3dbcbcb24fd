//! From names on the command line to texts.

use std::collections::HashSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use globset::GlobBuilder;
use ignore::WalkBuilder;

use super::batch::Sink;
use super::error::CliError;
use assur_text::source::Source;

/// Standard input's name.
const STDIN: &str = "-";

/// A text to be read.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// Standard input.
    Stdin,
    /// A file.
    File(PathBuf),
}

impl Input {
    /// Reads it.
    ///
    /// # Errors
    /// What cannot be read, or is no UTF-8.
    pub fn read(self) -> Result<Source, CliError> {
        let (name, bytes) = match self {
            Self::Stdin => {
                let mut bytes = Vec::new();
                let read = std::io::stdin().lock().read_to_end(&mut bytes);
                (STDIN.to_owned(), read.map(|_| bytes))
            }
            Self::File(path) => (path.display().to_string(), std::fs::read(&path)),
        };
        let bytes = bytes.map_err(|e| CliError::Unreadable { name: name.clone(), why: e.to_string() })?;
        match String::from_utf8(bytes) {
            Ok(text) => Ok(Source::new(name, text)),
            Err(error) => Err(CliError::NotUtf8 { name, at: error.utf8_error().valid_up_to() + 1 }),
        }
    }
}

/// Files, and folders that cannot be read.
type Found = Vec<Result<Input, CliError>>;

/// The texts that names mean, each once: files as they are, `.mech` files below folders, matches of globs.
#[must_use]
pub fn expand(names: &[String]) -> Vec<Result<Input, CliError>> {
    let mut inputs = Vec::new();
    let mut seen = HashSet::new();
    for name in names {
        match inputs_of(name) {
            Ok(found) => {
                for input in found {
                    if input.as_ref().ok().is_none_or(|input| seen.insert(input.clone())) {
                        inputs.push(input);
                    }
                }
            }
            Err(error) => inputs.push(Err(error)),
        }
    }
    inputs
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
    if name.contains(['*', '?', '[', '{']) {
        matches_of(name)
    } else {
        Err(CliError::Missing { name: name.to_owned() })
    }
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
                let is_file = entry.file_type().is_some_and(|t| t.is_file());
                let path = entry.path().strip_prefix("./").unwrap_or(entry.path());
                if is_file && wanted(path) {
                    files.push(path.to_owned());
                }
            }
            Err(error) => found.push(Err(unreadable(folder, &error))),
        }
    }
    files.sort();
    found.extend(files.into_iter().map(Input::File).map(Ok));
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
    CliError::Unreadable { name: place.display().to_string(), why: inner.to_string() }
}

/// Puts a text in the place of a file, at once and whole.
///
/// # Errors
/// A file that cannot be written; it is as it was.
pub fn replace(name: &str, text: &str) -> Result<(), CliError> {
    let is_readonly = std::fs::metadata(name).is_ok_and(|file| file.permissions().readonly());
    if is_readonly {
        return Err(CliError::Unwritable { name: name.to_owned(), why: "it is read-only".to_owned() });
    }
    let mut file = Sink::file(Path::new(name))?;
    file.write(text)?;
    file.finish().map(drop)
}
