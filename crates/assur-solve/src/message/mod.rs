//! Every sentence said about a solution: data of `solve` in words.

mod clause;
mod consistent;
mod consistent_error;
mod error;
mod failure;
mod fixes;
mod flywheel_error;
mod format;
mod friction;
mod friction_error;
mod gap;
mod impossible;
mod notes;
mod open_places;
mod opens;
mod over_sweep;
mod partial_sweep;
mod refusal;
mod simulate;
mod simulate_error;
mod slip;
mod speeds;
mod train_error;
mod unassembled;

pub use clause::clause;
pub use consistent_error::ConsistentError;
pub use error::SolveError;
pub use failure::{failure, failures};
pub use flywheel_error::FlywheelError;
pub use format::place;
pub use friction_error::FrictionError;
pub use notes::notes;
pub use over_sweep::undefined;
pub use train_error::TrainError;
