//! The answers of a file as a stream of Arrow: a column per number in the author's unit, which is in the field's metadata, null
//! where a position has none; positions one after another, none is kept.

use super::answers::{Answers, pose_header};
use super::row_numbers::{NumberField, NumberRows};
use super::rows::AnswerColumns;
use assur_arrow::{ArrowError, Head, Kind, Lines, SchemaRef, Writer};
use assur_solve::solve::{Model, Pose};

/// Positions of a record batch.
const BATCH: usize = 4096;

pub struct ArrowRows {
    rows: NumberRows,
    head: Head,
    schema: SchemaRef,
    lines: Lines,
    row: Vec<f64>,
    writer: Writer,
}

impl ArrowRows {
    /// For the answers of a file.
    ///
    /// # Errors
    /// The schema cannot be written.
    pub fn of(model: &Model<'_>) -> Result<Self, ArrowError> {
        let columns = AnswerColumns::of_file(model);
        let answer = |field: NumberField| (field.name, field.display.unit, field.condition);
        let answers = columns.fields(model.mechanism).into_iter().map(answer).collect();
        let head = Head { pose: pose_header(model.mechanism).to_owned(), answers, ..Head::default() };
        let schema = head.schema();
        let writer = Writer::of(Kind::Stream, &schema)?;
        let (rows, row) = (NumberRows::of(columns), Vec::new());
        let mut found = Self { rows, head, schema, lines: Lines::default(), row, writer };
        found.begin();
        Ok(found)
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
        self.lines.poses.push(&pose.name);
        let finite = |x: f64| if x.is_finite() { x } else { f64::NAN };
        self.lines.answers.iter_mut().zip(&self.row).for_each(|(cells, x)| cells.push(finite(*x)));
        if self.lines.poses.len() == BATCH { self.write() } else { Ok(()) }
    }

    /// What was written since.
    pub fn take(&mut self) -> Vec<u8> {
        self.writer.take()
    }

    /// Writes what is left, and the end.
    ///
    /// # Errors
    /// The last batch cannot be written.
    pub fn end(&mut self) -> Result<(), ArrowError> {
        if !self.lines.poses.is_empty() {
            self.write()?;
        }
        self.writer.end()
    }

    fn begin(&mut self) {
        let answers = self.head.answers.iter().map(|_| Vec::with_capacity(BATCH)).collect();
        self.lines = Lines { answers, ..Lines::default() };
    }

    fn write(&mut self) -> Result<(), ArrowError> {
        let lines = std::mem::take(&mut self.lines);
        self.begin();
        self.writer.write(&self.head.batch(&self.schema, lines)?)
    }
}
