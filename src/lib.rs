//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod check;
pub mod diagnostic;
pub mod force;
pub mod group;
pub mod math;
pub mod model;
mod pipeline;
pub mod plan;
pub mod solve;
pub mod source;
pub mod structure;
pub mod syntax;
pub mod units;

pub use pipeline::{Compiled, compile};

/// What the author of a text is told about it when it is solved, without colour, 100 columns wide; empty where nothing
/// is wrong.
#[must_use]
pub fn diagnose(source: &source::Source) -> String {
    let (compiled, mut problems) = compile(source, &check::Overrides::none());
    if let Some(compiled) = compiled {
        compiled.solve(&mut problems);
    }
    diagnostic::render(&problems, source, diagnostic::Style::PLAIN)
}
