//! The train from the front, beside its section and at the same heights: pitch circles to scale, teeth where they meet.

use super::layout::{Drawn, Layout, Run, Shaft};
use super::rack::{Rack, racks};
use crate::scene::Scene;
use crate::symbol::gear::{MODULE, held, row};
use crate::symbol::{arrow, gear, hinge};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, TransmissionKind};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// From the section to the front view.
const BESIDE: f64 = 24.0;
/// The most wheels that are told apart in it.
const MOST: usize = 10;
/// How far axes go beyond the wheels.
const BEYOND: f64 = 4.0;
/// How far wheels that mesh may be from touching.
const TOUCH: f64 = 0.05;
const NAME: f64 = 3.6;
const LETTERS: f64 = 4.0;

/// The front view, where all wheels mesh, have their sizes and fit together.
pub fn draw(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) {
    let mechanism = scene.mechanism();
    if !exists(mechanism, layout) {
        return;
    }
    let widest = layout.wheels.iter().map(|w| w.radius).fold(0.0, f64::max);
    let front = Front { scene, layout, x: drawing.extent().max.x + BESIDE + widest };
    front.axes(drawing);
    layout.wheels.iter().for_each(|wheel| front.wheel(drawing, wheel));
    layout.runs.iter().for_each(|run| front.teeth(drawing, run));
    racks(mechanism, layout).iter().for_each(|rack| front.rack(drawing, rack));
    layout.shafts.iter().for_each(|shaft| front.shaft(drawing, shaft));
    layout.shafts.iter().for_each(|shaft| front.turn(drawing, shaft));
    drawing.end();
}

fn exists(mechanism: &Mechanism, layout: &Layout) -> bool {
    let meshes = |kind: &PairKind| match kind {
        PairKind::Transmission(t) => matches!(t.kind, TransmissionKind::Mesh | TransmissionKind::Rack),
        _ => true,
    };
    let touches = |run: &Run| {
        let [a, b] = run.wheels.map(|i| &layout.wheels[i]);
        let apart = (centre_level(mechanism, a) - centre_level(mechanism, b)).abs();
        let wanted = if run.internal { (a.radius - b.radius).abs() } else { a.radius + b.radius };
        (apart - wanted).abs() < TOUCH
    };
    let racks = racks(mechanism, layout);
    let is_rack = |link: &LinkId| racks.iter().any(|rack| rack.link == *link);
    let all = mechanism.pairs.iter().all(|p| meshes(&p.kind)) && layout.sliders.iter().all(|s| is_rack(&s.0));
    let some = !(layout.runs.is_empty() && racks.is_empty()) && layout.wheels.len() <= MOST;
    all && some && layout.scale(mechanism).is_some() && layout.runs.iter().all(touches)
}

/// The height of the axis of a wheel: of a ring of the ground that of the wheel in it tells it.
fn centre_level(mechanism: &Mechanism, wheel: &Drawn) -> f64 {
    match wheel.ring_at {
        Some(touch) if mechanism.wheels[wheel.wheel].link == LinkId::GROUND => touch - wheel.radius,
        _ => wheel.level,
    }
}

struct Front<'a, 's> {
    scene: &'s Scene<'a>,
    layout: &'s Layout,
    x: f64,
}

impl Front<'_, '_> {
    fn at(&self, level: f64) -> Vec2 {
        Vec2::new(self.x, -level)
    }

    fn centre(&self, wheel: &Drawn) -> Vec2 {
        self.at(centre_level(self.scene.mechanism(), wheel))
    }

    /// The line of all axes, and one across for each that does not move.
    fn axes(&self, drawing: &mut Drawing) {
        let circles = || self.layout.wheels.iter().map(|w| (self.centre(w).y, w.radius));
        let top = circles().map(|(y, r)| y - r).fold(f64::MAX, f64::min);
        let bottom = circles().map(|(y, r)| y + r).fold(f64::MIN, f64::max);
        let end = |y: f64| Vec2::new(self.x, y);
        drawing.line(Style::Axis, end(top - BEYOND), end(bottom + BEYOND));
        let mut done: Vec<f64> = Vec::new();
        for shaft in self.layout.shafts.iter().filter(|s| s.on == LinkId::GROUND) {
            if done.iter().any(|level| (level - shaft.level).abs() < TOUCH) {
                continue;
            }
            done.push(shaft.level);
            let at = self.at(shaft.level);
            let own = circles().filter(|(y, _)| (y - at.y).abs() < TOUCH);
            let reach = Vec2::new(own.map(|(_, r)| r).fold(0.0, f64::max) + BEYOND, 0.0);
            drawing.line(Style::Axis, at - reach, at + reach);
        }
    }

