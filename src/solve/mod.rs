//! Plan × positions → Solution.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod assemble;
mod choices;
mod contact;
mod coordinate;
mod driven_legs;
mod effort;
mod error;
mod evaluate;
mod extremes;
mod forces;
mod friction;
mod friction_answers;
mod friction_error;
mod friction_notes;
mod gap;
mod general;
mod inputs;
mod loads;
mod locking;
mod modes;
mod motion;
mod notes;
mod pose;
mod positions;
mod refused;
mod residual;
mod solution;
mod state;
mod substitution;
mod sweep;
mod track;
mod triad;
mod view;
mod words;

pub use error::SolveError;
pub use evaluate::compare;
pub use extremes::Statics;
pub use friction_answers::Rubbing;
pub use friction_error::FrictionError;
pub use modes::{GroupModes, Mode, Modes, modes};
pub use solution::{DriveValue, Pose, PoseOrigin, Residuals, Scene, Solution, Solved};
pub use state::{BodyState, Branch, DriveInput, Reaction, State, Wrench};
pub use sweep::{solve, solve_with};
pub use view::View;
