//! Values from outside: set for all rows, in a row of variants, or assumed for a trial.

use crate::values::overrides::Overrides;
use crate::values::row::{ColumnUse, Row};
use crate::values::typed::Typed;
use indexmap::IndexMap;

pub struct Outside<'a> {
    /// Values set from outside.
    pub overrides: &'a Overrides,
    /// The row of variants that is checked.
    pub row: Row,
    /// A `given` with the SI value it has instead of any other.
    pub fixed: Option<(&'a str, f64)>,
    /// What stands for names that have their values in the row alone, where that is no number.
    pub keys: IndexMap<String, Typed>,
    /// A wheel whose size is left open, of which another is assumed than usual.
    pub other_size: Option<&'a str>,
}

impl<'a> Outside<'a> {
    /// Those that replace values, with nothing assumed.
    pub fn new(overrides: &'a Overrides) -> Self {
        Self { overrides, row: overrides.row.clone(), fixed: None, keys: IndexMap::new(), other_size: None }
    }

    /// What the row of variants says of a name that has its values there alone.
    pub fn key(&self, name: &str) -> Option<Typed> {
        if let Some(key) = self.keys.get(name) {
            return Some(key.clone());
        }
        let (column, cell) = self.row.find(name).filter(|(c, _)| c.what == ColumnUse::Key)?;
        Some(Typed::constant(cell.value, column.dimension))
    }

    pub fn is_set(&self, name: &str) -> bool {
        self.overrides.values.iter().any(|(n, _)| n == name)
    }

    /// One unit in the last digit of a name in the row of variants, SI, where nothing replaces it.
    pub fn digit_in_row(&self, name: &str) -> Option<f64> {
        self.row.find(name).filter(|_| !self.is_set(name)).map(|(_, cell)| cell.digit)
    }
}
