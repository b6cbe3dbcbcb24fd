//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod check;
pub mod diagnostic;
pub mod math;
pub mod model;
pub mod source;
pub mod syntax;
pub mod units;

/// What the author of a text is told about it, without colour, 100 columns wide; empty where nothing is wrong.
#[must_use]
pub fn diagnose(source: &source::Source) -> String {
    let (document, mut problems) = syntax::parse(source);
    let (_, more) = check::check(&document, &check::Overrides::none());
    problems.append(more);
    diagnostic::render(&problems, source, diagnostic::Style::PLAIN)
}