    fn wheel(&self, drawing: &mut Drawing, wheel: &Drawn) {
        let (centre, radius) = (self.centre(wheel), wheel.radius);
        let own = &self.scene.mechanism().wheels[wheel.wheel];
        drawing.begin("wheel", &own.name);
        drawing.mark(Style::Medium, Shape::Circle { centre, radius });
        if own.link == LinkId::GROUND {
            (0..3).for_each(|third| held(drawing, centre, radius, FRAC_PI_2 + TAU * f64::from(third) / 3.0));
        }
        // beside the teeth, which are above and below
        let side = Vec2::new(0.8, if wheel.ring_at.is_some() { -0.6 } else { 0.6 });
        let label = Label::at(Text::name(&own.name), NAME, centre + side * radius, 0.3);
        drawing.label(label.towards(-side).ranked(3));
    }

    fn teeth(&self, drawing: &mut Drawing, run: &Run) {
        let [a, b] = run.wheels.map(|i| &self.layout.wheels[i]);
        let own = &self.scene.mechanism().wheels;
        let Some(z) = own[a.wheel].teeth.filter(|_| own[b.wheel].teeth.is_some()) else { return };
        let module = (2.0 * a.radius / z).max(MODULE);
        drawing.begin("mesh", &own[a.wheel].name);
        for (wheel, other, shift) in [(a, b, 0.0), (b, a, 0.5)] {
            let (centre, towards) = (self.centre(wheel), self.centre(other).y - self.centre(wheel).y);
            let is_ring = run.internal && wheel.radius > other.radius;
            let down = if run.internal && !is_ring { towards < 0.0 } else { towards > 0.0 };
            let about = if down { FRAC_PI_2 } else { -FRAC_PI_2 };
            row(drawing, centre, wheel.radius, about, module, shift, if is_ring { -1.0 } else { 1.0 });
        }
    }

    fn rack(&self, drawing: &mut Drawing, rack: &Rack<'_>) {
        let (centre, radius) = (self.centre(rack.wheel), rack.wheel.radius);
        let side = rack.side(self.scene);
        let mechanism = self.scene.mechanism();
        drawing.begin("rack", &mechanism.link(rack.link).name);
        let teeth = mechanism.wheels[rack.wheel.wheel].teeth;
        gear::rack(drawing, (centre, radius), side, teeth, rack.link == LinkId::GROUND);
        if let Some(z) = teeth {
            let module = (2.0 * radius / z).max(MODULE);
            row(drawing, centre, radius, side.angle(), module, 0.0, 1.0);
        }
        let text = Text::upright(self.scene.link_label(rack.link));
        let end = centre + side * radius + side.perp() * radius;
        drawing.label(Label::at(text, NAME, end, 1.0).towards(side).ranked(3));
    }

    /// The end of a shaft; of one on a carrier with the arm that carries it.
    fn shaft(&self, drawing: &mut Drawing, shaft: &Shaft) {
        let at = self.at(shaft.level);
        drawing.begin("link", &self.scene.mechanism().link(shaft.link).name);
        if let Some(carrier) = self.carrier(shaft) {
            drawing.line(Style::Link, self.at(carrier.level), at);
            hinge::moving(drawing, self.at(carrier.level));
            let name = Text::upright(self.scene.link_label(carrier.link));
            drawing.label(Label::along(name, NAME, self.at(carrier.level), at).ranked(4));
        }
        hinge::moving(drawing, at);
    }

    fn carrier(&self, shaft: &Shaft) -> Option<&Shaft> {
        self.layout.shafts.iter().find(|s| s.link == shaft.on)
    }

    /// The sense in which a shaft turns.
    fn turn(&self, drawing: &mut Drawing, shaft: &Shaft) {
        let omega = self.scene.body(shaft.link).omega;
        if omega == 0.0 || !omega.is_finite() {
            return;
        }
        let own = |w: &&Drawn| self.scene.mechanism().wheels[w.wheel].link == shaft.link;
        let wheels = self.layout.wheels.iter().filter(own).map(|w| w.radius);
        let least = wheels.fold(f64::INFINITY, f64::min);
        let arm =
            self.layout.shafts.iter().find(|s| s.on == shaft.link).map(|s| (s.level - shaft.level).abs());
        // a carrier's arrow is on the way of its planet
        let (radius, middle, sweep) = match arm {
            Some(arm) if arm > 4.0 => (arm, PI * 0.78, 9.0 / arm),
            _ if self.carrier(shaft).is_some() => (0.55 * least, 0.0, 1.4),
            _ => (0.5 * least.min(40.0), -FRAC_PI_2, 1.4),
        };
        if !radius.is_finite() || radius < 1.5 {
            return;
        }
        let at = self.at(shaft.level);
        drawing.begin("turn", &self.scene.mechanism().link(shaft.link).name);
        arrow::turn(drawing, Style::Drive, at, radius, (middle, sweep), omega > 0.0);
        let tip = arrow::middle(at, radius, middle);
        let label = Label::at(self.scene.indexed("ω", shaft.link), LETTERS, tip, 0.5);
        drawing.label(label.towards(tip - at).coloured(assur_drawing::Role::Blue).ranked(2));
    }
}
