//! How near an answer must be.

use crate::expr::context::{Context, not_constant};
use crate::names::declared::QuantityKind;
use crate::requests::{expect::words, too_wide};
use crate::values::typed::{Dim, Type, Typed};
use assur_model::model::{Expr as ModelExpr, Tolerance, Value};
use assur_syntax::document::{self, Expr, ExprKind, Number, UnaryOp};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::{Dimension, lookup};

/// The most an inferred tolerance may be, relative to the value.
pub(crate) const MOST: f64 = 0.01;

/// The tolerance of an equality: as written, or from the digits of the values.
pub(crate) fn tolerance(
    cx: &mut Context<'_>,
    expect: &document::Expect,
    values: &[Typed],
    ty: Type,
) -> Option<Tolerance> {
    match &expect.within {
        Some(within) => given(cx, expect, within, values, ty),
        None => inferred(cx, expect, values, ty),
    }
}

fn given(
    cx: &mut Context<'_>,
    expect: &document::Expect,
    within: &Expr,
    values: &[Typed],
    ty: Type,
) -> Option<Tolerance> {
    if let Some((span, result)) = cx.values.definitions.first_result(&cx.names, within) {
        let what = "a tolerance".to_owned();
        cx.error(not_constant(&what, &result, span));
        return None;
    }
    let t = cx.read(within)?;
    let Type::Number(dim) = t.ty else {
        cx.shape("a tolerance", "a number", t.ty, within.span, None);
        return None;
    };
    let Some(Value::Scalar(size)) = t.value() else { return None };
    if !(size > 0.0 && size.is_finite()) {
        cx.error(
            Diagnosis::error("mech::expect::tolerance", "a tolerance must be greater than zero")
                .primary(within.span, "not greater than zero")
                .help("write `within 1e-9`, `within 0.1 %`, or one with a unit"),
        );
        return None;
    }
    if dim.known() == Dimension::NUMBER {
        let plain = ty.dimension().is_number();
        let zero = values.iter().zip(&expect.values).find(|(v, _)| !v.pending && magnitude(v) == Some(0.0));
        if zero.is_none() || plain {
            too_wide::relative(cx, within, size, ty)?;
        }
        return match zero {
            // A share of zero is zero; of a plain number the tolerance has no unit that would tell.
            Some(_) if plain => Some(Tolerance::Absolute(size)),
            Some((_, expr)) => no_zero(cx, expr, ty),
            None => {
                for expected in values.iter().filter_map(magnitude) {
                    too_wide::turn(cx, within.span, size * expected, ty)?;
                }
                Some(Tolerance::Relative(size))
            }
        };
    }
    if dim.unify(Dim::Of(ty.dimension())).is_none() {
        let (text, is, found) = (expect.text.clone(), words(ty), words(t.ty));
        let unit = cx.values.usual_unit(ty.dimension());
        let unit = if unit.is_empty() { "no unit".into() } else { unit };
        cx.error(
            Diagnosis::error(
                "mech::expect::tolerance_unit",
                format!("the tolerance is {found}, but `{text}` is {is}"),
            )
            .primary(within.span, &found)
            .help(format!(
                "write a plain number or a percentage, both relative to the value, or a \
                 tolerance in {unit}"
            )),
        );
        return None;
    }
    too_wide::turn(cx, within.span, size, ty)?;
    let expected = values.iter().map(magnitude).collect::<Option<Vec<_>>>();
    if let Some(expected) = expected {
        too_wide::absolute(cx, within, size, &expected, ty)?;
    }
    Some(Tolerance::Absolute(size))
}

fn no_zero<T>(cx: &mut Context<'_>, expr: &Expr, ty: Type) -> Option<T> {
    let unit = cx.values.usual_unit(ty.dimension());
    let example = format!("1e-9 {unit}").trim_end().to_owned();
    cx.error(
        Diagnosis::error("mech::expect::zero", "an expected zero needs a tolerance with a unit")
            .primary(expr.span, "a relative tolerance of zero is zero")
            .help(format!("write `within {example}`")),
    );
    None
}

fn inferred(
    cx: &mut Context<'_>,
    expect: &document::Expect,
    values: &[Typed],
    ty: Type,
) -> Option<Tolerance> {
    let mut all = Vec::new();
    for (value, expr) in values.iter().zip(&expect.values) {
        if value.pending {
            return None;
        }
        let size = magnitude(value);
        if size == Some(0.0) {
            return no_zero(cx, expr, ty);
        }
        let (Some(digit), Some(size)) = (last_digit(cx, expr, 0), size) else {
            cx.error(
                Diagnosis::error("mech::expect::no_tolerance", "a tolerance is required here")
                    .primary(expr.span, "computed, not written as a number")
                    .help(
                        "add `within 1e-9`, `within 0.1 %`, or a tolerance with a unit: a \
                         computed value has no written digits",
                    ),
            );
            return None;
        };
        let size = digit.min(MOST * size);
        too_wide::turn(cx, expr.span, size, ty)?;
        all.push(size);
    }
    Some(Tolerance::Written(all))
}

fn magnitude(t: &Typed) -> Option<f64> {
    match t.expr {
        ModelExpr::Constant(Value::Scalar(x)) => Some(x.abs()),
        ModelExpr::Constant(Value::Vector(v)) => Some(libm::hypot(v.x, v.y)),
        _ => None,
    }
}

/// The greatest depth of names of `given` before a value.
const DEPTH: usize = 8;

/// One unit in the last digit written, in SI.
fn last_digit(cx: &Context<'_>, expr: &Expr, depth: usize) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(number) => digit_of(number),
        ExprKind::Unary(op, inner) if op.node != UnaryOp::Not => last_digit(cx, inner, depth),
        ExprKind::Vector(x, y) => {
            let digit = |e: &Expr| match &e.kind {
                // A bare zero says nothing.
                ExprKind::Number(n) if n.value == 0.0 && n.unit.is_none() => Some(0.0),
                _ => last_digit(cx, e, depth),
            };
            Some(digit(x)?.max(digit(y)?)).filter(|d| *d > 0.0)
        }
        ExprKind::Polar(r, phi) => {
            let (digit, turned) = (last_digit(cx, r, depth)?, last_digit(cx, phi, depth)?);
            let ExprKind::Number(Number { value, unit, .. }) = &r.kind else { return Some(digit) };
            let factor = unit.as_ref().map_or(Some(1.0), |u| lookup(&u.node).ok().map(|u| u.factor))?;
            Some(digit.max(value.abs() * factor * turned))
        }
        ExprKind::Name(name) if depth < DEPTH => {
            if let Some(digit) = cx.values.outside.digit_in_row(name) {
                return Some(digit);
            }
            let declared = cx.names.quantities.get(name)?;
            match declared.what {
                QuantityKind::Given(_) => last_digit(cx, cx.given_as_written(name)?, depth + 1),
                _ => None,
            }
        }
        _ => None,
    }
}

/// `0.350` mm is good to 0.001 mm, `1.5e3` to 100.
pub fn digit_of(number: &Number) -> Option<f64> {
    let (mantissa, exponent) = match number.text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (number.text.as_str(), 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len());
    let digit = format!("1e{}", i64::from(exponent) - i64::try_from(decimals).ok()?).parse::<f64>().ok()?;
    match &number.unit {
        Some(word) => lookup(&word.node).ok().map(|unit| unit.to_si(digit)),
        None => Some(digit),
    }
}
