//! Motion under given loads: the free coordinates from instant to instant.
//!
//! The equations of the free coordinates are those of [`Reduced`](crate::position::Reduced); everything else follows from
//! these coordinates in closed form, so that nothing drifts apart. Two runs, one in halves or two thirds of the steps of the other, go
//! side by side: what they differ by, and how much finer the finer one is, tell its error; it is what comes out.

mod acting;
mod bends;
mod bonds;
mod bridge;
mod by_energy;
mod change;
mod chart;
mod compare;
mod conduct;
mod coordinates;
mod corners;
mod depends;
mod derivatives;
mod drives;
mod energy;
mod equations;
mod estimate;
mod functions;
mod going;
mod holding;
mod impact;
mod leap;
mod left_off;
mod loads;
mod meeting;
mod over_time;
mod part;
mod pass;
mod passage;
mod placed;
mod poses;
mod precise;
mod rebounding;
mod records;
mod refining;
mod report;
mod resting;
mod reversing;
mod rubbing;
mod rubs;
mod run;
mod seams;
mod secants;
mod seen;
mod setup;
mod sliding;
mod slipping;
mod springs;
mod stages;
mod standing;
mod starting;
mod steady;
mod stop;
mod strike;
mod touch;
mod trace;
mod trajectory;
mod trials;
mod turning;
mod walk;
mod watch;
mod ways;

pub use compare::{KINDS, STATES};
pub use conduct::{Conduct, Watch};
pub use over_time::{OverTime, TimeCourse, over_time};
pub use report::{Energy, Method, NotByEnergy, On, SimulationReport, SteadyReport};
pub use trials::{Trial, Trials};

pub(super) use chart::Given;
pub(super) use drives::Instant;
pub(super) use trajectory::{Trajectory, trajectory};
