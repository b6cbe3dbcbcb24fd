//! Values that need no position.

use super::view::View;
use super::whole_cycle::Statics;
use crate::model::{Expr, Value};
use crate::position::{Scene, State};

/// Evaluates expressions that need no position.
pub(crate) fn constant(scene: &Scene<'_>, statics: &Statics, expr: &Expr) -> Value {
    let state = State::new(scene.plan);
    let view = View::new(scene, &state, &[], statics);
    view.value(expr)
}
