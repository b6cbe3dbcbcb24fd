//! Joints so near to each other that the scale hides what is between them, magnified in an inset.

use super::{LinkId, Sketch};
use crate::inset::Inset;
use crate::symbol::hinge;
use assur_drawing::{Drawing, Label, Role, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::PairKind;

/// Joints nearer than this are magnified, and those at least so far apart that they are not one, mm.
const NEAR: f64 = 4.0;
const APART: f64 = 0.05;
/// How far apart they are then, at least, mm.
const SEEN: f64 = 6.0;
/// The most insets of a scheme.
const MOST: usize = 2;
/// Size of the names.
const POINT: f64 = 3.6;

impl Sketch<'_, '_> {
    /// Insets of the joints that are nearest to each other.
    pub(super) fn hidden(&self, drawing: &mut Drawing) {
        let joints = self.joints();
        let mut near: Vec<(f64, Vec2)> = Vec::new();
        for (i, (_, a, _)) in joints.iter().enumerate() {
            for (_, b, _) in &joints[i + 1..] {
                let apart = (*b - *a).norm();
                if apart > APART && apart < NEAR {
                    near.push((apart, (*a + *b) * 0.5));
                }
            }
        }
        near.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut shown: Vec<Vec2> = Vec::new();
        for (apart, middle) in near {
            if shown.len() < MOST && shown.iter().all(|s| (*s - middle).norm() > NEAR) {
                shown.push(middle);
                self.magnified(drawing, &joints, middle, apart);
            }
        }
    }

    /// Hinges with their places on paper; whether they are on the ground.
    fn joints(&self) -> Vec<(&str, Vec2, bool)> {
        let hinges = self.scene.mechanism().pairs.iter().filter_map(|pair| {
            let PairKind::Revolute(pins) = &pair.kind else { return None };
            let pin = pins.iter().find(|p| p.link != LinkId::GROUND)?;
            let placed = pins.iter().all(|p| self.scene.is_placed(p.link));
            let fixed = pins.iter().any(|p| p.link == LinkId::GROUND);
            placed.then(|| (pair.name.as_str(), self.on_paper(pin.link, pin.at), fixed))
        });
        hinges.collect()
    }

    fn magnified(&self, drawing: &mut Drawing, joints: &[(&str, Vec2, bool)], at: Vec2, apart: f64) {
        drawing.begin("inset", "");
        let Some(inset) = Inset::of(drawing, at, (apart, SEEN)) else { return drawing.end() };
        for outline in self.outlines() {
            for (a, b) in outline.bars.iter().copied().chain(outline.sides()) {
                inset.line(drawing, Style::Link, a, b);
            }
        }
        for (name, joint, fixed) in joints.iter().filter(|(_, joint, _)| inset.shows(*joint)) {
            let place = inset.point(*joint);
            if *fixed {
                hinge::support(drawing, place);
            }
            hinge::moving(drawing, place);
            drawing.label(Label::at(Text::name(name), POINT, place, hinge::RADIUS).ranked(1));
        }
        inset.caption(drawing, Text::default(), Role::Ink);
        drawing.end();
    }
}
