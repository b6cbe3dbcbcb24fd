//! Kinematic pairs as declared.

use super::{LinkId, Transmission, TransmissionKind};
use crate::math::Vec2;
use crate::source::Span;
use assur_text::language::JointKind;

#[derive(Clone, Debug)]
pub struct Pair {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// Its kind and the things it joins.
    pub kind: PairKind,
    /// Friction in it, where declared.
    pub friction: Option<Friction>,
    /// It belongs to a shaft or a slider, which brings it along.
    pub bearing: Option<Bearing>,
}

/// The pair of a shaft or a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bearing {
    /// Its place is left open.
    Open,
    /// Its place is known.
    Placed,
}

/// The law of friction of a pair. It opposes the relative velocity; where that is nothing there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Friction {
    /// Journal: the reaction touches the friction circle of this radius ρ, m, so that its moment about the hinge is ρ R.
    /// In a pin of many links every link but the first turns against the first.
    Circle(f64),
    /// Guide, slot or contact: a force of this equivalent coefficient times the normal force against the sliding.
    Coefficient(f64),
    /// Guide with two contact points: both ends rub, f (|N_1| + |N_2|).
    BothEnds(f64),
    /// Contact that also resists the rolling of its profiles: a torque of this arm δ, m, times the normal force.
    Rolling { coefficient: f64, arm: f64 },
}

/// A coefficient of friction as it is given, of a pair whose law has a greater one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedFriction {
    pub coefficient: f64,
    pub more: MoreFriction,
}

/// What makes friction more than its coefficient says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoreFriction {
    /// f/sin β in a V-groove with half the angle β, rad.
    Groove(f64),
    /// k f in a round fit; of a journal with its radius, m.
    Fit { factor: f64, radius: Option<f64> },
}

impl Friction {
    /// Whether it is more than nothing.
    #[must_use]
    pub fn is_some(&self) -> bool {
        match self {
            Self::Circle(rho) => *rho > 0.0,
            Self::Coefficient(f) | Self::BothEnds(f) => *f > 0.0,
            Self::Rolling { coefficient, arm } => *coefficient > 0.0 || *arm > 0.0,
        }
    }

    /// The same law with so many times the friction.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        match self {
            Self::Circle(rho) => Self::Circle(factor * rho),
            Self::Coefficient(f) => Self::Coefficient(factor * f),
            Self::BothEnds(f) => Self::BothEnds(factor * f),
            Self::Rolling { coefficient, arm } => {
                Self::Rolling { coefficient: factor * coefficient, arm: factor * arm }
            }
        }
    }

    /// The law at rest: its coefficient is greater by this ratio.
    #[must_use]
    pub fn at_rest(self, ratio: f64) -> Self {
        match self {
            Self::Rolling { coefficient, arm } => Self::Rolling { coefficient: ratio * coefficient, arm },
            other => other.times(ratio),
        }
    }

    /// Arm of the rolling resistance of a contact, m.
    #[must_use]
    pub const fn arm(&self) -> f64 {
        match self {
            Self::Rolling { arm, .. } => *arm,
            _ => 0.0,
        }
    }

    /// Coefficient of a guide or contact; zero for a friction circle.
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        match self {
            Self::Circle(_) => 0.0,
            Self::Coefficient(f) | Self::BothEnds(f) | Self::Rolling { coefficient: f, .. } => *f,
        }
    }
}

/// The kinds of pair.
#[derive(Clone, Debug)]
pub enum PairKind {
    /// Hinge: the pins' points coincide. The pin sits in the first link; k links make k − 1 lower pairs.
    Revolute(Vec<Pin>),
    /// Slider: the slider keeps its orientation to the line and its point on it. A lower pair.
    Prismatic(Guide),
    /// Pin in slot: the point stays on the line. A higher pair.
    Slot(Guide),
    /// Contact of two profiles. A higher pair.
    Contact {
        /// The first profile as written.
        first: Profile,
        /// The second profile as written.
        second: Profile,
        /// One circle lies inside the other.
        internal: bool,
        /// In a motion it opens and closes: it joins nothing, and presses as a stop does.
        parts: bool,
    },
    /// Barrel and rod between two points: two links, two revolutes and a prismatic pair.
    Cylinder {
        barrel: LinkId,
        rod: LinkId,
        /// Where the barrel is hinged.
        from: Pin,
        /// Where the rod is hinged.
        to: Pin,
    },
    /// Rigid joint: the pins' points coincide, and each further link is turned by the angle against the first, rad. The links
    /// are one body, and it counts as no pair.
    Weld { pins: Vec<Pin>, angle: f64 },
    /// A transmission between wheels and sliders. It counts as one higher pair per law.
    Transmission(Transmission),
}

/// A point of a link at a hinge.
#[derive(Clone, Debug)]
pub struct Pin {
    pub link: LinkId,
    /// Name of the point.
    pub name: String,
    /// The point in the link's frame, m.
    pub at: Vec2,
}

