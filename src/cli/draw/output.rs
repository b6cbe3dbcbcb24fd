//! Where pictures go: standard output, one file, one page with all, or files in a folder.

use super::one_only;
use super::pages::Page;
use crate::cli::batch::Sink;
use crate::cli::error::CliError;
use assur_drawing::escaped;
use std::cell::RefCell;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where pictures go.
pub enum Output {
    /// Standard output: one picture.
    Stdout,
    /// One file: one picture.
    File(PathBuf),
    /// One page with all pictures, until it is written.
    Page(PathBuf, RefCell<String>),
    /// Files in a folder.
    Folder(PathBuf),
}

impl Output {
    /// What `-o` names; a name that ends in `.svg`, `.png` or `.html` is a file, any other a folder.
    pub fn of(name: Option<&str>, one: bool, animation: bool) -> Result<Self, CliError> {
        match name {
            None | Some("-") if one => Ok(Self::Stdout),
            None | Some("-") => Err(one_only("standard output")),
            Some(name) if name.ends_with(".html") && one && animation => Ok(Self::File(PathBuf::from(name))),
            Some(name) if name.ends_with(".html") => {
                Ok(Self::Page(PathBuf::from(name), RefCell::new(String::new())))
            }
            #[cfg(not(feature = "png"))]
            Some(name) if name.ends_with(".png") => Err(CliError::NoPng { name: name.to_owned() }),
            Some(name) if (name.ends_with(".svg") || name.ends_with(".png")) && one => {
                Ok(Self::File(PathBuf::from(name)))
            }
            Some(name) if name.ends_with(".svg") || name.ends_with(".png") => Err(one_only(name)),
            Some(name) => Ok(Self::Folder(PathBuf::from(name))),
        }
    }

    /// Whether it is one picture, in which an animation needs no script.
    pub fn is_picture(&self) -> bool {
        matches!(self, Self::File(path) if ending(path) == "svg")
    }

    /// Whether nothing moves in it: a page of all pictures, or pixels.
    pub fn is_still(&self) -> bool {
        matches!(self, Self::Page(..)) || matches!(self, Self::File(path) if ending(path) == "png")
    }

    /// Whether it holds one picture.
    pub const fn is_single(&self) -> bool {
        matches!(self, Self::Stdout | Self::File(..))
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
                #[cfg(feature = "png")]
                [page] if ending(path) == "png" => {
                    let pixels = super::png::png(&page.text, &path.display().to_string())?;
                    written(path, &pixels, inputs).map(|()| String::new())
                }
                [page] => written(path, page.text.as_bytes(), inputs).map(|()| String::new()),
                _ => Err(one_only(&path.display().to_string())),
            },
            Self::Page(_, body) => {
                let mut body = body.borrow_mut();
                for page in pages {
                    let title = escaped(&page.title);
                    let _ =
                        write!(body, "<figure>\n<figcaption>{title}</figcaption>\n{}</figure>\n", page.text);
                }
                Ok(String::new())
            }
            Self::Folder(folder) => {
                std::fs::create_dir_all(folder).map_err(|error| CliError::NotCreated {
                    name: folder.display().to_string(),
                    why: error.to_string(),
                })?;
                for page in pages {
                    written(
                        &folder.join(format!("{}.{}", page.name, page.ending)),
                        page.text.as_bytes(),
                        inputs,
                    )?;
                }
                Ok(String::new())
            }
        }
    }
}

impl Output {
    /// Writes the page, where there is one with pictures.
    pub fn finish(&self, inputs: &[String]) -> Result<(), CliError> {
        let Self::Page(path, body) = self else { return Ok(()) };
        let body = body.borrow();
        if body.is_empty() { Ok(()) } else { written(path, format!("{HEAD}{body}{FOOT}").as_bytes(), inputs) }
    }
}

/// Begin and end of a page: figures that shrink to the screen, with their own colours.
const HEAD: &str = "<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
<title>Pictures</title>
<style>
body{margin:1rem;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;background:#fff;color:#111}
figure{margin:0 0 2rem;break-inside:avoid}figcaption{margin-bottom:.5rem}
figure svg{max-width:100%;height:auto}
@media (prefers-color-scheme:dark){body{background:#16181c;color:#ececec}}
@media print{body{background:#fff;color:#000}}
</style>
</head>
<body>
";
const FOOT: &str = "</body>\n</html>\n";

/// The ending of the name of a file.
fn ending(path: &Path) -> &str {
    path.extension().and_then(|ending| ending.to_str()).unwrap_or_default()
}

/// Writes a file, which appears only when complete.
fn written(path: &Path, text: &[u8], inputs: &[String]) -> Result<(), CliError> {
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
