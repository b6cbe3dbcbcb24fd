//! Applied loads, springs and unknown efforts.

use super::{Expr, LinkId, LoadId, PairId};
use crate::math::Vec2;
use crate::source::Span;

/// The acceleration of free fall as a vector in ground axes, m/s².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// Acceleration, m/s².
    pub acceleration: Vec2,
    /// Place of the statement.
    pub span: Span,
}

/// The point of a link at which a force acts.
#[derive(Clone, Debug)]
pub enum Place {
    /// A point of the link, in its frame, m.
    Local(Vec2),
    /// A place in ground axes at this instant, m (a vector expression).
    Ground(Expr),
}

#[derive(Clone, Debug)]
pub struct Load {
    /// Name, where it has one.
    pub name: Option<String>,
    /// Place of the statement.
    pub span: Span,
    pub kind: LoadKind,
    /// It acts on this pin, which is fixed to its first link: to the link of `kind`.
    pub pin: Option<PairId>,
    /// A force that is the resultant of a load per length.
    pub spread: Option<Spread>,
    /// Acts only while this condition is true.
    pub when: Option<Expr>,
}

/// How a force is spread over a segment of its link: per length it changes linearly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Ends of the segment in the link's frame, m.
    pub from: Vec2,
    pub to: Vec2,
    /// The part of the force per length at the end in the sum of those at both ends.
    pub share: f64,
}

impl Spread {
    /// The place of the resultant, m.
    #[must_use]
    pub fn centre(&self) -> Vec2 {
        self.from + (self.to - self.from) * ((1.0 + self.share) / 3.0)
    }

    /// The forces per length at both ends that have this resultant.
    #[must_use]
    pub fn ends(&self, resultant: Vec2) -> [Vec2; 2] {
        let mean = resultant * (2.0 / (self.to - self.from).norm());
        [mean * (1.0 - self.share), mean * self.share]
    }
}

/// The load and its point. Expressions are in SI; those that need no results are folded to numbers.
#[derive(Clone, Debug)]
pub enum LoadKind {
    /// A force on a link; a vector expression, N, in ground axes or in the axes of `frame`.
    Force {
        /// The link it acts on.
        on: LinkId,
        at: Place,
        value: Expr,
        /// The link whose axes the components are in.
        frame: Option<LinkId>,
    },
    /// A force of this magnitude (scalar, N) against the velocity of its point.
    ForceAgainstMotion {
        /// The link it acts on.
        on: LinkId,
        at: Place,
        value: Expr,
    },
    /// A torque on a link, N m, counter-clockwise positive.
    Torque {
        /// The link it acts on.
        on: LinkId,
        /// Where on it, m, where that is said: forces inside the link depend on it, nothing else does.
        at: Option<Vec2>,
        value: Expr,
        /// `value` is a magnitude that acts against the angular velocity.
        against_motion: bool,
    },
    /// A force (N) or torque (N m) between the two links of a pair, positive along its coordinate.
    InPair {
        /// The pair: prismatic, slot, cylinder or revolute of two links, or a clutch that slips.
        pair: PairId,
        value: Expr,
        /// `value` is a magnitude that acts against the rate of the coordinate.
        against_motion: bool,
    },
}

impl Load {
    /// Its magnitude, or the vector of a force.
    #[must_use]
    pub const fn value(&self) -> &Expr {
        match &self.kind {
            LoadKind::Force { value, .. }
            | LoadKind::ForceAgainstMotion { value, .. }
            | LoadKind::Torque { value, .. }
            | LoadKind::InPair { value, .. } => value,
        }
    }

    /// All that it takes from elsewhere: its value, its place in ground axes, its condition.
    pub fn expressions(&self) -> impl Iterator<Item = &Expr> {
        self.values().chain(&self.when)
    }

    /// The expressions of its value and its place.
    pub fn values(&self) -> impl Iterator<Item = &Expr> {
        let place = match &self.kind {
            LoadKind::Force { at, .. } | LoadKind::ForceAgainstMotion { at, .. } => Some(at),
            LoadKind::Torque { .. } | LoadKind::InPair { .. } => None,
        };
        let place = place.and_then(|at| match at {
            Place::Ground(place) => Some(place),
            Place::Local(_) => None,
        });
        std::iter::once(self.value()).chain(place)
    }

    /// The link on which it acts from outside; none where it acts between the links of a pair.
    #[must_use]
    pub const fn link(&self) -> Option<LinkId> {
        match &self.kind {
            LoadKind::Force { on, .. }
            | LoadKind::ForceAgainstMotion { on, .. }
            | LoadKind::Torque { on, .. } => Some(*on),
            LoadKind::InPair { .. } => None,
        }
    }

    /// Whether its value is a vector: it is a force on a link.
    #[must_use]
    pub const fn is_vector(&self) -> bool {
        match &self.kind {
            LoadKind::Force { .. } | LoadKind::ForceAgainstMotion { .. } => true,
            LoadKind::Torque { .. } | LoadKind::InPair { .. } => false,
        }
    }

    /// Whether it acts against the motion.
    #[must_use]
    pub const fn is_against_motion(&self) -> bool {
        match &self.kind {
            LoadKind::ForceAgainstMotion { .. } => true,
            LoadKind::Torque { against_motion, .. } | LoadKind::InPair { against_motion, .. } => {
                *against_motion
            }
            LoadKind::Force { .. } => false,
        }
    }
}

/// A spring, with a parallel damper, between two points.
#[derive(Clone, Debug)]
pub struct Spring {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// One end: link and point in its frame, m.
    pub from: (LinkId, Vec2),
    pub to: (LinkId, Vec2),
    /// N/m.
    pub stiffness: f64,
    /// m.
    pub free_length: f64,
    /// N s/m.
    pub damping: f64,
}

impl Spring {
    /// Whether its force needs a direction: without a free length it is proportional to the way from end to end, also at zero.
    #[must_use]
    pub fn has_direction(&self) -> bool {
        self.stiffness > 0.0 && self.free_length > 0.0
    }
}

/// What a spring in a revolute pair stores; its torque is a load.
#[derive(Clone, Copy, Debug)]
pub struct TorsionSpring {
    pub load: LoadId,
    /// N m/rad.
    pub stiffness: f64,
    /// Of the pair's coordinate, rad.
    pub free_angle: f64,
}

/// An unknown effort, found from equilibrium.
#[derive(Clone, Debug)]
pub struct Balance {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    pub kind: BalanceKind,
    /// It acts on this pin, as a load does.
    pub pin: Option<PairId>,
}

/// Kinds of unknown effort.
#[derive(Clone, Debug)]
pub enum BalanceKind {
    /// A torque on a link from outside, counter-clockwise positive.
    Torque(LinkId),
    /// A force on a link from outside along a direction, positive along it.
    Force {
        on: LinkId,
        at: Place,
        /// Unit direction in ground axes or in the axes of `frame`.
        along: Vec2,
        /// The link whose axes `along` is in.
        frame: Option<LinkId>,
    },
    /// The force or torque inside a pair, positive along its coordinate.
    InPair(PairId),
    /// The same torque or force at several places: two or more torques on links or efforts inside pairs of one dimension.
    Several(Vec<BalanceKind>),
}

impl BalanceKind {
    /// Its places: one, or several.
    #[must_use]
    pub fn places(&self) -> &[Self] {
        match self {
            Self::Several(places) => places,
            one => std::slice::from_ref(one),
        }
    }
}
