//! Profiles that touch: circles, lines, points, designed cams; wheels seen from the front.

use super::{Sketch, mass_shape};
use crate::scene::Scene;
use crate::symbol::wheel::spokes;
use crate::symbol::{gear, hinge, mass};
use assur_drawing::{Drawing, Label, Rect, Shape, Style, Text};
use assur_math::element::cam::Cam;
use assur_math::math::Vec2;
use assur_model::model::{CamContact, LinkId, PairId, PairKind, Profile, ProfileShape, Wheel};

use std::f64::consts::{FRAC_PI_2, TAU};

/// How far a flat face goes beyond its contact, mm.
const FACE: f64 = 7.0;
/// The same of the ground.
const GROUND: f64 = 16.0;
/// A circle of less than this is a roller, mm.
const LEAST: f64 = 0.6;
/// Size of the names of wheels, and where on their circles they are best.
const NAME: f64 = 3.4;
const DIAGONAL: Vec2 = Vec2::new(0.707, -0.707);
/// Steps of a cam's profile.
const STEPS: u32 = 360;

/// What profiles, wheels and masses with a shape take, m.
pub fn extent(scene: &Scene<'_>, bounds: &mut Rect) {
    extent_of(scene, |_| true, bounds);
    wheels_extent(scene, |_| true, bounds);
    mass_shape::extent(scene, bounds);
}

/// What the wheels of some links take, m.
pub(super) fn wheels_extent(scene: &Scene<'_>, wanted: impl Fn(LinkId) -> bool, bounds: &mut Rect) {
    for wheel in front(scene).filter(|wheel| wanted(wheel.link)) {
        if let Some(centre) = wheel.centre {
            round(bounds, scene.at(wheel.link, centre), wheel.radius);
        }
    }
}

pub(super) fn round(bounds: &mut Rect, centre: Vec2, radius: f64) {
    bounds.add(centre - Vec2::new(radius, radius));
    bounds.add(centre + Vec2::new(radius, radius));
}

/// What the profiles of some links take, m.
pub(super) fn extent_of(scene: &Scene<'_>, wanted: impl Fn(LinkId) -> bool, bounds: &mut Rect) {
    for pair in &scene.mechanism().pairs {
        let PairKind::Contact { first, second, .. } = &pair.kind else { continue };
        for profile in [first, second].into_iter().filter(|profile| wanted(profile.link)) {
            match profile.shape {
                ProfileShape::Circle(centre, radius) => round(bounds, scene.at(profile.link, centre), radius),
                ProfileShape::Rim(contact) => {
                    let Some(contact) = scene.mechanism().cam_contacts.get(contact) else { continue };
                    let Some(plate) = scene.mechanism().cams.get(contact.cam) else { continue };
                    let centre = scene.at(contact.disk, contact.centre);
                    let greatest =
                        (0..STEPS).step_by(6).map(|i| plate.cam.at(f64::from(i).to_radians()).contact.norm());
                    round(bounds, centre, greatest.fold(0.0, f64::max));
                }
                ProfileShape::Point(_) | ProfileShape::Line(..) => {}
            }
        }
    }
}

/// The wheels whose place and size are known.
pub(super) fn front<'a>(scene: &Scene<'a>) -> impl Iterator<Item = &'a Wheel> {
    let mechanism = scene.mechanism();
    let open = |wheel: &Wheel| mechanism.open_sizes.iter().any(|o| o.wheel == wheel.name);
    let placed: Vec<bool> = (0..mechanism.links.len()).map(|i| scene.is_placed(LinkId::at(i))).collect();
    mechanism.wheels.iter().filter(move |w| w.centre.is_some() && placed[w.link.index()] && !open(w))
}

impl Sketch<'_, '_> {
    /// Pitch circles of the wheels of some links.
    pub(super) fn wheels(&self, wanted: impl Fn(LinkId) -> bool, drawing: &mut Drawing) {
        for wheel in front(self.scene).filter(|wheel| wanted(wheel.link)) {
            let Some(centre) = wheel.centre else { continue };
            drawing.begin("wheel", &wheel.name);
            let (centre, radius) = (self.on_paper(wheel.link, centre), self.frame.length(wheel.radius));
            drawing.mark(Style::Medium, Shape::Circle { centre, radius });
            if wheel.link == LinkId::GROUND {
                let about = |third: u8| FRAC_PI_2 + TAU * f64::from(third) / 3.0;
                (0..3).for_each(|third| gear::held(drawing, centre, radius, about(third)));
            } else if self.motion.is_some() {
                spokes(drawing, centre, radius, self.angle_of(wheel.link));
            }
            let label = Label::at(Text::name(&wheel.name), NAME, centre + DIAGONAL * radius, 0.3);
            drawing.label(label.towards(DIAGONAL).ranked(5));
            drawing.end();
        }
    }

    /// Cams, discs, faces.
    pub(super) fn profiles(&self, drawing: &mut Drawing) {
        for (i, pair) in self.scene.mechanism().pairs.iter().enumerate() {
            let PairKind::Contact { first, second, .. } = &pair.kind else { continue };
            for profile in [first, second].into_iter().filter(|profile| self.shows(profile.link)) {
                drawing.begin("profile", &profile.name);
                match profile.shape {
                    ProfileShape::Circle(centre, radius) if !self.is_roller(profile, centre) => {
                        let centre = self.on_paper(profile.link, centre);
                        let radius = self.frame.length(radius);
                        drawing.mark(Style::Plate, Shape::Circle { centre, radius });
                        if self.motion.is_some() && profile.link != LinkId::GROUND {
                            spokes(drawing, centre, radius, self.angle_of(profile.link));
                        }
                    }
                    ProfileShape::Line(at, along) => self.face(drawing, PairId::at(i), profile, at, along),
                    ProfileShape::Rim(contact) => self.cam(drawing, contact),
                    ProfileShape::Circle(..) | ProfileShape::Point(_) => {}
                }
                drawing.end();
            }
        }
    }

