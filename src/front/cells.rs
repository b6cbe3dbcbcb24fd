//! Cells of rows in memory, and the header that they would have in a table of text.

use crate::exercise::table::{Separator, Written};
use assur_check::{ColumnUse, Row, RowCell, RowColumn};
use assur_syntax::document::{Document, ExprKind, Statement};
use std::sync::Arc;

/// What a column of rows holds.
#[derive(Clone, Copy, Debug)]
pub enum Cells<'c> {
    /// Numbers in the unit of the column; NaN where one is missing.
    Numbers(&'c [f64]),
    /// Names of rows.
    Names(&'c [Option<String>]),
}

/// What is wrong with a row.
#[derive(Clone, Debug, thiserror::Error)]
#[error("the value of `{name}` is {what}")]
pub(crate) struct Missing {
    /// The column.
    pub name: String,
    /// `missing`, `infinite`
    pub what: &'static str,
}

/// Reads a row in SI, or what is wrong with it. The digits of its numbers are looked at where they [count](digits_count).
pub(crate) fn read_row(
    columns: &Arc<[RowColumn]>,
    cells: &[Cells<'_>],
    index: usize,
    digits: bool,
    row: &mut Row,
) -> Result<(), Missing> {
    row.begin(columns);
    for (column, cells) in columns.iter().zip(cells) {
        let number = match cells {
            _ if column.what == ColumnUse::Label => {
                row.push(RowCell::default());
                continue;
            }
            Cells::Numbers(numbers) => numbers.get(index).copied().unwrap_or(f64::NAN),
            Cells::Names(_) => f64::NAN,
        };
        if !number.is_finite() {
            let what = if number.is_nan() { "missing" } else { "infinite" };
            return Err(Missing { name: column.name.clone(), what });
        }
        let digit = if digits { column.unit.to_si(last_digit(number)) } else { 0.0 };
        row.push(RowCell { value: column.unit.to_si(number), digit });
    }
    Ok(())
}

/// Whether the digits of numbers count: an expectation may take its tolerance from them.
pub(crate) fn digits_count(document: &Document) -> bool {
    document.statements.iter().any(|statement| matches!(statement.node, Statement::Expect(_)))
}

/// The header of columns with their names and units, as in a table of text.
pub(crate) fn header_line(document: &Document, header: &[(String, Option<String>)]) -> String {
    header.iter().map(|column| header_cell(document, column)).collect::<Vec<_>>().join(", ")
}

/// One unit in the last digit of a number as it would be written.
fn last_digit(number: f64) -> f64 {
    Written::read(&number.to_string(), Separator::Comma).map_or(0.0, |written| written.digit)
}

/// The header of a column as in a table of text: without a unit of its own the `given` has that of its declaration.
fn header_cell(document: &Document, (name, unit): &(String, Option<String>)) -> String {
    let unit = unit.clone().or_else(|| declared_unit(document, name));
    let text = match unit.filter(|unit| !unit.is_empty()) {
        Some(unit) if !name.contains('[') => format!("{name} [{unit}]"),
        _ => name.clone(),
    };
    let text = text.replace(['\r', '\n'], " ");
    let needs_quotes = text.contains([',', ';', '\t', '"']);
    if needs_quotes { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// The unit in which a document gives the value of a name.
fn declared_unit(document: &Document, name: &str) -> Option<String> {
    document.statements.iter().find_map(|statement| match &statement.node {
        Statement::Given(given) if given.name.node == name => match &given.value.kind {
            ExprKind::Number(number) => number.unit.as_ref().map(|unit| unit.node.clone()),
            _ => None,
        },
        _ => None,
    })
}
