//! What shows that a train turns which is seen from the side: teeth that go by on the near half of wheels, cranks on the ends of shafts.

use super::layout::{Drawn, Layout};
use super::wheels::FACE;
use crate::scene::Scene;
use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Wheel};
use std::f64::consts::TAU;

/// The most lines of teeth around a wheel, and those of one whose teeth are not known.
const MOST: f64 = 24.0;
const TEETH: f64 = 12.0;
/// The radius of a crank on the end of a shaft.
const CRANK: f64 = 3.4;

/// The marks of all wheels and shafts at their angles.
pub fn marks(scene: &Scene<'_>, layout: &Layout, turned: &dyn Fn(LinkId) -> f64, drawing: &mut Drawing) {
    for drawn in &layout.wheels {
        let wheel = &scene.mechanism().wheels[drawn.wheel];
        if wheel.link != LinkId::GROUND {
            drawing.begin("wheel", &wheel.name);
            teeth(drawing, drawn, wheel, turned(wheel.link));
            drawing.end();
        }
    }
    for shaft in layout.shafts.iter().filter(|shaft| shaft.upright.is_none()) {
        drawing.begin("link", &scene.mechanism().link(shaft.link).name);
        let end = Vec2::new(if shaft.right { shaft.ends.1 } else { shaft.ends.0 }, -shaft.level);
        let up = Vec2::new(0.0, -CRANK * libm::sin(turned(shaft.link)));
        drawing.line(Style::Medium, end, end + up);
        drawing.mark(Style::Hinge, Shape::Circle { centre: end + up, radius: 0.8 });
        drawing.end();
    }
}

/// Lines of teeth on the half of a wheel that is seen.
fn teeth(drawing: &mut Drawing, drawn: &Drawn, wheel: &Wheel, angle: f64) {
    let count = wheel.teeth.unwrap_or(TEETH);
    let every = (count / MOST).ceil().max(1.0);
    let pitch = TAU * every / count;
    let (apex, upright) = drawn.cone.map_or((None, false), |(apex, upright)| (Some(apex), upright));
    let centre = Vec2::new(drawn.x, drawn.level);
    let across = if upright { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
    let paper = |at: Vec2| Vec2::new(at.x, -at.y);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most a few dozen
    let lines = (0..(count / every) as u32).filter_map(|tooth| {
        let at = Vec2::direction(angle + pitch * f64::from(tooth));
        let rim = centre + across * (drawn.radius * at.y);
        let along = match apex {
            Some(apex) => (apex - rim).unit()? * (2.0 * FACE),
            None => Vec2::new(2.0 * FACE, 0.0),
        };
        let from = if apex.is_some() { rim } else { rim - along / 2.0 };
        (at.x > 0.0).then(|| (paper(from), paper(from + along)))
    });
    drawing.mark(Style::Thin, Shape::Strokes(lines.collect()));
}
