//! Belts, ropes with what they carry, nuts, ends of shafts.

use super::link::POINT;
use super::{LinkId, Sketch};
use crate::machine::{End, Rope, wound};
use crate::scene::Scene;
use crate::symbol::{arrow, gear, guide, hinge, wheel};
use assur_drawing::{Drawing, Label, Rect, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Bearing, PairId, PairKind, Transmission, TransmissionKind, Wheel};
use std::f64::consts::PI;

/// From an idler to the ceiling, and half the length of a piece of that.
const CEILING: f64 = 2.5;
const PIECE: f64 = 4.0;
/// Half the length and half the height of what a rope carries.
const LOAD: Vec2 = Vec2::new(5.0, 3.6);
/// Size of the names of ropes and idlers, and of angular velocities.
const SMALL: f64 = POINT * 0.75;
const LETTERS: f64 = 4.0;
/// A link that is a hinge alone.
const SHAFT: f64 = 3.4;
/// How far the guide of a nut goes beyond it.
const GUIDE: f64 = 6.0;

/// What ropes and threads take, m.
pub fn extent(scene: &Scene<'_>, bounds: &mut Rect) {
    let Some(laid) = scene.laid else { return };
    for station in laid.ropes.iter().flat_map(|rope| &rope.stations) {
        super::profile::round(bounds, scene.at(station.link, station.at), station.radius);
    }
    laid.threads.iter().for_each(|thread| super::profile::round(bounds, thread.at, thread.half));
}

/// Whether a link has a profile in a pair, or is a pin in its slot.
fn touches(kind: &PairKind, link: LinkId) -> bool {
    match kind {
        PairKind::Contact { first, second, .. } => first.link == link || second.link == link,
        PairKind::Slot(g) => g.slider == link,
        _ => false,
    }
}

impl Sketch<'_, '_> {
    /// A belt or a chain, with marks that run where it moves.
    pub(super) fn belt(&self, drawing: &mut Drawing, t: &Transmission, a: &Wheel, b: &Wheel) {
        let disc = |wheel: &Wheel| (self.centre(wheel), self.frame.length(wheel.radius));
        let (c_a, r_a) = disc(a);
        let crossed = super::crossed(t, a.link, b.link);
        for (from, to) in gear::tangents(disc(a), disc(b), crossed).into_iter().flatten() {
            drawing.line(Style::Medium, from, to);
            if self.motion.is_some() {
                // y of paper is down
                let sense = -(from - c_a).perp().dot(to - from).signum();
                wheel::running(drawing, from, to, sense * self.turned(a.link) * r_a);
            }
        }
    }

    /// A rope along all that it touches.
    pub(super) fn rope(&self, drawing: &mut Drawing, rope: &Rope) {
        drawing.begin("pair", &self.scene.mechanism().pair(rope.pair).name);
        let place = |i: usize| {
            let station = &rope.stations[i];
            (self.scene.at(station.link, station.at), station.radius * station.sense)
        };
        let runs = self.runs(rope);
        let mut longest: Option<(Vec2, Vec2)> = None;
        for i in 1..rope.stations.len() {
            let Some(ends) = wound(place(i - 1), place(i)) else { continue };
            let [from, to] = ends.map(|end| self.frame.point(end));
            drawing.line(Style::Medium, from, to);
            if self.motion.is_some() {
                wheel::running(drawing, from, to, self.frame.length(runs[i - 1]));
            }
            if longest.is_none_or(|(a, b)| (b - a).norm() < (to - from).norm()) {
                longest = Some((from, to));
            }
        }
        for (i, station) in rope.stations.iter().enumerate() {
            let (at, radius) = (self.frame.point(place(i).0), self.frame.length(station.radius));
            let run = runs.get(i.wrapping_sub(1)).or(runs.first()).copied().unwrap_or(0.0);
            self.station(drawing, &station.end, (at, radius), -station.sense * self.frame.length(run));
        }
        if let Some((a, b)) = longest {
            let words = format!("{} (rope)", self.scene.mechanism().pair(rope.pair).name);
            drawing.label(Label::along(Text::upright(&words), SMALL, a, b).ranked(5));
        }
        drawing.end();
    }

