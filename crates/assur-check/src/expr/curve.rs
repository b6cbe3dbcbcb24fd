//! Curves: tables of values, and calls of them.

use crate::error::CurveError;
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::QuantityKind;
use crate::names::suggestion::{not_declared, suggestion, wrong_kind};
use crate::values::fold;
use crate::values::store::CheckedCurve;
use crate::values::typed::{Dim, Type, Typed};
use crate::values::unit_use::display_in;
use assur_math::math::{Between, Beyond, TableFault, TableFunction};
use assur_model::model::{Curve, CurvePart, Value};
use assur_syntax::document::{self, Cell, Column, CurveBetween, CurveBeyond, Expr, ExprKind, Name, Row};
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::{Dimension, Unit};
use std::sync::Arc;

/// Reads all curves of the file.
pub fn curves(cx: &mut Context<'_>) {
    let all: Vec<&document::Curve> = cx.names.quantities.values().filter_map(|d| curve_of(d.what)).collect();
    for curve in all {
        if let Some(checked) = checked(cx, curve) {
            cx.builder.mech.has_curves = true;
            cx.values.curves.insert(curve.name.node.clone(), checked);
        }
    }
}

const fn curve_of(what: QuantityKind<'_>) -> Option<&document::Curve> {
    match what {
        QuantityKind::Curve(curve) => Some(curve),
        _ => None,
    }
}

fn checked(cx: &mut Context<'_>, curve: &document::Curve) -> Option<CheckedCurve> {
    let name = &curve.name;
    if Function::named(&name.node).is_some() {
        cx.error(CurveError::Name { name: name.node.clone(), span: name.span });
        return None;
    }
    let (x, y) = columns(cx, curve)?;
    let points = points(cx, curve)?;
    let between = match curve.between {
        None => Between::Monotone,
        Some(CurveBetween::Linear) => Between::Straight,
        Some(CurveBetween::Smooth) => Between::Spline,
    };
    let beyond = match curve.beyond {
        None => Beyond::Nothing,
        Some(CurveBeyond::Periodic) => Beyond::Repeated,
        Some(CurveBeyond::Held) => Beyond::Held,
    };
    let si: Vec<(f64, f64)> = points.iter().map(|(p, q)| (x.to_si(*p), y.to_si(*q))).collect();
    let function = match TableFunction::new(&si, between, beyond) {
        Ok(function) => function,
        Err(fault) => {
            wrong(cx, curve, fault);
            return None;
        }
    };
    let argument = display_in(&x);
    let curve = Curve { name: name.node.clone(), span: name.span, function, argument };
    Some(CheckedCurve { curve: Arc::new(curve), argument: x.dimension, value: y.dimension })
}

/// The units of argument and value.
fn columns(cx: &mut Context<'_>, curve: &document::Curve) -> Option<(Unit, Unit)> {
    let columns = &curve.table.columns;
    let [x, y] = columns.as_slice() else {
        // a header that does not read is reported
        if let (Some(first), Some(last)) = (columns.first(), columns.last()) {
            let span = first.name.span.to(last.unit.as_ref().map_or(last.name.span, |u| u.span));
            let message = format!("its header has {} names, not two", columns.len());
            let help =
                "a curve has an argument and a value, as in `phi [deg], p [MPa]`: write one curve per value"
                    .into();
            cx.error(CurveError::Table { name: curve.name.node.clone(), message, help, span });
        }
        return None;
    };
    let mut unit = |column: &Column| match &column.unit {
        Some(word) => cx.unit(word),
        None => Some(Unit::si(Dimension::NUMBER)),
    };
    let (x, y) = (unit(x), unit(y));
    Some((x?, y?))
}

/// The numbers as written.
fn points(cx: &mut Context<'_>, curve: &document::Curve) -> Option<Vec<(f64, f64)>> {
    let mut points = Vec::new();
    for row in &curve.table.rows {
        let [x, y] = row.cells.as_slice() else {
            let message = format!("this row has {} numbers, not two", row.cells.len());
            let help = "a row is an argument and its value, as in `90, 4.2`".to_owned();
            cx.error(CurveError::Table { name: curve.name.node.clone(), message, help, span: row.span });
            return None;
        };
        match (&x.node, &y.node) {
            (Cell::Number(x), Cell::Number(y)) => points.push((x.value, y.value)),
            (Cell::Name(word), _) | (_, Cell::Name(word)) => {
                let span = if matches!(x.node, Cell::Name(_)) { x.span } else { y.span };
                let message = format!("`{word}` is no number");
                let help = "the rows of a curve are plain numbers; a value that is computed goes in front of the call, \
                            as in `p_max*p(phi)`"
                    .to_owned();
                cx.error(CurveError::Table { name: curve.name.node.clone(), message, help, span });
                return None;
            }
        }
    }
    Some(points)
}

