//! The acceleration of free fall.

use crate::expr::{
    context::Context,
    positive::{Want, positive},
    property::given_twice,
};
use assur_math::math::Vec2;
use assur_model::model::Gravity;
use assur_syntax::document::{Expr, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Enters gravity into the mechanism: down, unless directed.
pub(crate) fn gravity(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let mut first: Option<Span> = None;
    for statement in &doc.statements {
        let Statement::Gravity(value) = &statement.node else { continue };
        if let Some(first) = first {
            cx.error(given_twice("gravity", statement.span, first));
            continue;
        }
        first = Some(statement.span);
        if let Some(acceleration) = acceleration(cx, value) {
            cx.builder.mech.gravity = Some(Gravity { acceleration, span: statement.span });
        }
    }
}

fn acceleration(cx: &mut Context<'_>, value: &Expr) -> Option<Vec2> {
    if !cx.is_vector(value)? {
        return Some(Vec2::new(0.0, -positive(cx, value, Dimension::ACCELERATION, "gravity")?));
    }
    let acceleration = cx.vector_constant(value, &Want::ACCELERATION, "gravity")?;
    if acceleration.unit().is_none() {
        cx.error(
            Diagnosis::error("mech::geometry::load_form", "gravity is zero and has no direction")
                .label(value.span, "does not fit here")
                .help("leave the statement out where nothing falls"),
        );
        return None;
    }
    Some(acceleration)
}
