//! Errors of a separate table.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// An error of a table in a file of comma-separated values; places are those in its line.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum TableError {
    /// A header that is no name with a unit.
    #[error("this header cannot be read: {why}")]
    #[diagnostic(code("mech::table::header"))]
    Header {
        why: String,
        #[help]
        help: String,
        #[label("a name with its unit is expected here")]
        span: Span,
    },
    /// Nothing below the header, or no header.
    #[error("the table has {what}")]
    #[diagnostic(
        code("mech::table::empty"),
        help(
            "write names with units in the first line, as in `r [mm], n [rpm]`, and rows of numbers below it"
        )
    )]
    Empty {
        /// `no header`, `no rows`
        what: &'static str,
        #[label("no rows below this")]
        span: Option<Span>,
    },
    /// A cell that is no number.
    #[error("line {line}, column {column} (`{name}`): {why}")]
    #[diagnostic(code("mech::table::number"))]
    Number {
        /// Line in the file.
        line: usize,
        /// Column of the table, from 1.
        column: usize,
        name: String,
        why: String,
        #[help]
        help: Option<String>,
        #[label("not a number")]
        span: Span,
    },
    /// A cell without a number.
    #[error("line {line}, column {column}: the value of `{name}` is missing")]
    #[diagnostic(code("mech::table::missing_cell"), help("write one number per column in every row"))]
    Missing {
        /// Line in the file.
        line: usize,
        /// Column of the table, from 1.
        column: usize,
        name: String,
        #[label("missing here")]
        span: Span,
    },
    /// A row of columns without a number.
    #[error("the value of `{name}` is {what}")]
    #[diagnostic(code("mech::table::missing_cell"), help("give every row a number in every column"))]
    Absent {
        name: String,
        /// `missing`, `infinite`
        what: &'static str,
    },
    /// More cells than columns.
    #[error("line {line} has {found} cells, but the table has {columns}")]
    #[diagnostic(code("mech::table::too_many_cells"))]
    TooMany {
        /// Line in the file.
        line: usize,
        found: usize,
        /// `2 columns`
        columns: String,
        #[help]
        help: String,
        /// The cells too many.
        #[label("no column for this")]
        span: Span,
    },
    /// A line that cannot be divided into cells.
    #[error("line {line} cannot be read: {why}")]
    #[diagnostic(code("mech::table::line"))]
    Line {
        /// Line in the file.
        line: usize,
        why: String,
        #[help]
        help: &'static str,
        #[label("here")]
        span: Span,
    },
    /// A column of answers that the key does not have.
    #[error("the key has no `{name}`")]
    #[diagnostic(code("mech::table::unknown_column"))]
    UnknownColumn {
        name: String,
        #[help]
        help: String,
        #[label("not in the key")]
        span: Span,
    },
    /// A unit that does not fit.
    #[error("{why}")]
    #[diagnostic(code("mech::table::unit"))]
    Unit {
        why: String,
        #[help]
        help: Option<String>,
        #[label("does not fit")]
        span: Span,
    },
    /// Two columns of one name.
    #[error("`{name}` appears twice in the header")]
    #[diagnostic(code("mech::table::column_twice"), help("leave one of the columns out"))]
    Twice {
        name: String,
        #[label("first here")]
        first: Span,
        #[label(primary, "again here")]
        again: Span,
    },
    /// A row of answers that is not one of the key.
    #[error("line {line}: {why}")]
    #[diagnostic(code("mech::table::unknown_row"))]
    UnknownRow {
        /// Line in the file.
        line: usize,
        why: String,
        #[help]
        help: String,
        #[label("this row")]
        span: Span,
    },
}

impl assur_text::diagnostic::Problem for TableError {}
