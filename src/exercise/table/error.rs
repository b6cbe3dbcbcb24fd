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
        /// The mistake.
        why: String,
        /// The correction.
        #[help]
        help: String,
        /// The place.
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
        /// The place.
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
        /// Its header.
        name: String,
        /// The mistake.
        why: String,
        /// The correction.
        #[help]
        help: Option<String>,
        /// The cell.
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
        /// Its header.
        name: String,
        /// The place.
        #[label("missing here")]
        span: Span,
    },
    /// A row of columns without a number.
    #[error("the value of `{name}` is {what}")]
    #[diagnostic(code("mech::table::missing_cell"), help("give every row a number in every column"))]
    Absent {
        /// The column.
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
        /// Number of cells.
        found: usize,
        /// `2 columns`
        columns: String,
        /// Similar names.
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
        /// The mistake.
        why: String,
        /// The correction.
        #[help]
        help: &'static str,
        /// The place.
        #[label("here")]
        span: Span,
    },
    /// A column of answers that the key does not have.
    #[error("the key has no `{name}`")]
    #[diagnostic(code("mech::table::unknown_column"))]
    UnknownColumn {
        /// Its name.
        name: String,
        /// Similar names.
        #[help]
        help: String,
        /// The header.
        #[label("not in the key")]
        span: Span,
    },
    /// A unit that does not fit.
    #[error("{why}")]
    #[diagnostic(code("mech::table::unit"))]
    Unit {
        /// The mistake.
        why: String,
        /// The correction.
        #[help]
        help: Option<String>,
        /// The place.
        #[label("does not fit")]
        span: Span,
    },
    /// Two columns of one name.
    #[error("`{name}` appears twice in the header")]
    #[diagnostic(code("mech::table::column_twice"), help("leave one of the columns out"))]
    Twice {
        /// The name.
        name: String,
        /// The first.
        #[label("first here")]
        first: Span,
        /// The second.
        #[label(primary, "again here")]
        again: Span,
    },
    /// A row of answers that is not one of the key.
    #[error("line {line}: {why}")]
    #[diagnostic(code("mech::table::unknown_row"))]
    UnknownRow {
        /// Line in the file.
        line: usize,
        /// The mistake.
        why: String,
        /// The correction.
        #[help]
        help: String,
        /// The line.
        #[label("this row")]
        span: Span,
    },
}

impl assur_text::diagnostic::Problem for TableError {}
