//! What is measured on a solved problem: the cost of its plan, and what accuracy costs.

pub mod accuracy;
mod clock;
mod cost;
mod runs;

pub use clock::{Clock, micros};
pub use cost::{Costs, Over, costs};
pub use runs::{MethodStudy, RunRow, RunStudy, study_runs};
