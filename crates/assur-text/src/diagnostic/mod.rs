//! Everything that is said about a text: collected, sorted, rendered.
//!
//! Each stage has its own error enum that derives `thiserror::Error` and `miette::Diagnostic`, with its data in
//! fields and a code `mech::<stage>::<what_is_wrong>`; [`Problems`] takes any of them.

mod codes;
mod excerpt;
mod lines;
mod problems;
mod render;
mod suggest;
mod view;

pub use codes::{CODES, Code, explain};
pub use problems::{AnyDiagnostic, Problems};
pub use render::{Style, render, render_most};
pub use suggest::{did_you_mean, distance_allowed};
pub use view::{DiagnosticView, Place, SpanView, place};
