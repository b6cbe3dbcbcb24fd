//! `variants`: names and units of the columns, and rows as numbers.

use crate::expr::{
    context::Context,
    fit::{unit_mismatch, unit_missing},
};
use crate::names::{
    declared::QuantityKind,
    suggestion::{not_declared, suggestion, wrong_kind},
};
use crate::requests::tolerance;
use crate::statements::comma::decimal_comma;
use crate::values::{
    definition::Settled,
    row::{ColumnUse, Row, RowCell, RowColumn},
    typed::{Dim, Type, correction, phrase},
};
use assur_model::model::{Expr, Value};
use assur_syntax::document::{Cell, Column, Document, ExprKind, Statement, Variants};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Span, Spanned};
use assur_text::units::{Dimension, Unit, lookup};
use indexmap::IndexSet;
use std::collections::{HashMap, hash_map::Entry};
use std::sync::Arc;

/// The name of a column that names its rows.
const LABEL: &str = "variant";

/// A row of a file's own table.
#[derive(Clone, Debug)]
pub struct FileRow {
    pub row: Row,
    /// Its name in the column `variant`.
    pub label: Option<String>,
    pub span: Span,
}

/// The table of a document, where there is one.
#[must_use]
pub fn table(document: &Document) -> Option<&Variants> {
    document.statements.iter().find_map(|statement| match &statement.node {
        Statement::Variants(table) => Some(table),
        _ => None,
    })
}

/// The rows of a table whose columns are checked; of those that are as long as the header.
#[must_use]
pub fn file_rows(table: &Variants, columns: &Arc<[RowColumn]>) -> Vec<FileRow> {
    let fits = table.rows.iter().filter(|row| row.cells.len() == columns.len());
    let rows = fits.enumerate().map(|(i, row)| {
        let label = columns.iter().position(|c| c.what == ColumnUse::Label);
        let cell = |(cell, column): (&Cell, &RowColumn)| match cell {
            Cell::Number(number) => RowCell {
                value: column.unit.to_si(number.value),
                digit: tolerance::digit_of(number).map_or(0.0, |digit| column.unit.to_si(digit)),
            },
            Cell::Name(_) => RowCell::default(),
        };
        let cells = row.cells.iter().map(|c| &c.node);
        let label = label.map(|i| row.cells[i].node.text().to_owned());
        let mut numbers = Row::new(columns.clone(), cells.zip(columns.iter()).map(cell).collect());
        numbers.label = Some(label.clone().unwrap_or_else(|| (i + 1).to_string()));
        FileRow { row: numbers, label, span: row.span }
    });
    rows.collect()
}

/// Checks the table of variants of a document; nothing where a row of it is checked.
pub(crate) fn variants(cx: &mut Context<'_>) {
    if !cx.values.outside.row.is_empty() {
        return;
    }
    let mut first = None;
    for statement in &cx.doc.statements {
        let Statement::Variants(table) = &statement.node else { continue };
        if let Some(first) = first {
            crate::motion::drive::stated_twice(cx, "variants", statement.span, first);
            continue;
        }
        first = Some(statement.span);
        columns(cx, table);
        rows(cx, table);
        named_twice(cx, table);
    }
}

/// The columns of a table, of the document or beside it; nothing where one has an error.
pub(crate) fn columns(cx: &mut Context<'_>, table: &Variants) -> Option<Vec<RowColumn>> {
    let mut all = Vec::new();
    let mut firsts: HashMap<&str, Span> = HashMap::new();
    for column in &table.columns {
        match firsts.entry(&column.name.node) {
            Entry::Occupied(first) => {
                cx.error(crate::names::suggestion::duplicate(&column.name, *first.get(), None));
                all.push(None);
            }
            Entry::Vacant(place) => {
                place.insert(column.name.span);
                all.push(check_column(cx, column));
            }
        }
    }
    all.into_iter().collect()
}

