//! Curves of the file as tables.

use super::numbers::digits;
use crate::document::{Block, Figure, Inline, Line, Table, text};
use crate::forces::quantity_name;
use crate::localised::drawing_in;
use crate::sheet::printed_unit;
use crate::words::Language;
use assur_drawing::Theme;
use assur_formula::name_node;
use assur_math::math::{Between, Beyond, TableFunction};
use assur_model::model::Mechanism;
use assur_picture::{TableAxis, table_plot};
use assur_syntax::document::{Column, Curve, CurveBetween, CurveBeyond, Row};
use assur_text::units::lookup;

/// Points of a curve next to each other.
const IN_STRIP: usize = 12;

/// A table with a row for the argument and one for the value, in strips.
pub(super) fn tables(curve: &Curve) -> Vec<Block> {
    let strip = |rows: &[Row]| {
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

/// The plot of a curve; none where the table cannot be read.
pub(super) fn plot(curve: &Curve, mechanism: &Mechanism, language: Language) -> Option<Figure> {
    let [along, value] = curve.table.columns.as_slice() else { return None };
    let axis = |column: &'_ Column| column.unit.as_ref().and_then(|unit| lookup(&unit.node).ok());
    let units = [axis(along), axis(value)];
    let number = |row: &Row, i: usize| {
        let x: f64 = row.cells.get(i)?.node.text().parse().ok()?;
        Some(units[i].as_ref().map_or(x, |unit| unit.to_si(x)))
    };
    let point = |row: &Row| Some((number(row, 0)?, number(row, 1)?));
    let points = curve.table.rows.iter().map(point).collect::<Option<Vec<_>>>()?;
    let between = match curve.between {
        None => Between::Monotone,
        Some(CurveBetween::Linear) => Between::Straight,
        Some(CurveBetween::Smooth) => Between::Spline,
    };
    let beyond = if curve.beyond == Some(CurveBeyond::Periodic) { Beyond::Repeated } else { Beyond::Held };
    let table = TableFunction::new(&points, between, beyond).ok()?;
    let name = &curve.name.node;
    let [along_unit, value_unit] = units;
    let axes = [
        TableAxis { name: &along.name.node, unit: along_unit },
        TableAxis { name: &value.name.node, unit: value_unit },
    ];
    let drawing = drawing_in(language, mechanism, table_plot(name, &table, axes)).placed();
    let caption = crate::sheet::in_letters(name);
    Some(Figure { svg: drawing.svg(Theme::Auto), name: format!("table-{name}"), caption })
}

/// The letter of a column with its unit.
fn header(column: &Column) -> Line {
    let unit = column.unit.as_ref().map_or_else(String::new, |unit| printed_unit(&unit.node));
    let unit = unit.trim_start();
    let mut line = vec![Inline::Math(name_node(&quantity_name(&column.name.node)))];
    line.extend((!unit.is_empty()).then(|| text(format!(", {unit}"))));
    line
}
