//! What a link looks like: the points at which it is joined, the guides on it, and the lines that follow from them.

use crate::paper::Frame;
use crate::scene::Scene;
use assur_drawing::Rect;
use assur_math::math::Vec2;
use assur_model::model::{
    BalanceKind, Bearing, DriveTarget, Guide, LinkId, LoadKind, PairId, PairKind, Pin, Place, Profile,
    ProfileShape,
};

/// How a prismatic pair is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A block on a rail of the ground.
    Rail,
    /// A block, fixed, through which a bar slides.
    FixedSleeve,
    /// A block on a bar that slides along the other link.
    Block,
    /// A block on the link of the guide, through which the other slides.
    Sleeve,
    /// The face of a wedge on a line of the other link, or of the ground.
    Face,
}

/// The points of a link that matter, in its frame.
#[derive(Clone, Debug, Default)]
pub struct LinkShape {
    /// Where it is joined.
    pub joints: Vec<Vec2>,
    /// Where something acts on it, or a name stands.
    pub attached: Vec<Vec2>,
    /// Lines on it along which a block or a pin moves: a point, a direction, and how far it is needed.
    pub rails: Vec<Rail>,
    /// The corners of a wedge.
    pub wedge: Vec<Vec2>,
    /// What of its points is no place of a mass: the corners of a link with at most one joint; none where a face says what it is.
    pub corners: Vec<Vec2>,
}

/// A line of a link.
#[derive(Clone, Copy, Debug)]
pub struct Rail {
    /// A point, m.
    pub at: Vec2,
    pub along: Vec2,
    /// The least and the greatest coordinate that is needed, m.
    pub way: (f64, f64),
    /// A slot, whose lines are drawn by its own symbol.
    pub slot: bool,
}

/// The lines of a link on paper.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    pub bars: Vec<(Vec2, Vec2)>,
    /// Plates: three corners and more.
    pub plates: Vec<Vec<Vec2>>,
    /// Thin bars to points beside.
    pub arms: Vec<(Vec2, Vec2)>,
}

impl Outline {
    /// The sides of all plates.
    pub fn sides(&self) -> impl Iterator<Item = (Vec2, Vec2)> {
        self.plates.iter().flat_map(|p| (0..p.len()).map(|i| (p[i], p[(i + 1) % p.len()])))
    }
}

/// How far a bar goes beyond a block that slides on it, mm.
const BEYOND: f64 = 9.0;
/// Points nearer than this on paper are one.
const SAME: f64 = 0.05;
/// How far joints may be off a line to be in it, mm.
const IN_LINE: f64 = 0.3;

/// The shapes of all links.
pub fn shapes(scene: &Scene<'_>) -> Vec<LinkShape> {
    let mechanism = scene.mechanism();
    let mut shapes: Vec<LinkShape> = vec![LinkShape::default(); mechanism.links.len()];
    for pair in mechanism.pairs.iter().filter(|p| p.bearing != Some(Bearing::Open)) {
        match &pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                pins.iter().for_each(|pin| shapes[pin.link.index()].joints.push(pin.at));
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => shapes[g.slider.index()].joints.push(g.point),
            PairKind::Cylinder { from, to, .. } => {
                shapes[from.link.index()].joints.push(from.at);
                shapes[to.link.index()].joints.push(to.at);
            }
            PairKind::Contact { first, second, .. } => {
                for profile in [first, second] {
                    if let Some(at) = centre(scene, profile) {
                        shapes[profile.link.index()].joints.push(at);
                    }
                }
            }
            PairKind::Transmission(_) => {}
        }
    }
    for wheel in &mechanism.wheels {
        if let Some(at) = wheel.centre {
            shapes[wheel.link.index()].joints.push(at);
        }
    }
    for drive in &mechanism.drives {
        if let DriveTarget::Place(link, ..) = drive.target
            && shapes[link.index()].joints.is_empty()
        {
            shapes[link.index()].joints = mechanism.link(link).points.iter().map(|point| point.at).collect();
        }
    }
    attach(scene, &mut shapes);
    corners(scene, &mut shapes);
    for (i, shape) in shapes.iter_mut().enumerate().skip(1) {
        if scene.is_placed(LinkId::at(i)) {
            shape.wedge = crate::wedge::corners(scene, LinkId::at(i)).unwrap_or_default();
        }
    }
    rails(scene, &mut shapes);
    shapes
}

