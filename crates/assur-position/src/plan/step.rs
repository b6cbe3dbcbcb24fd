//! The steps of motion: plain numbers and slots, nothing to look up.

use super::exact_vec::ExactVec;
use super::triad_step::TriadMotion;
use crate::group::rrr::Sides;
use crate::math::{Scalar, V2, Vec2};

/// A point in a body's frame, m; `None` at its origin, where there is nothing to turn.
pub type Arm = Option<Vec2>;

/// A point of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    pub body: usize,
    /// The point in the body's frame, m.
    pub at: Vec2,
}

/// A line on a body of known motion along which another body slides without turning against it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slide {
    /// Slot of the body that carries the line.
    pub base: usize,
    /// Origin of the line in the base's frame, m.
    pub origin: Vec2,
    /// Unit direction of the line in the base's frame.
    pub along: Vec2,
    /// Slot of the sliding body.
    pub body: usize,
    /// The point of the sliding body whose coordinate is counted, in its frame, m.
    pub point: Vec2,
    /// Unit direction in the sliding body's frame that lies along the line.
    pub direction: Vec2,
    /// Direction of the sliding body against the base.
    pub turn: Vec2,
    /// Distance of the point to the left of the line, times the branch's side, m: not zero for a round profile only.
    pub radius: f64,
    /// The pair's coordinate is this times the coordinate counted here: ±1.
    pub sense: f64,
}

/// A body hung by a revolute on a body of known motion, with its second revolute at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Slot of the body.
    pub body: usize,
    /// The outer revolute on the base.
    pub base: Anchor,
    /// The outer revolute in the body's frame.
    pub pin: Arm,
    /// Unit direction in the body's frame from the outer revolute to the inner one.
    pub direction: Vec2,
    /// Distance of the two, m.
    pub length: f64,
    /// The direction over the distance, 1/m.
    pub turn: Vec2,
    /// From the outer revolute to the inner one, m.
    pub arm: ExactVec,
}

impl Leg {
    /// Distance of the two revolutes, m.
    #[inline(always)]
    pub fn length<S: Scalar>(&self) -> S {
        if S::EXTENDED { self.arm.of::<S>().norm() } else { S::of(self.length) }
    }

    /// The direction from one to the other over the distance, 1/m.
    #[inline(always)]
    pub fn turn<S: Scalar>(&self) -> V2<S> {
        let arm = self.arm.of::<S>();
        if S::EXTENDED { arm / arm.dot(arm) } else { V2::of(self.turn) }
    }
}

/// A unit direction of the plan.
#[inline(always)]
pub fn unit<S: Scalar>(direction: Vec2) -> V2<S> {
    let direction = V2::of(direction);
    if S::EXTENDED { direction / direction.norm() } else { direction }
}

impl Slide {
    /// Direction of the sliding body against the base.
    #[inline(always)]
    pub fn turn<S: Scalar>(&self) -> V2<S> {
        if S::EXTENDED { unit(self.along).turned_back(unit(self.direction)) } else { V2::of(self.turn) }
    }
}

/// A link of a dyad that may consist of two bodies with a driven joint between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenLeg {
    /// Slot of the body with the outer revolute.
    pub body: usize,
    /// The outer revolute on the base.
    pub base: Anchor,
    /// The outer revolute in the body's frame.
    pub pin: Arm,
    /// From the outer revolute to the inner one, in the body's frame, m; of a leg with a driven joint the part that does
    /// not change.
    pub arm: ExactVec,
    pub joint: Option<DrivenJoint>,
}

/// The driven joint inside a leg, and the body after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrivenJoint {
    /// A guide on the first body.
    Shift {
        slide: Slide,
        /// Slot of the drive.
        drive: usize,
    },
    /// A revolute on the first body.
    Turn {
        /// The revolute on the first body.
        base: Anchor,
        /// Slot of the second body.
        body: usize,
        /// The revolute in the second body's frame.
        pin: Arm,
        /// From it to the inner revolute, in the second body's frame, m.
        arm: ExactVec,
        /// Slot of the drive.
        drive: usize,
        /// The angle of the second body is this times the drive's value.
        sign: f64,
    },
}

