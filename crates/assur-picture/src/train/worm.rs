//! Worms: seen from their end in section, on their shafts across their wheels in front view.

use super::layout::{Drawn, Layout, Shaft, wheel_named};
use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Transmission, TransmissionKind};

/// Half the height of a thread, and half the length of a worm.
const HEIGHT: f64 = 2.2;
pub const HALF: f64 = 7.0;
/// From a worm to the end of its shaft with the bearing, and to the other end.
const LONG: f64 = 14.0;
const SHORT: f64 = 4.0;
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

/// In front view: the shafts of worms that are across all others, and where their threads are.
pub fn placed(mechanism: &Mechanism, layout: &Layout, centre: impl Fn(&Drawn) -> Vec2) -> Vec<(Shaft, Vec2)> {
    let one = |t: &Transmission| {
        let link = *t.links.first()?;
        let drawn = &layout.wheels[wheel(mechanism, layout, t)?];
        let at = centre(drawn) - Vec2::new(0.0, drawn.radius + AXIS);
        let ends = (at.x - HALF - LONG, at.x + HALF + SHORT);
        is_across(mechanism, link)
            .then(|| (Shaft { ends, level: -at.y, ..Shaft::new(link, LinkId::GROUND) }, at))
    };
    worms(mechanism).filter_map(one).collect()
}

/// The turns of a worm on its shaft.
pub fn thread(drawing: &mut Drawing, at: Vec2) {
    spindle(drawing, at, HALF);
}

/// A line with the turns of a thread.
pub fn spindle(drawing: &mut Drawing, at: Vec2, half: f64) {
    let count = 2 * (half / 1.75).round().max(2.0) as i32;
    let point = |i: i32| {
        let x = at.x - half + 2.0 * half * f64::from(i) / f64::from(count);
        Vec2::new(x, at.y + if i % 2 == 0 { HEIGHT } else { -HEIGHT })
    };
    drawing.mark(Style::Medium, Shape::Lines { points: (0..=count).map(point).collect(), closed: false });
    drawing.line(Style::Medium, at - Vec2::new(half, 0.0), at + Vec2::new(half, 0.0));
}