/// The point at which a profile is joined to its link.
fn centre(scene: &Scene<'_>, profile: &Profile) -> Option<Vec2> {
    match profile.shape {
        ProfileShape::Point(at) | ProfileShape::Circle(at, _) => Some(at),
        ProfileShape::Line(..) => None,
        ProfileShape::Rim(contact) => scene.mechanism().cam_contacts.get(contact).map(|c| c.centre),
    }
}

/// Masses, loads, springs and driven points.
fn attach(scene: &Scene<'_>, shapes: &mut [LinkShape]) {
    let mechanism = scene.mechanism();
    let mut add = |link: LinkId, at: Vec2| shapes[link.index()].attached.push(at);
    for (i, link) in mechanism.links.iter().enumerate().skip(1) {
        let id = LinkId::at(i);
        if let Some(mass) = link.mass.filter(|m| m.mass > 0.0) {
            add(id, mass.centre);
        }
        link.points.iter().for_each(|p| add(id, p.at));
    }
    for spring in &mechanism.springs {
        for (link, at) in [spring.from, spring.to] {
            add(link, at);
        }
    }
    for load in &mechanism.loads {
        if let LoadKind::Force { on, at: Place::Local(at), .. }
        | LoadKind::ForceAgainstMotion { on, at: Place::Local(at), .. } = &load.kind
        {
            add(*on, *at);
        }
    }
    for balance in &mechanism.balances {
        for place in balance.kind.places() {
            if let BalanceKind::Force { on, at: Place::Local(at), .. } = place {
                add(*on, *at);
            }
        }
    }
}

/// The points of links that are not places of masses, and by which a link has a shape.
fn corners(scene: &Scene<'_>, shapes: &mut [LinkShape]) {
    let mechanism = scene.mechanism();
    let has_face = |link: LinkId| {
        mechanism.pairs.iter().any(|pair| match &pair.kind {
            PairKind::Contact { first, second, .. } => {
                [first, second].iter().any(|p| p.link == link && !matches!(p.shape, ProfileShape::Point(_)))
            }
            _ => false,
        })
    };
    for (i, link) in mechanism.links.iter().enumerate().skip(1) {
        if has_face(LinkId::at(i)) {
            continue;
        }
        let masses = link.mass_parts.iter().map(|part| part.own.centre).chain(link.mass.map(|m| m.centre));
        let masses: Vec<Vec2> = masses.collect();
        let own = link.points.iter().map(|point| point.at);
        shapes[i].corners = own.filter(|at| masses.iter().all(|m| (*m - *at).norm() > 1e-12)).collect();
    }
}

fn rails(scene: &Scene<'_>, shapes: &mut [LinkShape]) {
    for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
        let id = PairId::at(i);
        // a Geneva wheel is drawn whole
        if pair.bearing.is_some() || scene.geneva(id).is_some() {
            continue;
        }
        match &pair.kind {
            PairKind::Slot(g) => {
                let rail = Rail { at: g.through, along: g.along, way: scene.way(id), slot: true };
                shapes[g.guide.index()].rails.push(rail);
            }
            PairKind::Prismatic(g) => {
                let (least, greatest) = scene.way(id);
                match form(scene, shapes, g) {
                    Form::Rail => {}
                    Form::Face | Form::Block if shapes[g.guide.index()].is_wedge() => {}
                    Form::FixedSleeve | Form::Block | Form::Face => {
                        let rail =
                            Rail { at: g.through, along: g.along, way: (least, greatest), slot: false };
                        shapes[g.guide.index()].rails.push(rail);
                    }
                    Form::Sleeve => {
                        let rail =
                            Rail { at: g.point, along: g.direction, way: (-greatest, -least), slot: false };
                        shapes[g.slider.index()].rails.push(rail);
                        shapes[g.guide.index()].joints.push(g.through);
                    }
                }
            }
            _ => {}
        }
    }
}

