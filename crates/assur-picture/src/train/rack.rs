//! Racks: below their wheels in section, at the pitch circles in front view.

use super::layout::{Drawn, Layout, wheel_named};
use super::{BLOCK, NAME};
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Transmission, TransmissionKind};

/// Between the faces of a wheel and its rack.
const GAP: f64 = 1.1;

/// A rack with its wheel.
pub struct Rack<'l> {
    pub pair: &'l Transmission,
    pub wheel: &'l Drawn,
    /// The link of the rack.
    pub link: LinkId,
}

/// The racks under wheels that are drawn.
pub fn racks<'l>(mechanism: &'l Mechanism, layout: &'l Layout) -> Vec<Rack<'l>> {
    let one = |kind: &'l PairKind| match kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Rack => {
            let wheel = t.ends.iter().find_map(|end| layout.wheel(wheel_named(mechanism, end)?))?;
            let turning = mechanism.wheels[wheel.wheel].link;
            let link = t.links.iter().copied().find(|link| *link != turning)?;
            Some(Rack { pair: t, wheel, link })
        }
        _ => None,
    };
    mechanism.pairs.iter().filter_map(|pair| one(&pair.kind)).collect()
}

impl Rack<'_> {
    /// The middle of its body in section.
    pub fn middle(&self) -> Vec2 {
        Vec2::new(self.wheel.x, -(self.wheel.level - self.wheel.radius) + GAP + BLOCK.y)
    }

    /// Its body in section.
    pub fn section(&self, scene: &Scene<'_>, drawing: &mut Drawing) {
        let at = self.middle();
        let corner = |x: f64, y: f64| at + Vec2::new(x * BLOCK.x, y * BLOCK.y);
        let corners = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        drawing.mark(Style::Block, Shape::polygon(corners));
        let text = Text::upright(scene.link_label(self.link));
        drawing.label(Label::at(text, NAME, at, BLOCK.x).towards(Vec2::new(1.0, 0.0)).ranked(2));
    }
}