/// Reports names that an `expect` uses, and that neither the file nor a table beside it gives a value.
pub(crate) fn missing_keys(cx: &mut Context<'_>, table: &Variants) {
    let header = table.columns.iter().map(|c| c.name.span).reduce(|a, b| a.to(b)).unwrap_or_default();
    let own = crate::requests::variants::table(cx.doc).map_or(&[][..], |own| &own.columns);
    let has = |name: &str| table.columns.iter().any(|c| c.name.node == name);
    let mut names: IndexSet<&str> = IndexSet::new();
    for column in own {
        let declared = cx.names.quantities.get(&column.name.node).map(|d| d.what);
        if matches!(declared, Some(QuantityKind::Column(_)))
            && !has(&column.name.node)
            && cx.used_by_expect(&column.name.node)
        {
            names.insert(&column.name.node);
        }
    }
    for name in names {
        cx.error(
            Diagnosis::error(
                "mech::request::key_column",
                format!("the table has no column `{name}`, which an `expect` of the file needs"),
            )
            .label(header, format!("no `{name}` here"))
            .help(format!("add the column, or write `given {name} = …` in the file")),
        );
    }
}

fn check_column(cx: &mut Context<'_>, column: &Column) -> Option<RowColumn> {
    let unit = match &column.unit {
        Some(word) => cx.unit(word)?,
        None => Unit::si(Dimension::NUMBER),
    };
    let name = &column.name;
    let checked = |what, dimension, unit: Unit| {
        Some(RowColumn { name: name.node.clone(), unit, dimension, what, set: None })
    };
    cx.names.note_quantity(name);
    let of_expect = |cx: &Context<'_>| cx.used_by_expect(&name.node);
    match cx.names.quantities.get(&name.node).map(|d| d.what) {
        Some(QuantityKind::Given(_)) => {
            let Some(Settled::Constant(t)) = cx.values.definitions.settled(&name.node) else { return None };
            let outside = cx.values.outside.overrides.values.iter().any(|(n, _)| *n == name.node);
            let set = match t.expr {
                Expr::Constant(Value::Scalar(x)) if outside => Some(x),
                _ => None,
            };
            let ty = t.ty;
            let dimension = fits(cx, column, ty, &unit)?;
            checked(ColumnUse::Given, dimension, unit).map(|column| RowColumn { set, ..column })
        }
        Some(QuantityKind::Column(_)) | None if of_expect(cx) => {
            checked(ColumnUse::Key, unit.dimension, unit)
        }
        Some(QuantityKind::Column(_)) | None if name.node == LABEL && column.unit.is_none() => {
            checked(ColumnUse::Label, unit.dimension, unit)
        }
        Some(QuantityKind::Column(_)) | None => {
            unknown(cx, column);
            None
        }
        Some(kind) => {
            let is = kind.phrase().to_owned();
            let replaces = "a row of variants replaces the values of `given`";
            let suggestion = given_meant(cx, &name.node);
            cx.error(wrong_kind(
                &name.node,
                &is,
                "a `given`",
                name.span,
                cx.names.quantities.get(&name.node).map(|d| d.span),
                Some(
                    suggestion
                        .map_or(replaces.into(), |suggestion| format!("write `{suggestion}`: {replaces}")),
                ),
            ));
            None
        }
    }
}

/// The `given` whose name differs from this one in capitals alone.
fn given_meant(cx: &Context<'_>, name: &str) -> Option<String> {
    let given = cx.names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Given(_)));
    let mut alike = given.map(|(given, _)| given).filter(|given| given.to_lowercase() == name.to_lowercase());
    alike.next().cloned()
}

/// The unit in which the file states a `given`.
fn unit_of_given(cx: &Context<'_>, name: &str) -> Option<String> {
    let QuantityKind::Given(value) = cx.names.quantities.get(name)?.what else { return None };
    match &value.kind {
        ExprKind::Number(number) => number.unit.as_ref().map(|unit| unit.node.clone()),
        _ => None,
    }
}

