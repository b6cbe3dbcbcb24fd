//! Drives whose position is an expression of the instant.

use crate::expr::context::Context;
use assur_model::model::{Expr, Function, Positions, Query};
use assur_syntax::document::{Drive, DrivePosition};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Whether the one position depends on the instant.
pub(crate) fn follows_time(positions: &Positions) -> bool {
    let Positions::List(list) = positions else { return false };
    let mut timed = false;
    list.iter().for_each(|expr| expr.queries(&mut |query| timed |= *query == Query::Time));
    timed && list.len() == 1
}

/// Reports rates that are written beside an expression that has its own.
pub(crate) fn own_rates(cx: &mut Context<'_>, drive: &Drive, name: &str) {
    let written = [drive.rate.as_ref(), drive.acceleration.as_ref()];
    let span = written.into_iter().flatten().map(|rate| rate.value.span).next();
    let span = span.or(drive.direction.as_ref().map(|direction| direction.span));
    let position = match &drive.position {
        Some(DrivePosition::Values(values)) => values.first().map(|value| value.value.span),
        _ => None,
    };
    if let Some((again, first)) = span.zip(position) {
        cx.error(
            Diagnosis::error(
                "mech::simulate::twice",
                format!(
                    "the rate of `{name}` is given twice: it is the derivative of its \
                     position, which depends on `time`"
                ),
            )
            .primary(again, "again here")
            .label(first, "has its own rate")
            .help("leave out `at …` and `accelerating …`"),
        );
    }
}

/// Whether the expression can be differentiated; notes what cannot be yet.
pub(crate) fn differentiable(cx: &mut Context<'_>, expr: &Expr, span: Span) -> bool {
    let mut missing = false;
    if !follows_time(&Positions::List(vec![expr.clone()])) {
        return true;
    }
    expr.parts(&mut |part| {
        missing |= match part {
            Expr::Constant(_)
            | Expr::Negate(_)
            | Expr::Binary(..)
            | Expr::Power(..)
            | Expr::Query(_)
            | Expr::Vector(..)
            | Expr::Polar(..)
            | Expr::Component(..)
            | Expr::Curve(..) => false,
            Expr::Call(function, _) => matches!(
                function,
                Function::Mag | Function::Dot | Function::Cross | Function::Unit | Function::Direction
            ),
            _ => true,
        };
    });
    if missing {
        cx.builder.unsupported(
            "a position of a drive made of magnitudes or products of vectors that \
             depend on `time`",
            span,
        );
    }
    true
}
