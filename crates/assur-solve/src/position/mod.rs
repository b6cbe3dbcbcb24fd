//! One position from numbers: motion, loads and forces by the steps of a plan, in any scalar; nothing is followed.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_B, v_B, M_1")]

mod cam;
mod closed;
mod columns;
mod consistent;
mod contact;
mod driven_legs;
mod dyads;
mod forces;
mod friction;
mod friction_search;
mod general;
mod lanes;
mod loads;
mod motion;
mod precise;
mod residual;
mod rubbing;
mod run;
mod scene;
mod state;
mod train;
mod train_forces;
mod train_losses;
mod triad;

pub use columns::DriveColumns;
pub use consistent::{Consistent, Searched};
pub use friction::RubbingWork;
pub(crate) use friction::STILL;
pub(crate) use general::{STARTS, Workspace, assemblies as general_assemblies, is_never_regular};
#[cfg(target_arch = "x86_64")]
pub use lanes::block_in_avx2;
pub use lanes::{Place, SideBySide, WIDTH, instructions};
pub use precise::{Edge, in_scalar, precise};
pub use residual::{Residuals, residuals};
pub use scene::Scene;
pub use state::{BodyState, Branch, DriveInput, Reaction, State, Wrench};
pub use train::LawForce;
pub use train_forces::TrainWork;
pub(crate) use triad::assemblies as triad_assemblies;