fn unknown(cx: &mut Context<'_>, column: &Column) {
    let name = &column.name;
    let reported =
        cx.names.bad.contains(&name.node) || cx.problems.reported.contains(&("quantity", name.node.clone()));
    if reported || !cx.problems.reported.insert(("given", name.node.clone())) {
        return;
    }
    let given = cx.names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Given(_)));
    let given = given.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
    let help = match naming(cx, column) {
        true if name.node != LABEL => {
            let words = format!("call the column that names the rows `{LABEL}`");
            Some(Help::write(name.span, &[LABEL.to_owned()]).in_words(words))
        }
        _ => unused_given(cx, column)
            .or_else(|| suggestion(&name.node, name.span, &given, "`given` of this file"))
            .or_else(|| given_line(cx, column).map(Help::from)),
    };
    let (name, span) = (name.node.clone(), name.span);
    cx.error(not_declared("given", &name, None, span, help));
}

/// The only `given` of the column's dimension that no column has, where none is near by its letters.
fn unused_given(cx: &Context<'_>, column: &Column) -> Option<Help> {
    let wanted = cx.doc.statements.iter().find_map(|_| table(cx.doc))?;
    let unit = lookup(&column.unit.as_ref()?.node).ok()?;
    let is_given =
        |name: &str| matches!(cx.names.quantities.get(name).map(|d| d.what), Some(QuantityKind::Given(_)));
    let has = |name: &str| wanted.columns.iter().any(|c| c.name.node == name);
    let fits = |name: &&String| {
        let t = cx.values.definitions.settled.get(*name);
        is_given(name)
            && !has(name)
            && matches!(t, Some(Settled::Constant(t)) if t.ty.dimension() == unit.dimension)
    };
    let found = cx.names.quantities.keys().filter(fits).cloned().collect::<Vec<_>>();
    let [only] = found.as_slice() else { return None };
    let line = given_line(cx, column).map(|line| format!(", or {line}")).unwrap_or_default();
    let words = format!("write `{only}`, which no column has yet{line}");
    Some(Help::write(column.name.span, std::slice::from_ref(only)).in_words(words))
}

/// Whether a column is reported as one without a `given`.
fn is_undeclared(cx: &Context<'_>, column: &Column) -> bool {
    let declared = cx.names.quantities.get(&column.name.node).map(|d| d.what);
    matches!(declared, None | Some(QuantityKind::Column(_))) && !cx.used_by_expect(&column.name.node)
}

/// The line that would declare the `given` of a column, with its first number.
fn given_line(cx: &Context<'_>, column: &Column) -> Option<String> {
    let table = table(cx.doc)?;
    let at = table.columns.iter().position(|c| c.name.span == column.name.span)?;
    let Cell::Number(number) = &table.rows.first()?.cells.get(at)?.node else { return None };
    let unit = column.unit.as_ref().map_or("", |unit| unit.node.as_str());
    Some(format!("add `{}`", format!("given {} = {} {unit}", column.name.node, number.text).trim_end()))
}

/// Whether a column without a unit has names alone.
fn naming(cx: &Context<'_>, column: &Column) -> bool {
    let Some(table) = table(cx.doc).filter(|_| column.unit.is_none()) else { return false };
    let at = table.columns.iter().position(|c| c.name.span == column.name.span);
    let cells = || table.rows.iter().filter_map(|row| row.cells.get(at?));
    cells().next().is_some() && cells().all(|cell| matches!(cell.node, Cell::Name(_)))
}

/// The dimension that the column's values have in the file.
fn fits(cx: &mut Context<'_>, column: &Column, ty: Type, unit: &Unit) -> Option<Dimension> {
    let name = &column.name.node;
    let span = column.unit.as_ref().map_or(column.name.span, |u| u.span);
    let Type::Number(dim) = ty else {
        cx.shape(&format!("`{name}` of a table"), "a number", ty, span, None);
        return None;
    };
    if let Some(dim) = dim.unify(Dim::Of(unit.dimension)) {
        return Some(if column.unit.is_none() { Dimension::NUMBER } else { dim.known() });
    }
    let (what, want) = (format!("column `{name}`"), dim.known());
    if column.unit.is_none() {
        let unit = unit_of_given(cx, name).unwrap_or_else(|| cx.values.usual_unit(want));
        let help = Help::write(span, &[format!("{name} [{unit}]")]);
        cx.error(unit_missing(&what, want, span, None, help));
        return None;
    }
    let column =
        correction(want, unit.dimension).map(|_| format!("write `{name} [{}]`", cx.values.usual_unit(want)));
    // a torque that was given in newtons, or a force with a column for a torque
    let is_torque = want == Dimension::FORCE && unit.dimension == Dimension::TORQUE;
    let given = is_torque.then(|| cx.completed_given(name, unit.dimension)).flatten();
    let with_unit = (want == Dimension::NUMBER).then(|| unit_from_column(cx, name, unit.dimension)).flatten();
    let help = match (given, column) {
        _ if with_unit.is_some() => with_unit,
        (Some(given), Some(column)) => Some(format!("write `{given}` for a torque, or {column} for a force")),
        (_, column) => column,
    };
    let found = phrase(unit.dimension);
    cx.error(unit_mismatch(&what, &phrase(want), &found, span, help));
    None
}

