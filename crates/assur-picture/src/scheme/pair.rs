//! Pairs: hinges, rails, blocks, slots, cylinders; springs.

use super::{LinkId, Sketch, any_near};
use crate::scene::Scene;
use crate::shape::{Form, SLOT_END, form};
use crate::symbol::{cylinder, guide, hinge, spring};
use assur_drawing::{Drawing, Label, Rect, Segment, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Guide, PairId, PairKind, Pin, Spring, TransmissionKind};

/// How far a rail goes beyond all places of its block, mm.
const BEYOND: f64 = 9.0;
/// From a follower's highest place to the guide of its rod, and the length of that guide.
const ROD: (f64, f64) = (13.0, 7.0);
/// From a rod to a spring beside its guide.
const SPRING: f64 = 7.0;
/// Half the part of a bar that passes over a hinge in its middle.
const OVER: f64 = 3.5;
/// A point that is nearer to the end of a bar is its end, mm.
const END: f64 = 1.0;

/// The places of pins in slots of the ground, and ways on its rails, m.
pub fn extent(scene: &Scene<'_>, bounds: &mut Rect) {
    super::geneva::extent(scene, |_| true, bounds);
    for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
        if let PairKind::Prismatic(g) | PairKind::Slot(g) = &pair.kind
            && g.guide == LinkId::GROUND
            && scene.is_placed(g.slider)
        {
            let (from, to) = scene.way(PairId::at(i));
            for s in [from, to] {
                bounds.add(g.through + g.along * s);
            }
        }
    }
}

