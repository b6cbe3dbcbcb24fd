//! Welds: a filled corner, on the ground a hatched clamp.

use super::{LinkId, Sketch, any_near};
use crate::inset::freest;
use crate::symbol::hinge;
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{PairKind, Pin};

/// Sides of a corner, mm.
const CORNER: f64 = 2.4;
/// Half the line of a clamp, mm.
const CLAMP: f64 = 4.7;
/// Lines whose directions differ by less are one.
const ONE_LINE: f64 = 0.05;

impl Sketch<'_, '_> {
    pub(super) fn welds(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        for pair in &scene.mechanism().pairs {
            let PairKind::Weld { pins, .. } = &pair.kind else { continue };
            let is_ground = |pin: &&Pin| pin.link == LinkId::GROUND;
            let Some(pin) = pins.iter().find(|pin| !is_ground(pin)) else { continue };
            drawing.begin("pair", &pair.name);
            let at = self.on_paper(pin.link, pin.at);
            let lines = self.lines_at(at);
            let first = lines.first().copied().unwrap_or(Vec2::new(1.0, 0.0));
            if pins.iter().any(|pin| is_ground(&pin)) {
                let along = first.perp() * CLAMP;
                drawing.line(Style::Medium, at - along, at + along);
                hinge::hatch(drawing, at - along, at + along, -first);
                self.ground_number(drawing, at + along - first * 3.0);
            } else {
                let second = lines.iter().copied().find(|line| line.cross(first).abs() > ONE_LINE);
                let second = second.unwrap_or_else(|| first.perp());
                let corner = vec![at, at + first * CORNER, at + second * CORNER];
                drawing.mark(Style::Solid, Shape::polygon(corner));
            }
            if !any_near(&self.labelled, at, 0.05) {
                let label =
                    Label::at(Text::name(&pair.name), super::link::POINT, at, hinge::RADIUS).ranked(1);
                drawing.label(freest(&lines).map_or(label.clone(), |direction| label.towards(direction)));
                self.labelled.push(at);
            }
            drawing.end();
        }
    }
}
