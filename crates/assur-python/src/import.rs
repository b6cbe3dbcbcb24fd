//! Tables of Python: objects with the C interface of Arrow, and mappings of columns.

use arrow_array::ffi::{FFI_ArrowArray, FFI_ArrowSchema, from_ffi};
use arrow_array::ffi_stream::{FFI_ArrowArrayStream, RecordBatchStreamReader};
use arrow_array::{
    Array, ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, RecordBatchReader, StringArray,
    StructArray,
};
use arrow_schema::{ArrowError, DataType, Field, Schema};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::ffi::c_str;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyCapsule, PyTuple};
use std::ffi::CStr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Batches of rows, one after another.
pub type Reader = Box<dyn RecordBatchReader + Send>;

/// Columns of a mapping: numbers as bytes, or names.
#[derive(FromPyObject)]
pub enum GivenColumn<'py> {
    /// The bytes of numbers.
    Numbers(Bound<'py, PyBytes>),
    /// Names of rows.
    Names(Vec<Option<String>>),
}

/// Numbers from their bytes.
pub fn of_bytes(bytes: &Bound<'_, PyBytes>) -> Vec<f64> {
    let (numbers, _) = bytes.as_bytes().as_chunks::<8>();
    numbers.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect()
}

/// Rows from an object with the C interface of Arrow.
pub fn of_arrow(table: &Bound<'_, PyAny>) -> PyResult<Reader> {
    if table.hasattr("__arrow_c_stream__")? {
        let capsule = table.call_method0("__arrow_c_stream__")?;
        let capsule = capsule.cast::<PyCapsule>()?;
        return careful(|| of_stream(capsule));
    }
    let capsules = table.call_method0("__arrow_c_array__")?;
    let capsules = capsules.cast::<PyTuple>()?;
    let (schema, array) = (capsules.get_item(0)?, capsules.get_item(1)?);
    let (schema, array) = (schema.cast::<PyCapsule>()?, array.cast::<PyCapsule>()?);
    careful(|| of_array(schema, array))
}

/// Objects that lie about themselves make the reader of Arrow give up: that is an error, too.
fn careful<T>(read: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| Err(not_arrow("it is not what its schema says")))
}

fn not_arrow(why: &str) -> PyErr {
    PyValueError::new_err(format!("the table cannot be read as Arrow: {why}"))
}

fn pointer<T>(capsule: &Bound<'_, PyCapsule>, name: &'static CStr) -> PyResult<*mut T> {
    Ok(capsule.pointer_checked(Some(name))?.as_ptr().cast())
}

fn of_stream(capsule: &Bound<'_, PyCapsule>) -> PyResult<Reader> {
    let stream: *mut FFI_ArrowArrayStream = pointer(capsule, c_str!("arrow_array_stream"))?;
    // SAFETY: a capsule of this name holds such a stream, which is moved out of it: what is left is released
    let reader = unsafe { RecordBatchStreamReader::from_raw(stream) };
    Ok(Box::new(Checked(reader.map_err(|error| not_arrow(&error.to_string()))?)))
}

fn of_array(schema: &Bound<'_, PyCapsule>, array: &Bound<'_, PyCapsule>) -> PyResult<Reader> {
    let schema: *mut FFI_ArrowSchema = pointer(schema, c_str!("arrow_schema"))?;
    let array: *mut FFI_ArrowArray = pointer(array, c_str!("arrow_array"))?;
    // SAFETY: capsules of these names hold a schema and an array that belongs to it; the array is moved out of its capsule
    let data = unsafe { from_ffi(FFI_ArrowArray::from_raw(array), &*schema) };
    let data = data.map_err(|error| not_arrow(&error.to_string()))?;
    if !matches!(data.data_type(), DataType::Struct(_)) {
        return Err(PyTypeError::new_err(
            "a table has columns with names; this is one column without a name",
        ));
    }
    data.validate_full().map_err(|error| not_arrow(&error.to_string()))?;
    let batch = RecordBatch::from(StructArray::from(data));
    let schema = batch.schema();
    Ok(Box::new(RecordBatchIterator::new([Ok(batch)], schema)))
}

/// A stream whose batches are looked at before they are used.
struct Checked(RecordBatchStreamReader);

impl Iterator for Checked {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        let next = catch_unwind(AssertUnwindSafe(|| self.0.next()));
        let Ok(next) = next else {
            let why = "the table is not what its schema says".to_owned();
            return Some(Err(ArrowError::InvalidArgumentError(why)));
        };
        Some(next?.and_then(|batch| {
            batch.columns().iter().try_for_each(|column| column.to_data().validate_full())?;
            Ok(batch)
        }))
    }
}

impl RecordBatchReader for Checked {
    fn schema(&self) -> Arc<Schema> {
        self.0.schema()
    }
}

/// Rows from columns with their names.
pub fn of_columns(columns: Vec<(String, GivenColumn<'_>)>) -> PyResult<Reader> {
    let mut fields = Vec::new();
    let mut arrays: Vec<ArrayRef> = Vec::new();
    for (name, column) in columns {
        let array: ArrayRef = match column {
            GivenColumn::Numbers(numbers) => Arc::new(Float64Array::from(of_bytes(&numbers))),
            GivenColumn::Names(names) => Arc::new(StringArray::from(names)),
        };
        if let Some(first) = arrays.first()
            && first.len() != array.len()
        {
            let other: &Field = &fields[0];
            let (found, count, other) = (array.len(), first.len(), other.name());
            return Err(PyValueError::new_err(format!(
                "column `{name}` has {found} rows, but `{other}` has {count}"
            )));
        }
        fields.push(Field::new(name, array.data_type().clone(), true));
        arrays.push(array);
    }
    if arrays.is_empty() {
        return Err(PyValueError::new_err("the table has no columns"));
    }
    let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays).map_err(crate::columns::arrow)?;
    let schema = batch.schema();
    Ok(Box::new(RecordBatchIterator::new([Ok(batch)], schema)))
}
