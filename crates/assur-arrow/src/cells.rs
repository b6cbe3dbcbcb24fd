//! Columns of Arrow: fields with units, numbers with nulls.

use arrow_array::{ArrayRef, BooleanArray, Float64Array};
use arrow_buffer::{BooleanBuffer, NullBuffer, ScalarBuffer};
use arrow_schema::{DataType, Field};
use std::collections::HashMap;
use std::sync::Arc;

/// A field of numbers, or of conditions, with its unit.
#[must_use]
pub fn field(name: &str, unit: &str, condition: bool) -> Field {
    let kind = if condition { DataType::Boolean } else { DataType::Float64 };
    let unit = (!unit.is_empty()).then(|| ("unit".to_owned(), unit.to_owned()));
    Field::new(name, kind, true).with_metadata(unit.into_iter().collect::<HashMap<_, _>>())
}

/// A column of the numbers, which are not copied; null where they are NaN. Conditions become bits.
#[must_use]
pub fn array(values: &ScalarBuffer<f64>, condition: bool) -> ArrayRef {
    let valid = BooleanBuffer::collect_bool(values.len(), |i| !values[i].is_nan());
    let nulls = NullBuffer::new(valid);
    let nulls = (nulls.null_count() > 0).then_some(nulls);
    if condition {
        let bits = BooleanBuffer::collect_bool(values.len(), |i| values[i] != 0.0);
        Arc::new(BooleanArray::new(bits, nulls))
    } else {
        Arc::new(Float64Array::new(values.clone(), nulls))
    }
}
