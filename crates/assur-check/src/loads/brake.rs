//! Brakes: torques of friction against the motion.

use crate::expr::context::Context;
use crate::expr::property::read;
use crate::loads::load::moving;
use crate::trains::friction_torque::friction_torque;
use assur_model::model;
use assur_model::model::{Expr, LoadKind};
use assur_syntax::document::Brake;
use assur_text::language::BRAKE;
use assur_text::source::Span;

/// The load that a brake is.
pub(crate) fn brake(cx: &mut Context<'_>, brake: &Brake, span: Span) -> Option<model::Load> {
    let on = moving(cx, &brake.on, "a brake");
    let properties = read(cx, "a brake", &brake.properties, BRAKE)?;
    let value = Expr::number(friction_torque(cx, &brake.name, &properties)?);
    let kind = LoadKind::Torque { on: on?, value, against_motion: true };
    Some(model::Load { name: Some(brake.name.node.clone()), span, kind, when: None })
}
