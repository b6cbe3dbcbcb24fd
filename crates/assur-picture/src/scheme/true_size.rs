//! The mechanism at one position in its own millimetres, for CAD: joints, axes, circles, profiles and paths without symbols.

use super::{LinkId, Scheme, Sketch, ways};
use crate::error;
use crate::paper::Frame;
use crate::scene::Scene;
use crate::shape::{LinkShape, hull, shapes};
use crate::words;
use assur_drawing::{Drawing, Scale, Shape, Style};
use assur_math::element::cam::MOST_STEPS;
use assur_math::math::Vec2;
use assur_model::model::{Guide, PairId, PairKind, Pin, Profile, ProfileShape};
use assur_text::diagnostic::Diagnosis;

/// A millimetre of paper is one of the mechanism.
const TRUE: Scale = Scale { mantissa: 1.0, exponent: -3 };
/// How far the polygon of a cam may be off its profile, m.
const WITHIN: f64 = 10e-6;
/// How far joints may be off a line to be on it, as a part of its length.
const IN_LINE: f64 = 1e-9;

/// The mechanism at a position, one millimetre for each of its own; the origin is that of the ground.
///
/// # Errors
/// No link has a place; a path is wanted of a point that is not there, or where the drive has no way.
pub fn true_size(scene: &Scene<'_>, wanted: &Scheme) -> Result<Drawing, Diagnosis> {
    let is_placed = |i: usize| scene.is_placed(LinkId::at(i));
    if !(1..scene.mechanism().links.len()).any(is_placed) {
        return Err(error::no_true_size(scene));
    }
    let traced = ways::traced(scene, wanted)?;
    let (shapes, frame) = (shapes(scene), Frame::new(Some(TRUE), Vec2::zero()));
    let mut drawing = Drawing::new(&words::id(scene, "true-size"), String::new(), String::new());
    let mut sketch = Sketch::new(scene, &shapes, &frame);
    sketch.paths(&mut drawing, &traced);
    for (i, shape) in shapes.iter().enumerate().filter(|(i, _)| is_placed(*i)) {
        sketch.true_link(&mut drawing, LinkId::at(i), shape);
    }
    for i in 0..scene.mechanism().pairs.len() {
        sketch.true_pair(&mut drawing, PairId::at(i));
    }
    sketch.true_wheels(&mut drawing);
    drawing.title = format!("{}: true size{}", words::title(scene), words::at_position(scene));
    Ok(drawing)
}

impl Sketch<'_, '_> {
    /// The lines between the joints of a link, and its points.
    fn true_link(&self, drawing: &mut Drawing, link: LinkId, shape: &LinkShape) {
        let own = self.scene.mechanism().link(link);
        drawing.begin("link", &own.name);
        if link != LinkId::GROUND && !self.scene.is_in_cylinder(link) {
            let joints = if shape.is_wedge() { &shape.wedge } else { &shape.joints };
            let joints: Vec<Vec2> = joints.iter().map(|at| self.on_paper(link, *at)).collect();
            match line_of(&joints) {
                Ok(Some((a, b))) => drawing.line(Style::Link, a, b),
                Ok(None) => {}
                Err(()) => drawing.mark(Style::Link, Shape::polygon(hull(&joints))),
            }
        }
        own.points.iter().for_each(|point| self.true_point(drawing, link, point.at));
        drawing.end();
    }

    /// Where a pair is, and along which line it slides.
    fn true_pair(&self, drawing: &mut Drawing, id: PairId) {
        let pair = self.scene.mechanism().pair(id);
        drawing.begin("pair", &pair.name);
        match &pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                if let Some(Pin { link, at, .. }) = pins.iter().find(|pin| self.scene.is_placed(pin.link)) {
                    self.true_point(drawing, *link, *at);
                }
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => self.true_guide(drawing, id, g),
            PairKind::Cylinder { from, to, .. } => {
                let [a, b] = [from, to].map(|pin| self.on_paper(pin.link, pin.at));
                drawing.line(Style::Axis, a, b);
            }
            PairKind::Contact { first, second, .. } => {
                [first, second].into_iter().for_each(|profile| self.true_profile(drawing, id, profile));
            }
            PairKind::Transmission(_) => {}
        }
        drawing.end();
    }

    /// The line of a guide as far as it is used, from the point that gives it; the point that slides.
    fn true_guide(&self, drawing: &mut Drawing, id: PairId, g: &Guide) {
        if !self.scene.is_placed(g.slider) || !self.scene.is_placed(g.guide) {
            return;
        }
        let (least, greatest) = self.scene.way(id);
        let [a, b] =
            [least.min(0.0), greatest.max(0.0)].map(|s| self.on_paper(g.guide, g.through + g.along * s));
        if a != b {
            drawing.line(Style::Axis, a, b);
        }
        self.true_point(drawing, g.slider, g.point);
    }

    /// What touches something.
    fn true_profile(&self, drawing: &mut Drawing, pair: PairId, profile: &Profile) {
        match profile.shape {
            ProfileShape::Point(at) => self.true_point(drawing, profile.link, at),
            ProfileShape::Circle(at, radius) => {
                let (centre, radius) = (self.on_paper(profile.link, at), self.frame.length(radius));
                drawing.mark(Style::Medium, Shape::Circle { centre, radius });
            }
            ProfileShape::Line(at, _) => {
                if let Some((touch, _)) = self.scene.view().contact_normal(pair) {
                    drawing.line(Style::Link, self.on_paper(profile.link, at), self.frame.point(touch));
                }
            }
            ProfileShape::Rim(contact) => {
                let mechanism = self.scene.mechanism();
                let Some(contact) = mechanism.cam_contacts.get(contact) else { return };
                let Some(plate) = mechanism.cams.get(contact.cam) else { return };
                let steps = plate.cam.steps_within(WITHIN).unwrap_or(MOST_STEPS);
                let rim = plate.cam.profile(steps).into_iter();
                let rim = rim.map(|v| self.on_paper(contact.disk, contact.centre + v)).collect();
                drawing.mark(Style::Plate, Shape::polygon(rim));
                self.true_point(drawing, contact.disk, contact.centre);
            }
        }
    }

    fn true_wheels(&self, drawing: &mut Drawing) {
        for wheel in super::profile::front(self.scene) {
            let Some(at) = wheel.centre else { continue };
            drawing.begin("wheel", &wheel.name);
            let (centre, radius) = (self.on_paper(wheel.link, at), self.frame.length(wheel.radius));
            drawing.mark(Style::Thin, Shape::Circle { centre, radius });
            drawing.end();
        }
    }

    fn true_point(&self, drawing: &mut Drawing, link: LinkId, at: Vec2) {
        let centre = self.on_paper(link, at);
        drawing.mark(Style::Solid, Shape::Circle { centre, radius: 0.0 });
    }
}

/// The two points that are farthest from each other, if all others are on the line between them; none where all are one.
fn line_of(points: &[Vec2]) -> Result<Option<(Vec2, Vec2)>, ()> {
    let pairs = points.iter().enumerate().flat_map(|(i, a)| points[i + 1..].iter().map(move |b| (*a, *b)));
    let apart = |(a, b): &(Vec2, Vec2)| (*b - *a).norm();
    let Some((a, b)) = pairs.max_by(|one, other| apart(one).total_cmp(&apart(other))) else {
        return Ok(None);
    };
    let length = apart(&(a, b));
    if points.iter().any(|p| (*p - a).cross(b - a).abs() > IN_LINE * length * length) {
        return Err(());
    }
    Ok((length > 0.0).then_some((a, b)))
}
