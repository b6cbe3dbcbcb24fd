//! What loads may act in a run, and on what they depend: a condition on time that stays as it is from the first instant to the last
//! is none, and a load of zero acts nowhere.

use super::equations::Equations;
use super::loads::loads_need_angles;
use crate::answer::switches;
use crate::model::{BinaryOp, Comparison, Expr, Load, LoadId, Mechanism, Query, Value};

/// Calls `look` on all parts of some expressions, through the quantities that they name, each of which is gone through once.
pub(super) fn all_parts<'m>(
    mechanism: &'m Mechanism,
    exprs: impl Iterator<Item = &'m Expr>,
    mut look: impl FnMut(&'m Expr),
) {
    let mut waiting: Vec<&Expr> = exprs.collect();
    let mut named = vec![false; mechanism.quantities.len()];
    while let Some(expr) = waiting.pop() {
        look(expr);
        match expr {
            _ if is_zero(mechanism, expr) => continue,
            Expr::Quantity(id) if !std::mem::replace(&mut named[id.index()], true) => {
                waiting.push(&mechanism.quantities[id.index()].expr);
            }
            _ => {}
        }
        expr.children(&mut |part| waiting.push(part));
    }
}

/// Whether a value is zero by a factor that is.
pub(super) fn is_zero(mechanism: &Mechanism, expr: &Expr) -> bool {
    match expr {
        Expr::Constant(Value::Scalar(x)) => *x == 0.0,
        Expr::Negate(a) | Expr::Binary(BinaryOp::Div, a, _) => is_zero(mechanism, a),
        Expr::Binary(BinaryOp::Mul, a, b) => is_zero(mechanism, a) || is_zero(mechanism, b),
        Expr::Vector(a, b) => is_zero(mechanism, a) && is_zero(mechanism, b),
        Expr::Quantity(id) => is_zero(mechanism, &mechanism.quantities[id.index()].expr),
        _ => false,
    }
}

/// A value that is linear in time: at 0 s, and by how much it grows in a second.
fn linear(mechanism: &Mechanism, expr: &Expr) -> Option<(f64, f64)> {
    let of = |expr: &Expr| linear(mechanism, expr);
    Some(match expr {
        Expr::Constant(Value::Scalar(x)) => (*x, 0.0),
        Expr::Query(Query::Time) => (0.0, 1.0),
        Expr::Quantity(id) => of(&mechanism.quantities[id.index()].expr)?,
        Expr::Negate(a) => of(a).map(|(x, v)| (-x, -v))?,
        Expr::Binary(op, a, b) => match (op, of(a)?, of(b)?) {
            (BinaryOp::Add, a, b) => (a.0 + b.0, a.1 + b.1),
            (BinaryOp::Sub, a, b) => (a.0 - b.0, a.1 - b.1),
            (BinaryOp::Mul, (a, 0.0), (x, v)) | (BinaryOp::Mul, (x, v), (a, 0.0)) => (a * x, a * v),
            (BinaryOp::Div, (x, v), (a, 0.0)) => (x / a, v / a),
            _ => return None,
        },
        _ => return None,
    })
}

/// Whether a condition is true, or is false, at every instant from one to another, s.
fn always(mechanism: &Mechanism, condition: &Expr, run: (f64, f64)) -> Option<bool> {
    let of = |expr: &Expr| always(mechanism, expr, run);
    match condition {
        Expr::Constant(Value::Bool(truth)) => Some(*truth),
        Expr::Quantity(id) => of(&mechanism.quantities[id.index()].expr),
        Expr::Not(a) => of(a).map(|truth| !truth),
        Expr::And(a, b) => either(of(a), of(b), false),
        Expr::Or(a, b) => either(of(a), of(b), true),
        Expr::Compare(comparison, a, b) => {
            let (a, b) = (linear(mechanism, a)?, linear(mechanism, b)?);
            let truth = |t: f64| {
                let [a, b] = [a, b].map(|(x, v)| x + v * t);
                match comparison {
                    Comparison::Less => a < b,
                    Comparison::LessEqual => a <= b,
                    Comparison::Greater => a > b,
                    Comparison::GreaterEqual => a >= b,
                }
            };
            (truth(run.0) == truth(run.1)).then(|| truth(run.0))
        }
        _ => None,
    }
}

/// One of two conditions decides on both where it has this truth.
fn either(a: Option<bool>, b: Option<bool>, truth: bool) -> Option<bool> {
    if a == Some(truth) || b == Some(truth) {
        Some(truth)
    } else {
        (a.is_some() && b.is_some()).then_some(!truth)
    }
}

impl<'a> Equations<'a, '_> {
    /// The run goes on up to an instant, s: what does not act until then needs nothing, and what does not change is no corner.
    pub fn goes_until(&mut self, last: f64) {
        self.last = last;
        let (mechanism, run) = (self.model.mechanism, (self.from, last));
        let exprs: Vec<&Expr> = self.acting().flat_map(|(_, _, exprs)| exprs).collect();
        self.loads_need_angles = loads_need_angles(mechanism, exprs.iter().copied());
        self.switches = switches(mechanism, exprs);
        self.switches.retain(|switch| always(mechanism, switch.expr(), run).is_none());
    }

    /// The loads that may act, with what they depend on.
    pub fn acting(&self) -> impl Iterator<Item = (LoadId, &'a Load, Vec<&'a Expr>)> {
        let (mechanism, run) = (self.model.mechanism, (self.from, self.last));
        mechanism.loads.iter().enumerate().filter_map(move |(index, load)| {
            let decided = load.when.as_ref().and_then(|when| always(mechanism, when, run));
            if decided == Some(false) || is_zero(mechanism, load.value()) {
                return None;
            }
            let when = load.when.as_ref().filter(|_| decided.is_some());
            let exprs = load.expressions().filter(|expr| !when.is_some_and(|when| std::ptr::eq(when, *expr)));
            Some((LoadId::at(index), load, exprs.collect()))
        })
    }
}
