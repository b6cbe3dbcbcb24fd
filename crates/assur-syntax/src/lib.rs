//! Text → [`Document`].
//!
//! Parsing cannot fail: a part that cannot be read is reported and kept as `Bad`.

mod change;
mod character_error;
mod comma;
mod confusables;
mod error;
mod foreign;
mod grammar;
mod line;
mod lower;
mod prepare;
mod recover;
mod trivia;
mod whole;
mod words;

pub mod document;

pub use character_error::CharacterError;
pub use comma::{between_digits, readings};
pub use confusables::skeleton;
pub use error::SyntaxError;

use assur_text::diagnostic::Problems;
use assur_text::source::{Source, Span};
use document::Document;
use grammar::{Grammar, Rule};
use pest::Parser;

/// Reads a text. Every mistake is reported, and the document contains all parts that could be read.
#[must_use]
pub fn parse(source: &Source) -> (Document, Problems) {
    let mut problems = Problems::new();
    let read = prepare::prepare(&source.text, &mut problems);
    let mut document = Document { trivia: trivia::scan(&source.text), ..Document::default() };
    match Grammar::parse(Rule::file, &read) {
        Ok(pairs) => {
            let (statements, found) = lower::file(&source.text, &read, pairs);
            problems.append(found);
            document.notes = trivia::notes(&source.text, &statements, &document.trivia);
            document.statements = statements;
        }
        Err(_) => problems.push(recover::unreadable(Span::new(0, source.text.len()))),
    }
    whole::check(&document, &mut problems);
    (document, problems)
}