impl<'a> Sketch<'a, '_> {
    /// Sliding pairs with their guides, those of shafts and sliders without a place left out.
    fn guides(&self) -> impl Iterator<Item = (PairId, &'a str, &'a Guide, Form)> + use<'a, '_> {
        let (scene, shapes) = (self.scene, self.shapes);
        let pairs = scene.mechanism().pairs.iter().enumerate();
        pairs.filter_map(move |(i, pair)| match &pair.kind {
            PairKind::Prismatic(g) if pair.bearing.is_none() => {
                Some((PairId::at(i), pair.name.as_str(), g, form(scene, shapes, g)))
            }
            _ => None,
        })
    }

    /// Lines of the ground along which wedges slide.
    pub(super) fn walls(&self, drawing: &mut Drawing) {
        for (id, name, g, _) in self.guides().filter(|guide| guide.3 == Form::Face) {
            self.wall(drawing, id, name, g);
        }
    }

    /// Rails of the ground with their axes.
    pub(super) fn rails(&self, drawing: &mut Drawing) {
        for (id, name, g, form) in self.guides() {
            if form != Form::Rail || self.follower(g).is_some() || self.rolls(g) {
                continue;
            }
            drawing.begin("pair", name);
            let at = self.frame.point(g.through);
            let along = crate::inset::flipped(g.along);
            let (least, greatest) = self.scene.way(id);
            let (low, high) = match self.only {
                None => (self.frame.length(least), self.frame.length(greatest)),
                // of links alone the place of the block is shown, and not its way
                Some(_) => {
                    let here = (self.on_paper(g.slider, g.point) - at).dot(along);
                    (here, here)
                }
            };
            let ends = self.along_block(g, along);
            let (from, to) = (low + ends.0 - BEYOND, high + ends.1 + BEYOND);
            drawing.line(Style::Axis, at + along * (from - 4.0), at + along * (to + 4.0));
            guide::rail(drawing, at, along, (from, to));
            let end = at + along * to + guide::below(along) * (guide::BLOCK.y + 2.6);
            self.ground_number(drawing, end);
            drawing.end();
        }
    }

    /// The line of the ground along which a wedge slides, hatched on the side where the wedge is not.
    fn wall(&self, drawing: &mut Drawing, id: PairId, name: &str, g: &Guide) {
        let (wedge, sign) = if g.guide == LinkId::GROUND { (g.slider, 1.0) } else { (g.guide, -1.0) };
        let (at, along) = if sign > 0.0 { (g.through, g.along) } else { (g.point, g.direction) };
        if g.guide != LinkId::GROUND && g.slider != LinkId::GROUND {
            return;
        }
        let (at, along) = (self.frame.point(at), crate::inset::flipped(along));
        let corners: Vec<Vec2> =
            self.shapes[wedge.index()].wedge.iter().map(|c| self.on_paper(wedge, *c)).collect();
        let (mut from, mut to, mut off) = (f64::MAX, f64::MIN, 0.0);
        for corner in &corners {
            let d = *corner - at;
            off += along.cross(d);
            if along.cross(d).abs() < 0.1 {
                (from, to) = (from.min(d.dot(along)), to.max(d.dot(along)));
            }
        }
        // at all its places
        let (least, greatest) = self.scene.way(id);
        let here = (self.on_paper(g.slider, g.point) - self.on_paper(g.guide, g.through)).dot(along) * sign;
        let ways = [least, greatest].map(|s| self.frame.length(s) - here);
        let (from, to) =
            (from + ways[0].min(ways[1]).min(0.0) - BEYOND, to + ways[0].max(ways[1]).max(0.0) + BEYOND);
        let side = if off > 0.0 { -along.perp() } else { along.perp() };
        drawing.begin("pair", name);
        drawing.line(Style::Medium, at + along * from, at + along * to);
        hinge::hatch(drawing, at + along * from, at + along * to, side);
        self.ground_number(drawing, at + along * to + side * 3.0);
        drawing.end();
    }

    /// Whether a slider is what the axis of a wheel on the ground is on: the ground under the wheel says where it goes.
    fn rolls(&self, g: &Guide) -> bool {
        let mechanism = self.scene.mechanism();
        let on_ground = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
            PairKind::Transmission(t) if t.kind == TransmissionKind::Rack => Some(t),
            _ => None,
        });
        let wheels = on_ground.filter(|t| t.links.contains(&LinkId::GROUND));
        let wheels: Vec<LinkId> = wheels.flat_map(|t| t.links.iter().copied()).collect();
        mechanism.pairs.iter().any(|pair| match &pair.kind {
            PairKind::Revolute(pins) => {
                pins.iter().any(|pin| pin.link == g.slider)
                    && pins.iter().any(|pin| pin.link != LinkId::GROUND && wheels.contains(&pin.link))
            }
            _ => false,
        })
    }

    /// The ends of a block along its guide, from its point: longer where mass centre or loads are beside it on the guide.
    fn along_block(&self, g: &Guide, along: Vec2) -> (f64, f64) {
        let middle = self.on_paper(g.slider, g.point);
        let shape = &self.shapes[g.slider.index()];
        let (mut from, mut to) = (0.0_f64, 0.0_f64);
        for point in shape.attached.iter().chain(&shape.joints) {
            let d = self.on_paper(g.slider, *point) - middle;
            if d.cross(along).abs() < 1.0 && d.dot(along).abs() < 25.0 {
                (from, to) = (from.min(d.dot(along)), to.max(d.dot(along)));
            }
        }
        (from - guide::BLOCK.x, to + guide::BLOCK.x)
    }

    pub(super) fn draw_blocks(&mut self, drawing: &mut Drawing) {
        let guides: Vec<_> = self.guides().collect();
        for (id, name, g, form) in guides {
            let owner = if form == Form::Sleeve { g.guide } else { g.slider };
            if !self.shows(owner) {
                continue;
            }
            drawing.begin("pair", name);
            let along = self.direction(g.guide, g.along);
            let slider = self.on_paper(g.slider, g.point);
            match form {
                Form::Rail if self.only.is_none() && self.follower(g).is_some() => self.rod(drawing, id, g),
                Form::Rail => {
                    let ends = self.along_block(g, along);
                    guide::block(drawing, slider, along, ends, guide::BLOCK.y);
                    let half = Vec2::new((ends.1 - ends.0) / 2.0, guide::BLOCK.y);
                    let middle = slider + along * ((ends.0 + ends.1) / 2.0);
                    self.blocks.push((g.slider, middle, along, half));
                }
                Form::Face => {}
                Form::Block | Form::FixedSleeve => {
                    self.sleeve(drawing, g.slider, slider, along);
                }
                Form::Sleeve => {
                    let at = self.on_paper(g.guide, g.through);
                    self.sleeve(drawing, g.guide, at, along);
                }
            }
            let at = if form == Form::Sleeve { self.on_paper(g.guide, g.through) } else { slider };
            self.guide_name(drawing, id, at - guide::below(along) * guide::BLOCK.y, along);
            drawing.end();
        }
    }

    /// The name of a sliding pair on the free side of its block, where the file asks for something of it. It is not that of its point.
    fn guide_name(&self, drawing: &mut Drawing, id: PairId, at: Vec2, along: Vec2) {
        let mechanism = self.scene.mechanism();
        let pair = mechanism.pair(id);
        let is_point =
            |link: &LinkId| mechanism.link(*link).points.iter().any(|point| point.name == pair.name);
        if mechanism.speaks_of(id) && !pair.kind.links().iter().any(is_point) {
            let label = Label::at(Text::name(&pair.name), super::link::POINT, at, 0.5);
            drawing.label(label.towards(-guide::below(along)).ranked(3));
        }
    }

    /// Of a slider that another link pushes at a contact, the direction on paper in which it is pushed along its guide.
    fn follower(&self, g: &Guide) -> Option<Vec2> {
        let along = crate::inset::flipped(g.along);
        self.scene.mechanism().pairs.iter().enumerate().find_map(|(i, pair)| {
            let PairKind::Contact { first, second, .. } = &pair.kind else { return None };
            // a roller of its own is pushed for the link that it runs on
            let rollers = self.scene.mechanism().cam_contacts.iter().filter(|c| c.follower == g.slider);
            let roller = rollers.filter_map(|c| c.roller).map(|(link, _)| link).next();
            let pushes = |link: LinkId| link == g.slider || Some(link) == roller;
            let is_first = pushes(first.link);
            if !is_first && !pushes(second.link) {
                return None;
            }
            let (_, into_first) = self.scene.view().contact_normal(PairId::at(i))?;
            let pushed = crate::inset::flipped(if is_first { into_first } else { -into_first }).dot(along);
            (pushed.abs() > 0.1).then(|| along * pushed.signum())
        })
    }

    /// A rod from the point of a follower through a fixed guide.
    fn rod(&mut self, drawing: &mut Drawing, id: PairId, g: &Guide) {
        let Some(along) = self.follower(g) else { return };
        let at = self.on_paper(g.slider, g.point);
        let (least, greatest) = self.scene.way(id);
        let way = self.frame.length(greatest - least);
        // the guide is where no position of the follower reaches it
        let here = self.frame.point(g.through);
        let s = (at - here).dot(along);
        let forwards = along.dot(crate::inset::flipped(g.along)) > 0.0;
        let highest = if forwards { self.frame.length(greatest) } else { -self.frame.length(least) };
        let clear = highest - s + ROD.0;
        let shape = &self.shapes[g.slider.index()];
        let reach = shape.attached.iter().map(|p| (self.on_paper(g.slider, *p) - at).dot(along));
        let end = reach.fold(clear + ROD.1 + way + 3.0, f64::max);
        drawing.line(Style::Axis, at - along * 4.0, at + along * (end + 5.0));
        drawing.line(Style::Link, at, at + along * end);
        self.rods.push((g.slider, at, at + along * end));
        guide::bush(drawing, at, along, (clear, clear + ROD.1));
        self.ground_number(drawing, at + along * (clear + ROD.1 / 2.0) + guide::below(along) * 4.0);
    }

    fn sleeve(&mut self, drawing: &mut Drawing, link: LinkId, at: Vec2, along: Vec2) {
        guide::block(drawing, at, along, (-guide::SLEEVE.x, guide::SLEEVE.x), guide::SLEEVE.y);
        if link == LinkId::GROUND {
            guide::fixed(drawing, at, along);
        }
        self.blocks.push((link, at, along, guide::SLEEVE));
    }

    pub(super) fn slots(&self, drawing: &mut Drawing) {
        for (i, pair) in self.scene.mechanism().pairs.iter().enumerate() {
            let PairKind::Slot(g) = &pair.kind else { continue };
            if self.scene.geneva(PairId::at(i)).is_some() {
                continue;
            }
            drawing.begin("pair", &pair.name);
            let (least, greatest) = self.scene.way(PairId::at(i));
            let at = self.on_paper(g.guide, g.through);
            let along = self.direction(g.guide, g.along);
            let ends = (self.frame.length(least) - SLOT_END, self.frame.length(greatest) + SLOT_END);
            if self.shows(g.guide) {
                guide::slot(drawing, at, along, ends, g.guide == LinkId::GROUND);
            }
            let pin = self.on_paper(g.slider, g.point);
            if !self.shows(g.slider) {
                drawing.end();
                continue;
            }
            drawing.mark(Style::Hinge, Shape::Circle { centre: pin, radius: hinge::PIN });
            self.guide_name(drawing, PairId::at(i), pin, along);
            drawing.end();
        }
    }

    pub(super) fn cylinders(&mut self, drawing: &mut Drawing) {
        for (i, pair) in self.scene.mechanism().pairs.iter().enumerate() {
            let PairKind::Cylinder { from, to, .. } = &pair.kind else { continue };
            if ![from, to].iter().all(|pin| self.shows(pin.link)) {
                continue;
            }
            drawing.begin("pair", &pair.name);
            let ends = [from, to].map(|pin| self.on_paper(pin.link, pin.at));
            let least = self.frame.length(self.scene.way(PairId::at(i)).0);
            cylinder::cylinder(drawing, ends[0], ends[1], least);
            for (pin, at) in [from, to].into_iter().zip(ends) {
                if pin.link == LinkId::GROUND {
                    hinge::support(drawing, at);
                    self.ground_point(drawing, pin.at);
                }
                hinge::moving(drawing, at);
            }
            let label = Label::along(Text::name(&pair.name), super::link::POINT, ends[0], ends[1]);
            drawing.label(label.ranked(3));
            drawing.end();
        }
    }

    pub(super) fn springs(&mut self, drawing: &mut Drawing) {
        for item in &self.scene.mechanism().springs {
            if !self.shows(item.from.0) || !self.shows(item.to.0) {
                continue;
            }
            let ends = [item.from, item.to].map(|(link, at)| self.on_paper(link, at));
            let aside = self.aside(item);
            let [a, b] = ends.map(|end| end + aside);
            drawing.begin("spring", &item.name);
            for ((end, moved), (link, _)) in ends.into_iter().zip([a, b]).zip([item.from, item.to]) {
                if link != LinkId::GROUND && aside != Vec2::zero() {
                    drawing.line(Style::Medium, end, moved);
                }
            }
            spring::spring(drawing, a, b);
            for ((link, at), end) in [item.from, item.to].into_iter().zip([a, b]) {
                if link == LinkId::GROUND {
                    hinge::support(drawing, end);
                    if aside == Vec2::zero() {
                        self.ground_point(drawing, at);
                    }
                }
            }
            drawing.label(Label::along(Text::name(&item.name), super::link::POINT, a, b).ranked(3));
            drawing.end();
        }
    }

    /// The name of a point of the ground at which a cylinder or a spring is held.
    fn ground_point(&mut self, drawing: &mut Drawing, at: Vec2) {
        let points = &self.scene.mechanism().link(LinkId::GROUND).points;
        let Some(point) = points.iter().find(|point| (point.at - at).norm() < 1e-12) else { return };
        let place = self.frame.point(at);
        if !any_near(&self.labelled, place, 0.4) {
            self.labelled.push(place);
            let label = Label::at(Text::name(&point.name), super::link::POINT, place, hinge::RADIUS);
            drawing.label(label.towards(Vec2::new(-1.0, -0.3)).ranked(3));
        }
    }

    /// How far a spring is drawn beside its place: it is not to run through the guide of a rod along which it acts.
    fn aside(&self, item: &Spring) -> Vec2 {
        let [a, b] = [item.from, item.to].map(|(link, at)| self.on_paper(link, at));
        let on = |(_, from, to): &(LinkId, Vec2, Vec2)| {
            let along = (*to - *from).unit()?;
            let is_on = [a, b].iter().all(|end| along.cross(*end - *from).abs() < 0.5);
            let (low, high) = ((a - *from).dot(along), (b - *from).dot(along));
            let shared = low.max(high).min((*to - *from).norm()) - low.min(high).max(0.0);
            (is_on && shared > 1.0).then(|| -guide::below(along) * SPRING)
        };
        self.rods.iter().find_map(on).unwrap_or(Vec2::zero())
    }

    /// Hinges, with the bars in whose middle they are drawn over them.
    pub(super) fn hinges(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        for pair in &scene.mechanism().pairs {
            let PairKind::Revolute(pins) = &pair.kind else { continue };
            let own = |p: &&Pin| p.link != LinkId::GROUND && scene.is_placed(p.link) && self.shows(p.link);
            let Some(pin) = pins.iter().find(own) else { continue };
            if pins.iter().any(|p| !scene.is_placed(p.link)) {
                continue;
            }
            drawing.begin("pair", &pair.name);
            let at = self.on_paper(pin.link, pin.at);
            let fixed = self.only.is_none() && pins.iter().any(|p| p.link == LinkId::GROUND);
            if fixed {
                hinge::support(drawing, at);
                self.supports.push(at);
            }
            hinge::moving(drawing, at);
            if fixed {
                self.ground_number(drawing, at + Vec2::new(4.0, 5.5));
            }
            for pin in pins {
                self.over(drawing, pin.link, at);
            }
            let label = Label::at(Text::name(&pair.name), super::link::POINT, at, hinge::RADIUS).ranked(1);
            let mut lines = self.lines_at(at);
            if fixed {
                lines.extend([Vec2::new(-0.5, 0.86), Vec2::new(0.5, 0.86)]);
            }
            let label = match crate::inset::freest(&lines) {
                Some(direction) => label.towards(direction),
                None => label,
            };
            // the pair of a shaft has the name of the shaft
            if pair.bearing.is_none() && !any_near(&self.labelled, at, 0.05) {
                drawing.label(label);
            }
            self.labelled.push(at);
            drawing.end();
        }
    }

    /// The bar of a link over a hinge in its middle.
    fn over(&self, drawing: &mut Drawing, link: LinkId, at: Vec2) {
        for (a, b) in &self.outlines()[link.index()].bars {
            let segment = Segment { a: *a, b: *b };
            let inside = (at - *a).norm() > END + hinge::RADIUS && (at - *b).norm() > END + hinge::RADIUS;
            if let (true, Some(along)) = (inside && segment.distance(at) < 0.1, (*b - *a).unit()) {
                drawing.line(Style::Link, at - along * OVER, at + along * OVER);
            }
        }
    }
}
