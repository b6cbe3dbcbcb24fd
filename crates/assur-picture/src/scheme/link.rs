//! Bars and plates, mass centres, named points, numbers of links.

use super::{Sketch, any_near};
use crate::inset::freest;
use crate::symbol::{guide, hinge, mass};
use assur_drawing::{Drawing, Label, Rect, Segment, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairKind};

/// Radius of the circle around the number of a link, and the size of its letters.
const RING: f64 = 2.5;
const NUMBER: f64 = 3.7;
/// Size of the names of links that have no number.
const NAME: f64 = 3.4;
/// Size of the names of points.
pub const POINT: f64 = 4.4;
/// Nearer than this, points are one, mm.
const SAME: f64 = 0.4;

impl Sketch<'_, '_> {
    pub(super) fn plates(&self, drawing: &mut Drawing) {
        for (i, outline) in self.outlines().iter().enumerate() {
            drawing.begin("link", self.link_name(LinkId::at(i)));
            for plate in &outline.plates {
                drawing.mark(Style::Plate, Shape::polygon(plate.clone()));
            }
            drawing.end();
        }
    }

    pub(super) fn bars(&self, drawing: &mut Drawing) {
        for (i, outline) in self.outlines().iter().enumerate() {
            drawing.begin("link", self.link_name(LinkId::at(i)));
            for (a, b) in &outline.arms {
                drawing.line(Style::Medium, *a, *b);
            }
            for (a, b) in &outline.bars {
                drawing.line(self.style_of(LinkId::at(i)), *a, *b);
            }
            drawing.end();
        }
    }

    /// The directions in which lines leave a point, on paper.
    pub(super) fn lines_at(&self, at: Vec2) -> Vec<Vec2> {
        let mut directions = Vec::new();
        for (_, line) in self.lines().iter().filter(|(around, _)| around.has(at)) {
            if line.distance(at) <= SAME {
                let ends = [line.a - at, line.b - at].into_iter().filter(|d| d.norm() > 2.0 * SAME);
                directions.extend(ends.filter_map(Vec2::unit));
            }
        }
        directions
    }

    /// The lines of all links on paper, each with the box of what is at it.
    fn lines(&self) -> &[(Rect, Segment)] {
        self.lines.get_or_init(|| {
            let mut lines = Vec::new();
            for outline in self.outlines() {
                let all = outline.bars.iter().chain(&outline.arms).copied().chain(outline.sides());
                let all = all.map(|(a, b)| Segment { a, b });
                lines.extend(all.map(|line| (line.bounds().grown(2.0 * SAME), line)));
            }
            lines
        })
    }

    /// Mass centres, and points that the author named.
    pub(super) fn points(&mut self, drawing: &mut Drawing) {
        let scene = self.scene;
        let pins = self.pins();
        let is_joint = |at: Vec2| any_near(&pins, at, SAME);
        for (i, link) in scene.mechanism().links.iter().enumerate().skip(1) {
            let id = LinkId::at(i);
            if !scene.is_placed(id) || scene.is_in_cylinder(id) || !self.shows(id) {
                continue;
            }
            let body = |at: Vec2| self.frame.point(scene.at(id, at));
            drawing.begin("link", &link.name);
            let centre = link.mass.filter(|m| m.mass > 0.0).map(|m| body(m.centre));
            if let Some(at) = centre.filter(|at| !is_joint(*at)) {
                mass::centre(drawing, at);
            }
            link.mass_parts.iter().for_each(|part| mass::part(drawing, body(part.own.centre)));
            for point in &link.points {
                let at = body(point.at);
                if any_near(&self.labelled, at, SAME) {
                    continue;
                }
                let is_centre = centre.is_some_and(|c| (c - at).norm() <= SAME);
                let is_joint = is_joint(at);
                if !is_centre && !is_joint {
                    mass::point(drawing, at);
                }
                self.labelled.push(at);
                let radius = if is_joint { hinge::RADIUS } else { mass::RADIUS };
                let label = Label::at(Text::name(&point.name), POINT, at, radius).ranked(2);
                drawing.label(self.away(label, at));
            }
            drawing.end();
        }
    }

