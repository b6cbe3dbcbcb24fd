//! Rows of a batch in memory.

use std::sync::Arc;

use crate::exercise::table::{Cell, Fault, Lines, RawRow, Read, Separator};
use assur_check::{FileRow, Row, RowColumn};
use assur_text::source::Span;

/// The source of rows.
#[derive(Debug)]
pub enum Rows {
    /// The file as written.
    One,
    /// Its own table.
    Own(Vec<FileRow>),
    /// A separate table.
    Csv(String),
}

/// Rows in memory.
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
}

/// A row to solve.
pub struct Input<'a> {
    /// Counted from 1.
    pub number: usize,
    /// Its name in the column `variant`.
    pub label: Option<String>,
    /// Its numbers as written in a separate table.
    pub written: Option<Vec<Cell<'a>>>,
    /// Its numbers.
    pub row: Row,
    /// Its place in the file's own table.
    pub span: Option<Span>,
}

impl Chunk<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::One => 1,
            Self::Own { rows, .. } => rows.len(),
            Self::Csv { lines, .. } => lines.len(),
        }
    }

    /// The row of this index, in the memory of another one, or what is wrong with it.
    pub fn get<'c>(
        &'c self,
        index: usize,
        columns: &Arc<[RowColumn]>,
        old: Option<Input<'c>>,
    ) -> Result<Input<'c>, (usize, Fault)> {
        match self {
            Self::One => Ok(Input { number: 1, label: None, written: None, row: Row::default(), span: None }),
            Self::Own { rows, before } => {
                let FileRow { row, label, span } = rows[index].clone();
                let number = before + index + 1;
                Ok(Input { number, label, written: None, row, span: Some(span) })
            }
            Self::Csv { lines, table, separator } => {
                let raw = lines.get(index).unwrap_or(RawRow { number: 0, line: 0, bytes: &[] });
                let mut read = old.map_or_else(Read::default, |old| Read {
                    row: old.row,
                    label: None,
                    cells: old.written.unwrap_or_default(),
                });
                raw.read_in(table, columns, *separator, &mut read).map_err(|fault| (raw.number, fault))?;
                let Read { row, label, cells } = read;
                Ok(Input { number: raw.number, label, written: Some(cells), row, span: None })
            }
        }
    }
}