/// A point on a line. The coordinate is that of the point, measured along the line from its `through` point.
#[derive(Clone, Debug)]
pub struct Guide {
    /// The link that carries the point.
    pub slider: LinkId,
    /// Name of the point on the slider (of its line's `through` point where two lines slide).
    pub point_name: String,
    /// The point in the slider's frame, m.
    pub point: Vec2,
    /// Unit direction in the slider's frame that lies along the line (meaningless for a slot).
    pub direction: Vec2,
    /// Name of the slider's own line, where two lines slide.
    pub own_line: Option<String>,
    /// The link that carries the line.
    pub guide: LinkId,
    /// Name of the line.
    pub line_name: String,
    /// The line's `through` point in the guide's frame, m.
    pub through: Vec2,
    /// The line's unit direction in the guide's frame.
    pub along: Vec2,
    /// Coordinates of two contact points relative to the pair's point, m.
    pub contacts: Option<[f64; 2]>,
    /// The line's link was written first: `from` is the guide and `on` the slider in a list of reactions.
    pub guide_first: bool,
}

/// A profile in contact.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The link that carries it.
    pub link: LinkId,
    /// Name of the point, line or circle.
    pub name: String,
    pub shape: ProfileShape,
}

/// Shapes of profiles, in the frame of their link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProfileShape {
    Point(Vec2),
    /// A circle: centre and radius, m.
    Circle(Vec2, f64),
    /// A line: a point of it and its unit direction.
    Line(Vec2, Vec2),
    /// The profile of a designed cam: index into [`super::Mechanism::cam_contacts`], one for each of its contacts.
    Rim(usize),
}

/// What holds only as long as forces act as it takes them: beyond that a motion is another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnilateralCondition {
    Presses,
    Pulls,
    /// Power runs from the first wheel of a belt to the second: its slip is of the speed of the first.
    Drives,
    /// A clutch or a belt transmits no more than its friction can.
    Grips,
}

impl Pair {
    /// Whether friction can hold it: it has friction, or is a clutch that slips.
    #[must_use]
    pub fn rubs(&self) -> bool {
        self.friction.is_some_and(|friction| friction.is_some()) || self.kind.slipping().is_some()
    }
}

impl PairKind {
    /// The sense, ±1, in which the second side of a freewheel may turn ahead of the first; 0 for all other pairs.
    #[must_use]
    pub fn freewheel(&self) -> f64 {
        match self {
            Self::Transmission(transmission) => transmission.freewheel,
            _ => 0.0,
        }
    }

    /// The two sides of a clutch that slips.
    #[must_use]
    pub fn slipping(&self) -> Option<[LinkId; 2]> {
        match self {
            Self::Transmission(transmission) => transmission.slipping(),
            _ => None,
        }
    }

    /// What holds only as long as forces act as it takes them.
    pub fn bonds(&self) -> impl Iterator<Item = UnilateralCondition> {
        let (contact, rope, slips, grips) = match self {
            Self::Contact { parts, .. } => (!parts, false, false, false),
            Self::Transmission(t) => {
                let grips = t.grip.is_some_and(|grip| !grip.capacity().is_nan()) && t.slipping().is_none();
                (false, t.kind == TransmissionKind::Rope, t.slip > 0.0, grips)
            }
            _ => (false, false, false, false),
        };
        let all = [
            (contact, UnilateralCondition::Presses),
            (rope, UnilateralCondition::Pulls),
            (slips, UnilateralCondition::Drives),
            (grips, UnilateralCondition::Grips),
        ];
        all.into_iter().filter(|(holds, _)| *holds).map(|(_, bond)| bond)
    }

    /// The kind of its statement.
    #[must_use]
    pub const fn statement(&self) -> JointKind {
        match self {
            Self::Revolute(_) => JointKind::Revolute,
            Self::Prismatic(_) => JointKind::Prismatic,
            Self::Slot(_) => JointKind::Slot,
            Self::Contact { .. } => JointKind::Contact,
            Self::Cylinder { .. } => JointKind::Cylinder,
            Self::Weld { .. } => JointKind::Weld,
            Self::Transmission(t) => t.kind.statement(),
        }
    }

    #[must_use]
    pub const fn word(&self) -> &'static str {
        self.statement().word()
    }

    /// The links joined, in the order written.
    #[must_use]
    pub fn links(&self) -> Vec<LinkId> {
        match self {
            Self::Revolute(pins) | Self::Weld { pins, .. } => pins.iter().map(|p| p.link).collect(),
            Self::Prismatic(g) | Self::Slot(g) if g.guide_first => vec![g.guide, g.slider],
            Self::Prismatic(g) | Self::Slot(g) => vec![g.slider, g.guide],
            Self::Contact { first, second, .. } => vec![first.link, second.link],
            Self::Cylinder { from, to, .. } => vec![from.link, to.link],
            Self::Transmission(t) => t.links.clone(),
        }
    }

    /// Number of lower pairs it counts for.
    #[must_use]
    pub fn lower(&self) -> usize {
        match self {
            Self::Revolute(pins) => pins.len().saturating_sub(1),
            Self::Prismatic(_) => 1,
            Self::Cylinder { .. } => 3,
            Self::Slot(_) | Self::Contact { .. } | Self::Weld { .. } | Self::Transmission(_) => 0,
        }
    }

    /// Number of higher pairs it counts for.
    #[must_use]
    pub fn higher(&self) -> usize {
        match self {
            Self::Slot(_) => 1,
            // one that parts joins nothing
            Self::Contact { parts, .. } => usize::from(!parts),
            Self::Transmission(t) => t.laws.len(),
            Self::Revolute(_) | Self::Prismatic(_) | Self::Cylinder { .. } | Self::Weld { .. } => 0,
        }
    }
}
