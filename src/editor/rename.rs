//! Other names: all places of a name that change with it, and whether the meaning stays.

use super::Analysis;
use super::names::Names;
use assur_syntax::is_reserved;
use assur_text::diagnostic::Problem;
use assur_text::source::{Edit, Source, Span, edited};
use indexmap::IndexMap;
use miette::Severity;

impl Analysis {
    /// The name at a byte, if it can have another one; else why not.
    ///
    /// # Errors
    ///
    /// A word of the language, or nothing that has a name.
    pub fn renamable(&self, byte: usize) -> Result<Span, String> {
        let name = self.names.at(byte).filter(|name| !self.names.declarations(*name).is_empty());
        let name = name.ok_or_else(|| "there is no name here".to_owned())?;
        if self.written(name) == "ground" {
            return Err("`ground` is a word of the language".to_owned());
        }
        Ok(name)
    }

    /// The edits that give the name at a byte another one, everywhere. A name that joins others gives it to them too: a pair
    /// to the points that are found by its name.
    ///
    /// # Errors
    ///
    /// What the text with the new name would be wrong with, or that it would mean something else.
    pub fn rename(&self, byte: usize, name: &str) -> Result<Vec<Edit>, String> {
        let places = self.names.together(self.renamable(byte)?);
        if is_reserved(name) {
            return Err(format!("`{name}` is a word of the language and cannot be a name"));
        }
        let edits = places.into_iter().map(|at| Edit::new(at, name)).collect::<Vec<_>>();
        let after = Self::of(Source::new(&*self.source.name, edited(&self.source.text, &edits)));
        if let Some(problem) = self.new_error(&after) {
            return Err(problem.to_string());
        }
        if !is_moved(&self.names, &after.names, &edits) {
            return Err(format!("`{name}` would mean something else in this file"));
        }
        Ok(edits)
    }

    /// What is written in a place.
    pub(super) fn written(&self, at: Span) -> &str {
        self.source.text.get(at.start..at.end).unwrap_or_default()
    }

    /// An error of another text of which this one has fewer.
    fn new_error<'a>(&self, after: &'a Self) -> Option<&'a dyn Problem> {
        let mut known = IndexMap::<_, usize>::new();
        errors(self).for_each(|problem| *known.entry(code(problem)).or_default() += 1);
        errors(after).find(|problem| match known.get_mut(&code(*problem)) {
            Some(left) if *left > 0 => {
                *left -= 1;
                false
            }
            _ => true,
        })
    }
}

fn errors(analysis: &Analysis) -> impl Iterator<Item = &dyn Problem> {
    let all = analysis.problems.sorted().into_iter();
    all.filter(|problem| problem.severity().is_none_or(|severity| severity == Severity::Error))
}

fn code(problem: &dyn Problem) -> Option<String> {
    problem.code().map(|code| code.to_string())
}

/// Whether all names are used and declared where they were, each place moved as the edits move it.
fn is_moved(before: &Names, after: &Names, edits: &[Edit]) -> bool {
    let moved = |at: Span| {
        let grown = |edit: &Edit| edit.with.len() as isize - (edit.span.end - edit.span.start) as isize;
        let shift = edits.iter().filter(|e| e.span.start < at.start).map(grown).sum::<isize>();
        let own = edits.iter().filter(|e| e.span == at).map(grown).sum::<isize>();
        Span::new(at.start.saturating_add_signed(shift), at.end.saturating_add_signed(shift + own))
    };
    let declared = before.declared().map(|d| moved(d.at)).eq(after.declared().map(|d| d.at));
    let uses = before.uses().map(|(at, of)| (moved(at), of.iter().map(|of| moved(*of)).collect::<Vec<_>>()));
    declared && uses.eq(after.uses().map(|(at, of)| (at, of.to_vec())))
}
