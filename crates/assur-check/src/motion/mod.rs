//! How the machine moves: drives, poses, the assembly that is meant.

pub mod assemble;
pub mod drive;
pub mod drive_kind;
pub mod equilibrium;
pub mod no_motion;
pub mod place;
pub mod pose;
pub mod simulation;
pub mod spacing;
mod step_size;
