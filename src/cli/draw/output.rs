//! Where pictures go: standard output, one file, or files in a folder.

use super::{Page, one_only};
use crate::cli::batch::Sink;
use crate::cli::error::CliError;
use std::path::{Path, PathBuf};

/// Where pictures go.
pub enum Output {
    /// Standard output: one picture.
    Stdout,
    /// One file: one picture.
    File(PathBuf),
    /// Files in a folder.
    Folder(PathBuf),
}

impl Output {
    /// What `-o` names; a name that ends in `.svg` is a file, any other a folder.
    pub fn of(name: Option<&str>, one: bool) -> Result<Self, CliError> {
        match name {
            None | Some("-") if one => Ok(Self::Stdout),
            None | Some("-") => Err(one_only("standard output")),
            Some(name) if name.ends_with(".svg") && one => Ok(Self::File(PathBuf::from(name))),
            Some(name) if name.ends_with(".svg") => Err(one_only(name)),
            Some(name) => Ok(Self::Folder(PathBuf::from(name))),
        }
    }

    /// Writes pictures; what goes to standard output is given back.
    pub fn write(&self, pages: &[Page], inputs: &[String]) -> Result<String, CliError> {
        match self {
            _ if pages.is_empty() => Ok(String::new()),
            Self::Stdout => match pages {
                [page] => Ok(page.text.clone()),
                _ => Err(one_only("standard output")),
            },
            Self::File(path) => match pages {
                [page] => written(path, &page.text, inputs).map(|()| String::new()),
                _ => Err(one_only(&path.display().to_string())),
            },
            Self::Folder(folder) => {
                std::fs::create_dir_all(folder).map_err(|error| CliError::NotCreated {
                    name: folder.display().to_string(),
                    why: error.to_string(),
                })?;
                for page in pages {
                    written(&folder.join(format!("{}.svg", page.name)), &page.text, inputs)?;
                }
                Ok(String::new())
            }
        }
    }
}

/// Writes a file, which appears only when complete.
fn written(path: &Path, text: &str, inputs: &[String]) -> Result<(), CliError> {
    if inputs.iter().any(|input| Path::new(input) == path) {
        return Err(CliError::Overwrites { name: path.display().to_string() });
    }
    let mut sink = Sink::file(path)?;
    sink.write(text)?;
    sink.finish().map(|_| ())
}

/// A name without signs that file systems refuse.
pub fn file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_control() || "/\\:*?\"<>| ".contains(c) { '-' } else { c }).collect()
}
