//! What is handed to people: worked solutions, exercise sheets, keys as documents, pictures, answers as files. Where they go is the
//! program's.

mod answers;
mod base64;
pub mod course;
mod lacks;
mod pictures;
mod places;
mod published;
mod sheets;
mod sizes;
mod tables;
mod texts;
mod worked;

pub use answers::{csv_row, json, json_of_row, poses, solution};
pub use base64::base64;
pub use pictures::Pictured;
pub use sheets::{Row, Sheets};
pub use worked::document;

use assur_check::Overrides;
use assur_picture::Kind;
use assur_syntax::document::Document;
use assur_text::source::Source;
use assur_worked::Language;
use std::sync::Arc;

/// What is solved for a document: all that its pictures show.
const KINDS: [Kind; 4] = [Kind::Scheme, Kind::Velocities, Kind::Accelerations, Kind::Forces];

/// What a document is made of.
pub struct Handout<'a> {
    pub source: &'a Source,
    pub document: Arc<Document>,
    /// Values from outside.
    pub overrides: Overrides,
    pub language: Language,
    /// The position that is worked out or drawn; the first one without a name.
    pub pose: Option<&'a str>,
    /// The positions that answers are asked for at; all where none is named.
    pub positions: Vec<String>,
}

impl<'a> Handout<'a> {
    #[must_use]
    pub fn new(
        source: &'a Source,
        document: Arc<Document>,
        overrides: Overrides,
        language: Language,
        pose: Option<&'a str>,
    ) -> Self {
        let positions = pose.iter().map(ToString::to_string).collect();
        Self { source, document, overrides, language, pose, positions }
    }

    /// With answers asked for at these positions, unless there are none.
    #[must_use]
    pub fn at(mut self, positions: &'a [String]) -> Self {
        if let [first, ..] = positions {
            (self.pose, self.positions) = (Some(first.as_str()), positions.to_vec());
        }
        self
    }
}
