//! Wheels in section, and what runs between them.

use super::layout::{BELL, Drawn, Layout, wheel_named};
use super::{HOLLOW, NAME, SMALL, bevel, rack, worm};
use crate::scene::Scene;
use crate::symbol::{hinge, thread};
use assur_drawing::{Drawing, Label, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Transmission, TransmissionKind};

/// Half the width of a wheel's face.
pub const FACE: f64 = 3.5;
/// Half the gap between the faces of two wheels that mesh.
const GAP: f64 = 0.55;
/// Half the length of a spindle.
const SCREW: f64 = 10.0;
/// How far a ring goes beyond its teeth.
const RING: f64 = 4.5;

pub fn draw(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) {
    for drawn in &layout.wheels {
        let wheel = &scene.mechanism().wheels[drawn.wheel];
        drawing.begin("wheel", &wheel.name);
        if let Some(cone) = drawn.cone {
            bevel::wheel(drawing, drawn, wheel, cone);
            drawing.end();
            continue;
        }
        let is_hollow = layout.shafts.iter().any(|s| s.link == wheel.link && s.hollow);
        let face = |drawing: &mut Drawing, level: f64| {
            let at = Vec2::new(drawn.x, -level);
            drawing.line(Style::Link, at - Vec2::new(FACE, 0.0), at + Vec2::new(FACE, 0.0));
        };
        let top = match drawn.ring_at {
            Some(touch) => {
                face(drawing, touch + GAP);
                let foot = drawn.level + if is_hollow { HOLLOW } else { 0.0 };
                ring(drawing, drawn.x, (touch + GAP, foot), wheel.link);
                touch + GAP
            }
            None => {
                let reach = drawn.radius - GAP;
                let (low, high) = (drawn.level - reach, drawn.level + reach);
                let at = |level: f64| Vec2::new(drawn.x, -level);
                if is_hollow {
                    drawing.line(Style::Link, at(low), at(drawn.level - HOLLOW));
                    drawing.line(Style::Link, at(drawn.level + HOLLOW), at(high));
                } else {
                    drawing.line(Style::Link, at(low), at(high));
                }
                face(drawing, low);
                face(drawing, high);
                high
            }
        };
        let at = Vec2::new(drawn.x + FACE, -top);
        let towards = Vec2::new(1.0, 0.3);
        drawing.label(Label::at(Text::name(&wheel.name), NAME, at, 0.4).towards(towards).ranked(3));
        drawing.end();
    }
}

/// The rim of a ring: hatched where it is of the ground, else a bell down to its shaft.
fn ring(drawing: &mut Drawing, x: f64, (touch, foot): (f64, f64), link: LinkId) {
    let top = touch + RING;
    drawing.line(Style::Link, Vec2::new(x, -touch), Vec2::new(x, -top));
    if link == LinkId::GROUND {
        let (a, b) = (Vec2::new(x - 6.0, -top), Vec2::new(x + 6.0, -top));
        drawing.line(Style::Medium, a, b);
        hinge::hatch(drawing, a, b, Vec2::new(0.0, -1.0));
    } else {
        let corner = Vec2::new(x + BELL, -top);
        drawing.line(Style::Link, Vec2::new(x, -top), corner);
        drawing.line(Style::Link, corner, Vec2::new(x + BELL, -foot));
    }
}

/// Belts, chains, ropes, racks, worms, screws, clutches.
pub fn transmissions(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) {
    let mechanism = scene.mechanism();
    for pair in &mechanism.pairs {
        let PairKind::Transmission(t) = &pair.kind else { continue };
        if t.links.iter().all(|link| layout.shafts.iter().all(|shaft| shaft.link != *link)) {
            continue;
        }
        drawing.begin("pair", &pair.name);
        let middle = match t.kind {
            TransmissionKind::Mesh | TransmissionKind::Rope => None,
            TransmissionKind::Belt | TransmissionKind::Chain => belt(mechanism, layout, t, drawing),
            TransmissionKind::Rack => rack(scene, layout, t, drawing),
            TransmissionKind::Worm => worm(mechanism, layout, t, drawing),
            TransmissionKind::Screw => screw(layout, t, drawing),
            TransmissionKind::Clutch => clutch(layout, t, drawing),
        };
        if let Some(at) = middle {
            let words = format!("{} ({})", pair.name, t.kind.word());
            drawing.label(Label::at(Text::upright(&words), SMALL, at, 0.6).ranked(5));
        }
        drawing.end();
    }
}

