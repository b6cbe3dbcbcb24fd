//! A row of a table of variants: numbers from outside, one per column.

use assur_text::units::{Dimension, Unit};
use std::sync::Arc;

/// What a column of a table of variants is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnUse {
    /// It replaces a `given`.
    Given,
    /// Nothing but an `expect` uses it: an answer key per row.
    Key,
    /// `variant`: it names the row.
    Label,
}

/// A column of a table of variants, checked against a file.
#[derive(Clone, Debug, PartialEq)]
pub struct RowColumn {
    pub name: String,
    /// The unit of its numbers.
    pub unit: Unit,
    /// The dimension that its values have in the file.
    pub dimension: Dimension,
    /// What it is for.
    pub what: ColumnUse,
    /// The value set from outside for all rows, SI.
    pub set: Option<f64>,
}

impl RowColumn {
    /// Its header: the name with the unit in brackets.
    #[must_use]
    pub fn header(&self) -> String {
        if self.unit.text.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }
}

/// A number of a row.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowCell {
    pub value: f64,
    /// One unit in the last digit written, SI.
    pub digit: f64,
}

/// A row of a table of variants. The empty row replaces nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    columns: Arc<[RowColumn]>,
    cells: Vec<RowCell>,
    /// What it is called: `{variant}` in a title is replaced by it.
    pub label: Option<String>,
}

impl Row {
    /// One cell per column; what lacks on either side is left out. A value set from outside replaces that of the table.
    #[must_use]
    pub fn new(columns: Arc<[RowColumn]>, mut cells: Vec<RowCell>) -> Self {
        for (cell, column) in cells.iter_mut().zip(columns.iter()) {
            cell.value = column.set.unwrap_or(cell.value);
        }
        Self { columns, cells, label: None }
    }

    /// Begins another row in the memory of this one, without a cell yet.
    pub fn begin(&mut self, columns: &Arc<[RowColumn]>) {
        if !Arc::ptr_eq(&self.columns, columns) {
            self.columns = columns.clone();
        }
        self.cells.clear();
        self.label = None;
    }

    /// Adds the next cell, as [`Row::new`] does.
    pub fn push(&mut self, cell: RowCell) {
        if let Some(column) = self.columns.get(self.cells.len()) {
            self.cells.push(RowCell { value: column.set.unwrap_or(cell.value), ..cell });
        }
    }

    /// The same row with the cell of another one in a column.
    #[must_use]
    pub fn with(&self, column: usize, of: &Self) -> Self {
        let mut row = self.clone();
        row.cells.get_mut(column).zip(of.cells.get(column)).into_iter().for_each(|(own, cell)| *own = *cell);
        row
    }

    /// Whether it replaces nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// The columns with their numbers.
    pub fn entries(&self) -> impl Iterator<Item = (&RowColumn, RowCell)> {
        self.columns.iter().zip(self.cells.iter().copied())
    }

    /// The cell in the column of this index.
    pub(crate) fn cell(&self, column: usize) -> Option<RowCell> {
        self.cells.get(column).copied()
    }

    pub(crate) const fn columns(&self) -> &Arc<[RowColumn]> {
        &self.columns
    }

    /// The number of a column that is no label.
    pub(crate) fn find(&self, name: &str) -> Option<(&RowColumn, RowCell)> {
        self.entries().find(|(column, _)| column.what != ColumnUse::Label && column.name == name)
    }

    /// The row in words: `r = 120 mm, n = 1500 rpm`.
    #[must_use]
    pub fn words(&self) -> String {
        let word = |(column, cell): (&RowColumn, RowCell)| {
            let figures = assur_text::units::significant(column.unit.from_si(cell.value), 15);
            format!("{} = {figures} {}", column.name, column.unit.text).trim_end().to_owned()
        };
        self.entries().filter(|(c, _)| c.what != ColumnUse::Label).map(word).collect::<Vec<_>>().join(", ")
    }
}
