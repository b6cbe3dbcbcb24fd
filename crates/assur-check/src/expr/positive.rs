//! Constants whose sign is given.

use crate::expr::context::Context;
use crate::values::format_value::format_value_like;
use assur_syntax::document::Expr;
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// A constant that must be greater than zero.
pub(crate) fn positive(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) -> Option<f64> {
    let value = cx.scalar_constant(expr, &Want(dimension), what)?;
    positive_value(cx, value, expr, dimension, what)
}

/// Reports a value that is not greater than zero.
pub(crate) fn positive_value(
    cx: &mut Context<'_>,
    value: f64,
    expr: &Expr,
    dimension: Dimension,
    what: &str,
) -> Option<f64> {
    if value > 0.0 && value.is_finite() {
        return Some(value);
    }
    let help = match dimension {
        Dimension::LENGTH => "write a positive length; give directions by points and angles",
        Dimension::MASS => "leave the mass out if it is negligible",
        Dimension::ACCELERATION => {
            let up = format_value_like(&cx.names, -value, dimension, expr);
            &format!("write its magnitude, `{what} {up}`: it points down; `{what} {up} @ 90 deg` points up")
        }
        _ => "write a value greater than zero, or leave it out",
    };
    let value = format_value_like(&cx.names, value, dimension, expr);
    cx.error(
        Diagnosis::error(
            "mech::geometry::not_positive",
            format!("{what} must be greater than zero; got {value}"),
        )
        .label(expr.span, &value)
        .help(help),
    );
    None
}

/// A constant that must not be less than zero.
pub(crate) fn not_negative(
    cx: &mut Context<'_>,
    expr: &Expr,
    dimension: Dimension,
    what: &str,
) -> Option<f64> {
    let value = cx.scalar_constant(expr, &Want(dimension), what)?;
    if value >= 0.0 && value.is_finite() {
        return Some(value);
    }
    let value = format_value_like(&cx.names, value, dimension, expr);
    let help = if dimension == Dimension::MASS {
        "a hole is no mass of its own: write what is left, with its own centre and inertia"
    } else {
        "write it without the minus, or leave it out"
    };
    cx.error(
        Diagnosis::error("mech::geometry::negative", format!("{what} must not be negative; got {value}"))
            .label(expr.span, &value)
            .help(help),
    );
    None
}

// What an expression is expected to be.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Want(pub Dimension);

impl Want {
    pub const NUMBER: Self = Self(Dimension::NUMBER);
    pub const ANGLE: Self = Self(Dimension::ANGLE);
    pub const LENGTH: Self = Self(Dimension::LENGTH);
    pub const ACCELERATION: Self = Self(Dimension::ACCELERATION);
}