/// One step of motion. `branch` is the slot of the group's branch and of its condition figure.
#[derive(Clone, Debug)]
pub enum MotionStep {
    /// A body on a revolute at a driven angle.
    Turn {
        branch: usize,
        /// Slot of the body.
        body: usize,
        /// The revolute on the base.
        base: Anchor,
        /// The revolute in the body's frame.
        pin: Arm,
        /// Slot of the drive.
        drive: usize,
        /// The angle is measured from the base instead of the ground.
        relative: bool,
        /// With this sign, ±1.
        sign: f64,
        /// The axis of the base from that of the body: where the angle is between others than their x axes.
        ahead: Option<Vec2>,
    },
    /// A body that stands freely.
    Free {
        branch: usize,
        /// Slot of the body.
        body: usize,
        /// The driven point in the body's frame.
        at: Arm,
        /// Slots of the drives of its coordinates x, y.
        place: [usize; 2],
        /// Slot of the drive of the angle; of a particle there is none.
        turn: Option<usize>,
    },
    /// A body on a guide at a driven coordinate.
    Shift {
        branch: usize,
        slide: Slide,
        /// Slot of the drive.
        drive: usize,
    },
    Rrr {
        branch: usize,
        legs: [Leg; 2],
        sides: Sides<f64>,
    },
    /// Dyad RRP: the slider carries the inner revolute.
    Rrp {
        branch: usize,
        leg: Leg,
        /// The guide of the slider.
        slide: Slide,
        /// The inner revolute in the slider's frame.
        pin: Arm,
        /// The inner revolute from the sliding point, in the axes of the guide, m.
        from_point: ExactVec,
    },
    /// Dyad RRR with driven joints inside its links.
    DrivenRrr {
        branch: usize,
        legs: [DrivenLeg; 2],
    },
    /// Dyad RRP with a driven joint inside its link.
    DrivenRrp {
        branch: usize,
        leg: DrivenLeg,
        /// The guide of the slider.
        slide: Slide,
        /// The inner revolute in the slider's frame.
        pin: Arm,
        /// The inner revolute from the sliding point, in the axes of the guide, m.
        from_point: ExactVec,
    },
    /// Dyad RPR: the first body carries the line.
    Rpr {
        branch: usize,
        /// The outer revolutes on their bases.
        bases: [Anchor; 2],
        /// The outer revolutes in the frames of their bodies.
        pins: [Arm; 2],
        /// The inner guide, on the first body.
        slide: Slide,
        /// The first outer revolute from the line's origin, in the axes of the line, m.
        from_origin: ExactVec,
        /// The second outer revolute from the sliding point, in the axes of the line, m.
        from_point: ExactVec,
    },
    Prp {
        branch: usize,
        slides: [Slide; 2],
        /// The inner revolute in the frames of the sliders.
        pins: [Arm; 2],
        /// The inner revolute from the sliding points, in the axes of the guides, m.
        from_point: [ExactVec; 2],
    },
    /// Dyad RPP: the first body is hung by a revolute and slides along a line of the second, which slides on a base.
    Rpp {
        branch: usize,
        /// The outer revolute on its base.
        base: Anchor,
        /// The outer revolute in the first body's frame.
        pin: Arm,
        /// The inner guide, on the second body.
        inner: Slide,
        outer: Slide,
    },
    /// A body between two guides that fix its angle alike.
    Translation {
        branch: usize,
        slides: [Slide; 2],
    },
    /// Bodies moved by laws between their rates.
    Train {
        branch: usize,
        /// Index into [`super::Plan::trains`].
        train: usize,
    },
    /// A link on three legs.
    Triad {
        branch: usize,
        triad: Box<TriadMotion>,
    },
    /// The follower of a designed cam.
    Cam {
        branch: usize,
        /// Index into [`super::Plan::cams`].
        cam: usize,
    },
    /// A designed cam that its follower turns.
    CamTurned {
        branch: usize,
        /// Index into [`super::Plan::cams`].
        cam: usize,
    },
    Geneva {
        branch: usize,
        /// Index into [`super::Plan::genevas`].
        geneva: usize,
    },
    /// Anything else, by Newton's method.
    General {
        branch: usize,
        /// Index into [`super::Plan::general`].
        problem: usize,
    },
}

impl MotionStep {
    /// Its place in the order of motion.
    #[must_use]
    pub const fn branch(&self) -> usize {
        match self {
            Self::Turn { branch, .. }
            | Self::Free { branch, .. }
            | Self::Shift { branch, .. }
            | Self::Rrr { branch, .. }
            | Self::Rrp { branch, .. }
            | Self::DrivenRrr { branch, .. }
            | Self::DrivenRrp { branch, .. }
            | Self::Rpr { branch, .. }
            | Self::Prp { branch, .. }
            | Self::Rpp { branch, .. }
            | Self::Translation { branch, .. }
            | Self::Train { branch, .. }
            | Self::Triad { branch, .. }
            | Self::Cam { branch, .. }
            | Self::CamTurned { branch, .. }
            | Self::Geneva { branch, .. }
            | Self::General { branch, .. } => *branch,
        }
    }

    /// Whether it has a second assembly of the other root.
    #[must_use]
    pub const fn has_two_roots(&self) -> bool {
        matches!(
            self,
            Self::Rrr { .. }
                | Self::Rrp { .. }
                | Self::Rpr { .. }
                | Self::DrivenRrr { .. }
                | Self::DrivenRrp { .. }
        )
    }
}
