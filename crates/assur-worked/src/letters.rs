//! Letters of links, points and pairs.

use crate::course::Derivation;
use assur_formula::Name;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairId, PairKind};
use assur_model::structure::{BodyId, BodyOrigin, Joint, JointKind};
use assur_picture::reaction_index;

impl Derivation<'_> {
    /// The number of a body as written, or its name; of a body that stands for a pair the pair's.
    pub fn label(&self, body: usize) -> String {
        self.scene.body_label(body).to_owned()
    }

    /// The body that moves what a slot stands for: of a welded link that of all of them.
    pub fn body_of(&self, slot: usize) -> usize {
        self.structure().replaced.body_of(LinkId::at(slot)).0
    }

    /// The link of a body.
    pub fn link(&self, body: usize) -> Option<LinkId> {
        match self.structure().replaced.bodies[body].origin {
            BodyOrigin::Link(link) => Some(link),
            BodyOrigin::Imaginary(_) => None,
        }
    }

    /// The force of one body on another.
    pub fn reaction_name(&self, from: usize, on: usize) -> Name {
        let index = reaction_index(self.scene.body_label(from), self.scene.body_label(on));
        let (letter, begin) = self.language.letters().reaction;
        Name::new(letter, &format!("{begin}{index}"))
    }

    /// The name of a point of a body: that of the hinge there, else its own, else a new one.
    pub fn point_name(&self, body: usize, at: Vec2) -> String {
        self.known_name(body, at).unwrap_or_else(|| self.unnamed(body, at))
    }

    /// The name that a point has in the file, by its hinge or its own, or as a centre of mass.
    pub(crate) fn known_name(&self, body: usize, at: Vec2) -> Option<String> {
        if let Some(name) = self.hinge_name(body, at) {
            return Some(name);
        }
        let mechanism = self.scene.mechanism();
        let near = |p: Vec2| (p - at).norm() <= self.tiny;
        let Some(link) = self.link(body) else {
            let pair = self.label(body);
            return Some(if near(Vec2::zero()) { pair } else { format!("{pair}′") });
        };
        let own = mechanism.link(link);
        self.author_name(body, at)
            .or_else(|| self.name_on_part(body, at))
            .or_else(|| own.mass.is_some_and(|m| near(m.centre)).then(|| format!("S{}", self.label(body))))
    }

    /// The name that a point of a body has on one of its parts.
    fn name_on_part(&self, body: usize, at: Vec2) -> Option<String> {
        let place = self.moved(body).position(at);
        let parts = self.structure().replaced.links_of(BodyId(body)).into_iter().skip(1);
        parts.map(LinkId::index).find_map(|part| {
            let moved = self.moved(part);
            self.author_name(part, (place - moved.p).turned_back(moved.u))
        })
    }

    /// The name that the file gives a point of a link, with the number of the link where others have it too.
    fn author_name(&self, body: usize, at: Vec2) -> Option<String> {
        let mechanism = self.scene.mechanism();
        let link = self.link(body)?;
        let points = &mechanism.link(link).points;
        let point = points.iter().find(|p| (p.at - at).norm() <= self.tiny)?;
        let is_taken = |name: &str| {
            let pairs = mechanism.pairs.iter().any(|p| p.name == name);
            let points = mechanism.links.iter().enumerate();
            let others =
                points.filter(|(i, l)| *i != link.index() && l.points.iter().any(|p| p.name == name));
            pairs || others.count() > 0
        };
        let label = self.label(body);
        let own_already = !is_taken(&point.name) || point.name.ends_with(&label);
        Some(if own_already { point.name.clone() } else { format!("{}{label}", point.name) })
    }

    /// A name for a place on a body that has none in the file.
    fn unnamed(&self, body: usize, at: Vec2) -> String {
        let mut points = self.unnamed.borrow_mut();
        let known = points.iter().position(|(b, p)| *b == body && (*p - at).norm() <= self.tiny);
        let index = known.unwrap_or_else(|| {
            points.push((body, at));
            points.len() - 1
        });
        let mechanism = self.scene.mechanism();
        let taken = |name: &str| {
            mechanism.pairs.iter().any(|p| p.name == name)
                || mechanism.links.iter().any(|l| l.points.iter().any(|p| p.name == name))
        };
        // letters that no point of the file has
        let letter = ["P", "U", "W", "P′"]
            .into_iter()
            .find(|l| (1..=points.len()).all(|i| !taken(&format!("{l}{i}"))));
        format!("{}{}", letter.unwrap_or("P″"), index + 1)
    }

    fn hinge_name(&self, body: usize, at: Vec2) -> Option<String> {
        let found = self.hinge(body, at)?;
        Some(self.centre_name(found).unwrap_or_else(|| self.joint_name(found.pair, body, at)))
    }

    /// The name of the pair at a point of a body, else that of the point.
    pub(crate) fn hinge_pair_name(&self, body: usize, at: Vec2) -> String {
        let pair = self.hinge(body, at).map(|hinge| self.joint_name(hinge.pair, body, at));
        pair.unwrap_or_else(|| self.point_name(body, at))
    }

    fn hinge(&self, body: usize, at: Vec2) -> Option<&Joint> {
        let replaced = &self.structure().replaced;
        let (own, place) = replaced.place(LinkId::at(body), at);
        replaced.joints.iter().find(|joint| match &joint.kind {
            JointKind::Revolute(members) => {
                members.iter().any(|(b, p)| *b == own && (*p - place).norm() <= self.tiny)
            }
            JointKind::Weld { part, at: own, base, on } => {
                [(part, own), (base, on)].iter().any(|(b, p)| b.0 == body && (**p - at).norm() <= self.tiny)
            }
            _ => false,
        })
    }

    /// The author's name for the centre of a profile in contact, at which the link that stands for the contact is joined, and for the points
    /// between which a cylinder is.
    fn centre_name(&self, joint: &Joint) -> Option<String> {
        let JointKind::Revolute(members) = &joint.kind else { return None };
        let kind = &self.scene.mechanism().pair(joint.pair).kind;
        let has_points = matches!(kind, PairKind::Contact { .. } | PairKind::Cylinder { .. });
        members.iter().filter(|_| has_points).find_map(|(body, at)| self.author_name(body.0, *at))
    }

    /// The point at which two profiles touch: the pair's name, unless the centre of one of them has it.
    pub(crate) fn touching_name(&self, pair: PairId) -> String {
        let replaced = &self.structure().replaced;
        let mut joints = replaced.joints_of(pair).map(|joint| replaced.joint(joint));
        let is_hinge = |joint: &&Joint| matches!(joint.kind, JointKind::Revolute(_));
        let has_name = joints.any(|joint| is_hinge(&joint) && self.centre_name(joint).is_none());
        let name = &self.scene.mechanism().pair(pair).name;
        if has_name { format!("T{name}") } else { name.clone() }
    }

    /// The name of the pair; of a pair of two hinges with what tells them apart.
    fn joint_name(&self, pair: PairId, body: usize, at: Vec2) -> String {
        let name = self.scene.mechanism().pair(pair).name.clone();
        let hinges = self.structure().replaced.joints_of(pair).filter_map(|j| {
            match &self.structure().replaced.joint(j).kind {
                JointKind::Revolute(members) => Some(members),
                _ => None,
            }
        });
        let here = |members: &&Vec<_>| {
            members.iter().any(|(b, p): &(BodyId, Vec2)| b.0 == body && (*p - at).norm() <= self.tiny)
        };
        let all: Vec<_> = hinges.collect();
        let index = all.iter().position(here).unwrap_or(0);
        format!("{name}{}", "′".repeat(index))
    }

    /// All bodies that a hinge joins at a point of one of them, each with the point in its frame.
    pub fn at_hinge(&self, body: usize, at: Vec2) -> Vec<(usize, Vec2)> {
        let joints = &self.structure().replaced.joints;
        let mut found = vec![(body, at)];
        for joint in joints {
            let on_rim = |members: &[(BodyId, Vec2)]| {
                members.iter().any(|(b, _)| self.structure().replaced.bodies[b.0].on_rim)
            };
            if let JointKind::Weld { part, at: own, base, on } = joint.kind {
                let ends = [(part, own), (base, on)];
                let here = |end: &(BodyId, Vec2)| end.0.0 == body && (end.1 - at).norm() <= self.tiny;
                if ends.iter().any(here) {
                    found.extend(ends.iter().map(|(b, p)| (b.0, *p)).filter(|(b, _)| *b != body));
                }
            }
            if let JointKind::Revolute(members) = &joint.kind
                && !on_rim(members)
                && members.iter().any(|(b, p)| b.0 == body && (*p - at).norm() <= self.tiny)
            {
                found.extend(members.iter().map(|(b, p)| (b.0, *p)).filter(|(b, _)| *b != body));
            }
        }
        found
    }
}

/// The letters of a number of teeth: of a wheel `z2` its number alone.
pub fn teeth_name(wheel: &str) -> Name {
    let is_number = |rest: &&str| !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit());
    Name::new("z", wheel.strip_prefix('z').filter(is_number).unwrap_or(wheel))
}
