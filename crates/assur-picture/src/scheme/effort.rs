//! Drives, loads, weights and unknown efforts.

use super::{LinkId, Sketch, any_near};
use crate::inset::{flipped, wrapped};
use crate::symbol::{arrow, guide, hinge};
use assur_drawing::{Drawing, Label, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{
    Axis, BalanceKind, Drive, DriveTarget, Load, LoadId, LoadKind, PairId, PairKind, Query, Spread, Value,
};
use std::f64::consts::TAU;

/// Length of the arrow of a load, mm.
const LENGTH: f64 = 13.0;
/// Length of the arrow of an unknown force.
const UNKNOWN: f64 = 19.0;
/// Radius and angle of an arc arrow of a couple, and of a drive.
const COUPLE: (f64, f64) = (6.0, 1.75);
const DRIVE: (f64, f64) = (8.7, 1.1);
/// Radius of the arc of an angle, and of the line from which it is measured.
const ANGLE: (f64, f64) = (10.0, 13.0);
const LETTERS: f64 = 4.2;
const SMALL: f64 = 3.8;
/// Length of the longest arrow of a load per length, mm, and the number of gaps between its arrows.
const PER_LENGTH: f64 = 7.0;
const SPREAD: u8 = 6;
/// From a link to where the line over these arrows would be without them.
const ABOVE: f64 = 1.0;
/// Arrows from one point are at least as far apart, mm.
const BESIDE: f64 = 1.9;

impl Sketch<'_, '_> {
    /// Arrows in the sense of the motion, angles with their names.
    pub(super) fn drives(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        for drive in &scene.mechanism().drives {
            drawing.begin("drive", &drive.name);
            match drive.target {
                DriveTarget::Link(link) if scene.is_placed(link) => {
                    if let Some(pivot) = self.pivot(link) {
                        self.turning(drawing, drive, link, pivot);
                    }
                }
                DriveTarget::Pair(pair) => self.driven_pair(drawing, drive, pair),
                DriveTarget::Point(link, at) => {
                    let Some(speed) = &drive.speed else { continue };
                    self.moved(drawing, (link, at), scene.view().vector(speed), &drive.name);
                }
                // one arrow for both coordinates
                DriveTarget::Place(link, at, axis) => {
                    if axis == Axis::X
                        || !scene
                            .mechanism()
                            .drives
                            .iter()
                            .any(|d| d.target == DriveTarget::Place(link, at, Axis::X))
                    {
                        let v = scene.view().body(link).velocity(at);
                        self.moved(drawing, (link, at), v, drive.written_name());
                    }
                }
                DriveTarget::Link(_) => {}
            }
            drawing.end();
        }
        let drives = crate::words::drives(scene);
        if !drives.is_empty() {
            self.say(&format!("Drive: {drives}"));
        }
    }

    /// The arrow of a driven point.
    fn moved(&mut self, drawing: &mut Drawing, (link, at): (LinkId, Vec2), v: Vec2, name: &str) {
        if let Some(along) = flipped(v).unit() {
            let from = self.on_paper(link, at);
            self.push(drawing, Style::Drive, from, along, LENGTH, Text::italic("v").lowered(name));
        }
    }

    /// The hinge of a link: on the ground, else any.
    pub(super) fn pivot(&self, link: LinkId) -> Option<Vec2> {
        let pins = self.scene.mechanism().pairs.iter().filter_map(|p| match &p.kind {
            PairKind::Revolute(pins) => {
                let own = pins.iter().find(|pin| pin.link == link)?;
                Some((pins.iter().any(|pin| pin.link == LinkId::GROUND), own.at))
            }
            _ => None,
        });
        let pins: Vec<(bool, Vec2)> = pins.collect();
        let fixed = pins.iter().find(|p| p.0).or(pins.first());
        let at = fixed.map(|p| p.1).or_else(|| self.shapes[link.index()].joints.first().copied());
        at.map(|at| self.on_paper(link, at))
    }

    /// The sense of a drive, where it is known.
    fn sense(&self, drive: &Drive) -> Option<bool> {
        let speed = drive.speed.as_ref().map(|e| self.scene.view().scalar(e));
        let sign = speed.or(drive.sense)?;
        (sign.is_finite() && sign != 0.0).then_some(sign > 0.0)
    }

    fn turning(&mut self, drawing: &mut Drawing, drive: &Drive, link: LinkId, pivot: Vec2) {
        let angle = self.scene.body(link).u.angle();
        if let Some(ccw) = self.sense(drive) {
            let middle = self.free_middle(pivot, angle + 1.9);
            self.taken.push((pivot, Vec2::direction(-middle) * DRIVE.0));
            arrow::turn(drawing, Style::Drive, pivot, DRIVE.0, (middle, DRIVE.1), ccw);
            let at = arrow::middle(pivot, DRIVE.0, middle);
            let label = Label::at(self.scene.indexed("ω", link), LETTERS, at, 0.4);
            drawing.label(label.towards(at - pivot).coloured(Role::Blue).ranked(2));
        }
        drawing.end();
        drawing.begin("angle", &drive.name);
        self.angle(drawing, drive, pivot, angle);
    }

    /// The angle of a driven link, where the author gave it a name.
    fn angle(&self, drawing: &mut Drawing, drive: &Drive, pivot: Vec2, angle: f64) {
        let named = |w: &&String| {
            w.starts_with(char::is_alphabetic)
                && w.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'')
        };
        let Some(name) = drive.written.as_ref().filter(named) else { return };
        let sweep = wrapped(angle);
        let sweep = if sweep < 0.0 { sweep + TAU } else { sweep };
        if !(0.1..TAU - 0.1).contains(&sweep) {
            return;
        }
        let (radius, line) = ANGLE;
        drawing.line(Style::Thin, pivot, pivot + Vec2::new(line, 0.0));
        drawing.mark(Style::Thin, Shape::Arc { centre: pivot, radius, from: 0.0, sweep: -sweep });
        let at = arrow::middle(pivot, radius, sweep / 2.0);
        drawing.label(Label::at(Text::name(name), SMALL, at, 0.2).towards(at - pivot).ranked(3));
    }

    fn driven_pair(&mut self, drawing: &mut Drawing, drive: &Drive, pair: PairId) {
        let Some(forward) = self.sense(drive) else { return };
        let pair = self.scene.mechanism().pair(pair);
        if pair.kind.links().iter().any(|l| !self.scene.is_placed(*l)) {
            return;
        }
        match &pair.kind {
            PairKind::Revolute(pins) => {
                let [first, second] = pins.as_slice() else { return };
                if !self.scene.is_placed(second.link) {
                    return;
                }
                let pivot = self.on_paper(second.link, second.at);
                let moving = if second.link == LinkId::GROUND { first.link } else { second.link };
                let middle = self.free_middle(pivot, self.scene.body(moving).u.angle() + 1.9);
                self.taken.push((pivot, Vec2::direction(-middle) * DRIVE.0));
                arrow::turn(drawing, Style::Drive, pivot, DRIVE.0, (middle, DRIVE.1), forward);
                let at = arrow::middle(pivot, DRIVE.0, middle);
                let label = Label::at(self.scene.indexed("ω", moving), LETTERS, at, 0.4);
                drawing.label(label.towards(at - pivot).coloured(Role::Blue).ranked(2));
            }
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => {
                let Some((at, along)) = self.line_of(pair) else { return };
                let along = if forward { along } else { -along };
                self.push(drawing, Style::Drive, at, along, LENGTH, Text::italic("v").lowered(&drive.name));
            }
            _ => {}
        }
    }

    /// Arrows of a load per length onto its segment, under a line with its name.
    fn spread(&self, drawing: &mut Drawing, on: LinkId, spread: &Spread, resultant: Vec2, name: Text) {
        let ends = spread.ends(resultant).map(flipped);
        let longest = ends[0].norm().max(ends[1].norm());
        let mut tails = Vec::new();
        for i in 0..=SPREAD {
            let s = f64::from(i) / f64::from(SPREAD);
            let per_length = ends[0] * (1.0 - s) + ends[1] * s;
            let at = self.on_paper(on, spread.from + (spread.to - spread.from) * s);
            let Some(along) = per_length.unit().filter(|_| per_length.norm() > 0.05 * longest) else {
                tails.push(at);
                continue;
            };
            let tip = at - along * self.clear(at, -along);
            let tail = at - along * (ABOVE + PER_LENGTH * per_length.norm() / longest);
            tails.push(tail);
            arrow::straight(drawing, Style::Force, tail, tip);
        }
        let [first, last] = [tails[0], tails[tails.len() - 1]];
        drawing.mark(Style::Medium, Shape::Lines { points: tails, closed: false });
        let away = -flipped(resultant).unit().unwrap_or(Vec2::new(0.0, 1.0));
        drawing.label(Label::along(name, LETTERS, first, last).towards(away).ranked(2));
    }

    /// The slider's point and the direction of the guide on paper.
    fn line_of(&self, pair: &assur_model::model::Pair) -> Option<(Vec2, Vec2)> {
        match &pair.kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => {
                Some((self.on_paper(g.slider, g.point), self.direction(g.guide, g.along)))
            }
            PairKind::Cylinder { from, to, .. } => {
                let (a, b) = (self.on_paper(from.link, from.at), self.on_paper(to.link, to.at));
                Some((b, (b - a).unit()?))
            }
            _ => None,
        }
    }

    /// Loads as they act now, and weights.
    pub(super) fn loads(&mut self, drawing: &mut Drawing, against_motion: bool) {
        let scene = self.scene;
        let mut named = Vec::new();
        let shown = |load: &Load| against_motion || !load.is_against_motion();
        for (i, load) in scene.mechanism().loads.iter().enumerate().filter(|(_, load)| shown(load)) {
            let name = scene.load_words(load).unwrap_or_default();
            drawing.begin("load", &name);
            let value = scene.view().query(&Query::Load(LoadId::at(i)));
            let (force, couple) = (Text::name(or(&name, "F")), Text::name(or(&name, "M")));
            match (&load.kind, value) {
                (
                    LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                    Value::Vector(f),
                ) => {
                    let at = self.frame.point(scene.view().place(*on, at));
                    let f = scene.as_laid(*on, f);
                    if let (Some(along), true) = (flipped(f).unit(), scene.is_placed(*on)) {
                        let (length, force) =
                            (self.arrow(f.norm(), LENGTH), self.with_force(force, f.norm()));
                        named.push(spoken(&name, &force));
                        match &load.spread {
                            Some(spread) => self.spread(drawing, *on, spread, f, force),
                            None => self.push(drawing, Style::Force, at, along, length, force),
                        }
                    }
                }
                (LoadKind::Torque { on, at, .. }, Value::Scalar(m)) if m != 0.0 && m.is_finite() => {
                    let couple = self.with_couple(couple, m.abs());
                    self.couple(drawing, Style::Force, (*on, *at), m > 0.0, couple);
                    named.push(name);
                }
                (LoadKind::InPair { pair, .. }, Value::Scalar(x)) if x != 0.0 && x.is_finite() => {
                    let size = (self.arrow(x, LENGTH), x > 0.0);
                    let names = (self.with_force(force, x.abs()), self.with_couple(couple, x.abs()));
                    self.inside(drawing, Style::Force, *pair, size, names);
                    named.push(name);
                }
                _ => {}
            }
            drawing.end();
        }
        self.weights(drawing);
        named.retain(|n| !n.is_empty());
        if !named.is_empty() {
            self.say(&format!("Loads: {}", named.join(", ")));
        }
    }

    fn weights(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        let Some(acceleration) = scene.mechanism().gravity.map(|g| g.acceleration) else { return };
        let (Some(down), gravity) = (flipped(acceleration).unit(), acceleration.norm()) else { return };
        for (i, link) in scene.mechanism().links.iter().enumerate().skip(1) {
            let id = LinkId::at(i);
            let Some(mass) = link.mass.filter(|m| m.mass > 0.0) else { continue };
            if !scene.is_placed(id) {
                continue;
            }
            drawing.begin("weight", &link.name);
            let at = self.on_paper(id, mass.centre);
            let weight = mass.mass * gravity;
            let name = self.with_force(scene.indexed("G", id), weight);
            self.push(drawing, Style::Force, at, down, self.arrow(weight, LENGTH), name);
            drawing.end();
        }
    }

    /// Unknown efforts in their positive sense.
    pub(super) fn balances(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        for (i, balance) in scene.mechanism().balances.iter().enumerate() {
            drawing.begin("balance", &balance.name);
            for place in balance.kind.places() {
                let name = self.with_effort(Text::name(&balance.name), i, place);
                match place {
                    BalanceKind::Torque(link) => {
                        self.couple(drawing, Style::Unknown, (*link, None), true, name)
                    }
                    BalanceKind::Force { on, .. } => {
                        if let (Some((at, along)), true) =
                            (scene.view().balance_line(place), scene.is_placed(*on))
                        {
                            let at = self.frame.point(at);
                            let length = self.arrow_of(i, UNKNOWN);
                            self.push(
                                drawing,
                                Style::Unknown,
                                at,
                                flipped(scene.as_laid(*on, along)),
                                length,
                                name,
                            );
                        }
                    }
                    BalanceKind::InPair(pair) => {
                        let size = (self.arrow_of(i, LENGTH), true);
                        self.inside(drawing, Style::Unknown, *pair, size, (name.clone(), name));
                    }
                    BalanceKind::Several(_) => {}
                }
            }
            drawing.end();
            let first = balance.kind.places().first();
            let number = |place| self.with_effort(Text::name(&balance.name), i, place);
            let said =
                first.map_or_else(|| balance.name.clone(), |place| spoken(&balance.name, &number(place)));
            self.say(&format!("Unknown effort {said} in its positive sense"));
        }
    }

    /// An effort between the links of a pair.
    fn inside(
        &mut self,
        drawing: &mut Drawing,
        style: Style,
        pair: PairId,
        (length, positive): (f64, bool),
        (force, couple): (Text, Text),
    ) {
        let pair = self.scene.mechanism().pair(pair);
        if let PairKind::Revolute(pins) = &pair.kind {
            if let [_, second] = pins.as_slice()
                && self.scene.is_placed(second.link)
            {
                let at = self.on_paper(second.link, second.at);
                let middle = self.scene.body(second.link).u.angle() - COUPLE.1;
                self.arc(drawing, style, at, middle, positive, couple);
            }
        } else if let Some((at, along)) = self.line_of(pair) {
            let along = if positive { along } else { -along };
            self.push(drawing, style, at, along, length, force);
        }
    }

    /// A couple on a link.
    fn couple(
        &mut self,
        drawing: &mut Drawing,
        style: Style,
        (link, at): (LinkId, Option<Vec2>),
        ccw: bool,
        name: Text,
    ) {
        if !self.scene.is_placed(link) {
            return;
        }
        let at = at.map(|at| self.on_paper(link, at)).or_else(|| self.pivot(link));
        let Some(at) = at else { return };
        let middle = self.scene.body(link).u.angle() - COUPLE.1;
        self.arc(drawing, style, at, middle, ccw, name);
    }

    fn arc(&mut self, drawing: &mut Drawing, style: Style, at: Vec2, middle: f64, ccw: bool, name: Text) {
        let middle = self.free_middle(at, middle);
        let mut radius = COUPLE.0;
        let near = |(p, d): &(Vec2, Vec2), radius: f64| {
            let turned = wrapped(-d.angle() - middle).abs();
            (*p - at).norm() < 0.5 && (d.norm() - radius).abs() < 2.0 && turned < COUPLE.1
        };
        while self.taken.iter().any(|t| near(t, radius)) {
            radius += 2.4;
        }
        self.taken.push((at, Vec2::direction(-middle) * radius));
        arrow::turn(drawing, style, at, radius, (middle, COUPLE.1), ccw);
        let label_at = arrow::middle(at, radius, middle);
        let label = Label::at(name, LETTERS, label_at, 0.4).towards(label_at - at);
        drawing.label(label.coloured(style.text_role()).ranked(2));
    }

    /// The angle, on the ground, of a place for an arc arrow about a point: away from lines, supports and other arcs, and near
    /// one that is wanted.
    fn free_middle(&self, at: Vec2, wanted: f64) -> f64 {
        let mut busy: Vec<(f64, f64)> = self.lines_at(at).iter().map(|d| (-d.angle(), 1.1)).collect();
        if any_near(&self.supports, at, 0.05) {
            busy.push((-TAU / 4.0, 1.5));
        }
        let arcs = self.taken.iter().filter(|(p, d)| (*p - at).norm() < 0.5 && d.norm() > 2.0);
        busy.extend(arcs.map(|(_, d)| (-d.angle(), 1.5)));
        let price = |angle: f64| {
            let hits: f64 = busy.iter().map(|(b, room)| (room - wrapped(angle - b).abs()).max(0.0)).sum();
            3.0 * hits + 0.3 * wrapped(angle - wanted).abs()
        };
        let angles = (0..24).map(|i| wanted + TAU * f64::from(i) / 24.0);
        angles.min_by(|a, b| price(*a).total_cmp(&price(*b))).unwrap_or(wanted)
    }

    /// An arrow of a force or a velocity from a point; from the edge of a block where there is one, and beside others.
    fn push(&mut self, drawing: &mut Drawing, style: Style, at: Vec2, along: Vec2, length: f64, name: Text) {
        let mut from = at + along * self.clear(at, along);
        let side = along.perp();
        let mut shift = 0.0;
        while self
            .taken
            .iter()
            .any(|(p, d)| (*p - (from + side * shift)).norm() < BESIDE && d.dot(along) > 0.9)
        {
            shift += BESIDE;
        }
        from += side * shift;
        self.taken.push((from, along));
        let to = from + along * length;
        let (from, to) = self.onto_rail(at, along, length).unwrap_or((from, to));
        arrow::straight(drawing, style, from, to);
        // a label at the head, else beside the arrow
        let label = Label::along(name, LETTERS, from + along * (0.45 * length), to + along * 2.0);
        drawing.label(label.coloured(style.text_role()).ranked(2));
    }

    /// A force that presses a block on its rail comes from the other side: its head is at the block.
    fn onto_rail(&self, at: Vec2, along: Vec2, length: f64) -> Option<(Vec2, Vec2)> {
        let (_, _, u, half) = self.block_at(at)?;
        let is_rail = (half.y - guide::BLOCK.y).abs() < 1e-9;
        if !is_rail || guide::below(*u).dot(along) < 0.5 {
            return None;
        }
        let tip = at - along * self.clear(at, -along);
        Some((tip - along * length, tip))
    }

    /// The block on which a point lies.
    fn block_at(&self, at: Vec2) -> Option<&(LinkId, Vec2, Vec2, Vec2)> {
        self.blocks.iter().find(|(_, middle, u, half)| {
            let d = at - *middle;
            d.dot(*u).abs() <= half.x && d.cross(*u).abs() <= half.y
        })
    }

    /// How far a point is from the edge of the block, or of the hinge, on which it lies.
    fn clear(&self, at: Vec2, along: Vec2) -> f64 {
        if let Some((_, middle, u, half)) = self.block_at(at) {
            let d = at - *middle;
            let (x, y) = (d.dot(*u), u.cross(d));
            let (dx, dy) = (along.dot(*u), u.cross(along));
            let reach = |x: f64, dx: f64, half: f64| {
                if dx.abs() < 1e-9 { f64::INFINITY } else { (half * dx.signum() - x) / dx }
            };
            return reach(x, dx, half.x).min(reach(y, dy, half.y)) + 0.3;
        }
        let on_hinge = any_near(&self.labelled, at, 0.05);
        if on_hinge { hinge::RADIUS + 0.2 } else { 0.0 }
    }
}

/// A name with the number in its label.
fn spoken(name: &str, label: &Text) -> String {
    match label.plain().split_once(" = ") {
        Some((_, number)) if !name.is_empty() => format!("{name} = {number}"),
        _ => name.to_owned(),
    }
}

fn or<'s>(name: &'s str, other: &'s str) -> &'s str {
    if name.is_empty() { other } else { name }
}
