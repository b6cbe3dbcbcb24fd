//! The manual of `fmt`.

use std::ops::RangeInclusive;

/// Arguments of `fmt`.
#[derive(Clone, Debug, clap::Args)]
pub struct Fmt {
    /// Files, folders, globs, or `-` for standard input, which is printed formatted
    #[arg(required = true, value_name = "FILES")]
    pub files: Vec<String>,
    /// Change no file: print what would change as a diff, and exit with 1 if there is anything
    #[arg(long)]
    pub check: bool,
    /// Name of the text on standard input in diagnostics and diffs
    #[arg(long, value_name = "NAME")]
    pub stdin_filename: Option<String>,
    /// Change these lines of the file only, e.g. 10:20
    #[arg(long, value_name = "FIRST:LAST", value_parser = lines)]
    pub range: Option<RangeInclusive<usize>>,
}

/// Lines from 1, the last included.
fn lines(text: &str) -> Result<RangeInclusive<usize>, String> {
    let number = |part: &str| part.trim().parse::<usize>().ok().filter(|n| *n > 0);
    let range = text.split_once(':').and_then(|(first, last)| Some(number(first)?..=number(last)?));
    range.filter(|lines| !lines.is_empty()).ok_or_else(|| "write two lines, e.g. 10:20".to_owned())
}
