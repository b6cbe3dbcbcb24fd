//! How far a placed wheel is from the line of its rack: as far as its radius, and to the left.

use crate::expr::context::Context;
use crate::trains::rack::Sliding;
use crate::values::format_value::format_value;
use assur_math::math::Vec2;
use assur_model::model::{Line, Wheel};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// The distance may differ from the radius by this part.
const AGREES: f64 = 1e-6;

/// A point of the base, or of a link that slides on it.
pub(super) struct Placed {
    pub at: Vec2,
    pub on: Option<Sliding>,
}

impl Placed {
    /// How far it is to the left of the base's origin, along a line of this direction in the base.
    fn left(&self, teeth: Vec2) -> f64 {
        let Some(sliding) = self.on else { return teeth.cross(self.at) };
        let sense = sliding.on_base.dot(teeth).signum();
        teeth.cross(sliding.base_point) + sense * sliding.own.cross(self.at - sliding.own_point)
    }
}

/// Reports a wheel that does not touch its rack, or touches it from the right.
pub(super) fn distance(
    cx: &mut Context<'_>,
    (wheel, centre): (&Wheel, Placed),
    (line, own): (&Line, Option<Sliding>),
    teeth: Vec2,
    span: Span,
) -> Option<()> {
    let is_open = |s: &Option<Sliding>| s.is_some_and(|s| s.open);
    if wheel.open || is_open(&own) || is_open(&centre.on) {
        return Some(());
    }
    let left = centre.left(teeth) - Placed { at: line.through, on: own }.left(teeth);
    let agrees = |left: f64| (left - wheel.radius).abs() <= AGREES * wheel.radius;
    if agrees(left) {
        return Some(());
    }
    let length = |x| format_value(x, Dimension::LENGTH);
    let (message, help) = if agrees(-left) {
        let name = &line.name;
        (
            format!(
                "`{}` is to the right of the line `{name}`, and a rack has its wheel to the left",
                wheel.name
            ),
            format!("turn `{name}` round: add 180 deg to its direction, or exchange its two points"),
        )
    } else {
        (
            format!(
                "the axis of `{}` is {} from the line `{}`, but its radius is {}",
                wheel.name,
                length(left.abs()),
                line.name,
                length(wheel.radius)
            ),
            "move the axis or the line, or change the radius".to_owned(),
        )
    };
    cx.error(
        Diagnosis::error("mech::train::centre_distance", message).primary(span, "cannot touch").help(help),
    );
    None
}
