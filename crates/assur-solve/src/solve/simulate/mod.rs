//! Motion under given loads: the free coordinates from instant to instant.
//!
//! The equations of the free coordinates are those of [`Reduced`](crate::position::Reduced); everything else follows from
//! these coordinates in closed form, so that nothing drifts apart. Two runs of different tolerance go side by side: what they
//! differ by is the error of the coarser one, and the finer one is what is reported.

mod compare;
mod drives;
mod equations;
mod going;
mod poses;
mod records;
mod report;
mod rubbing;
mod run;
mod setup;
mod trajectory;
mod watch;

pub use report::{Energy, Method, SimulationReport};

pub(super) use drives::Instant;
pub(super) use trajectory::{Trajectory, trajectory};
