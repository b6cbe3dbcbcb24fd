//! What is known of the motion (drives) and what is unknown of the forces (balances): one place in the mechanism each.

use super::joint::{BodyId, JointId, JointKind, Replaced};
use crate::math::Vec2;
use crate::model::{Axis, BalanceId, BalanceKind, DriveId, DriveTarget, LinkId, Mechanism, PairId, PairKind};

/// A driven freedom, or the effort that acts in it.
#[derive(Clone, Debug)]
pub struct Effort {
    pub source: EffortSource,
    pub kind: EffortKind,
    /// Other places where the same effort acts.
    pub also: Vec<EffortKind>,
    /// Of an angle: the axes of the first and the second body between which it is.
    pub axes: [Vec2; 2],
}

/// The axes of bodies that are one link each.
pub(super) const X_AXES: [Vec2; 2] = [Vec2::new(1.0, 0.0); 2];

/// Where an effort is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EffortSource {
    Drive(DriveId),
    Balance(BalanceId),
}

/// Where an effort stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EffortKind {
    /// The angle of a body to the ground; a torque on it from outside.
    Angle(BodyId),
    /// The angle of `second` less that of `first` in a revolute joint; the torque of `first` on `second`.
    RelativeAngle { joint: JointId, first: BodyId, second: BodyId },
    /// The coordinate of a prismatic joint; the force of the guide on the slider along it.
    Coordinate(JointId),
    /// A force on a body from outside along a line.
    Line(BodyId),
    /// The place of a point: the body is known.
    Point(BodyId),
    /// A coordinate of a point of a body in the axes of the ground; as an effort it is a force along a line.
    Place(BodyId, Vec2, Axis),
}

impl Effort {
    /// Whether its angle is between others than the x axes of bodies.
    #[must_use]
    pub fn is_aside(&self) -> bool {
        self.axes[0] != self.axes[1]
    }

    /// The link whose angle is driven.
    #[must_use]
    pub fn link(&self, mechanism: &Mechanism) -> Option<LinkId> {
        match self.source {
            EffortSource::Drive(id) => match mechanism.drives[id.index()].target {
                DriveTarget::Link(link) => Some(link),
                DriveTarget::Pair(_) | DriveTarget::Point(..) | DriveTarget::Place(..) => None,
            },
            EffortSource::Balance(_) => None,
        }
    }

    /// All places where it acts.
    pub fn places(&self) -> impl Iterator<Item = EffortKind> + '_ {
        std::iter::once(self.kind).chain(self.also.iter().copied())
    }

    /// Its place, where it acts at one alone.
    #[must_use]
    pub fn only(&self) -> Option<EffortKind> {
        self.also.is_empty().then_some(self.kind)
    }

    /// The bodies it acts on.
    #[must_use]
    pub fn bodies(&self, replaced: &Replaced) -> Vec<BodyId> {
        let bodies = |kind| match kind {
            EffortKind::Angle(b) | EffortKind::Line(b) | EffortKind::Point(b) | EffortKind::Place(b, ..) => {
                vec![b]
            }
            EffortKind::RelativeAngle { first, second, .. } => vec![first, second],
            EffortKind::Coordinate(joint) => replaced.joint(joint).bodies(),
        };
        self.places().flat_map(bodies).collect()
    }
}

/// The effort inside a pair, positive along its coordinate. `None` where the pair has none (a contact, a pin of many links).
pub(super) fn in_pair(mechanism: &Mechanism, replaced: &Replaced, pair: PairId) -> Option<EffortKind> {
    let mut joints = replaced.joints_of(pair);
    match &mechanism.pair(pair).kind {
        PairKind::Revolute(pins) => match pins.as_slice() {
            [a, b] => Some(EffortKind::RelativeAngle {
                joint: joints.next()?,
                first: replaced.body_of(a.link),
                second: replaced.body_of(b.link),
            }),
            _ => None,
        },
        PairKind::Contact { .. } | PairKind::Transmission(_) | PairKind::Weld { .. } => None,
        _ => joints
            .find(|&j| matches!(replaced.joint(j).kind, JointKind::Prismatic { .. }))
            .map(EffortKind::Coordinate),
    }
}

pub(super) fn of_drives(mechanism: &Mechanism, replaced: &Replaced) -> Vec<Effort> {
    let kind = |target| match target {
        DriveTarget::Link(link) => Some(EffortKind::Angle(replaced.body_of(link))),
        DriveTarget::Pair(pair) => in_pair(mechanism, replaced, pair),
        DriveTarget::Point(link, _) => Some(EffortKind::Point(replaced.body_of(link))),
        DriveTarget::Place(link, at, axis) => {
            let (body, at) = replaced.place(link, at);
            Some(EffortKind::Place(body, at, axis))
        }
    };
    mechanism
        .drives
        .iter()
        .enumerate()
        .filter_map(|(i, d)| {
            let (source, also) = (EffortSource::Drive(DriveId::at(i)), Vec::new());
            Some(Effort { source, kind: kind(d.target)?, also, axes: axes(mechanism, replaced, d.target) })
        })
        .collect()
}

/// The axes between which a driven angle is.
fn axes(mechanism: &Mechanism, replaced: &Replaced, target: DriveTarget) -> [Vec2; 2] {
    let links = match target {
        DriveTarget::Link(link) => vec![LinkId::GROUND, link],
        DriveTarget::Pair(pair) => mechanism.pair(pair).kind.links(),
        DriveTarget::Point(..) | DriveTarget::Place(..) => Vec::new(),
    };
    match links[..] {
        [first, second] => [first, second].map(|link| replaced.direction(link, X_AXES[0])),
        _ => X_AXES,
    }
}

/// The balances or, where there is none, the drives' own efforts; and those of starts, which come to nothing.
pub(super) fn of_balances(mechanism: &Mechanism, replaced: &Replaced) -> Vec<Effort> {
    let own = of_drives(mechanism, replaced).into_iter().filter_map(|effort| match effort.kind {
        EffortKind::Point(_) => None,
        EffortKind::Place(body, ..) => Some(Effort { kind: EffortKind::Line(body), ..effort }),
        _ => Some(effort),
    });
    if mechanism.balances.is_empty() {
        return own.collect();
    }
    let kind = |kind: &BalanceKind| match kind {
        BalanceKind::Torque(link) => Some(EffortKind::Angle(replaced.body_of(*link))),
        BalanceKind::Force { on, .. } => Some(EffortKind::Line(replaced.body_of(*on))),
        BalanceKind::InPair(pair) => in_pair(mechanism, replaced, *pair),
        BalanceKind::Several(_) => None,
    };
    let balances = mechanism.balances.iter().enumerate().filter_map(|(i, b)| {
        let mut places = b.kind.places().iter().filter_map(kind);
        let source = EffortSource::Balance(BalanceId::at(i));
        Some(Effort { source, kind: places.next()?, also: places.collect(), axes: X_AXES })
    });
    let starts = own.filter(|e| match e.source {
        EffortSource::Drive(id) => mechanism.drives[id.index()].free,
        EffortSource::Balance(_) => false,
    });
    balances.chain(starts).collect()
}
