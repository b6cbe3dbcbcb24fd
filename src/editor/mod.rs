//! What an editor asks about a text, as plain data: no protocol is known here.

mod about;
mod changes;
mod complete;
mod folds;
mod hints;
mod hover;
mod lenses;
mod names;
mod picture;
mod rename;
mod results;
mod selection;
mod shown;
mod signature;
mod symbols;
mod tokens;

pub use changes::{Change, ChangeKind};
pub use complete::{Completion, CompletionKind};
pub use folds::folds;
pub use hints::Hint;
pub use hover::Hover;
pub use lenses::{Action, Lens};
pub use names::{Declaration, Names};
pub use picture::Picture;
pub use results::{GoesOn, Results};
pub use shown::{Declared, Shown};
pub use signature::Signature;
pub use symbols::{Symbol, SymbolKind, symbols};
pub use tokens::{Coloured, TOKEN_COLOURS};

use crate::pipeline::{Compiled, Looked, certain_edits, look};
use assur_syntax::document::Document;
use assur_syntax::{Token, parse_with_tokens};
use assur_text::diagnostic::{Fix, Problem, Problems};
use assur_text::source::{Edit, Source, Span};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// A text with all that is found in it before anything is solved: names, units, structure.
#[derive(Debug)]
pub struct Analysis {
    /// The text.
    pub source: Source,
    /// Its statements.
    pub document: Arc<Document>,
    /// Its tokens.
    pub tokens: Vec<Token>,
    /// What is wrong with it.
    pub problems: Problems,
    /// Its names.
    pub names: Names,
    /// Whether it reads.
    is_read: bool,
    /// It compiled, where it can be.
    compiled: Option<Compiled>,
    /// Definitions that are constant numbers.
    constants: Vec<(String, String)>,
}

impl Analysis {
    /// Looks at a text.
    #[must_use]
    pub fn of(source: Source) -> Self {
        let (document, tokens, found) = parse_with_tokens(&source);
        let document = Arc::new(document);
        let is_read = !found.has_errors();
        let Looked { compiled, problems, uses, constants } = look(&source, &document, found);
        let names = Names::of(&source.text, &tokens, &document, &uses);
        Self { source, document, tokens, problems, names, is_read, compiled, constants }
    }

    /// The fixes of the problems that touch a place, each with its problem.
    #[must_use]
    pub fn fixes_at(&self, at: Span) -> Vec<(&dyn Problem, Fix)> {
        let touches = |span: Span| span.start <= at.end && at.start <= span.end;
        let is_near = |problem: &dyn Problem, fix: &Fix| {
            let mut labels = problem.labels().into_iter().flatten();
            labels.any(|l| touches(Span::new(l.offset(), l.offset() + l.len())))
                || fix.edits.iter().any(|edit| touches(edit.span))
        };
        let all = self.problems.sorted().into_iter();
        let with_fixes = all.flat_map(|problem| problem.fixes().into_iter().map(move |fix| (problem, fix)));
        with_fixes.filter(|(problem, fix)| is_near(*problem, fix)).collect()
    }

    /// The edits of all fixes that are certain and do not touch each other.
    #[must_use]
    pub fn certain_edits(&self) -> Vec<Edit> {
        certain_edits(&self.problems).0
    }

    /// The edits that put the text, or some lines of it, in the one style; none where it does not read.
    #[must_use]
    pub fn formatting(&self, lines: Option<RangeInclusive<usize>>) -> Vec<Edit> {
        if !self.is_read {
            return Vec::new();
        }
        let edits = assur_format::edits_of(&self.source.text, &self.tokens, &self.document);
        match lines {
            Some(lines) => assur_format::touching(&self.source.text, edits, lines),
            None => edits,
        }
    }
}
