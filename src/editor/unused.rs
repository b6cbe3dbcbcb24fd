//! What is declared and changes nothing.

use super::{Analysis, Declaration, SymbolKind};
use indexmap::IndexSet;

impl Analysis {
    /// The given values that nothing uses, of a text without errors: in another one a use may be in what does not read.
    #[must_use]
    pub fn unused(&self) -> Vec<&Declaration> {
        if self.problems.has_errors() {
            return Vec::new();
        }
        let used = self.names.uses().flat_map(|(_, of)| of).collect::<IndexSet<_>>();
        let given = self.names.declared().filter(|d| d.kind == SymbolKind::Given);
        given.filter(|d| !used.contains(&d.at)).collect()
    }
}
