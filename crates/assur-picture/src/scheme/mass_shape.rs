//! Masses with a shape: rods, discs, rings, spheres, plates; holes in them.

use super::Sketch;
use crate::scene::Scene;
use assur_drawing::{Drawing, Rect, Shape, Style};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, MassPart, MassShape};

/// The parts with a shape of the links that are placed.
fn shaped<'s>(scene: &Scene<'s>) -> impl Iterator<Item = (LinkId, &'s MassPart, &'s MassShape)> {
    let links = scene.mechanism().links.iter().enumerate().skip(1);
    let parts = links.flat_map(|(i, link)| link.mass_parts.iter().map(move |part| (LinkId::at(i), part)));
    let parts = parts.filter_map(|(id, part)| Some((id, part, part.shape.as_ref()?)));
    parts.filter(|(id, ..)| scene.is_placed(*id) && !scene.is_in_cylinder(*id))
}

/// What they take, m.
pub fn extent(scene: &Scene<'_>, bounds: &mut Rect) {
    for (link, part, shape) in shaped(scene) {
        match shape {
            MassShape::Disc { radius, .. } | MassShape::Ring { radius } | MassShape::Sphere { radius } => {
                super::profile::round(bounds, scene.at(link, part.own.centre), *radius);
            }
            MassShape::Rod { from, to } => {
                [from, to].into_iter().for_each(|at| bounds.add(scene.at(link, *at)))
            }
            MassShape::Plate { corners } => corners.iter().for_each(|at| bounds.add(scene.at(link, *at))),
        }
    }
}

impl Sketch<'_, '_> {
    /// Bodies first, then their holes.
    pub(super) fn mass_shapes(&self, drawing: &mut Drawing) {
        for hole in [false, true] {
            let parts = shaped(self.scene).filter(|(_, part, _)| (part.own.mass < 0.0) == hole);
            for (link, part, shape) in parts {
                drawing.begin("link", &self.scene.mechanism().link(link).name);
                self.mass_shape(link, part, shape, drawing);
                drawing.end();
            }
        }
    }

    fn mass_shape(&self, link: LinkId, part: &MassPart, shape: &MassShape, drawing: &mut Drawing) {
        let on_paper = |at: &Vec2| self.on_paper(link, *at);
        let centre = on_paper(&part.own.centre);
        let circle = |radius: f64| Shape::Circle { centre, radius: self.frame.length(radius) };
        let filled = if part.own.mass < 0.0 { Style::Block } else { Style::Plate };
        match shape {
            MassShape::Rod { from, to } => drawing.line(Style::Medium, on_paper(from), on_paper(to)),
            MassShape::Disc { radius, inner } => {
                drawing.mark(filled, circle(*radius));
                if *inner > 0.0 {
                    drawing.mark(Style::Block, circle(*inner));
                }
            }
            MassShape::Ring { radius } => drawing.mark(Style::Medium, circle(*radius)),
            MassShape::Sphere { radius } => drawing.mark(filled, circle(*radius)),
            MassShape::Plate { corners } => {
                drawing.mark(filled, Shape::polygon(corners.iter().map(on_paper).collect()));
            }
        }
    }
}
