//! Plan × positions → Solution.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod again;
mod assemble;
mod choices;
mod consistent_error;
mod consistent_notes;
mod cycle;
mod digits;
mod error;
mod extremes;
mod free_roller;
mod friction_error;
mod friction_notes;
mod gap;
mod inputs;
mod modes;
mod notes;
mod open;
mod out_of_scale;
mod pose;
mod positions;
mod refused;
mod solution;
mod steps;
mod sweep;
mod track;
mod train_error;
mod turn;
mod words;

pub use crate::answer::{CycleAnswer, FlywheelAnswer, Rubbing, Statics, View, compare};
#[cfg(target_arch = "x86_64")]
pub use crate::position::block_in_avx2;
pub use crate::position::{
    BodyState, Branch, Consistent, DriveColumns, DriveInput, Edge, LawForce, Place, Reaction, Residuals,
    RubbingWork, Scene, Searched, SideBySide, State, TrainWork, WIDTH, Wrench, in_scalar, instructions,
    precise, residuals,
};
pub use crate::reference::{Exact, Reference, exact, knows_couple, reference};
pub use again::Again;
pub use consistent_error::ConsistentError;
pub use cycle::over_cycle;
pub use error::SolveError;
pub use friction_error::FrictionError;
pub use modes::{GroupModes, Mode, Modes, modes};
pub use open::unplaced_reactions;
pub use solution::{DriveValue, OpenSizes, Pose, PoseOrigin, Solution, Solved};
pub use steps::extent;
pub use sweep::{Following, refusals, solve, solve_with};
pub use train_error::TrainError;

pub(crate) use assemble::assemble;
pub(crate) use cycle::cycles;
pub(crate) use extremes::statics;
pub(crate) use inputs::Rates;
pub(crate) use positions::{Sweep, turns};
pub(crate) use sweep::can_be_solved;
pub(crate) use track::Tracker;
