//! Rows of a reader, solved batch by batch.

use crate::cells::{array, field};
use crate::given::{Column, columns};
use crate::import::Reader;
use crate::workers::Crew;
use arrow_array::{ArrayRef, Int64Array, RecordBatch, RecordBatchReader, StringArray};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use assur::{Cells, RowAnswers, RowField, RowLayout, Rows};
use pyo3::prelude::*;
use std::collections::VecDeque;
use std::sync::Arc;

/// Rows that are solved at a time.
const ROWS: usize = 1 << 16;

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
pub enum Begin {
    /// The text is wrong whatever the row.
    Diagnostics(assur::Diagnostics),
    /// The rows cannot be read.
    Arrow(ArrowError),
}

/// Rows that are being solved.
pub struct Solving {
    rows: Rows,
    fields: Vec<RowField>,
    reader: Reader,
    /// Rows that were read and not solved yet.
    waiting: VecDeque<RecordBatch>,
    layout: Option<RowLayout>,
    schema: SchemaRef,
    /// How many rows were solved.
    before: usize,
    form: Form,
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
        let (waiting, schema) = (VecDeque::new(), Arc::new(Schema::empty()));
        Self { rows, fields, reader, waiting, layout: None, schema, before: 0, form }
    }

    /// Reads the first rows and finds the columns of the answers.
    pub fn begin(&mut self) -> Result<(), Begin> {
        let first = self.read().transpose().map_err(Begin::Arrow)?;
        let columns = first.as_ref().map(|batch| columns(&self.fields, batch)).transpose();
        let columns = columns.map_err(Begin::Arrow)?.unwrap_or_default();
        let cells: Vec<Cells<'_>> = columns.iter().map(Column::cells).collect();
        let count = first.as_ref().map_or(0, RecordBatch::num_rows);
        let layout = self.rows.layout(&cells, count, self.form.key).map_err(Begin::Diagnostics)?;
        self.schema = Arc::new(Schema::new(self.fields(&layout)));
        self.layout = Some(layout);
        self.waiting.extend(first);
        Ok(())
    }

    fn fields(&self, layout: &RowLayout) -> Vec<Field> {
        let Form { key, numbered, .. } = self.form;
        let mut fields = Vec::new();
        fields.extend(numbered.then(|| Field::new("row", DataType::Int64, false)));
        let label = self.fields.iter().find(|field| field.is_label);
        fields.extend(label.map(|label| Field::new(&label.name, DataType::Utf8, true)));
        let givens = self.fields.iter().filter(|field| field.is_given && !key);
        fields.extend(givens.map(|given| field(&given.name, &given.unit, false)));
        fields.push(Field::new(&layout.pose_header, DataType::Utf8, true));
        fields.extend(layout.names_events.then(|| Field::new("event", DataType::Utf8, true)));
        fields
            .extend(layout.fields.iter().map(|(name, unit, condition)| field(name, unit.text(), *condition)));
        fields.extend((!key).then(|| Field::new("error", DataType::Utf8, true)));
        fields
    }

    /// The next rows, no more than are solved at a time.
    fn read(&mut self) -> Option<Result<RecordBatch, ArrowError>> {
        let batch = match self.waiting.pop_front() {
            Some(batch) => batch,
            None => match self.reader.next()? {
                Ok(batch) => batch,
                Err(error) => return Some(Err(error)),
            },
        };
        let count = batch.num_rows();
        if count > ROWS {
            self.waiting.push_front(batch.slice(ROWS, count - ROWS));
        }
        Some(Ok(batch.slice(0, count.min(ROWS))))
    }

    /// Who solves them.
    pub fn crew(&self) -> Crew {
        Crew::of(self.form.threads)
    }

    /// The answers to the next rows.
    pub fn next_batch(&mut self, crew: &Crew) -> Option<Result<RecordBatch, ArrowError>> {
        let batch = match self.read()? {
            Ok(batch) => batch,
            Err(error) => return Some(Err(error)),
        };
        let layout = self.layout.take()?;
        let answered = self.answered(&layout, &batch, crew);
        self.layout = Some(layout);
        self.before += batch.num_rows();
        Some(answered)
    }

    fn answered(
        &self,
        layout: &RowLayout,
        batch: &RecordBatch,
        crew: &Crew,
    ) -> Result<RecordBatch, ArrowError> {
        let columns = columns(&self.fields, batch)?;
        let cells: Vec<Cells<'_>> = columns.iter().map(Column::cells).collect();
        let answers = self.rows.solve(layout, &cells, batch.num_rows(), crew);
        let Some(answers) = answers else {
            return Err(ArrowError::ExternalError("interrupted".into()));
        };
        let RowAnswers { rows, poses, errors, events, values } = answers;
        let mut arrays: Vec<ArrayRef> = Vec::new();
        if self.form.numbered {
            let number = |row: &usize| i64::try_from(self.before + row + 1).unwrap_or(i64::MAX);
            arrays.push(Arc::new(rows.iter().map(number).collect::<Int64Array>()));
        }
        for (column, field) in columns.iter().zip(&self.fields) {
            match column {
                Column::Names(names) => {
                    arrays.insert(
                        usize::from(self.form.numbered),
                        Arc::new(rows.iter().map(|row| names[*row].as_deref()).collect::<StringArray>()),
                    );
                }
                Column::Numbers(numbers) if field.is_given && !self.form.key => {
                    let cells: Vec<f64> = rows.iter().map(|row| numbers[*row]).collect();
                    arrays.push(array(&cells.into(), false));
                }
                Column::Numbers(_) => {}
            }
        }
        arrays.push(Arc::new(poses.iter().map(some_text).collect::<StringArray>()));
        if layout.names_events {
            arrays.push(Arc::new(events.iter().map(some_text).collect::<StringArray>()));
        }
        for (values, (_, _, condition)) in values.into_iter().zip(&layout.fields) {
            arrays.push(array(&values.into(), *condition));
        }
        if !self.form.key {
            let mut reasons = vec![None; rows.len()];
            for (line, reason) in &errors {
                reasons[*line] = Some(reason.as_str());
            }
            arrays.push(Arc::new(StringArray::from(reasons)));
        }
        RecordBatch::try_new(Arc::clone(&self.schema), arrays)
    }
}

#[allow(clippy::ptr_arg, reason = "called with the items of a list")]
fn some_text(text: &String) -> Option<&str> {
    Some(text.as_str()).filter(|text| !text.is_empty())
}
