//! Answers to rows as batches: a line per row and position.

use crate::cells::{array, field};
use arrow_array::{ArrayRef, Int64Array, RecordBatch, StringArray};
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use std::sync::Arc;

/// What heads the columns of answers.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// The number of each row has a column.
    pub numbered: bool,
    /// The name of each row has a column of this name.
    pub label: Option<String>,
    /// What is repeated of the rows: names and units.
    pub givens: Vec<(String, String)>,
    /// What heads the names of positions.
    pub pose: String,
    /// A column says which events happen at an instant.
    pub events: bool,
    /// Names and units of the answers, and whether each is a condition.
    pub answers: Vec<(String, String, bool)>,
    /// A column says why a line has no answers.
    pub errors: bool,
}

/// Texts, one after another.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    text: String,
    ends: Vec<usize>,
}

impl Texts {
    /// Of one text, by where each ends in it.
    #[must_use]
    pub const fn of(text: String, ends: Vec<usize>) -> Self {
        Self { text, ends }
    }

    pub fn push(&mut self, text: &str) {
        self.text.push_str(text);
        self.ends.push(self.text.len());
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    fn iter(&self) -> impl Iterator<Item = &str> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| self.text.get(start..end).unwrap_or_default())
    }
}

/// Lines of answers, column by column.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// The number of the row of each line, from 1.
    pub rows: Vec<i64>,
    /// The name of the row of each line, where the head has them.
    pub labels: Vec<Option<String>>,
    /// What is repeated of the rows; NaN where it is missing.
    pub givens: Vec<Vec<f64>>,
    /// The position of each line.
    pub poses: Texts,
    /// The events at each instant, where the head has them.
    pub events: Vec<String>,
    /// The answers; NaN where there is none, 1 and 0 for conditions.
    pub answers: Vec<Vec<f64>>,
    /// Lines without answers, with the reasons, in their order.
    pub errors: Vec<(usize, String)>,
}

impl Head {
    /// The schema of the batches.
    #[must_use]
    pub fn schema(&self) -> SchemaRef {
        let mut fields = Vec::new();
        fields.extend(self.numbered.then(|| Field::new("row", DataType::Int64, false)));
        fields.extend(self.label.as_ref().map(|label| Field::new(label, DataType::Utf8, true)));
        fields.extend(self.givens.iter().map(|(name, unit)| field(name, unit, false)));
        fields.push(Field::new(&self.pose, DataType::Utf8, true));
        fields.extend(self.events.then(|| Field::new("event", DataType::Utf8, true)));
        fields.extend(self.answers.iter().map(|(name, unit, condition)| field(name, unit, *condition)));
        fields.extend(self.errors.then(|| Field::new("error", DataType::Utf8, true)));
        Arc::new(Schema::new(fields))
    }

    /// The batch of lines; numbers are not copied.
    ///
    /// # Errors
    /// Columns of different length.
    pub fn batch(&self, schema: &SchemaRef, lines: Lines) -> Result<RecordBatch, ArrowError> {
        let Lines { rows, labels, givens, poses, events, answers, errors } = lines;
        let mut reasons = vec![None; if self.errors { poses.len() } else { 0 }];
        for (line, reason) in &errors {
            if let Some(cell) = reasons.get_mut(*line) {
                *cell = Some(reason.as_str());
            }
        }
        let mut arrays: Vec<ArrayRef> = Vec::new();
        if self.numbered {
            arrays.push(Arc::new(Int64Array::from(rows)));
        }
        if self.label.is_some() {
            arrays.push(Arc::new(StringArray::from(labels)));
        }
        arrays.extend(givens.into_iter().map(|values| array(&values.into(), false)));
        arrays.push(texts(poses.iter()));
        if self.events {
            arrays.push(texts(events.iter().map(String::as_str)));
        }
        let answers = answers.into_iter().zip(&self.answers);
        arrays.extend(answers.map(|(values, (_, _, condition))| array(&values.into(), *condition)));
        if self.errors {
            arrays.push(Arc::new(StringArray::from(reasons)));
        }
        RecordBatch::try_new(Arc::clone(schema), arrays)
    }
}

/// A column of texts; null where one is empty.
fn texts<'t>(texts: impl Iterator<Item = &'t str>) -> ArrayRef {
    let texts = texts.map(|text| Some(text).filter(|text| !text.is_empty()));
    Arc::new(texts.collect::<StringArray>())
}
