//! `variants`: names and units of the columns.

use super::context::Context;
use super::definition::Settled;
use super::error::{NameError, RequestError, UnitsError};
use super::expr::typed::{Dim, Type, mend, phrase};
use super::lookup::suggestion;
use super::names::QuantityKind;
use crate::syntax::document::{Column, Statement, Variants};
use crate::units::{Dimension, Unit};

/// Checks the table of variants, and notes that it cannot be run yet.
pub(super) fn variants(cx: &mut Context<'_>) {
    for statement in &cx.doc.statements {
        let Statement::Variants(table) = &statement.node else { continue };
        for (i, column) in table.columns.iter().enumerate() {
            match table.columns[..i].iter().find(|c| c.name.node == column.name.node) {
                Some(first) => cx.error(NameError::duplicate(&column.name, first.name.span)),
                None => check_column(cx, column),
            }
        }
        rows(cx, table);
        cx.unsupported("variants", statement.span);
    }
}

fn check_column(cx: &mut Context<'_>, column: &Column) {
    let unit = match &column.unit {
        Some(word) => {
            let Some(unit) = cx.unit(word) else { return };
            unit
        }
        None => Unit::si(Dimension::NUMBER),
    };
    let name = &column.name;
    match cx.names.quantities.get(&name.node).map(|d| d.what) {
        Some(QuantityKind::Given(_)) => {
            let Some(Settled::Constant(t)) = cx.settled(&name.node) else { return };
            let ty = t.ty;
            fits(cx, column, ty, &unit);
        }
        Some(QuantityKind::Column(_)) => {
            if !cx.used_by_expect(&name.node) {
                unknown(cx, column);
            }
        }
        Some(kind) => {
            let is = kind.phrase().to_owned();
            cx.error(NameError::WrongKind {
                name: name.node.clone(),
                is,
                wanted: "a `given`".into(),
                span: name.span,
                declared: cx.names.quantities.get(&name.node).map(|d| d.span),
                help: Some("a row of variants replaces the values of `given`".into()),
            });
        }
        None => unknown(cx, column),
    }
}

fn unknown(cx: &mut Context<'_>, column: &Column) {
    let name = &column.name;
    let told = cx.names.bad.contains(&name.node) || cx.reported.contains(&("quantity", name.node.clone()));
    if told || !cx.reported.insert(("given", name.node.clone())) {
        return;
    }
    let given = cx.names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Given(_)));
    let given = given.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
    let help = suggestion(&name.node, &given, "`given` of this file");
    let (name, span) = (name.node.clone(), name.span);
    cx.error(NameError::Unknown { kind: "given", name, place: String::new(), span, help });
}

fn fits(cx: &mut Context<'_>, column: &Column, ty: Type, unit: &Unit) {
    let name = &column.name.node;
    let span = column.unit.as_ref().map_or(column.name.span, |u| u.span);
    let Type::Number(dim) = ty else {
        cx.shape(&format!("`{name}` of a table"), "a number", ty, span, None);
        return;
    };
    if dim.unify(Dim::Of(unit.dimension)).is_some() {
        return;
    }
    let (what, want) = (format!("column `{name}`"), dim.known());
    if column.unit.is_none() {
        let example = format!("`{name} [{}]`", cx.usual_unit(want));
        cx.error(UnitsError::Missing { what, want, span, example });
        return;
    }
    let help = mend(want, unit.dimension).map(|_| format!("write `{name} [{}]`", cx.usual_unit(want)));
    let found = phrase(unit.dimension);
    cx.error(UnitsError::Mismatch { what, want: phrase(want), found, span, help });
}

/// Reports rows that are longer or shorter than the header.
fn rows(cx: &mut Context<'_>, table: &Variants) {
    let columns = table.columns.len();
    let header = table.columns.iter().map(|c| c.name.span).reduce(|a, b| a.to(b));
    for row in table.rows.iter().filter(|row| row.cells.len() != columns) {
        let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let (found, columns) = (count(row.cells.len(), "number"), count(columns, "column"));
        cx.error(RequestError::VariantRow { found, columns, span: row.span, header });
    }
}
