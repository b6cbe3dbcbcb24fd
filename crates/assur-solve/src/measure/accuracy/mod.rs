//! What accuracy costs in time: settings of the solver against the error and the time of each, and the settings that a wanted
//! accuracy asks for.
//!
//! An error is always the difference from a reference, never an estimate; [`Error`] says what it is relative to.

mod answer;
mod clock;
mod error;
mod setting;
mod study;
mod within;

pub use answer::Source;
pub use clock::micros;
pub use error::{Error, Scales};
pub use setting::{Kind, NotApplicable, Row, Setting};
pub use study::{AccuracyStudy, Recommendation, study};
pub use within::{AccuracyError, AchievedAccuracy, candidates, out_of_reach, reached};
