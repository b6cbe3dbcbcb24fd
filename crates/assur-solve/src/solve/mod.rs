//! Plan × positions → Solution.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod again;
mod as_written;
mod assemble;
mod assemblies;
mod block;
mod centre_notes;
mod clause;
mod closure_after_turn;
mod course;
mod cycle;
mod digits;
mod extremes;
mod failure;
mod friction_notes;
mod gap;
mod initial_guess;
mod inputs;
mod iteration;
mod lost;
mod motion_scales;
mod note;
mod notes;
mod pose;
mod positions;
mod refusal;
mod refusals;
mod regular;
mod replay;
mod run;
mod simulate;
mod solution;
mod steps;
mod sweep;
mod track;
mod turn;
mod unassembled;
mod whole_turns;

pub use crate::answer::{
    CycleAnswer, FlywheelAnswer, JointReaction, PairFriction, PoseAnswers, PoseExtras, Source, WholeCycle,
    compare, finite, read_numbers,
};
pub use crate::position::PoseRequest;
pub use crate::position::{
    BodyState, Branch, Checked, Consistent, DriveInput, Edge, F64x8, FrictionWork, LaneSolver, LawForce,
    Model, Reaction, Residuals, Searched, State, TrainWork, WIDTH, Wrench, in_scalar, precise, residuals,
};
pub use crate::position::{DriveValue, PoseOrigin, extent};
pub use crate::reference::{Exact, Reference, exact, knows_couple, reference};
pub use again::{PoseOutputs, ReusedSolver};
pub use assemblies::{Assemblies, GroupAssemblies, GroupAssembly, assemblies, not_chosen};
pub use block::{BLOCK, Block, FreeSweep};
pub use clause::{Clause, NamedPoint};
pub use course::{Course, CourseSet, Courses, courses};
pub use cycle::over_cycle;
pub use failure::{Cause, Failure, GroupId, Halt, Lost, NoCycle};
pub use gap::{GroupGap, TurnGap};
pub use iteration::{Begun, Iteration, iteration};
pub use motion_scales::MotionScales;
pub use note::{Closing, Gap, Locking, Loss, Note, Pull, Uncertified, WholeCycleRange};
pub use refusal::{Refusal, Unpositioned};
pub use refusals::{refusals, unplaced_reactions};
pub use replay::Replay;
pub use simulate::{
    Energy, Holder, IntegrationOptions, KINDS, Method, NotByEnergy, On, Progress, STATES, SimulationReport,
    SteadyReport, Trial, Trials,
};
pub use solution::{OpenSizes, Pose, Solution, Solved};
pub use sweep::{Following, solve, solve_with};
pub use unassembled::MOST_CLAUSES;

pub(crate) use assemble::assemble;
pub(crate) use cycle::cycles;
pub(crate) use extremes::statics;
pub(crate) use inputs::Rates;
pub(crate) use positions::Sweep;
pub(crate) use track::Tracker;
