//! Everything that is said about a text: collected, sorted, rendered.
//!
//! A [`Diagnosis`] is built where the fault arises, with a code `mech::<stage>::<what_is_wrong>`.

mod diagnosis;
mod excerpt;
mod fix;
mod problems;
mod render;
mod suggest;
mod view;

pub use crate::language::{CODES, Code, explain};
pub use diagnosis::Diagnosis;
pub use fix::{Fix, Help};
pub use problems::{AnyDiagnostic, Problem, Problems, Undeclared};
pub use render::{Style, render, render_most};
pub use suggest::{did_you_mean, distance_allowed};
pub use view::{DiagnosticView, Place, SpanView, place};
