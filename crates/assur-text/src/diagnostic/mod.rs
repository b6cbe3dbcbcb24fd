//! Everything that is said about a text: collected, sorted, rendered.
//!
//! Each stage has its own error enum that derives `thiserror::Error` and `miette::Diagnostic`, with its data in
//! fields and a code `mech::<stage>::<what_is_wrong>`; [`Problems`] takes any of them.

mod excerpt;
mod fix;
mod problems;
mod render;
mod suggest;
mod view;

pub use crate::language::{CODES, Code, explain};
pub use fix::{Fix, Help};
pub use problems::{AnyDiagnostic, Problem, Problems, Undeclared};
pub use render::{Style, render, render_most};
pub use suggest::{did_you_mean, distance_allowed};
pub use view::{DiagnosticView, Place, SpanView, place};
