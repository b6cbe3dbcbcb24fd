//! The profile with base circle, path of the roller's centre, follower, common normal and pressure angle.

use crate::inset::flipped;
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Subject;
use crate::scheme::length_scale;
use crate::symbol::{arrow, guide, hinge};
use crate::words;
use assur_drawing::{Drawing, Label, Level, Rect, Role, Shape, Style, Text};
use assur_math::element::cam::{Cam, CamPoint, Follower, Quantity, Shape as End};
use assur_math::math::Vec2;
use assur_model::model::{CamContact, LinkId, Pair, PairKind, PlateCam};
use assur_text::diagnostic::Diagnosis;

/// What symbols and labels take beside the cam, mm.
const AROUND: Vec2 = Vec2::new(30.0, 26.0);
const NAMES: f64 = 4.2;
/// How far the normal goes beyond contact and tip, mm.
const NORMAL: (f64, f64) = (10.0, 20.0);
/// Length of the arrow along the way of the tip, and radius of the arc of the pressure angle, mm.
const WAY: f64 = 18.0;
const ARC: f64 = 11.0;
/// How far a flat face goes beyond its contact, in base radii.
const FACE: f64 = 0.9;

/// The profile at a position.
///
/// # Errors
/// A scale is wanted that does not fit.
pub fn profile(
    subject: &Subject<'_, '_>,
    placed: &PlacedCam<'_>,
    paper: &Paper,
) -> Result<Drawing, Diagnosis> {
    let rim = placed.around(|at| at.contact);
    let tips = placed.around(|at| at.tip);
    let bounds = extent(placed, &rim, &tips);
    let frame = paper.frame(Scaled::Length, &bounds, AROUND)?;
    let name = &placed.plate.name;
    let scene = subject.scene.filter(|_| placed.contact.is_some());
    let place = scene.map(words::at_position).unwrap_or_default();
    let title = format!("{}: cam {name}{place}", subject.title());
    let id = format!("{}-{name}", subject.id("cam"));
    let mut drawing = Drawing::new(&id, title, said(placed));
    let sketch = Sketch { subject, placed, frame: &frame };
    sketch.plate(&mut drawing, &rim, &tips);
    sketch.follower(&mut drawing);
    sketch.hub(&mut drawing);
    sketch.pressure(&mut drawing);
    if let Some(scale) = frame.scale {
        drawing.captions.push(length_scale(&scale));
        drawing.description += &format!(" Length scale {} m per mm.", scale.text());
    }
    Ok(drawing)
}

fn said(placed: &PlacedCam<'_>) -> String {
    let cam = placed.cam();
    format!(
        "Profile of the cam {}, which turns {}, with base circle and follower at the cam angle {:.2}°. Pressure angle {:.2}°. Base \
         radius {:.2} mm.",
        placed.plate.name,
        if cam.ccw { "counter-clockwise" } else { "clockwise" },
        placed.phi.to_degrees(),
        placed.at.pressure_angle.to_degrees(),
        cam.base_radius * 1e3,
    )
}

/// The end of a translating follower's rod, from the tip on, m.
fn rod(placed: &PlacedCam<'_>) -> f64 {
    let cam = placed.cam();
    cam.base_radius + cam.program.greatest_lift() - cam.program.least_lift().1
}

fn extent(placed: &PlacedCam<'_>, rim: &[Vec2], tips: &[Vec2]) -> Rect {
    let cam = placed.cam();
    let mut bounds = Rect::NOTHING;
    rim.iter().chain(tips).for_each(|p| bounds.add(*p));
    let r = Vec2::new(cam.base_radius, cam.base_radius);
    let centre = placed.on_ground(Vec2::zero());
    bounds.add(centre - r);
    bounds.add(centre + r);
    match cam.follower {
        Follower::Oscillating { pivot_distance, .. } => {
            bounds.add(placed.on_ground(Vec2::new(pivot_distance, 0.0)));
        }
        Follower::Translating { .. } => {
            bounds.add(placed.on_ground(placed.at.tip + Vec2::new(rod(placed), 0.0)));
        }
    }
    bounds
}

