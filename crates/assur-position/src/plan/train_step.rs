//! Trains: groups with laws of transmissions.

use super::joint::{Guide, Hinge};
use super::step::{Anchor, Arm, Slide};
use crate::math::Scalar;
use crate::model::{Meeting, PairId};

/// A train group of motion.
#[derive(Clone, Debug)]
pub struct TrainMotion {
    /// Its bodies, each after those it stands on.
    pub members: Vec<TrainMember>,
    /// The rates that it depends on.
    pub sources: Vec<TrainSource>,
    /// One row per member, one column per source.
    pub coefficients: Vec<f64>,
    /// Whether the laws determine it.
    pub regular: bool,
}

/// A body of a train.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TrainMember {
    Turn {
        /// Slot of the body.
        body: usize,
        /// The revolute on the base.
        base: Anchor,
        /// The revolute in the body's frame.
        pin: Arm,
    },
    Shift(Slide),
}

/// A rate that is known before a train is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TrainSource {
    /// A body that turns; its angle is kept, or followed by its direction.
    Turn {
        /// Slot of the body.
        body: usize,
        followed: bool,
    },
    /// The coordinate of a guide.
    Slide(Slide),
    Drive(usize),
    /// A coordinate that does not change: the constants of the laws.
    Constant,
}

/// A law as the forces see it.
#[derive(Clone, Debug)]
pub struct PlannedLaw {
    pub pair: PairId,
    /// Its place among the laws of the transmission.
    pub index: usize,
    /// What it acts on, with the coefficients.
    pub terms: Vec<(LawSite, f64)>,
    /// What the coordinates add up to.
    pub constant: f64,
    /// Part of the power that gets through, from the first side to the second and back.
    pub efficiency: Option<[f64; 2]>,
    /// Its place among the grips, where it loses power: after the elements of friction.
    pub grip: Option<usize>,
    /// Tangential force per unit of the multiplier.
    pub force: f64,
    /// The wheels whose teeth meet at a known place.
    pub meeting: Option<Meeting>,
}

impl PlannedLaw {
    /// Whether a side counts from the carrier: a bevel planet turns relative to it, and has no part in its term.
    #[must_use]
    pub fn counts_from_carrier(&self, side: usize) -> bool {
        crate::model::counts_from_carrier(&self.terms, side)
    }

    /// What a law with losses does at one of its sites, with the forces on its two sides per unit of their coefficients.
    #[must_use]
    pub fn with_losses<S: Scalar>(&self, term: usize, sides: [S; 2]) -> S {
        let side = |i: usize| sides[i] * S::of(self.terms[i].1);
        match term {
            2 if !self.counts_from_carrier(1) => -side(0),
            2 => -(side(0) + side(1)),
            _ => side(term),
        }
    }
}

/// What a law acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LawSite {
    /// A couple on a body: its slot.
    Turn(usize),
    /// A force along a guide, on its slider and back on its base.
    Slide(Guide),
}

/// A train group of forces.
#[derive(Clone, Debug)]
pub struct TrainForces {
    /// Its bodies, each after those it stands on.
    pub members: Vec<TrainSupport>,
    /// Laws whose multipliers are found here: slots.
    pub laws: Vec<usize>,
    /// Unknown efforts: slot, and the bodies they act on with signs.
    pub efforts: Vec<TrainEffort>,
    /// Row by row, one row per member, one column per unknown: laws, then efforts.
    pub matrix: Vec<f64>,
    /// Its inverse: the unknowns are this times the loads with the opposite sign. Empty where it is singular.
    pub inverse: Vec<f64>,
    /// Whatever the loads, one direction of the power in every transmission with losses is consistent, and only one.
    pub unique: bool,
}

/// How a body of a train is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TrainSupport {
    /// By a revolute. The member that carries it, if one does.
    Turn(Hinge, Option<usize>),
    /// By a guide; +1 where the body is the slider, −1 where it carries the line.
    Shift(Guide, f64),
}

/// An unknown effort of a train.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TrainEffort {
    /// A torque: slot, the body, the other body.
    Torque(usize, usize, usize),
    /// A force along a guide: slot, guide.
    Along(usize, Guide),
}
