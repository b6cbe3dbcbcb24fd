//! Where a name leads to and where it is used; another name.

use super::asked::Asked;
use super::error::Failure;
use assur_text::source::Span;
use gen_lsp_types::{
    DocumentHighlight, DocumentHighlightKind, Location, PrepareRenamePlaceholder, WorkspaceEdit,
};

impl Asked<'_> {
    fn location(&self, at: Span) -> Location {
        Location { uri: self.uri.into(), range: self.range(at) }
    }

    /// The declarations to which a name leads. A pair leads to the points that it finds by its name.
    pub fn definition(&self, byte: usize) -> Vec<Location> {
        let names = &self.analysis.names;
        let Some(name) = names.at(byte) else { return Vec::new() };
        let found = names.declarations(name).into_iter().map(|d| d.at).collect::<Vec<_>>();
        let elsewhere = found.iter().filter(|at| **at != name).copied().collect::<Vec<_>>();
        let shown = if elsewhere.is_empty() { found } else { elsewhere };
        shown.into_iter().map(|at| self.location(at)).collect()
    }

    pub fn references(&self, byte: usize, with_declarations: bool) -> Result<Vec<Location>, Failure> {
        let names = &self.analysis.names;
        let all = names.at(byte).map(|name| names.occurrences(name)).unwrap_or_default();
        let shown = all.into_iter().filter(|at| with_declarations || !names.is_declaration(*at));
        Ok(shown.map(|at| self.location(at)).collect())
    }

    /// The places of what has the name at a byte; those where it is declared as written.
    pub fn highlights(&self, byte: usize) -> Vec<DocumentHighlight> {
        let names = &self.analysis.names;
        let all = names.at(byte).map(|name| names.occurrences(name)).unwrap_or_default();
        let highlight = |at: Span| {
            let declared = names.is_declaration(at);
            let kind = if declared { DocumentHighlightKind::Write } else { DocumentHighlightKind::Read };
            DocumentHighlight { range: self.range(at), kind: Some(kind) }
        };
        all.into_iter().map(highlight).collect()
    }

    pub fn prepare_rename(&self, byte: usize) -> Result<PrepareRenamePlaceholder, Failure> {
        let at = self.analysis.renamable(byte).map_err(Failure::request)?;
        let placeholder = self.analysis.source.text.get(at.start..at.end).unwrap_or_default().to_owned();
        Ok(PrepareRenamePlaceholder { range: self.range(at), placeholder })
    }

    pub fn rename(&self, byte: usize, name: &str) -> Result<WorkspaceEdit, Failure> {
        let edits = self.analysis.rename(byte, name).map_err(Failure::request)?;
        Ok(self.change(&edits))
    }
}
