//! The forms of output: the same in every command.

use crate::report::Page;
use crate::report::text::Look;
use clap::ValueEnum;
use clap::builder::PossibleValue;

/// A form of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables to read, in the author's units
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
}

impl Format {
    /// The form of a report.
    pub(in crate::cli) const fn page(self, look: Look) -> Page {
        match self {
            Self::Table => Page::Text(look),
            Self::Json | Self::Jsonl => Page::Json,
            Self::Csv => Page::Csv,
            Self::Markdown => Page::Markdown,
            Self::Latex => Page::Latex,
        }
    }

    /// Whether it is read by people.
    pub(in crate::cli) const fn is_read(self) -> bool {
        matches!(self, Self::Table | Self::Markdown | Self::Latex)
    }

    /// What separates two files.
    pub(in crate::cli) const fn apart(self) -> &'static str {
        match self {
            Self::Json | Self::Jsonl => "",
            Self::Csv => "\r\n",
            Self::Table | Self::Markdown | Self::Latex => "\n",
        }
    }

    /// The form of a file with this ending.
    pub(super) fn of_ending(ending: &str) -> Option<Self> {
        match ending {
            "csv" => Some(Self::Csv),
            "json" | "jsonl" | "ndjson" => Some(Self::Jsonl),
            "md" => Some(Self::Markdown),
            "tex" => Some(Self::Latex),
            _ => None,
        }
    }
}

/// A form of a profile: a drawing too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfileFormat {
    /// As in every command.
    Common(Format),
    /// A drawing.
    Dxf,
}

impl ValueEnum for ProfileFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::Common(Format::Csv),
            Self::Dxf,
            Self::Common(Format::Table),
            Self::Common(Format::Json),
            Self::Common(Format::Jsonl),
            Self::Common(Format::Markdown),
            Self::Common(Format::Latex),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Common(format) => format.to_possible_value(),
            Self::Dxf => Some(
                PossibleValue::new("dxf")
                    .help("A drawing: DXF R12 in millimetres, layers PROFILE, PITCH, BASE, CENTRE"),
            ),
        }
    }
}

/// A form of the answers to rows: files of columns too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BatchFormat {
    /// As in every command.
    Common(Format),
    /// Columns.
    #[cfg(feature = "arrow")]
    Columns(assur_arrow::Kind),
}

impl Default for BatchFormat {
    fn default() -> Self {
        Self::Common(Format::Table)
    }
}

impl BatchFormat {
    /// The common form; columns are filled line by line as those of comma-separated values.
    pub(in crate::cli) const fn common(self) -> Format {
        match self {
            Self::Common(format) => format,
            #[cfg(feature = "arrow")]
            Self::Columns(_) => Format::Csv,
        }
    }

    /// The form of a file with this ending.
    pub(super) fn of_ending(ending: &str) -> Option<Self> {
        match ending {
            #[cfg(feature = "arrow")]
            "arrow" | "feather" => Some(Self::Columns(assur_arrow::Kind::File)),
            #[cfg(feature = "arrow")]
            "arrows" => Some(Self::Columns(assur_arrow::Kind::Stream)),
            #[cfg(feature = "parquet")]
            "parquet" => Some(Self::Columns(assur_arrow::Kind::Parquet)),
            _ => Format::of_ending(ending).map(Self::Common),
        }
    }
}

impl ValueEnum for BatchFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::Common(Format::Table),
            Self::Common(Format::Json),
            Self::Common(Format::Jsonl),
            Self::Common(Format::Csv),
            Self::Common(Format::Markdown),
            Self::Common(Format::Latex),
            #[cfg(feature = "arrow")]
            Self::Columns(assur_arrow::Kind::Stream),
            #[cfg(feature = "arrow")]
            Self::Columns(assur_arrow::Kind::File),
            #[cfg(feature = "parquet")]
            Self::Columns(assur_arrow::Kind::Parquet),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Common(format) => format.to_possible_value(),
            #[cfg(feature = "arrow")]
            Self::Columns(kind) => Some(match kind {
                assur_arrow::Kind::Stream => PossibleValue::new("arrow").help(STREAM),
                assur_arrow::Kind::File => PossibleValue::new("feather")
                    .help("The same as a file of Arrow IPC, with the places of its batches"),
                #[cfg(feature = "parquet")]
                assur_arrow::Kind::Parquet => {
                    PossibleValue::new("parquet").help("The same as a file of Parquet, compressed by Snappy")
                }
            }),
        }
    }
}

#[cfg(feature = "arrow")]
const STREAM: &str = "A stream of Arrow IPC: columns with their units as metadata";

/// A form of answers: a stream of columns too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolveFormat {
    /// As in every command.
    Common(Format),
    /// A stream of Arrow.
    #[cfg(feature = "arrow")]
    Arrow,
}

impl SolveFormat {
    /// The common form; a stream of Arrow goes position by position as lines of JSON do.
    pub(in crate::cli) const fn common(self) -> Format {
        match self {
            Self::Common(format) => format,
            #[cfg(feature = "arrow")]
            Self::Arrow => Format::Jsonl,
        }
    }
}

impl ValueEnum for SolveFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self::Common(Format::Table),
            Self::Common(Format::Json),
            Self::Common(Format::Jsonl),
            Self::Common(Format::Csv),
            Self::Common(Format::Markdown),
            Self::Common(Format::Latex),
            #[cfg(feature = "arrow")]
            Self::Arrow,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Common(format) => format.to_possible_value(),
            #[cfg(feature = "arrow")]
            Self::Arrow => Some(PossibleValue::new("arrow").help(STREAM)),
        }
    }
}