    /// A label of a point best where no line goes.
    pub(super) fn away(&self, label: Label, at: Vec2) -> Label {
        match freest(&self.lines_at(at)) {
            Some(direction) => label.towards(direction),
            None => label,
        }
    }

    /// Hinges and pins on paper.
    fn pins(&self) -> Vec<Vec2> {
        let mut pins = Vec::new();
        for pair in &self.scene.mechanism().pairs {
            match &pair.kind {
                PairKind::Revolute(all) => {
                    let placed = all.iter().filter(|pin| self.scene.is_placed(pin.link));
                    pins.extend(placed.map(|pin| self.on_paper(pin.link, pin.at)));
                }
                PairKind::Slot(g) => pins.push(self.on_paper(g.slider, g.point)),
                PairKind::Cylinder { from, to, .. } => {
                    pins.extend([from, to].map(|pin| self.on_paper(pin.link, pin.at)));
                }
                _ => {}
            }
        }
        pins
    }

    /// The number of every link, off the link; the ground's at every fixed pair.
    pub(super) fn numbers(&self, drawing: &mut Drawing) {
        for (i, link) in self.scene.mechanism().links.iter().enumerate().skip(1) {
            let id = LinkId::at(i);
            // of links alone the forces need the room
            let named = self.only.is_none() || link.number.is_some();
            if !self.scene.is_placed(id) || !self.shows(id) || !named {
                continue;
            }
            drawing.begin("link", &link.name);
            if let Some(label) = self.axial_number(id).or_else(|| self.number(id)) {
                drawing.label(label);
            }
            drawing.end();
        }
    }

    /// The longest line of a link on paper.
    pub(super) fn longest(&self, link: LinkId) -> Option<(Vec2, Vec2)> {
        let outline = &self.outlines()[link.index()];
        outline
            .bars
            .iter()
            .copied()
            .chain(self.rods.iter().filter(|r| r.0 == link).map(|r| (r.1, r.2)))
            .chain(outline.sides())
            .filter(|(a, b)| (*b - *a).norm() > 4.0)
            .max_by(|a, b| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm()))
    }

    /// The number of a link at its longest line, or at its block.
    fn number(&self, link: LinkId) -> Option<Label> {
        if let Some((a, b)) = self.longest(link) {
            return Some(self.numbered(link, |text, size| Label::along(text, size, a, b)));
        }
        let block = self.blocks.iter().find(|b| b.0 == link);
        let at = match block {
            Some((_, at, _, _)) => *at,
            None => self.frame.point(self.scene.at(link, *self.shapes[link.index()].joints.first()?)),
        };
        let radius = block.map_or(hinge::RADIUS, |(_, _, _, half)| half.y);
        let label = self.numbered(link, |text, size| Label::at(text, size, at, radius));
        // off the rail
        Some(match block {
            Some((_, _, along, _)) => label.towards(-guide::below(*along)),
            None => label,
        })
    }

    /// The ground's number at a point of it.
    pub(super) fn ground_number(&self, drawing: &mut Drawing, at: Vec2) {
        if self.scene.mechanism().link(LinkId::GROUND).number.is_some() {
            let label = self.numbered(LinkId::GROUND, |text, size| Label::at(text, size, at, 1.0));
            drawing.label(label.towards(Vec2::new(1.0, 0.1)));
        }
    }

    fn numbered(&self, link: LinkId, at: impl Fn(Text, f64) -> Label) -> Label {
        match &self.scene.mechanism().link(link).number {
            Some(number) => at(Text::upright(number), NUMBER).ringed(RING).ranked(3),
            None => {
                let full = Text::name(self.link_name(link));
                // a name is no quantity
                let plain = full.full.clone();
                let letters: String = match &plain {
                    Some(_) => full.runs.iter().map(|r| r.letters.as_str()).collect(),
                    None => self.link_name(link).to_owned(),
                };
                let mut text = Text::upright(&letters);
                text.full = plain;
                at(text, NAME).ranked(5)
            }
        }
    }
}