struct Sketch<'a, 's> {
    subject: &'s Subject<'s, 'a>,
    placed: &'s PlacedCam<'a>,
    frame: &'s Frame,
}

impl Sketch<'_, '_> {
    fn paper(&self, v: Vec2) -> Vec2 {
        self.frame.point(self.placed.on_ground(v))
    }

    /// The profile, the path of the roller's centre, the base circle.
    fn plate(&self, drawing: &mut Drawing, rim: &[Vec2], tips: &[Vec2]) {
        drawing.begin("profile", &self.placed.plate.name);
        let on_paper = |points: &[Vec2]| points.iter().map(|p| self.frame.point(*p)).collect::<Vec<_>>();
        drawing.mark(Style::Plate, Shape::polygon(on_paper(rim)));
        let cam = self.placed.cam();
        if cam.follower.shape().radius() > 0.0 {
            drawing.mark(Style::Way, Shape::polygon(on_paper(tips)));
        }
        let radius = self.frame.length(cam.base_radius);
        drawing.mark(Style::Axis, Shape::Circle { centre: self.paper(Vec2::zero()), radius });
        drawing.end();
    }

    fn follower(&self, drawing: &mut Drawing) {
        let (at, cam) = (&self.placed.at, self.placed.cam());
        drawing.begin("link", self.placed.contact.map_or("follower", |c| self.link_name(c.follower)));
        let tip = self.paper(at.tip);
        let base = match cam.follower {
            Follower::Oscillating { pivot_distance, .. } => self.paper(Vec2::new(pivot_distance, 0.0)),
            Follower::Translating { .. } => {
                let foot = if cam.follower.shape() == End::Flat { Vec2::new(at.tip.x, 0.0) } else { at.tip };
                self.paper(foot + Vec2::new(rod(self.placed), 0.0))
            }
        };
        match (cam.follower, cam.follower.shape()) {
            (Follower::Oscillating { .. }, End::Flat) => {
                let along = flipped(self.placed.direction(at.normal.perp()));
                let touch = self.paper(at.contact);
                let foot = touch + along * (base - touch).dot(along);
                drawing.line(Style::Link, base, foot);
                self.face(drawing, touch, along, (foot - touch).dot(along));
            }
            (Follower::Translating { .. }, End::Flat) => {
                let foot = self.paper(Vec2::new(at.tip.x, 0.0));
                let along = flipped(self.placed.direction(Vec2::new(0.0, 1.0)));
                drawing.line(Style::Link, foot, base);
                let touch = self.paper(at.contact);
                self.face(drawing, touch, along, (foot - touch).dot(along));
            }
            (_, shape) => {
                drawing.line(Style::Link, tip, base);
                if let End::Roller(radius) = shape {
                    let radius = self.frame.length(radius);
                    drawing.mark(Style::Medium, Shape::Circle { centre: tip, radius });
                    hinge::moving(drawing, tip);
                }
            }
        }
        match cam.follower {
            Follower::Oscillating { .. } => {
                hinge::support(drawing, base);
                hinge::moving(drawing, base);
                if let Some(contact) = self.placed.contact {
                    self.pivot(drawing, contact.follower, base);
                }
            }
            Follower::Translating { .. } => {
                let along = flipped(self.placed.direction(Vec2::new(1.0, 0.0)));
                guide::fixed(drawing, base - along * 7.0, along);
            }
        }
        drawing.end();
        if let Some(contact) = self.placed.contact {
            let middle = (tip + base) * 0.5;
            self.number(drawing, contact.follower, middle, 1.0);
        }
    }

