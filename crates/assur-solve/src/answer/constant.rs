//! Values that need no position.

use super::pose_answers::PoseAnswers;
use super::whole_cycle::WholeCycle;
use crate::model::{Expr, Value};
use crate::position::{Model, State};

/// Evaluates expressions that need no position.
pub(crate) fn constant(model: &Model<'_>, statics: &WholeCycle, expr: &Expr) -> Value {
    if let Expr::Constant(value) = expr {
        return *value;
    }
    let state = State::new(model.plan);
    let view = PoseAnswers::new(model, &state, &[], statics);
    view.value(expr)
}
