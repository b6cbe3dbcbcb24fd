//! Numbers or vectors: what the value of an expression is, whatever it is.

use super::{Answer, BinaryOp, Expr, Function, Load, Mechanism, Value};

impl Mechanism {
    /// For each quantity, whether it is a vector.
    #[must_use]
    pub fn vector_quantities(&self) -> Vec<bool> {
        // they stand in the order in which one depends on another
        let mut known = Vec::with_capacity(self.quantities.len());
        for quantity in &self.quantities {
            let vector = self.is_vector(&quantity.expr, &known);
            known.push(vector);
        }
        known
    }

    /// Whether the value of an expression is a vector; `known` says it of the quantities that it depends on.
    #[must_use]
    pub fn is_vector(&self, expr: &Expr, known: &[bool]) -> bool {
        let is = |e: &Expr| self.is_vector(e, known);
        match expr {
            Expr::Constant(value) => matches!(value, Value::Vector(_)),
            Expr::Vector(..) | Expr::Polar(..) => true,
            Expr::Negate(a) | Expr::Frictionless(a) | Expr::Binary(BinaryOp::Div, a, _) => is(a),
            Expr::Binary(_, a, b) => is(a) || is(b),
            Expr::Call(function, _) => *function == Function::Unit,
            Expr::Quantity(id) => known.get(id.index()).copied().unwrap_or(false),
            Expr::Query(query) => match query.facts().answer {
                Answer::Vector => true,
                Answer::Number | Answer::Condition => false,
                Answer::Load(id) => self.loads.get(id.index()).is_some_and(Load::is_vector),
            },
            Expr::Component(..)
            | Expr::Power(..)
            | Expr::Compare(..)
            | Expr::And(..)
            | Expr::Or(..)
            | Expr::Not(_)
            | Expr::Curve(..) => false,
        }
    }

    /// Whether the value of an expression is a condition.
    #[must_use]
    pub fn is_condition(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Constant(value) => matches!(value, Value::Bool(_)),
            Expr::Compare(..) | Expr::And(..) | Expr::Or(..) | Expr::Not(_) => true,
            Expr::Frictionless(a) => self.is_condition(a),
            Expr::Quantity(id) => self.quantities.get(id.index()).is_some_and(|q| self.is_condition(&q.expr)),
            Expr::Query(query) => query.facts().answer == Answer::Condition,
            Expr::Vector(..)
            | Expr::Polar(..)
            | Expr::Negate(_)
            | Expr::Binary(..)
            | Expr::Call(..)
            | Expr::Component(..)
            | Expr::Power(..)
            | Expr::Curve(..) => false,
        }
    }
}
