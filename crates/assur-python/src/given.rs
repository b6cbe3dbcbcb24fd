//! Columns of rows from tables of any kind.

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type,
    UInt64Type,
};
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_schema::{ArrowError, DataType};
use assur::{Cells, RowField};
use pyo3::IntoPyObject;

/// A column of rows.
pub enum Column {
    /// NaN where one is missing.
    Numbers(Vec<f64>),
    /// Names of rows.
    Names(Vec<Option<String>>),
}

impl Column {
    /// As the library takes them.
    pub fn cells(&self) -> Cells<'_> {
        match self {
            Self::Numbers(numbers) => Cells::Numbers(numbers),
            Self::Names(names) => Cells::Names(names),
        }
    }
}

/// The columns of a batch, in the order of the fields.
pub fn columns(fields: &[RowField], batch: &RecordBatch) -> Result<Vec<Column>, ArrowError> {
    let column = |(field, array): (&RowField, &ArrayRef)| {
        let column = if field.is_label {
            names(array).map(Column::Names)
        } else {
            numbers(array).map(Column::Numbers)
        };
        column.ok_or_else(|| {
            let (name, kind) = (&field.name, array.data_type());
            let takes = if field.is_label { "names" } else { "numbers" };
            ArrowError::CastError(format!("column `{name}` takes {takes}, but has {kind}"))
        })
    };
    fields.iter().zip(batch.columns()).map(column).collect()
}

/// A column of any kind of numbers; NaN for null.
fn numbers(array: &ArrayRef) -> Option<Vec<f64>> {
    macro_rules! of {
        ($kind:ty, $convert:expr) => {{
            let numbers = array.as_primitive::<$kind>();
            Some(numbers.iter().map(|x| x.map_or(f64::NAN, $convert)).collect())
        }};
    }
    #[allow(clippy::cast_precision_loss, reason = "a number of a table is a number with decimals")]
    match array.data_type() {
        DataType::Float64 => of!(Float64Type, |x| x),
        DataType::Float32 => of!(Float32Type, f64::from),
        DataType::Int8 => of!(Int8Type, f64::from),
        DataType::Int16 => of!(Int16Type, f64::from),
        DataType::Int32 => of!(Int32Type, f64::from),
        DataType::Int64 => of!(Int64Type, |x| x as f64),
        DataType::UInt8 => of!(UInt8Type, f64::from),
        DataType::UInt16 => of!(UInt16Type, f64::from),
        DataType::UInt32 => of!(UInt32Type, f64::from),
        DataType::UInt64 => of!(UInt64Type, |x| x as f64),
        DataType::Null => Some(vec![f64::NAN; array.len()]),
        _ => None,
    }
}

/// A column of names; whole numbers are names, too.
fn names(array: &ArrayRef) -> Option<Vec<Option<String>>> {
    let text = |x: Option<&str>| x.map(str::to_owned);
    match array.data_type() {
        DataType::Utf8 => Some(array.as_string::<i32>().iter().map(text).collect()),
        DataType::LargeUtf8 => Some(array.as_string::<i64>().iter().map(text).collect()),
        DataType::Utf8View => Some(array.as_string_view().iter().map(text).collect()),
        DataType::Null => Some(vec![None; array.len()]),
        _ => Some(numbers(array)?.into_iter().map(number_name).collect()),
    }
}

/// A cell as a value of Python.
#[derive(IntoPyObject)]
pub enum Cell {
    /// A condition.
    Truth(bool),
    /// A whole number.
    Whole(i64),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
}

/// The cells of a column of any kind.
pub fn cells(array: &ArrayRef) -> Option<Vec<Option<Cell>>> {
    match array.data_type() {
        DataType::Boolean => Some(array.as_boolean().iter().map(|x| x.map(Cell::Truth)).collect()),
        DataType::Int64 => {
            Some(array.as_primitive::<Int64Type>().iter().map(|x| x.map(Cell::Whole)).collect())
        }
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => {
            Some(names(array)?.into_iter().map(|x| x.map(Cell::Text)).collect())
        }
        _ => {
            let number = |x: f64| (!x.is_nan()).then_some(Cell::Number(x));
            Some(numbers(array)?.into_iter().map(number).collect())
        }
    }
}

fn number_name(x: f64) -> Option<String> {
    (!x.is_nan()).then(|| x.to_string())
}
