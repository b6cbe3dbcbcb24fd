//! From names on the command line to texts.

use std::io::Read;
use std::path::{Path, PathBuf};

use globset::GlobBuilder;
use ignore::WalkBuilder;

use super::error::CliError;
use crate::source::Source;

/// Standard input's name.
const STDIN: &str = "-";

/// A text to be read.
#[derive(Clone, Debug, PartialEq, Eq)]
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

/// The texts that names mean, each once: files as they are, `.mech` files below folders, matches of globs.
#[must_use]
pub fn expand(names: &[String]) -> Vec<Result<Input, CliError>> {
    let mut inputs: Vec<Result<Input, CliError>> = Vec::new();
    for name in names {
        match inputs_of(name) {
            Ok(found) => {
                for input in found {
                    if !inputs.iter().any(|i| i.as_ref().ok() == Some(&input)) {
                        inputs.push(Ok(input));
                    }
                }
            }
            Err(error) => inputs.push(Err(error)),
        }
    }
    inputs
}

fn inputs_of(name: &str) -> Result<Vec<Input>, CliError> {
    let path = Path::new(name);
    if name == STDIN {
        return Ok(vec![Input::Stdin]);
    }
    if path.is_dir() {
        let files = walk(path, |file| file.extension().is_some_and(|e| e == "mech"));
        let none = || CliError::NoMechFiles { name: name.to_owned() };
        return if files.is_empty() { Err(none()) } else { Ok(files) };
    }
    if path.exists() {
        return Ok(vec![Input::File(path.to_owned())]);
    }
    if name.contains(['*', '?', '[', '{']) {
        matches_of(name)
    } else {
        Err(CliError::Missing { name: name.to_owned() })
    }
}

/// Files that match a glob; `*` stops at `/`, `**` does not.
fn matches_of(pattern: &str) -> Result<Vec<Input>, CliError> {
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

/// Files below a folder in the order of their names.
fn walk(folder: &Path, wanted: impl Fn(&Path) -> bool) -> Vec<Input> {
    let mut files: Vec<PathBuf> = WalkBuilder::new(folder)
        .build()
        .filter_map(Result::ok)
        .filter(|entry| entry.file_type().is_some_and(|t| t.is_file()))
        .map(|entry| entry.path().strip_prefix("./").unwrap_or(entry.path()).to_owned())
        .filter(|path| wanted(path))
        .collect();
    files.sort();
    files.into_iter().map(Input::File).collect()
}
