//! What loads may act in a run, and on what they depend: a condition on time that stays as it is from the first instant to the last
//! is none, and a load of zero acts nowhere.

use super::equations::Equations;
use super::loads::{all_parts, is_zero, loads_need_angles};
use crate::answer::switches;
use crate::model::{BinaryOp, Comparison, Expr, Load, LoadId, Mechanism, Query, Value};

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

/// Whether something changes while all rests: a drive moves, or a load depends on the instant.
pub(super) fn wakes(equations: &Equations<'_, '_>) -> bool {
    let mechanism = equations.model.mechanism;
    let mut timed = false;
    all_parts(mechanism, equations.acting().flat_map(|(_, _, exprs)| exprs), |part| {
        timed |= matches!(part, Expr::Query(Query::Time));
    });
    timed || mechanism.drives.iter().any(|d| !d.free && (d.speed.is_some() || d.acceleration.is_some()))
}

impl<'a> Equations<'a, '_> {
    /// The run goes on up to an instant, s: what does not act until then needs nothing, and what does not change is no corner.
    pub fn goes_until(&mut self, last: f64) {
        self.last = last;
        let (mechanism, run) = (self.model.mechanism, (self.from, last));
        let exprs: Vec<&Expr> = self.acting().flat_map(|(_, _, exprs)| exprs).collect();
        let is_condition = |expr: &&&Expr| {
            let own = mechanism.loads.iter().filter_map(|load| load.when.as_ref());
            own.into_iter().any(|when| std::ptr::eq(when, **expr))
        };
        let (conditions, values): (Vec<&Expr>, Vec<&Expr>) =
            exprs.iter().partition(|expr| is_condition(expr));
        self.loads_need_angles = loads_need_angles(mechanism, values.into_iter());
        self.conditions_need_angles = loads_need_angles(mechanism, conditions.into_iter());
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
