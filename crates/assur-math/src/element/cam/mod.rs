//! Plate cams: laws of motion, pitch curve and working profile, pressure angle, curvature.

mod bound;
mod design;
mod fault;
mod flank;
mod follower;
mod law;
mod point;
mod program;

pub use design::Cam;
pub use fault::{Fault, Misfit};
pub use flank::{Flank, Reached};
pub use follower::{Follower, Shape};
pub use law::{Jet, Law};
pub use point::{CamPoint, Quantity};
pub use program::{Part, Phase, Program};
