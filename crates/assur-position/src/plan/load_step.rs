//! Loads, and the lines of unknown forces.

use super::step::{Anchor, Arm};
use crate::math::Vec2;
use crate::model::{LoadId, SpringId};

/// One load. Numbers that do not change over a sweep are in the step; the rest is evaluated at every position.
#[derive(Clone, Debug)]
pub enum LoadStep {
    /// The weight at the mass centre, with the inertia force −m a_S and torque −J α where `inertia` is set. The first load of
    /// its body: it is written, not added.
    Mass {
        /// Slot of the body.
        body: usize,
        /// Mass centre in the body's frame.
        centre: Arm,
        /// Mass, kg.
        mass: f64,
        /// Moment of inertia about the mass centre, kg m².
        moment_of_inertia: f64,
        /// Weight, N; null without gravity.
        weight: Vec2,
        /// Weight over mass, m/s².
        gravity: Vec2,
        inertia: bool,
    },
    /// A force that does not change, at a point of a body.
    Force {
        load: LoadId,
        /// Slot of the body.
        body: usize,
        /// Point in the body's frame, m.
        at: Vec2,
        /// Force, N, in ground axes or, where `turning`, in the body's axes.
        force: Vec2,
        /// The axes turn with this body.
        frame: Option<usize>,
    },
    /// A torque that does not change.
    Torque {
        load: LoadId,
        /// Slot of the body.
        body: usize,
        /// Torque, N m.
        torque: f64,
    },
    /// A load with expressions, a condition, a place of the ground, or inside a pair.
    Evaluated(LoadId),
    /// A spring with a damper beside it.
    Spring {
        spring: SpringId,
        /// Its ends: slots of bodies and points in their frames, m.
        ends: [Anchor; 2],
        /// Stiffness, N/m.
        stiffness: f64,
        /// Length without load, m.
        free_length: f64,
        /// Damping, N s/m; none without a damper, so that no velocities are looked at.
        damping: Option<f64>,
    },
}

impl LoadStep {
    /// Whether it adds to the load of a body; one that is evaluated may act on any.
    pub(super) fn acts_on(&self, slot: usize) -> bool {
        match self {
            Self::Mass { body, .. } | Self::Force { body, .. } | Self::Torque { body, .. } => *body == slot,
            Self::Spring { ends, .. } => ends.iter().any(|end| end.body == slot),
            Self::Evaluated(_) => true,
        }
    }
}

/// The line of an unknown force.
#[derive(Clone, Copy, Debug)]
pub struct ForceLine {
    /// Slot of the effort.
    pub effort: usize,
    /// Slot of the body with the point of the line; the ground's for a place that does not move.
    pub body: usize,
    /// The point in its frame, m.
    pub at: Vec2,
    /// Unit direction in ground axes, or in those of `frame`.
    pub along: Vec2,
    /// The axes turn with this body.
    pub frame: Option<usize>,
}