/// How a prismatic pair is drawn.
pub fn form(scene: &Scene<'_>, shapes: &[LinkShape], g: &Guide) -> Form {
    if shapes[g.slider.index()].is_wedge() {
        return Form::Face;
    }
    if shapes[g.guide.index()].is_wedge() {
        return if g.slider == LinkId::GROUND { Form::Face } else { Form::Block };
    }
    if g.guide == LinkId::GROUND {
        return Form::Rail;
    }
    if g.slider == LinkId::GROUND {
        return Form::FixedSleeve;
    }
    let near = 1e-6 * assur_solve::solve::extent(&scene.model);
    let all_at =
        |link: LinkId, at: Vec2| shapes[link.index()].joints.iter().all(|j| (*j - at).norm() <= near);
    let hinged = scene.mechanism().pairs.iter().any(|pair| {
        let own = |pin: &Pin| pin.link == g.slider && (pin.at - g.point).norm() <= near;
        matches!(&pair.kind, PairKind::Revolute(pins) if pins.iter().any(own))
    });
    // a point that is no hinge, or has edges beside it, is the middle of a block
    let is_bar = hinged && g.contacts.is_none() && !all_at(g.slider, g.point);
    if is_bar && all_at(g.guide, g.through) { Form::Sleeve } else { Form::Block }
}

impl LinkShape {
    pub const fn is_wedge(&self) -> bool {
        !self.wedge.is_empty()
    }

    /// Points of the link that the picture must contain, in ground axes.
    pub fn extent(&self, scene: &Scene<'_>, link: LinkId, bounds: &mut Rect) {
        let body = scene.body(link);
        for at in self.joints.iter().chain(&self.attached).chain(&self.wedge) {
            bounds.add(body.position(*at));
        }
        for rail in &self.rails {
            for s in [rail.way.0, rail.way.1] {
                bounds.add(body.position(rail.at + rail.along * s));
            }
        }
    }

    /// Its lines on paper, of a body where it is.
    pub fn outline(&self, frame: &Frame, place: &dyn Fn(Vec2) -> Vec2) -> Outline {
        let mut outline = Outline::default();
        let on_paper = |at: &Vec2| frame.point(place(*at));
        let mut joints: Vec<Vec2> = Vec::new();
        for joint in self.joints.iter().map(on_paper) {
            if joints.iter().all(|j| (*j - joint).norm() > SAME) {
                joints.push(joint);
            }
        }
        if self.is_wedge() {
            outline.plates.push(self.wedge.iter().map(on_paper).collect());
        } else if self.rails.is_empty() {
            let beside: Vec<Vec2> = self.attached.iter().map(on_paper).collect();
            let corners: Vec<Vec2> =
                joints.iter().copied().chain(self.corners.iter().map(on_paper)).collect();
            let is_plate = joints.len() < 2
                && farthest(&corners).is_some_and(|(a, b)| {
                    let along = (b - a).unit().unwrap_or(Vec2::new(1.0, 0.0));
                    corners.iter().any(|at| (*at - a).cross(along).abs() > IN_LINE)
                });
            if is_plate {
                outline.plates.push(hull(&corners));
            } else {
                spanned(&joints, &beside, &mut outline);
            }
        } else {
            self.with_rails(frame, place, &joints, &mut outline);
        }
        for at in self.attached.iter().map(on_paper) {
            arm(at, &joints, &mut outline);
        }
        outline
    }

