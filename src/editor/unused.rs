//! What is declared and changes nothing.

use super::{Analysis, Declaration, SymbolKind};

impl Analysis {
    /// The given values that nothing uses, of a text without errors: in another one a use may be in what does not read.
    #[must_use]
    pub fn unused(&self) -> Vec<&Declaration> {
        if self.problems.has_errors() {
            return Vec::new();
        }
        let given = self.names.declared().filter(|d| d.kind == SymbolKind::Given);
        given.filter(|d| self.names.uses().all(|(_, of)| !of.contains(&d.at))).collect()
    }
}
