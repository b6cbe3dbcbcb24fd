//! What is measured on a solved problem: the cost of its plan, and what accuracy costs.

pub mod accuracy;
mod choice;
mod clock;
mod cost;
mod digit_less;
mod price;
mod runs;

pub use choice::Choice;
pub use clock::{Clock, micros};
pub use cost::{Costs, MotionCost, Over, costs};
pub use digit_less::{DigitLess, run_with_a_digit_less, samples_with_a_digit_less};
pub use price::Price;
pub use runs::{MethodStudy, RunRow, RunStudy, study_runs};
