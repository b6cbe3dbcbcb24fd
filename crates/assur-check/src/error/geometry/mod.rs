//! The machine itself: links, pairs, drives, poses, assembly, loads, elements.

mod link;
mod load;
mod motion;
mod pair;

pub use link::LinkError;
pub use load::LoadError;
pub use motion::MotionError;
pub use pair::PairError;
