//! The answers of a file as a stream of Arrow: a column per number in the author's unit, which is in the field's metadata, null
//! where a position has none; positions one after another, none is kept.

use super::answers::{Answers, pose_header};
use super::row_numbers::{NumberField, NumberRows};
use super::rows::AnswerColumns;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, StringArray};
use arrow_ipc::writer::StreamWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use assur_solve::solve::{Model, Pose};
use std::collections::HashMap;
use std::sync::Arc;

/// Positions of a record batch.
const BATCH: usize = 4096;

/// Writes positions.
pub struct ArrowRows {
    rows: NumberRows,
    schema: SchemaRef,
    names: Vec<String>,
    /// By column; NaN for null, 1 and 0 for conditions.
    cells: Vec<Vec<f64>>,
    row: Vec<f64>,
    writer: StreamWriter<Vec<u8>>,
}

impl ArrowRows {
    /// For the answers of a file.
    ///
    /// # Errors
    /// The schema cannot be written.
    pub fn of(model: &Model<'_>) -> Result<Self, ArrowError> {
        let columns = AnswerColumns::of_file(model);
        let field = |field: NumberField| {
            let kind = if field.condition { DataType::Boolean } else { DataType::Float64 };
            let unit = Some(field.display.unit).filter(|unit| !unit.is_empty());
            let unit = unit.map(|unit| ("unit".to_owned(), unit));
            Field::new(field.name, kind, true).with_metadata(unit.into_iter().collect::<HashMap<_, _>>())
        };
        let numbers = columns.fields(model.mechanism).into_iter().map(field);
        let pose = Field::new(pose_header(model.mechanism), DataType::Utf8, false);
        let schema = Arc::new(Schema::new(std::iter::once(pose).chain(numbers).collect::<Vec<_>>()));
        let writer = StreamWriter::try_new(Vec::new(), &schema)?;
        let cells = vec![Vec::new(); schema.fields().len() - 1];
        let (rows, names, row) = (NumberRows::of(columns), Vec::new(), Vec::new());
        Ok(Self { rows, schema, names, cells, row, writer })
    }

    /// Whether a column shows the angle of a link or of a hinge.
    #[must_use]
    pub fn reads_angles(&self, model: &Model<'_>) -> bool {
        self.rows.reads_angles(model)
    }

    /// Adds a position.
    ///
    /// # Errors
    /// A batch cannot be written.
    pub fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> Result<(), ArrowError> {
        self.rows.begin(answers);
        self.rows.read(answers, pose, &mut self.row);
        self.names.push(pose.name.clone());
        self.cells.iter_mut().zip(&self.row).for_each(|(cells, x)| cells.push(*x));
        if self.names.len() == BATCH { self.write() } else { Ok(()) }
    }

    /// What was written since.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(self.writer.get_mut())
    }

    /// Writes what is left, and the end.
    ///
    /// # Errors
    /// The last batch cannot be written.
    pub fn end(&mut self) -> Result<(), ArrowError> {
        if !self.names.is_empty() {
            self.write()?;
        }
        self.writer.finish()
    }

    fn write(&mut self) -> Result<(), ArrowError> {
        let names = StringArray::from_iter_values(self.names.drain(..));
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(names)];
        for (cells, field) in self.cells.iter_mut().zip(self.schema.fields().iter().skip(1)) {
            let cells = cells.drain(..).map(|x| Some(x).filter(|x| x.is_finite()));
            arrays.push(match field.data_type() {
                DataType::Boolean => Arc::new(cells.map(|x| x.map(|x| x != 0.0)).collect::<BooleanArray>()),
                _ => Arc::new(cells.collect::<Float64Array>()),
            });
        }
        self.writer.write(&RecordBatch::try_new(Arc::clone(&self.schema), arrays)?)
    }
}
