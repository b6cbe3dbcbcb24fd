//! Every sentence said about a solution.

#![allow(non_snake_case, reason = "names carry the notation of the field: p_A, p_B")]

mod assembly_lines;
mod at_pose;
mod consistent_error;
mod consistent_warnings;
mod error;
mod format;
mod free_roller;
mod friction_error;
mod friction_warnings;
mod gap;
mod impossible;
mod not_closing;
mod open_places;
mod out_of_scale;
mod over_sweep;
mod too_far;
mod train_error;
mod unsupported;
mod warnings;

pub(crate) use assembly_lines::{ambiguous, lines, near_lines, not_met};
pub(crate) use at_pose::with_pose;
pub use consistent_error::ConsistentError;
pub use error::SolveError;
pub(crate) use format::place;
pub(crate) use free_roller::free_rollers;
pub use friction_error::FrictionError;
pub(crate) use friction_warnings::FrictionNotes;
pub(crate) use impossible::{cannot_hold, dead, not_finite};
pub(crate) use not_closing::does_not_close;
pub use open_places::unplaced_reactions;
pub(crate) use open_places::{friction_beside, friction_couples, without_place, without_position};
pub(crate) use out_of_scale::out_of_scale;
pub(crate) use over_sweep::{needless_flywheel, no_extreme, no_flywheel, no_sweep, undefined};
pub(crate) use too_far::too_far;
pub use train_error::TrainError;
pub(crate) use unsupported::{cams, missing_speeds, not_supported, unit_speeds};
pub(crate) use warnings::{Closing, Notes};
