//! Sentences of a scheme.

use super::Sketch;

impl Sketch<'_, '_> {
    /// Adds a sentence to what is said about the picture.
    pub(super) fn say(&mut self, sentence: &str) {
        self.said.push_str(sentence);
        self.said.push_str(". ");
    }
}
