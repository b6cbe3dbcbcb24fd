//! What can be wrong with the meaning of a document: one enum per topic.

mod geometry;
mod name;

pub use geometry::{LinkError, LoadError, MotionError, PairError};
pub use name::NameError;
