//! Cells of columns as values of Python.

use arrow_array::cast::AsArray;
use arrow_array::types::Int64Type;
use arrow_array::{Array, ArrayRef};
use arrow_schema::DataType;
use assur_arrow::{names, numbers};
use pyo3::IntoPyObject;

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
