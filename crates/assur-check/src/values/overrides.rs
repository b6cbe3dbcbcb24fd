//! Values from outside the file.

use crate::values::row::Row;

/// Values that replace those of `given` statements. A row of variants replaces what the file says, values set from
/// outside replace both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Name and value as text, as in `--set r=120mm`, in the order given; a later one wins.
    pub values: Vec<(String, String)>,
    /// The row of variants.
    pub row: Row,
}

impl Overrides {
    /// No value is replaced.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// Values set from outside, as in `--set r=120mm`.
    #[must_use]
    pub fn set(values: Vec<(String, String)>) -> Self {
        Self { values, row: Row::default() }
    }
}
