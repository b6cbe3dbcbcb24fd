//! Every sentence said about a solution: data of `solve` in words.

mod clause;
mod consistent;
mod failure;
mod format;
mod friction;
mod gap;
mod impossible;
mod notes;
mod odd_point;
mod open_places;
mod opens;
mod over_sweep;
mod parallel;
mod partial_sweep;
mod refusal;
mod simulate;
mod slip;
mod speeds;
mod unassembled;

pub use clause::clause;
pub use failure::{failure, failures};
pub use format::{drive_text, place};
pub use notes::notes;
pub use over_sweep::undefined;
