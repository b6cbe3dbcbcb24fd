//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

pub mod check;
pub mod diagnostic;
pub mod math;
pub mod model;
pub mod source;
pub mod syntax;
pub mod units;

use check::Overrides;
use diagnostic::{Problems, Style};
use model::Mechanism;
use source::Source;

/// Reads and checks a text, with these values from outside. The mechanism is absent where the problems hold an error.
#[must_use]
pub fn read(source: &Source, overrides: &Overrides) -> (Option<Mechanism>, Problems) {
    let (document, mut problems) = syntax::parse(source);
    let (mechanism, later) = check::check(&document, overrides);
    problems.append_later(later);
    (mechanism.filter(|_| !problems.has_errors()), problems)
}

/// What the author of a text is told about it, without colour, 100 columns wide; empty where nothing is wrong.
#[must_use]
pub fn diagnose(source: &Source) -> String {
    diagnostic::render(&read(source, &Overrides::none()).1, source, Style::PLAIN)
}