    fn with_rails(
        &self,
        frame: &Frame,
        place: &dyn Fn(Vec2) -> Vec2,
        joints: &[Vec2],
        outline: &mut Outline,
    ) {
        let mut feet: Vec<Vec2> = Vec::new();
        let mut off: Vec<Vec2> = joints.to_vec();
        for rail in &self.rails {
            let at = frame.point(place(rail.at));
            let toward = frame.point(place(rail.at + rail.along * frame.unit()));
            let Some(along) = (toward - at).unit() else { continue };
            let (low, high) = (frame.length(rail.way.0), frame.length(rail.way.1));
            let (mut from, mut to) = (low - BEYOND, high + BEYOND);
            let on_line: Vec<f64> = joints
                .iter()
                .filter(|j| (**j - at).cross(along).abs() <= IN_LINE)
                .map(|j| (*j - at).dot(along))
                .collect();
            off.retain(|j| (*j - at).cross(along).abs() > IN_LINE);
            if !on_line.is_empty() && !rail.slot {
                // a bar between joints carries the block where it covers its way
                let (a, b) = on_line.iter().fold((f64::MAX, f64::MIN), |(a, b), s| (a.min(*s), b.max(*s)));
                from = if a <= low { a } else { from.min(a) };
                to = if b >= high { b } else { to.max(b) };
            }
            if rail.slot {
                // the symbol of the slot is at its place; the bar reaches it
                for s in on_line.iter().filter(|s| **s < from || **s > to) {
                    let end = if *s < from { low - SLOT_END } else { high + SLOT_END };
                    outline.bars.push((at + along * *s, at + along * end));
                }
            } else {
                outline.bars.push((at + along * from, at + along * to));
            }
            let middle = at + along * ((from + to) * 0.5);
            feet.push(middle);
            for joint in joints.iter().filter(|j| (**j - at).cross(along).abs() > IN_LINE) {
                let foot = at + along * (*joint - at).dot(along).clamp(low.min(from), high.max(to));
                outline.bars.push((*joint, foot));
            }
        }
        if joints.is_empty() {
            feet.windows(2).for_each(|w| outline.bars.push((w[0], w[1])));
        }
        spanned(&off, &[], outline);
    }
}

/// Half the length that a slot is longer than its way, mm.
pub const SLOT_END: f64 = 3.5;

/// A bar through joints in one line, else a plate around them; with points beside the line a plate too.
fn spanned(joints: &[Vec2], beside: &[Vec2], outline: &mut Outline) {
    let Some((a, b)) = farthest(joints) else { return };
    let Some(along) = (b - a).unit() else { return };
    let is_off = |at: &&Vec2| (**at - a).cross(along).abs() > IN_LINE;
    if joints.iter().chain(beside).any(|at| is_off(&at)) {
        let corners: Vec<Vec2> = joints.iter().chain(beside.iter().filter(is_off)).copied().collect();
        outline.plates.push(hull(&corners));
    } else {
        outline.bars.push((a, b));
    }
}

/// A point beside a bar is joined to it: a triangle over its ends, or a line to the only joint.
fn arm(at: Vec2, joints: &[Vec2], outline: &mut Outline) {
    let near = |a: Vec2, b: Vec2| assur_drawing::Segment { a, b }.distance(at) <= IN_LINE;
    let on_it =
        outline.bars.iter().any(|(a, b)| near(*a, *b)) || outline.plates.iter().any(|p| contains(p, at));
    if on_it || joints.iter().any(|j| (*j - at).norm() <= SAME) {
        return;
    }
    match (farthest(joints), joints) {
        (Some((a, b)), _) if outline.plates.is_empty() && outline.bars.len() == 1 => {
            outline.arms.push((a, at));
            outline.arms.push((b, at));
        }
        (_, [only, ..]) => {
            let nearest = joints.iter().copied().min_by(|a, b| (*a - at).norm().total_cmp(&(*b - at).norm()));
            outline.arms.push((nearest.unwrap_or(*only), at));
        }
        _ => {}
    }
}

fn contains(polygon: &[Vec2], p: Vec2) -> bool {
    let sides = (0..polygon.len()).map(|i| {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        (b - a).cross(p - a)
    });
    let sides: Vec<f64> = sides.collect();
    sides.iter().all(|s| *s >= -IN_LINE) || sides.iter().all(|s| *s <= IN_LINE)
}

fn farthest(points: &[Vec2]) -> Option<(Vec2, Vec2)> {
    let mut found: Option<(f64, Vec2, Vec2)> = None;
    for (i, a) in points.iter().enumerate() {
        for b in &points[i + 1..] {
            let apart = (*b - *a).norm();
            if apart > SAME && found.is_none_or(|(most, _, _)| apart > most) {
                found = Some((apart, *a, *b));
            }
        }
    }
    found.map(|(_, a, b)| (a, b))
}

/// The convex hull, after Andrew.
pub fn hull(points: &[Vec2]) -> Vec<Vec2> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let half = |points: &mut dyn Iterator<Item = Vec2>| {
        let mut chain: Vec<Vec2> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..]
                && (b - a).cross(p - a) <= 0.0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut around = half(&mut sorted.iter().copied());
    around.extend(half(&mut sorted.iter().rev().copied()));
    around
}