fn of_end<'l>(mechanism: &Mechanism, layout: &'l Layout, end: &str) -> Option<&'l Drawn> {
    layout.wheel(wheel_named(mechanism, end)?)
}

fn belt(mechanism: &Mechanism, layout: &Layout, t: &Transmission, drawing: &mut Drawing) -> Option<Vec2> {
    let [first, second] = t.ends.as_slice() else { return None };
    let (a, b) = (of_end(mechanism, layout, first)?, of_end(mechanism, layout, second)?);
    let (low, high) = if a.level <= b.level { (a, b) } else { (b, a) };
    for side in [-2.0, 2.0] {
        let from = Vec2::new(low.x + side, -(low.level + low.radius));
        let to = Vec2::new(high.x + side, -(high.level - high.radius));
        drawing.line(Style::Medium, from, to);
    }
    Some(Vec2::new(low.x + 2.0, -(low.level + low.radius + high.level - high.radius) / 2.0))
}

/// A rack below its wheel; a slider has its own block.
fn rack(scene: &Scene<'_>, layout: &Layout, t: &Transmission, drawing: &mut Drawing) -> Option<Vec2> {
    let all = rack::racks(scene.mechanism(), layout);
    let own = all.into_iter().find(|rack| std::ptr::eq(rack.pair, t))?;
    if layout.sliders.iter().all(|(link, _)| *link != own.link) {
        own.section(scene, drawing);
    }
    Some(own.middle())
}

/// A worm above its wheel, from its end; of one on a shaft with other wheels the shaft leads to it.
fn worm(mechanism: &Mechanism, layout: &Layout, t: &Transmission, drawing: &mut Drawing) -> Option<Vec2> {
    let at = worm::section(drawing, &layout.wheels[worm::wheel(mechanism, layout, t)?]);
    if let Some(shaft) = layout.shafts.iter().find(|s| Some(&s.link) == t.links.first()) {
        let end = Vec2::new(if shaft.right { shaft.ends.0 } else { shaft.ends.1 }, -shaft.level);
        drawing.line(Style::Axis, end, at);
    }
    Some(at)
}

/// A spindle with its nut on it.
fn screw(layout: &Layout, t: &Transmission, drawing: &mut Drawing) -> Option<Vec2> {
    let shaft = layout.shafts.iter().find(|s| t.links.contains(&s.link))?;
    thread::thread(drawing, shaft.spindle(), SCREW, 0.0);
    Some(shaft.spindle() + Vec2::new(SCREW, 0.0))
}

/// Two discs that face each other; the second of a backstop is of the ground.
fn clutch(layout: &Layout, t: &Transmission, drawing: &mut Drawing) -> Option<Vec2> {
    let shafts: Vec<_> = layout.shafts.iter().filter(|s| t.links.contains(&s.link)).collect();
    let level = shafts.first()?.level;
    let x = match shafts.as_slice() {
        [a, b, ..] => (a.ends.1.min(b.ends.1) + a.ends.0.max(b.ends.0)) / 2.0,
        _ => shafts[0].ends.1 + 3.0,
    };
    let ends = |side: f64| [-4.5, 4.5].map(|half| Vec2::new(x + side, -level + half));
    for [a, b] in [-0.8, 0.8].map(ends) {
        drawing.line(Style::Link, a, b);
    }
    if let [only] = shafts.as_slice() {
        drawing.line(Style::Link, Vec2::new(only.ends.1, -level), Vec2::new(x - 0.8, -level));
        let [a, b] = ends(0.8);
        hinge::hatch(drawing, a, b, Vec2::new(1.0, 0.0));
    }
    Some(Vec2::new(x, -level - 4.5))
}