    /// Whether a circle is the roller at the end of a link, and not a disc that turns about another point.
    fn is_roller(&self, profile: &Profile, centre: Vec2) -> bool {
        let joints = &self.shapes[profile.link.index()].joints;
        let apart = |a: Vec2, b: Vec2| self.frame.length((a - b).norm()) > LEAST;
        let hinged = self.scene.mechanism().pairs.iter().filter_map(|p| match &p.kind {
            PairKind::Revolute(pins) => pins.iter().find(|pin| pin.link == profile.link).map(|pin| pin.at),
            _ => None,
        });
        let radius = if let ProfileShape::Circle(_, r) = profile.shape { r } else { 0.0 };
        let inside = |at: Vec2| (at - centre).norm() < radius;
        // a disc has its hinge inside
        let disc = hinged.clone().any(|at| apart(at, centre) && inside(at));
        let turns_about_it = hinged.clone().count() == 1 && !hinged.clone().any(|at| apart(at, centre));
        // what no hinge holds slides
        !disc && joints.iter().any(|j| apart(*j, centre)) || turns_about_it || hinged.clone().count() == 0
    }

    /// Rollers, over the links that carry them.
    pub(super) fn rollers(&self, drawing: &mut Drawing) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Contact { first, second, .. } = &pair.kind else { continue };
            for profile in [first, second] {
                let ProfileShape::Circle(at, radius) = profile.shape else { continue };
                if !self.is_roller(profile, at) || !self.shows(profile.link) {
                    continue;
                }
                drawing.begin("profile", &profile.name);
                let centre = self.on_paper(profile.link, at);
                drawing.mark(Style::Medium, Shape::Circle { centre, radius: self.frame.length(radius) });
                hinge::moving(drawing, centre);
                drawing.end();
            }
            if let (None, Some((at, _))) = (self.only, self.scene.view().contact_normal(self.id(pair))) {
                drawing.begin("pair", &pair.name);
                mass::point(drawing, self.frame.point(at));
                drawing.end();
            }
        }
    }

    fn id(&self, pair: &assur_model::model::Pair) -> PairId {
        let pairs = &self.scene.mechanism().pairs;
        PairId::at(pairs.iter().position(|p| std::ptr::eq(p, pair)).unwrap_or(0))
    }

    /// A flat face around its contact, in a motion around all places of that, joined to the rest of its link.
    fn face(&self, drawing: &mut Drawing, pair: PairId, profile: &Profile, at: Vec2, along: Vec2) {
        let on_paper = |p: Vec2| self.on_paper(profile.link, p);
        let start = on_paper(at);
        let along_paper = self.direction(profile.link, along);
        let touch = |scene: &Scene<'_>| {
            let (place, _) = scene.view().contact_normal(pair)?;
            let body = scene.body(profile.link);
            Some(self.frame.length((place - body.position(at)).dot(along.turned(body.u))))
        };
        let frames = self.motion.map_or(std::slice::from_ref(self.scene), |motion| motion.frames);
        let reach = frames.iter().filter_map(touch);
        let (mut from, mut to) =
            reach.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)));
        if from > to {
            (from, to) = (0.0, 0.0);
        }
        let joints = self.shapes[profile.link.index()].joints.iter().map(|j| on_paper(*j));
        let mut feet = Vec::new();
        for joint in joints {
            let s = (joint - start).dot(along_paper);
            let foot = start + along_paper * s;
            (from, to) = (from.min(s), to.max(s));
            if (joint - foot).norm() > 0.3 {
                feet.push((joint, foot));
            }
        }
        if profile.link == LinkId::GROUND {
            let (a, b) = (start + along_paper * (from - GROUND), start + along_paper * (to + GROUND));
            drawing.line(Style::Link, a, b);
            hinge::hatch(drawing, a, b, crate::symbol::guide::below(along_paper));
            return;
        }
        drawing.line(Style::Link, start + along_paper * (from - FACE), start + along_paper * (to + FACE));
        for (joint, foot) in feet {
            drawing.line(Style::Link, joint, foot);
        }
    }

    /// The profile of a designed cam, its base circle, and the path of a roller's centre.
    fn cam(&self, drawing: &mut Drawing, contact: usize) {
        let Some((contact, cam)) = self.rim(drawing, contact) else { return };
        if cam.follower.shape().radius() > 0.0 {
            let pitch = self.around(contact, |phi| cam.in_cam(cam.at(phi).tip, phi));
            drawing.mark(Style::Way, Shape::polygon(pitch));
        }
        let (centre, radius) =
            (self.on_paper(contact.disk, contact.centre), self.frame.length(cam.base_radius));
        drawing.mark(Style::Axis, Shape::Circle { centre, radius });
    }

    /// The profile of a designed cam.
    fn rim(&self, drawing: &mut Drawing, contact: usize) -> Option<(&CamContact, &Cam)> {
        let mechanism = self.scene.mechanism();
        let contact = mechanism.cam_contacts.get(contact)?;
        let cam = &mechanism.cams.get(contact.cam)?.cam;
        let rim = self.around(contact, |phi| cam.in_cam(cam.at(phi).contact, phi));
        drawing.mark(Style::Plate, Shape::polygon(rim));
        Some((contact, cam))
    }

    /// Points around a cam, on paper.
    fn around(&self, contact: &CamContact, of: impl Fn(f64) -> Vec2) -> Vec<Vec2> {
        let place = |v: Vec2| self.on_paper(contact.disk, contact.centre + v);
        (0..STEPS).map(|i| place(of(f64::from(i).to_radians()))).collect()
    }
}
