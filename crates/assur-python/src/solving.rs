//! Rows of a reader, solved batch by batch.

use crate::import::Reader;
use crate::workers::Crew;
use arrow_array::{RecordBatch, RecordBatchReader};
use arrow_schema::{ArrowError, Schema, SchemaRef};
use assur::{Cells, RowAnswers, RowField, RowLayout, Rows, WrittenUnit};
use assur_arrow::{Column, Head, Lines, Texts, columns};
use pyo3::prelude::*;
use std::iter::Fuse;
use std::sync::Arc;

/// Rows that are solved at a time, at the most.
const ROWS: usize = 1 << 16;
/// Rows that are gathered before they are solved, from batches that have fewer: what rows have in common is looked for once for
/// all that are solved at a time.
const GATHERED: usize = 1 << 13;

/// What the answers look like.
#[derive(Clone, Copy)]
pub struct Form {
    /// An answer key.
    pub key: bool,
    /// With the number of each row.
    pub numbered: bool,
    /// How many threads solve them: one for every processor without a number.
    pub threads: Option<usize>,
}

impl From<(bool, bool, Option<usize>)> for Form {
    fn from((key, numbered, threads): (bool, bool, Option<usize>)) -> Self {
        Self { key, numbered, threads }
    }
}

/// Why it cannot begin.
pub enum StartError {
    /// The text is wrong whatever the row.
    Diagnostics(assur::Diagnostics),
    /// The rows cannot be read.
    Arrow(ArrowError),
}

/// Rows that are being solved.
pub struct Solving {
    rows: Rows,
    fields: Vec<RowField>,
    reader: Fuse<Reader>,
    /// What was read and is not taken yet.
    waiting: Option<Result<RecordBatch, ArrowError>>,
    /// The first rows, until they are solved.
    first: Option<Given>,
    layout: Option<RowLayout>,
    head: Head,
    schema: SchemaRef,
    /// How many rows were solved.
    before: usize,
    form: Form,
}

/// Rows that are solved at a time.
struct Given {
    columns: Vec<Column>,
    count: usize,
}

impl Given {
    fn append(&mut self, more: Self) {
        self.columns.iter_mut().zip(more.columns).for_each(|(column, more)| column.append(more));
        self.count += more.count;
    }
}

impl Iterator for Solving {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        let crew = self.crew();
        let next = self.next_batch(&crew);
        if crew.error().is_some() {
            // the reader cannot raise an exception of Python: the signal is handled when it returns
            Python::try_attach(|py| py.import("_thread")?.call_method0("interrupt_main").map(drop));
        }
        next
    }
}

impl RecordBatchReader for Solving {
    fn schema(&self) -> SchemaRef {
        Arc::clone(&self.schema)
    }
}

impl Solving {
    /// The rows of a reader whose columns fit the problem.
    pub fn of(rows: Rows, reader: Reader, form: Form) -> Self {
        let fields = rows.fields();
        let (head, schema) = (Head::default(), Arc::new(Schema::empty()));
        let reader = reader.fuse();
        Self { rows, fields, reader, waiting: None, first: None, layout: None, head, schema, before: 0, form }
    }

    /// Reads the first rows and finds the columns of the answers.
    pub fn begin(&mut self) -> Result<(), StartError> {
        self.first = self.read().transpose().map_err(StartError::Arrow)?;
        let columns = self.first.as_ref().map_or(&[][..], |first| &first.columns);
        let cells: Vec<Cells<'_>> = columns.iter().map(cells).collect();
        let count = self.first.as_ref().map_or(0, |first| first.count);
        let layout = self.rows.layout(&cells, count, self.form.key).map_err(StartError::Diagnostics)?;
        self.head = self.head(&layout);
        self.schema = self.head.schema();
        self.layout = Some(layout);
        Ok(())
    }

