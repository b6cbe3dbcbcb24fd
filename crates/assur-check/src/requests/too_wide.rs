//! Tolerances that any value would meet.

use crate::expr::context::Context;
use crate::statements::walk;
use crate::values::format_value::{digits, format_value, format_value_like};
use crate::values::typed::Type;
use assur_syntax::document::{Expr, ExprKind, Number, Statement};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Span;
use assur_text::units::{Dimension, lookup};
use std::f64::consts::PI;

/// A part of the value that is no less than all of it: zero and the opposite sign would pass.
pub(crate) fn relative(cx: &mut Context<'_>, within: &Expr, size: f64, ty: Type) -> Option<()> {
    if size < 1.0 {
        return Some(());
    }
    let percent = match &within.kind {
        ExprKind::Number(Number { text, unit: None, .. }) if size < 100.0 => format!("{text} %"),
        _ => "3 %".to_owned(),
    };
    let unit = cx.values.usual_unit(ty.dimension());
    let absolute = match &within.kind {
        ExprKind::Number(Number { text, unit: None, .. }) if !unit.is_empty() => {
            format!(", or `within {text} {unit}` if that is meant")
        }
        _ => String::new(),
    };
    let why = format!("it is {} % of the value, so zero would pass", digits(size * 100.0));
    let words = format!("write `within {percent}`{absolute}");
    let help = Help::write(within.span, &[percent]).in_words(words);
    cx.error(any_value(&why, within.span, help));
    None
}

/// Half a turn: angles are compared modulo a turn, so that none differ by more.
pub(crate) fn turn(cx: &mut Context<'_>, span: Span, size: f64, ty: Type) -> Option<()> {
    let angle = matches!(ty, Type::Number(_)) && ty.dimension() == Dimension::ANGLE;
    if !angle || size < PI {
        return Some(());
    }
    let why = format!(
        "it is {}, and two angles differ by at most half a turn",
        format_value(size, Dimension::ANGLE)
    );
    cx.error(any_value(&why, span, "write `within 1 deg`".into()));
    None
}

/// No less than the expected values and than every value of that dimension that the file writes.
pub(crate) fn absolute(
    cx: &mut Context<'_>,
    within: &Expr,
    size: f64,
    expected: &[f64],
    ty: Type,
) -> Option<()> {
    let dimension = ty.dimension();
    let most = expected.iter().copied().fold(0.0, f64::max);
    if size < most || dimension == Dimension::ANGLE {
        return Some(());
    }
    let most = most.max(greatest_written(cx, dimension));
    if most == 0.0 || size < most {
        return Some(());
    }
    let is = format_value_like(&cx.names, size, dimension, within);
    let greatest = format_value_like(&cx.names, most, dimension, within);
    let why = format!("{is} is no less than the greatest such value in the file, {greatest}");
    let help = if expected.contains(&0.0) {
        instead(within.span, &format_value_like(&cx.names, most * 1e-3, dimension, within))
    } else {
        instead(within.span, "3 %")
    };
    cx.error(any_value(&why, within.span, help));
    None
}

/// Another tolerance in the place of this.
fn instead(at: Span, size: &str) -> Help {
    Help::write(at, &[size.to_owned()]).in_words(format!("write `within {size}`"))
}

/// The greatest number of a dimension that stands in the file, tolerances left out; SI.
fn greatest_written(cx: &Context<'_>, dimension: Dimension) -> f64 {
    let mut most = 0.0_f64;
    for statement in &cx.doc.statements {
        let tolerance = match &statement.node {
            Statement::Expect(e) => e.within.as_ref().map(|w| w.span),
            _ => None,
        };
        walk::expressions(&statement.node, &mut |expr| {
            if Some(expr.span) == tolerance {
                return;
            }
            walk::parts(expr, &mut |part| {
                if let ExprKind::Number(Number { value, unit: Some(word), .. }) = &part.kind
                    && let Ok(unit) = lookup(&word.node)
                    && unit.dimension == dimension
                {
                    most = most.max(unit.to_si(*value).abs());
                }
            });
        });
    }
    most
}

/// A tolerance that any value would meet.
fn any_value(why: &str, span: Span, help: Help) -> Diagnosis {
    Diagnosis::error("mech::expect::any_value", format!("any value would meet this tolerance: {why}"))
        .primary(span, "too wide")
        .help(help)
}