    /// A pulley, whose rim runs with the rope, or the place where the rope is fastened.
    fn station(&self, drawing: &mut Drawing, end: &End, (at, radius): (Vec2, f64), run: f64) {
        let ceiling = |drawing: &mut Drawing, at: Vec2| {
            let half = Vec2::new(PIECE, 0.0);
            drawing.line(Style::Medium, at - half, at + half);
            hinge::hatch(drawing, at - half, at + half, Vec2::new(0.0, -1.0));
        };
        match end {
            End::Ground(_) => return ceiling(drawing, at),
            End::Wheel(_) | End::Slider(_) => return,
            End::Over(_) | End::Under(_) => {}
        }
        drawing.mark(Style::Hinge, Shape::Circle { centre: at, radius });
        let held = match end {
            End::Under(link) => self.on_paper(*link, Vec2::zero()),
            _ => at - Vec2::new(0.0, radius + CEILING),
        };
        drawing.line(Style::Link, at, held);
        if let End::Over(_) = end {
            ceiling(drawing, held);
        }
        if self.motion.is_some() {
            wheel::spokes(drawing, at, radius, run / radius);
        }
        hinge::moving(drawing, at);
        if let End::Over(name) = end {
            drawing.label(Label::at(Text::upright(name), SMALL, at, radius).ranked(4));
        }
    }

    /// How far each part of a rope has run since the first frame, towards its last end, m.
    fn runs(&self, rope: &Rope) -> Vec<f64> {
        let down = |link: LinkId| -self.slid(link).y;
        // what it carries may go a part of its way: then the rope does
        let shares = self.scene.laid.map(|laid| laid.shares.as_slice()).unwrap_or_default();
        let own =
            rope.stations.iter().filter(|station| matches!(station.end, End::Slider(_) | End::Under(_)));
        let share =
            own.filter_map(|station| shares.get(station.link.index())).fold(1.0_f64, |a, b| a.min(*b));
        let mut run = 0.0;
        let runs = rope.stations.iter().map(|station| {
            match &station.end {
                End::Wheel(_) => run = station.sense * station.radius * self.turned(station.link) * share,
                End::Slider(link) => run = -down(*link),
                End::Under(link) => run -= 2.0 * down(*link),
                End::Over(_) => {}
                End::Ground(_) => run = 0.0,
            }
            run
        });
        runs.collect()
    }

    /// Blocks of sliders that were laid out: loads of ropes, nuts with the guide that keeps them from turning.
    pub(super) fn loads_on_ropes(&mut self, drawing: &mut Drawing) {
        let mechanism = self.scene.mechanism();
        let of = |kind: TransmissionKind, link: LinkId| {
            mechanism.pairs.iter().any(
                |pair| matches!(&pair.kind, PairKind::Transmission(t) if t.kind == kind && t.links.contains(&link)),
            )
        };
        for (i, pair) in mechanism.pairs.iter().enumerate() {
            let PairKind::Prismatic(g) = &pair.kind else { continue };
            let is_rack = of(TransmissionKind::Rack, g.slider);
            if pair.bearing != Some(Bearing::Placed) || is_rack {
                continue;
            }
            drawing.begin("link", self.link_name(g.slider));
            let at = self.on_paper(g.slider, Vec2::zero());
            let along = Vec2::new(1.0, 0.0);
            let is_nut = of(TransmissionKind::Screw, g.slider);
            let half = if is_nut { guide::BLOCK } else { LOAD };
            if is_nut {
                let (least, most) = self.scene.way(PairId::at(i));
                let here = (self.scene.at(g.slider, g.point) - g.through).dot(g.along);
                let ends = [least - here, most - here].map(|s| self.frame.length(s));
                guide::rail(drawing, at, along, (ends[0] - half.x - GUIDE, ends[1] + half.x + GUIDE));
            }
            guide::block(drawing, at, along, (-half.x, half.x), half.y);
            self.blocks.push((g.slider, at, along, half));
            drawing.end();
        }
    }