    fn head(&self, layout: &RowLayout) -> Head {
        let Form { key, numbered, .. } = self.form;
        let label = self.fields.iter().find(|field| field.is_label).map(|label| label.name.clone());
        let givens = self.fields.iter().filter(|field| field.is_given && !key);
        let answer =
            |(name, unit, condition): &(String, _, bool)| (name.clone(), unit_text(unit), *condition);
        Head {
            numbered,
            label,
            givens: givens.map(|given| (given.name.clone(), given.unit.clone())).collect(),
            pose: layout.pose_header.clone(),
            events: layout.names_events,
            answers: layout.fields.iter().map(answer).collect(),
            errors: !key,
        }
    }

    /// The next rows, no more than are solved at a time, and no less than are gathered unless these are all.
    fn read(&mut self) -> Option<Result<Given, ArrowError>> {
        let mut given: Option<Given> = None;
        while given.as_ref().map_or(0, |given| given.count) < GATHERED {
            let Some(next) = self.waiting.take().or_else(|| self.reader.next()) else { break };
            let room = ROWS - given.as_ref().map_or(0, |given| given.count);
            let read = next.and_then(|batch| {
                let count = batch.num_rows().min(room);
                let columns = self.columns(&batch.slice(0, count))?;
                let left = batch.num_rows() - count;
                self.waiting = (left > 0).then(|| Ok(batch.slice(count, left)));
                Ok(Given { columns, count })
            });
            match (read, &mut given) {
                (Ok(read), None) => given = Some(read),
                (Ok(read), Some(given)) => given.append(read),
                (Err(error), None) => return Some(Err(error)),
                // it comes after the rows before it
                (Err(error), Some(_)) => {
                    self.waiting = Some(Err(error));
                    break;
                }
            }
        }
        given.map(Ok)
    }

    /// Who solves them.
    pub fn crew(&self) -> Crew {
        Crew::of(self.form.threads)
    }

    /// The answers to the next rows.
    pub fn next_batch(&mut self, crew: &Crew) -> Option<Result<RecordBatch, ArrowError>> {
        let given = match self.first.take().map(Ok).or_else(|| self.read())? {
            Ok(given) => given,
            Err(error) => return Some(Err(error)),
        };
        let layout = self.layout.take()?;
        let answered = self.answered(&layout, &given, crew);
        self.layout = Some(layout);
        self.before += given.count;
        Some(answered)
    }

    fn answered(
        &self,
        layout: &RowLayout,
        Given { columns, count }: &Given,
        crew: &Crew,
    ) -> Result<RecordBatch, ArrowError> {
        let cells: Vec<Cells<'_>> = columns.iter().map(cells).collect();
        let answers = self.rows.solve(layout, &cells, *count, crew);
        let Some(answers) = answers else {
            return Err(ArrowError::ExternalError("interrupted".into()));
        };
        let RowAnswers { rows, poses, errors, events, values } = answers;
        let number = |row: &usize| i64::try_from(self.before + row + 1).unwrap_or(i64::MAX);
        let (text, ends) = poses.into_parts();
        let poses = Texts::of(text, ends);
        let mut lines = Lines { poses, events, answers: values, errors, ..Lines::default() };
        if self.form.numbered {
            lines.rows = rows.iter().map(number).collect();
        }
        for (column, field) in columns.iter().zip(&self.fields) {
            match column {
                Column::Names(names) => lines.labels = rows.iter().map(|row| names[*row].clone()).collect(),
                Column::Numbers(numbers) if field.is_given && !self.form.key => {
                    lines.givens.push(rows.iter().map(|row| numbers[*row]).collect());
                }
                Column::Numbers(_) => {}
            }
        }
        self.head.batch(&self.schema, lines)
    }

    /// The columns of rows.
    fn columns(&self, batch: &RecordBatch) -> Result<Vec<Column>, ArrowError> {
        let fields = self.fields.iter().map(|field| (field.name.as_str(), field.is_label));
        columns(fields, batch).map_err(ArrowError::CastError)
    }
}

/// As the library takes them.
fn cells(column: &Column) -> Cells<'_> {
    match column {
        Column::Numbers(numbers) => Cells::Numbers(numbers),
        Column::Names(names) => Cells::Names(names),
    }
}

fn unit_text(unit: &WrittenUnit) -> String {
    unit.text().to_owned()
}