    /// A flat face on both sides of its contact, and as far as the foot of its link.
    fn face(&self, drawing: &mut Drawing, touch: Vec2, along: Vec2, foot: f64) {
        let reach = FACE * self.frame.length(self.placed.cam().base_radius);
        let (from, to) = (foot.min(0.0) - 0.35 * reach, foot.max(0.0) + 0.35 * reach);
        drawing.line(Style::Link, touch + along * from, touch + along * to);
    }

    /// The hinge of the cam, its sense and its number.
    fn hub(&self, drawing: &mut Drawing) {
        let centre = self.paper(Vec2::zero());
        drawing.begin("pair", "");
        hinge::support(drawing, centre);
        hinge::moving(drawing, centre);
        drawing.begin("drive", &self.placed.plate.name);
        let ccw = self.placed.cam().ccw;
        arrow::turn(drawing, Style::Drive, centre, 7.5, (std::f64::consts::FRAC_PI_2, 1.4), ccw);
        let disk = self.placed.contact.map(|c| c.disk);
        let letter =
            disk.map_or_else(|| Text::italic("ω"), |disk| Text::italic("ω").lowered(self.link_label(disk)));
        let top = centre - Vec2::new(0.0, 7.5);
        drawing.label(Label::at(letter, NAMES, top, 0.6).coloured(Role::Blue).ranked(2));
        drawing.end();
        if let Some(disk) = disk {
            self.pivot(drawing, disk, centre);
            self.number(drawing, disk, centre, 9.0);
        }
    }

    /// The common normal, the way of the tip, the angle between them.
    fn pressure(&self, drawing: &mut Drawing) {
        let at = &self.placed.at;
        let (tip, touch) = (self.paper(at.tip), self.paper(at.contact));
        let normal = flipped(self.placed.direction(at.normal));
        drawing.begin("normal", "");
        let (from, to) = (touch - normal * NORMAL.0, tip + normal * NORMAL.1);
        drawing.line(Style::Axis, from, to);
        drawing.mark(Style::Solid, Shape::Circle { centre: touch, radius: 0.6 });
        for (end, side) in [(from, -1.0), (to, 1.0)] {
            drawing.label(Label::at(Text::italic("n"), NAMES, end, 0.4).towards(normal * side).ranked(3));
        }
        if let Some(contact) = self.placed.contact {
            let name = Text::name(&self.subject.mechanism.pair(contact.pair).name);
            drawing.label(Label::at(name, NAMES, touch, 1.0).ranked(4));
        }
        drawing.begin("vector", "v");
        // the way on which the normal pushes
        let way = self.way();
        let way = if way.dot(normal) < 0.0 { -way } else { way };
        let end = tip + way * WAY;
        drawing.mark(Style::Velocity, Shape::Arrow(tip, end));
        drawing
            .label(Label::at(Text::italic("v"), NAMES, end, 0.8).towards(way).coloured(Role::Blue).ranked(2));
        let sweep = libm::atan2(normal.cross(way), normal.dot(way));
        let from = libm::atan2(normal.y, normal.x);
        if sweep.abs() * ARC > 0.8 {
            drawing.mark(Style::Thin, Shape::Arc { centre: tip, radius: ARC, from, sweep });
        }
        let text =
            Text::italic("α").and(&format!(" = {:.1}°", at.pressure_angle.to_degrees()), false, Level::Base);
        let middle = Vec2::direction(from + 0.5 * sweep);
        drawing.label(Label::at(text, NAMES, tip + middle * ARC, 0.6).towards(middle).ranked(2));
        drawing.end();
    }

    /// Unit direction in which the follower's point may go, on paper.
    fn way(&self) -> Vec2 {
        match self.placed.cam().follower {
            Follower::Translating { .. } => flipped(self.placed.direction(Vec2::new(1.0, 0.0))),
            Follower::Oscillating { pivot_distance, .. } => {
                let arm = self.placed.at.tip - Vec2::new(pivot_distance, 0.0);
                flipped(self.placed.direction(arm.perp())).unit().unwrap_or(Vec2::new(0.0, -1.0))
            }
        }
    }

