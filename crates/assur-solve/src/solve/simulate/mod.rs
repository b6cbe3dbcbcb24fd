//! Motion under given loads: the free coordinates from instant to instant.
//!
//! The equations of the free coordinates are those of [`Reduced`](crate::position::Reduced); everything else follows from
//! these coordinates in closed form, so that nothing drifts apart. Two runs, one in halves or two thirds of the steps of the other, go
//! side by side: what they differ by, and how much finer the finer one is, tell its error; it is what comes out.

mod acting;
mod bearing;
mod bends;
mod by_energy;
mod change;
mod chart;
mod compare;
mod contact_modes;
mod coordinates;
mod corners;
mod crossing_search;
mod depends;
mod derivatives;
mod dissipative;
mod drives;
mod energy;
mod equations;
mod estimate;
mod event_detector;
mod functions;
mod held_efforts;
mod impact;
mod impulses;
mod integration;
mod kinks;
mod loads;
mod lookout;
mod meeting;
mod multi_crossing;
mod options;
mod over_time;
mod part;
mod pass;
mod placed;
mod plane;
mod poses;
mod precise;
mod rebounding;
mod records;
mod refining;
mod report;
mod run;
mod seams;
mod secants;
mod seen;
mod setup;
mod singular_crossing;
mod sliding_sense;
mod springs;
mod stages;
mod starting;
mod steady;
mod stick_slip;
mod stop;
mod stop_modes;
mod tangential;
mod touch;
mod touching;
mod trace;
mod trajectory;
mod trials;
mod truncation;
mod turning;
mod unilateral;
mod walk;
mod ways;

pub use compare::{KINDS, STATES};
pub use options::{IntegrationOptions, Progress};
pub(crate) use over_time::over_time;
pub use report::{Energy, Holder, Method, NotByEnergy, On, SimulationReport, SteadyReport};
pub use trials::{Trial, Trials};

pub(super) use chart::Given;
pub(super) use drives::Instant;
pub(super) use trajectory::{Trajectory, trajectory};
