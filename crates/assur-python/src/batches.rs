//! Rows of variants in batches of Arrow: rows come in, answers go out, none is kept.

use crate::columns::arrow;
use crate::errors;

use crate::import::{Reader, of_arrow};
use crate::numbers::Numbers;
use crate::solving::{Form, Solving, StartError};
use crate::values::{Cell, cells};
use arrow_array::cast::AsArray;
use arrow_array::ffi::{FFI_ArrowArray, FFI_ArrowSchema};
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, RecordBatch, RecordBatchIterator, RecordBatchReader, StructArray};
use arrow_schema::{Field, Schema, SchemaRef};
use arrow_select::concat::concat_batches;
use assur::Rows;
use pyo3::exceptions::{PyKeyError, PyStopIteration, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use std::sync::{Arc, Mutex, PoisonError};

/// Schema and array of a batch.
type Capsules<'py> = (Bound<'py, PyCapsule>, Bound<'py, PyCapsule>);

/// A schema for others.
fn schema_capsule<'py>(py: Python<'py>, schema: &Schema) -> PyResult<Bound<'py, PyCapsule>> {
    PyCapsule::new_with_value(py, FFI_ArrowSchema::try_from(schema).map_err(arrow)?, c"arrow_schema")
}

/// A batch for others.
fn array_capsules(py: Python<'_>, batch: RecordBatch) -> PyResult<Capsules<'_>> {
    let schema = schema_capsule(py, &batch.schema())?;
    let array = FFI_ArrowArray::new(&StructArray::from(batch).into_data());
    Ok((schema, PyCapsule::new_with_value(py, array, c"arrow_array")?))
}

/// Batches for others.
fn stream_capsule(py: Python<'_>, reader: Reader) -> PyResult<Bound<'_, PyCapsule>> {
    PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(reader), c"arrow_array_stream")
}

/// Columns of answers.
#[pyclass(frozen, module = "assur")]
pub struct Batch(RecordBatch);

#[pymethods]
impl Batch {
    fn __len__(&self) -> usize {
        self.0.num_rows()
    }

    /// The names of the columns.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.0.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    /// The units of the columns that have one.
    #[getter]
    fn units(&self) -> Vec<(String, String)> {
        let schema = self.0.schema();
        let unit = |f: &Arc<Field>| Some((f.name().clone(), f.metadata().get("unit")?.clone()));
        schema.fields().iter().filter_map(unit).collect()
    }

    /// The numbers of a column.
    fn numbers(&self, name: &str) -> PyResult<Numbers> {
        let column = self.column(name)?;
        let numbers = column.as_primitive_opt::<Float64Type>();
        numbers
            .map(|numbers| Numbers::of(numbers.values().clone()))
            .ok_or_else(|| PyTypeError::new_err(format!("column `{name}` has no numbers: see `cells`")))
    }

    /// The cells of a column that has no numbers with decimals: names, whole numbers, conditions.
    fn cells(&self, name: &str) -> PyResult<Vec<Option<Cell>>> {
        let column = self.column(name)?;
        cells(column).ok_or_else(|| {
            PyTypeError::new_err(format!(
                "column `{name}` has {}, which is not read here",
                column.data_type()
            ))
        })
    }

    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        schema_capsule(py, &self.0.schema())
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_array__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Capsules<'py>> {
        // a schema may be asked for; this is the only one there is
        drop(requested_schema);
        array_capsules(py, self.0.clone())
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        drop(requested_schema);
        stream_capsule(py, Box::new(RecordBatchIterator::new([Ok(self.0.clone())], self.0.schema())))
    }
}

impl Batch {
    /// Of columns that are there.
    pub const fn of(batch: RecordBatch) -> Self {
        Self(batch)
    }

    fn column(&self, name: &str) -> PyResult<&ArrayRef> {
        self.0.column_by_name(name).ok_or_else(|| PyKeyError::new_err(name.to_owned()))
    }
}

/// Answers to rows, batch by batch.
#[pyclass(frozen, module = "assur")]
pub struct Batches {
    schema: SchemaRef,
    solving: Mutex<Option<Solving>>,
}

impl Batches {
    /// Of a reader of rows, whose columns fit the problem.
    pub fn of(py: Python<'_>, rows: Rows, reader: Reader, form: Form) -> PyResult<Self> {
        let mut solving = Solving::of(rows, reader, form);
        py.detach(|| solving.begin()).map_err(|error| match error {
            StartError::Diagnostics(diagnostics) => errors::outside(py, &diagnostics),
            StartError::Arrow(error) => arrow(error),
        })?;
        Ok(Self { schema: solving.schema(), solving: Mutex::new(Some(solving)) })
    }

    fn taken(&self) -> PyResult<Solving> {
        let mut solving = self.solving.lock().unwrap_or_else(PoisonError::into_inner);
        solving.take().ok_or_else(|| PyValueError::new_err("the answers were read already"))
    }
}

#[pymethods]
impl Batches {
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        schema_capsule(py, &self.schema)
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        drop(requested_schema);
        stream_capsule(py, Box::new(self.taken()?))
    }

    /// All answers that are left, as one batch.
    fn read(&self, py: Python<'_>) -> PyResult<Batch> {
        let mut solving = self.taken()?;
        let crew = solving.crew();
        let all = py.detach(|| {
            let batches = std::iter::from_fn(|| solving.next_batch(&crew)).collect::<Result<Vec<_>, _>>()?;
            match batches.as_slice() {
                [only] => Ok(only.clone()),
                all => concat_batches(&self.schema, all),
            }
        });
        match (all, crew.error()) {
            (Err(_), Some(error)) => Err(error),
            (all, _) => all.map(Batch).map_err(arrow),
        }
    }

    const fn __iter__(this: PyRef<'_, Self>) -> PyRef<'_, Self> {
        this
    }

    fn __next__(&self, py: Python<'_>) -> PyResult<Batch> {
        let mut solving = self.taken()?;
        let crew = solving.crew();
        let next = py.detach(|| solving.next_batch(&crew));
        let error = crew.error();
        *self.solving.lock().unwrap_or_else(PoisonError::into_inner) = Some(solving);
        match next {
            _ if error.is_some() => Err(error.unwrap_or_else(|| PyStopIteration::new_err(()))),
            None => Err(PyStopIteration::new_err(())),
            Some(batch) => batch.map(Batch).map_err(arrow),
        }
    }
}

/// The batches of a table.
#[pyfunction]
pub fn batches(table: &Bound<'_, PyAny>) -> PyResult<Vec<Batch>> {
    of_arrow(table)?.map(|batch| batch.map(Batch).map_err(arrow)).collect()
}
