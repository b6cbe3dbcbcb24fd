//! One position from numbers: motion, loads and forces by the steps of a plan, in any scalar; nothing is followed.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod against;
mod body;
mod cam;
mod check;
mod closed;
#[cfg(feature = "lanes")]
mod columns;
mod consistent;
mod contact;
mod directions;
mod driven_legs;
mod dyads;
mod energy;
mod forces;
mod free_body;
mod friction;
mod friction_closed;
mod friction_search;
mod friction_steps;
mod friction_wheels;
mod friction_work;
mod general;
mod general_forces;
mod general_losses;
mod general_work;
mod geneva;
mod grip;
mod kinematics;
#[cfg(feature = "lanes")]
mod lanes;
mod law_grip;
mod loads;
mod losses;
mod model;
mod motion;
mod newton_steps;
#[cfg(feature = "lanes")]
mod one_lane;
mod pose_request;
mod precise;
mod reduced;
mod residual;
mod run;
mod scratch;
mod state;
mod statics;
mod together;
mod train;
mod train_forces;
mod train_losses;
mod train_work;
mod triad;
mod virtual_power;
mod wrench;

pub use against::Against;
pub use body::BodyState;
#[cfg(feature = "lanes")]
pub use columns::DriveColumns;
pub use consistent::{Consistent, Searched};
#[doc(hidden)]
pub use directions::directions;
pub use free_body::{Action, Origin};
pub use friction::STILL;
pub use friction_work::FrictionWork;
pub use general::{STARTS, assemblies as general_assemblies, is_never_regular};
pub use general_work::Workspace;
pub use grip::ContactMode;
pub use kinematics::{DriveInput, Motion};
#[cfg(all(feature = "lanes", target_arch = "x86_64"))]
pub use lanes::block_in_avx2;
#[cfg(feature = "lanes")]
pub use lanes::{Batch, Place, instructions};
pub use model::turns;
pub use model::{Model, extent};
pub use pose_request::PoseRequest;
pub use pose_request::{DriveValue, PoseOrigin};
pub use precise::{Edge, in_scalar, precise};
pub use reduced::Reduced;
pub use residual::{Residuals, closure_alone, residuals, residuals_in};
pub use scratch::Scratch;
pub use state::{Branch, State};
pub use state::{DEAD, SAME};
pub use statics::Forces;
pub use together::{Checked, F64x8, LaneSolver, WIDTH, in_avx2};
pub use train_work::TrainWork;
pub use triad::assemblies as triad_assemblies;
pub use wrench::{LawForce, Reaction, Wrench};
