//! Groups that have no closed form.

use super::joint::{Guide, Hinge};
use crate::group::general::General;
use crate::math::Vec2;

/// A group of motion. Bodies are slots: those of the group first, then those of known motion that it depends on.
#[derive(Clone, Debug)]
pub struct GeneralMotion {
    /// Slots of the bodies.
    pub bodies: Vec<usize>,
    /// How many of them belong to the group.
    pub moving: usize,
    /// The equations with their memory; `None` where there are not as many as unknowns.
    pub equations: Option<General>,
    /// Constraints that a drive sets: index, slot of the drive, and the axis of the first body from that of the second where its
    /// angle is between others than x axes.
    pub driven: Vec<(usize, usize, Option<Vec2>)>,
    /// Constraints of round profiles: index and radius, m.
    pub round: Vec<(usize, f64)>,
    /// Bodies whose angles laws of wheels speak of: slot, whether it is of the group, whether its angle is followed by its
    /// direction.
    pub turning: Vec<(usize, bool, bool)>,
    /// Slots of its laws.
    pub laws: Vec<usize>,
    /// Its laws may turn one body so many times as fast as another: steps of the motion are as much shorter.
    pub faster: f64,
}

/// A group of forces.
#[derive(Clone, Debug)]
pub struct BalanceSystem {
    /// Slots of the bodies: those of the group first.
    pub bodies: Vec<usize>,
    /// How many of them belong to the group.
    pub moving: usize,
    /// The equations with their memory; `None` where there are not as many as unknowns.
    pub equations: Option<General>,
    /// What each constraint gives, in their order.
    pub unknowns: Vec<UnknownForce>,
    /// Constraints along the lines of unknown forces: index, slot of the effort.
    pub lines: Vec<(usize, usize)>,
    /// Angles in which unknown torques act: any position satisfies them.
    pub torques: Vec<usize>,
    /// Efforts at several places: slot, the other bodies' share of it. Their equations come before those of the laws.
    pub shared: Vec<(usize, Vec<SharedPlace>)>,
    /// Slots of the laws of wheels whose multipliers are found here, in the order of the equations.
    pub laws: Vec<usize>,
}

/// One of the places of an effort that acts at several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SharedPlace {
    /// A torque of the second body on the first.
    Torque(usize, usize),
    /// A force on the slider of a prismatic joint along its line.
    Along(Guide),
}

/// What the force in a constraint is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UnknownForce {
    /// The force in a revolute, two numbers: slot.
    Hinge {
        /// Slot of the reaction.
        slot: usize,
        hinge: Hinge,
    },
    /// The couple of a prismatic joint on its slider.
    Couple(Guide),
    /// The normal force of a prismatic joint on its slider.
    Normal(Guide),
    /// A torque of `base` on `body`: slot of the effort.
    Torque {
        /// Slot of the effort.
        effort: usize,
        body: usize,
        base: usize,
    },
    /// A force on the slider of a prismatic joint along its line.
    Along {
        /// Slot of the effort.
        effort: usize,
        guide: Guide,
    },
    /// A force on a body along the line of an effort: its slot.
    Line(usize),
    /// A torque that holds a passive freedom: nothing.
    Passive,
}
