//! Pictures of a solved problem. Nothing is computed here: a picture shows a [`Scene`], one position of a solution.

mod animation;
mod cam;
mod diagram;
mod equilibrium;
mod error;
mod figures;
mod forces;
mod fourier;
mod hodograph;
mod inset;
mod internal;
mod kind;
mod motion;
mod no_diagram;
mod paper;
mod planes;
mod plot;
mod scene;
mod scheme;
mod shape;
mod symbol;
mod train;
mod wedge;
mod wittenbauer;
mod wording;
mod words;
mod work;

pub use animation::{ArrowKind, Film, Moving, PLAYER, PLAYER_STYLE, animation, film, motion, moving};
pub use cam::cams_alone;
pub use kind::{KINDS, Kind, Options, draw};
pub use paper::Frame;
pub use paper::{Paper, SCALED, Scaled, Scales};
pub use scene::Scene;
pub use scene::reaction_index;
pub use scheme::{Dimension, Loads, Measured, Scheme, scheme, true_size};
pub use wording::Wording;
