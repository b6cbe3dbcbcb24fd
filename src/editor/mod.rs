//! What an editor asks about a text, as plain data: no protocol is known here.

mod about;
mod changes;
mod complete;
mod documents;
mod formatting;
mod hints;
mod hover;
mod lenses;
mod names;
mod results;
mod shown;
mod signature;
mod symbols;
mod tokens;
mod tutorial;
mod unused;

pub use changes::{Change, ChangeKind};
use complete::units_alike;
pub use complete::{Completion, CompletionKind};
pub use documents::{Picture, Wish, Written};
pub use formatting::folds;
pub use hints::{Earlier, Hint, HintKind};
pub use hover::Hover;
pub use lenses::{Action, Lens};
pub use names::{Declaration, Names};
pub use results::{GoesOn, Results, solve_while};
pub use shown::{Declared, PageParts};
pub use signature::Signature;
pub use symbols::{Symbol, SymbolKind, symbols};
pub use tokens::{Coloured, TOKEN_COLOURS};
pub use tutorial::{Step, Tutorial};

use crate::pipeline::{CompileFindings, Compiled, analyze, certain_edits};
use assur_syntax::document::Document;
use assur_syntax::{Token, parse_with_tokens};
use assur_text::diagnostic::{Fix, Problem, Problems};
use assur_text::source::{Edit, Source, Span};
use std::sync::Arc;

/// A text with all that is found in it before anything is solved: names, units, structure.
#[derive(Debug)]
pub struct Analysis {
    pub source: Source,
    pub document: Arc<Document>,
    pub tokens: Vec<Token>,
    /// What is wrong with it.
    pub problems: Problems,
    pub names: Names,
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
        let CompileFindings { compiled, problems, uses, constants } = analyze(&source, &document, found);
        let names = Names::of(&source.text, &tokens, &document, &uses);
        Self { source, document, tokens, problems, names, is_read, compiled, constants }
    }

    /// The fixes of the problems that touch a place, those of the answers among them, each with its problem.
    #[must_use]
    pub fn fixes_at<'a>(&'a self, at: Span, results: Option<&'a Results>) -> Vec<(&'a dyn Problem, Fix)> {
        let is_near = |problem: &dyn Problem, fix: &Fix| {
            is_marked(problem, at) || fix.edits.iter().any(|edit| touch(edit.span, at))
        };
        let all = self.problems_with(results).into_iter();
        let with_fixes = all.flat_map(|problem| problem.fixes().into_iter().map(move |fix| (problem, fix)));
        with_fixes.filter(|(problem, fix)| is_near(*problem, fix)).collect()
    }

    /// The codes of the problems that mark a place, each once.
    #[must_use]
    pub fn codes_at(&self, at: Span, results: Option<&Results>) -> Vec<String> {
        let all = self.problems_with(results).into_iter().filter(|problem| is_marked(*problem, at));
        let mut codes = all.filter_map(|problem| Some(problem.code()?.to_string())).collect::<Vec<_>>();
        codes.sort();
        codes.dedup();
        codes
    }

    /// What is wrong with the text, then with its answers.
    #[must_use]
    pub fn problems_with<'a>(&'a self, results: Option<&'a Results>) -> Vec<&'a dyn Problem> {
        let of_answers = results.map(|results| results.problems.sorted()).unwrap_or_default();
        self.problems.sorted().into_iter().chain(of_answers).collect()
    }

    /// The edits of all fixes that are certain and do not touch each other.
    #[must_use]
    pub fn certain_edits(&self) -> Vec<Edit> {
        certain_edits(&self.problems).0
    }
}

fn touch(one: Span, other: Span) -> bool {
    one.start <= other.end && other.start <= one.end
}

/// Whether a problem marks a place.
fn is_marked(problem: &dyn Problem, at: Span) -> bool {
    let mut labels = problem.labels().into_iter().flatten();
    labels.any(|l| touch(Span::new(l.offset(), l.offset() + l.len()), at))
}
