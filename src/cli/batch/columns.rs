//! Tables of columns: rows of variants from files of Arrow and Parquet, and answers to such files.

use super::super::error::CliError;
use super::filled::Filled;
use super::job::{Job, Work};
use super::rows::Chunk;
use crate::exercise::table::{self as text, Fault, TableError};
use crate::front::{Cells, RowAnswers, WrittenUnit, header_line};
use assur_arrow::{ArrowError, Column, Field, Head, Kind, Lines, Reader, RecordBatch, SchemaRef, Writer};
use assur_check::{ColumnUse, RowColumn};
use assur_syntax::document::Document;
use assur_text::source::{Source, Span};
use std::fs::File;
use std::io::Cursor;

/// The header of a table as text.
pub type Header = text::Table<Cursor<Vec<u8>>>;

/// Opens a table of columns.
pub fn open(name: &str) -> Result<Reader, CliError> {
    let file = File::open(name).map_err(|error| crate::cli::files::unread_table(name, &error))?;
    assur_arrow::open(file).map_err(|error| unreadable(name, &error))
}

fn unreadable(name: &str, error: &ArrowError) -> CliError {
    CliError::Unreadable { name: name.to_owned(), why: error.to_string() }
}

/// The header that the table would have as text, read.
pub fn header(document: &Document, name: &str, reader: &Reader) -> Result<Header, Fault> {
    let column = |field: &Field| (field.name().clone(), field.metadata().get("unit").cloned());
    let columns: Vec<_> = reader.schema().fields().iter().map(|field| column(field)).collect();
    let line = header_line(document, &columns);
    let text = Cursor::new(line.into_bytes());
    // a text in memory is always read
    let unread = |_| (Source::new(name, ""), Box::new(TableError::Empty { what: "no header", span: None }));
    text::Table::open(name, text).map_err(unread)?
}

/// The names of columns, and whether each names rows.
fn wanted(columns: &[RowColumn]) -> impl Iterator<Item = (&str, bool)> {
    columns.iter().map(|column| (column.name.as_str(), column.what == ColumnUse::Label))
}

/// What is wrong with the kinds of columns.
pub fn wrong_kind(header: &Source, reader: &Reader, columns: &[RowColumn]) -> Option<Fault> {
    let none = RecordBatch::new_empty(reader.schema());
    let why = assur_arrow::columns(wanted(columns), &none).err()?;
    let help = "write the columns of numbers as float64, and `variant` as texts".to_owned();
    let span = Span::new(0, header.text.len());
    Some((header.clone(), Box::new(TableError::Header { why, help, span })))
}

/// Calls `work` on the rows of a table, chunk by chunk, until that says it is enough.
pub fn each_chunk(
    name: &str,
    columns: &[RowColumn],
    mut size: impl FnMut(usize) -> usize,
    work: &mut Work<'_>,
) -> Result<(), CliError> {
    let mut before = 0;
    for batch in open(name)? {
        let batch = batch.map_err(|error| unreadable(name, &error))?;
        let mut at = 0;
        while at < batch.num_rows() {
            let count = size(before).min(batch.num_rows() - at);
            let read = assur_arrow::columns(wanted(columns), &batch.slice(at, count));
            let read = read.map_err(|why| CliError::Unreadable { name: name.to_owned(), why })?;
            let cells: Vec<Cells<'_>> = read.iter().map(cells).collect();
            if !work(&Chunk::Columns { cells: &cells, count, before, table: name }, None)? {
                return Ok(());
            }
            (at, before) = (at + count, before + count);
        }
    }
    Ok(())
}

fn cells(column: &Column) -> Cells<'_> {
    match column {
        Column::Numbers(numbers) => Cells::Numbers(numbers),
        Column::Names(names) => Cells::Names(names),
    }
}

/// Writes answers as columns.
pub struct Table {
    head: Head,
    schema: SchemaRef,
    writer: Writer,
    name: String,
}

impl Table {
    /// Of a file with its rows, to the place of this name.
    pub fn of(job: &Job, kind: Kind, name: &str) -> Result<Self, CliError> {
        let layout = job.layout();
        let answer = |(name, unit, condition): &(String, WrittenUnit, bool)| {
            (name.clone(), unit.text().to_owned(), *condition)
        };
        let head = Head {
            numbered: true,
            label: job.label().map(|i| job.columns[i].name.clone()),
            givens: job.givens().map(|(_, column)| (column.name.clone(), column.unit.text.clone())).collect(),
            pose: layout.pose_header.clone(),
            events: layout.names_events,
            answers: layout.fields.iter().map(answer).collect(),
            errors: true,
        };
        let schema = head.schema();
        let writer = Writer::of(kind, &schema).map_err(|error| unwritable(name, &error))?;
        Ok(Self { head, schema, writer, name: name.to_owned() })
    }

    pub fn written(&mut self, filled: Filled<'_>) -> Result<Vec<u8>, CliError> {
        let Filled { answers, labels, givens, .. } = filled;
        let RowAnswers { rows, poses, events, values, errors } = answers;
        let rows = rows.into_iter().map(|row| i64::try_from(row + 1).unwrap_or(i64::MAX)).collect();
        let (text, ends) = poses.into_parts();
        let poses = assur_arrow::Texts::of(text, ends);
        let lines = Lines { rows, labels, givens, poses, events, answers: values, errors };
        let batch = self.head.batch(&self.schema, lines);
        batch.and_then(|batch| self.writer.write(&batch)).map_err(|error| unwritable(&self.name, &error))?;
        Ok(self.writer.take())
    }

    /// The bytes of the end.
    pub fn end(mut self) -> Result<Vec<u8>, CliError> {
        self.writer.end().map_err(|error| unwritable(&self.name, &error))?;
        Ok(self.writer.take())
    }
}

fn unwritable(name: &str, error: &ArrowError) -> CliError {
    CliError::Unwritable { name: name.to_owned(), why: error.to_string() }
}
