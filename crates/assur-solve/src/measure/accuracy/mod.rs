//! What accuracy costs in time: settings of the solver against the error and the time of each, and the settings that a wanted
//! accuracy asks for.
//!
//! An error is always the difference from a reference, never an estimate; [`Error`] says what it is relative to.

mod answer;
mod choice;
mod error;
mod setting;
mod study;
mod within;

pub use answer::Source;
pub use choice::PositionChoice;
pub use error::{Error, Scales};
pub use setting::{Kind, NotApplicable, Row, Setting};
pub(super) use study::sampled;
pub use study::{AccuracyStudy, study};
pub use within::{AchievedAccuracy, candidates, out_of_reach, reached, run_out_of_reach};
