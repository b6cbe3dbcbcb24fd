//! How a joint carries force.

use super::step::Arm;
use crate::math::Vec2;

/// Where a reaction acts and where it is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    /// Slot of the body it acts on.
    pub body: usize,
    /// The pin in the body's frame.
    pub pin: Arm,
    /// Slot of the body it comes from.
    pub base: usize,
    /// Slot of the reaction: force on `body`.
    pub slot: usize,
}

/// A prismatic joint on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guide {
    /// Slot of the body the reaction is counted on.
    pub body: usize,
    /// Slot of the other body.
    pub base: usize,
    /// Slot of the sliding body.
    pub slider: usize,
    /// Its point in its frame, m: couples are taken about it.
    pub point: Vec2,
    /// Its direction along the line, in its frame.
    pub direction: Vec2,
    /// Slot of the reaction: force and couple on `body`.
    pub slot: usize,
}

/// The second outer joint of a dyad on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OuterJoint {
    Hinge(Hinge),
    Guide(Guide),
}
