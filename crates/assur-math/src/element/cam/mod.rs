//! Plate cams: laws of motion, pitch curve and working profile, pressure angle, curvature.

mod bound;
mod design;
mod fault;
mod flank;
mod law;
mod outline;
mod point;
mod program;

pub use design::Cam;
pub use fault::{Fault, Misfit};
pub use flank::{Flank, Reached};
pub use law::{Jet, Law};
pub use outline::MOST_STEPS;
pub use point::{CamPoint, Quantity};
pub use point::{Follower, Shape};
pub use program::{Part, Phase, Program};
