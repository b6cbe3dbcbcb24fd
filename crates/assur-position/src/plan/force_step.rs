//! The steps of forces.

use super::exact_vec::ExactVec;
use super::friction_step::FrictionGroup;
use super::joint::{Guide, Hinge, OuterJoint};
use super::step::Arm;
use super::triad_step::TriadForces;
use crate::math::Vec2;

/// One unknown effort on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EffortLine {
    /// A torque on `body`, with the opposite on `base` (the ground where it comes from outside).
    Torque { body: usize, base: usize },
    /// A force on `body` along a line, in ground axes.
    Force {
        body: usize,
        /// Slot of the effort's line, set before the forces are solved.
        line: usize,
    },
    /// A force on the slider of a prismatic joint along its line, with the opposite on the guide.
    Along(Guide),
}

/// One step of forces.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "a plan has few steps, and the loop reads them in a row")]
pub enum ForceStep {
    /// One body on a revolute with one unknown effort.
    Turn {
        hinge: Hinge,
        effort: EffortLine,
        /// Slot of the effort, and the sign with which it acts on the body.
        value: (usize, f64),
    },
    /// One body on a guide with one unknown effort.
    Shift {
        guide: Guide,
        effort: EffortLine,
        /// Slot of the effort, and the sign with which it acts on the body.
        value: (usize, f64),
    },
    /// Dyad RRR: outer, inner (force on the second link), outer.
    Rrr {
        outer: [Hinge; 2],
        /// The inner revolute in the frames of the links, and its slot; the sign turns the force on the second link
        /// into that kept.
        inner: Inner,
        /// The step of motion of the same group.
        motion: Option<usize>,
    },
    Rrp {
        /// Outer revolute of the link.
        outer: Hinge,
        inner: Inner,
        /// Guide of the slider.
        guide: Guide,
        /// The step of motion of the same group.
        motion: Option<usize>,
    },
    /// Dyad RRR or RRP with unknown efforts inside its links: solved as a dyad of stiff links, then taken apart.
    DrivenLegs {
        /// Outer revolute of the first link, and of the second or its guide.
        outer: (Hinge, OuterJoint),
        /// The inner revolute, on the bodies that carry it.
        inner: Inner,
        /// Slots of the bodies that carry the inner revolute.
        ends: [usize; 2],
        /// The driven joint of each link with its effort, if it has one.
        driven: [Option<DrivenPart>; 2],
    },
    Rpr {
        outer: [Hinge; 2],
        guide: Guide,
    },
    Prp {
        ways: [Guide; 2],
        inner: Inner,
    },
    Rpp {
        /// Outer revolute of the first body.
        outer: Hinge,
        inner: Guide,
        /// Guide of the second body.
        guide: Guide,
    },
    /// A body between two guides; the couples are not determined.
    Translation {
        ways: [Guide; 2],
    },
    /// Bodies held by laws between their rates.
    Train {
        /// Index into [`super::Plan::train_forces`].
        train: usize,
    },
    /// A link on three legs.
    Triad(Box<TriadForces>),
    /// Anything else: all equations of equilibrium at once.
    General {
        /// Index into [`super::Plan::balance_systems`].
        system: usize,
    },
    /// Steps of the groups from the first on, solved as one since friction couples them; none where a later step does it.
    Sequence(Vec<ForceStep>),
    /// A group with friction.
    Friction {
        /// The step without friction.
        plain: Box<ForceStep>,
        /// What rubs in it.
        group: Box<FrictionGroup>,
    },
}

/// The far half of a link with an unknown effort inside: solved like one body with one joint and one effort.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenPart {
    /// The joint, counted on the far half.
    pub joint: OuterJoint,
    pub effort: EffortLine,
    /// Slot of the effort, and the sign with which it acts on the far half.
    pub value: (usize, f64),
}

/// The inner revolute of a dyad on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inner {
    /// The pin in the first body's frame, m.
    pub pin: Vec2,
    /// The pin in the second body's frame.
    pub second_pin: Arm,
    /// The pin goes along the rim of a cam, which is the first body: its place is that of the second body.
    pub on_rim: bool,
    /// From the outer pins to this one in the frames of their bodies, m; of a guide nothing.
    pub arms: [ExactVec; 2],
    /// Slot of the reaction.
    pub slot: usize,
    /// The reaction kept is this times the force of the first body on the second.
    pub sign: f64,
}
