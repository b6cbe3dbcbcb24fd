//! The solution of a problem as columns.

use crate::batches::Batch;
use crate::numbers::Numbers;
use arrow_array::{ArrayRef, RecordBatch, StringArray};
use arrow_buffer::ScalarBuffer;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use assur::internals::diagnostic::did_you_mean;
use assur::{Diagnostics, PoseFailure, WrittenUnit};
use assur_arrow::{array, field};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Write;
use std::sync::Arc;

/// Columns of residuals and condition.
const OWN: usize = 4;

/// The answers of all positions.
#[pyclass(frozen, module = "assur")]
pub struct Columns {
    columns: Vec<Column>,
    /// Residuals and condition.
    quality: Vec<Column>,
    solved: Arc<Solved>,
}

/// A column and its unit.
struct Column {
    name: String,
    unit: String,
    written: WrittenUnit,
    condition: bool,
    values: ScalarBuffer<f64>,
}

/// What columns in all units have in common.
struct Solved {
    pose_header: String,
    len: usize,
    names: Vec<(usize, String)>,
    failures: Vec<PoseFailure>,
    expectations: Vec<assur::Expectation>,
    diagnostics: Diagnostics,
}

impl Columns {
    /// Takes the columns of the library over: nothing is copied.
    pub fn of(found: assur::Columns) -> Self {
        let assur::Columns { pose_header, len, names, failures, expectations, diagnostics, .. } = found;
        let assur::Residuals { closure, equilibrium, power } = found.residuals;
        let named = |name: &str| (name.to_owned(), String::new(), WrittenUnit::default(), false);
        let own = [
            (named("residual(closure)"), closure),
            (named("residual(equilibrium)"), equilibrium),
            (named("residual(power)"), power),
            (named("condition"), found.condition),
        ];
        let answers = found.columns.into_iter().map(|c| ((c.name, c.unit, c.written, c.condition), c.values));
        let (mut memory, mut parts) = (Arc::default(), Vec::new());
        for (head, values) in answers.chain(own) {
            let (all, range) = values.into_parts();
            memory = all;
            parts.push((head, range));
        }
        // nobody else has it any more
        let memory = ScalarBuffer::from(Arc::unwrap_or_clone(memory));
        let mut columns: Vec<Column> = parts
            .into_iter()
            .map(|((name, unit, written, condition), range)| {
                let values = memory.slice(range.start, range.len());
                Column { name, unit, written, condition, values }
            })
            .collect();
        let quality = columns.split_off(columns.len() - OWN);
        Self {
            columns,
            quality,
            solved: Arc::new(Solved { pose_header, len, names, failures, expectations, diagnostics }),
        }
    }

    fn column(&self, name: &str) -> PyResult<&Column> {
        let found = self.columns.iter().chain(&self.quality).find(|column| column.name == name);
        found.ok_or_else(|| {
            let names = || self.columns.iter().map(|column| column.name.as_str());
            let help = match did_you_mean(name, names()).first() {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
            };
            PyKeyError::new_err(format!("no answer is called `{name}`; {help}"))
        })
    }

    fn record(&self) -> Result<RecordBatch, ArrowError> {
        let Solved { pose_header, len, names, failures, .. } = &*self.solved;
        let mut fields = vec![Field::new(pose_header, DataType::Utf8, false)];
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(pose_names(*len, names))];
        for column in self.columns.iter().chain(&self.quality) {
            fields.push(field(&column.name, &column.unit, column.condition));
            arrays.push(array(&column.values, column.condition));
        }
        let mut reasons: Vec<Option<&str>> = vec![None; *len];
        for failure in failures {
            reasons[failure.index] = Some(&failure.message);
        }
        fields.push(Field::new("error", DataType::Utf8, true));
        arrays.push(Arc::new(StringArray::from(reasons)));
        RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
    }
}

/// The names of positions: their numbers, counted from 1, but for some.
fn pose_names(count: usize, others: &[(usize, String)]) -> StringArray {
    let mut others = others.iter().peekable();
    let mut name = String::new();
    let names = (0..count).map(|i| {
        name.clear();
        match others.next_if(|(index, _)| *index == i) {
            Some((_, other)) => name.push_str(other),
            // writing to a String does not fail
            None => drop(write!(name, "{}", i + 1)),
        }
        name.clone()
    });
    StringArray::from_iter_values(names)
}

#[pymethods]
impl Columns {
    fn __len__(&self) -> usize {
        self.solved.len
    }

    /// The names of the columns.
    #[getter]
    fn names(&self) -> Vec<&str> {
        self.columns.iter().map(|column| column.name.as_str()).collect()
    }

    /// The units of the columns, by name.
    #[getter]
    fn units(&self) -> Vec<(&str, &str)> {
        self.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect()
    }

    /// The numbers of a column.
    fn numbers(&self, name: &str) -> PyResult<Numbers> {
        self.column(name).map(|column| Numbers::of(column.values.clone()))
    }

    /// The names of positions.
    #[getter]
    fn poses(&self) -> Vec<String> {
        pose_names(self.solved.len, &self.solved.names).iter().flatten().map(str::to_owned).collect()
    }

    /// Positions without a solution: index, code, reason.
    #[getter]
    fn failures(&self) -> Vec<(usize, Option<&str>, &str)> {
        let failures = self.solved.failures.iter();
        failures.map(|f| (f.index, f.code.as_deref(), f.message.as_str())).collect()
    }

    /// Expectations: text, pose, whether they are met.
    #[getter]
    fn expectations(&self) -> Vec<(&str, Option<&str>, bool)> {
        let expectations = self.solved.expectations.iter();
        expectations.map(|e| (e.text.as_str(), e.pose.as_deref(), e.met)).collect()
    }

    /// Warnings as the terminal shows them, and as JSON.
    #[getter]
    fn diagnostics(&self) -> (String, String) {
        (self.solved.diagnostics.to_string(), self.solved.diagnostics.to_json())
    }

    /// The same in the units of the file.
    fn in_file_units(&self) -> Self {
        let column = |c: &Column| Column {
            name: c.name.clone(),
            unit: c.written.text().to_owned(),
            written: c.written.clone(),
            condition: c.condition,
            values: match c.condition {
                true => c.values.clone(),
                false => c.values.iter().map(|x| c.written.of_si(*x)).collect(),
            },
        };
        let same = |c: &Column| Column {
            name: c.name.clone(),
            unit: String::new(),
            written: WrittenUnit::default(),
            condition: false,
            values: c.values.clone(),
        };
        Self {
            columns: self.columns.iter().map(column).collect(),
            quality: self.quality.iter().map(same).collect(),
            solved: Arc::clone(&self.solved),
        }
    }

    /// All of it as a batch of Arrow.
    #[getter]
    fn batch(&self) -> PyResult<Batch> {
        self.record().map(Batch::of).map_err(arrow)
    }
}

/// An error of Arrow as an exception.
#[allow(clippy::needless_pass_by_value, reason = "for `map_err`")]
pub fn arrow(error: ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
