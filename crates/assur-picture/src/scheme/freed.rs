//! Some links alone, without what holds them, as they look in the scheme.

use super::link::POINT;
use super::{LinkId, Sketch, any_near, geneva, profile};
use crate::paper::Frame;
use crate::scene::Scene;
use crate::shape::LinkShape;
use crate::symbol::hinge;
use assur_drawing::{Drawing, Label, Rect, Text};
use assur_model::model::PairKind;

/// Links that are drawn alone.
pub struct Freed<'l>(pub &'l [LinkId]);

impl Freed<'_> {
    /// What they take, m.
    pub fn extent(&self, scene: &Scene<'_>, shapes: &[LinkShape], bounds: &mut Rect) {
        let wanted = |link: LinkId| self.0.contains(&link);
        self.0.iter().for_each(|link| shapes[link.index()].extent(scene, *link, bounds));
        profile::extent_of(scene, wanted, bounds);
        profile::wheels_extent(scene, wanted, bounds);
        geneva::extent(scene, wanted, bounds);
    }

    /// On their guides, without hinges.
    pub fn on_guides(&self, scene: &Scene<'_>, shapes: &[LinkShape], frame: &Frame, drawing: &mut Drawing) {
        let mut sketch = self.sketch(scene, shapes, frame);
        sketch.walls(drawing);
        sketch.rails(drawing);
        sketch.touching(drawing);
        sketch.plates(drawing);
        sketch.draw_blocks(drawing);
        sketch.bars(drawing);
        sketch.slots(drawing);
        sketch.rollers(drawing);
        sketch.numbers(drawing);
    }

    /// With their hinges, blocks, slots, springs and mass centres too.
    pub fn draw(&self, scene: &Scene<'_>, shapes: &[LinkShape], frame: &Frame, drawing: &mut Drawing) {
        let mut sketch = self.sketch(scene, shapes, frame);
        sketch.touching(drawing);
        sketch.plates(drawing);
        sketch.draw_blocks(drawing);
        sketch.bars(drawing);
        sketch.slots(drawing);
        sketch.cylinders(drawing);
        sketch.springs(drawing);
        sketch.hinges(drawing);
        sketch.ends_of_cylinders(drawing);
        sketch.rollers(drawing);
        sketch.points(drawing);
        sketch.numbers(drawing);
    }

    fn sketch<'a, 's>(
        &'s self,
        scene: &'s Scene<'a>,
        shapes: &'s [LinkShape],
        frame: &'s Frame,
    ) -> Sketch<'a, 's> {
        Sketch { only: Some(self.0), ..Sketch::new(scene, shapes, frame) }
    }
}

impl Sketch<'_, '_> {
    /// Whether a link is drawn.
    pub(super) fn shows(&self, link: LinkId) -> bool {
        self.only.is_none_or(|only| only.contains(&link))
    }

    /// The hinges at the ends of cylinders, with the names of their points.
    fn ends_of_cylinders(&mut self, drawing: &mut Drawing) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Cylinder { from, to, .. } = &pair.kind else { continue };
            for pin in [from, to] {
                if !self.shows(pin.link) {
                    continue;
                }
                drawing.begin("pair", &pair.name);
                let at = self.on_paper(pin.link, pin.at);
                hinge::moving(drawing, at);
                if !any_near(&self.labelled, at, 0.05) {
                    let label = Label::at(Text::name(&pin.name), POINT, at, hinge::RADIUS).ranked(1);
                    drawing.label(self.away(label, at));
                    self.labelled.push(at);
                }
                drawing.end();
            }
        }
    }

    fn touching(&self, drawing: &mut Drawing) {
        self.wheels(|link| self.shows(link), drawing);
        self.meshing(|link| self.shows(link), drawing);
        self.profiles(drawing);
        self.genevas(|link| self.shows(link), drawing);
    }
}
