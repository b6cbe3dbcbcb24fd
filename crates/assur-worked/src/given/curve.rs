//! Curves of the file as tables.

use super::numbers::digits;
use crate::document::{Block, Inline, Line, Table, text};
use crate::forces::quantity_name;
use crate::sheet::printed_unit;
use assur_formula::name_node;
use assur_syntax::document::{Column, Curve};

/// Points of a curve next to each other.
const IN_STRIP: usize = 12;

/// A table with a row for the argument and one for the value, in strips.
pub(super) fn tables(curve: &Curve) -> Vec<Block> {
    let strip = |rows: &[assur_syntax::document::Row]| {
        let row = |(i, column): (usize, &Column)| -> Vec<Line> {
            let cells = rows.iter().filter_map(|row| row.cells.get(i));
            let cells = cells.map(|cell| vec![text(digits(cell.node.text()))]);
            std::iter::once(header(column)).chain(cells).collect()
        };
        let mut lines = curve.table.columns.iter().enumerate().map(row);
        let headers = lines.next().unwrap_or_default();
        Block::Table(Table { headers, rows: lines.collect(), numbers: (1..=rows.len()).collect() })
    };
    curve.table.rows.chunks(IN_STRIP).map(strip).collect()
}

/// The letter of a column with its unit.
fn header(column: &Column) -> Line {
    let unit = column.unit.as_ref().map_or_else(String::new, |unit| printed_unit(&unit.node));
    let unit = unit.trim_start();
    let mut line = vec![Inline::Math(name_node(&quantity_name(&column.name.node)))];
    line.extend((!unit.is_empty()).then(|| text(format!(", {unit}"))));
    line
}
