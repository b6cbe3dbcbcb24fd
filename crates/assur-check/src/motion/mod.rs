//! How the machine moves: drives, poses, the assembly that is meant.

pub mod assemble;
pub mod drive;
pub mod drive_kind;
pub mod pose;
pub mod simulation;
