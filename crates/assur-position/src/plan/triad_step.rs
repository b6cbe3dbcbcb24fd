//! A link on three legs.

use super::joint::{Guide, OuterJoint};
use super::step::{Arm, Leg, Slide};
use crate::group::triad::Plate;
use crate::math::Vec2;

/// The motion of a triad.
#[derive(Clone, Debug, PartialEq)]
pub struct TriadMotion {
    pub legs: [TriadLeg; 3],
    /// Slot of the link they carry.
    pub body: usize,
    /// The mean of its pins, in its frame, m.
    pub mean: Vec2,
    pub plate: Plate,
}

/// A leg on the side of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriadLeg {
    /// A link on a revolute.
    Link(Leg),
    /// A slider on a guide.
    Slider {
        slide: Slide,
        /// The inner revolute in the slider's frame, m.
        pin: Arm,
        /// The inner revolute from the sliding point to the left of the guide, m.
        offset: f64,
    },
}

/// The forces of a link on three legs, each a link between two joints of which at most one is a guide.
#[derive(Clone, Debug, PartialEq)]
pub struct TriadForces {
    pub legs: [TriadForceLeg; 3],
    /// Slot of the link they carry.
    pub body: usize,
}

/// A leg on the side of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriadForceLeg {
    /// Slot of its body.
    pub body: usize,
    /// What it depends on.
    pub outer: OuterJoint,
    /// How it holds the link.
    pub inner: TriadHold,
}

/// What joins a leg to the link it helps to carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriadHold {
    Pin {
        /// In the frame of the leg.
        leg: Arm,
        /// In the frame of the link, m.
        link: Vec2,
        /// Slot of its reaction.
        slot: usize,
        /// The reaction kept is this times the force of the leg on the link.
        sign: f64,
        /// Unit direction from the outer revolute to this one in the frame of the leg; of a slider nothing.
        direction: Vec2,
        /// 1 / distance of the two, 1/m.
        inverse: f64,
    },
    Guide(Guide),
}
