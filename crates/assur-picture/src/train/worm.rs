//! Worms: seen from their end in section, on their shafts across their wheels in front view.

use super::layout::{Drawn, Layout, wheel_named};
use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Transmission, TransmissionKind};

/// From the pitch circle of a wheel to the axis of its worm.
const AXIS: f64 = 3.0;

/// The drawn wheel that a worm turns.
pub fn wheel(mechanism: &Mechanism, layout: &Layout, t: &Transmission) -> Option<usize> {
    let index = wheel_named(mechanism, t.ends.get(1)?)?;
    layout.wheels.iter().position(|w| w.wheel == index)
}

fn worms(mechanism: &Mechanism) -> impl Iterator<Item = &Transmission> {
    mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Worm => Some(t),
        _ => None,
    })
}

/// Whether a wheel is the pitch cylinder of a worm.
pub fn is_worm(mechanism: &Mechanism, wheel: usize) -> bool {
    worms(mechanism).any(|t| t.ends.first().and_then(|end| wheel_named(mechanism, end)) == Some(wheel))
}

/// Whether a shaft has nothing but worms on it: it is across all others.
pub fn is_across(mechanism: &Mechanism, link: LinkId) -> bool {
    let other = |i: &usize| mechanism.wheels[*i].link == link && !is_worm(mechanism, *i);
    worms(mechanism).any(|t| t.links.first() == Some(&link))
        && !(0..mechanism.wheels.len()).any(|i| other(&i))
}

/// In section: the worm above its wheel, from its end.
pub fn section(drawing: &mut Drawing, wheel: &Drawn) -> Vec2 {
    let centre = Vec2::new(wheel.x, -(wheel.level + wheel.radius + AXIS));
    drawing.mark(Style::Hinge, Shape::Circle { centre, radius: AXIS - 0.4 });
    drawing.mark(Style::Hinge, Shape::Circle { centre, radius: 1.0 });
    centre
}
