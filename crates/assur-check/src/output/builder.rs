//! The mechanism that is being made.

use crate::output::hinges::Hinges;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, Unsupported};
use assur_text::source::Span;

/// The mechanism that is being made, with what is looked up in it.
#[derive(Default)]
pub struct Builder {
    /// The mechanism so far. Every link is in it (name, number, span; ground first) as soon as the names are declared, so
    /// that link ids are known from the start. All other tables are filled in the order of the file; what has an error is
    /// left out.
    pub mech: Mechanism,
    /// The hinges at each point.
    pub hinges: Hinges,
}

impl Builder {
    /// Notes a construct that is understood but cannot be solved yet.
    pub fn unsupported(&mut self, what: impl Into<String>, span: Span) {
        let noted = Unsupported { what: what.into(), span };
        let again = self.mech.unsupported.iter().any(|u| u.span == span && u.what == noted.what);
        if !again {
            self.mech.unsupported.push(noted);
        }
    }

    /// This point and all that pins join with it.
    pub fn joined_with(&self, point: (LinkId, Vec2)) -> Vec<(LinkId, Vec2)> {
        self.hinges.joined_with(&self.mech, point)
    }
}
