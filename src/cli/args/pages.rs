//! The manual of commands with few options.

use super::format::{COLUMNS, Format, table_or};
use super::{Problem, accuracy, threads};
use clap::ValueEnum;
use clap::builder::NonEmptyStringValueParser;
use std::ops::RangeInclusive;

/// Arguments of `explain`.
#[derive(Clone, Debug, clap::Args)]
pub struct Explain {
    /// Code of a diagnostic, e.g. `mech::assembly::ambiguous`; `mech::` may be left out
    #[arg(required_unless_present = "all", value_name = "CODE")]
    pub code: Option<String>,
    /// List all codes
    #[arg(long, conflicts_with = "code")]
    pub all: bool,
}

/// Arguments of `new`.
#[derive(Clone, Debug, clap::Args)]
pub struct New {
    /// Name of the file; the ending `.mech` may be left out
    #[arg(value_name = "NAME", value_parser = NonEmptyStringValueParser::new())]
    pub name: String,
    /// The mechanism in it
    #[arg(long, value_enum, default_value_t = StartKind::FourBar)]
    pub kind: StartKind,
}

/// The mechanisms to start from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StartKind {
    /// A four-bar linkage with masses and a load
    FourBar,
    /// A crank-slider with masses and a gas force
    CrankSlider,
    /// A four-bar that moves a ram
    SixBar,
    /// Gears, a drum and a rope
    Train,
    /// A cam, its follower and a spring
    Cam,
}

/// Arguments of `help`.
#[derive(Clone, Debug, clap::Args)]
pub struct Help {
    /// `functions`, `units`, `statements`, or a command
    #[arg(value_name = "TOPIC")]
    pub topic: Option<String>,
}

/// Arguments of `info`.
#[derive(Clone, Debug, clap::Args)]
pub struct Info {
    /// Output format
    #[arg(long, value_enum, default_value_t = InfoFormat::Text)]
    pub format: InfoFormat,
}

/// A form of what a build can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum InfoFormat {
    /// Lines to read
    Text,
    /// One object
    Json,
}

/// Arguments of `card`.
#[derive(Clone, Debug, clap::Args)]
pub struct Card {
    /// Output format
    #[arg(long, value_enum, default_value_t = CardFormat::Markdown)]
    pub format: CardFormat,
    /// Print `llms.txt`: what a language model reads first
    #[arg(long, conflicts_with = "format")]
    pub llms: bool,
}

/// A form of the card.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CardFormat {
    /// A page to read
    Markdown,
    /// Statements, functions and files as one object
    Json,
}

/// Arguments of `mcp`.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Mcp {}

/// Arguments of `completions`.
#[derive(Clone, Debug, clap::Args)]
pub struct Completions {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

/// Arguments of `man`.
#[derive(Clone, Debug, clap::Args)]
pub struct Man {
    /// A command; the whole program where it is left out
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

/// Arguments of `preview`.
#[derive(Clone, Debug, clap::Args)]
pub struct Preview {
    /// The file to show
    #[arg(value_name = "FILE")]
    pub file: String,
    /// Port of the page on this machine [default: one that is free]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub port: Option<u16>,
    /// Print the address and open no browser
    #[arg(long)]
    pub no_open: bool,
}

/// Arguments of `lsp`: none.
#[cfg(feature = "lsp")]
#[derive(Clone, Debug, clap::Args)]
pub struct Lsp {}

// The manual of `fmt`.

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

// The manual of `batch`.

/// Arguments of `batch`.
#[derive(Clone, Debug, clap::Args)]
pub struct Batch {
    /// Files to solve
    #[command(flatten)]
    pub problem: Problem,
    /// Table of variants that replaces those of the files: names with units in the header, plain numbers below. Comma-separated
    /// values; by its ending also .arrow, .arrows, .feather or .parquet, where this build reads them
    #[arg(long, value_name = "TABLE.csv")]
    pub variants: Option<String>,
    /// Output format [default: by the ending of --out, else table]
    #[arg(long, value_name = "FORMAT", value_parser = table_or(COLUMNS))]
    pub format: Option<Format>,
    /// Write the answers to this file (created only when complete)
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,
    /// Write the answer key for `assur grade` to this file, as comma-separated values
    #[arg(long, value_name = "KEY.csv")]
    pub key: Option<String>,
    /// Maximum relative error of every row, e.g. 1e-6; the fastest sufficient settings are used
    #[arg(long, value_name = "ERROR", value_parser = accuracy)]
    pub within: Option<f64>,
    /// Number of threads [default: all processors]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
}

impl Batch {
    /// The kinds of tables of variants that this build reads.
    pub fn tables() -> impl Iterator<Item = &'static str> {
        let all = [("csv", true), ("arrow", cfg!(feature = "arrow")), ("parquet", cfg!(feature = "parquet"))];
        all.into_iter().filter_map(|(kind, has)| has.then_some(kind))
    }

    /// The format of the option, else of the file name.
    #[must_use]
    pub fn format(&self) -> Format {
        let of_name = self.out.as_deref().and_then(ending).and_then(Format::of_ending);
        self.format.or(of_name).unwrap_or_default()
    }
}

/// The ending of a file's name.
pub(in crate::cli) fn ending(name: &str) -> Option<&str> {
    name.rsplit_once('.').map(|(_, ending)| ending)
}