    /// Links that are a hinge alone, so that their turn is seen.
    pub(super) fn bare_shafts(&self, drawing: &mut Drawing) {
        let mechanism = self.scene.mechanism();
        for (i, outline) in self.outlines().iter().enumerate().skip(1).filter(|_| self.motion.is_some()) {
            let link = LinkId::at(i);
            let clutched = mechanism.pairs.iter().any(|pair| match &pair.kind {
                PairKind::Transmission(t) => t.kind == TransmissionKind::Clutch && t.links.contains(&link),
                _ => false,
            });
            let pin = mechanism.pairs.iter().find_map(|pair| match &pair.kind {
                PairKind::Revolute(pins) => pins.iter().find(|pin| pin.link == link),
                _ => None,
            });
            let drawn = !(outline.bars.is_empty() && outline.plates.is_empty() && outline.arms.is_empty())
                || self.blocks.iter().any(|block| block.0 == link)
                || mechanism.wheels.iter().any(|wheel| wheel.link == link)
                || mechanism.pairs.iter().any(|pair| touches(&pair.kind, link));
            let Some(pin) = pin.filter(|_| !drawn && !clutched) else { continue };
            if !self.scene.is_placed(link) || self.scene.is_in_cylinder(link) {
                continue;
            }
            drawing.begin("link", self.link_name(link));
            let centre = self.on_paper(link, pin.at);
            drawing.mark(Style::Medium, Shape::Circle { centre, radius: SHAFT });
            wheel::spokes(drawing, centre, SHAFT, self.angle_of(link));
            drawing.end();
        }
    }

    /// The axis of each shaft, whose bearing is in section, and the sense in which it turns: on its wheel, of a carrier on the way of its
    /// planet.
    pub(super) fn axes(&self, drawing: &mut Drawing) {
        let mechanism = self.scene.mechanism();
        for pair in mechanism.pairs.iter().filter(|pair| pair.bearing == Some(Bearing::Placed)) {
            let PairKind::Revolute(pins) = &pair.kind else { continue };
            let Some(link) = pins.last().map(|pin| pin.link) else { continue };
            let at = self.on_paper(link, Vec2::zero());
            hinge::moving(drawing, at);
            let omega = self.scene.body(link).omega;
            if omega == 0.0 || !omega.is_finite() {
                continue;
            }
            let own = mechanism.wheels.iter().filter(|wheel| wheel.link == link);
            let least = own.map(|wheel| self.frame.length(wheel.radius)).fold(f64::INFINITY, f64::min);
            let carried = mechanism.pairs.iter().find_map(|other| match &other.kind {
                PairKind::Revolute(pins) if other.bearing.is_some() && pins[0].link == link => {
                    Some(self.frame.length(pins[0].at.norm()))
                }
                _ => None,
            });
            let (radius, middle, sweep) = match carried {
                Some(arm) if arm > 4.0 => (arm, PI * 0.78, 9.0 / arm),
                _ if pins[0].link != LinkId::GROUND => (0.55 * least, 0.0, 1.4),
                _ => (0.5 * least.min(40.0), PI, 1.4),
            };
            if !radius.is_finite() || radius < 1.5 {
                continue;
            }
            drawing.begin("turn", self.link_name(link));
            arrow::turn(drawing, Style::Drive, at, radius, (middle, sweep), omega > 0.0);
            let tip = arrow::middle(at, radius, middle);
            let label = Label::at(self.scene.indexed("ω", link), LETTERS, tip, 0.5);
            drawing.label(label.towards(tip - at).coloured(Role::Blue).ranked(2));
        }
        drawing.end();
    }
}
