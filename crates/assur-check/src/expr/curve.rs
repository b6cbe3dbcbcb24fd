//! Curves: tables of values, and calls of them.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::QuantityKind;
use crate::names::suggestion::{not_declared, suggestion, wrong_kind};
use crate::statements::comma::decimal_comma;
use crate::values::fold;
use crate::values::store::CheckedCurve;
use crate::values::typed::{Dim, Type, Typed, phrase};
use crate::values::unit_use::display_in;
use assur_math::math::{Between, Beyond, TableFault, TableFunction};
use assur_model::model::{Curve, CurvePart, Value};
use assur_syntax::document::{
    self, Cell, Column, CurveBetween, CurveBeyond, Expr, ExprKind, Name, Row, Statement,
};
use assur_text::diagnostic::Diagnosis;
use assur_text::diagnostic::Fix;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::{Dimension, Unit};
use std::sync::Arc;

/// Reads all curves of the file.
pub fn curves(cx: &mut Context<'_>) {
    let all: Vec<&document::Curve> = cx.names.quantities.values().filter_map(|d| curve_of(d.what)).collect();
    for curve in all {
        if let Some(checked) = checked(cx, curve) {
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
    let function = Function::named(&name.node);
    if function.is_some_and(Function::yields_to_curve) {
        let (name, span) = (&name.node, name.span);
        cx.error(
            Diagnosis::warning(
                "mech::curve::name",
                format!("`{name}` is a function of the language; in this file it is the curve"),
            )
            .label(span, "goes before the function")
            .help(format!("give the curve another name, as in `curve {name}_1 {{`, to use the function")),
        );
    } else if function.is_some() {
        let (name, span) = (&name.node, name.span);
        cx.error(
            Diagnosis::error(
                "mech::curve::name",
                format!("`{name}` is a function of the language, and cannot name a curve"),
            )
            .primary(span, "already a function")
            .help(format!("give the curve another name, as in `curve {name}_1 {{`")),
        );
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
            let help = "a curve has an argument and a value, as in `phi [deg], p [MPa]`: write \
                        one curve per value";
            cx.error(
                Diagnosis::error("mech::curve::table", format!("curve `{}`: {message}", curve.name.node))
                    .primary(span, "this header")
                    .help(help),
            );
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

/// `1 number`, `3 numbers`
fn numbers(count: usize) -> String {
    format!("{count} number{}", if count == 1 { "" } else { "s" })
}

/// The numbers as written.
fn points(cx: &mut Context<'_>, curve: &document::Curve) -> Option<Vec<(f64, f64)>> {
    let mut points = Vec::new();
    for row in &curve.table.rows {
        let [x, y] = row.cells.as_slice() else {
            let message = format!("this row has {}, not two", numbers(row.cells.len()));
            let help = decimal_comma(2, row)
                .unwrap_or_else(|| "a row is an argument and its value, as in `90, 4.2`".into());
            cx.error(
                Diagnosis::error("mech::curve::table", format!("curve `{}`: {message}", curve.name.node))
                    .primary(row.span, "this row")
                    .help(help),
            );
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
                cx.error(
                    Diagnosis::error("mech::curve::table", format!("curve `{}`: {message}", curve.name.node))
                        .primary(span, "this word")
                        .help(help),
                );
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
        TableFault::Short => {
            let s = if rows.len() == 1 { "" } else { "s" };
            let message = format!("curve `{name}`: it has {} row{s}, but needs two", rows.len());
            Diagnosis::error("mech::curve::table", message)
                .primary(span, "too few")
                .help("add rows of argument and value, each on a line of its own")
        }
        TableFault::TooLarge => {
            let message = format!("curve `{name}`: its numbers are too large, or too close together");
            Diagnosis::error("mech::curve::table", message)
                .primary(curve.name.span, "this curve")
                .help("choose other units in its header")
        }
        TableFault::Order(i) => {
            let (before, here) = (cell(rows.get(i - 1), 0), cell(rows.get(i), 0));
            let does = format!("do not rise: {before} is followed by {here}");
            Diagnosis::error("mech::curve::order", format!("the arguments of curve `{name}` {does}"))
                .primary(rows[i].span, format!("not above {before}"))
                .label(rows[i - 1].span, before)
                .help(
                    "sort the rows by their first number, and give each argument once; a jump takes two arguments \
                     close together",
                )
        }
        TableFault::Ends => {
            let (first, last) = (cell(rows.first(), 1), cell(rows.last(), 1));
            let write = format!("write `{}, {first}`", cell(rows.last(), 0));
            let does = format!("is periodic, but begins with {first} and ends with {last}");
            Diagnosis::error("mech::curve::ends", format!("curve `{name}` {does}"))
                .primary(span, format!("should end with {first}"))
                .help(format!(
                    "the last row belongs to the same place as the first, one period on: {write}, add a row, or \
                     leave out `periodic`"
                ))
                .fixes(Fix::quoted(&write, span))
        }
    });
}

impl Context<'_> {
    /// Whether the file has a curve of that name.
    pub(crate) fn is_curve(&self, name: &str) -> bool {
        self.names.quantities.get(name).is_some_and(|d| curve_of(d.what).is_some())
    }

    /// Reports a header without units, once, where the curve is asked at a quantity that has one.
    fn header_without_units(&mut self, name: &Name, argument: &Typed) -> bool {
        let found = argument.ty.dimension();
        let header = self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Curve(curve) if curve.name.node == name.node => Some(curve.table.columns.as_slice()),
            _ => None,
        });
        let Some([x, y]) = header else { return false };
        if found == Dimension::NUMBER || argument.pending || x.unit.is_some() {
            return false;
        }
        if self.problems.reported.insert(("header", name.node.clone())) {
            let (first, second) = (&x.name.node, &y.name.node);
            let unit = self.values.usual_unit(found);
            let value = y.unit.as_ref().map_or_else(|| second.clone(), |u| format!("{second} [{}]", u.node));
            let more = if y.unit.is_none() { ", and a unit for its values" } else { "" };
            let help = format!("write `{first} [{unit}], {value}`{more}");
            self.error(
                Diagnosis::error(
                    "mech::unit::missing",
                    format!("the argument `{first}` of curve `{}` needs a unit of angle", name.node)
                        .replace("angle", phrase(found).trim_start_matches("an ").trim_start_matches("a ")),
                )
                .primary(x.name.span, "without a unit")
                .help(help),
            );
        }
        true
    }

    /// A call of a curve.
    pub(crate) fn curve(&mut self, call: Call<'_>, part: CurvePart) -> Option<Typed> {
        self.names.note_quantity(call.name);
        let args = self.arguments(call, 1, 1)?;
        let argument = self.read(args[0]);
        let checked = self.values.curves.get(&call.name.node)?.clone();
        self.builder.mech.has_curves = true;
        let what = format!("the argument of curve `{}`", call.name.node);
        let argument = argument?;
        if checked.argument == Dimension::NUMBER && self.header_without_units(call.name, &argument) {
            return None;
        }
        let t = self.fit(argument, checked.argument, &what, args[0])?;
        let curve = &checked.curve;
        if let Some(Value::Scalar(x)) = t.value()
            && !curve.function.covers(x)
        {
            let argument = curve.shown(x);
            let extent = curve.extent();
            self.error(
                Diagnosis::error(
                    "mech::curve::outside",
                    format!(
                        "curve `{}` has no value at {argument}: its table goes from {extent}",
                        curve.name
                    ),
                )
                .primary(args[0].span, &argument)
                .label(curve.span, &extent)
                .help(
                    "add rows, or write `periodic` after its name if it begins again, or \
                     `held` if its end values hold beyond the table",
                ),
            );
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
                wrong_kind(&name, is, "a curve", span, Some(at), help)
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
        self.error(
            Diagnosis::error("mech::curve::slope", "`slope` takes a call of a curve")
                .primary(found.span, "not a call of a curve")
                .help(help),
        );
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
