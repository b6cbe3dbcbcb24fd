//! Joints as a group sees them.

use super::joint::{BodyId, JointId};

/// A joint of a group, reduced to two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroupJoint {
    pub joint: JointId,
    /// Its body in the group.
    pub body: BodyId,
    /// The other body: in the group for an inner joint; else one that is known already (motion) or solved later (forces).
    pub base: BodyId,
    /// Both bodies are in the group.
    pub inner: bool,
    /// Prismatic rather than revolute.
    pub prismatic: bool,
}
