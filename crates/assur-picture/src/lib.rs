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
mod table_plot;
mod train;
mod wedge;
mod wittenbauer;
mod wording;
mod words;
mod work;

pub use animation::{ArrowKind, Film, Moving, PLAYER, PLAYER_STYLE, animation, film, motion, moving};
pub use kind::{KINDS, Kind, Needs, Options, Place, draw};
pub use paper::Frame;
pub use paper::{Paper, SCALED, Scaled, Scales};
pub use scene::{Scene, Subject, reaction_index};
pub use scheme::{Dimension, Loads, Measured, Scheme, scheme, true_size};
pub use table_plot::{TableAxis, table_plot};
pub use wording::Wording;
