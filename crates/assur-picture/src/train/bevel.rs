//! Bevel wheels in the section: cones towards the place where their axes meet; the axis of a planet stands upright.

use super::layout::{Drawn, LEAST, Layout, Shaft};
use super::{HOLLOW, NAME, bearing_across};
use crate::symbol::hinge;
use assur_drawing::{Drawing, Label, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Bevel, LinkId, Mechanism, Transmission, TransmissionKind, Wheel};

/// Half the length of a tooth, and half the gap between two.
const FACE: f64 = 3.5;
const GAP: f64 = 0.55;
/// From wheel to wheel of an upright axis, at least.
const STEP: f64 = 9.0;
/// How far an upright axis goes beyond its wheels.
const BEYOND: f64 = 5.0;
/// How far the pin of a planet goes down.
const PIN: f64 = 14.0;

/// Two bevel wheels, the one with the upright axis second.
#[derive(Clone, Copy, Debug)]
pub struct Cones {
    pub lying: usize,
    pub upright: usize,
    pub side: Bevel,
}

/// The cones of a mesh between two drawn wheels of these links.
pub fn cones(t: &Transmission, wheels: [usize; 2], links: [LinkId; 2]) -> Option<Cones> {
    let side = t.bevel.filter(|_| t.kind == TransmissionKind::Mesh)?;
    let first = t.bevel_planet().is_some_and(|(planet, _)| planet == links[0]);
    let [lying, upright] = if first { [wheels[1], wheels[0]] } else { wheels };
    Some(Cones { lying, upright, side })
}

/// Puts upright axes beside the wheels that they mesh with, and these where the cones touch.
pub fn place(layout: &mut Layout, mechanism: &Mechanism) {
    let all: Vec<Cones> = layout.runs.iter().filter_map(|run| run.cones).collect();
    let link_of = |layout: &Layout, wheel: usize| mechanism.wheels[layout.wheels[wheel].wheel].link;
    let mut done: Vec<LinkId> = Vec::new();
    for first in &all {
        let link = link_of(layout, first.upright);
        if done.contains(&link) {
            continue;
        }
        done.push(link);
        let own: Vec<Cones> = all.iter().filter(|c| link_of(layout, c.upright) == link).copied().collect();
        let level = |of: LinkId| layout.shafts.iter().find(|s| s.link == of).map(|s| s.level);
        let on = layout.shafts.iter().find(|s| s.link == link).map_or(LinkId::GROUND, |s| s.on);
        let axis = level(on).unwrap_or(layout.wheels[first.lying].level);
        for cones in &own {
            let lying = link_of(layout, cones.lying);
            layout.shafts.iter_mut().filter(|s| s.link == lying).for_each(|s| s.level = axis);
        }
        stand(layout, &own, axis);
        let (x, top) = (layout.wheels[first.upright].x, layout.wheels.iter().filter(|w| w.cone.is_some()));
        let on = |w: &&Drawn| mechanism.wheels[w.wheel].link == link;
        let top = top.filter(on).map(|w| w.level).fold(axis, f64::max) + BEYOND;
        if let Some(shaft) = layout.shafts.iter_mut().find(|s| s.link == link) {
            (shaft.upright, shaft.level) = (Some((x, axis)), top);
        }
    }
}

/// The wheels of one upright axis with those that they mesh with.
fn stand(layout: &mut Layout, own: &[Cones], axis: f64) {
    let mut wheels: Vec<(usize, f64)> = Vec::new();
    for cones in own {
        let height = layout.wheels[cones.lying].radius;
        match wheels.iter_mut().find(|w| w.0 == cones.upright) {
            Some(known) => known.1 = known.1.max(height),
            None => wheels.push((cones.upright, height)),
        }
    }
    wheels.sort_by(|a, b| b.1.total_cmp(&a.1));
    for i in 1..wheels.len() {
        wheels[i].1 = wheels[i].1.min(wheels[i - 1].1 - STEP).max(LEAST);
    }
    let reach = wheels.iter().map(|w| layout.wheels[w.0].radius).fold(0.0, f64::max);
    let from = wheels.iter().map(|w| layout.wheels[w.0].x).fold(f64::INFINITY, f64::min);
    let touched = |i: usize| own.iter().any(|c| c.lying == i || c.upright == i);
    for i in 0..layout.wheels.len() {
        if !touched(i) && layout.wheels[i].x > from {
            layout.wheels[i].x += 2.0 * reach;
        }
    }
    let x = from + reach;
    for (upright, height) in wheels {
        let radius = layout.wheels[upright].radius;
        let own_cones = own.iter().filter(|c| c.upright == upright);
        let set = |wheel: &mut Drawn, x: f64, level: f64, upright: bool| {
            (wheel.x, wheel.level, wheel.cone) = (x, level, Some((Vec2::new(from + reach, axis), upright)));
        };
        for cones in own_cones {
            let side = if cones.side == Bevel::Near { -radius } else { radius };
            let lying = &mut layout.wheels[cones.lying];
            lying.radius = height;
            set(lying, x + side, axis, false);
        }
        set(&mut layout.wheels[upright], x, axis + height, true);
    }
}

/// A wheel as a cone towards a place.
pub fn wheel(drawing: &mut Drawing, drawn: &Drawn, own: &Wheel, (apex, upright): (Vec2, bool)) {
    let centre = Vec2::new(drawn.x, drawn.level);
    let across = if upright { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
    let paper = |at: Vec2| Vec2::new(at.x, -at.y);
    let ends = [-1.0, 1.0].map(|side| {
        let end = centre + across * (side * drawn.radius);
        let along = (apex - end).unit().unwrap_or(across);
        // away from the wheel that meshes
        let inwards = centre - end;
        let away = (inwards - along * inwards.dot(along)).unit().unwrap_or(across);
        let end = end + away * GAP;
        drawing.line(Style::Link, paper(end), paper(end + along * (2.0 * FACE)));
        end
    });
    drawing.line(Style::Link, paper(ends[0]), paper(ends[1]));
    if own.link == LinkId::GROUND {
        let foot = paper(ends[0]);
        let half = Vec2::new(FACE, 0.0);
        hinge::hatch(drawing, foot - half, foot + half, Vec2::new(0.0, 1.0));
        drawing.line(Style::Medium, foot - half, foot + half);
    }
    let towards = Vec2::new(1.0, -0.3);
    drawing.label(Label::at(Text::name(&own.name), NAME, paper(ends[1]), 0.6).towards(towards).ranked(3));
}

/// An upright axis: of a planet a pin in the frame of its carrier, which goes around the wheels to its own shaft.
pub fn axis(drawing: &mut Drawing, (x, axis): (f64, f64), top: f64, carrier: Option<&Shaft>) {
    let at = |level: f64| Vec2::new(x, -level);
    if let Some(frame) = carrier.and_then(|carrier| carrier.frame) {
        let over = |level: f64| Vec2::new(frame, -level);
        drawing.line(Style::Link, at((top - PIN).max(axis + 2.0)), at(top));
        drawing.line(Style::Link, at(top), over(top));
        drawing.line(Style::Link, over(top), over(axis + HOLLOW));
        for side in [-1.6, 1.6] {
            let beside = Vec2::new(side, 0.0);
            drawing.line(Style::Medium, at(top - 1.2) + beside, at(top - BEYOND + 0.4) + beside);
        }
    } else {
        drawing.line(Style::Link, at(top - BEYOND), at(top + 2.0 * BEYOND));
        bearing_across(drawing, at(top + BEYOND));
    }
}
