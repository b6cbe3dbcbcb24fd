//! The forms of output: one list for all commands, and those that each of them writes.

use crate::report::Page;
use crate::report::text::Look;
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};

/// A form of output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables to read, in the author's units
    #[default]
    Table,
    /// Objects, one per file and line; of `batch` one per row
    Json,
    /// Objects, one per pose and line; where there are no poses as `json`
    Jsonl,
    /// Comma-separated values: a line per pose, row or answer
    Csv,
    /// Tables to paste into a document
    Markdown,
    /// Tables for a LaTeX document
    Latex,
    /// Tables for a Typst document
    Typst,
    /// A drawing: DXF R12 in millimetres, layers PROFILE, PITCH, BASE, CENTRE
    Dxf,
    /// A stream of Arrow IPC: columns with their units as metadata
    #[cfg(feature = "arrow")]
    Arrow,
    /// The same as a file of Arrow IPC, with the places of its batches
    #[cfg(feature = "arrow")]
    Feather,
    /// The same as a file of Parquet, compressed by Snappy
    #[cfg(feature = "parquet")]
    Parquet,
}

/// What every command with tables writes.
pub const TABLES: &[Format] = &[
    Format::Table,
    Format::Json,
    Format::Jsonl,
    Format::Csv,
    Format::Markdown,
    Format::Latex,
    Format::Typst,
];
/// What `solve` writes as well as tables.
pub const STREAMS: &[Format] = &[
    #[cfg(feature = "arrow")]
    Format::Arrow,
];
/// What `batch` writes as well as tables.
pub const COLUMNS: &[Format] = &[
    #[cfg(feature = "arrow")]
    Format::Arrow,
    #[cfg(feature = "arrow")]
    Format::Feather,
    #[cfg(feature = "parquet")]
    Format::Parquet,
];
/// What `profile` writes as well as tables.
pub const DRAWINGS: &[Format] = &[Format::Dxf];

/// Reads one of the tables, or one of these.
pub(super) fn table_or(others: &[Format]) -> impl TypedValueParser<Value = Format> + use<> {
    let values = TABLES.iter().chain(others).filter_map(ValueEnum::to_possible_value);
    PossibleValuesParser::new(values).try_map(|name| Format::from_str(&name, false))
}

impl Format {
    /// The form of a report. What is not a page has no reports.
    pub(in crate::cli) const fn page(self, look: Look) -> Page {
        match self {
            Self::Table => Page::Text(look),
            Self::Json | Self::Jsonl => Page::Json,
            Self::Markdown => Page::Markdown,
            Self::Latex => Page::Latex,
            Self::Typst => Page::Typst,
            _ => Page::Csv,
        }
    }

    /// Whether it is read by people.
    pub(in crate::cli) const fn is_read(self) -> bool {
        matches!(self, Self::Table | Self::Markdown | Self::Latex | Self::Typst)
    }

    /// What separates two files.
    pub(in crate::cli) const fn apart(self) -> &'static str {
        match self {
            Self::Csv => "\r\n",
            _ if self.is_read() => "\n",
            _ => "",
        }
    }

    /// Columns of Arrow, which are filled as the lines of another form are.
    pub(in crate::cli) fn is_columns(self) -> bool {
        COLUMNS.contains(&self)
    }

    /// The form of a file with this ending; columns of Arrow too.
    pub(super) fn of_ending(ending: &str) -> Option<Self> {
        Some(match ending {
            "csv" => Self::Csv,
            "json" | "jsonl" | "ndjson" => Self::Jsonl,
            "md" => Self::Markdown,
            "tex" => Self::Latex,
            "typ" => Self::Typst,
            #[cfg(feature = "arrow")]
            "arrow" | "feather" => Self::Feather,
            #[cfg(feature = "arrow")]
            "arrows" => Self::Arrow,
            #[cfg(feature = "parquet")]
            "parquet" => Self::Parquet,
            _ => return None,
        })
    }
}
