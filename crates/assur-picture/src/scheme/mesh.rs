//! What runs between wheels that have places, seen from the front: teeth where wheels meet, belts and ropes, racks.

use super::{LinkId, Sketch};
use crate::symbol::gear::{MODULE, belt, held, rack, row};
use assur_drawing::Drawing;
use assur_math::math::Vec2;
use assur_model::model::{PairKind, Rate, Transmission, TransmissionKind, Wheel};
use std::f64::consts::{PI, TAU};

impl<'a> Sketch<'a, '_> {
    /// Teeth, belts, ropes, racks.
    pub(super) fn meshes(&self, drawing: &mut Drawing) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Transmission(t) = &pair.kind else { continue };
            let wheels: Vec<&Wheel> = t.ends.iter().filter_map(|end| self.placed_wheel(end)).collect();
            drawing.begin("pair", &pair.name);
            match (t.kind, wheels.as_slice()) {
                (TransmissionKind::Mesh, [a, b]) => self.teeth(drawing, a, b, &|_| true),
                (TransmissionKind::Belt | TransmissionKind::Chain | TransmissionKind::Rope, [a, b]) => {
                    let disc = |wheel: &Wheel| (self.centre(wheel), self.frame.length(wheel.radius));
                    belt(drawing, disc(a), disc(b), crossed(t, a.link, b.link));
                }
                (TransmissionKind::Rack, [wheel]) => self.rack(drawing, t, wheel),
                _ => {}
            }
            drawing.end();
        }
    }

    /// The teeth of some links where their wheels meet others.
    pub(super) fn meshing(&self, wanted: impl Fn(LinkId) -> bool, drawing: &mut Drawing) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Transmission(t) = &pair.kind else { continue };
            let wheels: Vec<&Wheel> = t.ends.iter().filter_map(|end| self.placed_wheel(end)).collect();
            if let (TransmissionKind::Mesh, [a, b]) = (t.kind, wheels.as_slice())
                && (wanted(a.link) || wanted(b.link))
            {
                drawing.begin("pair", &pair.name);
                self.teeth(drawing, a, b, &wanted);
                drawing.end();
            }
        }
    }

    /// A wheel by the name of an end, if its place and its size are known.
    fn placed_wheel(&self, end: &str) -> Option<&'a Wheel> {
        let mechanism = self.scene.mechanism();
        let bare = end.rsplit('.').next().unwrap_or(end);
        let wheel = mechanism.wheels.iter().find(|w| w.name == bare)?;
        let open = mechanism.open_sizes.iter().any(|o| o.wheel == wheel.name);
        (wheel.centre.is_some() && !open && self.scene.is_placed(wheel.link)).then_some(wheel)
    }

    fn centre(&self, wheel: &Wheel) -> Vec2 {
        self.on_paper(wheel.link, wheel.centre.unwrap_or_else(Vec2::zero))
    }

    /// Teeth of those of two wheels that are wanted, around the place where their pitch circles touch.
    fn teeth(&self, drawing: &mut Drawing, a: &Wheel, b: &Wheel, wanted: &dyn Fn(LinkId) -> bool) {
        let (c_a, c_b) = (self.centre(a), self.centre(b));
        let radii = [a, b].map(|w| self.frame.length(w.radius));
        let internal = (c_b - c_a).norm() < radii[0].max(radii[1]);
        let Some(towards) = (c_b - c_a).unit() else { return };
        let module = a.teeth.map_or(0.0, |z| 2.0 * radii[0] / z).max(MODULE);
        let ends = [(c_a, a.link), (c_b, b.link)].into_iter().enumerate();
        for (i, (centre, _)) in ends.filter(|(_, (_, link))| wanted(*link)) {
            let (own, other) = (radii[i], radii[1 - i]);
            let is_ring = internal && own > other;
            // the wheels touch beyond the centre of the inner one
            let outward = if i == 0 { towards } else { -towards };
            let at = if internal && !is_ring { -outward } else { outward };
            let shift = if i == 0 { 0.0 } else { 0.5 };
            row(drawing, centre, own, at.angle(), module, shift, if is_ring { -1.0 } else { 1.0 });
        }
        for wheel in [a, b].into_iter().filter(|w| w.link == LinkId::GROUND && wanted(w.link)) {
            let (centre, radius) = (self.centre(wheel), self.frame.length(wheel.radius));
            for third in 0..3 {
                held(drawing, centre, radius, PI / 2.0 + TAU * f64::from(third) / 3.0);
            }
        }
    }

    /// The toothed line under a wheel.
    fn rack(&self, drawing: &mut Drawing, t: &Transmission, wheel: &Wheel) {
        let Some((at, along)) = self.rack_line(t) else { return };
        let (centre, radius) = (self.centre(wheel), self.frame.length(wheel.radius));
        let away = (at - centre) - along * (at - centre).dot(along);
        let side = away.unit().unwrap_or(Vec2::new(0.0, 1.0));
        rack(drawing, (centre, radius), side, wheel.teeth, t.links.contains(&LinkId::GROUND));
    }

    /// A point and the direction of a rack: of a line that is named, or of a slider's guide.
    fn rack_line(&self, t: &Transmission) -> Option<(Vec2, Vec2)> {
        let mechanism = self.scene.mechanism();
        for end in &t.ends {
            let Some((link, line)) = end.split_once('.') else { continue };
            let index = mechanism.links.iter().position(|l| l.name == link)?;
            let id = LinkId::at(index);
            if let Some(line) = mechanism.links[index].lines.iter().find(|l| l.name == line) {
                return Some((self.on_paper(id, line.through), self.direction(id, line.along)));
            }
        }
        let slides = t.laws.first()?.terms.iter().find_map(|(rate, _)| match rate {
            Rate::Slide(pair) => Some(*pair),
            Rate::Turn(_) => None,
        })?;
        let PairKind::Prismatic(g) = &mechanism.pair(slides).kind else { return None };
        let placed = self.scene.is_placed(g.slider) && self.scene.is_placed(g.guide);
        placed.then(|| (self.on_paper(g.slider, g.point), self.direction(g.guide, g.along)))
    }
}

/// Whether two wheels of a belt turn against each other.
pub fn crossed(t: &Transmission, a: LinkId, b: LinkId) -> bool {
    let term = |link: LinkId| {
        let law = t.laws.first()?;
        law.terms.iter().find(|(r, _)| *r == Rate::Turn(link)).map(|t| t.1)
    };
    matches!((term(a), term(b)), (Some(a), Some(b)) if a * b > 0.0)
}
