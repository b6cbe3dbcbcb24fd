//! The problems found, and what is not reported again.

use assur_text::diagnostic::{self, Problem};
use indexmap::IndexSet;

/// All that was found wrong.
#[derive(Default)]
pub struct Problems {
    found: diagnostic::Problems,
    /// Names reported as unknown already, with the list they were looked for in.
    pub reported: IndexSet<(&'static str, String)>,
    /// Classes of names of which one is declared twice: another that is not declared follows from it.
    pub twice: IndexSet<&'static str>,
}

impl Problems {
    /// Reports an error or a warning; the same at the same place once, as of what `all` gives to several pairs.
    pub fn error(&mut self, problem: impl Problem) {
        if !self.found.has_alike(&problem) {
            self.found.push(problem);
        }
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        self.found.has_errors()
    }

    /// Whether nothing was found at all.
    pub fn is_empty(&self) -> bool {
        self.found.is_empty() && self.reported.is_empty()
    }

    /// Drops what was found; names reported as unknown stay so.
    pub fn clear_found(&mut self) {
        self.found = diagnostic::Problems::new();
    }

    /// Whether a pair is asked for that the file has not.
    pub fn lacks_pair(&self) -> bool {
        self.reported.iter().any(|(kind, _)| kind.split(" or ").any(|kind| kind == "pair"))
    }

    /// Drops errors of these codes, unless nothing else is wrong.
    pub fn drop_followers(&mut self, codes: &[&str], unread: bool) {
        let kept = self.found.without(codes);
        if unread || kept.has_errors() {
            self.found = kept;
        }
    }

    /// All that was found.
    pub fn into_found(self) -> diagnostic::Problems {
        self.found
    }

    /// The state before something is tried: what is reported from now on is kept apart.
    pub fn start_trial(&mut self) -> Self {
        Self {
            found: std::mem::take(&mut self.found),
            reported: self.reported.clone(),
            twice: self.twice.clone(),
        }
    }
}
