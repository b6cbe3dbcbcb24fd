//! Columns of rows from tables of any kind.

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type,
    UInt64Type,
};
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_schema::DataType;

/// A column of rows.
#[derive(Clone, Debug)]
pub enum Column {
    /// NaN where one is missing.
    Numbers(Vec<f64>),
    Names(Vec<Option<String>>),
}

impl Column {
    /// Adds the rows of the same column.
    pub fn append(&mut self, more: Self) {
        match (self, more) {
            (Self::Numbers(all), Self::Numbers(mut more)) => all.append(&mut more),
            (Self::Names(all), Self::Names(mut more)) => all.append(&mut more),
            _ => {}
        }
    }
}

/// The columns of a batch in its order: by the name of each, and whether it has names instead of numbers.
///
/// # Errors
/// A column of another kind, in words.
pub fn columns<'f>(
    fields: impl IntoIterator<Item = (&'f str, bool)>,
    batch: &RecordBatch,
) -> Result<Vec<Column>, String> {
    let column = |((name, is_label), array): ((&str, bool), &ArrayRef)| {
        let column =
            if is_label { names(array).map(Column::Names) } else { numbers(array).map(Column::Numbers) };
        column.ok_or_else(|| {
            let (kind, takes) = (array.data_type(), if is_label { "names" } else { "numbers" });
            format!("column `{name}` takes {takes}, but has {kind}")
        })
    };
    fields.into_iter().zip(batch.columns()).map(column).collect()
}

/// A column of any kind of numbers; NaN for null.
#[must_use]
pub fn numbers(array: &ArrayRef) -> Option<Vec<f64>> {
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
#[must_use]
pub fn names(array: &ArrayRef) -> Option<Vec<Option<String>>> {
    let text = |x: Option<&str>| x.map(str::to_owned);
    match array.data_type() {
        DataType::Utf8 => Some(array.as_string::<i32>().iter().map(text).collect()),
        DataType::LargeUtf8 => Some(array.as_string::<i64>().iter().map(text).collect()),
        DataType::Utf8View => Some(array.as_string_view().iter().map(text).collect()),
        DataType::Null => Some(vec![None; array.len()]),
        _ => Some(numbers(array)?.into_iter().map(number_name).collect()),
    }
}

fn number_name(x: f64) -> Option<String> {
    (!x.is_nan()).then(|| x.to_string())
}
