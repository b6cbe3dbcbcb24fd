//! How the function in whose brackets a place is takes its arguments.

use super::Analysis;
use super::complete::Place;
use assur_text::language::{Form, Function};

/// One way to call a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// `velocity(link, point)`
    pub label: String,
    pub means: String,
    /// The arguments, as they are written in the label.
    pub arguments: Vec<String>,
    /// The argument that is being written.
    pub active: usize,
}

impl Analysis {
    /// The ways to call the function in whose brackets a byte is; those with enough arguments come first.
    #[must_use]
    pub fn signatures(&self, byte: usize) -> Vec<Signature> {
        let place = Place::of(self, byte);
        let Some((name, active)) = place.call() else { return Vec::new() };
        let Some(function) = Function::named(name) else { return Vec::new() };
        let mut found =
            function.row().forms.iter().map(|form| signature(name, form, active)).collect::<Vec<_>>();
        found.sort_by_key(|signature| signature.arguments.len() <= active);
        found
    }
}

fn signature(name: &str, form: &Form, active: usize) -> Signature {
    let arguments = form.takes.iter().map(|argument| {
        let optional = if argument.optional { "?" } else { "" };
        format!("{argument}{optional}")
    });
    let arguments = arguments.collect::<Vec<_>>();
    let label = format!("{name}({})", arguments.join(", "));
    Signature { label, means: format!("{}: {}", form.gives, form.means), arguments, active }
}
