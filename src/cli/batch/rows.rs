//! Rows of a batch in memory.

use std::sync::Arc;

use super::filled::Cited;
use crate::exercise::table::{Cell, Fault, Lines, PreciseNumber, RawRow, Read, Separator, TableError};
use crate::front::{Cells, Missing, read_row};
use assur_check::{FileRow, Row, RowColumn};
use assur_text::source::{Source, Span};

/// The source of rows.
#[derive(Debug)]
pub enum Rows {
    /// The file as written.
    One,
    Own(Vec<FileRow>),
    /// A separate table of text.
    Csv(String),
    /// A separate table of columns.
    #[cfg(feature = "arrow")]
    Columns(String),
}

pub enum Chunk<'a> {
    /// The file as written.
    One,
    /// Rows of its own table, after a number of them.
    Own {
        rows: &'a [FileRow],
        before: usize,
    },
    Csv {
        lines: Lines,
        table: &'a str,
        separator: Separator,
    },
    /// Rows of a table of columns, after a number of them.
    #[cfg_attr(not(feature = "arrow"), expect(dead_code, reason = "this build reads no such tables"))]
    Columns {
        cells: &'a [Cells<'a>],
        count: usize,
        before: usize,
        table: &'a str,
    },
}

/// The cells of a row as they are written in a separate table.
#[derive(Default)]
pub enum AsWritten<'a> {
    /// It is of no separate table, or cannot be read.
    #[default]
    No,
    /// Those of a line.
    Line(Vec<Cell<'a>>, Separator),
    /// Those of columns, with the index of the row.
    Columns(&'a [Cells<'a>], usize),
}

impl AsWritten<'_> {
    /// The text of a column, where it can stand between commas.
    pub fn text(&self, column: usize) -> Option<&str> {
        let Self::Line(cells, _) = self else { return None };
        let text = cells.get(column)?.text.as_ref();
        text.bytes().all(|b| b.is_ascii_graphic() && b != b',' && b != b'"').then_some(text)
    }

    /// The number in a column, in the unit of the table; NaN where it is missing.
    pub fn number(&self, column: usize) -> f64 {
        match self {
            Self::No => f64::NAN,
            Self::Line(cells, separator) => {
                let read =
                    cells.get(column).and_then(|cell| PreciseNumber::read(&cell.text, *separator).ok());
                read.map_or(f64::NAN, |written| written.value)
            }
            Self::Columns(cells, index) => match cells.get(column) {
                Some(Cells::Numbers(numbers)) => numbers.get(*index).copied().unwrap_or(f64::NAN),
                Some(Cells::Names(_)) | None => f64::NAN,
            },
        }
    }
}

/// A row to solve.
pub struct Input<'a> {
    /// Counted from 1.
    pub number: usize,
    /// Its name in the column `variant`.
    pub label: Option<String>,
    /// Its cells as they are written in a separate table.
    pub written: AsWritten<'a>,
    pub row: Row,
    /// Its place in the file's own table.
    pub span: Option<Span>,
}

impl Input<'_> {
    /// What lines repeat of it.
    pub fn cited(&self) -> Cited<'_> {
        let (label, row) = (self.label.as_deref(), Some(&self.row));
        Cited { number: self.number, label, written: &self.written, row }
    }
}

impl Chunk<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::One => 1,
            Self::Own { rows, .. } => rows.len(),
            Self::Csv { lines, .. } => lines.len(),
            Self::Columns { count, .. } => *count,
        }
    }

    /// The cells of a row that cannot be read.
    pub fn as_written(&self, index: usize) -> (Option<String>, AsWritten<'_>) {
        match self {
            Self::Columns { cells, .. } => (name_of(cells, index), AsWritten::Columns(cells, index)),
            _ => (None, AsWritten::No),
        }
    }

    /// The row of this index, in the memory of another one, or what is wrong with it.
    pub fn get<'c>(
        &'c self,
        index: usize,
        (columns, digits): (&Arc<[RowColumn]>, bool),
        old: Option<Input<'c>>,
    ) -> Result<Input<'c>, (usize, Fault)> {
        match self {
            Self::One => {
                Ok(Input { number: 1, label: None, written: AsWritten::No, row: Row::default(), span: None })
            }
            Self::Own { rows, before } => {
                let FileRow { row, label, span } = rows[index].clone();
                let number = before + index + 1;
                Ok(Input { number, label, written: AsWritten::No, row, span: Some(span) })
            }
            Self::Csv { lines, table, separator } => {
                let raw = lines.get(index).unwrap_or(RawRow { number: 0, line: 0, bytes: &[] });
                let mut read = old.map_or_else(Read::default, |old| Read {
                    row: old.row,
                    label: None,
                    cells: if let AsWritten::Line(cells, _) = old.written { cells } else { Vec::new() },
                });
                raw.read_in(table, columns, *separator, &mut read).map_err(|fault| (raw.number, fault))?;
                let Read { row, label, cells } = read;
                let written = AsWritten::Line(cells, *separator);
                Ok(Input { number: raw.number, label, written, row, span: None })
            }
            Self::Columns { cells, before, table, .. } => {
                let (number, mut row) = (before + index + 1, old.map(|old| old.row).unwrap_or_default());
                read_row(columns, cells, index, digits, &mut row).map_err(|missing| {
                    let Missing { name, what } = missing;
                    (number, (Source::new(*table, ""), Box::new(TableError::Absent { name, what })))
                })?;
                let label = name_of(cells, index);
                Ok(Input { number, label, written: AsWritten::Columns(cells, index), row, span: None })
            }
        }
    }
}

fn name_of(cells: &[Cells<'_>], index: usize) -> Option<String> {
    cells.iter().find_map(|cells| match cells {
        Cells::Names(names) => names.get(index).cloned().flatten(),
        Cells::Numbers(_) => None,
    })
}
