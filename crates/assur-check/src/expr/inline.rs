//! Expressions with their quantities written out.

use crate::expr::context::Context;
use crate::expr::no_value::undefined;
use assur_model::model;
use assur_text::source::Span;

/// The largest expression of a drive, in parts.
const LARGEST: usize = 2000;

impl Context<'_> {
    /// The expression with quantities that need no pose written out. Reports one that grows too large.
    pub(crate) fn inline(&mut self, expr: &model::Expr, span: Span) -> Option<model::Expr> {
        if self.values.definitions.size(expr) > LARGEST {
            self.error(undefined("with its definitions inserted it is too long", span, None));
            return None;
        }
        Some(self.written_out(expr))
    }

    fn written_out(&self, expr: &model::Expr) -> model::Expr {
        expr.map_leaves(&mut |leaf| match leaf {
            model::Expr::Quantity(id) if self.values.definitions.needs_no_pose(*id) => {
                self.written_out(&self.builder.mech.quantities[id.index()].expr)
            }
            other => other.clone(),
        })
    }
}