    /// The name of the hinge in which a link turns on the one that cam and follower stand on.
    fn pivot(&self, drawing: &mut Drawing, link: LinkId, at: Vec2) {
        let Some(contact) = self.placed.contact else { return };
        let joins = |pair: &&Pair| {
            let links = pair.kind.links();
            matches!(pair.kind, PairKind::Revolute(_))
                && links.contains(&link)
                && links.contains(&contact.frame)
        };
        if let Some(pair) = self.subject.mechanism.pairs.iter().find(joins) {
            drawing.label(Label::at(Text::name(&pair.name), NAMES, at, 1.6).ranked(3));
        }
    }

    fn number(&self, drawing: &mut Drawing, link: LinkId, at: Vec2, radius: f64) {
        let text = Text::upright(self.link_label(link));
        drawing.label(Label::at(text, 3.6, at, radius).ringed(2.5).ranked(5));
    }

    fn link_name(&self, link: LinkId) -> &str {
        &self.subject.mechanism.link(link).name
    }

    fn link_label(&self, link: LinkId) -> &str {
        let link = self.subject.mechanism.link(link);
        link.number.as_deref().unwrap_or(&link.name)
    }
}

// Where a cam stands: in its mechanism at a position, or alone at the angle of its greatest pressure angle.

/// A cam in its place.
pub struct PlacedCam<'a> {
    pub plate: &'a PlateCam,
    /// The contact in which it is.
    pub contact: Option<&'a CamContact>,
    /// How far it has turned, rad.
    pub phi: f64,
    /// What belongs to that angle.
    pub at: CamPoint,
    /// Its centre, m.
    centre: Vec2,
    /// Unit direction towards the follower.
    towards: Vec2,
}

impl<'a> PlacedCam<'a> {
    /// The cam of an index.
    pub fn of(subject: &Subject<'_, 'a>, index: usize, plate: &'a PlateCam) -> Self {
        let contact = subject.mechanism.cam_contacts.iter().find(|c| c.cam == index);
        let cam = &plate.cam;
        let (Some(contact), Some(scene)) = (contact, subject.scene) else {
            let (phi, _) = cam.extreme(Quantity::PressureAngle, true);
            let up = if cam.follower.oscillates() { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
            return Self { plate, contact: None, phi, at: cam.at(phi), centre: Vec2::zero(), towards: up };
        };
        let (frame, disk) = (scene.body(contact.frame), scene.body(contact.disk));
        let towards = contact.towards.turned(frame.u);
        let sense = if cam.ccw { -1.0 } else { 1.0 };
        let phi = sense * towards.turned_back(disk.u).angle();
        let phi = phi.rem_euclid(std::f64::consts::TAU);
        let centre = frame.position(contact.frame_centre);
        Self { plate, contact: Some(contact), phi, at: cam.at(phi), centre, towards }
    }

    pub const fn cam(&self) -> &'a Cam {
        &self.plate.cam
    }

    /// A place in the axes of the frame (x from the cam's centre towards the follower), on the ground, m.
    pub fn on_ground(&self, v: Vec2) -> Vec2 {
        self.centre + v.turned(self.towards)
    }

    /// A direction of the frame's axes, on the ground.
    pub fn direction(&self, v: Vec2) -> Vec2 {
        v.turned(self.towards)
    }

    /// A place in the axes of the cam, on the ground, m.
    pub fn of_cam(&self, v: Vec2) -> Vec2 {
        let turned = Vec2::direction(if self.cam().ccw { -self.phi } else { self.phi });
        self.on_ground(v.turned_back(turned))
    }

    /// Points of a curve of the cam, on the ground, m.
    pub fn around(&self, of: impl Fn(&CamPoint) -> Vec2) -> Vec<Vec2> {
        let cam = self.cam();
        let place = |i: u32| {
            let phi = f64::from(i).to_radians();
            self.of_cam(cam.in_cam(of(&cam.at(phi)), phi))
        };
        (0..360).map(place).collect()
    }
}