/// A number of a row as written.
fn cell(row: Option<&Row>, column: usize) -> String {
    row.and_then(|row| row.cells.get(column)).map_or_else(String::new, |cell| cell.node.text().to_owned())
}

fn wrong(cx: &mut Context<'_>, curve: &document::Curve, fault: TableFault) {
    let (name, rows) = (curve.name.node.clone(), &curve.table.rows);
    let span = rows.last().map_or(curve.name.span, |row| row.span);
    cx.error(match fault {
        TableFault::Short => CurveError::Table {
            name,
            message: format!("it has {} row{}, but needs two", rows.len(), if rows.len() == 1 { "" } else { "s" }),
            help: "add rows of argument and value, each on a line of its own".into(),
            span,
        },
        TableFault::TooLarge => CurveError::Table {
            name,
            message: "its numbers are too large, or too close together".into(),
            help: "choose other units in its header".into(),
            span: curve.name.span,
        },
        TableFault::Order(i) => CurveError::Order {
            name,
            before: cell(rows.get(i - 1), 0),
            here: cell(rows.get(i), 0),
            span: rows[i].span,
            last: rows[i - 1].span,
        },
        TableFault::Ends => {
            let (first, last) = (cell(rows.first(), 1), cell(rows.last(), 1));
            let at = cell(rows.last(), 0);
            let help = format!(
                "the last row belongs to the same place as the first, one period on: write `{at}, {first}`, add a row, or \
                 leave out `periodic`"
            );
            CurveError::Ends { name, first, last, help, span }
        }
    });
}

impl Context<'_> {
    /// Whether the file has a curve of that name.
    pub(crate) fn is_curve(&self, name: &str) -> bool {
        self.names.quantities.get(name).is_some_and(|d| curve_of(d.what).is_some())
    }

    /// A call of a curve.
    pub(crate) fn curve(&mut self, call: Call<'_>, part: CurvePart) -> Option<Typed> {
        self.names.note_quantity(call.name);
        let args = self.arguments(call, 1, 1)?;
        let argument = self.read(args[0]);
        let checked = self.values.curves.get(&call.name.node)?.clone();
        let what = format!("the argument of curve `{}`", call.name.node);
        let t = self.fit(argument?, checked.argument, &what, args[0])?;
        let curve = &checked.curve;
        if let Some(Value::Scalar(x)) = t.value()
            && !curve.function.covers(x)
        {
            self.error(CurveError::Outside {
                name: curve.name.clone(),
                argument: curve.shown(x),
                extent: curve.extent(),
                span: args[0].span,
                declared: curve.span,
            });
            return None;
        }
        let value = Dim::Of(checked.value);
        let dim = match part {
            CurvePart::Value => value,
            CurvePart::Slope => value.over(Dim::Of(checked.argument)),
        };
        let expr = fold::curve(curve, part, t.expr);
        Some(Typed { expr, ty: Type::Number(dim), pending: t.pending })
    }

    /// `slope(p(x))`
    pub(crate) fn slope(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        if let ExprKind::Call { function, args: inner } = &args[0].kind
            && self.is_curve(&function.node)
        {
            return self.curve(Call { name: function, args: inner, ..call }, CurvePart::Slope);
        }
        self.no_curve(args[0]);
        None
    }

    /// Reports a name that is not one of a curve.
    pub(crate) fn no_curve_of_name(&mut self, name: &Name) {
        if self.names.bad.contains(&name.node) {
            return;
        }
        let declared = self.names.quantities.get(&name.node).map(|d| (d.what.phrase(), d.span));
        let all = self.names.quantities.iter().filter(|(_, d)| curve_of(d.what).is_some());
        let all = all.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
        let help = suggestion(&name.node, name.span, &all, "curves");
        let (span, name) = (name.span, name.node.clone());
        self.error(match declared {
            Some((is, at)) => {
                let help = help.map(|help| help.to_string());
                wrong_kind(&name, &is, "a curve", span, Some(at), help)
            }
            None => not_declared("curve", &name, None, span, help),
        });
    }

    fn no_curve(&mut self, found: &Expr) {
        let mut curves = self.names.quantities.values().filter_map(|d| curve_of(d.what));
        let help = match curves.next() {
            Some(curve) => {
                let x = curve.table.columns.first().map_or("x", |c| c.name.node.as_str());
                format!("write `slope({}({x}))`", curve.name.node)
            }
            None => "declare a curve, as in `curve p { phi [deg], p [MPa]` with its rows, and write `slope(p(phi))`".into(),
        };
        self.error(CurveError::Slope { help, span: found.span });
    }

    /// Reports a curve that is not called.
    pub(crate) fn uncalled(&mut self, name: &str, curve: &document::Curve, span: Span) {
        let x = curve.table.columns.first().map_or("x", |c| c.name.node.as_str());
        self.error(wrong_kind(
            name,
            "a curve",
            "a value",
            span,
            Some(curve.name.span),
            Some(format!("write its argument behind it: `{name}({x})`")),
        ));
    }
}
