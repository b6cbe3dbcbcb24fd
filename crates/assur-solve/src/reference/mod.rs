//! One position with twice the digits, from the equations of all bodies at once.
//!
//! The closed forms of the groups are not used. From the poses of a state in `f64` Newton's method in double-double solves
//! the closure of all joints of the replaced mechanism, the laws of transmissions and cams, and the drives; velocities,
//! accelerations and rates beyond follow from the same equations differentiated; forces are one linear system of the equilibria of all
//! bodies, with friction by Newton's method on the laws of all its elements.
//!
//! Taken as exact are the numbers that the model holds in `f64`: points of links, the distances between them formed again;
//! radii, coefficients of laws, masses and the acceleration of gravity, their products formed again; the drives' values;
//! directions, of unit length again. Loads that are expressions have the values that they have in `f64`. Taken over from
//! the state are its choices: the assembly, on which side of a line a profile lies, the senses of sliding, the sense of
//! the power in transmissions with losses.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod cam;
mod contact;
mod exact;
mod forces;
mod geneva;
mod loads;
mod motion;
mod unknowns;

pub use exact::{Exact, exact, knows_couple};

use crate::math::{Double, V2, Vec2};
use crate::model::{LoadId, Value};
use crate::position::{BodyState, Model, Reaction, State, Wrench};

/// A position with about 30 digits. Slots are those of the [`State`] it belongs to; without forces their lists are empty.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Bodies, the ground first.
    pub bodies: Vec<BodyState<Double>>,
    /// Loads on the bodies.
    pub applied: Vec<Wrench<Double>>,
    /// Reactions by slot. Couples of guides that close a chain of them are not determined and stand in one of them.
    pub reactions: Vec<Reaction<Double>>,
    pub efforts: Vec<Double>,
    /// Efforts of friction, by element.
    pub frictions: Vec<Double>,
    /// Multipliers of the laws of transmissions.
    pub multipliers: Vec<Double>,
    /// What the equations of position are off, relative to the magnitudes in them.
    pub closure: f64,
    /// Worst lack of equilibrium of a body over the greatest force, or moment, in play.
    pub equilibrium: f64,
}

/// The reference of a state, with the values of its loads that are expressions (see
/// `PoseAnswers::evaluated_loads`). `None` where the position is so near to a singular one that there is none near the
/// state's, or where the equations are not as many as the unknowns. A locked state has no forces.
#[must_use]
pub fn reference(model: &Model<'_>, state: &State, evaluated: &[(LoadId, Value)]) -> Option<Reference> {
    let motion = motion::motion(model, state)?;
    let balanced = model.plan.effects.forces && !model.plan.forces.is_empty() && !state.forces.locked;
    let forces =
        if balanced { forces::forces(model, state, &motion, evaluated)? } else { forces::Forces::default() };
    Some(Reference {
        closure: motion.closure,
        bodies: motion.bodies,
        applied: forces.applied,
        reactions: forces.reactions,
        efforts: forces.efforts,
        frictions: forces.frictions,
        multipliers: forces.multipliers,
        equilibrium: forces.equilibrium,
    })
}

/// A direction of the model, of unit length to all digits.
fn unit(direction: Vec2) -> V2<Double> {
    crate::plan::step::unit(direction)
}
