//! Arguments of `report`.

use super::setting;
use assur_check::Overrides;
use assur_worked::{Language, Part};
use clap::ValueEnum;
use std::path::Path;

/// Arguments of `report`.
#[derive(Clone, Debug, clap::Args)]
pub struct Report {
    /// Files to work out
    #[arg(required = true, value_name = "FILES")]
    pub files: Vec<String>,
    /// Write the solution to this file (.html, .md, .typ, .txt; created only when complete), pictures of .md and .typ next to
    /// it, or one file per problem into this folder [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    pub out: Option<String>,
    /// Format [default: that of the ending of OUT, else text]
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Option<ReportFormat>,
    /// Work out the pose of this name [default: the first]
    #[arg(long, value_name = "NAME")]
    pub pose: Option<String>,
    /// With --sheet or --key: ask at the positions of these names alone, e.g. `--positions 1,4,8` [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', conflicts_with = "pose")]
    pub positions: Vec<String>,
    /// Write these parts alone, e.g. `--steps 1,3,6`: 0 problem, 1 structure, 2 positions, 3 velocities, 4 accelerations,
    /// 5 loads and inertia forces, 6 reactions and balance, 7 check, 8 results [default: all]
    #[arg(long, value_name = "PARTS", value_delimiter = ',', value_parser = part)]
    pub steps: Vec<Part>,
    /// Write an exercise sheet instead: statement, scheme, given values, variants, what to find, cells for answers; no answer.
    /// Of several files one page, if OUT is an .html
    #[arg(long, conflicts_with_all = ["key", "steps"])]
    pub sheet: bool,
    /// Write the key of the sheet instead: the answers of every row of variants, with four digits
    #[arg(long, conflicts_with = "steps")]
    pub key: bool,
    /// Write one sheet per row of variants, each with its own scheme: OUT with the number and the name of the row before its
    /// ending
    #[arg(long, requires_all = ["sheet", "out"])]
    pub per_row: bool,
    /// Language of the sentences, with the letters of its courses
    #[arg(long = "lang", value_enum, value_name = "LANGUAGE", default_value_t = LanguageArg::En)]
    pub language: LanguageArg,
    /// Replace the value of a `given`, e.g. `--set r=120mm`; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// The output has a name that the program made up
    #[arg(skip)]
    pub made_up: bool,
}

/// A format of a worked solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    /// One page with formulas and pictures, without scripts or requests
    Html,
    /// Markdown with formulas in LaTeX
    Markdown,
    /// Typst, for a printed document
    Typst,
    /// Plain text, without pictures
    Text,
}

/// A language of worked solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LanguageArg {
    /// English
    En,
    /// Chinese
    Zh,
    /// Russian, with a decimal comma
    Ru,
}

impl From<LanguageArg> for Language {
    fn from(language: LanguageArg) -> Self {
        match language {
            LanguageArg::En => Self::English,
            LanguageArg::Zh => Self::Chinese,
            LanguageArg::Ru => Self::Russian,
        }
    }
}

impl ReportFormat {
    /// The ending of its files.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Html => "html",
            Self::Markdown => "md",
            Self::Typst => "typ",
            Self::Text => "txt",
        }
    }

    fn of_ending(name: &str) -> Option<Self> {
        Some(match name.rsplit_once('.')?.1 {
            "html" | "htm" => Self::Html,
            "md" => Self::Markdown,
            "typ" => Self::Typst,
            "txt" => Self::Text,
            _ => return None,
        })
    }
}

impl Report {
    /// The format; none where the ending of the output says nothing.
    #[must_use]
    pub fn format(&self) -> Option<ReportFormat> {
        match (self.format, self.out.as_deref()) {
            (Some(format), _) => Some(format),
            (None, None | Some("-")) => Some(ReportFormat::Text),
            (None, Some(name)) if is_folder(name) => Some(ReportFormat::Html),
            (None, Some(name)) => ReportFormat::of_ending(name),
        }
    }

    /// The folder that the output names; none where it names a file.
    #[must_use]
    pub fn folder(&self) -> Option<&Path> {
        self.out.as_deref().filter(|name| *name != "-" && is_folder(name)).map(Path::new)
    }

    /// Values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
    }
}

/// Whether a name is that of a folder: it is one, or it has no ending.
fn is_folder(name: &str) -> bool {
    let path = Path::new(name);
    path.is_dir() || path.extension().is_none() || name.ends_with('/')
}

pub(super) fn part(text: &str) -> Result<Part, String> {
    text.trim()
        .parse()
        .ok()
        .and_then(Part::numbered)
        .ok_or_else(|| "write numbers from 0 to 8, e.g. 1,3,6".to_owned())
}
