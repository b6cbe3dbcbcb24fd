//! Geneva wheels: the wheel with all its slots, the locking disc of the crank, the pin.

use super::Sketch;
use crate::inset::flipped;
use crate::paper::Frame;
use crate::scene::Scene;
use crate::symbol::hinge;
use assur_drawing::{Drawing, Rect, Shape, Style, on_circle};
use assur_math::math::Vec2;
use assur_model::model::{GenevaPair, LinkId, PairKind};
use std::f64::consts::TAU;

/// Half the width of a slot, mm, and the most of it that the pitch of small wheels leaves.
const SLOT: (f64, f64) = (1.7, 0.35);
/// Radius of the locking disc as a part of the pin's circle: the file gives none.
const DISC: f64 = 0.72;
/// How deep a slot is below the lowest place of its pin, mm.
const BELOW: f64 = 1.7;

/// Sizes of a wheel, m: distance of the centres, radius of the pin's circle, radius of the rim.
fn sizes(scene: &Scene<'_>, wheel: &GenevaPair) -> Option<(f64, f64, f64)> {
    let PairKind::Slot(g) = &scene.mechanism().pair(wheel.pair).kind else { return None };
    let r = (g.point - wheel.crank_centre).norm();
    let a = r / wheel.law.ratio;
    // the pin enters where the slot begins
    let entry = Vec2::direction(wheel.law.half()) * r;
    Some((a, r, (Vec2::new(a, 0.0) - entry).norm()))
}

/// The box of the wheels and locking discs among some links, m.
pub fn extent(scene: &Scene<'_>, wanted: impl Fn(LinkId) -> bool, bounds: &mut Rect) {
    for wheel in &scene.mechanism().genevas {
        let Some((_, r, rim)) = sizes(scene, wheel) else { continue };
        let disc = DISC * r;
        let round = [(wheel.wheel, wheel.hub, rim), (wheel.crank, wheel.crank_centre, disc)];
        for (link, centre, radius) in round.into_iter().filter(|(link, ..)| wanted(*link)) {
            bounds.join(&Rect::around(scene.at(link, centre), Vec2::new(radius, radius)));
        }
    }
}

/// The outline of a wheel from slot to slot, about its hub, in the direction of growing angles on paper, mm.
fn outline(frame: &Frame, wheel: &GenevaPair, (a, r, rim): (f64, f64, f64), first: f64) -> Vec<Vec2> {
    let [a, r, rim] = [a, r, rim].map(|l| frame.length(l));
    let pitch = wheel.law.pitch();
    let half = SLOT.0.min(SLOT.1 * rim * pitch * 0.5);
    let bottom = (a - r - BELOW.min(0.3 * (a - r))).max(half);
    // where the rim ends at a slot, and where the locking arc begins and ends on the rim
    let mouth = libm::asin((half / rim).min(1.0));
    let disc = DISC * r;
    let cosine = (a * a + rim * rim - disc * disc) / (2.0 * a * rim);
    let bite = libm::acos(cosine.clamp(-1.0, 1.0)).min(0.5 * pitch - mouth);
    let mut points = Vec::new();
    for slot in 0..wheel.law.slots {
        let at = first + pitch * f64::from(slot);
        let (along, across) = (Vec2::direction(at), Vec2::direction(at).perp());
        points.push(along * (rim * libm::cos(mouth)) - across * half);
        for i in 0..=8 {
            let turn = Vec2::direction(TAU / 4.0 - TAU / 2.0 * f64::from(i) / 8.0);
            points.push(along * (bottom + half - turn.x.abs() * half) - across * (turn.y * half));
        }
        points.push(along * (rim * libm::cos(mouth)) + across * half);
        // the rim, the hollow that the disc of the crank holds, the rim
        let hollow = at + 0.5 * pitch;
        let centre = Vec2::direction(hollow) * a;
        let arc = |from: f64, to: f64| {
            (0..=6).map(move |i| Vec2::direction(from + (to - from) * f64::from(i) / 6.0) * rim)
        };
        points.extend(arc(at + mouth, hollow - bite));
        let begin = Vec2::direction(hollow - bite) * rim - centre;
        let end = Vec2::direction(hollow + bite) * rim - centre;
        let sweep = crate::inset::wrapped(end.angle() - begin.angle());
        let turned = |i: i32| begin.turned(Vec2::direction(sweep * f64::from(i) / 12.0));
        points.extend((1..12).map(|i| centre + turned(i)));
        points.extend(arc(hollow + bite, at + pitch - mouth));
    }
    points
}

impl Sketch<'_, '_> {
    /// Wheels and locking discs among some links.
    pub(super) fn genevas(&self, wanted: impl Fn(LinkId) -> bool, drawing: &mut Drawing) {
        for wheel in &self.scene.mechanism().genevas {
            let Some(sizes) = sizes(self.scene, wheel) else { continue };
            if wanted(wheel.wheel) {
                drawing.begin("link", self.link_name(wheel.wheel));
                let hub = self.on_paper(wheel.wheel, wheel.hub);
                let first = flipped(wheel.slot.turned(self.scene.body(wheel.wheel).u)).angle();
                let around = outline(self.frame, wheel, sizes, first);
                drawing.mark(Style::Plate, Shape::polygon(around.into_iter().map(|p| hub + p).collect()));
                drawing.end();
            }
            if wanted(wheel.crank) {
                self.locking_disc(wheel, sizes.1, drawing);
            }
        }
    }

    /// The disc of a crank whose pin turns on a circle of a radius, m.
    fn locking_disc(&self, wheel: &GenevaPair, r: f64, drawing: &mut Drawing) {
        drawing.begin("link", self.link_name(wheel.crank));
        let centre = self.on_paper(wheel.crank, wheel.crank_centre);
        let arm = flipped(wheel.arm.turned(self.scene.body(wheel.crank).u)).angle();
        let radius = DISC * self.frame.length(r);
        let (from, sweep) = (arm + wheel.law.half(), TAU - 2.0 * wheel.law.half());
        drawing.mark(Style::Medium, Shape::Arc { centre, radius, from, sweep });
        let ends = (on_circle(centre, radius, from), on_circle(centre, radius, from + sweep));
        // what the wheel turns through is cut out
        let cut = Shape::Lines { points: vec![ends.0, centre, ends.1], closed: false };
        drawing.mark(Style::Thin, cut);
        drawing.end();
    }

    /// Pins over bars and wheels.
    pub(super) fn pins_of_wheels(&self, drawing: &mut Drawing) {
        for wheel in &self.scene.mechanism().genevas {
            drawing.begin("pair", &self.scene.mechanism().pair(wheel.pair).name);
            let centre = self.on_paper(wheel.crank, wheel.pin);
            drawing.mark(Style::Hinge, Shape::Circle { centre, radius: hinge::PIN });
            drawing.end();
        }
    }
}
