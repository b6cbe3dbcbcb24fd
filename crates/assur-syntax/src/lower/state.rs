//! The state of the walk.

use assur_text::diagnostic::Problems;
use std::collections::BTreeSet;

/// The state of the walk.
pub struct Lower<'a> {
    pub text: &'a str,
    /// The text that the grammar read, of the same length.
    pub read: &'a str,
    pub problems: Problems,
    /// Words of the language that were meant as names, and reported.
    pub reserved: BTreeSet<String>,
    /// Closing braces after a statement that stands within them, which is reported.
    pub closing: BTreeSet<usize>,
}

impl<'a> Lower<'a> {
    /// The state at the start.
    pub fn new(text: &'a str, read: &'a str) -> Self {
        Self { text, read, problems: Problems::new(), reserved: BTreeSet::new(), closing: BTreeSet::new() }
    }
}
