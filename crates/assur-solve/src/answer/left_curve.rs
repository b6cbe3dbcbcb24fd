//! Curves that are asked for a value beyond their tables.

use super::pose_answers::PoseAnswers;
use crate::model::{Curve, Expr};
use std::sync::Arc;

/// A curve, and the argument at which it has no value.
#[derive(Clone, Debug)]
pub struct LeftCurve {
    pub curve: Arc<Curve>,
    /// The argument, SI.
    pub argument: f64,
}

impl PoseAnswers<'_> {
    /// The first curve in an expression, or in the quantities it names, that has no value at this position.
    pub(crate) fn left_curve(&self, expr: &Expr) -> Option<LeftCurve> {
        let mut left = None;
        expr.parts(&mut |part| {
            if left.is_some() {
                return;
            }
            left = match part {
                Expr::Quantity(id) => {
                    let quantity = self.mechanism.quantities.get(id.index());
                    quantity.and_then(|quantity| self.left_curve(&quantity.expr))
                }
                Expr::Curve(curve, _, x) => {
                    let argument = self.scalar(x);
                    let outside = argument.is_finite() && !curve.function.covers(argument);
                    outside.then(|| LeftCurve { curve: curve.clone(), argument })
                }
                _ => None,
            };
        });
        left
    }

    /// The first curve that a load needs beyond its table.
    pub(crate) fn left_by_loads(&self) -> Option<LeftCurve> {
        self.mechanism.loads.iter().find_map(|load| match &load.when {
            Some(when) => self.left_curve(when).or_else(|| {
                let acts = self.truth(when);
                if acts { self.left_curve(load.value()) } else { None }
            }),
            None => self.left_curve(load.value()),
        })
    }

    /// The first curve that an answer at every position needs beyond its table.
    pub(crate) fn left_by_answers(&self) -> Option<LeftCurve> {
        let finds = self.mechanism.finds.iter().filter_map(|find| match &find.kind {
            crate::model::FindKind::Value { expr, poseless: false, .. } => Some(expr),
            _ => None,
        });
        let quantities = self.mechanism.quantities.iter().map(|quantity| &quantity.expr);
        quantities.chain(finds).find_map(|expr| self.left_curve(expr))
    }
}
