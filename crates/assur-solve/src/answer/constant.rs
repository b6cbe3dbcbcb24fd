//! Values that need no position.

use super::pose_answers::PoseAnswers;
use super::whole_cycle::WholeCycle;
use crate::model::{Expr, Value};
use crate::position::{Scene, State};

/// Evaluates expressions that need no position.
pub(crate) fn constant(scene: &Scene<'_>, statics: &WholeCycle, expr: &Expr) -> Value {
    let state = State::new(scene.plan);
    let view = PoseAnswers::new(scene, &state, &[], statics);
    view.value(expr)
}
