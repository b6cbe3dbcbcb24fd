//! Pictures of a solved problem. Nothing is computed here: a picture shows a [`Scene`], one position of a solution.

mod angles;
mod animation;
mod cam;
mod diagram;
mod error;
mod event_marks;
mod figures;
mod forces;
mod frame;
mod hodograph;
mod inset;
mod kind;
mod motion;
mod no_diagram;
mod paper;
mod plot;
mod reaction;
mod scene;
mod scheme;
mod shape;
mod symbol;
mod train;
mod wittenbauer;
mod wording;
mod words;
mod work;

pub use animation::{animation, moving};
pub use cam::cams_alone;
pub use frame::Frame;
pub use kind::{KINDS, Kind, Options, draw};
pub use paper::{Paper, SCALED, Scaled, Scales};
pub use reaction::reaction_index;
pub use scene::Scene;
pub use scheme::{Dimension, Loads, Measured, Scheme, scheme};
pub use wording::Wording;
