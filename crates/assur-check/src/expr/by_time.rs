//! `20 rad/s*t`: the tonne is read where the time of a motion is meant.

use crate::expr::context::Context;
use crate::statements::written::written;
use crate::values::typed::{Dim, Type};
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Number};
use assur_text::source::Spanned;
use assur_text::units::Dimension;

const TONNE: &str = "*t";

impl Context<'_> {
    /// The expression with `time` in place of the unit `t`, where it is of the dimension that is due by that.
    pub(crate) fn by_time(&mut self, want: Dimension, expr: &Expr) -> Option<String> {
        if !self.names.simulates {
            return None;
        }
        let new = with_time(expr)?;
        let read = self.quietly(|cx| cx.read(&new))?;
        let fits = matches!(read.ty, Type::Number(dim) if dim.unify(Dim::Of(want)).is_some());
        let text = written(&new).filter(|_| fits)?;
        Some(format!("write `{text}`; the unit t is the tonne"))
    }
}

/// The expression with `time` in place of every unit `t`; `None` where it has none.
fn with_time(expr: &Expr) -> Option<Expr> {
    match &expr.kind {
        ExprKind::Number(number) => number_by_time(number, expr),
        ExprKind::Unary(op, inner) => {
            let inner = Box::new(with_time(inner)?);
            Some(Expr { kind: ExprKind::Unary(op.clone(), inner), span: expr.span })
        }
        ExprKind::Chain(first, rest) => {
            let new = |part: &Expr| with_time(part).unwrap_or_else(|| part.clone());
            let changed = Expr {
                kind: ExprKind::Chain(
                    Box::new(new(first)),
                    rest.iter().map(|(op, part)| (op.clone(), new(part))).collect(),
                ),
                span: expr.span,
            };
            (changed != *expr).then_some(changed)
        }
        _ => None,
    }
}

fn number_by_time(number: &Number, expr: &Expr) -> Option<Expr> {
    let unit = number.unit.as_ref()?;
    let (before, power) = unit.node.rsplit_once(TONNE)?;
    let span = expr.span;
    let at = |kind| Expr { kind, span };
    let time = at(ExprKind::Name("time".to_owned()));
    let factor = match power.strip_prefix('^') {
        Some(exponent) => {
            let value = exponent.parse().ok()?;
            let exponent = Number { value, text: exponent.to_owned(), unit: None };
            at(ExprKind::Power(Box::new(time), Box::new(at(ExprKind::Number(exponent)))))
        }
        None if power.is_empty() => time,
        None => return None,
    };
    let unit = Some(Spanned::new(before.to_owned(), unit.span));
    let number = at(ExprKind::Number(Number { unit, ..number.clone() }));
    let times = Spanned::new(BinaryOp::Multiply, span);
    Some(at(ExprKind::Chain(Box::new(number), vec![(times, factor)])))
}