/// ``write `given n = 60 rpm` `` where the value has no unit and the column has.
fn unit_from_column(cx: &Context<'_>, name: &str, dimension: Dimension) -> Option<String> {
    let Some(QuantityKind::Given(value)) = cx.names.quantities.get(name).map(|d| d.what) else { return None };
    let ExprKind::Number(number) = &value.kind else { return None };
    let column = table(cx.doc)?.columns.iter().find(|c| c.name.node == *name)?;
    let unit = column.unit.as_ref().filter(|_| number.unit.is_none() && dimension != Dimension::NUMBER)?;
    Some(format!("write `given {name} = {} {}`", number.text, unit.node))
}

/// Notes two rows of one name.
fn named_twice(cx: &mut Context<'_>, table: &Variants) {
    let Some(label) = table.columns.iter().position(|c| c.name.node == LABEL) else { return };
    let mut firsts: HashMap<&str, Span> = HashMap::new();
    for cell in table.rows.iter().filter_map(|row| row.cells.get(label)) {
        let name = cell.node.text();
        if let Some(first) = firsts.get(name) {
            cx.error(
                Diagnosis::advice("mech::request::variant_row", format!("two rows have the name `{name}`"))
                    .primary(cell.span, "again here")
                    .label(*first, "first here")
                    .help("give each row a name of its own"),
            );
        } else {
            firsts.insert(name, cell.span);
        }
    }
}

/// Reports rows that are longer or shorter than the header.
pub(crate) fn rows(cx: &mut Context<'_>, table: &Variants) {
    let columns = table.columns.len();
    if columns == 0 {
        // the header has an error, which is reported
        return;
    }
    let header = table.columns.iter().map(|c| c.name.span).reduce(|a, b| a.to(b));
    for row in table.rows.iter().filter(|row| row.cells.len() != columns) {
        let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let (found, columns) = (count(row.cells.len(), "number"), count(columns, "column"));
        cx.error(
            Diagnosis::error(
                "mech::request::variant_row",
                format!("this row has {found}, but the table has {columns}"),
            )
            .primary(row.span, &found)
            .label(header, &columns)
            .help(
                decimal_comma(table.columns.len(), row)
                    .unwrap_or_else(|| "write one number per column, separated by commas".into()),
            ),
        );
    }
    // a column of which an `expect` takes its values has numbers
    let label = table.columns.iter().position(|c| c.name.node == LABEL && !cx.used_by_expect(LABEL));
    let of_names: Vec<bool> = table.columns.iter().map(|c| is_undeclared(cx, c) && naming(cx, c)).collect();
    for row in &table.rows {
        let named = |(i, cell): &(usize, &Spanned<Cell>)| {
            // a column of names with another name is reported by its header
            matches!(cell.node, Cell::Name(_)) && Some(*i) != label && of_names.get(*i) != Some(&true)
        };
        if let Some((_, cell)) = row.cells.iter().enumerate().find(named) {
            let (name, place) = (cell.node.text().to_owned(), cell.span);
            let has_column = label.is_some();
            cx.error(
                Diagnosis::error("mech::request::variant_row", format!("`{name}` is not a number"))
                    .primary(place, "not a number")
                    .label(header, "the columns")
                    .help(if has_column {
                        "write a number here; the name of a row belongs in the column `variant`"
                    } else {
                        "write a number; to name the rows, add a column: `variant, …` in the header"
                    }),
            );
        }
    }
}
