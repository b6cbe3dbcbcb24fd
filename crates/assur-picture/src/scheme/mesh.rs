//! Teeth where wheels meet, racks, worms, screws and clutches, seen from the front.

use super::{LinkId, Motion, Sketch};
use crate::machine::arrangement::Thread;
use crate::scene::Scene;
use crate::symbol::gear::{self, MODULE, TEETH, row};
use crate::symbol::{hinge, thread, wheel};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{PairId, PairKind, Rate, Transmission, TransmissionKind, Wheel};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Radii of the two sides of a clutch, mm.
const CLUTCH: [f64; 2] = [4.0, 5.6];
/// The most teeth of a rack on each side of a place.
const MANY: i32 = 200;

impl<'a> Sketch<'a, '_> {
    /// Teeth, belts, ropes, racks, worms, screws, clutches.
    pub(super) fn transmissions(&self, drawing: &mut Drawing) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Transmission(t) = &pair.kind else { continue };
            let wheels: Vec<&Wheel> = t.ends.iter().filter_map(|end| self.placed_wheel(end)).collect();
            drawing.begin("pair", &pair.name);
            match (t.kind, wheels.as_slice()) {
                (TransmissionKind::Mesh, [a, b]) if t.bevel.is_none() => {
                    self.teeth(drawing, a, b, &|_| true);
                }
                (TransmissionKind::Belt | TransmissionKind::Chain, [a, b]) => self.belt(drawing, t, a, b),
                (TransmissionKind::Rack, [wheel]) => self.rack(drawing, t, wheel),
                (TransmissionKind::Clutch, _) => self.clutch(drawing, t),
                _ => {}
            }
            drawing.end();
        }
        if let Some(laid) = self.scene.laid {
            laid.ropes.iter().for_each(|rope| self.rope(drawing, rope));
            laid.threads.iter().for_each(|thread| self.thread(drawing, thread));
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
        let bare = end.rsplit('.').next().unwrap_or(end);
        super::profile::front(self.scene).find(|wheel| wheel.name == bare)
    }

    pub(super) fn centre(&self, wheel: &Wheel) -> Vec2 {
        self.on_paper(wheel.link, wheel.centre.unwrap_or_else(Vec2::zero))
    }

    /// Teeth of those of two wheels that are wanted, around the place where their pitch circles touch: in the first frame a tooth of one
    /// in a gap of the other, and then turned by their wheels, within one pitch.
    fn teeth(&self, drawing: &mut Drawing, a: &Wheel, b: &Wheel, wanted: &dyn Fn(LinkId) -> bool) {
        let (c_a, c_b) = (self.centre(a), self.centre(b));
        let radii = [a, b].map(|w| self.frame.length(w.radius));
        let internal = (c_b - c_a).norm() < radii[0].max(radii[1]);
        let Some(towards) = (c_b - c_a).unit() else { return };
        let module = a.teeth.map_or(0.0, |z| 2.0 * radii[0] / z).max(MODULE);
        // both wheels keep step where the file leaves sizes open too: a turn has as many pitches as teeth
        let count = |wheel: &Wheel, radius: f64| wheel.teeth.unwrap_or(2.0 * radius / module);
        let larger = 2.0 * radii[0] / module / count(a, radii[0]);
        let line = self.line_turned(a, b);
        for (i, wheel) in [a, b].into_iter().enumerate().filter(|(_, wheel)| wanted(wheel.link)) {
            let (own, other) = (radii[i], radii[1 - i]);
            let is_ring = internal && own > other;
            // the wheels touch beyond the centre of the inner one
            let outward = if i == 0 { towards } else { -towards };
            let at = if internal && !is_ring { -outward } else { outward };
            let shift = if i == 0 { 0.0 } else { 0.5 };
            let turned = (line - self.turned(wheel.link)) * count(wheel, own) * larger / TAU;
            let shift = shift + turned;
            let shift = shift - (shift - 0.25).round();
            let centre = if i == 0 { c_a } else { c_b };
            row(drawing, centre, own, at.angle(), module, shift, if is_ring { -1.0 } else { 1.0 });
        }
    }

    /// By how much the line of centres of two wheels has turned since the first frame, rad: as the link that carries both, with its whole
    /// turns, where there is one.
    fn line_turned(&self, a: &Wheel, b: &Wheel) -> f64 {
        let Some(Motion { rest, .. }) = self.motion else { return 0.0 };
        let at =
            |scene: &Scene<'_>, wheel: &Wheel| scene.at(wheel.link, wheel.centre.unwrap_or_else(Vec2::zero));
        let [from, to] = [rest, self.scene].map(|scene| at(scene, b) - at(scene, a));
        let turned = libm::atan2(from.cross(to), from.dot(to));
        let carriers = (1..self.scene.mechanism().links.len()).map(|i| self.turned(LinkId::at(i)));
        let same = |angle: &f64| crate::inset::wrapped(angle - turned).abs() < 1e-6;
        carriers.filter(same).max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(turned)
    }

    /// The toothed line under a wheel. One that moves is as long as the way of the wheel on it.
    fn rack(&self, drawing: &mut Drawing, t: &Transmission, wheel: &Wheel) {
        let Some((touch, along)) = self.rack_touch(t, wheel, self.scene) else { return };
        let (centre, radius) = (self.centre(wheel), self.frame.length(wheel.radius));
        let side = (touch - centre).unit().unwrap_or(Vec2::new(0.0, 1.0));
        let reach = gear::reach(radius);
        let module = wheel.teeth.map(|z| (2.0 * radius / z).max(MODULE));
        let fixed = t.links.contains(&LinkId::GROUND);
        let Some(Motion { rest, frames }) = self.motion else {
            let teeth = module.map(|module| (module, 0.0, 2 * TEETH));
            gear::rack(drawing, (touch, side), (-reach, reach), teeth, fixed);
            return;
        };
        // along the direction in which the symbol counts, from a place of the rack
        let sense = if side.perp().dot(along) < 0.0 { -1.0 } else { 1.0 };
        let on_rack = |scene: &Scene<'_>| {
            let (touch, along) = self.rack_touch(t, wheel, scene)?;
            let origin = self.frame.point(self.rack_origin(t, scene)?);
            Some((touch - origin).dot(along) * sense)
        };
        let Some(here) = on_rack(self.scene) else { return };
        let ends = frames.iter().filter_map(on_rack);
        let (least, most) = ends.fold((here, here), |(a, b), s| (a.min(s), b.max(s)));
        let first = on_rack(rest).unwrap_or(here);
        let teeth = module.map(|module| (module, first - here, MANY));
        gear::rack(drawing, (touch, side), (least - here - reach, most - here + reach), teeth, fixed);
        if let Some(module) = module {
            let shift = -self.turned(wheel.link) * wheel.teeth.unwrap_or(0.0) / TAU;
            row(drawing, centre, radius, side.angle(), module, shift - (shift - 0.25).round(), 1.0);
        }
    }

    /// Where a wheel touches the pitch line of its rack at a position, and the direction of that line, on paper.
    fn rack_touch(&self, t: &Transmission, wheel: &Wheel, scene: &Scene<'_>) -> Option<(Vec2, Vec2)> {
        let (at, along) = self.rack_line(t, scene)?;
        let centre = self.frame.point(scene.at(wheel.link, wheel.centre?));
        let radius = self.frame.length(wheel.radius);
        let away = (at - centre) - along * (at - centre).dot(along);
        Some((centre + away.unit()? * radius, along))
    }

    /// A place that goes with a rack, in ground axes.
    fn rack_origin(&self, t: &Transmission, scene: &Scene<'_>) -> Option<Vec2> {
        let wheel = t.ends.iter().find_map(|end| self.placed_wheel(end))?;
        let own = t.links.iter().copied().find(|link| *link != wheel.link)?;
        Some(scene.at(own, Vec2::zero()))
    }

    /// A point and the direction of a rack on paper: of a line that is named, or of a slider's guide.
    fn rack_line(&self, t: &Transmission, scene: &Scene<'_>) -> Option<(Vec2, Vec2)> {
        let mechanism = scene.mechanism();
        let line = |link: LinkId, at: Vec2, along: Vec2, through: LinkId| {
            (self.frame.point(scene.at(through, at)), crate::inset::flipped(along.turned(scene.body(link).u)))
        };
        for end in &t.ends {
            let Some((link, name)) = end.split_once('.') else { continue };
            let index = mechanism.links.iter().position(|l| l.name == link)?;
            let id = LinkId::at(index);
            if let Some(own) = mechanism.links[index].lines.iter().find(|l| l.name == name) {
                return Some(line(id, own.through, own.along, id));
            }
        }
        let slides = t.laws.first()?.terms.iter().find_map(|(rate, _)| match rate {
            Rate::Slide(pair) => Some(*pair),
            Rate::Turn(_) => None,
        })?;
        let PairKind::Prismatic(g) = &mechanism.pair(slides).kind else { return None };
        let placed = scene.is_placed(g.slider) && scene.is_placed(g.guide);
        placed.then(|| line(g.guide, g.point, g.along, g.slider))
    }

    /// A thread across its wheel, which moves it along, or under its nut.
    fn thread(&self, drawing: &mut Drawing, own: &Thread) {
        let pair = self.scene.mechanism().pair(own.pair);
        let PairKind::Transmission(t) = &pair.kind else { return };
        let at = self.frame.point(own.at);
        drawing.begin("pair", &pair.name);
        if t.kind == TransmissionKind::Worm {
            let wheel = t.ends.get(1).and_then(|end| self.placed_wheel(end));
            let run = wheel.map_or(0.0, |w| -self.turned(w.link) * self.frame.length(w.radius));
            thread::thread(drawing, at, thread::WORM, run);
        } else {
            thread::thread(drawing, at, self.frame.length(own.half), self.frame.length(self.gone(own.pair)));
        }
        drawing.end();
    }

    /// Names of threads: of the shafts whose axes they are, where these are not drawn.
    pub(super) fn thread_names(&self, drawing: &mut Drawing) {
        for own in self.scene.laid.iter().flat_map(|laid| &laid.threads) {
            let pair = self.scene.mechanism().pair(own.pair);
            let links = pair.kind.links();
            let across = links.iter().find(|link| !self.scene.is_placed(**link));
            let name = across.map_or(pair.name.as_str(), |link| self.scene.link_label(*link));
            drawing.begin("pair", &pair.name);
            let label =
                Label::at(Text::upright(name), super::link::POINT * 0.8, self.frame.point(own.at), 3.0);
            drawing.label(label.towards(Vec2::new(-1.0, -0.6)).ranked(3));
            drawing.end();
        }
    }

    /// How far the slider of a transmission has gone along its guide since the first frame, m.
    pub(super) fn gone(&self, transmission: PairId) -> f64 {
        let mechanism = self.scene.mechanism();
        let links = mechanism.pair(transmission).kind.links();
        let guide = mechanism.pairs.iter().find_map(|pair| match &pair.kind {
            PairKind::Prismatic(g) if links.contains(&g.slider) => Some(g),
            _ => None,
        });
        guide.map_or(0.0, |g| self.slid(g.slider).dot(g.along))
    }

    /// How far the origin of a link has gone since the first frame, m.
    pub(super) fn slid(&self, link: LinkId) -> Vec2 {
        let gone = |motion: Motion<'_, '_>| self.scene.body(link).p - motion.rest.body(link).p;
        self.motion.map_or(Vec2::zero(), gone)
    }

    /// The two sides of a clutch, or of a brake with the ground, about their axis.
    fn clutch(&self, drawing: &mut Drawing, t: &Transmission) {
        let Some(axis) = t.links.iter().find(|link| **link != LinkId::GROUND) else { return };
        if !self.scene.is_placed(*axis) {
            return;
        }
        let centre = self.on_paper(*axis, Vec2::zero());
        for (link, radius) in t.links.iter().zip(CLUTCH) {
            drawing.mark(Style::Medium, Shape::Circle { centre, radius });
            if *link == LinkId::GROUND {
                (0..3).for_each(|third| {
                    gear::held(drawing, centre, radius, FRAC_PI_2 + TAU * f64::from(third) / 3.0)
                });
            } else if self.motion.is_some() {
                let inner = if radius > CLUTCH[0] { CLUTCH[0] } else { hinge::RADIUS };
                wheel::ticks(drawing, centre, [inner, radius], self.angle_of(*link));
            }
        }
        hinge::moving(drawing, centre);
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
