//! What a question evaluates to at a position, and what needs no position.

#![allow(non_snake_case, reason = "names carry the notation of the field: dJ")]

mod angles;
mod axial;
mod constant;
mod contact_normal;
mod coordinate;
mod curvature;
mod cycle_answers;
mod effort;
mod evaluate;
mod evaluated_loads;
mod every_query;
mod flywheel_answers;
mod free_body;
mod friction_answers;
mod internal;
mod joint_reaction;
mod left_curve;
mod locking;
mod pose_answers;
mod pose_numbers;
mod pressure_angle;
mod query_size;
mod sharing;
mod sides;
mod size;
mod sizes;
mod substitution;
mod switch;
mod train_answers;
mod turning;
mod undefined;
mod whole_cycle;

pub(crate) use angles::{first_angles, first_angles_in, whole_turns};
pub(crate) use constant::constant;
pub use cycle_answers::{CycleAnswer, FlywheelAnswer};
pub use evaluate::compare;
pub(crate) use evaluated_loads::balanced;
pub(crate) use every_query::{every_expr, every_query};
pub use friction_answers::PairFriction;
pub use internal::{Acting, Section};
pub use joint_reaction::JointReaction;
pub use left_curve::LeftCurve;
pub(crate) use locking::Locked;
pub use pose_answers::PoseAnswers;
pub use pose_numbers::{PoseExtras, Source, finite, read_numbers};
pub use pressure_angle::FollowerWay;
pub(crate) use size::Measured;
pub use sizes::Sizes;
pub(crate) use sizes::{LEAST_CONDITION, OF_FORCES, OF_MOTION, ROUNDING, is_zero};
pub use switch::Switch;
pub(crate) use switch::{Side, side_of, switches};
pub use undefined::{NoExtreme, NoFlywheel, NoSweep, SweepPlace, Undefined};
pub use whole_cycle::{Extremes, Nearest, Swept, WholeCycle};
