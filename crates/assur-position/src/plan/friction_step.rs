//! Friction in the joints of a group.

use super::joint::Guide;
use crate::model::{PairId, ProfileShape};

/// Friction in one joint: an effort that opposes the relative motion, in proportion to the reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionElement {
    pub pair: PairId,
    /// Slot of the body the effort is counted on.
    pub body: usize,
    /// Slot of the other body.
    pub base: usize,
    /// Slot of the body through which the effort reaches `body`: the block that stands for a pin in a slot, or `body`
    /// itself. The link of the pin may have been solved before the block.
    pub through: usize,
    /// Slot of the reaction.
    pub slot: usize,
    pub kind: FrictionLaw,
    /// Hinge of several links that its own link does not carry: the force on `body` is the sum of these reactions, a range
    /// of [`super::Plan::pin_slots`], instead of the one in `slot`.
    pub pin: Option<(usize, usize)>,
    /// Contact that parts: what presses is what this stop of the mechanism bears, instead of the reaction in `slot`.
    pub stop: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrictionLaw {
    /// A torque ρ |f| about a hinge.
    Circle {
        /// Radius of the friction circle, m.
        radius: f64,
    },
    /// A force f |N| along a guide.
    Guide { coefficient: f64, guide: Guide },
    /// A force f (|N_1| + |N_2|) along a guide with two contact points.
    BothEnds {
        coefficient: f64,
        guide: Guide,
        /// Coordinates of the contact points relative to the pair's point, m.
        contacts: [f64; 2],
    },
    /// A force f |N| along the tangent of a contact, or along a slot. `slot` holds the normal force.
    Contact {
        coefficient: f64,
        /// The profile on `body`.
        first: ProfileShape,
        /// The profile on `base`.
        second: ProfileShape,
        /// One circle lies inside the other.
        internal: bool,
        /// 1 where the reaction of the slot is that on `body`, −1 where it is that on `base`: along the normal it can only press.
        /// 0 of a slot, which also holds on its other side.
        presses: f64,
    },
    /// A torque δ |N| against the rolling of two profiles. `slot` holds the normal force of their contact.
    Rolling {
        /// Arm δ of rolling resistance, m.
        arm: f64,
    },
}

impl FrictionLaw {
    /// The law with its radius or coefficient multiplied.
    #[must_use]
    pub const fn scaled(mut self, by: f64) -> Self {
        match &mut self {
            Self::Circle { radius: factor }
            | Self::Guide { coefficient: factor, .. }
            | Self::BothEnds { coefficient: factor, .. }
            | Self::Contact { coefficient: factor, .. }
            | Self::Rolling { arm: factor } => *factor *= by,
        }
        self
    }

    /// Whether its effort is a torque, against a relative rotation.
    #[must_use]
    pub const fn turns(&self) -> bool {
        matches!(self, Self::Circle { .. } | Self::Rolling { .. })
    }
}

/// The bodies whose loads a group's step reads or changes, and the elements inside it.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionGroup {
    /// Slots of the group's bodies.
    pub bodies: Vec<usize>,
    /// Slots of the bodies that carry it.
    pub bases: Vec<usize>,
    /// Its elements: indices into [`super::Plan::friction`].
    pub elements: Vec<usize>,
    /// Slots of its reactions.
    pub slots: Vec<usize>,
    /// Slots of the laws of wheels whose multipliers its step finds.
    pub laws: Vec<usize>,
    /// The elements in its joints, where the laws reduce to the force in the inner hinge of a dyad, or to nothing unknown.
    pub reduced: Option<[Option<usize>; 3]>,
}
