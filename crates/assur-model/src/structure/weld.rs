//! Welded links: one body per set of them, its frame that of one of its links. The others are its parts.

use super::joint::{BodyId, BodyOrigin, Joint, JointKind, Part, Replaced};
use crate::math::Vec2;
use crate::model::{LinkId, Mechanism, Pair, PairId, PairKind, Pin, ProfileShape, Rate};

/// Sets of welded links.
#[derive(Default)]
pub(super) struct Welds {
    /// Per link, where it is no body of its own.
    pub parts: Vec<Option<Part>>,
    /// What each weld holds, from the links whose frames bodies have outwards.
    pub joints: Vec<Joint>,
    /// Welds of links that others join already.
    pub closing: Vec<PairId>,
}

impl Welds {
    pub fn of(mechanism: &Mechanism) -> Self {
        let welds: Vec<(PairId, &[Pin], f64)> = mechanism.pairs.iter().enumerate().filter_map(weld).collect();
        if welds.is_empty() {
            return Self::default();
        }
        let mut order: Vec<usize> = (0..mechanism.links.len()).collect();
        order.sort_by_key(|&link| rank(mechanism, LinkId::at(link)));
        let mut found = Self { parts: vec![None; order.len()], ..Self::default() };
        let (mut placed, mut done) = (vec![None; order.len()], vec![false; welds.len()]);
        for link in order {
            if placed[link].is_none() {
                placed[link] = Some(Part::own(link));
                found.spread(link, &welds, &mut placed, &mut done);
            }
        }
        found
    }

    /// Follows the welds from a link whose frame the body has.
    fn spread(
        &mut self,
        root: usize,
        welds: &[(PairId, &[Pin], f64)],
        placed: &mut [Option<Part>],
        done: &mut [bool],
    ) {
        let mut queue = std::collections::VecDeque::from([root]);
        while let Some(link) = queue.pop_front() {
            for (i, (pair, pins, angle)) in welds.iter().enumerate() {
                let (Some(own), Some(on)) = (pins.iter().position(|p| p.link.index() == link), placed[link])
                else {
                    continue;
                };
                if std::mem::replace(&mut done[i], true) {
                    continue;
                }
                let turned = |pin: usize| if pin == 0 { 0.0 } else { *angle };
                let others = pins.iter().enumerate().filter(|(other, _)| *other != own);
                for (other, pin) in others {
                    let to = pin.link.index();
                    if placed[to].is_some() {
                        self.closing.push(*pair);
                        continue;
                    }
                    let angle = on.angle + turned(other) - turned(own);
                    let along = Vec2::direction(angle);
                    let at = on.place(pins[own].at) - pin.at.turned(along);
                    placed[to] = Some(Part { body: BodyId(root), at, along, angle });
                    self.parts[to] = placed[to];
                    let kind = JointKind::Weld {
                        part: BodyId(to),
                        at: pin.at,
                        base: BodyId(link),
                        on: pins[own].at,
                    };
                    self.joints.push(Joint { pair: *pair, kind });
                    queue.push_back(to);
                }
            }
        }
    }
}

pub(super) fn weld((i, pair): (usize, &Pair)) -> Option<(PairId, &[Pin], f64)> {
    match &pair.kind {
        PairKind::Weld { pins, angle } => Some((PairId::at(i), pins, *angle)),
        _ => None,
    }
}

/// Which of welded links gives the body its frame: the ground, what laws speak of, what is written first.
fn rank(mechanism: &Mechanism, link: LinkId) -> usize {
    match link {
        LinkId::GROUND => 0,
        _ if (0..mechanism.pairs.len())
            .map(PairId::at)
            .any(|pair| is_law(mechanism, pair) && spoken_of(mechanism, pair).contains(&link)) =>
        {
            1
        }
        _ => 2,
    }
}

/// Whether a law moves the links of a pair, by their own places.
pub(super) fn is_law(mechanism: &Mechanism, pair: PairId) -> bool {
    mechanism.is_by_law(pair) || matches!(mechanism.pair(pair).kind, PairKind::Transmission(_))
}

/// The links that a law speaks of, and those on whose guides its sliders move.
pub(super) fn spoken_of(mechanism: &Mechanism, pair: PairId) -> Vec<LinkId> {
    let mut links = mechanism.pair(pair).kind.links();
    if let PairKind::Transmission(transmission) = &mechanism.pair(pair).kind {
        for (rate, _) in transmission.laws.iter().flat_map(|law| &law.terms) {
            match rate {
                Rate::Turn(link) => links.push(*link),
                Rate::Slide(guide) => links.extend(mechanism.pair(*guide).kind.links()),
            }
        }
    }
    links
}

impl Replaced {
    /// Whether any link is a part of another body.
    #[must_use]
    pub const fn has_parts(&self) -> bool {
        !self.parts.is_empty()
    }

    /// The body of a link.
    #[must_use]
    pub fn body_of(&self, link: LinkId) -> BodyId {
        self.part(link).map_or(BodyId(link.index()), |part| part.body)
    }

    /// The links of a body: the one whose frame it has first.
    #[must_use]
    pub fn links_of(&self, body: BodyId) -> Vec<LinkId> {
        let parts = (0..self.parts.len()).map(LinkId::at);
        let parts = parts.filter(|link| self.part(*link).is_some_and(|part| part.body == body));
        match self.bodies[body.0].origin {
            BodyOrigin::Link(own) => std::iter::once(own).chain(parts).collect(),
            BodyOrigin::Imaginary(_) => Vec::new(),
        }
    }

    /// How a link lies in its body, where it is no body of its own.
    #[must_use]
    pub fn part(&self, link: LinkId) -> Option<&Part> {
        self.parts.get(link.index())?.as_ref()
    }

    /// A point of a link in its body.
    #[must_use]
    pub fn place(&self, link: LinkId, at: Vec2) -> (BodyId, Vec2) {
        (self.body_of(link), self.part(link).map_or(at, |part| part.place(at)))
    }

    /// A direction of a link in its body.
    #[must_use]
    pub fn direction(&self, link: LinkId, along: Vec2) -> Vec2 {
        self.part(link).map_or(along, |part| along.turned(part.along))
    }

    /// A profile of a link in its body.
    #[must_use]
    pub fn profile(&self, link: LinkId, shape: ProfileShape) -> ProfileShape {
        let place = |at| self.place(link, at).1;
        match shape {
            ProfileShape::Point(at) => ProfileShape::Point(place(at)),
            ProfileShape::Circle(centre, radius) => ProfileShape::Circle(place(centre), radius),
            ProfileShape::Line(through, along) => {
                ProfileShape::Line(place(through), self.direction(link, along))
            }
            ProfileShape::Rim(contact) => ProfileShape::Rim(contact),
        }
    }

    /// The link, among those of a pair, by which the pair holds a body; the body itself where that is none of them.
    #[must_use]
    pub fn held_by(&self, mechanism: &Mechanism, pair: PairId, body: BodyId) -> BodyId {
        if !self.has_parts() {
            return body;
        }
        let links = mechanism.pair(pair).kind.links();
        let link = links.into_iter().find(|link| self.body_of(*link) == body);
        link.map_or(body, |link| BodyId(link.index()))
    }
}
